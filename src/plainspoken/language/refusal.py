"""Why an utterance is no mission, in words that help to say it better."""

from __future__ import annotations

import re
from collections.abc import Sequence

from plainspoken.language.clause import Act, Clause
from plainspoken.language.extracted import listed
from plainspoken.language.lexicon import Kind
from plainspoken.language.sentence import Meaning, Sentence
from plainspoken.language.word import is_known, words

_JOINING = re.compile(r"\b((?:and|or|but)(?:\s+then)?)\W*$", re.IGNORECASE)

LONGEST = 2000
"""Characters of an utterance; nobody says more in one breath."""
_QUESTION_WORDS = frozenset(("what", "why", "who", "whose", "how", "which"))
_QUESTION_VERBS = frozenset(
    ("where", "when", "is", "are", "was", "were", "does", "did", "do", "has", "have")
)
_MOST_NAMED = 5
"""Pieces not understood that are named; the others are counted."""


def unspeakable(utterance: str) -> str | None:
    """Why an utterance is not even looked at."""
    if not utterance.strip():
        return "Nothing was said. Say what the robot should get done."
    if len(utterance) > LONGEST:
        return (
            f"That is {len(utterance)} characters long, and I can take {LONGEST}. "
            "Say it in shorter pieces."
        )
    return None


def not_understood(sentence: Sentence) -> str | None:
    """Name the words that matter and stand for nothing in the domain."""
    spans = unknown_spans(sentence)
    if not spans and sentence.references:
        return None
    if not spans and is_question(sentence.utterance):
        return "That is a question. I take missions: say what the robot should get done."
    if not spans:
        return (
            "I found nothing in that sentence that the robot can visit, watch or do. "
            + _suggestions(sentence, sentence.utterance)
        )
    partial = {each.last: each for each in sentence.references if each.score < 1.0}
    spans = [(partial[first].first if first in partial else first, last) for first, last in spans]
    texts = [sentence.text(first, last) for first, last in spans]
    places = [
        f'"{text}" (characters {sentence.words[first].start} to {sentence.words[last - 1].end})'
        for text, (first, last) in zip(texts, spans, strict=True)
    ]
    if len(places) > _MOST_NAMED:
        more = len(places) - _MOST_NAMED
        places = [*places[:_MOST_NAMED], f"{more} other piece{'s' if more > 1 else ''}"]
    start = f"I do not understand {listed(places, 'and')}. "
    if not sentence.references:
        start = f"I found nothing there that this robot can visit, watch or do: {start}"
    if is_foreign(sentence.utterance):
        return f"{start}I understand English only. {_suggestions(sentence, texts[0])}".strip()
    return start + _suggestions(sentence, texts[0])


def unknown_spans(sentence: Sentence) -> list[tuple[int, int]]:
    """The runs of words that neither the lexicon nor the domain knows."""
    spans: list[tuple[int, int]] = []
    for item in sentence.items:
        if item.kind is Kind.UNKNOWN:
            if spans and spans[-1][1] == item.first:
                spans[-1] = (spans[-1][0], item.last)
            else:
                spans.append((item.first, item.last))
    return spans


def is_foreign(utterance: str) -> bool:
    """Whether most words of an utterance are not of English."""
    said = [each.text for each in words(utterance) if each.text.isalpha()]
    strange = sum(1 for text in said if not (text.isascii() and is_known(text)))
    return bool(said) and 2 * strange > len(said)


def is_question(utterance: str) -> bool:
    """Whether an utterance asks something, and does not ask for something to be done."""
    first = next(iter(words(utterance)), None)
    return first is not None and (
        first.text in _QUESTION_WORDS
        or (utterance.rstrip().endswith("?") and first.text in _QUESTION_VERBS)
    )


def idle(meaning: Meaning, utterance: str) -> str | None:
    """Why a sentence that was understood asks for nothing; None where it asks for something."""
    if not meaning.patterns and is_question(utterance):
        return "That is a question. I take missions: say what the robot should get done."
    if meaning.remarks:
        return (
            'That tells me how things are. Say what to do about it, or begin with "make sure that".'
        )
    if meaning.patterns:
        return None
    if meaning.permissions:
        return "That allows something, but asks for nothing."
    return None


def aimless(meaning: Meaning) -> str | None:
    """Why a sentence that names things is no mission: nobody can tell what to do about them."""
    if meaning.patterns:
        return None
    return (
        "I found what you speak of, but not what to do about it. "
        "Say for example to visit, avoid, or wait."
    )


def broken_off(utterance: str) -> str | None:
    """Why an utterance is not whole: it stops at a word that joins something to it."""
    last = _JOINING.search(utterance)
    if last is None:
        return None
    return f'I do not hear what comes after "{last[1]}". Say the sentence to its end.'


def unfinished(parsed: Sequence[Clause]) -> str | None:
    """Why a sentence is not whole: a clause of it begins something and names nothing."""
    for place, each in enumerate(parsed):
        if _is_open(each, parsed[max(place - 1, 0) : place + 2]):
            word = str(each.connector or "not").replace("_", " ")
            return (
                f'I do not see what you mean after "{word}". Name the place, the condition '
                "or the action."
            )
    return None


def _suggestions(sentence: Sentence, text: str) -> str:
    nearest = sentence.vocabulary.nearest(text)
    named = [f'"{landmark.description}"' for landmark in nearest]
    return f"The nearest that I know: {listed(named, 'and')}." if named else ""


def _is_open(clause: Clause, near: Sequence[Clause]) -> bool:
    """Whether a clause begins something and names nothing: "before leaving", "but never both"."""
    if clause.operands:
        return False
    if clause.connector is not None:
        return True
    attached = any(each.connector is not None and each.operands for each in near)
    return clause.act is Act.AVOID and not clause.flags and not attached
