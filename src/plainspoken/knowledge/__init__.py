"""What is known: the log of what happened, and the fold of it to facts and a trace."""
