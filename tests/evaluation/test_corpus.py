from pathlib import Path
from typing import Any

import pytest
from tests.evaluation.small_corpus import LANDMARKS, ROWS, small_rows, written

from plainspoken.automata.equivalence import equivalent
from plainspoken.errors import FormulaSyntaxError, InputFileError
from plainspoken.evaluation.corpus import (
    NOT_GIVEN,
    brings_landmarks,
    parse_published,
    pattern_name,
    read_corpus,
)
from plainspoken.logic.syntax import parse
from plainspoken.world.landmark import read_landmarks

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"


def test_a_row_holds_both_readings_and_where_each_symbol_is_mentioned(tmp_path: Path) -> None:
    one, two, three = small_rows(tmp_path)
    assert (one.literal, one.executable) == (parse("F hall"), parse("F hall"))
    assert two.mentions is not None
    assert [(each.start, each.end, each.symbol) for each in two.mentions] == [
        (0, 8, "hall"),
        (15, 24, "attic"),
    ]
    assert three.mentions is None


def test_a_row_of_a_published_set_has_the_landmarks_of_its_own_symbols(tmp_path: Path) -> None:
    published = {
        "utterance": "visit Blue Room 1 then blue room, never the red room",
        "symbols": {"blue room": "blue", "Blue Room 1": "blue_1", "red room": "red"},
        "pattern": "Sequenced Visit",
        "literal": "F(blue_1 & F(blue)) & G(!red)",
        "license": "MIT",
    }
    path = written(tmp_path / "c.jsonl", [published])
    assert brings_landmarks(path)
    (row,) = read_corpus(path)
    assert (row.id, row.pattern, row.group, row.executable) == ("1", "sequenced visit", None, None)
    assert [one.description for one in row.landmarks] == ["blue room", "Blue Room 1", "red room"]
    assert row.mentions is not None
    assert [(each.text, each.symbol) for each in row.mentions] == [
        ("Blue Room 1", "blue_1"),
        ("blue room", "blue"),
        ("red room", "red"),
    ]


@pytest.mark.parametrize("text", ["(a) M (b)", "a M (b)", "(a)M b", " a M b "])
def test_strong_release_is_read_where_it_is_outermost(text: str) -> None:
    assert equivalent(parse_published(text), parse("(a R b) & F a"))


@pytest.mark.parametrize("text", ["(a) & a M b", "F a M b", "(a | (b) M (c))", "(a) M", "M (a)"])
def test_strong_release_elsewhere_is_refused(text: str) -> None:
    with pytest.raises(FormulaSyntaxError):
        parse_published(text)


def test_patterns_are_written_one_way() -> None:
    assert pattern_name("Bound Delay") == "bound delay"
    assert pattern_name("visit+global avoidance") == "visit & global avoidance"
    assert pattern_name("visit & visit") == "visit"


@pytest.mark.parametrize("domain", ["vineyard", "warehouse", "kitchen"])
def test_the_sentences_of_the_examples_can_be_read(domain: str) -> None:
    folder = EXAMPLES / domain
    landmarks = read_landmarks(folder / "landmarks.json")
    rows = read_corpus(folder / "sentences.jsonl", landmarks)
    assert len(rows) >= 100
    assert all(row.pattern != NOT_GIVEN for row in rows)


@pytest.mark.parametrize(
    ("change", "field", "what"),
    [
        ({"utterance": None}, "utterance", "missing"),
        ({"utterance": 3}, "utterance", "expected a text"),
        ({"literal": None}, "literal", "missing"),
        ({"literal": "F hall &"}, "literal", "not an LTLf formula"),
        ({"formula": "F garden"}, "formula", "no landmark is called garden"),
        ({"id": ["one"]}, "id", "text or a number"),
        ({"symbols": {}}, "symbols", "expected an object"),
        ({"symbols": {"the hall": "F"}}, "symbols.the hall", "cannot be a symbol"),
        ({"referring_expressions": {}}, "referring_expressions", "list"),
        (
            {"referring_expressions": [{"text": "the shed", "symbol": "hall"}]},
            "referring_expressions[0].text",
            "does not say",
        ),
        (
            {"referring_expressions": [{"text": "the hall", "start": 5, "symbol": "hall"}]},
            "referring_expressions[0]",
            "at 5 the utterance says",
        ),
        (
            {"referring_expressions": [{"text": "the hall", "symbol": "garden"}]},
            "referring_expressions[0].symbol",
            "no landmark",
        ),
        ({"traces": {"rejected": [[["hall"]]]}}, "traces.rejected[0]", "accepts this trace"),
        ({"traces": {"accepted": [[[]]]}}, "traces.accepted[0]", "rejects this trace"),
        ({"traces": {"accepted": ["hall"]}}, "traces.accepted[0]", "list of instants"),
    ],
)
def test_a_row_that_cannot_be_used_is_named_by_file_line_and_field(
    change: dict[str, Any], field: str, what: str, tmp_path: Path
) -> None:
    path = written(tmp_path / "c.jsonl", [ROWS[1], {**ROWS[0], **change}])
    with pytest.raises(InputFileError, match=what) as caught:
        read_corpus(path, LANDMARKS)
    assert (caught.value.path, caught.value.line, caught.value.field) == (path, 2, field)


def test_two_rows_with_one_id_are_refused(tmp_path: Path) -> None:
    with pytest.raises(InputFileError, match="stands twice") as caught:
        read_corpus(written(tmp_path / "c.jsonl", [ROWS[0], ROWS[0]]), LANDMARKS)
    assert caught.value.line == 2


def test_a_row_without_symbols_asks_for_landmarks(tmp_path: Path) -> None:
    with pytest.raises(InputFileError, match="no landmarks") as caught:
        read_corpus(written(tmp_path / "c.jsonl"))
    assert "--landmarks" in str(caught.value)


@pytest.mark.parametrize(("text", "what"), [("{", "not JSON"), ("[]", "object"), ("", "no sen")])
def test_a_file_that_is_no_corpus_is_refused(text: str, what: str, tmp_path: Path) -> None:
    path = tmp_path / "c.jsonl"
    path.write_text(text)
    with pytest.raises(InputFileError, match=what):
        read_corpus(path, LANDMARKS)
