"""The page: what it shows, as pure functions, and where it shows it."""
