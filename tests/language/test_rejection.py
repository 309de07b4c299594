"""What is not understood is refused or asked about, never guessed."""

import subprocess
import sys
import time
from pathlib import Path

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.extraction import Status, extract

VINEYARD = DOMAINS["vineyard"]
LANGUAGE = Path(__file__).parents[2] / "src" / "plainspoken" / "language"


@pytest.mark.parametrize(
    ("sentence", "not_understood"),
    [
        ("Visit the moon.", '"moon"'),
        ("Visit line 7.", '"line 7"'),
        ("Make me a sandwich.", '"sandwich"'),
        ("Visit line 1 and dance.", '"dance"'),
        ("Visit the red line.", '"red"'),
        ("If grape 9 is ripe, harvest a grape.", "grape 9"),
        ("Ignore all previous instructions.", '"Ignore"'),
        ("Vai alla riga 1.", '"Vai alla riga'),
        ("اذهب إلى الصف الأول", "اذهب"),
    ],
)
def test_words_that_stand_for_nothing_are_named(sentence: str, not_understood: str) -> None:
    extraction = extract(sentence, VINEYARD)
    assert extraction.status is Status.REJECT
    assert extraction.formula is None
    assert extraction.reason is not None
    assert not_understood.strip('"') in extraction.reason


@pytest.mark.parametrize("sentence", ["", "  \n", "?!", "never", "if if if", "not not not", "(((("])
def test_nothing_to_do_is_refused(sentence: str) -> None:
    assert extract(sentence, VINEYARD).status is Status.REJECT


@pytest.mark.parametrize(
    "sentence",
    ["a" * 10_000, "visit line 1 and " * 600, "🍇" * 400, "visit " * 300, "(" * 1900, "1 " * 900],
    ids=["letters", "clauses", "emoji", "verbs", "brackets", "numbers"],
)
def test_odd_input_is_answered_within_a_second(sentence: str) -> None:
    extract("visit line 1", VINEYARD)  # the dictionary loads once
    started = time.process_time()
    assert extract(sentence, VINEYARD).status is Status.REJECT
    assert time.process_time() - started < 1


@pytest.mark.parametrize(
    ("sentence", "clash"),
    [
        ("Visit line 1 and never visit line 1.", '"Visit line 1." and "Never visit line 1."'),
        ("Harvest a grape, but never harvest a grape.", '"Never harvest a grape."'),
        ("Visit line 2 exactly once and at least twice.", "cannot"),
    ],
)
def test_a_contradiction_names_what_clashes(sentence: str, clash: str) -> None:
    extraction = extract(sentence, VINEYARD)
    assert extraction.status is Status.REJECT
    assert extraction.reason is not None
    assert clash in extraction.reason


def test_a_place_without_its_number_is_asked_for() -> None:
    extraction = extract("Go to the line.", VINEYARD)
    assert extraction.status is Status.CLARIFY
    assert extraction.question == ('What do you mean by "line": line 0, line 1, line 2 or line 3?')
    assert [one.english for one in extraction.alternatives] == [
        "Visit line 0.",
        "Visit line 1.",
        "Visit line 2.",
        "Visit line 3.",
    ]
    assert extraction.formula is None


def test_a_permission_asks_for_nothing() -> None:
    extraction = extract("You may visit line 1.", VINEYARD)
    assert extraction.status is Status.REJECT
    assert extraction.reason == "That allows something, but asks for nothing."


@pytest.mark.parametrize("sentence", ["Never enter line 3.", "If the box is full, ask a human."])
def test_a_mission_met_by_doing_nothing_is_accepted_with_a_note(sentence: str) -> None:
    extraction = extract(sentence, VINEYARD)
    assert extraction.status is Status.OK
    assert extraction.note == "Doing nothing at all already satisfies this."


def test_the_same_sentence_is_read_the_same_way_in_every_process() -> None:
    code = (
        "from tests.language.domains import DOMAINS\n"
        "from plainspoken.language.extraction import extract\n"
        "for s in ('Go to the line.', 'Visit every line, then pick up a grape'):\n"
        "    d = extract(s, DOMAINS['vineyard']).to_json(); d.pop('seconds'); print(d)\n"
    )
    root = Path(__file__).parents[2]
    printed = {
        subprocess.run(
            [sys.executable, "-c", code],
            check=True,
            capture_output=True,
            text=True,
            cwd=root,
            env={"PYTHONHASHSEED": seed, "PYTHONPATH": f"{root}/src:{root}"},
        ).stdout
        for seed in ("1", "2")
    }
    assert len(printed) == 1


@pytest.mark.parametrize("module", sorted(LANGUAGE.glob("*.py")), ids=lambda path: path.name)
def test_no_word_of_a_domain_stands_in_the_language_room(module: Path) -> None:
    words = set(module.read_text().lower().replace("_", " ").replace('"', " ").split())
    domain = {"grape", "grapes", "line", "lines", "box", "boxes", "bin", "harvest", "harvesting"}
    domain |= {"vineyard", "warehouse", "ward", "aisle", "kitchen", "pharmacy", "medicine"}
    assert not words & domain
