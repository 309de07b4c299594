"""The paper's experiment on monitoring: plans, the moment of a question, and scores by hand."""

import json
from pathlib import Path
from random import Random

import pytest
from click.testing import CliRunner

from plainspoken.cli.monitoring import GOALS, monitoring
from plainspoken.evaluation.monitoring import (
    QUESTIONS,
    Category,
    Run,
    Situation,
    Tally,
    answered,
    by_distance,
    determinised,
    falls_at,
    read_back,
    score,
    situations,
)
from plainspoken.evaluation.monitoring_report import markdown, picture
from plainspoken.logic.syntax import parse
from plainspoken.pipeline import Site, bundled, find_policy, open_site
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.questions.moment import Moment, lexicon_of
from plainspoken.questions.question import question_of
from plainspoken.world.event import MissionAccepted


@pytest.fixture(scope="module")
def kitchen() -> tuple[Site, Policy]:
    folder = bundled("kitchen")
    site = open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")
    ending = find_policy(site.problem, parse(GOALS["kitchen"]))
    assert isinstance(ending, Solved)
    return site, ending.policy


def _situation(category: Category, at: int) -> Situation:
    states = tuple(frozenset(each.split("+")) for each in ("a", "a+b", "b", "b+c"))
    static = frozenset({"s"})
    return Situation("x", "d", category, False, "?", at, states, static, ())


def test_a_plan_has_one_outcome_a_node_and_ends(kitchen: tuple[Site, Policy]) -> None:
    for seed in range(20):
        plan = determinised(kitchen[1], Random(seed))
        assert [len(node.successors) for node in plan.nodes[:-1]] == [1] * (len(plan.nodes) - 1)
        assert plan.nodes[-1].action is None


def test_a_question_falls_before_the_end_and_more_often_late_than_at_first() -> None:
    fallen = [falls_at(10, Random(seed)) for seed in range(500)]
    assert set(fallen) <= set(range(1, 10))
    assert fallen.count(1) < fallen.count(3)
    assert [falls_at(2, Random(seed)) for seed in range(5)] == [1] * 5


def test_the_papers_metric_compares_one_set_with_every_state() -> None:
    run = Run(_situation(Category.PAST, 2), "", {1: frozenset({"a"}), 2: frozenset({"b"})})
    # S1 = |ab| / 2, S2 = |b| / 2; C1 = 2/2, C2 = 1/1
    assert score(run, timed=False, static=False).soundness == pytest.approx(0.75)
    assert score(run, timed=False, static=False).completeness == pytest.approx(1.0)
    # With the fluent that never changes C1 = 2/3, C2 = 1/2.
    assert score(run, timed=False, static=True).completeness == pytest.approx((2 / 3 + 1 / 2) / 2)


def test_the_time_indexed_metric_compares_what_is_said_of_an_instant_with_it() -> None:
    run = Run(_situation(Category.FUTURE, 1), "", {2: frozenset({"b", "c"}), 3: frozenset({"c"})})
    found = score(run, timed=True, static=False)
    assert found.soundness == pytest.approx((1 / 2 + 1) / 2)
    assert found.completeness == pytest.approx((0 + 1 + 1 / 2) / 3)


def test_what_is_said_is_counted_by_its_distance_from_now() -> None:
    run = Run(_situation(Category.FUTURE, 1), "", {2: frozenset({"b", "c"})})
    assert by_distance([run], timed=True) == {
        0: Tally(0, 0, 2),
        1: Tally(1, 1, 0),
        2: Tally(0, 0, 2),
    }


def test_our_claims_are_sound_at_every_instant(kitchen: tuple[Site, Policy]) -> None:
    for situation in situations("kitchen", *kitchen, runs=8, seed=3):
        run = answered(situation, lambda: 0.0)
        assert score(run, timed=True, static=True).soundness in (1.0, None), run.text
        assert 1 <= situation.at < len(situation.states)


def test_every_question_of_the_experiment_is_of_its_category(kitchen: tuple[Site, Policy]) -> None:
    accepted = next(situations("kitchen", *kitchen, runs=1, seed=0)).entries[0].event
    assert isinstance(accepted, MissionAccepted)
    kinds = {Category.PRESENT: {"now", "state", "progress"}, Category.PAST: {"past"}}
    for category, questions in QUESTIONS.items():
        for text in questions:
            kind = question_of(text, lexicon_of(accepted)).kind
            assert str(kind) in kinds.get(category, {"future"}), text


def test_a_reply_is_scored_by_what_it_states(kitchen: tuple[Site, Policy]) -> None:
    situation = next(situations("kitchen", *kitchen, runs=1, seed=1))
    lexicon = Moment(situation.entries).lexicon
    run = read_back(situation, "The fridge is open and the soup is served.", lexicon)
    true = "open fridge" in situation.states[situation.at]
    assert run.said == {"open fridge", "served soup"}
    assert score(run, timed=True, static=False).soundness == pytest.approx(0.5 if true else 0.0)


def test_the_page_and_the_picture_show_both_metrics(kitchen: tuple[Site, Policy]) -> None:
    falls = situations("kitchen", *kitchen, runs=1, seed=0)
    runs = [answered(each, lambda: 0.0) for each in falls]
    page = markdown({"claims": runs}, "caption")
    assert "## The paper's metric" in page
    assert "## Time-indexed, without fluents that never change" in page
    assert picture(runs, timed=True).startswith("<svg")


def test_a_batch_is_written_and_its_replies_are_scored(tmp_path: Path) -> None:
    asked = tmp_path / "requests.jsonl"
    base = ["--runs", "1"]
    assert CliRunner().invoke(monitoring, [*base, "--export-batch", str(asked)]).exit_code == 0
    requests = [json.loads(line) for line in asked.read_text().splitlines()]
    assert len(requests) == len(GOALS) * len(Category)
    said = {"choices": [{"message": {"content": "I'm working."}}]}
    replies = tmp_path / "replies.jsonl"
    replies.write_text(
        "".join(
            json.dumps({"custom_id": each["custom_id"], "response": {"body": said}}) + "\n"
            for each in requests
        )
    )
    out = tmp_path / "out"
    found = CliRunner().invoke(
        monitoring, [*base, "--import-batch", str(replies), "--out", str(out)]
    )
    assert found.exit_code == 0, found.output
    assert len((out / "runs.jsonl").read_text().splitlines()) == len(requests)
