"""An utterance as it was understood: its words, what they speak of, and its clauses."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

from plainspoken.language.clause import Clause, Operand, Statement, statements
from plainspoken.language.colour import without_colour
from plainspoken.language.ellipsis import resolved
from plainspoken.language.extracted import (
    Reading,
    ReferringExpression,
    executable_of,
    grounded,
    literal_of,
    placeholder,
)
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.item import Item, items
from plainspoken.language.lifting import lifted
from plainspoken.language.own_name import addressed
from plainspoken.language.reading import clauses
from plainspoken.language.reference import Reference
from plainspoken.language.word import Word, words
from plainspoken.logic.english import say
from plainspoken.logic.formula import Atom
from plainspoken.logic.pattern import Pattern
from plainspoken.world.symbol import SymbolId


@dataclass(frozen=True)
class Meaning:
    """What clauses ask for.

    lifted:      the patterns over placeholders
    patterns:    the same over symbols
    score:       of the least sure reference
    permissions: clauses that only allow
    remarks:     clauses that only tell what is the case
    """

    lifted: tuple[Pattern, ...]
    patterns: tuple[Pattern, ...]
    score: float
    permissions: int
    remarks: int


@dataclass(frozen=True)
class Sentence:
    """An utterance and what was made of it on the way to a formula."""

    utterance: str
    vocabulary: Vocabulary
    words: tuple[Word, ...]
    references: tuple[Reference, ...]
    items: tuple[Item, ...]
    clauses: tuple[Clause, ...] = ()

    @classmethod
    def of(cls, utterance: str, vocabulary: Vocabulary) -> Sentence:
        """Find what an utterance speaks of; the clauses come with `parsed`."""
        said, found = resolved(addressed(words(utterance), vocabulary.own_name), vocabulary)
        shaped = without_colour(items(said, found), said)
        meant = {item.first for item in shaped if item.reference is not None}
        # "never enter one room before the one listed before it" asks for no room by name
        kept = tuple(each for each in found if not each.rivals or each.first in meant)
        return cls(utterance, vocabulary, tuple(said), kept, tuple(shaped))

    def parsed(self) -> Sentence:
        """The sentence with its clauses."""
        return replace(self, clauses=clauses(self.items))

    def text(self, first: int, last: int) -> str:
        """What was said from a word up to, and without, another."""
        return self.utterance[self.words[first].start : self.words[last - 1].end]

    @property
    def expressions(self) -> tuple[ReferringExpression, ...]:
        """What the references say of the utterance."""
        return tuple(
            ReferringExpression(
                self.text(each.first, each.last),
                self.words[each.first].start,
                self.words[each.last - 1].end,
                each.symbol,
                each.score,
            )
            for each in self.references
            if each.errand is None
        ) + tuple(
            ReferringExpression(
                self.utterance[each.start : each.end], each.start, each.end, each.symbol, 1.0
            )
            for reference in self.references
            if reference.errand is not None
            for each in reference.errand.named
        )

    def meaning(
        self,
        of: Sequence[Statement] | None = None,
        chosen: Mapping[SymbolId, SymbolId] | None = None,
    ) -> Meaning:
        """What the sentence asks for; of some of it, or with other symbols, if wanted."""
        parts = statements(self.clauses) if of is None else tuple(of)
        names: dict[SymbolId, str] = {}

        def named(operand: Operand) -> Atom:
            symbol = operand.reference.symbol
            return Atom(names.setdefault(symbol, placeholder(len(names))))

        def persists(operand: Operand) -> bool:
            return operand.negated or self.vocabulary.persists(operand.reference.symbol)

        result = lifted(parts, named, persists)
        instead = chosen or {}
        symbols = {name: instead.get(symbol, symbol) for symbol, name in names.items()}
        scores = [o.reference.score for clause in self.clauses for o in clause.operands]
        return Meaning(
            result.patterns,
            grounded(result.patterns, symbols),
            round(min(scores, default=1.0), 3),
            result.permissions,
            result.remarks,
        )


def reading_of(
    patterns: tuple[Pattern, ...],
    vocabulary: Vocabulary,
    score: float,
    answer: str = "",
    english: str = "",
) -> Reading:
    """The reading that patterns over symbols make together; its English is the formula's."""
    executable = executable_of(patterns)
    english = english or say(executable, vocabulary.landmarks)
    return Reading(executable, literal_of(patterns), english, score, answer, patterns)
