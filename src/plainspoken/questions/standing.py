"""Facts that an answer adds as far as it has room: what it does not say, it does not claim."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence

from plainspoken.questions.claim import Draft
from plainspoken.questions.clause import Tense, enumerated
from plainspoken.questions.morphology import listed
from plainspoken.questions.narration import Saying, facts_together, natural
from plainspoken.world.domain import GroundAtom


def fitting(
    draft: Draft, atoms: Iterable[GroundAtom], tense: Tense = "now", opening: str = ""
) -> list[Saying]:
    """The facts that there is room to say, those that come first before others."""
    room = draft.room - len(opening.split()) - 1  # For the "and".
    chosen: list[Saying] = []
    for saying in facts_together(draft.moment.lexicon, atoms, tense, most=draft.length.most_named):
        words = len(saying.text.split())
        if words <= room:
            chosen.append(saying)
            room -= words
    return chosen


def say_facts(
    draft: Draft,
    atoms: Iterable[GroundAtom],
    claim: Callable[[Sequence[GroundAtom]], None],
    tense: Tense = "now",
    opening: str = "",
) -> None:
    """Say the facts that there is room for, and claim those and no others."""
    chosen = fitting(draft, atoms, tense, opening)
    if chosen:
        claim([atom for saying in chosen for atom in saying.atoms if saying.named])
        draft.say(f"{opening} {listed([saying.text for saying in chosen])}".strip())


def say_only(
    draft: Draft,
    changing: Iterable[GroundAtom],
    kept: Sequence[GroundAtom],
    claim: Callable[[Sequence[GroundAtom]], None],
    verb: str,
    *,
    others: Tense,
) -> bool:
    """Say which things change, and claim what is kept of all others; False where listing says more.

    verb: `will change`, `has changed`
    """
    lexicon = draft.moment.lexicon
    subjects = {lexicon.clause(atom).subject for atom in sorted(changing, key=natural)}
    rest = [atom for atom in kept if lexicon.clause(atom).subject not in subjects]
    listable = sum(len(saying.atoms) for saying in fitting(draft, kept, others))
    things = sorted(subjects - {"I"}, key=natural)
    only = f"{'Besides me, only' if 'I' in subjects else 'Only'} {enumerated(things)} {verb}"
    if not things or len(rest) <= listable or len(only.split()) > draft.room:
        return False
    claim(rest)
    draft.say(only)
    return True
