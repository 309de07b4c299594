"""Sentences whose words are clear and whose structure is not: a question, with its answers.

Asked only where the sentence itself hints at a second reading. What English settles by custom, or
the catalogue of patterns does, is not asked.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

from plainspoken.automata.equivalence import equivalent, satisfiable
from plainspoken.language.clause import Act, Clause, Operand, Statement, statements
from plainspoken.language.contradiction import words_of
from plainspoken.language.counting import Count
from plainspoken.language.extracted import executable_of
from plainspoken.language.item import Item
from plainspoken.language.lexicon import Kind
from plainspoken.language.reading import clauses
from plainspoken.language.reference import Form
from plainspoken.language.refusal import aimless, idle, unfinished
from plainspoken.language.sentence import Meaning, Sentence
from plainspoken.logic.english import say
from plainspoken.logic.formula import Formula, Next, atoms, conjunction
from plainspoken.logic.pattern import (
    Choice,
    DelayedReaction,
    GlobalAvoidance,
    OrderedVisit,
    Pattern,
    PromptReaction,
    SequencedVisit,
    Visit,
)


@dataclass(frozen=True, slots=True)
class Option:
    """One way to understand a sentence, and what to answer to choose it.

    english: where the formula's own would be hard to read
    """

    answer: str
    patterns: tuple[Pattern, ...]
    english: str = ""


@dataclass(frozen=True, slots=True)
class Ambiguity:
    """A question about a sentence, the likeliest answer first."""

    question: str
    options: tuple[Option, ...]


def ambiguity(sentence: Sentence, meaning: Meaning) -> Ambiguity | None:
    """The first question that a sentence leaves open; None where there is none."""
    for doubt in _DOUBTS:
        found = doubt(sentence, meaning)
        if found is not None and _differ(found.options):
            return found
    return None


def _differ(options: Sequence[Option]) -> bool:
    """Whether all options ask for something that can be met, and each for something else."""
    formulas = [executable_of(each.patterns) for each in options if each.patterns]
    return (
        len(formulas) == len(options)
        and all(map(satisfiable, formulas))
        and not any(
            equivalent(one, other) for i, one in enumerate(formulas) for other in formulas[:i]
        )
    )


def _others(meaning: Meaning, change: Callable[[Pattern], Pattern | None]) -> tuple[Pattern, ...]:
    """The patterns with those replaced that a change is for."""
    return tuple(change(each) or each for each in meaning.patterns)


# "a, then immediately b": in the next step, or only later?

_AT_ONCE = frozenset((Kind.NEXT, Kind.RIGHT_AFTER_THAT, Kind.NEXT_INSTANT))
_IMMEDIATE = frozenset(
    ("immediately", "right", "straight", "straightaway", "instantly", "once",
     "promptly", "quickly", "asap", "delay")
)  # fmt: skip


def _next_or_later(sentence: Sentence, meaning: Meaning) -> Ambiguity | None:
    said_so = any(
        item.kind in _AT_ONCE and not _IMMEDIATE.isdisjoint(item.text.split())
        for item in sentence.items
    )
    hinted = [
        each
        for each in sentence.clauses
        if said_so and each.connector is None and each.flags & _AT_ONCE and each.act is Act.DO
    ]
    chains = [each for each in meaning.patterns if isinstance(each, (SequencedVisit, OrderedVisit))]
    if not hinted or len(chains) != 1:
        return None
    places = chains[0].places
    symbols = {o.reference.symbol for each in hinted for o in each.operands}
    at = next((i for i, each in enumerate(places) if i and atoms(each) & symbols), None)
    if at is None:
        return None

    def prompt(pattern: Pattern) -> Pattern | None:
        if pattern is not chains[0]:
            return None
        return Visit((_in_a_row(places, at),))

    before, after = (_named(places[i], sentence) for i in (at - 1, at))
    plain = say(executable_of(meaning.patterns), sentence.vocabulary.landmarks)
    english = f"{plain} Nothing comes between {before} and {after}."
    return Ambiguity(
        f"Should {after} come right after {before}, or just later?",
        (
            Option("just later", meaning.patterns),
            Option("right after", _others(meaning, prompt), english),
        ),
    )


def _in_a_row(places: Sequence[Formula], at: int) -> Formula:
    """One after another, the one at a position at the instant after the one before it."""
    *before, last = places
    formula = last
    for i in reversed(range(len(before))):
        later = Next(formula) if i + 1 == at else SequencedVisit((formula,)).literal
        formula = conjunction(before[i], later)
    return formula


def _named(formula: Formula, sentence: Sentence) -> str:
    names = sorted(atoms(formula))
    known = sentence.vocabulary.landmarks
    return " and ".join(known[name].description for name in names if name in known)


# "... soon": at once, or at some time?

_BETWEEN = frozenset(("soon", "shortly", "fast", "swiftly", "before long"))


def _prompt_or_delayed(sentence: Sentence, meaning: Meaning) -> Ambiguity | None:
    word = next((each.text for each in sentence.items if each.text in _BETWEEN), None)
    reactions = [each for each in meaning.patterns if isinstance(each, DelayedReaction)]
    if word is None or len(reactions) != 1:
        return None
    trigger = reactions[0].trigger
    steady = all(sentence.vocabulary.persists(name) for name in atoms(trigger))

    def prompt(pattern: Pattern) -> Pattern | None:
        if not isinstance(pattern, DelayedReaction):
            return None
        return PromptReaction(pattern.trigger, pattern.response, steady)

    return Ambiguity(
        f'By "{word}", do you mean in the very next step, or some time later?',
        (
            Option("some time later", meaning.patterns),
            Option("in the next step", _others(meaning, prompt)),
        ),
    )


# "do a and do b if c": does the condition go with both?

_CONDITIONS = frozenset((Kind.WHEN, Kind.WHENEVER, Kind.UNLESS))


def _shared_condition(sentence: Sentence, meaning: Meaning) -> Ambiguity | None:
    parts = statements(sentence.clauses)
    for place, (one, other) in enumerate(pairwise(parts)):
        if not _may_share(one, other, sentence.clauses):
            continue
        condition = other.subordinates[0]
        both = [
            *parts[:place],
            replace(one, subordinates=(condition,)),
            *parts[place + 1 :],
        ]
        last = words_of(sentence, (other.main,)) or "the last part"
        return Ambiguity(
            f'Does "{words_of(sentence, (condition,))}" go with both parts, or only with "{last}"?',
            (
                Option(f"only {last}", meaning.patterns),
                Option("both", sentence.meaning(both).patterns),
            ),
        )
    return None


def _may_share(one: Statement, other: Statement, said: Sequence[Clause]) -> bool:
    main = other.main
    return (
        not one.subordinates
        and bool(one.main.operands and main.operands)
        and one.main.modality is main.modality
        and not (one.main.counts or main.counts)
        and one.main.act is Act.DO is main.act
        and main.link is Kind.AND
        and not main.pause
        and not main.flags & {Kind.ALWAYS}
        and len(other.subordinates) == 1
        and other.subordinates[0].connector in _CONDITIONS
        and other.subordinates[0].link is None
        and not other.subordinates[0].pause
        and _stand_in_order((one.main, main, other.subordinates[0]), said)
    )


def _stand_in_order(some: Sequence[Clause], said: Sequence[Clause]) -> bool:
    places = [said.index(each) if each in said else -1 for each in some]
    return -1 not in places and places == list(range(places[0], places[0] + len(places)))


# "a or b and c": which two belong together?


def _mixed_list(sentence: Sentence, _: Meaning) -> Ambiguity | None:
    parts = statements(sentence.clauses)
    for place, part in enumerate(parts):
        links = [each.link for each in part.main.operands[1:]]
        plain = part.main.act is Act.DO and not part.subordinates and not part.main.counts
        if not plain or set(links) != {Kind.OR, Kind.AND} or links != sorted(
            links, key=links.index
        ):  # fmt: skip
            continue
        cut = links.index(links[-1])
        operands = part.main.operands
        options = []
        for split, link in ((cut, links[0]), (cut + 1, links[-1])):
            groups = (operands[:split], operands[split:])
            options.append(
                Option(
                    _grouped(groups, link, sentence),
                    sentence.meaning(
                        [*parts[:place], *_apart(part, groups, link), *parts[place + 1 :]]
                    ).patterns,
                )
            )
        first, second = (each.answer for each in options)
        return Ambiguity(f"Which do you mean: {first}, or {second}?", tuple(options))
    return None


def _apart(
    part: Statement, groups: tuple[tuple[Operand, ...], ...], link: Kind | None
) -> Iterator[Statement]:
    first, second = groups
    yield replace(part, main=replace(part.main, operands=first))
    second = (replace(second[0], link=None), *second[1:])
    yield Statement(replace(part.main, operands=second, link=link, pause=False))


def _grouped(groups: tuple[tuple[Operand, ...], ...], link: Kind | None, sentence: Sentence) -> str:
    joints = {Kind.OR: " or ", Kind.AND: " and "}

    def joined(some: Sequence[Operand]) -> str:
        text = _said(some[0], sentence)
        for each in some[1:]:
            text += joints.get(each.link or Kind.AND, " and ") + _said(each, sentence)
        return text

    one, other = map(joined, groups)
    if link is Kind.AND:
        if len(groups[0]) > 1:
            one = f"either {one}"
        else:
            other = f"either {other}"
        return f"{one}, and {other}" if len(groups[0]) > 1 else f"{one}, and besides {other}"
    return f"{one}, or else {other}"


def _said(operand: Operand, sentence: Sentence) -> str:
    return sentence.text(operand.reference.first, operand.reference.last)


# "do not visit all sites": none, or not all of them?


def _not_all(sentence: Sentence, meaning: Meaning) -> Ambiguity | None:
    avoided = [each for each in meaning.patterns if isinstance(each, GlobalAvoidance)]
    places = [place for each in avoided for place in each.avoided]
    denied = next((item for item in sentence.items if item.kind is Kind.NOT), None)
    if denied is None or len(places) < 2 or len(sentence.clauses) != 1:
        return None
    # A plural was put in the place of its members: its own words are only in the utterance.
    start = sentence.words[denied.first].start
    end = max(sentence.words[each.last - 1].end for each in sentence.references)
    between = sentence.utterance[start:end].lower().split()
    if {"all", "every"}.isdisjoint(between) or any(
        item.kind in (Kind.AVOID, Kind.LEAVE) for item in sentence.items
    ):
        return None
    rest = tuple(each for each in meaning.patterns if each not in avoided)
    some = tuple((GlobalAvoidance((place,)),) for place in places)
    return Ambiguity(
        "Do you mean none of them, or only not all of them?",
        (
            Option("none of them", meaning.patterns),
            Option("not all of them", (*rest, Choice(some))),
        ),
    )


# "... once ...": one time, or as soon as?


def _one_time_or_when(sentence: Sentence, meaning: Meaning) -> Ambiguity | None:
    found = sentence.items
    for place, item in enumerate(found[:-1]):
        behind = found[place + 1]
        bare = behind.form is Form.NOUN and behind.reference is not None
        if item.text != "once" or item.kind is not Kind.AFTER or not bare or not place:
            continue
        counted = replace(item, kind=Kind.COUNT, count=Count("", 1))
        other = _reread(sentence, (*found[:place], counted, *found[place + 1 :]))
        if other is None:
            return None
        return Ambiguity(
            'By "once", do you mean one time, or as soon as?',
            (Option("as soon as", meaning.patterns), Option("one time", other)),
        )
    return None


def _reread(sentence: Sentence, found: tuple[Item, ...]) -> tuple[Pattern, ...] | None:
    """What the sentence would ask for with other items; None where it would make no sense."""
    instead = replace(sentence, items=found, clauses=clauses(found))
    meaning = instead.meaning()
    if idle(meaning, sentence.utterance) or aimless(meaning) or unfinished(instead.clauses):
        return None
    return meaning.patterns


_DOUBTS = (
    _mixed_list,
    _not_all,
    _one_time_or_when,
    _shared_condition,
    _next_or_later,
    _prompt_or_delayed,
)
