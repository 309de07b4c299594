"""Words cut into the pieces that a network knows.

Source: Wu et al., Google's Neural Machine Translation System, 2016, section 4.1; the greedy,
longest-first form of it is what BERT uses.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

UNKNOWN = "[UNK]"
START = "[CLS]"
END = "[SEP]"


class Pieces:
    """A vocabulary of pieces; a piece that goes on in a word begins with `##`."""

    def __init__(self, pieces: Sequence[str]) -> None:
        self._ids: Mapping[str, int] = {piece: index for index, piece in enumerate(pieces)}
        self._cut: dict[str, tuple[int, ...]] = {}
        self.start = self._ids[START]
        self.end = self._ids[END]

    def of(self, word: str) -> tuple[int, ...]:
        """The ids of a word's pieces, the longest first piece first."""
        if word not in self._cut:
            self._cut[word] = self._pieces(word)
        return self._cut[word]

    def _pieces(self, word: str) -> tuple[int, ...]:
        found: list[int] = []
        begin = 0
        while begin < len(word):
            mark = "##" if begin else ""
            end = next(
                (end for end in range(len(word), begin, -1) if mark + word[begin:end] in self._ids),
                None,
            )
            if end is None:
                return (self._ids[UNKNOWN],)
            found.append(self._ids[mark + word[begin:end]])
            begin = end
        return tuple(found)
