"""Taking a record of a place, as it is said: "take a photo of a", "a must be photographed"."""

from __future__ import annotations

from dataclasses import replace

from plainspoken.language.handled import DETERMINERS, HandledReader
from plainspoken.language.handling import (
    LIGHT,
    RECORDING,
    RECORDS,
)
from plainspoken.language.step import Deed, Place, names_of
from plainspoken.world.symbol import SymbolId

_PASSIVE_WORDS = """
    must should shall has have to need needs is are be been being was were will ought not never
    always eventually also then first gets get
"""
PASSIVE = frozenset(_PASSIVE_WORDS.split())
BEING = frozenset(("be", "been", "being", "is", "are", "was", "were", "gets", "get"))
_OF = frozenset(("of", "at", "in", "from", "inside", "near", "around", "by", "on", "within"))
_WANTING = frozenset(("need", "want", "like", "require", "me", "us", "have", "expect"))
_SEVERAL = frozenset(
    ("of", "multiple", "several", "new", "at", "least", "single", "few", "couple", "another", "two")
)
ASKING = frozenset(("must", "should", "to", "shall", "needs", "need", "will", "ought"))
KEPT = frozenset(("not", "never", "always", "eventually", "first"))


class DeedReader(HandledReader):
    """Reads what record is taken, and where."""

    def _deed(self, index: int) -> Deed | None:
        if index >= len(self._said):
            return None
        word = self._said[index]
        for number, symbol in self._handling.records.items():
            if word.stems & RECORDING[number] and self._form(index) != "finite":
                found = self._recorded(index, index + 1, symbol, direct=True)
                if found is not None:
                    return found
            if word.stems & RECORDS[number] and self._text(index - 1) in ("no", "without"):
                bare = self._recorded(index, index + 1, symbol, direct=False)
                return bare and replace(bare, form="gerund")
            light = bool(word.stems & LIGHT)
            wanted = word.text in DETERMINERS and self._text(index - 1) in _WANTING
            if light or wanted:
                noun = self._counted(index + 1)
                if noun < len(self._said) and self._said[noun].stems & RECORDS[number]:
                    found = self._recorded(index, noun + 1, symbol, direct=False)
                    if found is not None and (light or found.places):
                        return found if light else replace(found, form="base")
        return self._deed_done(index)

    def _counted(self, index: int) -> int:
        """The word after "a", "at least one", "some"."""
        while self._text(index) in DETERMINERS | _SEVERAL:
            index += 1
        return index

    def _deed_done(self, index: int) -> Deed | None:
        """Read "a must be photographed", "a photo of a must be taken"."""
        place = self.place_at(index)
        taken = None
        for number, symbol in self._handling.records.items():
            noun = self._counted(index)
            if place is None and noun < len(self._said) and (
                self._said[noun].stems & RECORDS[number]
            ):  # fmt: skip
                taken = self._recorded(index, noun + 1, symbol, direct=False)
            start = taken.last if taken else place.last if place else index
            position = start
            while self._text(position) in PASSIVE:
                position += 1
            if position == start or position >= len(self._said) or (
                self._text(position - 1) not in BEING
            ):  # fmt: skip
                continue
            verb = self._said[position].stems
            done = (taken is not None and verb & LIGHT) or (place is not None and (
                verb & RECORDING[number]
            ))  # fmt: skip
            where = taken.places if taken else (place,) if place else ()
            if not done or (taken is not None and not where):
                continue
            between = range(start, position)
            asked = any(self._text(i) in ASKING for i in between)
            return Deed(
                index, position + 1, position, "base" if asked else "finite",
                ((symbol, position, position + 1), *names_of(where)), where,
                tuple(i for i in between if self._text(i) in KEPT),
                symbol=symbol, places=where,
            )  # fmt: skip
        return None

    def _recorded(self, index: int, last: int, symbol: SymbolId, *, direct: bool) -> Deed | None:
        position = last
        there = self._text(position) == "there"
        places: list[Place] = []
        link = "and"
        end = last + there
        if self._text(position) in _OF or (direct and not there):
            position += self._text(position) in _OF
            while (place := self.place_at(position)) is not None:
                places.append(place)
                end = place.last
                position = end
                while self._text(position) in (",", "and", "or", "then", "both", "of"):
                    link = self._text(position) if self._text(position) in ("or", "then") else link
                    position += 1
                if position == end:
                    break
        if direct and not places and not there:
            return None
        return Deed(
            index, end, index, self._form(index),
            ((symbol, index, last), *names_of(tuple(places))), tuple(places), there=there,
            link=link, symbol=symbol, places=tuple(places),
        )  # fmt: skip
