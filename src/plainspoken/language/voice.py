"""How a verb is told of what it is about: by whoever does it, or as done to something.

Here are also the small words that may stand between the two.
"""

from __future__ import annotations

from collections.abc import Sequence

from plainspoken.language.expression import Expression, Shape
from plainspoken.language.frame import ARTICLES
from plainspoken.language.word import Word

NEGATIONS = frozenset(("not", "no", "never", "neither", "nor"))
_WITHIN_WORDS = """
    is are am be was were been being gets get got getting becomes become becoming
    turns turn turned goes has have had having longer ever already yet finally fully
    completely totally still now also must should can could may might will would
    shall needs need to of in on at into from with up down out off its his their any
    some your 's currently inside itself going right just again entirely onto over
    by for that this these those number no actually immediately promptly really
    always only later then eventually quickly it all both each run runs running lie lies
    lying sit sits stand stands seem seems look looks end ends ended land lands landed reach
    reaches reached reaching make makes come comes came appear appears sent brought start
    starts started starting begin begins began beginning first subsequently
"""
WITHIN = ARTICLES | NEGATIONS | frozenset(_WITHIN_WORDS.split())
OBLIGING = frozenset(("must", "should", "shall", "needs", "to"))
_GETTING = frozenset(("get", "gets", "got", "getting"))
_COMING_TO_BE = _GETTING | {"be", "been", "being"}
LASTING = frozenset(("stay", "stays", "remain", "remains", "kept", "keeps", "keep"))
DOERS = frozenset(("you", "we", "i", "that", "which"))
"""What may stand between the object of an act and its verb: "each jar that you open"."""


def is_relative(said: Sequence[Word], verb: int) -> bool:
    """Whether a verb is told of whoever is spoken to: "each jar (that) you open"."""
    before = verb - 1
    while before > 0 and said[before].text in WITHIN:
        before -= 1
    return said[before].text in DOERS - {"that", "which"} or (
        said[before].text == "robot" and said[before - 1].text == "the"
    )


def is_participle(word: Word) -> bool:
    """Whether a word may be what is done to something: "opened", "cut"."""
    return not word.text.endswith(("ing", "s")) and word.stems != {word.text}


def is_eventful(expression: Expression, at: dict[int, int], said: Sequence[Word]) -> bool:
    """Whether a state is told as something done, or an act as something that is done."""
    part = 0 if expression.shape is Shape.ACT else expression.subject
    if expression.shape is Shape.PLACE or part not in at or not min(at.values()) < at[part]:
        return False
    verb = said[at[part]]
    between = {said[index].text for index in range(min(at.values()), at[part])}
    if not is_participle(verb) or between & LASTING or not between & _COMING_TO_BE:
        return False
    if between & OBLIGING and between & (NEGATIONS - {"neither"}):
        return True
    adjective = len(expression.parts[part].stems) == 1  # "open", and not "opened"
    return (expression.shape is Shape.ACT or adjective) and bool(between & _GETTING)
