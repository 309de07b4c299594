"""Make the thesaurus that grounding asks with, from the database files of WordNet 3.0.

    python tools/thesaurus.py DIRECTORY_WITH_DATA_AND_INDEX_FILES

Kept are single words for what a robot may meet or do: things, places, persons, animals, food and
substances of the nouns, and all verbs and adjectives, as far as the dictionary of lemmas that
plainspoken uses has them. Each line of the result is one sense: its words, each with the rank of
the sense among those of the word, and the lines of what is more general (of adjectives: similar).
"""

from __future__ import annotations

import gzip
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

import simplemma

RESULT = Path(__file__).parents[1] / "src" / "plainspoken" / "language" / "thesaurus.txt.gz"
NOUNS = frozenset(("05", "06", "08", "13", "14", "15", "17", "18", "20", "27"))
"""Files of WordNet: animals, artifacts, bodies, food, groups, places, objects, persons, plants and
substances."""
MORE_GENERAL = {"n": ("@",), "v": ("@", "$"), "a": ("&",)}
MOST_SENSES = 8
"""Rarer senses of a word are left out."""
NOTICE = """\
WordNet 3.0 Copyright 2006 by Princeton University. All rights reserved.
THIS SOFTWARE AND DATABASE IS PROVIDED "AS IS" AND PRINCETON UNIVERSITY MAKES NO REPRESENTATIONS
OR WARRANTIES, EXPRESS OR IMPLIED. This is a selection; the licence is in LICENSE-WORDNET.
"""


@dataclass(frozen=True)
class Sense:
    """One synset: its offset with its part of speech, its file, its words, and the more general."""

    id: str
    file: str
    words: tuple[str, ...]
    above: tuple[str, ...]


def senses(directory: Path, kind: str, letter: str) -> Iterator[Sense]:
    """The synsets of one part of speech."""
    for line in (directory / f"data.{kind}").read_text().splitlines():
        if line.startswith(" "):
            continue
        fields = line.split("|")[0].split()
        count = int(fields[3], 16)
        words = tuple(fields[4 + 2 * i].lower().split("(")[0] for i in range(count))
        rest = fields[4 + 2 * count :]
        above = tuple(
            letter + rest[2 + 4 * i]
            for i in range(int(rest[0]))
            if rest[1 + 4 * i] in MORE_GENERAL[letter]
        )
        yield Sense(letter + fields[0], fields[1], words, above)


def ranks(directory: Path, kind: str, letter: str) -> Iterator[tuple[str, str, int]]:
    """Each word, a sense of it, and which of its senses that is, the most usual first."""
    for line in (directory / f"index.{kind}").read_text().splitlines():
        if line.startswith(" "):
            continue
        fields = line.split()
        for rank, offset in enumerate(fields[6 + int(fields[3]) :][:MOST_SENSES]):
            yield fields[0], letter + offset, rank


def is_kept(word: str) -> bool:
    """Whether a word is one that people say."""
    return word.isalpha() and len(word) > 1 and bool(simplemma.is_known(word, lang="en"))


def made(directory: Path) -> str:
    """The whole table, with its notice."""
    kept: dict[str, Sense] = {}
    named: dict[str, dict[str, int]] = {}
    for kind, letter in (("noun", "n"), ("verb", "v"), ("adj", "a")):
        for sense in senses(directory, kind, letter):
            if letter != "n" or sense.file in NOUNS:
                kept[sense.id] = sense
        for word, id, rank in ranks(directory, kind, letter):
            if id in kept and is_kept(word):
                named.setdefault(id, {})[word] = rank
    links = {id: [up for up in sense.above if up in named] for id, sense in kept.items()}
    linked = {up for id, ups in links.items() if id in named for up in ups}
    order = [id for id in sorted(named) if len(named[id]) > 1 or links[id] or id in linked]
    place = {id: number for number, id in enumerate(order)}
    lines = (
        " ".join(
            [
                id[0],
                *(f"{word}:{rank}" for word, rank in sorted(named[id].items())),
                *(str(place[up]) for up in links[id] if up in place),
            ]
        )
        for id in order
    )
    return NOTICE + "\n" + "\n".join(lines) + "\n"


if __name__ == "__main__":
    text = made(Path(sys.argv[1]))
    with gzip.GzipFile(RESULT, "wb", compresslevel=9, mtime=0) as file:
        file.write(text.encode())
    print(f"{RESULT.name}: {len(text.splitlines())} lines, {RESULT.stat().st_size} bytes")
