"""Text about states becomes ground fluents with the time they are said of: words back to claims.

    fluents_in("I'm at line 1, and the box was full.", lexicon)

The counterpart of the paper's FluentExtractor, without a model: a text is cut into clauses, each
clause into a subject, a verb and what is said of it, and these are looked up among the words for
the facts of the problem. What cannot be read is not guessed.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from enum import StrEnum

from plainspoken.questions.concordance import ARTICLE, Concordance, concordance_of
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import lemma
from plainspoken.questions.referent import MOTION
from plainspoken.questions.spelling import NUMBERS, normal
from plainspoken.world.domain import GroundAtom
from plainspoken.world.event import Instant


class Time(StrEnum):
    """The part of the trace that a text speaks of."""

    NOW = "now"
    WAS = "was"
    WILL = "will"
    MAY = "may"
    """Not said to be so, only to be possible."""
    START = "start"
    END = "end"
    NEVER = "never"
    """Not so at any instant up to now."""


@dataclass(frozen=True, slots=True, order=True)
class Fluent:
    """A fact that a text states.

    holds:  whether it is said to be so
    offset: actions from now, negative for the past; None where the text gives none
    """

    atom: GroundAtom
    holds: bool = True
    time: Time = Time.NOW
    offset: int | None = None

    def instants(self, now: Instant, last: Instant) -> range:
        """The instants of a trace of which it is said; of a span, that it is so at one of them."""
        if self.offset is not None:
            return range(now + self.offset, now + self.offset + 1)
        match self.time:
            case Time.NOW:
                return range(now, now + 1)
            case Time.WAS:
                return range(now)
            case Time.NEVER:
                return range(now + 1)
            case Time.START:
                return range(1)
            case Time.END:
                return range(last, last + 1)
            case Time.WILL | Time.MAY:
                return range(now + 1, last + 1)


@dataclass(frozen=True, slots=True)
class Reading:
    """What a text states, and the clauses of it that state nothing that could be read."""

    fluents: tuple[Fluent, ...]
    unread: tuple[str, ...]


def fluents_in(text: str, lexicon: Lexicon) -> tuple[Fluent, ...]:
    """The fluents that a text states, in its order."""
    return read(text, lexicon).fluents


def read(text: str, lexicon: Lexicon) -> Reading:
    """Read a text, clause by clause."""
    clauses = tuple(clauses_in(text, lexicon))
    found = dict.fromkeys(fluent for each in clauses for fluent in each.fluents)
    return Reading(tuple(found), tuple(each.words for each in clauses if not each.fluents))


@dataclass(frozen=True, slots=True)
class ReadClause:
    """A clause, names of objects marked in it, and what it states, if that can be read."""

    words: str
    fluents: tuple[Fluent, ...]
    subject: str
    time: Time


def clauses_in(text: str, lexicon: Lexicon, *, marked: bool = False) -> Iterator[ReadClause]:
    """The clauses of a text, each with what it states.

    marked: whether the text is spelled out, and its objects are marked, already
    """
    known = concordance_of(lexicon)
    before = _Clause()
    for sentence in re.split(r"(?<=[\w)>])[.!?;:]+(?:\s+|$)", text.strip()):
        before = _Clause(before.subject)  # Which "it" may still mean.
        for words in _clauses(sentence if marked else known.mark(_spelled(sentence))):
            clause = _parsed(words, before, known)
            fluents = tuple(_fluents(clause, known))
            yield ReadClause(words, fluents, clause.subject, clause.time)
            before = clause if clause.subject else before


# -- clauses -----------------------------------------------------------------------------------

_JOINTS = re.compile(
    r" ?, (?:and |but |so |or |then )*|; | (?:and then|and|but|because|since|so that|so|while|when"
    r"|although|though|whereas|which|who|that|until|as long as|or) "
)
_AUXILIARY = {
    "is": Time.NOW, "are": Time.NOW, "am": Time.NOW, "has": Time.NOW, "have": Time.NOW,
    "do": Time.NOW, "does": Time.NOW, "was": Time.WAS, "were": Time.WAS, "had": Time.WAS,
    "did": Time.WAS, "will": Time.WILL, "shall": Time.WILL, "may": Time.MAY, "might": Time.MAY,
    "could": Time.MAY, "would": Time.MAY, "can": Time.MAY,
}  # fmt: skip
_COPULA = (
    {"be", "been", "being", "get", "got", "become", "became", "turned", "turn", "gets", "becomes"}
    | {"remain", "remains", "remained", "stay", "stays", "stayed", "look", "looks", "stand"}
    | {"stands", "seems", "proved", "went", "gone"}
)
_LIGHT = frozenset(
    {"now", "still", "already", "yet", "again", "also", "just", "currently", "once", "more", "only"}
    | {"any", "so", "too", "then", "finally", "here", "ago", "longer", "completely", "quite"}
    | {"standing", "located", "really", "actually", "probably", "soon", "later", "ever", "by", "me"}
)
_NOT = frozenset({"not", "no", "never", "neither", "none"})
_CAUSING = frozenset(
    {"put", "drop", "place", "load", "bring", "store", "lay", "set", "take", "add", "move", "give"}
    | {"carry", "hand"}
)
_ARRIVING = MOTION | {"roll", "get", "run"}


@dataclass(frozen=True, slots=True)
class _Clause:
    """A clause cut up; what it does not say itself is the clause's before it."""

    subject: str = ""
    verb: str = ""
    complement: str = ""
    time: Time = Time.NOW
    offset: int | None = None
    negative: bool = False
    perfect: bool = False


