"""What a question speaks of: objects, kinds of objects, facts and actions of the mission."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import product

from plainspoken.questions.lexicon import PREPOSITIONS, Lexicon, split_name
from plainspoken.questions.morphology import (
    lemma,
    participle,
    past,
    plural,
    progressive,
    third_person,
)
from plainspoken.questions.spelling import NUMBERS, normal
from plainspoken.world.domain import GroundAction, GroundAtom

_ALIKE = {"in": "inside", "inside": "in", "on": "onto", "onto": "on"}
_EMPTY = frozenset(
    {"a", "an", "the", "of", "to", "is", "are", "was", "were", "be", "been", "am", "that", "this"}
    | {"i", "you", "it", "he", "she", "they", "we", "my", "your", "our", "its", "there", "robot"}
    | {"have", "has", "had", "do", "does", "did", "will", "would", "can", "could"}
)
_BEEN = re.compile(r"\b(?:been|was|were|went|away|out)\b")
MOTION = frozenset(
    {"go", "move", "drive", "come", "head", "travel", "enter", "visit", "reach", "arrive", "return"}
    | {"walk", "leave", "approach", "proceed"}
)
"""Verbs of going, which any domain with places understands."""


@dataclass(frozen=True, slots=True)
class Referents:
    """What a text speaks of.

    kinds:   nouns that stand for several objects, with those objects: `lines` (l0, l1 ...)
    atoms:   the facts that the words spell out, or may
    deeds:   ground actions of the named kind cannot be listed before a log is at hand, so the
             named actions and objects stand for them
    verbs:   every word that is an action's verb in this domain
    visits:  that I am at a place named, where the words speak of going or having been there
    goals:   for each action that only goes somewhere, which argument says where
    topics:  predicates whose own noun is said and whose property is not: `the floor`, `the battery`
    things:  the words said for objects that cannot act
    """

    objects: tuple[str, ...] = ()
    kinds: tuple[tuple[str, tuple[str, ...]], ...] = ()
    predicates: tuple[str, ...] = ()
    actions: tuple[str, ...] = ()
    atoms: tuple[GroundAtom, ...] = ()
    verbs: frozenset[str] = frozenset()
    visits: tuple[GroundAtom, ...] = ()
    goals: tuple[tuple[str, int], ...] = ()
    topics: tuple[str, ...] = ()
    things: frozenset[str] = frozenset()

    def concerns(self, action: GroundAction) -> bool:
        """Whether a ground action is one of those spoken of."""
        name, *arguments = action.split()
        if self.actions and name not in self.actions:
            return False
        goal = dict(self.goals).get(name)
        if goal is not None and self.objects and self.actions:
            # Who asks for a move to line 3 does not ask for one away from there.
            return arguments[goal] in self.objects and set(self.objects) <= set(arguments)
        return all(each in arguments for each in self.objects)


def referents_of(plain: str, lexicon: Lexicon) -> Referents:
    """Look up what a normalised text speaks of."""
    index = index_of(lexicon)
    objects, rest = index.objects_in(plain)
    tokens = rest.split()
    lemmas = {token: index.base(token) for token in dict.fromkeys(plain.split())}
    kinds = index.kinds_in(tokens)
    actions = index.actions_in(plain, lemmas)
    predicates = index.predicates_in(plain, lemmas)
    speaks_to_me = bool({"you", "your", "yourself", "robot"} & set(plain.split()))
    atoms = tuple(index.atoms_for(predicates, objects, speaks_to_me=speaks_to_me))
    visits: tuple[GroundAtom, ...] = ()
    if MOTION & set(lemmas.values()) or _BEEN.search(plain):
        visits = tuple(index.visits(objects))
        if not set(objects) <= {name for atom in visits for name in atom.split()}:
            visits = ()  # Something is named that is no place: it is not about where I am.
    if visits and MOTION & set(lemmas.values()):
        # Whatever takes me there: "go" may be the very word for one of several ways to move.
        actions = tuple(dict.fromkeys([*actions, *(name for name, _ in index.goals)]))
    goals = tuple(index.goals)
    topics = () if predicates else index.topics_in(tokens)
    things = frozenset(
        words
        for name in objects
        if name not in lexicon.actors
        for words in lexicon.synonyms(name)
        if words in plain
    )
    return Referents(
        objects,
        kinds,
        predicates,
        actions,
        atoms,
        verbs=index.verbs,
        visits=visits,
        goals=goals,
        topics=topics,
        things=things,
    )


def first_words(lexicon: Lexicon) -> frozenset[str]:
    """The words that a name of a thing, or of a kind of things, may begin with."""
    return index_of(lexicon).first_words


_INDEXES: dict[int, tuple[Lexicon, Index]] = {}


def index_of(lexicon: Lexicon) -> Index:
    """The index of a lexicon, made once."""
    known = _INDEXES.get(id(lexicon))
    if known is None or known[0] is not lexicon:
        if len(_INDEXES) > 16:
            _INDEXES.clear()
        known = _INDEXES[id(lexicon)] = (lexicon, Index(lexicon))
    return known[1]


class Index:
    """Words of one lexicon, from what is said to what is meant."""

    def __init__(self, lexicon: Lexicon) -> None:
        self._lexicon = lexicon
        self._problem = lexicon.problem
        self._phrases: dict[str, str] = {}
        self._numbered: dict[str, dict[str, str]] = {}
        for name in lexicon.problem.objects:
            for words in lexicon.synonyms(name):
                self._phrases.setdefault(words, name)
                self._phrases.setdefault(normal(words), name)
                found = re.match(r"(\D+) (\d+)$", words)
                if found:
                    self._numbered.setdefault(found[1], {})[found[2]] = name
        self._kinds = self._kind_words()
        for words, name in tuple(self._phrases.items()):
            if words not in self._kinds and plural(words) not in self._kinds:
                self._phrases.setdefault(plural(words), name)  # "We are out of oil filters."
        self._verb_forms = self._forms_of_verbs()
        self._actions = tuple(self._action_words())
        self._predicates = tuple(self._predicate_words())
        self.verbs = frozenset(verb for _, verb, _ in self._actions)
        self.goals = tuple(self._motions())
        named = {*self._phrases, *self._kinds, *map(plural, self._kinds)}
        self.deed_words = frozenset(self._verb_forms)
        self.kind_words = frozenset(
            word for kind in {*self._kinds, *map(plural, self._kinds)} for word in kind.split()
        )
        said = {word for _, words in self._predicates for word in words} - PREPOSITIONS - _EMPTY
        self.fact_words = frozenset(
            said
            | {
                form
                for word in said
                for form in (past(word), third_person(word), progressive(word))
            }
        ) - {"not"}
        self.first_words = frozenset(words.split()[0] for words in named if words) - self.verbs
        alternatives = sorted(map(re.escape, self._phrases), key=len, reverse=True)
        self._pattern = re.compile(rf"(?<![\w-])(?:{'|'.join(alternatives) or '(?!)'})(?![\w-])")
        heads = sorted(
            {re.escape(form) for head in self._numbered for form in (head, plural(head))},
            key=len,
            reverse=True,
        )
        number = rf"(?:\d+|{'|'.join(NUMBERS)})"
        self._listed = re.compile(
            rf"(?<![\w-])({'|'.join(heads) or '(?!)'})(?: numbers?)? ({number}"
            rf"(?:(?: and| or| to| through|-)* {number})*)(?![\w-])"
        )

    def base(self, token: str) -> str:
        """The base form of a word; that of a verb of the domain by its own forms."""
        return self._verb_forms.get(token) or (token if token.isdigit() else lemma(token))

    def _forms_of_verbs(self) -> dict[str, str]:
        names = [schema.name for schema in self._problem.domain.actions]
        phrases = [phrase for name in names for phrase in self._lexicon.action_phrases(name)]
        verbs = {phrase.lower().split()[0] for phrase in phrases if phrase}
        inflections = (past, participle, progressive, third_person)
        forms = {inflect(verb): verb for inflect in inflections for verb in sorted(verbs)}
        return {**forms, **{verb: verb for verb in verbs}}

    # -- objects -------------------------------------------------------------------------------

    def objects_in(self, plain: str) -> tuple[tuple[str, ...], str]:
        """The objects named, in order, and the text without their names."""
        rest = plain
        found: list[str] = []
        for start, end, names in self.named_in(plain):
            rest = rest[:start] + " " * (end - start) + rest[end:]
            found.extend(names)
        return tuple(dict.fromkeys(name for name in found if name != self._lexicon.me)), rest

    def named_in(self, plain: str) -> list[tuple[int, int, tuple[str, ...]]]:
        """Where objects are named: from, to, and which; in order, the robot that speaks too."""
        found: list[tuple[int, int, tuple[str, ...]]] = []

        def several(match: re.Match[str]) -> str:
            head = match[1]
            known = self._numbered.get(head) or next(
                each for one, each in self._numbered.items() if plural(one) == head
            )
            numbers = [number for number in _expanded(match[2]) if number in known]
            found.append((*match.span(), tuple(known[number] for number in numbers)))
            return " " * len(match[0])

        rest = self._listed.sub(several, plain)
        found += [
            (*match.span(), (self._phrases[match[0]],)) for match in self._pattern.finditer(rest)
        ]
        return sorted(found)

    def _kind_words(self) -> dict[str, tuple[str, ...]]:
        kinds: dict[str, list[str]] = {}
        for name in self._problem.objects:
            if name == self._lexicon.me:
                continue
            words = {self._lexicon.type_words(name)}
            words |= {" ".join(split_name(each)) for each in self._lexicon.types_of(name)}
            for each in words:
                kinds.setdefault(each, []).append(name)
        return {each: tuple(names) for each, names in kinds.items()}

    def kinds_in(self, tokens: list[str]) -> tuple[tuple[str, tuple[str, ...]], ...]:
        text = f" {' '.join(tokens)} "
        return tuple(
            (kind, names)
            for kind, names in self._kinds.items()
            if f" {kind} " in text or f" {plural(kind)} " in text
        )

    # -- actions -------------------------------------------------------------------------------

    def _action_words(self) -> Iterator[tuple[str, str, frozenset[str]]]:
        """Each action with a verb for it, and the other words of the phrase."""
        objects = {word for phrase in self._phrases for word in phrase.split()}
        kinds = {word for kind in self._kinds for word in kind.split()}
        for schema in self._problem.domain.actions:
            for phrase in self._lexicon.action_phrases(schema.name):
                verb, *rest = phrase.lower().split() or [""]
                words = {self.base(word) for word in rest} - _EMPTY - kinds - objects
                particles = {word for word in rest if word in PREPOSITIONS} | {"up", "down"} & set(
                    rest
                )
                yield schema.name, verb, frozenset(words | particles)

    def actions_in(self, plain: str, lemmas: dict[str, str]) -> tuple[str, ...]:
        words = plain.split()
        said = {
            lemmas[word]
            for index, word in enumerate(words)
            if index == 0
            or words[index - 1] not in ("next", "last", "your", "a", "the", "what")
            or words[index - 2 : index] == ["you", "last"]
        } | {word for index, word in enumerate(words) if index and words[index - 1] == "you"}
        present = set(lemmas) | set(lemmas.values())
        scored: dict[str, tuple[int, int]] = {}
        for name, verb, others in self._actions:
            if verb in said:
                shared = len(others & present)
                key = (shared, -len(others - present))
                scored[name] = max(scored.get(name, key), key)
        best: dict[str, tuple[int, int]] = {}
        for name, verb, _ in self._actions:
            if name in scored and verb in said:
                best[verb] = max(best.get(verb, scored[name]), scored[name])
        return tuple(
            dict.fromkeys(
                name
                for name, verb, _ in self._actions
                if name in scored and verb in said and scored[name] == best[verb]
            )
        )

    def _motions(self) -> Iterator[tuple[str, int]]:
        """The actions that only take the robot somewhere, and the argument that says where."""
        for name in dict.fromkeys(schema.name for schema in self._problem.domain.actions):
            parts = self._lexicon.template(name).parts
            if len(parts) == 2 and parts[0] == "to" and isinstance(parts[1], int):
                yield name, parts[1]

    def visits(self, objects: tuple[str, ...]) -> Iterator[GroundAtom]:
        """That the robot that speaks is at each of some places."""
        me = self._lexicon.me
        for predicate, parameters in self._problem.domain.predicates.items():
            if me is None or len(parameters) != 2:
                continue
            whose, where = (self._problem.objects_for(each) for each in parameters)
            for name in objects:
                atom = f"{predicate} {me} {name}"
                if me in whose and name in where and self._lexicon.place_clause(atom):
                    yield atom

    # -- facts ---------------------------------------------------------------------------------

    def _predicate_words(self) -> Iterator[tuple[str, frozenset[str]]]:
        """Each predicate that can change, with words that together say it."""
        kinds = {word for kind in self._kinds for word in kind.split()} | {"robot"}
        for predicate in sorted(self._problem.changing_predicates):
            words = [word for word in split_name(predicate) if word not in _EMPTY]
            content = {word for word in words if word not in PREPOSITIONS and word not in kinds}
            yield predicate, frozenset(content or words)
            for word in content:
                if word.startswith("un") and len(word) > 4:
                    # "which have not been checked" asks for the unchecked ones
                    yield predicate, frozenset({"not", self.base(word[2:])})
            if words and words[-1] in PREPOSITIONS:
                yield predicate, frozenset({words[-1]})
                yield predicate, frozenset({_ALIKE.get(words[-1], words[-1])})
        for atom, phrase in self._lexicon.atom_phrases():
            predicate, *arguments = atom.split()
            text = phrase.lower()
            for name in arguments:
                for words_of in sorted(self._lexicon.synonyms(name), key=len, reverse=True):
                    text = re.sub(rf"(?<!\w){re.escape(words_of)}(?!\w)", " ", text)
            rest = frozenset(word for word in text.split() if word not in _EMPTY)
            if rest - PREPOSITIONS:
                yield predicate, rest

    def predicates_in(self, plain: str, lemmas: dict[str, str]) -> tuple[str, ...]:
        present = set(lemmas) | set(lemmas.values())
        found: dict[str, int] = {}
        for predicate, words in self._predicates:
            matched = all(w in present or self._alike(w, lemmas) for w in words)
            if matched:
                found[predicate] = max(found.get(predicate, 0), len(words))
        return tuple(sorted(found, key=lambda each: (-found[each], each)))

    def topics_in(self, tokens: list[str]) -> tuple[str, ...]:
        """The predicates whose noun is said: `floor` for `floor-wet`."""
        return tuple(
            predicate
            for predicate in sorted(self._problem.changing_predicates)
            if (words := split_name(predicate))[1:]
            and words[0] in tokens
            and not {words[0], words[-1]} & (PREPOSITIONS | {"robot"})
            and len(words) == 2
        )

    def _alike(self, word: str, lemmas: dict[str, str]) -> bool:
        """Whether a word of a name has a form of the same verb among the words said."""
        return len(word) > 3 and self.base(word) in lemmas.values()

    def atoms_for(
        self, predicates: tuple[str, ...], objects: tuple[str, ...], *, speaks_to_me: bool
    ) -> Iterator[GroundAtom]:
        """The facts that the named predicates and objects make up, all objects used."""
        own = (self._lexicon.me,) if speaks_to_me and self._lexicon.me else ()
        for predicate in predicates:
            parameters = self._problem.domain.predicates[predicate]
            places = []
            for parameter in parameters:
                fitting = self._problem.objects_for(parameter)
                named = [name for name in (*objects, *own) if name in fitting]
                if not named and len(fitting) == 1:
                    named = list(fitting)
                places.append(named)
            for arguments in product(*places):
                used = {*arguments}
                if len(used) == len(arguments) and (
                    len(parameters) == 1 or len(objects) < 2 or used >= set(objects)
                ):
                    yield " ".join([predicate, *arguments])


def _expanded(numbers: str) -> Iterator[str]:
    """The numbers of `0 and 1` or `1 to 3`."""
    words = numbers.replace("-", " to ").split()
    values: list[int] = []
    span = False
    for word in words:
        if word in ("to", "through"):
            span = True
            continue
        if word in ("and", "or"):
            continue
        value = NUMBERS.index(word) if word in NUMBERS else int(word)
        if span and values and value > values[-1] and value - values[-1] < 1000:
            values.extend(range(values[-1] + 1, value + 1))
        else:
            values.append(value)
        span = False
    return map(str, values)
