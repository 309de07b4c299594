"""What of a mission cannot be together: a smallest set of its parts, said in English."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import pairwise

from plainspoken.language.clause import CONNECTORS, Clause, Statement, statements
from plainspoken.language.extracted import Reading, executable_of, listed
from plainspoken.language.lexicon import Kind
from plainspoken.language.sentence import Meaning, Sentence
from plainspoken.language.whereabouts import Apart, can_be_met, places_of_robots
from plainspoken.logic.english import say
from plainspoken.logic.formula import atoms, conjunction
from plainspoken.logic.pattern import Patrolling, Pattern
from plainspoken.world.landmark import Landmarks

_SEPARATORS = frozenset(
    (Kind.COMMA, Kind.AND, Kind.OR, Kind.BUT, Kind.THEN, Kind.ONLY_THEN, Kind.STOP)
)


def core(parts: int, meets: Callable[[Sequence[int]], bool]) -> tuple[int, ...]:
    """Which of some parts cannot be together, none of them to spare.

    parts: how many there are, which together cannot be
    meets: whether some of them can be together
    """
    kept = list(range(parts))
    # The last said goes last: what was said first is more often what the others rest on.
    for each in reversed(range(parts)):
        without = [other for other in kept if other != each]
        if without and not meets(without):
            kept = without
    return tuple(kept)


def clash(patterns: Sequence[Pattern], landmarks: Landmarks) -> str | None:
    """Say which of some patterns clash; None where all of them can be met."""
    formulas = [each.executable for each in patterns]
    whole = conjunction(*formulas)
    apart = _apart(patterns, landmarks)
    if can_be_met(whole, apart):
        return None
    found = core(
        len(formulas), lambda some: can_be_met(conjunction(*(formulas[i] for i in some)), apart)
    )
    return disagreement([f'"{say(formulas[i], landmarks)}"' for i in found])


def disagreement(said: Sequence[str]) -> str:
    """A sentence that names parts, in quotation marks, that cannot be together."""
    if len(said) == 1:
        return f"This cannot be met, whatever happens: {said[0]}"
    which = "These two cannot both be" if len(said) == 2 else "These cannot all be"
    return f"{which}: {listed(said, 'and')}"


def contradiction(sentence: Sentence, meaning: Meaning) -> str | None:
    """Say which clauses of a sentence clash; None where all of them can be met."""
    landmarks = sentence.vocabulary.landmarks
    apart = _apart(meaning.patterns, landmarks)
    if can_be_met(executable_of(meaning.patterns), apart):
        return None
    parts = statements(sentence.clauses)

    def meets(some: Sequence[int]) -> bool:
        patterns = sentence.meaning([parts[i] for i in some]).patterns
        return not patterns or can_be_met(executable_of(patterns), apart)

    found = core(len(parts), meets) if len(parts) > 1 else ()
    if len(found) > 1:
        return disagreement([_said(sentence, parts[i]) for i in found])
    within = sentence.meaning([parts[found[0]]]).patterns if found else meaning.patterns
    return clash(within, landmarks) or clash(meaning.patterns, landmarks)


def in_two_places(reading: Reading, landmarks: Landmarks) -> str | None:
    """Said of places to be gone to for ever, which on a finite run means at its last instant."""
    apart = places_of_robots(landmarks, sorted(atoms(reading.formula)))
    if not apart or can_be_met(reading.formula, apart):
        return None
    return (
        "No robot can be at two places at one instant, and this can only be met so. To go to "
        "each of them several times over, say how many rounds to make."
    )


def _apart(patterns: Sequence[Pattern], landmarks: Landmarks) -> Apart:
    """Where no robot can be at once; to patrol places is a mission all the same."""
    if any(isinstance(each, Patrolling) for each in patterns):
        return ()
    names = sorted({name for each in patterns for name in atoms(each.executable)})
    return places_of_robots(landmarks, names)


def _said(sentence: Sentence, part: Statement) -> str:
    """A part in its own words, and as it was read where that is not the same."""
    meaning = sentence.meaning([part])
    own = words_of(sentence, (part.main, *part.subordinates))
    if not meaning.patterns:
        return f'"{own}"'
    read = say(executable_of(meaning.patterns), sentence.vocabulary.landmarks)
    return f'"{read}"' if _plain(own) in ("", _plain(read)) else f'"{own}" ({read})'


def _plain(text: str) -> str:
    return "".join(c for c in text.lower() if c.isalnum())


def words_of(sentence: Sentence, which: Sequence[Clause]) -> str:
    """The words of the utterance that some of its clauses are made of; "" where none are."""
    spans = [span for each, span in _spans(sentence) if each.operands and _among(each, which)]
    if not spans:
        return ""
    return sentence.text(min(first for first, _ in spans), max(last for _, last in spans))


def _among(clause: Clause, which: Sequence[Clause]) -> bool:
    # A connector may have been taken off or turned since.
    return any(clause.operands == each.operands for each in which)


def _spans(sentence: Sentence) -> list[tuple[Clause, tuple[int, int]]]:
    """The clauses that name something, and the words from and up to which each is said."""
    named = [each for each in sentence.clauses if each.operands]
    reaches = [
        (
            min(o.reference.first for o in each.operands),
            max(o.reference.last for o in each.operands),
        )
        for each in named
    ]
    starts, ends = [0], []
    for (_, end), (start, _) in pairwise(reaches):
        cut = next(
            (
                item
                for item in sentence.items
                if end <= item.first < start
                and (item.kind in _SEPARATORS or item.kind in CONNECTORS)
            ),
            None,
        )
        ends.append(max(end, cut.first) if cut else max(end, start))
        starts.append(cut.last if cut and cut.kind in _SEPARATORS else ends[-1])
    last = len(sentence.words)
    while last and sentence.words[last - 1].is_mark:
        last -= 1
    ends.append(last)
    return [
        (each, (_past_separators(sentence, first), max(end, first + 1)))
        for each, first, end in zip(named, starts, ends, strict=True)
    ]


def _past_separators(sentence: Sentence, first: int) -> int:
    for item in sentence.items:
        if item.first == first and item.kind in _SEPARATORS and item.last < len(sentence.words):
            first = item.last
    return first