def _spelled(sentence: str) -> str:
    """A sentence with contractions spelled out, its commas kept."""
    pieces = [normal(piece) for piece in sentence.replace("’", "'").split(",")]
    return " , ".join(pieces).replace(" , ", ", ")


def _clauses(text: str) -> Iterator[str]:
    rest = re.sub(r"^(?:and|but|so|then|well|yes|no|of the two),? ", "", text.strip())
    rest = re.sub(r"^it (?:could|may|might) be that ", "maybe ", rest)
    for part in _JOINTS.split(rest):
        clause = re.sub(
            r"^(?:although|though|because|while|but|and) ", "", (part or "").strip(" ,")
        )
        if clause:
            yield clause


def _parsed(words: str, before: _Clause, known: Concordance) -> _Clause:
    text, time, offset = _dated(words)
    text = ARTICLE.sub("", text)
    if found := re.fullmatch(r"so (?:is|are|was|were) (<[^>]+>|i)", text):
        return replace(before, subject=found[1])
    tokens = text.split()
    start = next((i for i, token in enumerate(tokens) if _is_verb(token, i, tokens, known)), None)
    if start is None:
        return _continued(tokens, before, time, offset)
    subject = " ".join(token for token in tokens[:start] if token not in _LIGHT | _NOT)
    negative = bool(_NOT & set(tokens[:start]))
    subject = _subject(subject, before)
    own = time
    perfect = False
    index = start
    while index < len(tokens) and (tokens[index] in _AUXILIARY or tokens[index] in _LIGHT | _NOT):
        token = tokens[index]
        if token in _AUXILIARY:
            own = own or _AUXILIARY[token]
            perfect = perfect or token in ("has", "have", "had")
        negative = negative or token in _NOT
        if token == "never" and (own or Time.NOW) is not Time.WILL:
            own = Time.NEVER
        index += 1
    rest = tokens[index:]
    if rest[:2] in (["going", "to"], ["about", "to"]):
        own, rest = own if time else Time.WILL, rest[2:]
    verb, rest, past = _verb(tokens[start:index], rest, known)
    if past and own is None:
        own = Time.WAS
    if before.time is Time.MAY and words.startswith("if "):
        own = Time.MAY
    negative = negative or bool(_NOT & set(rest))
    complement = " ".join(each for each in rest if each not in _LIGHT | _NOT)
    if not complement and before.subject:
        # "Line 1 isn't": what is not said again is that of the clause before.
        verb, complement = before.verb, before.complement
    elif not subject or (start == 0 and re.fullmatch(r"<[^>]+>|i", complement)):
        return replace(before, subject=complement, negative=negative)  # "So is the cart."
    return _Clause(subject, verb, complement, own or Time.NOW, offset, negative, perfect)


def _is_verb(token: str, index: int, tokens: Sequence[str], known: Concordance) -> bool:
    """Whether the predicate of a clause begins here."""
    if token in _AUXILIARY:
        return True
    if index == 0:
        return False
    behind = tokens[index - 1].startswith("<") or tokens[index - 1] in ("i", "it", "they", "he")
    moves = lemma(token) in _ARRIVING | _CAUSING or token in _COPULA
    return behind and (
        moves or token in known.verbs or lemma(token) in known.verbs or token.endswith("ed")
    )


def _subject(words: str, before: _Clause) -> str:
    words = re.sub(r"^(?:if|that|when|then|both|unfortunately|luckily|it be) ", "", words)
    if words in ("it", "they", "he", "she", "this", "that", ""):
        return before.subject
    return {"hand": "my hand", "robot": "i", "my hands": "my hand"}.get(words, words)


