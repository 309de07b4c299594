"""Carrying said in many words, taken together as errands: "pick up x at a, and take it to b".

A sentence is read step by step - go there, pick this up, carry it there, put it down, take a
record of it - and steps that belong together become one word that bears an errand.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace

from plainspoken.language.errand import Errand, Named
from plainspoken.language.handling import Handling, Manner
from plainspoken.language.load import Stops, stops_of
from plainspoken.language.step import Deed, Go, Handle, Lies, Place, Step
from plainspoken.language.stepping import StepReader
from plainspoken.language.word import Word
from plainspoken.world.symbol import SymbolId

_JOINT_WORDS = """
    , and then next afterwards afterward finally subsequently later to before ; . you must should
    which after that in order so as once done lastly eventually from there also please
"""
_JOINTS = frozenset(_JOINT_WORDS.split())
_CONNECTORS = frozenset(
    ["before", "after", "until", "till", "when", "whenever", "once", "if", "while", "unless",
    "as", "whilst", "upon"]
)  # fmt: skip
_POINTS_THERE = frozenset(
    ["stay", "remain", "go", "wait", "return", "be", "linger", "park", "rest", "keep", "get"]
)
_STEADY_SUBJECTS = frozenset(("you", "robot", "it", "we", "they"))


def with_errands(
    said: tuple[Word, ...],
    handling: Handling,
    places: Sequence[Place],
    told: Callable[[int], SymbolId | None],
) -> tuple[Word, ...]:
    """The words of an utterance, those that tell of one errand taken together as one word.

    told: the symbol that a word is one of the own words of, which needs no errand
    """
    return _Folder(said, handling, places, told).folded()


class _Folder:
    def __init__(
        self,
        said: tuple[Word, ...],
        handling: Handling,
        places: Sequence[Place],
        told: Callable[[int], SymbolId | None],
    ) -> None:
        self._said = said
        self._told_already = told
        self._handling = handling
        self._reader = StepReader(said, handling, places)
        self._out: list[Word] = []
        self._steps_before: list[Step] = []  # of an errand that ends right before
        self._last: Place | None = None  # the last place of an errand

    def folded(self) -> tuple[Word, ...]:
        index = 0
        while index < len(self._said):
            if self._steps_before and self._said[index].text in _JOINTS:
                self._plain(index)
                index += 1
                continue
            after = self._errand(index)
            if after is None:
                self._steps_before = []
            if after is None:
                self._plain(index)
                index += 1
            else:
                index = after
        return tuple(self._out)

    def _plain(self, index: int) -> None:
        word = self._said[index]
        before = self._said[index - 1].stems if index else frozenset()
        if self._reader.place_at(index) is not None:
            self._last = None
        if word.text == "there" and self._last is not None and before & _POINTS_THERE:
            named = self._said[self._last.first : self._last.last]
            self._out += [replace(each, start=word.start, end=word.end) for each in named]
        else:
            self._out.append(word)

    # Steps that belong together.

    def _turned(self, index: int) -> list[Step]:
        """Read "take x to b after picking it up at a", "before taking x to b, pick it up at a"."""
        before = self._said[index].text == "before"
        if index + before >= len(self._said):
            return []
        later = self._reader.step(index + before, ())
        if not isinstance(later, Handle) or later.manner is Manner.LIFT or later.source or (
            not later.things or later.last >= len(self._said)
        ):  # fmt: skip
            return []
        comma = self._said[later.last].text == ","
        start = later.last + 1 if before and comma else self._after(later.last + comma)
        if start is None or (before and not comma) or start >= len(self._said):
            return []
        first = self._reader.step(start, ())
        if not isinstance(first, Handle) or first.manner is not Manner.LIFT or (
            first.things != later.things
        ):  # fmt: skip
            return []
        verb, form = (first.verb, first.form) if before else (later.verb, later.form)
        return [
            replace(first, first=index, verb=verb, form=form, kept=later.kept),
            replace(later, last=first.last),
        ]

    def _errand(self, index: int) -> int | None:
        """Take an errand that begins at a word; returns the word after it."""
        steps = self._turned(index) or self._steps(index)
        whole = steps[0] if steps else None
        while steps:
            found = self._told(steps)
            if found is not None:
                self._emit(steps, found)
                self._steps_before = steps
                return steps[-1].last
            steps = steps[:-1]
        if isinstance(whole, Handle) and whole.source and whole.goal:
            # Carrying that the domain cannot say is not to be taken for its parts.
            said = self._said[whole.first : whole.last]
            text = "".join(word.text for word in said if not word.is_mark)
            self._out.append(Word(text, said[0].start, said[-1].end))
            return whole.last
        return None

    def _steps(self, index: int) -> list[Step]:
        found: list[Step] = []
        position: int | None = index
        after = self._after(index)
        subordinate = after is None and self._is_subordinate(index)
        if after is not None:
            position = after
        while position is not None:
            step = self._reader.step(position, found, self._steps_before)
            if step is None:
                break
            found.append(step)
            position = self._joined(step.last, subordinate=subordinate)
        if after is None:
            return found
        # "after picking it up at a, take it to b": the step behind the comma is a second one.
        goes_on = len(found) > 1 and isinstance(found[0], Handle) and isinstance(found[1], Handle)
        if not goes_on or self._said[found[0].last].text != ",":
            return []
        return [replace(found[0], first=index, form="base"), *found[1:]]

    def _after(self, index: int) -> int | None:
        """The word behind "after", "once you have", "having"."""
        if index >= len(self._said) or self._said[index].text not in (
            "after", "once", "having", "when",
        ):  # fmt: skip
            return None
        position = index + 1
        while position < len(self._said) and self._said[position].text in (
            "you", "have", "having", "has", "are", "done",
        ):  # fmt: skip
            position += 1
        return position if position < len(self._said) else None

    def _is_subordinate(self, index: int) -> bool:
        """Whether a connector stands before, so that a comma ends what begins here."""
        for word in reversed(self._said[max(index - 5, 0) : index]):
            if word.is_mark:
                return False
            if word.text in _CONNECTORS:
                return True
        return False

    def _joined(self, index: int, *, subordinate: bool) -> int | None:
        """Where a further step may begin, behind words that join it to the one before."""
        position = index
        marks = [word.text for word in self._said[index : index + 2]]
        if subordinate and marks[:1] == [","] and marks[1:] not in (["and"], ["then"]):
            return None
        while position < len(self._said) and self._said[position].text in _JOINTS:
            if self._reader.step(position, ()) is not None:
                break
            position += 1
        return position if position > index and position < len(self._said) else None

    def _told(self, steps: Sequence[Step]) -> list[Stops] | None:
        """The stops of the errands that steps tell of; None where they do not make any."""
        first, last = steps[0], steps[-1]
        if isinstance(last, (Go, Lies)):
            return None
        if isinstance(first, Go) and not self._goes_for(first, steps):
            return None
        if isinstance(last, Deed):
            return self._recorded(last, steps[:-1])
        if isinstance(first, Handle) and len(steps) == 1:
            own = first.source is None and self._told_already(first.verb) is not None
            if (own and first.manner is Manner.LIFT) or self._is_state(first):
                return None
            if self._goes_itself(first):
                return None
            return self._each(first)
        stops = stops_of(steps, self._handling)
        return [stops] if stops else None

    def _recorded(self, deed: Deed, before: Sequence[Step]) -> list[Stops] | None:
        own = {self._told_already(index) for index in range(deed.first, deed.last)}
        went = before[0] if before else None
        if (
            own - {None, deed.symbol}
            or len(before) > 1
            or not (went is None or isinstance(went, Go))
        ):
            return None
        where = deed.places or ((went.place,) if went and went.place else ())
        return [((place.symbol, deed.symbol),) for place in where] or [((deed.symbol,),)]

    def _is_state(self, step: Handle) -> bool:
        """Whether "bring x to b" says nothing but a condition, which is told in its own words."""
        if step.goal is None or step.source is not None or len(step.things) != 1:
            return False
        there = self._handling.delivered.get((step.things[0], step.goal.words))
        named = next((first for symbol, first, _ in step.names if symbol == there), None)
        causes = self._said[step.verb].text in ("get", "bring", "put")
        return causes and named is not None and self._told_already(named) == there

    def _goes_itself(self, step: Handle) -> bool:
        """Whether "send x to b" asks another that moves to go there."""
        things = self._handling
        sends = self._said[step.verb].stems & {"send", "move", "drive", "get", "run", "take"}
        return bool(sends) and any(
            thing in things.movers and things.lifts(thing) is None for thing in step.things
        )

    def _each(self, step: Handle) -> list[Stops] | None:
        """What is done to each of several things."""
        several = [replace(step, things=(thing,)) for thing in step.things] or [step]
        found = [stops_of([each], self._handling) for each in several]
        return [each for each in found if each] if all(found) else None

    def _goes_for(self, goes: Go, steps: Sequence[Step]) -> bool:
        """Whether going there belongs to what is done next: "go to a and pick it up (there)"."""
        follows = steps[1]
        delivers = len(steps) > 2
        then = any(word.text in ("then", "next", "before", ".", ";", "afterwards", "after")
                   for word in self._said[goes.last : follows.first])  # fmt: skip
        if isinstance(follows, Deed):
            return follows.there or (not follows.places and not then) or goes.place is None
        if isinstance(follows, Handle) and follows.manner is Manner.LIFT:
            return follows.source is None and (follows.there or delivers or not then)
        return isinstance(follows, Handle) and follows.manner is Manner.LAY and (
            follows.there or (follows.goal is None and not then)
        )  # fmt: skip

    # The word that stands for them.

    def _emit(self, steps: Sequence[Step], found: Sequence[Stops]) -> None:
        named = tuple(dict.fromkeys(self._named(steps)))
        first, last = steps[0].first, steps[-1].last
        head = steps[0]
        for place in head.kept:
            self._out.append(self._said[place])
        form = next((each.form for each in steps if each.form), "base")
        link = steps[-1].link
        for number, stops in enumerate(found):
            if number:
                self._out.append(Word(link, self._said[first].start, self._said[last - 1].end))
            symbols = {symbol for stop in stops for symbol in stop}
            own = tuple(each for each in named if each.symbol in symbols)
            self._out.append(
                Word(
                    self._said[head.verb].text,
                    self._said[first].start,
                    self._said[last - 1].end,
                    errand=self._errand_of(steps, stops, own, form),
                )
            )
        places = [place for each in steps for place in each.where]
        self._last = places[-1] if places else None

    @staticmethod
    def _errand_of(
        steps: Sequence[Step],
        stops: Stops,
        named: tuple[Named, ...],
        form: str,
    ) -> Errand:
        handled = [each for each in steps if isinstance(each, Handle)]
        lays = any(each.manner is not Manner.LIFT for each in handled)
        things = tuple(dict.fromkeys(thing for each in handled for thing in each.things))
        return Errand(stops, named, form, bool(handled), lays, things)

    def _named(self, steps: Sequence[Step]) -> Iterator[Named]:
        for step in steps:
            for symbol, first, last in step.names:
                yield Named(symbol, self._said[first].start, self._said[last - 1].end)
