"""Words for what the domain calls otherwise: "the couch" where it says "the sofa".

A paraphrase is never taken silently. Where one makes sense of the whole utterance, the person is
asked whether it is what was meant.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise, product

from plainspoken.language.extracted import listed
from plainspoken.language.frame import ARTICLES
from plainspoken.language.grounding import Vocabulary
from plainspoken.language.slip import Slip
from plainspoken.language.thesaurus import Similarity
from plainspoken.language.word import Word, is_known, stems

LEAST_NEAR = 0.7
"""Less near in meaning, the name of a thing is not offered."""
LEAST_NEAR_OF_A_VERB = 0.8
"""The same of what is done or so: those words have more senses, and rarer ones."""
MOST_PARAPHRASES = 4
"""Unknown words in one utterance; with more of them it is about something else."""
MOST_TRIED = 6
_MOST_A_WORD = 3
_MODIFIED = 0.65
"""What a name is worth with a word before it that the domain does not have: "the front gate"."""
_COMPOUND = 0.62
"""The same of a name that is part of a longer word: "gateway"."""
_OWNERS = ARTICLES | frozenset(("my", "our", "your", "this", "that"))


@dataclass(frozen=True, slots=True)
class _Option:
    slip: Slip
    score: float


def paraphrases(
    said: Sequence[Word],
    unknown: Sequence[tuple[int, int]],
    vocabulary: Vocabulary,
    similarity: Similarity,
) -> Iterator[tuple[Slip, ...]]:
    """What an utterance may say in the words of the domain, the likeliest first.

    unknown: the words, first and one after the last, that stand for nothing
    """
    strange = [
        index
        for first, last in unknown
        for index in range(first, last)
        if said[index].text.isalpha() and not _is_heard(said[index], vocabulary)
    ]
    texts = dict.fromkeys(said[index].text for index in strange)
    if not 0 < len(texts) <= MOST_PARAPHRASES:
        return
    options = [tuple(_options(said, index, vocabulary, similarity)) for index in strange]
    if not all(options):
        return
    ranked = sorted(product(*options), key=lambda each: -sum(option.score for option in each))
    for chosen in islice(filter(_agrees, ranked), MOST_TRIED):
        yield tuple(option.slip for option in chosen)


def asked_whether(utterance: str, found: Sequence[Slip]) -> str:
    """The question whether words stand for others."""
    pairs = {(utterance[each.start : each.end].lower(), each.meant): each for each in found}
    said = [utterance[each.start : each.end] for each in pairs.values()]
    meant = [each.meant for each in pairs.values()]
    return f"By {_quoted(said)}, do you mean {_quoted(meant)}?"


def _quoted(texts: Sequence[str]) -> str:
    return listed([f'"{text}"' for text in texts], "and")


def _is_heard(word: Word, vocabulary: Vocabulary) -> bool:
    return any(stem in vocabulary.by_stem for stem in word.stems)


def _agrees(chosen: Sequence[_Option]) -> bool:
    """Whether no piece of the utterance is changed twice."""
    spans = sorted((each.slip.start, each.slip.end) for each in chosen)
    return all(one[1] <= other[0] for one, other in pairwise(spans))


def _options(
    said: Sequence[Word], index: int, vocabulary: Vocabulary, similarity: Similarity
) -> Iterator[_Option]:
    word = said[index]
    following = said[index + 1] if index + 1 < len(said) else None
    owned = index > 0 and said[index - 1].text in _OWNERS
    if owned and following is not None and _is_heard(following, vocabulary):
        name = following.text
        yield _Option(Slip(word.start, following.end, name), _MODIFIED)
    found: dict[str, float] = {}
    for stem in word.stems:
        for score, name in similarity.ranked(stem, vocabulary.by_stem):
            found[name] = max(found.get(name, 0.0), score)
        for name in vocabulary.by_stem:
            if len(name) > 3 and _is_part(name, stem):
                found[name] = max(found.get(name, 0.0), _COMPOUND)
    nouns = _nouns(vocabulary)
    best = sorted(found.items(), key=lambda each: (-each[1], each[0]))[:_MOST_A_WORD]
    for name, score in best:
        if name not in nouns and (owned or score < LEAST_NEAR_OF_A_VERB):
            continue
        if score >= LEAST_NEAR or score == _COMPOUND:
            yield _Option(Slip(word.start, word.end, inflected(name, word)), score)


def _nouns(vocabulary: Vocabulary) -> frozenset[str]:
    """The words that things of the domain are called by."""
    frames = vocabulary.frames
    named = (*frames.things, *frames.places, *frames.movers)
    return frames.classes | {stem for thing in named for text in thing for stem in stems(text)}


def _is_part(name: str, word: str) -> bool:
    """Whether a word is made of a name and another word: "gate" and "way"."""
    rest = word.removeprefix(name) if word.startswith(name) else word.removesuffix(name)
    return rest != word and len(rest) > 2 and is_known(rest)


def inflected(name: str, like: Word) -> str:
    """A word with the ending of another one: "sofa" as in "couches"."""
    if like.text in like.stems and like.stems == {like.text}:
        return name
    for ending in ("ing", "ed", "es", "s"):
        if not like.text.endswith(ending):
            continue
        heads = (name, name.removesuffix("e"), name + name[-1])
        ends = ("s", "es") if ending in ("es", "s") else (ending,)
        for made in (head + end for end in ends for head in heads):
            if is_known(made) and name in stems(made):
                return made
    return name
