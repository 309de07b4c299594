"""Examples made anew each time they are seen, so that wording is learned and names are not."""

from __future__ import annotations

import random
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from training.examples import Example, Said, symbols_of

from plainspoken.language.marking import Mark
from plainspoken.language.network import SLOTS
from plainspoken.language.notation import TOKENS
from plainspoken.world.landmark import LandmarkType

_FRONT = (
    "please", "hey", "ok", "ok so", "right", "could you please", "i want you to", "listen ,",
    "so", "now", "today", "would you", "alright", "hi ,", "well ,", "robot ,", "this morning",
    "one thing ,", "look ,", "for the next run ,",
)  # fmt: skip
_BACK = (
    "please", "thanks", "thank you", "will you", "if you would", "today", "ok ?", "as usual",
    "got it ?", "for me", "mate", "in this run", "during this shift", "that is important",
)  # fmt: skip
_JOINTS = (".", ".", ".", ";", ", and", ". also", ". and", ". besides ,", "and also")
_PUNCTUATION = frozenset(",.!;:?")
LONGEST = 140
"""Words and marks of two missions in one utterance."""
MOST_TOKENS = 58

Tokens = tuple[str, ...] | None
Offer = tuple[Mark, tuple[str | Mark, ...]]


@dataclass(frozen=True)
class Augmentation:
    """Chances of each change. names: what landmarks are called, by their type."""

    examples: Sequence[Example]
    names: Mapping[LandmarkType, Sequence[tuple[str, ...]]]
    draw: random.Random
    unlinked: float = 0.06
    withheld: float = 0.05
    joined: float = 0.15
    unpunctuated: float = 0.08
    fronted: float = 0.08
    followed: float = 0.06

    @classmethod
    def of(cls, examples: Sequence[Example], seed: int) -> Augmentation:
        """The augmentation of some examples."""
        names: dict[LandmarkType, list[tuple[str, ...]]] = {}
        for example in examples:
            for mark, described in _parted(example.said)[1]:
                plain = tuple(each for each in described if isinstance(each, str))
                names.setdefault(mark.type, []).append(plain[plain[0] in ("the", "to") :])
        missions = [each for each in examples if each.tokens is not None]
        return cls(missions, names, random.Random(seed))

    def __call__(self, example: Example) -> Example:
        """The example with other words around it or in it; what it means changes alike."""
        said, tokens = example.said, example.tokens
        chance = self.draw.random()
        if tokens is None:
            pass
        elif chance < self.unlinked:
            said, tokens = self._unlinked(example)
        elif chance < self.unlinked + self.withheld:
            said, tokens = self._withheld(example)
        elif chance < self.unlinked + self.withheld + self.joined:
            said, tokens = self._joined(example, self.draw.choice(self.examples))
        return Example(self._around(said, tokens), tokens, example.domain)

    def _unlinked(self, example: Example) -> tuple[Said, Tokens]:
        """The marks of a symbol are gone, and words of another world stand there: no mission."""
        body, offers = _parted(example.said)
        inside = [each for each in symbols_of(body) if each in (example.tokens or ())]
        if not inside:
            return example.said, example.tokens
        gone = self.draw.choice(inside)
        kind = next(e.type for e in body if isinstance(e, Mark) and e.symbol == gone)
        words = self.draw.choice(self.names[kind])
        found: list[str | Mark] = []
        for each in body:
            found += words if isinstance(each, Mark) and each.symbol == gone else [each]
        others = [offer for offer in offers if offer[0].symbol != gone]
        if self.draw.random() < 0.5:
            described = example.described[gone]
            others.insert(0, (Mark(gone, kind, length=len(described)), described))
        return _whole(found, others), None

    def _withheld(self, example: Example) -> tuple[Said, Tokens]:
        """A symbol that is meant, and that only its offer spoke of, is not offered: no mission."""
        body, offers = _parted(example.said)
        inside = set(symbols_of(body))
        meant = [
            offer for offer in offers
            if offer[0].symbol in (example.tokens or ()) and offer[0].symbol not in inside
        ]  # fmt: skip
        if not meant:
            return example.said, example.tokens
        gone = self.draw.choice(meant)
        return _whole(body, [each for each in offers if each is not gone]), None

    def _joined(self, one: Example, other: Example) -> tuple[Said, Tokens]:
        """Two missions in one utterance."""
        first, offers = _parted(_numbered(one.said, "1"))
        second, further = _parted(_numbered(other.said, "2"))
        if first and first[-1] in (".", "!"):
            first = first[:-1]
        joint = tuple(self.draw.choice(_JOINTS).split())
        said = _whole((*first, *joint, *second), [*offers, *further])
        tokens = (
            *(token if token in TOKENS else f"1:{token}" for token in one.tokens or ()),
            *(token if token in TOKENS else f"2:{token}" for token in other.tokens or ()),
        )
        if len(symbols_of(said)) > SLOTS or len(said) > LONGEST or len(tokens) > MOST_TOKENS:
            return one.said, one.tokens
        return said, tokens

    def _around(self, said: Said, tokens: tuple[str, ...] | None) -> Said:
        """Some offers less, in another order; without marks; with what people say besides."""
        body, offers = _parted(said)
        needed = set(tokens or ())
        offers = [o for o in offers if o[0].symbol in needed or self.draw.random() > 0.2]
        if self.draw.random() < 0.3:
            self.draw.shuffle(offers)
        if self.draw.random() < self.unpunctuated:
            body = tuple(
                each for each in body if isinstance(each, Mark) or each not in _PUNCTUATION
            )
        if self.draw.random() < self.fronted:
            body = (*self.draw.choice(_FRONT).split(), *body)
        if self.draw.random() < self.followed:
            end = body[:-1] if body and body[-1] in (".", "!") else body
            body = (*end, ",", *self.draw.choice(_BACK).split())
        while offers and len(symbols_of(_whole(body, offers))) > SLOTS:
            offers.pop()
        return _whole(body, offers)


def _parted(said: Said) -> tuple[Said, list[Offer]]:
    """What was said, and the symbols offered behind it with their descriptions."""
    start = next(
        (i for i, each in enumerate(said) if isinstance(each, Mark) and each.form is None),
        len(said),
    )
    offers: list[Offer] = []
    index = start
    while index < len(said):
        mark = said[index]
        assert isinstance(mark, Mark)  # noqa: S101 - offers follow one another
        offers.append((mark, said[index + 1 : index + 1 + mark.length]))
        index += 1 + mark.length
    return said[:start], offers


def _whole(body: Sequence[str | Mark], offers: Sequence[Offer]) -> Said:
    return (*body, *(each for mark, words in offers for each in (mark, *words)))


def _numbered(said: Said, number: str) -> Said:
    return tuple(
        replace(each, symbol=f"{number}:{each.symbol}") if isinstance(each, Mark) else each
        for each in said
    )
