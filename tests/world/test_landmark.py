"""Landmarks files in: the contract's form, each fault with its field or line."""

import json
from collections.abc import Callable
from pathlib import Path

import pytest

from plainspoken.errors import InputFileError
from plainspoken.world.domain import Problem
from plainspoken.world.landmark import (
    Landmark,
    LandmarkType,
    landmarks_from_json,
    landmarks_to_json,
    read_landmarks,
)

EXAMPLES = Path(__file__).resolve().parents[2] / "examples"
GOOD = {
    "robot_at_rob_l0": {"description": "line 0", "type": "location", "names": ["row 0"]},
    "full_b": {"description": "the box is full", "type": "condition"},
    "harvest_grape_executed": {"description": "to harvest a grape", "type": "action"},
}


def test_a_landmark_has_an_id_a_description_a_type_and_names() -> None:
    landmarks = landmarks_from_json(GOOD, "l.json")
    assert list(landmarks) == list(GOOD)
    assert landmarks["robot_at_rob_l0"] == Landmark(
        "robot_at_rob_l0", "line 0", LandmarkType.LOCATION, ("row 0",)
    )
    assert landmarks["robot_at_rob_l0"].phrases == ("line 0", "row 0")
    assert landmarks["full_b"].phrases == ("the box is full",)


def test_places_and_conditions_persist_and_actions_do_not() -> None:
    assert [one.persists for one in landmarks_from_json(GOOD, "l.json").values()] == [
        True,
        True,
        False,
    ]


def test_landmarks_go_to_json_and_come_back() -> None:
    assert landmarks_to_json(landmarks_from_json(GOOD, "l.json")) == GOOD


@pytest.mark.parametrize(
    "path", sorted(EXAMPLES.glob("*/landmarks.json")), ids=lambda path: path.parent.name
)
def test_the_landmarks_of_every_example_can_be_read(path: Path) -> None:
    assert read_landmarks(path)


def test_every_landmark_of_the_vineyard_names_something_in_it(vineyard: Problem) -> None:
    assert len(read_landmarks(EXAMPLES / "vineyard" / "landmarks.json", vineyard)) > 40


def test_white_space_in_a_description_is_single_spaces_and_further_fields_are_read_over() -> None:
    document = {"full_b": {"description": " the box\n is  full ", "type": "condition", "x": 1}}
    assert landmarks_from_json(document, "l.json")["full_b"].description == "the box is full"


ENTRY = {"description": "the box is full", "type": "condition"}


@pytest.mark.parametrize(
    ("document", "field", "what"),
    [
        ([], None, "expected an object with an entry for each landmark"),
        ({}, None, "expected an object with an entry for each landmark"),
        ("full_b", None, "expected an object with an entry for each landmark"),
        (None, None, "expected an object with an entry for each landmark"),
        ({"full-b": ENTRY}, "full-b", "'full-b' cannot be a symbol"),
        ({"GF": ENTRY}, "GF", "'GF' cannot be a symbol"),
        ({"": ENTRY}, "", "'' cannot be a symbol"),
        ({"full_b": "the box is full"}, "full_b", "expected an object with description and type"),
        ({"full_b": {"type": "condition"}}, "full_b.description", "a description is missing"),
        ({"full_b": {**ENTRY, "description": " "}}, "full_b.description", "is missing"),
        ({"full_b": {**ENTRY, "description": 3}}, "full_b.description", "is missing"),
        ({"full_b": {"description": "full"}}, "full_b.type", "expected 'location', "),
        ({"full_b": {**ENTRY, "type": "place"}}, "full_b.type", "expected 'location', "),
        ({"full_b": {**ENTRY, "type": ["action"]}}, "full_b.type", "expected 'location', "),
        ({"full_b": {**ENTRY, "names": "full"}}, "full_b.names", "expected a list of texts"),
        ({"full_b": {**ENTRY, "names": [""]}}, "full_b.names", "expected a list of texts"),
        ({"full_b": {**ENTRY, "names": [1]}}, "full_b.names", "expected a list of texts"),
    ],
)
def test_a_document_that_is_none_is_refused_with_the_field(
    document: object, field: str | None, what: str
) -> None:
    with pytest.raises(InputFileError) as caught:
        landmarks_from_json(document, "l.json")
    assert what in caught.value.what
    assert caught.value.field == field


@pytest.fixture
def refused(tmp_path: Path) -> Callable[[bytes], InputFileError]:
    def read(content: bytes) -> InputFileError:
        path = tmp_path / "landmarks.json"
        path.write_bytes(content)
        with pytest.raises(InputFileError) as caught:
            read_landmarks(path)
        assert str(path) in str(caught.value)
        return caught.value

    return read


def test_what_is_no_json_is_refused_with_line_and_column(
    refused: Callable[[bytes], InputFileError],
) -> None:
    error = refused(b'{"full_b":\n  {"description": }}')
    assert (error.line, error.column) == (2, 19)


@pytest.mark.parametrize(
    ("content", "what"),
    [
        (b"", "not JSON: Expecting value"),
        (b"\xff\xfe\x00", "not a text file in UTF-8"),
        (b"[" * 100_000, "not JSON: nested too deep"),
    ],
    ids=["empty", "binary", "deep"],
)
def test_what_is_no_text_of_json_is_refused(
    refused: Callable[[bytes], InputFileError], content: bytes, what: str
) -> None:
    assert refused(content).what == what


def test_an_entry_that_stands_twice_is_refused(
    refused: Callable[[bytes], InputFileError],
) -> None:
    entry = json.dumps(ENTRY)
    error = refused(f'{{"full_b": {entry}, "full_b": {entry}}}'.encode())
    assert (error.what, error.field) == ("an entry stands twice", "full_b")


def test_a_file_that_begins_with_a_byte_order_mark_is_read(tmp_path: Path) -> None:
    path = tmp_path / "landmarks.json"
    path.write_bytes(b"\xef\xbb\xbf" + json.dumps(GOOD).encode())
    assert len(read_landmarks(path)) == 3


def test_a_missing_file_and_a_folder_are_refused(tmp_path: Path) -> None:
    for path in (tmp_path / "none.json", tmp_path):
        with pytest.raises(InputFileError, match="cannot read the file"):
            read_landmarks(path)


def test_with_a_problem_an_id_of_nothing_is_refused_with_what_was_meant(
    vineyard: Problem,
) -> None:
    with pytest.raises(InputFileError) as caught:
        landmarks_from_json({"full_box": ENTRY}, "l.json", vineyard)
    assert caught.value.field == "full_box"
    assert caught.value.hint is not None
    assert "full_b" in caught.value.hint
