"""Where the words for a fact lead back to the fact: `<b>`, `be`, `full` is `full b`.

The words are those that the lexicon would say, and every further name that the landmarks give.
Objects stand in them as marks, `<name>`.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from plainspoken.questions.identity import ById
from plainspoken.questions.lexicon import PREPOSITIONS, Lexicon, split_name
from plainspoken.questions.morphology import lemma, number_word, participle, past, plural
from plainspoken.questions.spelling import NUMBERS
from plainspoken.world.domain import GroundAtom

Key = tuple[str, str, str]
"""Subject, verb and complement."""

MOST_ATOMS = 20_000
"""Facts that are looked up by their words; a problem with more is read by those first."""
_NUMBER = rf"(?:{'|'.join(NUMBERS[2:13])}|\d+)"
_OPPOSITES = (
    {
        "empty": "full",
        "off": "on",
        "closed": "open",
        "shut": "open",
        "dry": "wet",
        "free": "blocked",
    }
    | {"unlocked": "locked", "cold": "hot", "dirty": "clean", "dark": "lit", "light": "heavy"}
    | {"high": "low", "broken": "intact", "absent": "present", "asleep": "awake", "dead": "alive"}
    | {"negative": "positive", "damaged": "intact"}
)
"""Words that deny another one, used where a domain has no fact of its own for them."""
_LEADING = frozenset({"to", "into", "onto", "from", "off", "out", "toward", "towards", "through"})
"""Prepositions of a way: who is on it is not there, or not there any more."""
ARTICLE = re.compile(r"\b(?:the|a|an|its) (?=[\w<])")


class Concordance:
    """The facts of one problem by the words that say them."""

    def __init__(self, lexicon: Lexicon) -> None:
        self.lexicon = lexicon
        self._marks = _Marks(lexicon)
        self._facts: dict[Key, GroundAtom] = {}
        self._placed: dict[tuple[str, str], list[GroundAtom]] = {}
        for number, atom in enumerate(self._atoms()):
            if number >= MOST_ATOMS:
                break
            clause = lexicon.clause(atom)
            self._add(atom, clause.subject, clause.verb, clause.complement)
            arguments = atom.split()[1:]
            if len(arguments) == 2 and lexicon.place_clause(atom):
                subject = "i" if arguments[0] == lexicon.me else f"<{arguments[0]}>"
                self._placed.setdefault((subject, f"<{arguments[1]}>"), []).append(atom)
        for atom, phrase in lexicon.atom_phrases():
            self._add_phrase(atom, phrase)
        self.verbs = self._verb_forms()

    def mark(self, text: str) -> str:
        """A text in lower case with the names of objects as marks, lists of them as one."""
        return self._marks.mark(text)

    def facts(self, subject: str, verb: str, complement: str) -> list[tuple[GroundAtom, bool]]:
        """The facts that a clause says, and whether it says that they are so."""
        subject = self._speaking(subject)
        found = self._facts.get((subject, verb, complement))
        if found is not None:
            return [(found, True)]
        if verb == "be":
            if place := self._place(subject, complement):
                return [(place, True)]
            for opposite in sorted(opposites(complement)):
                if found := self._facts.get((subject, "be", opposite)):
                    return [(found, False)]
            if undone := self._facts.get((subject, "be", f"un{complement}")):
                return [(undone, False)]
            if subject == "i" and complement.split(" ", 1)[0].endswith("ing"):
                first, _, rest = complement.partition(" ")
                return self.facts(subject, lemma(first), rest)
        if (
            verb == "hold"
            and subject == "i"
            and (found := self._facts.get((complement, "be", "in my hand")))
        ):
            return [(found, True)]
        if complement == "nothing" and verb in ("hold", "carry"):
            return self.facts("my hand", "be", "empty")
        return []

    def done(self, verb: str, objects: Sequence[str]) -> list[GroundAtom]:
        """The facts that a deed leaves by its very name: `washed carrot` of to wash."""
        names = {participle(verb), past(verb)}
        return [
            atom
            for atom in self._by_name(names)
            if atom.split()[1:] and set(atom.split()[1:]) == set(objects)
        ]

    def _by_name(self, names: set[str]) -> Iterator[GroundAtom]:
        for predicate in sorted(self.lexicon.problem.changing_predicates & names):
            parameters = self.lexicon.problem.domain.predicates[predicate]
            for binding in self.lexicon.problem.bindings(parameters):
                yield " ".join([predicate, *binding.values()])

    def _place(self, subject: str, complement: str) -> GroundAtom | None:
        """Where a thing is, whichever preposition is used."""
        words = complement.split()
        if len(words) < 2 or words[-2] not in PREPOSITIONS - _LEADING:
            return None
        places = self._placed.get((subject, words[-1]), [])
        exact = [each for each in places if words[-2] in split_name(each.split()[0])]
        return exact[0] if exact else places[0] if len(places) == 1 else None

    def _speaking(self, subject: str) -> str:
        return "i" if subject == f"<{self.lexicon.me}>" else subject

    def place_of(self, subject: str, place: str) -> GroundAtom | None:
        """The fact that a thing is at a place; None where there are several such facts, or none."""
        subject = self._speaking(subject)
        places = self._placed.get((subject, place), [])
        return places[0] if len(places) == 1 else None

    def _atoms(self) -> Iterator[GroundAtom]:
        problem = self.lexicon.problem
        for predicate in sorted(problem.changing_predicates):
            parameters = problem.domain.predicates[predicate]
            for binding in problem.bindings(parameters):
                yield " ".join([predicate, *binding.values()])

    def _add(self, atom: GroundAtom, subject: str, verb: str, complement: str) -> None:
        key = (self._speaking(self.plain(subject)), verb, self.plain(complement))
        self._facts.setdefault(key, atom)

    def _add_phrase(self, atom: GroundAtom, phrase: str) -> None:
        found = re.match(r"(.+?) (is|are|holds|has|carries) (.+)$", phrase)
        if found:
            subject = found[1]
            if subject in ("the robot", "robot"):
                subject = "I"
            self._add(atom, subject, lemma(found[2]) if found[2] != "are" else "be", found[3])

    def plain(self, words: str) -> str:
        """Some words as they are looked up: marked, without articles and plural words."""
        text = ARTICLE.sub("", self.mark(words)).strip()
        return (
            "my hand"
            if text in ("hand", "my hand", "hands", "my hands")
            else text.replace("in hand", "in my hand").replace("my my", "my")
        )

    def _verb_forms(self) -> dict[str, str]:
        verbs = {verb for _, verb, _ in self._facts}
        forms = {participle(verb): verb for verb in verbs}
        return {**forms, **{past(verb): verb for verb in verbs}, **{verb: verb for verb in verbs}}


_MARK = re.compile(r"<([^>]+)>")
_LISTED = re.compile(
    r"<[^>]+>(?:, (?:the )?<[^>]+>)*(?:,? and (?:the )?<[^>]+>"
    r"(?! (?:is|was|has|does)\b|,? and (?:the )?<)"
    r"|,? (?:or|nor) (?:the )?<[^>]+>)"
)
"""Things in a list; "at <a> and <b> is full" is none: what follows a list is said of several."""


class _Marks:
    """Names of objects in a text, replaced by marks."""

    def __init__(self, lexicon: Lexicon) -> None:
        problem = lexicon.problem
        self._names: dict[str, tuple[str, ...]] = {}
        numbered: dict[str, dict[str, str]] = {}
        kinds: dict[str, list[str]] = {}
        for name in problem.objects:
            for words in lexicon.synonyms(name) - {"robot"}:
                self._names.setdefault(words, (name,))
            if name == lexicon.me:
                continue
            for words in lexicon.synonyms(name):
                if found := re.match(r"(\D+) (\d+)$", words):
                    numbered.setdefault(found[1], {})[found[2]] = name
            for kind in {lexicon.type_words(name), *lexicon.types_of(name)}:
                kinds.setdefault(" ".join(split_name(kind)), []).append(name)
        self._numbered = {plural(head): known for head, known in numbered.items()} | numbered
        self._kinds = {plural(kind): tuple(names) for kind, names in kinds.items()}
        self._name = _any_of(self._names)
        number = r"\d+"
        heads = "|".join(sorted(map(re.escape, self._numbered), key=len, reverse=True)) or "(?!)"
        self._listed = re.compile(
            rf"\b({heads}) ({number}(?:(?: ?, ?| and | or |, and ){number})*)(?![\w-])"
        )
        longest = sorted(map(re.escape, self._kinds), key=len, reverse=True)
        kinds_named = "|".join(longest) or "(?!)"
        self._all = re.compile(
            rf"\b(?:all|both|every|each|none)(?: of)?(?: the)?(?: (?P<number>{_NUMBER}))? "
            rf"(?P<kinds>{kinds_named})\b"
        )

    def mark(self, text: str) -> str:
        text = self._listed.sub(self._several, text.lower())
        text = self._all.sub(self._whole, text)
        text = self._name.sub(lambda m: _mark(self._names[m[0]]), text)
        return _LISTED.sub(lambda m: _mark("+".join(_MARK.findall(m[0])).split("+")), text)

    def _whole(self, match: re.Match[str]) -> str:
        names = self._kinds[match["kinds"]]
        if match["number"] and match["number"] not in (str(len(names)), number_word(len(names))):
            return match[0]  # "All seven mugs", of three.
        return ("none " if match[0].startswith("none") else "") + _mark(names)

    def _several(self, match: re.Match[str]) -> str:
        known = self._numbered[match[1]]
        names = [known.get(each) for each in re.findall(r"\d+", match[2])]
        return _mark([name for name in names if name]) if all(names) else match[0]


def _any_of(words: dict[str, tuple[str, ...]]) -> re.Pattern[str]:
    longest = sorted(map(re.escape, words), key=len, reverse=True)
    return re.compile(rf"(?<![\w<+-])(?:{'|'.join(longest) or '(?!)'})(?![\w>+-])")


def _mark(names: Sequence[str]) -> str:
    return f"<{'+'.join(names)}>"


def opposites(word: str) -> frozenset[str]:
    """The words that deny another one: `unchecked` and `checked`, `empty` and `full`."""
    found = {word.removeprefix("un")} if word.startswith("un") and len(word) > 4 else {f"un{word}"}
    found |= {value for key, value in _OPPOSITES.items() if key == word}
    return frozenset(found | {key for key, value in _OPPOSITES.items() if value == word})


@lru_cache(maxsize=8)
def _concordance(lexicon: ById[Lexicon]) -> Concordance:
    return Concordance(lexicon.value)


def concordance_of(lexicon: Lexicon) -> Concordance:
    """The concordance of a lexicon; kept, as many texts are read with one."""
    return _concordance(ById(lexicon))
