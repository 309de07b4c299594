"""A formula said back in English: one short sentence for each pattern that it is made of.

Formulas outside the patterns are said operator by operator, with brackets where they nest.
"""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import Protocol, assert_never

from plainspoken.logic.formula import (
    Always,
    And,
    Atom,
    Constant,
    Eventually,
    Formula,
    Iff,
    Implies,
    Next,
    Not,
    Or,
    Release,
    Until,
    WeakNext,
    WeakUntil,
    atoms,
)
from plainspoken.logic.pattern import (
    AtLeast,
    AtMost,
    BoundDelay,
    BoundReaction,
    Choice,
    DelayedReaction,
    Exactly,
    FairVisit,
    FutureAvoidance,
    GlobalAvoidance,
    GuardedVisit,
    InstantaneousReaction,
    Maintenance,
    OrderedVisit,
    PastAvoidance,
    Patrolling,
    Pattern,
    PromptPrecedence,
    PromptReaction,
    Remaining,
    SequencedVisit,
    StrictOrderedVisit,
    Visit,
    Wait,
    negated,
)
from plainspoken.logic.recognition import is_boolean, is_errand, recognised, sequel

_COPULA = re.compile(r"\b(is|are|has|have|was|were)\b(?! not\b)")


class Described(Protocol):
    """The words of a symbol, as a landmark has them."""

    @property
    def description(self) -> str:
        """As a person says it: "line 1", "the box is full", "to harvest a grape"."""

    @property
    def type(self) -> str:
        """What it says: "location", "condition" or "action"."""


def say(formula: Formula, words: Mapping[str, Described]) -> str:
    """Say a formula in English, as something that a robot is asked to do.

    words: by the name of each proposition; one that is missing is said as it is spelled
    """
    return _Speaker(words).text(formula)


