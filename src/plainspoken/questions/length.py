"""How long an answer may be: what matters most, what matters, or every fact."""

from __future__ import annotations

from enum import StrEnum


class Length(StrEnum):
    """A register: one or two sentences, a few, or all there is to tell."""

    BRIEF = "brief"
    NORMAL = "normal"
    FULL = "full"

    @property
    def words(self) -> int:
        """Words that an answer aims at."""
        return {Length.BRIEF: 45, Length.NORMAL: 90, Length.FULL: 1_000_000}[self]

    @property
    def most_named(self) -> int:
        """More things of a kind than this are counted, not named."""
        return {Length.BRIEF: 5, Length.NORMAL: 8, Length.FULL: 1_000_000}[self]
