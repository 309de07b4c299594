"""Robots that a file describes: their services, and what an action of the domain is on them."""
