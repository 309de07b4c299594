from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.mission.template import UnfilledError, filled, meets, paths_in, value_at

VALUES = {"to": "l1", "h": "rob"}
OBJECTS = {"l1": {"x": 3.5, "pose": {"yaw": 0}, "stops": ["a", "b"]}}


@pytest.mark.parametrize(
    ("template", "expected"),
    [
        ("{to}", "l1"),
        ("driving to {to}", "driving to l1"),
        ("{to.x}", 3.5),
        ("x = {to.x}", "x = 3.5"),
        ("{to.stops.1}", "b"),
        ("{to.stops.-2}", "a"),
        ({"a": ["{h}", {"b": "{to.pose.yaw}"}], "c": 7}, {"a": ["rob", {"b": 0}], "c": 7}),
        ("no {placeholder here", "no {placeholder here"),
        (True, True),
        (None, None),
    ],
)
def test_a_template_takes_values_as_they_are_and_writes_them_into_longer_texts(
    template: Any, expected: Any
) -> None:
    assert filled(template, VALUES, OBJECTS) == expected


@pytest.mark.parametrize(
    "template", ["{from}", "{to.y}", "{to.stops.2}", "{to.stops.-3}", "{h.x}", "{to.x.y}"]
)
def test_what_there_is_not_is_named(template: str) -> None:
    with pytest.raises(UnfilledError) as caught:
        filled(template, VALUES, OBJECTS)
    assert caught.value.path == template.strip("{}")


@given(st.recursive(st.text() | st.integers() | st.booleans(), st.lists, max_leaves=8))
def test_a_template_that_names_nothing_is_its_own_value(template: Any) -> None:
    if not list(paths_in(template)):
        assert filled(template, {}) == template


@pytest.mark.parametrize(
    ("expected", "met"),
    [
        ({}, True),
        ({"state": "done"}, True),
        ({"state": ["failed", "done"]}, True),
        ({"state": ["failed"]}, False),
        ({"level": {">": 0.2, "<=": 0.5}}, True),
        ({"level": {">": 0.5}}, False),
        ({"state": {">": 3}}, False),
        ({"state": {"not": "failed"}}, True),
        ({"ok": True}, True),
        ({"ok": 1}, False),
        ({"count": True}, False),
        ({"result.0.kind": "ripe"}, True),
        ({"nothing": "here"}, False),
        ({"state": "done", "level": {"<": 0.1}}, False),
    ],
)
def test_a_result_meets_what_is_expected_of_it(expected: dict[str, Any], met: object) -> None:
    result = {
        "state": "done",
        "level": 0.5,
        "ok": True,
        "count": 1,
        "result": [{"kind": "ripe"}],
    }
    assert meets(result, expected) is met


def test_a_path_leads_through_mappings_and_lists() -> None:
    assert value_at("a.1.b", {"a": [0, {"b": "found"}]}) == "found"
