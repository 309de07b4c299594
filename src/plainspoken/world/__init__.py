"""What can be spoken of: planning domains, their symbols and landmarks, scenes and events."""
