"""The words for what a problem holds: its objects, its facts and its actions.

Landmarks go first; what they do not name is worded from the PDDL names. The robot that speaks is
`I`. Nothing here knows a domain: only English and the shape of names, effects and landmarks.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from functools import cached_property, lru_cache
from typing import Any

from plainspoken.errors import UnknownSymbolError
from plainspoken.questions.clause import Clause, Deed, Thing
from plainspoken.questions.morphology import lemma
from plainspoken.questions.template import Template, template_of
from plainspoken.world.domain import GroundAction, GroundAtom, Problem
from plainspoken.world.landmark import Landmark, Landmarks, LandmarkType, landmarks_from_json
from plainspoken.world.symbol import ActionSymbol, AtomSymbol, flat, resolve
from plainspoken.world.wording import spelled_out

PREPOSITIONS = frozenset(
    {"aboard", "above", "across", "at", "behind", "below", "beneath"}
    | {"beside", "between", "by", "for", "from", "in", "inside", "into", "near"}
    | {"of", "off", "on", "onto", "out", "outside", "over", "through", "to"}
    | {"toward", "towards", "under", "underneath", "upon", "with", "within"}
    | {"without"}
)
_RELATING = frozenset(
    {"carry", "contain", "cover", "face", "grip", "guard", "hear", "hold", "know", "need", "own"}
    | {"see", "support", "touch", "wear"}
)
_DETERMINERS = ("the ", "a ", "an ", "my ", "your ")
_VERB = re.compile(r"^(?P<subject>.+?) (?P<verb>is|are|has|have|holds|contains) (?P<rest>.+)$")
_CODE = re.compile(r"^(?P<letters>[a-z]+?)[-_]?(?P<number>\d+)$")
_PERSONS = frozenset(
    {"person", "human", "man", "woman", "people", "user", "operator", "agent", "patient", "guest"}
    | {"customer", "client", "nurse", "doctor", "worker", "child", "student", "passenger"}
    | {"visitor", "resident", "friend", "colleague"}
)


def split_name(name: str) -> list[str]:
    """A PDDL name as words: `robot-at` is `robot`, `at`."""
    return [word for word in re.split(r"[-_]+", name) if word]


class Lexicon:
    """The words of one problem and its landmarks.

    me: the object that is the robot that speaks, None where none stands out
    """

    def __init__(self, problem: Problem, landmarks: Landmarks) -> None:
        self.problem = problem
        self.landmarks = landmarks
        self._templates: dict[str, Template] = {}
        self._clauses: dict[GroundAtom, Clause] = {}

    @cached_property
    def resolved(self) -> tuple[tuple[Landmark, AtomSymbol | ActionSymbol], ...]:
        """The landmarks that name something in the problem, and what."""
        found = []
        for one in self.landmarks.values():
            try:
                found.append((one, resolve(one.id, self.problem)))
            except UnknownSymbolError:
                continue  # A landmark of another problem of the domain: there is nothing to say.
        return tuple(found)

    # -- who speaks ----------------------------------------------------------------------------

    @cached_property
    def actor_types(self) -> frozenset[str]:
        """The types of a first argument that every action has and that stands nowhere else."""
        schemas = self.problem.domain.actions
        if not schemas or not all(schema.parameters for schema in schemas):
            return frozenset()
        first = {each for schema in schemas for each in schema.parameters[0].types}
        other = {
            each
            for schema in schemas
            for parameter in schema.parameters[1:]
            for each in parameter.types
        }
        return frozenset() if first & other or first == {"object"} else frozenset(first)

    @cached_property
    def actors(self) -> tuple[str, ...]:
        """The objects that can act."""
        return tuple(
            name
            for name in self.problem.objects
            if self.types_of(name)[0] in self.actor_types
            or self.actor_types & set(self.types_of(name))
        )

    @cached_property
    def me(self) -> str | None:
        placed = {
            symbol.atom.split()[1]
            for one, symbol in self.resolved
            if one.type is LandmarkType.LOCATION
            and isinstance(symbol, AtomSymbol)
            and len(symbol.atom.split()) == 3
        }
        if len(placed) == 1:
            return placed.pop()
        return self.actors[0] if len(self.actors) == 1 else None

    def types_of(self, name: str) -> tuple[str, ...]:
        """The type of an object and those above it, `object` left out."""
        return self.type_chain(self.problem.objects.get(name, "object"))

    def type_chain(self, own: str) -> tuple[str, ...]:
        """A type and those above it, `object` left out."""
        chain: list[str] = []
        while own != "object" and own not in chain:
            chain.append(own)
            own = self.problem.domain.types.get(own, "object")
        return tuple(chain) or ("object",)

    # -- objects -------------------------------------------------------------------------------

    @cached_property
    def _names(self) -> dict[str, tuple[str, ...]]:
        """The words for each object that landmarks give, the best first."""
        votes: dict[str, Counter[str]] = {}
        places: dict[str, list[str]] = {}
        for one, symbol in self.resolved:
            if not isinstance(symbol, AtomSymbol):
                continue
            _, *arguments = symbol.atom.split()
            if one.type is LandmarkType.LOCATION and arguments:
                own = one.phrases if self.me is not None else self._shared_words(one, arguments)
                # "The cart is at the dock" says where it is, and is no name of the dock.
                called = [phrase for phrase in own if not _VERB.match(phrase)]
                places.setdefault(arguments[-1], []).extend(called)
            elif (
                arguments[:1] != [self.me] and arguments and (found := _VERB.match(one.description))
            ):
                votes.setdefault(arguments[0], Counter())[found["subject"]] += 1
        names = {
            name: (min(counted, key=lambda words: (-counted[words], len(words), words)),)
            for name, counted in votes.items()
        }
        named = {name: tuple(dict.fromkeys(words)) for name, words in places.items() if words}
        return {**names, **named}

    def _shared_words(self, one: Landmark, arguments: list[str]) -> list[str]:
        """The words for a place that do not tell which of several robots is there."""
        others = {
            phrase
            for other, symbol in self.resolved
            if isinstance(symbol, AtomSymbol) and other.type is LandmarkType.LOCATION
            and symbol.atom.split()[-1] == arguments[-1] and symbol.atom.split()[1:] != arguments
            for phrase in other.phrases
        }  # fmt: skip
        return [phrase for phrase in one.phrases if phrase in others]

    @cached_property
    def _further(self) -> dict[str, frozenset[str]]:
        """Further words for objects, from landmarks that say one thing in two ways."""
        found: dict[str, set[str]] = {}
        for one, symbol in self.resolved:
            own = _VERB.match(one.description)
            if own is None or not isinstance(symbol, AtomSymbol) or " " not in symbol.atom:
                continue
            for phrase in one.names:
                other = _VERB.match(phrase)
                if other and (other["verb"], other["rest"]) == (own["verb"], own["rest"]):
                    found.setdefault(symbol.atom.split()[1], set()).add(other["subject"])
        return {name: frozenset(words) for name, words in found.items()}

    @lru_cache(maxsize=4096)  # noqa: B019 - a lexicon lives as long as its mission is asked about
    def object_words(self, name: str) -> str:
        """`mug 1`, `the support robot`, `the kitchen`, `Ann`."""
        given = self._names.get(name, ("",))[0]
        same = given.lower().replace(" ", "") == "".join(split_name(name))
        if given and (not same or given != given.lower()):
            return _with_article(given)
        types = self.types_of(name)
        own = " ".join(map(spelled_out, split_name(types[0]))) if types[0] != "object" else ""
        alike = [o for o, each in self.problem.objects.items() if each == types[0]]
        found = _CODE.match(name)
        if found:
            letters = " ".join(split_name(found["letters"]))
            short = own.replace(" ", "").startswith(letters) or len(letters) < 3
            if own and short:
                return f"{own} {found['number']}" if len(alike) > 1 else f"the {own}"
            return f"{letters} {found['number']}"
        words = split_name(name)
        if own and len(alike) == 1 and (len(name) <= 2 or own.startswith(name)):
            return f"the {own}"
        if _PERSONS & set(types) and len(words) == 1 and name not in _PERSONS:
            return name.capitalize()
        return "the " + " ".join(words) if len(name) > 1 else f"{own} {name.upper()}".strip()

    def synonyms(self, name: str) -> frozenset[str]:
        """Every way to name an object that is understood, without its article."""
        words = {self.object_words(name), *self._names.get(name, ()), name}
        words |= {" ".join(split_name(name))}
        words |= self._further.get(name, frozenset())
        found = _CODE.match(name)
        if found:
            words.add(f"{found['letters']} {found['number']}")
            words |= {f"{' '.join(split_name(t))} {found['number']}" for t in self.types_of(name)}
        for each in self.types_of(name):
            if len([o for o in self.problem.objects if each in self.types_of(o)]) == 1:
                words.add(" ".join(split_name(each)))
        return frozenset(bare(each) for each in words) - {"object"}

    def type_words(self, name: str) -> str:
        """What kind of thing an object is, as one says it of several: `mug`, `line`."""
        found = re.match(r"(\D+) \d+$", bare(self.object_words(name)))
        own = self.types_of(name)[0]
        return found[1] if found else " ".join(split_name(own)) if own != "object" else "thing"

    def thing(self, name: str) -> Thing:
        return Thing(name, self.object_words(name))

    # -- facts ---------------------------------------------------------------------------------

    def clause(self, atom: GroundAtom) -> Clause:
        """The small sentence that says an atom."""
        if atom not in self._clauses:
            self._clauses[atom] = self._clause(atom)
        return self._clauses[atom]

    def _clause(self, atom: GroundAtom) -> Clause:
        predicate, *arguments = atom.split()
        one = self.landmarks.get(flat(atom))
        if one is not None and one.type is LandmarkType.CONDITION:
            found = _VERB.match(one.description)
            if found:
                verb = lemma(found["verb"])
                subject = self._spoken_subject(found["subject"], arguments)
                return Clause(subject, verb, found["rest"], found["verb"] == "are")
        words = split_name(predicate)
        if one is not None and (told := self._told(one, predicate, arguments)):
            return told
        if len(words) > 1 and words[0] in ("is", "are"):
            words = words[1:]
        subjects = [self._subject(name) for name in arguments]
        if not arguments:
            return _bare_clause(words)
        if len(arguments) == 1:
            return self._property(words, subjects[0])
        if len(arguments) == 2:
            return self._relation(words, arguments, subjects)
        tail = ", ".join(self.object_words(name) for name in arguments[1:])
        return Clause(subjects[0], "be", f"{' '.join(words)} {tail}")

    def _told(self, one: Landmark, predicate: str, arguments: list[str]) -> Clause | None:
        """What a landmark says with the predicate's own verb: "room 2 needs cleaning"."""
        verb, *more = split_name(predicate)
        if one.type is LandmarkType.LOCATION:
            if len(arguments) != 2 or {verb, *more} & PREPOSITIONS:
                return None
            return Clause(
                self._subject(arguments[0]), "be", f"at {self.object_words(arguments[1])}"
            )
        found = re.match(rf"(?P<subject>.+?) {re.escape(verb)}(?: (?P<rest>.+))?$", one.description)
        if found is None or not self._is_verb(verb):
            return None
        subject = self._spoken_subject(found["subject"], arguments)
        return Clause(subject, lemma(verb), found["rest"] or "")

    def _spoken_subject(self, subject: str, arguments: list[str]) -> str:
        """The subject of a landmark's sentence as the robot says it."""
        if bare(subject) == "robot" or (
            self.me and bare(subject) == bare(self.object_words(self.me))
        ):
            return "I"
        if arguments and subject.lower().replace(" ", "") == "".join(split_name(arguments[0])):
            return self._subject(arguments[0])  # Only the name: there are better words for it.
        return subject if subject in ("it", "there") else _with_article(subject)

    def _subject(self, name: str) -> str:
        return "I" if name == self.me else self.object_words(name)

    def _property(self, words: list[str], subject: str) -> Clause:
        """`cleared line`, `hand-empty robot`, `on-table block`, `holding mug`, `robot-in room`."""
        if len(words) > 1 and words[-1] in PREPOSITIONS and words[0] not in PREPOSITIONS:
            # One thing of its kind that has no name: where it is, is all that is said of it.
            kind = " ".join(words[:-1])
            mover = "I" if kind in ("robot", "agent") else f"the {kind}"
            return Clause(mover, "be", f"{words[-1]} {subject}")
        if len(words) == 1 and words[0].endswith("ing") and subject != "I":
            return Clause("I", "be", f"{words[0]} {subject}")
        if len(words) == 1 or words[0] in PREPOSITIONS or words[0] == "not":
            text = " ".join(words)
            if len(words) == 2 and words[0] in PREPOSITIONS:
                text = f"{words[0]} the {words[1]}"
            return Clause(subject, "be", text)
        if len(words) == 2 and words[1] not in PREPOSITIONS:
            owner = "my" if subject == "I" else f"{subject}'s"
            return Clause(f"{owner} {words[0]}", "be", words[1], _is_plural(words[0]))
        return Clause(subject, "be", " ".join(words))

    def _relation(self, words: list[str], arguments: list[str], subjects: list[str]) -> Clause:
        """`robot-at rob l0`, `on a b`, `carries rob b`, `holding rob mug`."""
        second = self.object_words(arguments[1])
        if words[0] in ("has", "have") or self._is_verb(words[0]):
            return Clause(subjects[0], lemma(words[0]), " ".join([*words[1:], second]))
        if len(words) > 1 and words[0] in PREPOSITIONS and words[-1] not in PREPOSITIONS:
            if words[1:] == split_name(self.types_of(arguments[1])[0]):
                # `in-bay van front-bay`: the thing says by itself what kind it is.
                return Clause(subjects[0], "be", f"{words[0]} {second}")
            return Clause(subjects[0], "be", f"{words[0]} the {' '.join(words[1:])} of {second}")
        if words[-1] in PREPOSITIONS:
            kinds = {*split_name(arguments[0])}.union(*map(split_name, self.types_of(arguments[0])))
            middle = [word for word in words[:-1] if word not in kinds]
            return Clause(subjects[0], "be", " ".join([*middle, words[-1], second]))
        if words[-1].endswith("ing") or words[-1].endswith("ed"):
            link = "" if words[-1].endswith("ing") else "to "
            return Clause(subjects[0], "be", f"{' '.join(words)} {link}{second}")
        return Clause(subjects[0], "be", f"{' '.join(words)} to {second}")

    def _is_verb(self, word: str) -> bool:
        """Whether a word of a predicate is a verb such as `carries`, and no kind of object."""
        if word in _RELATING:
            return True
        kinds = {each for type in self.problem.domain.types for each in split_name(type)}
        return (
            word.endswith("s")
            and not word.endswith("ss")
            and word not in kinds
            and lemma(word) != word
            and lemma(word) not in kinds
        )

    def place_clause(self, atom: GroundAtom) -> bool:
        """Whether the atom says where something is: `robot-at rob l0`, `on-table mug`."""
        predicate, *arguments = atom.split()
        words = split_name(predicate)
        if len(arguments) == 1:
            return len(words) > 1 and words[0] in PREPOSITIONS
        return len(arguments) == 2 and words[-1] in PREPOSITIONS

    # -- actions -------------------------------------------------------------------------------

    def template(self, action: str) -> Template:
        if action not in self._templates:
            one = self.landmarks.get(f"{flat(action)}_executed")
            said = one.description if one is not None and one.type is LandmarkType.ACTION else None
            self._templates[action] = template_of(self, action, said)
        return self._templates[action]

    def deed(self, action: GroundAction) -> Deed:
        """The words for a ground action."""
        name, *arguments = action.split()
        template = self.template(name)
        subject = "I"
        if arguments and arguments[0] != self.me and arguments[0] in self.actors:
            subject = self.object_words(arguments[0])
        parts = tuple(
            part if isinstance(part, str) else self.thing(arguments[part])
            for part in template.parts
            if isinstance(part, str) or part < len(arguments)
        )
        return Deed(subject, template.verb, parts)

    def action_phrases(self, action: str) -> tuple[str, ...]:
        """The ways to say an action that the landmarks and its name give, without `to`."""
        one = self.landmarks.get(f"{flat(action)}_executed")
        said = one.phrases if one is not None else ()
        return (*(re.sub(r"^to ", "", each) for each in said), " ".join(split_name(action)))

    def atom_phrases(self) -> Iterator[tuple[GroundAtom, str]]:
        """The ways to say an atom that the landmarks give."""
        for one, symbol in self.resolved:
            if isinstance(symbol, AtomSymbol):
                for phrase in one.phrases:
                    yield symbol.atom, phrase


def bare(words: str) -> str:
    """Without the article, lower case."""
    text = words.lower()
    for determiner in _DETERMINERS:
        text = text.removeprefix(determiner)
    return text


def _with_article(words: str) -> str:
    """A name as it stands in a sentence: `box` gets an article, `line 1` needs none."""
    if words.startswith(_DETERMINERS) or words[-1].isdigit() or any(map(str.isupper, words)):
        return words
    if re.search(r"\b(?:of|\d+)\b", words):
        return words
    return f"the {words}"


def _bare_clause(words: list[str]) -> Clause:
    """A fact about nothing in particular: `door-open`, `raining`."""
    if len(words) == 1:
        return Clause("it", "be", words[0])
    return Clause(f"the {' '.join(words[:-1])}", "be", words[-1], _is_plural(words[-2]))


def _is_plural(noun: str) -> bool:
    return noun.endswith("s") and not noun.endswith(("ss", "us", "is")) and lemma(noun) != noun


def landmarks_of(document: Mapping[str, Any]) -> Landmarks:
    """The landmarks document that a log carries; an empty one is no landmarks."""
    return landmarks_from_json(dict(document), "landmarks of the log") if document else {}
