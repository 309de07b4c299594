"""What a person tells, clause by clause: facts, and deeds that made facts.

"I cleared line 2, and the box is full": here `I` is the person, and the robot is `you`. Facts are
read by `questions.fluents`, and by the words of the landmarks where that reads none; deeds by the
verbs of the domain's actions.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from functools import lru_cache
from itertools import product

from plainspoken.language.grounding import Vocabulary
from plainspoken.language.lexicon import Kind
from plainspoken.language.sentence import Sentence
from plainspoken.planning.exclusion import Literal
from plainspoken.questions.accomplishment import Deed
from plainspoken.questions.concordance import concordance_of
from plainspoken.questions.fluents import ReadClause, Time, clauses_in
from plainspoken.questions.identity import ById
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import lemma, participle, past
from plainspoken.questions.referent import MOTION, Referents, referents_of
from plainspoken.questions.spelling import normal
from plainspoken.world.domain import GroundAtom
from plainspoken.world.landmark import LandmarkType
from plainspoken.world.symbol import AtomSymbol, resolve


@dataclass(frozen=True, slots=True)
class Told:
    """One clause of a report.

    facts:   what it says, by its words alone
    deeds:   what it says was done, as the actions that may be meant
    made:    facts that the verb of a deed names: `washed` of to wash
    odd:     words that nothing was made of
    loose:   whether the landmarks' words alone say so, which orders are made of, too
    trouble: why it cannot be taken for a fact that is so now
    """

    words: str
    facts: tuple[Literal, ...] = ()
    deeds: tuple[tuple[Deed, ...], ...] = ()
    made: tuple[Literal, ...] = ()
    odd: tuple[str, ...] = ()
    loose: bool = False
    trouble: str | None = None


_PERSON = "somebody"
_SWAPS = (
    (r"\b(?:i|we|he|she) am\b", f"{_PERSON} is"),
    (r"\bmyself|ourselves|by hand\b", ""),
    (r"\b(?:i|we)\b", _PERSON),
    (r"\bmy\b", "their"),
    (r"\byou are\b", "i am"),
    (r"\byou were\b", "i was"),
    (r"\byou\b", "i"),
    (r"\byour\b", "my"),
    (r"\bsomeone\b|\ba colleague\b", _PERSON),
)
_OPENING = re.compile(
    r"^(?:(?:hey|hi|hello|ok|okay|well|so|oh|actually|fyi|careful|attention|note|please note|"
    r"just so you know|for your information|by the way|good news|bad news|look|listen|"
    r"robot|now|sorry|yes|no)\b(?: that\b)?[\s,:;!.–—-]*)+",
    re.IGNORECASE,
)
_RESULT = re.compile(
    r"\b(?:came|come|comes) (?:back|out)(?: as)?\b|\bturn(?:s|ed)? out(?: to be)?\b"
    r"|\bprove[ds]?(?: to be)?\b|\b(?:has |have )?(?:got|gotten|gone|went|stayed|remained|became)\b"
)
"""Verbs that say what has become of a thing: it is so now."""
_ASIDE = re.compile(r"\b(?:after all|any longer|for sure|as of now|once again|at last|of course)\b")
_UNSURE = re.compile(
    r"\b(?:maybe|perhaps|probably|possibly|might|may|could|would|i (?:think|guess|believe|suppose"
    r"|hope|doubt)|not sure|unsure|i wonder|if|unless|almost|nearly|likely|seems?|apparently)\b"
)
_AHEAD = re.compile(
    r"\b(?:will|shall|going to|about to|tomorrow|later|next week|want|wants|plan(?:s|ning)? to"
    r"|have to|has to|must|should|need to|needs to|try|trying)\b"
)
_LITTLE = frozenset(
    {"a", "an", "the", "already", "just", "now", "again", "too", "also", "all", "both", "each"}
    | {"every", "of", "in", "on", "onto", "into", "at", "to", "from", "by", "with", "for", "and"}
    | {"up", "down", "off", "out", "is", "are", "was", "were", "has", "have", "had", "been", "be"}
    | {"do", "did", "does", "not", "it", "them", "they", "that", "this", "there", "here", "then"}
    | {"myself", "my", "their", "your", "today", "morning", "afternoon", "evening", "yesterday"}
    | {"earlier", "ago", "minute", "minutes", "moment", "finally", "still", "yet", "more", "any"}
    | {"me", "one", "only", "so", "as", "well", "back", "quickly", "manually", "everything", "i"}
    | {_PERSON, "she", "he", "we", "you", "who", "which", "what", "after", "before", "away", "some"}
)


def told(text: str, lexicon: Lexicon) -> tuple[Told, ...]:
    """The clauses of a report."""
    rest = _OPENING.sub("", text.strip().replace("\u2019", "'"))
    known = concordance_of(lexicon)
    marked = re.sub(r"\bboth (?=<)", "", known.mark(_swapped(rest)))
    # "Its battery" is the battery; "its state" is the state of what was spoken of.
    readings = [
        tuple(_clauses(_without_pronouns(marked, its), lexicon)) for its in (r"\1 of <{}>", r"\1")
    ]
    return min(readings, key=lambda found: sum(map(_is_unread, found)))


def _is_unread(clause: Told) -> bool:
    return not (clause.facts or clause.deeds or clause.made)


def _clauses(marked: str, lexicon: Lexicon) -> Iterator[Told]:
    before = ""
    for clause in clauses_in(marked, lexicon, marked=True):
        one = _read(clause, lexicon)
        if _is_unread(one) and before and "<" not in clause.words:
            (again, *_) = clauses_in(f"<{before}> is {clause.words}", lexicon, marked=True)
            one = _read(again, lexicon)  # "I tested it: negative"
        before = next(iter(_marks(clause.words)), before)
        yield one


_PIECE = re.compile(r"([,.;:!?]+\s|\b(?:and|but|so|because)\b)")


def _without_pronouns(marked: str, its: str) -> str:
    """A text with the thing that was spoken of first, in the clause before, for `it` and `its`."""
    parts, before = [], ""
    for piece in _PIECE.split(marked):
        own, named = next(iter(_marks(piece)), ""), piece
        if before:
            named = re.sub(r"\bits (\w+)", its.format(before), named)
        if before and not own:
            named = re.sub(r"\b(?:it|they|them|this one)\b", f"<{before}>", named)
        before = own or before
        parts.append(named)
    return "".join(parts)


def unsure(text: str) -> bool:
    """Whether somebody only supposes what is said."""
    return _UNSURE.search(normal(text)) is not None


def ahead(text: str) -> bool:
    """Whether it is said what is to be, and not what is."""
    return _AHEAD.search(normal(text)) is not None


def _swapped(text: str) -> str:
    """A text with the person as somebody, the robot as I, and results as they are now."""
    parts = []
    for part in re.split(r"([,.;:!?]+\s*)", text):
        if not part or re.fullmatch(r"[,.;:!?]+\s*", part):
            parts.append(part)
            continue
        plain = normal(part)
        for pattern, instead in _SWAPS:
            plain = re.sub(pattern, instead, plain)
        parts.append(_RESULT.sub("becomes", _ASIDE.sub("", plain)))
    return "".join(parts)


def _marks(words: str) -> tuple[str, ...]:
    return tuple(re.findall(r"<([^>]+)>", words))


def _read(clause: ReadClause, lexicon: Lexicon) -> Told:
    """A clause as facts where it states some, else as a deed, else by the landmarks' words."""
    if not clause.words.startswith(_PERSON):
        facts = _facts(clause)
        if facts:
            past_state = clause.time in (Time.WAS, Time.START) and not _is_passive(clause.words)
            trouble = "that was so, and may be otherwise now" if past_state else None
            return Told(clause.words, facts, trouble=trouble)
    return (
        _deed(clause.words, lexicon)
        or _made_so(clause.words, lexicon)
        or _loosely(clause.words, lexicon)
        or _by_landmarks(clause.words, lexicon)
        or Told(clause.words)
    )


