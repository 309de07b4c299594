"""A conversation about one mission: a sentence, the answer to a question, and what is said further.

Each turn is a value that holds the next state of the conversation. What is said further is turned
into patterns and joined to those of the mission; a sentence is never edited.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

from plainspoken.language.answer import Declined, chosen
from plainspoken.language.contradiction import clash
from plainspoken.language.counting import Count
from plainspoken.language.extracted import (
    Extraction,
    Reading,
    Status,
    idleness,
    names_of,
    over_placeholders,
    patterns_of,
)
from plainspoken.language.extraction import extract
from plainspoken.language.follow_up import FollowUp, Wish, follow_ups
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import Kind
from plainspoken.language.refinement import (
    Patterns,
    added,
    demanded,
    put_first,
    put_last,
    repeated,
    replaced,
    without,
)
from plainspoken.language.sentence import Sentence, reading_of
from plainspoken.language.word import words
from plainspoken.logic.formula import Atom, atoms
from plainspoken.logic.pattern import Visit
from plainspoken.world.symbol import SymbolId

Translate = Callable[[str, Vocabulary], Extraction]

_AROUND_A_NAME = frozenset(
    (Kind.REFERENCE, Kind.FILLER, Kind.SUBJECT, Kind.COMMA, Kind.AND, Kind.STOP, Kind.GO,
     Kind.ENSURE, Kind.MUST, Kind.BOTH)
)  # fmt: skip
"""What may stand in a piece that only names something: "please go to site 2"."""


@dataclass(frozen=True, slots=True)
class Turn:
    """What a sentence did.

    dialogue:   to go on with
    extraction: the mission as it is now, the question, or the refusal
    """

    dialogue: Dialogue
    extraction: Extraction

    @property
    def said(self) -> str:
        """What to tell the person."""
        match self.extraction.status:
            case Status.OK if self.extraction.reading is not None:
                return self.extraction.reading.english
            case Status.CLARIFY:
                return self.extraction.question or "Which do you mean?"
            case _:
                return self.extraction.reason or "That is no mission."


@dataclass(frozen=True, slots=True)
class Dialogue:
    """A conversation so far.

    mission: what has been agreed on
    asked:   the question that is open, and `about` what it will do to the mission
    """

    vocabulary: Vocabulary
    mission: Extraction | None = None
    asked: Extraction | None = None
    about: FollowUp | None = None
    translate: Translate = extract

    def say(self, text: str) -> Turn:
        """Take a sentence: an answer where a question is open, else a mission or more of it."""
        if self.asked is not None:
            turn = self._answered(self.asked, text)
            if turn is not None:
                return turn
        if follow_ups(text)[0].wish is Wish.RESTART:
            start = Dialogue(self.vocabulary, translate=self.translate)
            reason = "All right, from the beginning. What should be done?"
            return Turn(start, Extraction(text, Status.REJECT, reason=reason))
        if self.mission is None:
            return self._heard(self.translate(text, self.vocabulary), None)
        return self._further(self.mission, text)

    def _answered(self, asked: Extraction, text: str) -> Turn | None:
        """The turn after an answer; None where something else was said."""
        choice = chosen(text, asked.alternatives)
        if isinstance(choice, Reading):
            return self._heard(asked.settled_on(choice), self.about)
        closed = replace(self, asked=None, about=None)
        if isinstance(choice, Declined):
            reason = "Then say it in other words, please."
            return Turn(closed, Extraction(text, Status.REJECT, reason=reason))
        instead = closed.say(text)
        if instead.extraction.status is not Status.REJECT:
            return instead
        again = replace(
            asked, reason=f"I cannot tell which you mean. {asked.question}", status=Status.REJECT
        )
        return Turn(self, again)

    def _heard(self, found: Extraction, about: FollowUp | None) -> Turn:
        """Go on with what was understood of a sentence, or of the name in a follow-up."""
        match found.status:
            case Status.CLARIFY:
                return Turn(replace(self, asked=found, about=about), found)
            case Status.REJECT:
                return Turn(self, found)
            case Status.OK:
                if self.mission is None or about is None or about.wish is Wish.ANEW:
                    agreed = replace(self, mission=found, asked=None, about=None)
                    return Turn(agreed, found)
                return self._refined(self.mission, found, about)

    def _further(self, mission: Extraction, text: str) -> Turn:
        for wished in follow_ups(text):
            turn = self._tried(mission, text, wished)
            if turn is not None:
                return turn
        raise AssertionError("the last follow-up is a whole sentence")

    def _tried(self, mission: Extraction, text: str, wished: FollowUp) -> Turn | None:
        """The turn where a follow-up is one; None where its frame was read into it."""
        if wished.wish is Wish.REPEAT:
            count = _count(wished.what, self.vocabulary)
            if count is None:
                named = replace(wished, wish=Wish.REPLACE)
                return self._tried(mission, text, named)
            return self._repeated(mission, text, count)
        if not wished.bare and not wished.what:
            return self._refused(text, "Then say what should be different, please.")
        if not wished.bare or wished.wish is Wish.ANEW:
            return self._heard(self.translate(wished.what, self.vocabulary), wished)
        named_alone = _named(wished.what, self.vocabulary)
        if named_alone is None or (wished.old and _named(wished.old, self.vocabulary) is None):
            return None
        found = self.translate(wished.what, self.vocabulary)
        if found.status is Status.CLARIFY and len(found.alternatives) > 1:
            return self._heard(found, wished)  # which one is meant; a name need be no mission
        return self._with_names(mission, text, named_alone, wished)

    def _refined(self, mission: Extraction, found: Extraction, about: FollowUp) -> Turn:
        """The mission with what a further sentence asks for."""
        assert found.reading is not None  # noqa: S101 - what is accepted has one
        if about.bare:
            symbols = demanded(patterns_of(found.reading)) or tuple(
                sorted(atoms(found.reading.formula))
            )
            return self._with_names(mission, found.utterance, symbols, about)
        return self._agreed(mission, found, added(_patterns(mission), patterns_of(found.reading)))

    def _with_names(
        self, mission: Extraction, text: str, symbols: tuple[SymbolId, ...], about: FollowUp
    ) -> Turn:
        patterns = _patterns(mission)
        for symbol in symbols if about.wish is not Wish.FIRST else reversed(symbols):
            match about.wish:
                case Wish.FIRST:
                    patterns = put_first(patterns, Atom(symbol))
                case Wish.LAST:
                    patterns = put_last(patterns, Atom(symbol))
                case Wish.SKIP:
                    left = without(patterns, symbol)
                    if left == patterns:
                        return self._refused(text, f"{self._name(symbol)} is not asked for.")
                    patterns = left
                case Wish.REPLACE:
                    old = self._old(mission, symbol, about)
                    if old is None:
                        return self._refused(
                            text, f"{self._name(symbol)} has nothing to take the place of."
                        )
                    patterns = replaced(patterns, old, symbol)
                case _:
                    patterns = added(patterns, (Visit((Atom(symbol),)),))
        found = Extraction(
            text,
            Status.OK,
            referring_expressions=Sentence.of(text, self.vocabulary).expressions,
            confidence=mission.confidence,
        )
        return self._agreed(mission, found, patterns)

    def _old(self, mission: Extraction, new: SymbolId, about: FollowUp) -> SymbolId | None:
        """What a new symbol takes the place of: the one named, or the last of its kind."""
        assert mission.reading is not None  # noqa: S101 - a mission has one
        spoken = atoms(mission.reading.formula)
        if about.old:
            named = _named(about.old, self.vocabulary) or ()
            return next((each for each in named if each in spoken), None)
        known = self.vocabulary.landmarks
        alike = [
            each.symbol
            for each in mission.referring_expressions
            if each.symbol in spoken
            and each.symbol != new
            and known[each.symbol].type is known[new].type
        ]
        asked_for = demanded(_patterns(mission))
        last = [each for each in alike if each in asked_for] or alike
        return last[-1] if last else None

    def _repeated(self, mission: Extraction, text: str, count: Count) -> Turn:
        asked_for = demanded(_patterns(mission))
        if not asked_for:
            return self._refused(text, "There is nothing that could be done so many times.")
        found = Extraction(text, Status.OK, confidence=mission.confidence)
        return self._agreed(mission, found, repeated(_patterns(mission), asked_for[-1], count))

    def _agreed(self, mission: Extraction, found: Extraction, patterns: Patterns) -> Turn:
        """The mission made of other patterns, where they can be met."""
        assert mission.reading is not None  # noqa: S101 - a mission has one
        if not patterns:
            return self._refused(found.utterance, "Nothing would be left of the mission.")
        reason = clash(patterns, self.vocabulary.landmarks)
        if reason is not None:
            return self._refused(found.utterance, f"{reason} The mission stays as it was.")
        score = min(mission.reading.score, found.reading.score if found.reading else 1.0)
        reading = reading_of(patterns, self.vocabulary, score)
        shift = len(mission.utterance) + 1
        whole = Extraction(
            f"{mission.utterance} {found.utterance}",
            Status.OK,
            reading,
            names_of(patterns),
            over_placeholders(reading.literal),
            (
                *mission.referring_expressions,
                *(
                    replace(each, start=each.start + shift, end=each.end + shift)
                    for each in found.referring_expressions
                ),
            ),
            note=idleness(reading.formula),
            confidence=min(mission.confidence or 1.0, found.confidence or 1.0),
        )
        return Turn(replace(self, mission=whole, asked=None, about=None), whole)

    def _refused(self, text: str, reason: str) -> Turn:
        return Turn(self, Extraction(text, Status.REJECT, reason=reason))

    def _name(self, symbol: SymbolId) -> str:
        text = self.vocabulary.landmarks[symbol].description
        return f"{text[0].upper()}{text[1:]}"


def _patterns(mission: Extraction) -> Patterns:
    assert mission.reading is not None  # noqa: S101 - a mission has one
    return patterns_of(mission.reading)


def _named(text: str, vocabulary: Vocabulary) -> tuple[SymbolId, ...] | None:
    """The symbols that a piece names; None where it does anything else, or more."""
    if not words(text):
        return None
    sentence = Sentence.of(text, vocabulary)
    if not sentence.references or any(
        item.kind not in _AROUND_A_NAME or (item.reference and item.reference.negated)
        for item in sentence.items
    ):
        return None
    return tuple(dict.fromkeys(each.symbol for each in sentence.references))


def _count(text: str, vocabulary: Vocabulary) -> Count | None:
    """The number of times that a piece says: "twice"."""
    if not words(text):
        return None
    sentence = Sentence.of(text, vocabulary)
    counts = [item.count for item in sentence.items if item.count is not None]
    others = [item for item in sentence.items if item.kind not in (Kind.COUNT, Kind.FILLER)]
    return counts[0] if len(counts) == 1 and not others else None
