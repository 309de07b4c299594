"""Claims in words: facts and deeds joined into sentences that a person would say."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace

from plainspoken.questions.clause import Clause, Deed, Tense, Thing, enumerated, merged
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.morphology import counted, listed, plural, times
from plainspoken.world.domain import GroundAction, GroundAtom

_CHUNK = re.compile(r"(\D+)(\d*)")
MOST_NAMED = 5
"""More things of a kind than this are counted, not named."""


@dataclass(frozen=True, slots=True)
class Saying:
    """Some words, and the atoms that they say.

    named: whether the words tell which things, and not only how many
    """

    text: str
    atoms: tuple[GroundAtom, ...]
    named: bool = True


def facts_together(
    lexicon: Lexicon,
    atoms: Iterable[GroundAtom],
    tense: Tense = "now",
    *,
    negative: bool = False,
    most: int = MOST_NAMED,
) -> list[Saying]:
    """One saying for the facts that differ in their subject only: `mugs 2 and 3 are clean`."""
    groups: dict[tuple[str, str], list[tuple[GroundAtom, Clause]]] = {}
    for atom in atoms:
        clause = lexicon.clause(atom)
        groups.setdefault((clause.verb, clause.complement), []).append((atom, clause))
    clauses: list[_Said] = []
    for unsorted in groups.values():
        members = sorted(unsorted, key=lambda member: natural(member[0]))
        clause, named = members[0][1], True
        if len(members) > 1:
            subjects = list(dict.fromkeys(each.subject for _, each in members))
            words, named = _subjects(
                lexicon, [atom for atom, _ in members], subjects, most, negative=negative
            )
            several = len(subjects) > 1 and " of " not in subjects[0]
            clause = replace(clause, subject=words, several=several)
        clauses.append(_Said(clause, tuple(atom for atom, _ in members), named))
    if not negative:
        clauses = _with_one_subject(clauses)
    return [
        Saying(each.clause.said(tense, negative=negative), each.atoms, each.named)
        for each in clauses
    ]


@dataclass(frozen=True, slots=True)
class _Said:
    """A clause in the making, and the atoms that it says."""

    clause: Clause
    atoms: tuple[GroundAtom, ...]
    named: bool


def _with_one_subject(clauses: Sequence[_Said]) -> list[_Said]:
    """Clauses of one subject as one: `mugs 0 and 2 are picked and inside the box`."""
    found: dict[tuple[str, str], list[_Said]] = {}
    for each in clauses:
        clause = each.clause
        # Only `be` is shared: "holds a mug and lies on the table" would need the verb twice.
        key = (clause.subject, clause.verb if clause.verb == "be" else clause.complement)
        found.setdefault(key, []).append(each)
    return [
        _Said(
            replace(group[0].clause, complement=listed([one.clause.complement for one in group])),
            tuple(atom for one in group for atom in one.atoms),
            all(one.named for one in group),
        )
        for group in found.values()
    ]


def natural(text: str) -> tuple[tuple[str, int], ...]:
    """A key that sorts `g2` before `g10`."""
    return tuple((word, int(digits or -1)) for word, digits in _CHUNK.findall(text))


def _subjects(
    lexicon: Lexicon,
    atoms: Sequence[GroundAtom],
    subjects: Sequence[str],
    most: int,
    *,
    negative: bool,
) -> tuple[str, bool]:
    """Several subjects as one, and whether it tells which they are: `all four mugs`, `17 mugs`."""
    names = dict.fromkeys(atom.split()[1] for atom in atoms if " " in atom)
    kinds = {lexicon.type_words(name) for name in names}
    noun = next(iter(kinds)) if len(kinds) == 1 else "thing"
    # "All four mugs aren't clean" may mean that some are.
    if len(names) == len(subjects) > 2 and kinds == {noun} and not negative:
        alike = [each for each in lexicon.problem.objects if lexicon.type_words(each) == noun]
        if len(alike) == len(names):
            return f"all {counted(len(names), noun)}", True
    if len(subjects) <= most:
        others = [each for each in subjects if each != "I"]
        return enumerated([*others, *(["I"] if len(others) < len(subjects) else [])]), True
    return counted(len(subjects), noun), False


def deeds_together(
    lexicon: Lexicon, actions: Sequence[GroundAction], *, most: int = MOST_NAMED
) -> list[tuple[Deed, int]]:
    """A deed for each kind of action, in the order they were first done, and how often.

    The number is 1 unless one and the same deed was done several times.
    """
    number = Counter(actions)
    groups: dict[tuple[str, str], list[GroundAction]] = {}
    for action in dict.fromkeys(actions):
        groups.setdefault((action.split()[0], lexicon.deed(action).subject), []).append(action)
    found: list[tuple[Deed, int]] = []
    for (name, subject), group in groups.items():
        deeds = list(dict.fromkeys(map(lexicon.deed, group)))
        if len(deeds) == 1:
            found.append((deeds[0], sum(number[action] for action in group)))
        elif (joined := merged(deeds)) is not None and len(deeds) <= most:
            found.append((joined, 1))
        else:
            found.append((_summed(lexicon, name, subject, group, deeds), 1))
    return found


def _summed(
    lexicon: Lexicon, name: str, subject: str, group: Sequence[GroundAction], deeds: Sequence[Deed]
) -> Deed:
    """Many deeds of a kind as one, its things counted: `check 17 mugs`."""
    parts: list[str | Thing] = []
    for index in lexicon.template(name).parts:
        if isinstance(index, str):
            parts.append(index)
            continue
        names = list(dict.fromkeys(action.split()[index + 1] for action in group))
        if len(names) == 1:
            parts.append(lexicon.thing(names[0]))
        elif len(names) <= MOST_NAMED:
            parts.append(enumerated([lexicon.object_words(each) for each in names]))
        else:
            kinds = {lexicon.type_words(each) for each in names}
            parts.append(counted(len(names), kinds.pop() if len(kinds) == 1 else "thing"))
    return Deed(subject, deeds[0].verb, tuple(parts))


def often(text: str, number: int) -> str:
    """`called the support robot twice`; once goes without saying."""
    return text if number == 1 else f"{text} {times(number)}"


def spoken(deeds: Sequence[tuple[str, str]], *, auxiliary: str = "") -> str:
    """`I checked mug 1 and picked it`: subjects and what they did, each subject said once."""
    runs: list[tuple[str, list[str]]] = []
    for subject, words in deeds:
        if runs and runs[-1][0] == subject:
            runs[-1][1].append(words)
        else:
            runs.append((subject, [words]))
    said = [f"{subject}{_auxiliary(auxiliary, subject)} {listed(words)}" for subject, words in runs]
    return ", and ".join(filter(None, (", ".join(said[:-1]), said[-1]))) if said else ""


def _auxiliary(word: str, subject: str) -> str:
    if word == "have":
        return "'ve" if subject == "I" else " has"
    return {"": "", "will": "'ll" if subject == "I" else " will"}[word]


def past_deeds(deeds: Sequence[tuple[Deed, int]], *, perfect: bool = False) -> str:
    """`I checked mugs 0 and 1, picked mug 1 and rinsed it`; `I've checked ...`."""
    said = referring([deed for deed, _ in deeds])
    return spoken(
        [
            (deed.subject, often(deed.done if perfect else deed.did, number))
            for deed, (_, number) in zip(said, deeds, strict=True)
        ],
        auxiliary="have" if perfect else "",
    )


def future_deeds(deeds: Sequence[Deed], opening: str = "") -> str:
    """`I'll check mug 1 and sign off line 1`."""
    said = spoken([(deed.subject, deed.bare) for deed in deeds], auxiliary="will")
    return " ".join(filter(None, (opening, said)))


def joined_runs(deeds: Sequence[Deed]) -> list[Deed]:
    """Neighbours that differ in one thing as one deed: `move to lines 1 and 2`."""
    found: list[list[Deed]] = []
    for deed in deeds:
        if found and merged([*found[-1], deed]) is not None and deed not in found[-1]:
            found[-1].append(deed)
        else:
            found.append([deed])
    return [merged(run) or run[0] for run in found]


def referring(deeds: Sequence[Deed], before: Deed | None = None) -> list[Deed]:
    """The deeds with `it` for a thing that the deed before has just named, and no other thing."""
    found: list[Deed] = []
    last = before
    for deed in deeds:
        known = _things(last) if last is not None else []
        found.append(deed.pronoun(known=known))
        last = deed
    return found


def _things(deed: Deed) -> list[Thing]:
    return [part for part in deed.parts if isinstance(part, Thing)]


def about_it(text: str, deed: Deed) -> str:
    """A saying with `it` for its subject, where the deed has named that and nothing else."""
    things = [part for part in deed.parts if isinstance(part, Thing)]
    if len(things) != 1 or not things[0].name or things[0].words[0].isupper():
        return text  # "It" would mean nothing, or a person.
    words = re.escape(things[0].words)
    text = re.sub(rf"^{words} (is|was|has|isn't)\b", r"it \1", text)
    return re.sub(rf"^the (\w+) of {words} ", r"its \1 ", text)


def present_deed(deed: Deed) -> str:
    """`I'm checking mug 1`."""
    return f"I'm {deed.doing}" if deed.subject == "I" else f"{deed.subject} is {deed.doing}"


def named(lexicon: Lexicon, names: Sequence[str], most: int = 12) -> str:
    """`mugs 0 and 1`; many are named up to a point and then counted."""
    words = [lexicon.object_words(name) for name in names]
    if len(words) <= most:
        return enumerated(words)
    kinds = {lexicon.type_words(name) for name in names}
    noun = kinds.pop() if len(kinds) == 1 else "thing"
    return f"{counted(len(words), noun)}, among them {enumerated(words[:3])}"


def steps(number: int) -> str:
    """`three more actions`."""
    return f"{counted(number, 'more action')}" if number else "nothing more"


def ago(number: int) -> str:
    """How many actions lie between an instant and now."""
    if number == 0:
        return "just now"
    return f"{counted(number, 'action')} ago"


def kinds_word(names: Sequence[str], lexicon: Lexicon) -> str:
    """The plural noun for some objects: `mugs`; `things` for a mixture."""
    kinds = {lexicon.type_words(name) for name in names}
    return plural(kinds.pop()) if len(kinds) == 1 else "things"
