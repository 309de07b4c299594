"""What an utterance means by a network that has learned from sentences, as a second reader.

It reads the same references as the rules do, and writes patterns over the symbols of the domain;
what it writes becomes a formula by the same construction, or nothing.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from plainspoken.language.extracted import Reading
from plainspoken.language.marking import marked
from plainspoken.language.network import Network, network
from plainspoken.language.notation import NotationError, executable, literal, read
from plainspoken.language.sentence import Sentence
from plainspoken.logic.formula import Formula, atoms, conjunction
from plainspoken.logic.pattern import Pattern


@dataclass(frozen=True, slots=True)
class Learned:
    """What the network makes of a sentence.

    reading:     None where it finds no mission, or what it wrote is no formula
    probability: of what it wrote, by its own estimate
    refusal:     the probability that there is no mission
    """

    reading: Reading | None
    probability: float
    refusal: float


Reader = Callable[[Sentence], Learned]
"""What reads a sentence beside the rules."""


def learned(sentence: Sentence, reader: Network | None = None) -> Learned:
    """Read a sentence by the network."""
    said = marked(sentence)
    written = (reader or network()).write(said)
    if written.tokens is None:
        return Learned(None, written.probability, written.refusal)
    known = sentence.vocabulary

    def persists(formula: Formula) -> bool:
        return all(known.persists(name) for name in atoms(formula))

    try:
        stated = read(written.tokens, persists)
    except NotationError:
        return Learned(None, 0.0, written.refusal)
    formula = conjunction(*map(executable, stated))
    patterns = tuple(each for each in stated if isinstance(each, Pattern))
    reading = Reading(
        formula,
        conjunction(*map(literal, stated)),
        "",  # said where it is needed: most readings only confirm the rules
        written.probability,
        patterns=patterns if len(patterns) == len(stated) else (),
    )
    return Learned(reading, written.probability, written.refusal)