class _Speaker:
    def __init__(self, words: Mapping[str, Described]) -> None:
        self._words = words

    def text(self, formula: Formula) -> str:
        visits: list[Formula] = []
        sentences: list[str] = []
        for each in recognised(formula):
            if isinstance(each, Or) and not is_boolean(each):
                sentences.append(self._choice(each))
                continue
            if isinstance(each, Visit) and all(
                self._type(place) == "location" for place in each.places
            ):
                visits += each.places
                if len(visits) == len(each.places):
                    sentences.append("")  # where the visits will be said together
                    place_of_visits = len(sentences) - 1
            elif isinstance(each, Pattern):
                sentences += self._pattern(each)
            else:
                sentences.append(self._clause(each))
        if visits:
            sentences[place_of_visits] = self._visit(visits)
        return " ".join(f"{sentence[0].upper()}{sentence[1:]}." for sentence in sentences)

    def _choice(self, formula: Or) -> str:
        """Options as one sentence, where each of them is one."""
        options = [self.text(each).removesuffix(".") for each in formula.operands]
        if any("." in option for option in options):
            return self._clause(formula)
        return " or ".join(f"{option[0].lower()}{option[1:]}" for option in options)

    # Operands.

    def _type(self, formula: Formula) -> str:
        """What kind of symbol an atom is; "" for anything but an atom."""
        if isinstance(formula, Atom):
            known = self._words.get(formula.name)
            return str(known.type) if known else "condition"
        return ""

    def _description(self, atom: Atom) -> str:
        known = self._words.get(atom.name)
        return known.description if known else f"{atom.name} is true"

    def _do(self, operand: Formula) -> str:
        """As an order: "visit line 1", "make sure that the box is full"."""
        match self._type(operand):
            case "location" if isinstance(operand, Atom):
                return f"visit {self._description(operand)}"
            case "action" if isinstance(operand, Atom):
                return _bare(self._description(operand))
            case _:
                return self._act_at(operand) or f"make sure that {self._that(operand)}"

    def _is_done(self, errand: Formula) -> bool:
        """Whether all that comes after the first thing is told as acts."""
        return all(
            self._type(each) == "action" or self._act_at(each) for each in sequel(errand)[1:]
        )

    def _act_at(self, operand: Formula) -> str:
        """An action and where it is done: "take a photo at line 1"; "" for anything else."""
        if not isinstance(operand, And) or len(operand.operands) != 2:
            return ""
        place, act = sorted(operand.operands, key=lambda each: self._type(each) != "location")
        told = isinstance(place, Atom) and self._type(place) == "location"
        if not isinstance(place, Atom) or not told or self._type(act) != "action":
            return ""
        return f"{self._do(act)} at {self._description(place)}"

    def _do_not(self, operand: Formula) -> str:
        """As a prohibition: "do not visit line 1"."""
        if self._type(operand) in ("location", "action") or self._act_at(operand):
            return f"do not {self._do(operand)}"
        return f"make sure that {self._that(negated(operand))}"

    def _that(self, operand: Formula) -> str:
        """As a situation: "you are at line 1", "the box is not full"."""
        match operand:
            case Atom():
                return self._that_atom(operand, positive=True)
            case Not(Atom() as atom):
                return self._that_atom(atom, positive=False)
            case And(operands):
                return " and ".join(self._inner(each) for each in operands)
            case Or(operands):
                return " or ".join(self._inner(each) for each in operands)
            case _:
                return self._clause(operand)

    def _inner(self, operand: Formula) -> str:
        text = self._that(operand)
        return f"({text})" if isinstance(operand, (And, Or)) else text

    def _that_atom(self, atom: Atom, *, positive: bool) -> str:
        description = self._description(atom)
        match self._type(atom):
            case "location":
                return f"you are {'' if positive else 'not '}at {description}"
            case "action":
                return f"you {'' if positive else 'do not '}{_bare(description)}"
            case _ if positive:
                return description
            case _ if _COPULA.search(description):
                return _COPULA.sub(r"\1 not", description, count=1)
            case _:
                return f"it is not so that {description}"

    # Patterns.

    def _visit(self, places: Sequence[Formula]) -> str:
        names = [self._description(place) for place in places if isinstance(place, Atom)]
        return f"visit {_listed(names, 'and')}" + (", in any order" if len(names) > 1 else "")

    def _sequence(self, places: Sequence[Formula]) -> str:
        return ", then ".join(map(self._do_together, places))

    def _do_together(self, operand: Formula) -> str:
        """As an order that leaves no doubt that its parts belong to one moment."""
        joint = isinstance(operand, And) and not self._act_at(operand)
        return self._do(operand) + (" at the same time" if joint else "")

    def _pattern(self, pattern: Pattern) -> list[str]:
        match pattern:
            case Visit(places):
                return [self._eventually(place) for place in places]
            case SequencedVisit(places):
                return [self._sequence(places)]
            case OrderedVisit(places) | StrictOrderedVisit(places):
                return self._ordered(places, strict=isinstance(pattern, StrictOrderedVisit))
            case GuardedVisit(place, guard):
                return [self._do(place), *self._pattern(PastAvoidance(place, guard))]
            case Patrolling(places):
                return [f"again and again, {self._do(place)}, to the end" for place in places]
            case Maintenance(kept):
                return [f"at every moment, {self._stay(each)}" for each in kept]
            case Remaining(kept):
                return [f"eventually {self._stay(each)}, for good" for each in kept]
            case GlobalAvoidance(avoided):
                return [self._never(each) for each in avoided]
            case PastAvoidance() | FutureAvoidance() | Wait():
                return self._avoidance(pattern)
            case AtLeast(place, times):
                return [f"{self._do(place)} at least {_times(times)}"]
            case AtMost(place, times):
                return [f"{self._do(place)} at most {_times(times)}"]
            case Exactly(place, times):
                return [f"{self._do(place)} exactly {_times(times)}"]
            case FairVisit(places):
                return [f"{_listed([self._do(place) for place in places], 'and')} by turns"]
            case Choice():
                return [self._clause(pattern.executable)]
            case _:
                return [self._reaction(pattern)]

    def _eventually(self, place: Formula) -> str:
        if self._type(place) or self._act_at(place):
            return f"{self._do(place)} at some point"
        together = ", at the same time" if isinstance(place, And) else ""
        return f"at some point make sure that {self._that(place)}{together}"

    def _stay(self, kept: Formula) -> str:
        if self._type(kept) == "location" and isinstance(kept, Atom):
            return f"stay at {self._description(kept)}"
        return f"make sure that {self._that(kept)}"

    def _never(self, avoided: Formula) -> str:
        if self._type(avoided) in ("location", "action") or self._act_at(avoided):
            return f"never {self._do(avoided)}"
        return f"at every moment, make sure that {self._that(negated(avoided))}"

    def _ordered(self, places: Sequence[Formula], *, strict: bool) -> list[str]:
        sentences = [self._sequence(places)]
        for here, there in pairwise(places):
            sentences.append(f"{self._do_not(there)} before {self._that(here)}")
            if strict:
                sentences.append(f"{self._do_not(here)} again before {self._that(there)}")
        return sentences

    def _avoidance(self, pattern: PastAvoidance | FutureAvoidance | Wait) -> list[str]:
        match pattern:
            case PastAvoidance(_, until) if is_errand(until) and not self._is_done(until):
                return [self._clause(pattern.executable)]
            case PastAvoidance(avoided, until, demanded) if is_errand(until):
                errand = self._sequence(sequel(until))
                guard = f"{self._do_not(avoided)} until you {errand}"
                return [errand, guard] if demanded else [guard]
            case PastAvoidance(avoided, until, demanded):
                together = " at the same time" if isinstance(until, And) else ""
                guard = f"{self._do_not(avoided)} until {self._that(until)}{together}"
                return [self._eventually(until), guard] if demanded else [guard]
            case FutureAvoidance(after, avoided):
                return [f"after {self._that(after)}, {self._do_not(avoided)} any more"]
            case Wait(kept, until):
                first, *later = sequel(until)
                then = "".join(f", then {self._do(each)}" for each in later)
                return [f"{self._stay(kept)} until {self._that(first)}{then}"]
            case _:
                assert_never(pattern)

    def _reaction(
        self,
        pattern: InstantaneousReaction
        | DelayedReaction
        | PromptReaction
        | PromptPrecedence
        | BoundReaction
        | BoundDelay,
    ) -> str:
        first, *later = sequel(pattern.response)
        then = "".join(f", then {self._do(each)}" for each in later)
        trigger, response = self._that(pattern.trigger), self._do(first)
        steady = getattr(pattern, "persists", False)
        every = not steady and self._lasts(pattern.trigger)
        start = f"at every step at which {trigger}," if every else f"as soon as {trigger},"
        match pattern:
            case InstantaneousReaction(a, Not(b)) if self._type(b) in ("location", "action"):
                return f"never {self._do(b)} while {trigger}"
            case InstantaneousReaction(a, b) if self._type(a) == self._type(b) == "location":
                # "visit a only if you are at b" would be taken for an order of the two
                return f"never {self._do(a)} while {self._that(Not(b))}"
            case InstantaneousReaction(a, b) if self._type(a) in ("location", "action"):
                return f"{self._do(a)} only if {self._that(b)}"
            case InstantaneousReaction(_, b):
                return f"whenever {trigger}, make sure that {self._that(b)} at the same time"
            case DelayedReaction():
                return f"whenever {trigger}, eventually {response}{then}"
            case PromptReaction():
                return f"{start} {response} in the next step{then}"
            case PromptPrecedence():
                after = "in the step after one at which" if every else "right after"
                return f"{response} only {after} {trigger}"
            case BoundReaction(_, b):
                return f"make sure that {self._that(b)} if and only if {trigger}"
            case BoundDelay():
                return f"{start} {response} in the next step, and at no other time"
            case _:
                assert_never(pattern)

    def _lasts(self, trigger: Formula) -> bool:
        """Whether a trigger may hold for several instants on end."""
        names = atoms(trigger)
        if isinstance(trigger, Not):
            return True
        return not any(self._type(Atom(name)) == "action" for name in names)

    # Anything else, operator by operator.

    def _clause(self, formula: Formula) -> str:
        if is_boolean(formula) and not isinstance(formula, Constant):
            match formula:
                case Not(operand) if not isinstance(operand, Atom):
                    return f"it is not so that {self._nested(operand)}"
                case _:
                    return self._that(formula)
        match formula:
            case Constant(value):
                return "anything goes" if value else "nothing will do"
            case Atom():
                return self._that(formula)
            case Not(f):
                return f"it is not so that {self._nested(f)}"
            case And(operands):
                return f"both {' and '.join(map(self._nested, operands))}"
            case Or(operands):
                return f"either {' or '.join(map(self._nested, operands))}"
            case Implies(left, right):
                return f"if {self._nested(left)}, then {self._nested(right)}"
            case Iff(left, right):
                return f"{self._nested(left)} if and only if {self._nested(right)}"
            case Next(f):
                return f"there is a next step, and in it {self._nested(f)}"
            case WeakNext(f):
                return f"if there is a next step, in it {self._nested(f)}"
            case Eventually(f):
                return f"at some point {self._nested(f)}"
            case Always(f):
                return f"at every point {self._nested(f)}"
            case Until(left, right):
                return f"{self._nested(left)} until at some point {self._nested(right)}"
            case WeakUntil(left, right):
                return f"{self._nested(left)} until {self._nested(right)}, or to the end"
            case Release(left, right):
                return f"{self._nested(right)} up to when {self._nested(left)}, or to the end"
            case _:
                assert_never(formula)

    def _nested(self, formula: Formula) -> str:
        text = self._clause(formula)
        simple = isinstance(formula, Atom) or (
            isinstance(formula, Not) and isinstance(formula.operand, Atom)
        )
        return text if simple else f"({text})"


def _bare(description: str) -> str:
    return description.removeprefix("to ")


def _times(times: int) -> str:
    return {1: "once", 2: "twice"}.get(times, f"{times} times")


def _listed(texts: Sequence[str], word: str) -> str:
    if len(texts) == 1:
        return texts[0]
    return f"{', '.join(texts[:-1])} {word} {texts[-1]}"