def _facts(clause: ReadClause) -> tuple[Literal, ...]:
    return tuple((fluent.atom, fluent.holds) for fluent in clause.fluents)


_MAKING = frozenset(
    {"put", "set", "place", "lay", "leave", "get", "make", "keep", "take", "bring", "move"}
    | {"carry", "push", "drop", "store", "load"}
)
"""Verbs after which a thing is as, or where, the rest of the clause says."""


def _made_so(words: str, lexicon: Lexicon) -> Told | None:
    """`Somebody put <a> on the floor`: <a> is on the floor."""
    tokens = words.split()
    for index, token in enumerate(tokens[:-1]):
        if lemma(token) in _MAKING:
            thing, *rest = [word for word in tokens[index + 1 :] if word not in _ARTICLES]
            if not thing.startswith("<") or not rest:
                return None
            rest = ["at" if rest[0] in ("to", "into", "onto") else rest[0], *rest[1:]]
            return _again(words, f"{thing} is {' '.join(rest)}", lexicon)
    return None


_ARTICLES = frozenset({"the", "a", "an"})


def _loosely(words: str, lexicon: Lexicon) -> Told | None:
    """`The lights are on in <a>` said as `the lights of <a> are on`."""
    found = re.fullmatch(r"(.+?) (is|are|becomes) (.+?) (?:in|at|on|of) (?:the )?(<[^>]+>)", words)
    if found is None:
        return None
    subject, verb, rest, place = found.groups()
    return _again(words, f"{subject} of {place} {verb} {rest}", lexicon)


def _again(words: str, said: str, lexicon: Lexicon) -> Told | None:
    """A clause read in other words."""
    facts = tuple(fact for each in clauses_in(said, lexicon, marked=True) for fact in _facts(each))
    return Told(words, facts) if facts else None


