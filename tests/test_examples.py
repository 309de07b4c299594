"""The examples are sound: they parse, their words resolve, their formulas mean what they say."""

from __future__ import annotations

import json
import re
from collections import Counter
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from plainspoken.automata.equivalence import implies, satisfiable
from plainspoken.logic.formula import Atom, Formula, children
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import Trace, holds
from plainspoken.world.domain import Problem
from plainspoken.world.landmark import Landmarks, LandmarkType, read_landmarks
from plainspoken.world.pddl import read_domain, read_problem

EXAMPLES = Path(__file__).resolve().parents[1] / "examples"
DOMAINS = ("vineyard", "warehouse", "kitchen")
NAVIGATION = {
    "visit",
    "sequenced visit",
    "ordered visit",
    "strict ordered visit",
    "global avoidance",
}
PATTERNS = NAVIGATION | {
    "guarded visit",
    "fair visit",
    "patrolling",
    "past avoidance",
    "future avoidance",
    "upper restricted avoidance",
    "lower restricted avoidance",
    "exact restricted avoidance",
    "wait",
    "instantaneous reaction",
    "delayed reaction",
    "prompt reaction",
    "bound reaction",
    "bound delay",
    # not in the catalogue: "always stay at a" and "end up at a for good"
    "maintenance",
    "remaining",
}

Sentence = dict[str, Any]


@cache
def problem_of(domain: str) -> Problem:
    folder = EXAMPLES / domain
    return read_problem(folder / "problem.pddl", read_domain(folder / "domain.pddl"))


@cache
def landmarks_of(domain: str) -> Landmarks:
    return read_landmarks(EXAMPLES / domain / "landmarks.json", problem_of(domain))


@cache
def sentences_of(domain: str) -> tuple[Sentence, ...]:
    text = (EXAMPLES / domain / "sentences.jsonl").read_text(encoding="utf-8")
    return tuple(json.loads(line) for line in text.splitlines())


each_domain = pytest.mark.parametrize("domain", DOMAINS)


def atoms_of(formula: Formula) -> set[str]:
    if isinstance(formula, Atom):
        return {formula.name}
    return {name for child in children(formula) for name in atoms_of(child)}


def traces_of(sentence: Sentence, which: str) -> list[Trace]:
    return [[frozenset(x) for x in trace] for trace in sentence.get("traces", {}).get(which, [])]


def frame_of(sentence: Sentence) -> str:
    """The utterance with a gap for each referring expression."""
    frame = sentence["utterance"]
    spans = {(one["start"], one["end"]) for one in sentence["referring_expressions"]}
    for start, end in sorted(spans, reverse=True):
        frame = f"{frame[:start]}_{frame[end:]}"
    return re.sub(r"\W+", " ", frame.lower()).strip()


@each_domain
def test_an_example_parses_and_its_landmarks_resolve(domain: str) -> None:
    assert problem_of(domain).objects
    types = {landmark.type for landmark in landmarks_of(domain).values()}
    assert types == set(LandmarkType)


@each_domain
def test_no_two_landmarks_of_an_example_share_a_name(domain: str) -> None:
    phrases = Counter(p.lower() for one in landmarks_of(domain).values() for p in one.phrases)
    assert [phrase for phrase, count in phrases.items() if count > 1] == []


def test_every_folder_of_the_examples_is_tested() -> None:
    folders = {folder.name for folder in EXAMPLES.iterdir() if folder.is_dir()}
    # tests/backends run what is in robots/, tests/mission and tests/cli what is in store-room/
    assert folders - {"robots", "store-room"} == set(DOMAINS)


def test_there_are_as_many_sentences_as_promised() -> None:
    groups = {d: Counter(sentence["group"] for sentence in sentences_of(d)) for d in DOMAINS}
    assert groups["vineyard"]["navigation"] >= 200
    assert groups["vineyard"]["generic"] >= 300
    assert groups["warehouse"].total() >= 100
    assert groups["kitchen"].total() >= 100