def _verb(
    auxiliaries: Sequence[str], rest: list[str], known: Concordance
) -> tuple[str, list[str], bool]:
    """The verb, what follows it, and whether its form alone says that it is past."""
    while rest and rest[0] in _LIGHT:
        rest = rest[1:]
    be = {"is", "are", "am", "was", "were"} & set(auxiliaries)
    if rest and rest[0] in _COPULA and lemma(rest[0]) != "go":
        past = not auxiliaries and rest[0] in ("became", "got", "turned", "remained", "stayed")
        return "be", rest[2 if rest[1:2] == ["out"] and "turn" in rest[0] else 1 :], past
    if be or not rest:
        return "be", rest, False
    first = rest[0]
    verb = known.verbs.get(first) or lemma(first)
    past = not auxiliaries and verb != first and not first.endswith("s")
    return verb, rest[1:], past


def _continued(
    tokens: Sequence[str], before: _Clause, time: Time | None, offset: int | None
) -> _Clause:
    """A clause that says only what is different: `not damaged`, `line 1 not`."""
    words = [token for token in tokens if token not in _LIGHT | _NOT]
    negative = bool(_NOT & set(tokens)) or (before.negative and not before.complement)
    return replace(
        before,
        complement=" ".join(words),
        negative=negative,
        time=time or before.time,
        offset=offset if offset is not None else before.offset,
    )


# -- times -------------------------------------------------------------------------------------

_COUNT = "|".join(["a", "an", *NUMBERS, r"\d+"])
_AGO = re.compile(rf"\b({_COUNT}) (?:more )?(?:actions?|steps?) ago\b,?")
_IN = re.compile(rf"\b(?:in|after) ({_COUNT}) (?:more )?(?:actions?|steps?)\b(?: from now)?,?")
_DATES = (
    (re.compile(r"\b(?:after|with) (?:my |the )?next (?:action|step)\b,?"), Time.WILL, 1),
    (re.compile(r"^(?:at (?:the )?(?:start|beginning|first)|in (?:the )?beginning|initially"
                r"|originally)\b,?"), Time.START, None),
    (re.compile(r"(?:^| )(?:in the end|finally|at the end|by the end|eventually"
                r"|when i am done)\b,?"), Time.END, None),
)  # fmt: skip


def _dated(words: str) -> tuple[str, Time | None, int | None]:
    """A clause without the words for its time, and that time."""
    for pattern, sign in ((_AGO, -1), (_IN, 1)):
        if found := pattern.search(words):
            time = Time.WAS if sign < 0 else Time.WILL
            return pattern.sub("", words).strip(), time, sign * _number(found[1])
    for pattern, time, offset in _DATES:
        if pattern.search(words):
            return pattern.sub(" ", words).strip(), time, offset
    if found := re.match(r"(?:it )?(?:could|may|might) be that |perhaps |maybe ", words):
        return words[found.end() :], Time.MAY, None
    if words.startswith("if "):
        return words[3:], Time.MAY, None
    return words, None, None


def _number(word: str) -> int:
    if word.isdigit():
        return int(word)
    return 1 if word in ("a", "an") else NUMBERS.index(word)


# -- fluents -----------------------------------------------------------------------------------


def _fluents(clause: _Clause, known: Concordance) -> Iterator[Fluent]:
    for subject in _each(clause.subject):
        for complement in _each(clause.complement):
            for atom, so in _facts(replace(clause, subject=subject, complement=complement), known):
                time = clause.time
                holds = so != clause.negative
                if time is Time.NEVER:
                    holds = not so
                yield Fluent(atom, holds, time, clause.offset)


def _each(words: str) -> Iterator[str]:
    """The words once for every object of a list in them."""
    found = re.search(r"<([^>]*\+[^>]*)>", words)
    if found is None:
        yield words
        return
    for name in found[1].split("+"):
        yield from _each(words[: found.start()] + f"<{name}>" + words[found.end() :])


def _facts(clause: _Clause, known: Concordance) -> list[tuple[GroundAtom, bool]]:
    """What a clause says of one subject and one complement."""
    complement = re.sub(r" (?:by|since|for|with) .*$", "", clause.complement)
    for each in dict.fromkeys((clause.complement, complement)):
        if found := known.facts(clause.subject, clause.verb, each):
            return found
    objects = re.findall(r"<([^>]+)>", f"{clause.subject} {clause.complement}")
    places = re.findall(r"<[^>]+>", clause.complement)
    going = clause.complement.split()[:1] == ["going"]
    if places and (clause.verb in _ARRIVING or going):
        moved = known.place_of(clause.subject, places[-1])
        under_way = (
            clause.time is Time.NOW and not clause.perfect
        )  # Going there is not being there.
        return [(moved, True)] if moved and not under_way else []
    if clause.verb == "be" and clause.complement:
        doing = clause.complement.split()[0]
        return [
            (atom, True) for atom in known.done(lemma(doing), objects) if not doing.endswith("ing")
        ]
    acted = [(atom, True) for atom in known.done(clause.verb, objects)]
    if not acted and clause.verb in _CAUSING and len(places) > 1:
        moved = known.place_of(places[0], places[-1])
        return [(moved, True)] if moved else []
    return acted