def _by_landmarks(words: str, lexicon: Lexicon) -> Told | None:
    """A clause by what the landmarks call the facts."""
    sentence = Sentence.of(_unmarked(words, lexicon), _vocabulary(ById(lexicon)))
    facts: dict[Literal, None] = {}
    for each in sentence.references:
        symbol = resolve(each.symbol, lexicon.problem)
        if each.rivals or not isinstance(symbol, AtomSymbol):
            return None
        if lexicon.landmarks[each.symbol].type is not LandmarkType.CONDITION:
            return None
        said = sentence.text(each.first, each.last).lower()
        own = any(re.search(_DENIAL, name) for name in lexicon.landmarks[each.symbol].phrases)
        negated = each.negated and not (own and re.search(_DENIAL, said))
        facts[symbol.atom, not negated] = None
    if not facts:
        return None
    odd = [
        sentence.text(item.first, item.last)
        for item in sentence.items
        if item.kind in (Kind.UNKNOWN, Kind.NOT, Kind.MAY)
    ]
    strange = tuple(word for word in odd if word.lower() not in _LITTLE)
    return Told(words, tuple(facts), odd=strange, loose=True)


_DENIAL = r"\b(?:not|cannot|can't|no|nothing)\b"


@lru_cache(maxsize=8)
def _vocabulary(lexicon: ById[Lexicon]) -> Vocabulary:
    return Vocabulary.of(lexicon.value.landmarks)


def _is_passive(words: str) -> bool:
    return re.search(r"\b(?:was|were) (?:\w+ )?\w+(?:ed|en|t|n)\b", words) is not None


def _deed(words: str, lexicon: Lexicon) -> Told | None:
    """A clause that tells what was done, to what."""
    plain = _unmarked(words, lexicon)
    referents = referents_of(plain, lexicon)
    verb = _verb(words, referents, lexicon)
    if verb is None:
        return None
    base, rest = verb
    negative = re.search(r"\b(?:not|never|nobody|none)\b", words) is not None
    slots = [mark.split("+") for mark in _marks(words)]
    known = concordance_of(lexicon)
    by_person = not re.match(r"i\b|<", words)
    if base in MOTION and by_person and len(slots) < 2:
        return None  # Where people are is kept nowhere.
    deeds: list[tuple[Deed, ...]] = []
    made: list[Literal] = []
    for objects in product(*slots):
        actions = tuple(
            Deed(name, objects) for name in referents.actions if _takes(name, objects, lexicon)
        )
        made += [(atom, not negative) for atom in known.done(base, objects)]
        if not made:
            made += [(atom, not negative) for atom in _carried(base, objects, lexicon)]
        if actions:
            deeds.append(actions)
    if not deeds and not made:
        return None
    odd = tuple(_odd(rest, referents, lexicon))
    trouble = None
    if negative and not made:
        trouble = "that says what was not done, and not what is so"
    return Told(words, (), () if negative else tuple(deeds), tuple(made), odd, trouble=trouble)


def _carried(verb: str, objects: tuple[str, ...], lexicon: Lexicon) -> Iterator[GroundAtom]:
    """That a thing is where somebody took it."""
    if len(objects) == 2 and verb in {"take", "bring", "put", "carry", "move", "push", "place"}:
        place = concordance_of(lexicon).place_of(f"<{objects[0]}>", f"<{objects[1]}>")
        if place is not None:
            yield place


def _takes(action: str, objects: tuple[str, ...], lexicon: Lexicon) -> bool:
    """Whether every object has a place of its own in an action."""
    return any(
        _placed(list(objects), [lexicon.problem.objects_for(p) for p in schema.parameters])
        for schema in lexicon.problem.action(action)
    )


def _placed(objects: list[str], places: list[tuple[str, ...]]) -> bool:
    if not objects:
        return True
    return any(
        objects[0] in place and _placed(objects[1:], places[:index] + places[index + 1 :])
        for index, place in enumerate(places)
    )


def _unmarked(words: str, lexicon: Lexicon) -> str:
    """A clause with the words for its objects again."""

    def named(match: re.Match[str]) -> str:
        return " and ".join(lexicon.object_words(name) for name in match[1].split("+"))

    return normal(re.sub(r"<([^>]+)>", named, words))


def _verb(words: str, referents: Referents, lexicon: Lexicon) -> tuple[str, list[str]] | None:
    """The verb that says what was done, in its base form, and the other words."""
    forms = {form: verb for verb in referents.verbs for form in (past(verb), participle(verb))}
    named = {
        word for predicate in lexicon.problem.changing_predicates for word in predicate.split("-")
    }
    tokens = [token for token in words.split() if not token.startswith("<")]
    for index, token in enumerate(tokens):
        base = forms.get(token) or (lemma(token) if token not in referents.verbs else token)
        known = base in referents.verbs or participle(base) in named or past(base) in named
        carries = base in {"take", "bring", "put", "carry", "move", "push", "place"}
        if (known or carries) and token not in _LITTLE and (token != base or index):
            return base, tokens[index + 1 :]
    return None


def _odd(rest: list[str], referents: Referents, lexicon: Lexicon) -> Iterator[str]:
    """The words of a deed that nothing was made of."""
    said = {
        word
        for action in referents.actions
        for phrase in lexicon.action_phrases(action)
        for word in phrase.lower().split()
    }
    for word in rest:
        if word not in _LITTLE and word not in said and lemma(word) not in said:
            yield word
