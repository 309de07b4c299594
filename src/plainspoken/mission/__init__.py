"""Carrying a policy out: the state of a mission, the task manager that decides, and robots."""
