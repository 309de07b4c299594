"""Whether a clause speaks of doing: the form and the place of the verbs of a domain in it."""

from __future__ import annotations

import re
from functools import lru_cache

from plainspoken.questions.grammar import BE, DO, MODAL, Shape
from plainspoken.questions.morphology import participle, past, progressive, third_person
from plainspoken.questions.referent import MOTION, Referents


@lru_cache(maxsize=8)
def forms_of(verbs: frozenset[str]) -> dict[str, str]:
    """Each form of some verbs, and what it is."""
    found: dict[str, str] = {}
    for verb in sorted(verbs):
        found[third_person(verb)] = "s"
        found[participle(verb)] = "participle"
        found[past(verb)] = "past"
        found[progressive(verb)] = "ing"
    return {**found, **dict.fromkeys(verbs, "base")}


def _is_mine(shape: Shape) -> bool:
    """Whether I am the one who goes or works, said or unsaid: `why go there`."""
    mine = shape.has("you|your") or not shape.auxiliary or shape.subject == "robot"
    return mine or shape.clause.startswith("what ")


def of_a_thing(shape: Shape, referents: Referents) -> bool:
    """Whether a thing is what acts: `the soup tastes of nothing`, `why did the stove go out`."""
    subject = re.search(
        r"\b(?:why|how come|that|do|does|did|has|have|had|will)\b (?:the |that |my |your )?"
        rf"(?:{'|'.join(map(re.escape, sorted(referents.things))) or '(?!)'})\b",
        shape.clause,
    )
    passive = r"\b(?:be|been|being|get|gets|got|is|are|was|were)\b|\b(?:have|has|had) to\b"
    return subject is not None and not re.search(passive, shape.clause)


_WORK = frozenset({"do", "perform", "carry", "execute", "work", "need", "bother", "use", "choose"})


def does(shape: Shape, referents: Referents) -> bool:
    """Whether a verb of doing is in the clause as a verb: its form and place decide.

    `The box was emptied`, `emptying it` and `to empty it` are deeds, `the box is empty` is not.
    """
    if of_a_thing(shape, referents):
        return False
    mine = _is_mine(shape)
    known = forms_of(referents.verbs if mine else referents.verbs - MOTION)
    further = forms_of(MOTION | _WORK) if mine else {}
    words = shape.clause.split()
    helped = False  # An auxiliary that takes a bare form stands before.
    been = False
    for index, word in enumerate(words):
        before = words[index - 1] if index else ""
        form = known.get(word) or (further.get(word) if word not in DO else None)
        if form in ("past", "participle", "ing"):
            if form == "ing" or not been or word in known:
                return True
        elif form is not None and (
            (form == "base" and (helped or before in ("to", "why", "you", "not", "for", "and")))
            or (form == "s" and before not in ("the", "your", "a"))
            or (form == "base" and index == 0)
        ):
            return True
        helped = helped or word in DO or word in MODAL
        been = been or word in BE
    return False


def does_exactly(shape: Shape, referents: Referents, *forms: str) -> bool:
    """Whether a verb of the domain is in the clause, in whatever form but as a bare word."""
    known = forms_of(referents.verbs)
    wanted = forms or ("past", "participle", "ing", "s")
    return any(known.get(word) in wanted for word in shape.clause.split())