def test_the_page_about_the_examples_gives_the_right_counts() -> None:
    page = (EXAMPLES / "README.md").read_text(encoding="utf-8")
    words = " ".join(page.split())
    vineyard, warehouse, kitchen = (len(sentences_of(domain)) for domain in DOMAINS)
    assert f"{vineyard} sentences in the vineyard" in words
    assert f"{warehouse} in the warehouse, {kitchen} in the kitchen" in words


def test_ids_and_utterances_are_unique() -> None:
    every = [sentence for domain in DOMAINS for sentence in sentences_of(domain)]
    assert len({sentence["id"] for sentence in every}) == len(every)
    assert len({sentence["utterance"].lower() for sentence in every}) == len(every)


def test_the_sentences_are_not_a_few_templates_filled_in() -> None:
    frames = {frame_of(sentence) for domain in DOMAINS for sentence in sentences_of(domain)}
    assert len(frames) >= 300


def test_every_pattern_is_said_in_every_domain() -> None:
    for domain in DOMAINS:
        said = {name for one in sentences_of(domain) for name in one["pattern"].split("+")}
        assert said == PATTERNS, domain


@each_domain
def test_formulas_use_landmarks_only_and_each_is_referred_to(domain: str) -> None:
    for sentence in sentences_of(domain):
        referred = {one["symbol"] for one in sentence["referring_expressions"]}
        for reading in ("literal", "formula"):
            assert atoms_of(parse(sentence[reading])) == referred, sentence["id"]
        assert referred <= set(landmarks_of(domain)), sentence["id"]


@each_domain
def test_a_referring_expression_is_a_piece_of_the_utterance(domain: str) -> None:
    for sentence in sentences_of(domain):
        for one in sentence["referring_expressions"]:
            piece = sentence["utterance"][one["start"] : one["end"]]
            assert piece == one["text"], sentence["id"]


@each_domain
def test_navigation_is_about_places_and_five_patterns(domain: str) -> None:
    for sentence in sentences_of(domain):
        assert sentence["group"] in ("navigation", "generic"), sentence["id"]
        if sentence["group"] == "navigation":
            assert set(sentence["pattern"].split("+")) <= NAVIGATION, sentence["id"]
            for one in sentence["referring_expressions"]:
                symbol = landmarks_of(domain)[one["symbol"]]
                assert symbol.type is LandmarkType.LOCATION, sentence["id"]


@each_domain
def test_every_executable_formula_can_be_satisfied(domain: str) -> None:
    for sentence in sentences_of(domain):
        assert satisfiable(parse(sentence["formula"])), sentence["id"]


@each_domain
def test_the_executable_reading_asks_for_less_unless_its_trigger_is_another(domain: str) -> None:
    # In a prompt reaction or bound delay to a condition that persists, the trigger is the change.
    for sentence in sentences_of(domain):
        if not {"prompt reaction", "bound delay"} & set(sentence["pattern"].split("+")):
            literal, executable = parse(sentence["literal"]), parse(sentence["formula"])
            assert implies(literal, executable), sentence["id"]


@each_domain
def test_the_traces_are_accepted_and_rejected_as_said(domain: str) -> None:
    for sentence in sentences_of(domain):
        literal = parse(sentence["literal"])
        accepted, rejected = traces_of(sentence, "accepted"), traces_of(sentence, "rejected")
        assert all(holds(literal, trace) for trace in accepted), sentence["id"]
        assert not any(holds(literal, trace) for trace in rejected), sentence["id"]
        for trace in (*accepted, *rejected):
            assert frozenset().union(*trace) <= set(landmarks_of(domain)), sentence["id"]


@each_domain
def test_at_least_every_fifth_sentence_has_a_trace_of_each_kind(domain: str) -> None:
    sentences = sentences_of(domain)
    with_both = [
        one for one in sentences if traces_of(one, "accepted") and traces_of(one, "rejected")
    ]
    assert 5 * len(with_both) >= len(sentences)
