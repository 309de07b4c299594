"""A robots' file that is wrong is refused before anything moves: file, line, what was expected."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.backends.activities.errands import GRASP, PROBLEM, SERVICES, VIA, file_of, robot_of
from tests.stores import store_in

from plainspoken.backends.activities.configuration import robot_from
from plainspoken.errors import InputFileError

GOOD = file_of('{call: drive, with: {to: "{to}"}}')


def refused(text: str, folder: Path) -> InputFileError:
    with pytest.raises(InputFileError) as caught, robot_of(text, folder):
        pass
    assert caught.value.path == folder / "robots.yaml"
    return caught.value


def test_a_good_file_is_read(tmp_path: Path) -> None:
    with robot_of(GOOD, tmp_path):
        pass


def swap(old: str, new: str) -> Callable[[str], str]:
    def swapped(text: str) -> str:
        assert old in text
        return text.replace(old, new)

    return swapped


def activity(text: str) -> Callable[[str], str]:
    return lambda _: file_of(text)


def more(text: str) -> Callable[[str], str]:
    return lambda good: good + text


WRONG: dict[str, tuple[Callable[[str], str], str, str]] = {
    # what is wrong: (the change, the text that the named line holds, what is said)
    "a top-level key": (swap("services:", "service:"), "service:", "no key 'service'.*'services'"),
    "no services": (swap(SERVICES, ""), "actions:", "'services' is missing"),
    "no via": (swap(f"arm: {{{VIA}, script: arm}}", "arm: {}"), "arm:", "'via' is missing"),
    "an adapter": (swap(VIA, "via: htttp"), "htttp", "'htttp' is not known.*'http'"),
    "an adapter's key": (swap("script: arm", "skript: arm"), "arm:", "no key 'skript'.*'script'"),
    "an adapter elsewhere": (swap(VIA, "via: no.such.thing"), "no.such", "no adapter 'no.such"),
    "a kind of value": (swap("script: arm", "limit: soon, script: arm"), "soon", "a number"),
    "no such action": (swap("  go:", "  goo:"), "  goo:", "no action 'goo'.*'go'"),
    "an action missing": (swap(GRASP, ""), "actions:", "not here: grasp"),
    "no activity": (swap("do:\n", "does:\n"), "does:", "no key 'does'.*'do'"),
    "no such service": (activity("{call: drvie}"), "drvie", "no service 'drvie'.*'drive'"),
    "a field of a service": (activity("{call: drive, with: {colour: red}}"), "colour", "'colour'"),
    "a placeholder": (activity('{call: drive, with: {a: "{too}"}}'), "{too}", r"no \{too\}.*'to'"),
    "a placeholder in words": (activity('{call: drive, as: "to {it}"}'), "{it}", r"no \{it\}"),
    "what is not known": (activity('{call: drive, with: {a: "{to.x}"}}'), "{to.x}", "no 'x' is"),
    "two kinds": (activity("{call: drive, if: []}"), "call", "an activity is one of.*call and if"),
    "no kind": (activity("{limit: 3}"), "limit", "an activity is one of.*only limit"),
    "nothing to do": (activity("sequence: []"), "sequence", "nothing in it"),
    "no list": (activity("sequence: {call: drive}"), "sequence", "expected a list, got a mapping"),
    "no mapping": (activity("drive"), "drive", "expected a mapping, got 'drive'"),
    "a limit": (activity("{call: drive, limit: -1}"), "limit", "greater than 0, got -1"),
    "a key of a kind": (activity("{call: drive, limt: 1}"), "limt", "no key 'limt'.*'limit'"),
    "needs": (activity("parallel: [{call: arm}]\nneeds: some"), "needs", "'some' is not known"),
    "tries missing": (activity("retry: {call: arm}"), "do:", "'times' is missing"),
    "tries": (activity("retry: {call: arm}\ntimes: 1"), "times", "at least 2, got 1"),
    "a predicate": (activity('if: ["att {to}"]'), "att", "no predicate 'att'.*'at'"),
    "arguments": (activity('if: ["at"]'), "if", r"1 arguments: \?p"),
    "an object": (activity('if: ["at attic"]'), "attic", "'attic' fits no 'at'.*kitchen"),
    "a comparison": (activity("{call: arm, when: {a: {'=>': 1}}}"), "=>", "no key '=>'"),
    "an outcome": (swap("when: {held: true}, ", ""), "held {t}", "'when' is missing"),
    "no outcomes": (
        lambda _: file_of("{call: arm}").split("    outcomes")[0],
        "grasp",
        "'grasp' may turn out in several ways",
    ),
    "an object's name": (more("objects: {attic: {x: 1}}\n"), "attic", "no object 'attic'"),
    "a fact sensed": (
        more('facts:\n  "inside {p}": {call: look, when: {a: 1}}\n'),
        "inside",
        "no predicate 'inside'",
    ),
    "how it is seen": (more('facts:\n  "at {p}": {call: look}\n'), "at {p}", "'when' is missing"),
    "what tells all": (more("state: {call: look}\n"), "state", "'atoms' is missing"),
    "a key twice": (more("actions: {}\n"), "actions: {}", "stands twice"),
    "no YAML": (more("facts: [\n"), "", "not YAML"),
}


@pytest.mark.parametrize("what", WRONG)
def test_what_is_wrong_is_named_with_its_line(what: str, tmp_path: Path) -> None:
    change, place, said = WRONG[what]
    text = change(GOOD)
    error = refused(text, tmp_path)
    assert re.search(said, f"{error.what} {error.hint}", re.DOTALL), str(error)
    assert error.line is not None
    assert place in text.splitlines()[min(error.line, len(text.splitlines())) - 1], str(error)
    assert f"robots.yaml:{error.line}:" in str(error)


@pytest.mark.parametrize(("text", "said"), [("", "empty"), ("- a\n- b\n", "expected a mapping")])
def test_a_file_that_holds_nothing_of_the_kind_is_refused(
    text: str, said: str, tmp_path: Path
) -> None:
    assert said in refused(text, tmp_path).what


def test_a_file_that_is_not_there_is_named(tmp_path: Path) -> None:
    nowhere = tmp_path / "nowhere.yaml"
    with (
        pytest.raises(InputFileError, match="cannot read"),
        store_in(tmp_path) as store,
        robot_from(nowhere, PROBLEM, store),
    ):
        pass


def test_yes_and_no_are_words_and_true_is_not(tmp_path: Path) -> None:
    text = GOOD.replace("script: arm", "script: yes")
    with robot_of(text, tmp_path):
        pass
    error = refused(GOOD.replace("script: arm", "script: true"), tmp_path)
    assert "expected a text, got 'true'" in error.what


def test_where_something_is_sensed_an_open_action_needs_no_outcomes(tmp_path: Path) -> None:
    grasp = GRASP.split("    outcomes")[0]
    facts = 'facts:\n  "held {t}": {call: look, when: {in_hand: "{t}"}}\n'
    with robot_of(GOOD.replace(GRASP, grasp) + facts, tmp_path):
        pass
