"""The words of a problem in another language than English, from a file, and what they make.

The file names objects, says what is so of the first argument of a fact, and how each action is
put: `"inside": "in {1}"`, `"put-in": "mettere {x} in {y}"`. Italian is the language there is;
another one is a module beside `italian.py`.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from plainspoken.errors import InputFileError
from plainspoken.questions import italian
from plainspoken.questions.narration import natural
from plainspoken.world.domain import GroundAction, GroundAtom, Problem

LANGUAGES = {"it": italian}


@dataclass(frozen=True, slots=True)
class Noun:
    """The name of a thing, without an article."""

    name: str
    feminine: bool


@dataclass(frozen=True, slots=True)
class Words:
    """What a file of words says about one problem."""

    language: str
    nouns: Mapping[str, Noun]
    facts: Mapping[str, str]
    actions: Mapping[str, str]


def read_words(path: Path, problem: Problem) -> Words:
    """Read a file of words.

    raises InputFileError: where it is no such file, or lacks a word that answers need
    """
    try:
        document = json.loads(path.read_text(encoding="utf-8"))
        words = _words(document)
    except (OSError, ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputFileError(
            f"no file of words: {type(error).__name__} {error}",
            path,
            hint="the words.it.json among the examples shows what it holds",
        ) from error
    lacking = [each for each in sorted(problem.changing_predicates) if each not in words.facts]
    lacking += [each.name for each in problem.domain.actions if each.name not in words.actions]
    lacking += [name for name in sorted(problem.objects) if name not in words.nouns]
    if words.language not in LANGUAGES or lacking:
        wrong = f"no words for {', '.join(lacking[:5])}" if lacking else "no language known"
        raise InputFileError(
            wrong, path, hint=f"languages: {', '.join(LANGUAGES)}; every name needs words"
        )
    return words


def _words(document: Mapping[str, Any]) -> Words:
    nouns = {
        name: Noun(str(own["name"]), own.get("gender", "") == "f" or _feminine(own))
        for name, own in document["objects"].items()
    }
    facts, actions = document["facts"], document["actions"]
    return Words(
        str(document["language"]),
        nouns,
        {name: str(said) for name, said in facts.items()},
        {name: str(said) for name, said in actions.items()},
    )


def _feminine(own: Mapping[str, Any]) -> bool:
    return "gender" not in own and italian.is_feminine(str(own["name"]))


class Speaker:
    """Says facts and deeds of one problem in Italian; `me` is the robot that speaks."""

    def __init__(self, words: Words, problem: Problem, me: str | None) -> None:
        self._words = words
        self._problem = problem
        self._me = me

    def things(self, names: Sequence[str], preposition: str = "") -> str:
        """`il filare 0`, `i filari 0 e 1 e la cassa`; `a i filari 0 e 1 e a la cassa`."""
        groups: dict[tuple[str, bool], list[str]] = {}
        for name in names:
            noun = self._words.nouns[name]
            found = re.match(r"(.+) (\d+)$", noun.name)
            key = (found[1] if found else noun.name, noun.feminine)
            groups.setdefault(key, []).append(found[2] if found else "")
        parts = []
        for (head, feminine), numbers in groups.items():
            several = len(numbers) > 1
            spoken = italian.plural(head) if several else head
            article = italian.with_article(spoken, feminine=feminine, several=several)
            parts.append(f"{preposition}{article} {italian.listed(numbers)}".strip())
        return italian.listed(parts)

    # -- facts ---------------------------------------------------------------------------------

    def facts(
        self, atoms: Iterable[GroundAtom], tense: str = "now", *, negative: bool = False
    ) -> str:
        """`sono al filare 0 e i grappoli 0 e 1 non sono maturi`."""
        shared: dict[str, list[str]] = {}
        for atom in sorted(dict.fromkeys(atoms), key=natural):
            predicate, *arguments = atom.split()
            complement = self._words.facts[predicate]
            for index, name in enumerate(arguments):
                complement = complement.replace(f"{{{index}}}", self.things([name]))
            shared.setdefault(complement, []).append(arguments[0] if arguments else "")
        together: dict[tuple[str, ...], list[str]] = {}
        for complement, subjects in shared.items():
            own = [each for each in subjects if each == self._me]
            others = tuple(each for each in subjects if each != self._me)
            for group in filter(None, (tuple(own), others)):
                together.setdefault(group, []).append(complement)
        order = sorted(together, key=lambda group: group != (self._me,))
        return italian.listed(
            [self._fact(group, together[group], tense, negative=negative) for group in order]
        )

    def _fact(
        self, subjects: Sequence[str], complements: Sequence[str], tense: str, *, negative: bool
    ) -> str:
        me = tuple(subjects) == (self._me,)
        several = len(subjects) > 1
        nouns = [self._words.nouns[name] for name in subjects if name]
        feminine = bool(nouns) and all(noun.feminine for noun in nouns) and not me
        verb = italian.be(tense, me=me, several=several)
        said = italian.listed(
            [italian.agreeing(c, feminine=feminine, several=several) for c in complements]
        )
        subject = "" if me or not nouns else self.things(subjects)
        return italian.contracted(f"{subject} {'non ' if negative else ''}{verb} {said}".strip())

    # -- deeds ---------------------------------------------------------------------------------

    def deeds(self, actions: Sequence[GroundAction], form: str, conjunction: str = "e") -> str:
        """`ho controllato i grappoli 0 e 1 e chiuso il filare 0`.

        form: `did`, `doing`, `shall` or `do`
        """
        kinds: dict[tuple[str, bool], list[GroundAction]] = {}
        for action in dict.fromkeys(actions):
            kinds.setdefault((action.split()[0], self._mine(action)), []).append(action)
        return italian.listed([self._deed(group, form) for group in kinds.values()], conjunction)

    def _mine(self, action: GroundAction) -> bool:
        """Whether I am the one who acts: every action whose first argument is no other actor."""
        first = action.split()[1:2]
        schema = self._problem.action(action.split()[0])[0]
        if self._me is None or not first or first[0] == self._me or not schema.parameters:
            return True
        return self._me not in self._problem.objects_for(schema.parameters[0])

    def _deed(self, group: Sequence[GroundAction], form: str) -> str:
        name, *first = group[0].split()
        template = self._words.actions[name]
        schema = self._problem.action(name)[0]
        for index, parameter in enumerate(schema.parameters):
            names = list(dict.fromkeys(action.split()[index + 1] for action in group))
            # "A" and its like are said before each thing of a list.
            slot = rf"((?:a|da|di|in|su|con) |)\{{{re.escape(parameter.name.lstrip('?'))}\}}"
            if found := re.search(slot, template):
                template = template.replace(found[0], self.things(names, found[1]))
        verb, _, rest = template.partition(" ")
        me = self._mine(group[0])
        said = {
            "do": verb,
            "doing": italian.is_doing(verb, me=me),
            "did": italian.has_done(verb, me=me),
            "shall": italian.future(verb, me=me),
        }[form]
        subject = "" if me else f"{self.things(first[:1])} "
        return italian.contracted(f"{subject}{said} {rest}".strip())
