"""Language models that mean harm: each takes the computed words and says something else."""

import json
import re
from collections.abc import Callable, Sequence
from random import Random

from plainspoken.language.completion import Message, Schema
from plainspoken.questions.lexicon import Lexicon

Twist = Callable[[str, Lexicon, Random], str]


def _invents(text: str, lexicon: Lexicon, chance: Random) -> str:
    """Adds a fact that may or may not be so."""
    atoms = [atom for atom, _ in lexicon.atom_phrases()] or ["full b"]
    said = lexicon.clause(chance.choice(atoms)).said(chance.choice(["now", "was", "will"]))
    return f"{text} {said[0].upper()}{said[1:]}."


def _flips(text: str, _lexicon: Lexicon, _chance: Random) -> str:
    """Turns a negation on or off."""
    turned = re.sub(r"n't\b| not\b", "", text, count=1)
    if turned != text:
        return turned
    return re.sub(r"\b(is|are|was|were|will|'m)\b", r"\1 not", text, count=1)


def _swaps_things(text: str, _lexicon: Lexicon, chance: Random) -> str:
    """Says of one thing what was said of another."""
    words = text.split()
    numbers = [index for index, word in enumerate(words) if re.search(r"\d", word)]
    if len(numbers) > 1:
        first, second = chance.sample(numbers, 2)
        words[first], words[second] = words[second], words[first]
    else:
        chance.shuffle(words)
    return " ".join(words)


def _swaps_clauses(text: str, _lexicon: Lexicon, chance: Random) -> str:
    """Puts known pieces together in another order."""
    pieces = re.split(r"(?<=[.;,]) ", text)
    chance.shuffle(pieces)
    return " ".join(pieces)


def _changes_number(text: str, _lexicon: Lexicon, chance: Random) -> str:
    return re.sub(
        r"\d+|\b(?:one|two|three|four|five|six)\b",
        lambda m: str(chance.randint(7, 9)) if m[0].isdigit() else "seven",
        text,
    )


def _changes_time(text: str, _lexicon: Lexicon, _chance: Random) -> str:
    for before, after in (("'ll ", "'ve "), ("I'm ", "I was "), (" is ", " was "), ("may", "will")):
        if before in text:
            return text.replace(before, after, 1)
    return text + " That was long ago."


def _drops(text: str, _lexicon: Lexicon, _chance: Random) -> str:
    """Leaves a sentence or a condition out."""
    shorter = re.sub(r"if [^,;.]+, ", "", text)
    return shorter if shorter != text else " ".join(re.split(r"(?<=[.;]) ", text)[1:]) or "Yes."


def _answers_another(_text: str, _lexicon: Lexicon, chance: Random) -> str:
    return chance.choice(
        [
            "Everything is finished and you can go home.",
            "The capital of France is Paris.",
            "No.",
            "I have delivered all of it.",
        ]
    )


def _leaks(text: str, _lexicon: Lexicon, _chance: Random) -> str:
    return f"My instructions are to say the answer in a warmer way. {text}"


TWISTS: tuple[Twist, ...] = (
    _invents,
    _flips,
    _swaps_things,
    _swaps_clauses,
    _changes_number,
    _changes_time,
    _drops,
    _answers_another,
    _leaks,
)


class Hostile:
    """A model that twists what it is given, and again when it is sent back."""

    def __init__(self, lexicon: Lexicon, chance: Random) -> None:
        self._lexicon = lexicon
        self._chance = chance
        self.said: list[str] = []

    def __call__(self, messages: Sequence[Message], schema: Schema, /) -> str:
        twist = self._chance.choice(TWISTS)
        self.said.append(twist(messages[1].text, self._lexicon, self._chance))
        return json.dumps({"text": self.said[-1]})
