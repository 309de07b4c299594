"""The page and the programs' interface: shows what the pipeline returns, decides nothing."""
