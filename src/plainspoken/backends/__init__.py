"""Vendors: the only room that imports them, each behind a Protocol of a room below."""
