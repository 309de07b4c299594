"""A report in words becomes facts to confirm, a question back, or a reason to refuse it.

    report = understood("I cleared line 2 myself", lexicon, state)
    report.said     # (("cleared l2", True),)

Whatever the words are, nothing comes out but atoms of the problem that some action can change.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import product
from typing import Any

from plainspoken.language.extracted import Status
from plainspoken.language.refusal import LONGEST
from plainspoken.planning.exclusion import Exclusions, Literal
from plainspoken.questions.accomplishment import Deed, Outcomes, accomplished
from plainspoken.questions.concordance import opposites
from plainspoken.questions.consequence import Clash, Open, Settled, exclusions_of, settled
from plainspoken.questions.kind import Kind
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import listed
from plainspoken.questions.narration import facts_together
from plainspoken.questions.question import question_of
from plainspoken.questions.telling import Told, ahead, told, unsure
from plainspoken.world.domain import GroundAtom, State

MOST_CHOICES = 6
MOST_IMPLIED = 6
"""Conclusions that are said back one by one."""


@dataclass(frozen=True, slots=True)
class Choice:
    """One thing that a report may mean: the words to choose it by, and the facts."""

    answer: str
    facts: Settled


@dataclass(frozen=True, slots=True)
class Report:
    """What became of a report.

    facts:    what is to be recorded (status ok)
    english:  those facts said back
    question: what is not clear (status clarify), and `choices` to answer it with
    reason:   why it is refused (status reject)
    """

    text: str
    status: Status
    facts: Settled | None = None
    english: str = ""
    question: str | None = None
    choices: tuple[Choice, ...] = ()
    reason: str | None = None

    @property
    def said(self) -> tuple[Literal, ...]:
        return self.facts.said if self.facts else ()

    @property
    def added(self) -> frozenset[GroundAtom]:
        return self._changed(holds=True)

    @property
    def deleted(self) -> frozenset[GroundAtom]:
        return self._changed(holds=False)

    def to_json(self) -> dict[str, Any]:
        """What `report --json` prints, without what became of it."""

        def texts(literals: Iterable[Literal]) -> list[str]:
            return [atom if holds else f"not {atom}" for atom, holds in literals]

        return {
            "text": self.text,
            "status": str(self.status),
            "facts": texts(self.said),
            "implied": texts(self.facts.implied if self.facts else ()),
            "english": self.english or None,
            "question": self.question,
            "choices": [
                {"answer": each.answer, "facts": texts(each.facts.said)} for each in self.choices
            ],
            "reason": self.reason,
        }

    def _changed(self, *, holds: bool) -> frozenset[GroundAtom]:
        if self.facts is None:
            return frozenset()
        return frozenset(atom for atom, so in self.facts.whole if so == holds)


def understood(
    text: str, lexicon: Lexicon, state: State, unknown: Iterable[GroundAtom] = ()
) -> Report:
    """Understand a report.

    state:   what is so now, static atoms included
    unknown: what nobody knew at s0, beside what the problem names
    """
    reason = _unspeakable(text)
    if reason is not None:
        return Report(text, Status.REJECT, reason=reason)
    clauses = told(text, lexicon)
    reason = _refusal(text, clauses, lexicon)
    if reason is not None:
        return Report(text, Status.REJECT, reason=reason)
    exclusions = exclusions_of(lexicon.problem, frozenset(unknown))
    return _Reader(lexicon, state, exclusions).report(text, clauses)


def settled_on(report: Report, choice: Choice, lexicon: Lexicon) -> Report:
    """A report with the question answered."""
    english = said_back(choice.facts, lexicon)
    return replace(
        report, status=Status.OK, facts=choice.facts, english=english, question=None, choices=()
    )


def said_back(facts: Settled, lexicon: Lexicon) -> str:
    """Facts in words, those that follow behind."""
    text = in_words(facts.said, lexicon)
    gained = [each for each in facts.implied if each[1]]
    lost = [each for each in facts.implied if not each[1]]
    follows = in_words([*gained, *lost][:MOST_IMPLIED], lexicon)
    more = len(facts.implied) - MOST_IMPLIED
    tail = f" and {more} more such facts" if more > 0 else ""
    return f"{text}; so {follows}{tail}" if follows else text


def in_words(literals: Iterable[Literal], lexicon: Lexicon) -> str:
    """Literals as one small sentence."""
    true = [atom for atom, holds in literals if holds]
    false = [atom for atom, holds in literals if not holds]
    parts = [each.text for each in facts_together(lexicon, true, most=12)]
    parts += [each.text for each in facts_together(lexicon, false, negative=True, most=12)]
    return listed(parts)


# -- refusals ----------------------------------------------------------------------------------


def _unspeakable(text: str) -> str | None:
    if not text.strip():
        return "Nothing is said."
    if len(text) > LONGEST:
        return f"That is too long: a report has {LONGEST} characters at most."
    return None


def _refusal(text: str, clauses: Sequence[Told], lexicon: Lexicon) -> str | None:
    if text.rstrip().endswith("?"):
        return "That is a question, and no report: `plainspoken ask` answers it."
    understood_something = any(c.facts or c.deeds or c.made for c in clauses)
    surely = any((c.facts and not c.loose) or c.deeds or c.made for c in clauses)
    if not surely and question_of(text, lexicon).kind is Kind.COMMAND:
        return "That asks for something, and reports nothing: `plainspoken missions change` does."
    if unsure(text):
        return "You do not seem sure of that. Say only what you know."
    if ahead(text):
        return "That is yet to come. Say it once it is so."
    if not understood_something:
        return "That speaks of nothing that I keep track of."
    trouble = next((c.trouble for c in clauses if c.trouble), None)
    return f"{trouble[0].upper()}{trouble[1:]}: say what is so now." if trouble else None


# -- what is meant -----------------------------------------------------------------------------


def _opposite(fact: Literal, exclusions: Exclusions) -> Literal:
    """That a mug is not checked says that it is unchecked, where that is one of what it can be."""
    atom, holds = fact
    if holds:
        return fact
    predicate, *arguments = atom.split()
    for other in exclusions.group(atom):
        word, *same = other.split()
        if same == arguments and word in opposites(predicate):
            return other, True
    return fact


class _Reader:
    """What clauses come to in one state of one problem."""

    def __init__(self, lexicon: Lexicon, state: State, exclusions: Exclusions) -> None:
        self._lexicon = lexicon
        self._state = state
        self._exclusions = exclusions

    def report(self, text: str, clauses: Sequence[Told]) -> Report:
        named = frozenset(
            name
            for clause in clauses
            for part in clause.words.split("<")[1:]
            for name in part.split(">")[0].split("+")
        )
        stated = [_opposite(fact, self._exclusions) for clause in clauses for fact in clause.facts]
        ways = [list(stated)]
        for clause in clauses:
            for deeds in clause.deeds or (((),) if clause.made else ()):
                options = self._options(deeds, clause.made, named)
                if options:
                    ways = [[*way, *more] for way, more in product(ways, options)]
        odd = [word for clause in clauses for word in clause.odd]
        odd += [c.words for c in clauses if not (c.facts or c.deeds or c.made)]
        return self._settled(text, _agreeing(ways, stated), odd)

    def _options(
        self, deeds: Sequence[Deed], made: Sequence[Literal], named: frozenset[str]
    ) -> list[tuple[Literal, ...]]:
        """The facts that a deed may have made so."""
        found: dict[tuple[Literal, ...], None] = {}
        objects = deeds[0].objects if deeds else None
        own = [m for m in made if objects is None or set(m[0].split()[1:]) <= set(objects)]
        for deed in deeds:
            ends = accomplished(deed, named, self._state, self._lexicon, self._exclusions)
            for each in ends:
                found.update(dict.fromkeys(_with_verb(each, own)))
        if own and not any(set(own) <= set(each) for each in found):
            return [tuple(own)]
        return list(found)

    def _settled(self, text: str, ways: list[list[Literal]], odd: Sequence[str]) -> Report:
        """One way is the report, several are a question, none is a refusal."""
        said = dict.fromkeys(tuple(dict.fromkeys(way)) for way in ways if way)
        endings = {each: settled(each, self._state, self._exclusions) for each in said}
        if not endings:
            reason = "That is clear, but I cannot tell what has come of it."
            return Report(text, Status.REJECT, reason=reason)
        good = [each for each in endings.values() if isinstance(each, Settled)]
        if len(endings) == 1 and not good:
            ((literals, only),) = endings.items()
            if isinstance(only, Open):
                return self._which(text, literals, only)
            assert isinstance(only, Clash)  # noqa: S101 - what is neither settled nor open
            return Report(text, Status.REJECT, reason=_clash_words(only, self._lexicon))
        if not good:
            return Report(text, Status.REJECT, reason="That cannot be, whichever way it is meant.")
        if len(good) > MOST_CHOICES:
            question = "That may mean many things. Say of what it is so."
            return Report(text, Status.CLARIFY, question=question)
        if len(good) > 1:
            shared = set.intersection(*(set(each.said) for each in good))
            choices = tuple(
                Choice(_own_words(each, shared, good, self._lexicon), each) for each in good
            )
            return Report(text, Status.CLARIFY, question="How did it turn out?", choices=choices)
        english = said_back(good[0], self._lexicon)
        if odd:
            question = f'Do you mean: "{english}"?'
            choice = Choice("yes", good[0])
            return Report(text, Status.CLARIFY, question=question, choices=(choice,))
        return Report(text, Status.OK, good[0], english)

    def _which(self, text: str, said: Sequence[Literal], left: Open) -> Report:
        """A question what is so instead of what is not so any more."""
        choices = []
        for each in left.candidates:
            ending = settled([*said, (each, True)], self._state, self._exclusions)
            if isinstance(ending, Settled):
                choices.append(Choice(in_words([(each, True)], self._lexicon), ending))
        lost = in_words([(left.no_more, False)], self._lexicon)
        question = f"Then {lost}. What is so instead?"
        if len(choices) > MOST_CHOICES:
            choices = []
        return Report(text, Status.CLARIFY, question=question, choices=tuple(choices))


def _with_verb(outcomes: Outcomes, made: Sequence[Literal]) -> Outcomes:
    """The outcomes in which what the verb says has come about: who cooked it has it cooked."""
    fitting = tuple(each for each in outcomes if set(made) & set(each))
    return fitting or outcomes


def _agreeing(ways: list[list[Literal]], stated: Sequence[Literal]) -> list[list[Literal]]:
    """The ways that do not deny what is stated; those that say it too, if any do."""
    denied = {(atom, not holds) for atom, holds in stated}
    kept = [way for way in ways if not denied & set(way)] or ways
    count = len(stated)
    saying = [way for way in kept if set(way[count:]) & set(stated)]
    return saying or kept


def _own_words(
    facts: Settled, shared: set[Literal], others: Sequence[Settled], lexicon: Lexicon
) -> str:
    """What tells one way from the others."""
    own = [each for each in facts.said if each not in shared]
    if own:
        return in_words(own, lexicon)
    foreign = {each for other in others for each in other.said} - set(facts.said)
    return in_words([(atom, not holds) for atom, holds in sorted(foreign)], lexicon)


def _clash_words(clash: Clash, lexicon: Lexicon) -> str:
    one, other = clash.one, clash.other
    if one == other:
        never = "can never be so here" if one[1] else "is always so here"
        return f"That {in_words([(one[0], True)], lexicon)} {never}."
    return (
        f"That cannot be: {in_words([one], lexicon)}, and {in_words([other], lexicon)}, "
        "are never so together."
    )
