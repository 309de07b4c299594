"""The hash chain over a mission's log: what makes tampering evident.

Each entry is hashed together with the hash before it, as the text that is stored, so that one
changed byte breaks the chain at its step. Entries cut off the end leave a chain that is whole:
against that, keep the last hash somewhere else and compare.
"""

from __future__ import annotations

import json
from collections.abc import Iterable
from dataclasses import dataclass
from hashlib import sha256
from typing import NamedTuple

from plainspoken.world.event import Entry, Step

MissionId = str
Hash = str
"""Sixty-four hexadecimal digits."""


class Link(NamedTuple):
    """An entry as it is stored: its canonical JSON and the hash up to here."""

    step: Step
    text: str
    hash: Hash


@dataclass(frozen=True, slots=True)
class Break:
    """The first place where a log is not as it was written."""

    mission: MissionId
    step: Step
    what: str


def canonical(entry: Entry) -> str:
    """The one text of an entry: fields as `Entry.to_json` orders them, no spaces.

    ASCII only, so that no line separator of Unicode and no lone surrogate of a command line
    can cut a line of the log in two or keep it from being written.
    """
    return json.dumps(entry.to_json(), ensure_ascii=True, separators=(",", ":"))


def genesis(mission: MissionId) -> Hash:
    """What the first entry is chained to, so that no chain fits another mission."""
    return sha256(b"plainspoken\n" + mission.encode("utf-8", "surrogatepass")).hexdigest()


def chained(previous: Hash, text: str) -> Hash:
    """The hash of an entry after the one before it."""
    return sha256(f"{previous}\n{text}".encode("utf-8", "surrogatepass")).hexdigest()


def linked(mission: MissionId, entries: Iterable[Entry]) -> list[Link]:
    """The whole chain of a mission's entries, from its first one."""
    links: list[Link] = []
    previous = genesis(mission)
    for entry in entries:
        text = canonical(entry)
        previous = chained(previous, text)
        links.append(Link(entry.step, text, previous))
    return links


def first_break(mission: MissionId, links: Iterable[Link]) -> Break | None:
    """Where the chain is broken, None where it is whole."""
    previous = genesis(mission)
    for expected, link in enumerate(links):
        if link.step != expected:
            return Break(mission, expected, f"step {expected} is missing")
        if link.hash != chained(previous, link.text):
            return Break(mission, expected, "the entry is not the one that was written")
        if _step_of(link.text) != expected:
            return Break(mission, expected, "the entry belongs to another step")
        previous = link.hash
    return None


def _step_of(text: str) -> object:
    try:
        document = json.loads(text)
    except ValueError:
        return None
    return document.get("step") if isinstance(document, dict) else None
