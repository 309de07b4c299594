import pytest

from plainspoken.language.correction import corrected
from plainspoken.language.extracted import Status
from plainspoken.language.extraction import by_rules
from plainspoken.language.sentence import Sentence
from plainspoken.logic.syntax import unparse
from plainspoken.pipeline import Site, bundled, open_site


@pytest.fixture(scope="module")
def site() -> Site:
    folder = bundled("vineyard")
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


def test_another_symbol_takes_the_place_of_the_one_that_was_understood(site: Site) -> None:
    found = by_rules(Sentence.of("Visit line 1, then line 2", site.vocabulary))
    put_right = corrected(found, 1, "robot_at_rob_wh", site.vocabulary)
    assert put_right.status is Status.OK
    wanted = by_rules(Sentence.of("Visit line 1, then the warehouse", site.vocabulary))
    assert put_right.reading is not None
    assert wanted.reading is not None
    assert unparse(put_right.reading.formula) == unparse(wanted.reading.formula)
    assert put_right.reading.english == wanted.reading.english
    assert [each.symbol for each in put_right.referring_expressions] == [
        "robot_at_rob_l1", "robot_at_rob_wh",
    ]  # fmt: skip


def test_a_question_is_settled_by_a_correction(site: Site) -> None:
    found = by_rules(Sentence.of("Go to the line", site.vocabulary))
    assert found.status is Status.CLARIFY
    put_right = corrected(found, 0, "robot_at_rob_l3", site.vocabulary)
    assert put_right.status is Status.OK
    assert put_right.question is None
    assert put_right.formula is not None
    assert unparse(put_right.formula) == "F robot_at_rob_l3"


def test_a_correction_that_contradicts_the_rest_is_refused(site: Site) -> None:
    found = by_rules(Sentence.of("Visit line 1 but never visit line 2", site.vocabulary))
    place = [each.symbol for each in found.referring_expressions].index("robot_at_rob_l2")
    refused = corrected(found, place, "robot_at_rob_l1", site.vocabulary)
    assert refused.status is Status.REJECT
    assert refused.reason
