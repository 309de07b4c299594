"""An utterance read step by step: what is gone to, picked up, carried, put down, recorded."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from plainspoken.language.deed import ASKING, BEING, KEPT, PASSIVE, DeedReader
from plainspoken.language.handled import ALONG, AMBIGUOUS, LYING, Handled, Where
from plainspoken.language.handling import (
    VERBS,
    Manner,
    noun_at,
    verb_at,
)
from plainspoken.language.step import Go, Handle, Lies, Place, Step, names_of

_BOUNDARY_WORDS = """
    and or but then before after while until till without unless when if as first once whenever
    finally next later eventually whilst though provided only
"""
_BOUNDARIES = frozenset(_BOUNDARY_WORDS.split())


class StepReader(DeedReader):
    """Reads steps from the words of an utterance."""

    def step(self, index: int, before: Sequence[Step], earlier: Sequence[Step] = ()) -> Step | None:
        """The step that begins at a word, after steps of its errand or of an earlier one."""
        fronted = self._fronted(index)
        if fronted is not None:
            return fronted
        return (
            self._deed(index)
            or self._handle(index, before)
            or self._passive(index)
            or self._lies(index)
            or self._again(index, before or earlier)
            or self._go(index)
        )

    def _go(self, index: int) -> Go | None:
        last = self._motion(index)
        if last is None:
            return None
        position = last
        while self._text(position) in ALONG | {"to", "into", "onto", "at", "in", "on", "towards"}:
            if position in self._places:
                break
            position += 1
        place = self.place_at(position)
        if place is not None:
            return Go(
                index, place.last, index, self._form(index),
                ((place.symbol, place.first, place.last),), (place,), place=place,
            )  # fmt: skip
        bare = self._said[index].stems & {"go", "come"} and self._text(index + 1) in ("to", "and")
        if bare and (self._deed(index + 2) or self._handle(index + 2, ())):
            return Go(index, index + 2, index, self._form(index))
        return None

    def _fronted(self, index: int) -> Step | None:
        """Read "from a, take x to b", "from a to b, carry x"."""
        here = self.place_at(index + 1)
        if self._text(index) in ("at", "in", "on", "inside") and here is not None:
            return self._done_at(index, here)
        if self._text(index) != "from" or here is None:
            return None
        where = self._where(index, carried=True, lifted=False)
        behind = where.last + (self._text(where.last) == ",")
        step = self._handle(behind, (), fronted=True) if behind < len(self._said) else None
        if step is None or step.source is not None or (step.goal and where.goal):
            return None
        goal = step.goal or where.goal
        manner = Manner.CARRY if goal is not None else step.manner
        if manner is Manner.LAY:
            manner = Manner.CARRY
        places = tuple(each for each in (where.source, where.goal) if each)
        return replace(
            step, first=index, manner=manner, source=where.source, goal=goal,
            names=(*names_of(places), *step.names), where=(*places, *step.where),
        )  # fmt: skip

    def _done_at(self, index: int, here: Place) -> Step | None:
        """Read "at a, pick up x", "at a, take a photo"."""
        opens = not index or self._said[index - 1].is_mark or self._text(index - 1) in _BOUNDARIES
        behind = here.last + (self._text(here.last) == ",")
        if not opens or behind >= len(self._said):
            return None
        names = names_of((here,))
        deed = self._deed(behind)
        if deed is not None and not deed.places:
            return replace(
                deed, first=index, places=(here,), names=(*names, *deed.names), where=(here,)
            )
        step = self._handle(behind, ())
        if step is None or step.manner is not Manner.LIFT or step.source is not None:
            return None
        return replace(step, first=index, source=here, names=(*names, *step.names), where=(here,))

    def _handle(
        self, index: int, before: Sequence[Step], *, fronted: bool = False
    ) -> Handle | None:
        if index >= len(self._said):
            return None
        holding = any(isinstance(each, Handle) for each in before)
        for manner in (Manner.CARRY, Manner.LIFT, Manner.LAY):
            noun = noun_at(self._said, index, manner)
            verb = (noun, "") if noun else verb_at(self._said, index, manner)
            if verb is None:
                continue
            there = bool(before) and isinstance(before[-1], Go)
            step = self._handled(index, verb, manner, holding=holding, fronted=fronted, there=there)
            if step is not None:
                return replace(step, form="gerund") if noun else step
        return None

    def _handled(
        self,
        index: int,
        verb: tuple[int, str],
        manner: Manner,
        *,
        holding: bool,
        fronted: bool,
        there: bool,
    ) -> Handle | None:
        last, particle = verb
        what = self._object(last, index, manner, holding=holding)
        if what is None:
            return None
        behind = what.last
        if particle:
            if self._text(behind) != particle:
                return None
            behind += 1
        own = tuple(word.text for word in self._said[index:last])
        both = manner is Manner.CARRY and any(
            phrase[0] in self._said[index].stems and phrase[1:] == own[1:]
            for phrase in VERBS[Manner.LIFT]
        )
        where = self._where(behind, carried=manner is not Manner.LIFT, lifted=both)
        if manner is Manner.CARRY and where.goal is None and not fronted:
            if not (there and holding and what.pronoun and where.source is None):
                return None
            manner = Manner.LAY  # "go to b to deliver it"
        if manner is Manner.LIFT and where.goal is not None:
            return None
        if manner is Manner.LIFT and not what.things:
            return None
        if manner is Manner.LIFT and not self._lifts(index, where, what):
            return None
        if what.released and manner is not Manner.LAY:
            return None
        names_only = self._handling.stands_in and bool(what.things) and not holding
        if names_only and manner is Manner.LAY and where.goal is None:
            return None  # "leave a", where a may be a place
        if manner is Manner.LAY and what.last == last and where.goal is None:
            return None
        places = tuple(each for each in (where.source, where.goal) if each)
        return Handle(
            index, where.last, index, self._form(index), (*what.names, *names_of(places)), places,
            there=where.there, manner=manner, things=what.things, source=where.source,
            goal=where.goal,
        )  # fmt: skip

    def _lifts(self, index: int, where: Where, what: Handled) -> bool:
        """Whether "get x" is to pick x up: not in "get x cleaned", nor where x is only a name."""
        loose = not self._said[index].stems.isdisjoint(("get", "take"))
        if self._handling.stands_in and not self._handling.laid:
            return where.source is not None and not loose
        behind = self._text(where.last)
        return not loose or behind in _BOUNDARIES or not behind[0].isalnum()

    def _lies(self, index: int) -> Lies | None:
        """Read "x is (waiting) at a"."""
        what = self._listed(index)
        if what is None or len(what.things) > 1:
            return None
        position = what.last
        while self._text(position) in ("is", "lies", "sits", "waits", "stands", "rests") or (
            self._text(position) in LYING
        ):
            position += 1
        place = self.place_at(position + 1) if position > what.last else None
        if place is None or self._text(position) not in AMBIGUOUS:
            return None
        return Lies(
            index, place.last, index, "", (*what.names, *names_of((place,))), (place,),
            thing=what.things[0], place=place,
        )  # fmt: skip

    def _again(self, index: int, before: Sequence[Step]) -> Handle | None:
        """Read "and y to c" behind "take x to b" as taking it there."""
        last = before[-1] if before else None
        if not isinstance(last, Handle) or not last.things or last.manner is Manner.LAY:
            return None
        what = self._listed(index)
        if what is None or set(what.things) & set(last.things):
            return None
        where = self._where(what.last, carried=last.manner is Manner.CARRY, lifted=False)
        behind = self._text(where.last)
        if (where.goal is None) == (last.manner is Manner.CARRY) or (
            where.goal is None and where.source is None
        ) or not (behind in _BOUNDARIES or not behind[0].isalnum()):  # fmt: skip
            return None
        places = tuple(each for each in (where.source, where.goal) if each)
        return replace(
            last, first=index, last=where.last, names=(*what.names, *names_of(places)),
            where=places, kept=(), there=where.there, things=what.things, source=where.source,
            goal=where.goal,
        )  # fmt: skip

    def _passive(self, index: int) -> Handle | None:
        """Read "x must be taken from a to b"."""
        what = self._listed(index)
        if what is None:
            return None
        position = what.last
        early = self._where(position, carried=False, lifted=False)
        if early.source is not None and early.goal is None:
            position = early.last
        start = position
        while self._text(position) in PASSIVE:
            position += 1
        between = range(start, position)
        if (
            position == start
            or self._text(position - 1) not in BEING
            or position >= len(self._said)
        ):
            return None
        asked = any(self._text(i) in ASKING for i in between)
        step = None
        for manner in (Manner.CARRY, Manner.LIFT, Manner.LAY):
            verb = verb_at(self._said, position, manner)
            if verb is None or verb[1] or self._text(position)[-1] not in "dnt":
                continue
            where = self._where(verb[0], carried=manner is not Manner.LIFT, lifted=False)
            source = where.source or (early.source if start == early.last else None)
            if (manner is Manner.LIFT) == (where.goal is not None):
                continue
            places = tuple(each for each in (source, where.goal) if each)
            step = Handle(
                index, where.last, position, "base" if asked else "finite",
                (*what.names, *names_of(places)), places,
                tuple(i for i in between if self._text(i) in KEPT),
                there=where.there, manner=manner, things=what.things, source=source,
                goal=where.goal,
            )  # fmt: skip
            break
        return step
