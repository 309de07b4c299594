"""The name of the robot that is spoken to, where only the ids of its places tell it.

Landmarks call a place "the archive", with an id such as `robot_at_ada_archive`: the ids of all the
robot's places begin alike, and what they begin with ends in its name. Said of it ("Ada should ...")
or to it ("Hey Ada, ..."), the name is another word for the robot.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import takewhile

from plainspoken.language.word import Word, is_known, words
from plainspoken.world.landmark import Landmarks, LandmarkType

SAYS_WHERE = frozenset(("at", "in", "on", "inside", "located", "location", "position"))
"""How a predicate ends that tells where somebody is: `robot_at`, `in`, `is_located`."""
_ROBOT = "robot"


def own_name(landmarks: Landmarks) -> str | None:
    """What the ids of all places have in common before the place; None where it is no name."""
    shared = beginning(landmarks)
    if len(shared) < 2:
        return None
    name = shared[-1]
    described = {
        word.text for one in landmarks.values() for phrase in one.phrases for word in words(phrase)
    }
    if not name.isalpha() or len(name) < 2 or name in described or name in SAYS_WHERE:
        return None
    # Behind "at" a word is whose place it is, even where it is one of English: Rob, Flora.
    return name if shared[-2] in SAYS_WHERE or not is_known(name) else None


def beginning(landmarks: Landmarks) -> tuple[str, ...]:
    """The words that the ids of all places begin with, where something follows in each."""
    ids = [one.id.split("_") for one in landmarks.values() if one.type is LandmarkType.LOCATION]
    if len(ids) < 2:
        return ()
    columns = list(zip(*ids, strict=False))[: min(map(len, ids)) - 1]
    return tuple(column[0] for column in takewhile(lambda each: len(set(each)) == 1, columns))


def addressed(said: Sequence[Word], name: str | None) -> tuple[Word, ...]:
    """The words with the robot's name as another word for the robot."""
    if name is None:
        return tuple(said)
    return tuple(replace(each, text=_ROBOT) if each.text == name else each for each in said)
