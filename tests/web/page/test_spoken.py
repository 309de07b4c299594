import re
from xml.etree import ElementTree as ET

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from hypothesis import given
from hypothesis import strategies as st

from plainspoken.language.example import examples
from plainspoken.language.extracted import ReferringExpression
from plainspoken.logic.syntax import parse
from plainspoken.pipeline import bundled, open_site, understand
from plainspoken.web.page.spoken import marked, pictured

FOLDER = bundled("vineyard")
SITE = open_site(FOLDER / "domain.pddl", FOLDER / "problem.pddl", FOLDER / "landmarks.json")


def test_each_piece_is_marked_with_what_it_is_understood_as() -> None:
    found = understand("Clear line 2 & visit <line 3>", SITE)
    told = marked(found.utterance, found.referring_expressions, SITE.landmarks)
    root = ET.fromstring(told)  # noqa: S314 - our own words
    meant = {b.findtext("mark"): b.findtext("small") for b in root.iter("button")}
    assert meant["line 3"] == "line 3"
    assert "line 2 is cleared" in meant.values()


@given(st.text(max_size=30), st.data())
def test_no_letter_of_a_sentence_is_lost_or_told_twice(text: str, data: st.DataObject) -> None:
    spans = data.draw(
        st.lists(st.tuples(st.integers(0, len(text)), st.integers(0, len(text))), max_size=4)
    )
    expressions = [ReferringExpression(text[a:b], a, b, "full_b", 1.0) for a, b in spans if a < b]
    told = marked(text, expressions, SITE.landmarks)
    without_meaning = re.sub(r"<small.*?</small>", "", told)
    plain = re.sub(r"<[^>]*>", "", without_meaning)
    for sign, code in (
        ("<", "&lt;"),
        (">", "&gt;"),
        ('"', "&quot;"),
        ("'", "&#x27;"),
        ("&", "&amp;"),
    ):
        plain = plain.replace(code, sign)
    assert plain == text


def test_a_picture_of_each_example_says_in_words_what_it_shows() -> None:
    formula = parse("F cleared_l2 & G(full_b -> !robot_at_rob_l3)")
    found = examples(formula, SITE.landmarks)
    told = pictured(found, SITE.landmarks)
    assert told is not None
    root = ET.fromstring(told)  # noqa: S314 - our own picture
    titles = {each.text for each in root.iter("title")}
    assert titles == {each.english for each in (*found.accepted, *found.rejected)}
    assert "would do" in told
    assert "would not do" in told


def test_a_formula_that_speaks_of_too_much_has_no_picture() -> None:
    formula = parse(" & ".join(f"F cleared_l{i} & F ripe_g{i} & F unripe_g{i}" for i in range(4)))
    assert pictured(examples(formula, SITE.landmarks), SITE.landmarks) is None
