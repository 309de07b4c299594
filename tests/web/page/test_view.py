from collections.abc import Sequence
from dataclasses import replace
from datetime import UTC, datetime, timedelta

import pytest

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from tests.mission import store_room, two_robots

from plainspoken.automata.verdict import Verdict
from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import Status
from plainspoken.mission.simulator import Simulator, steering_from
from plainspoken.pipeline import Request, bundled, carry_out, find_policy, open_site
from plainspoken.planning.solver import Solved
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.moment import lexicon_of
from plainspoken.web.page import panels
from plainspoken.web.page.drawing import Drawing
from plainspoken.web.page.ground import Ground
from plainspoken.web.page.layout import Layout
from plainspoken.web.page.speech import Said, bubbles
from plainspoken.web.page.view import View, age
from plainspoken.world.event import ActionStarted, Entry, Event, MissionAccepted
from plainspoken.world.sense import Sense

FOLDER = bundled("vineyard")
SITE = open_site(FOLDER / "domain.pddl", FOLDER / "problem.pddl", FOLDER / "landmarks.json")
GOAL = parse("F cleared_l1 & G !robot_at_rob_l3")


@pytest.fixture(scope="module")
def entries() -> Sequence[Entry]:
    """A mission from its first entry to its last."""
    ending = find_policy(SITE.problem, GOAL)
    assert isinstance(ending, Solved)
    robot = Simulator(SITE.problem, steering=[steering_from("unripe g1", SITE.problem)])
    log: list[Entry] = []

    def record(instant: int, events: Sequence[Event]) -> Sequence[Entry]:
        new = [
            Entry(len(log) + i, f"2026-05-01T08:00:{len(log):02}+00:00", instant, event)
            for i, event in enumerate(events)
        ]
        log.extend(new)
        return new

    request = Request("m", GOAL, "Clear line 1 <b>now</b>, and stay out of line 3")
    return list(carry_out(SITE, request, ending.policy, robot, record))


def view(entries: Sequence[Entry], at: int | None = None) -> View:
    first = entries[0].event
    return View(entries, Drawing(Ground(lexicon_of(first), Layout())), at)  # type: ignore[arg-type]


def test_each_moment_of_the_log_is_shown_by_the_same_code(entries: Sequence[Entry]) -> None:
    for entry in entries:
        assert view(entries, entry.step).map == view(entries[: entry.step + 1]).map
        assert view(entries, entry.step).lines == view(entries[: entry.step + 1]).lines


def test_a_mission_runs_until_it_is_finished(entries: Sequence[Entry]) -> None:
    assert view(entries, 0).status is Status.PLANNING
    assert view(entries, 2).status is Status.RUNNING
    assert view(entries, 2).doing == "I'm moving to line 1."
    assert view(entries).status is Status.FINISHED
    assert view(entries).doing == "Finished: everything asked for is satisfied."


def test_each_part_of_the_request_has_its_verdict(entries: Sequence[Entry]) -> None:
    assert [each.verdict for each in view(entries, 2).clauses] == [
        Verdict.OPEN, Verdict.HOLDS_SO_FAR,
    ]  # fmt: skip
    assert view(entries).clauses[0].verdict is Verdict.SATISFIED
    told = panels.clauses(view(entries, 2).clauses)
    assert "still open" in told  # in words, not in colour alone
    assert "kept so far" in told


def test_what_is_known_says_since_when_and_how(entries: Sequence[Entry]) -> None:
    known = view(entries).known(datetime.fromisoformat(entries[-1].time))
    unripe = next(each for each in known if each.fact.atom == "unripe g1")
    assert unripe.text == "Grape 1 is unripe."
    assert unripe.things == ("g1",)
    table = panels.known(known, datetime.fromisoformat(unripe.fact.time) + timedelta(minutes=5))
    assert "<td>Grape 1 is unripe.</td>" in table
    assert "5 min" in table
    assert "seen after an action" in table


def test_a_timeline_tells_every_action_once_and_escapes_what_people_said(
    entries: Sequence[Entry],
) -> None:
    told = panels.timeline(view(entries).lines)
    assert told.count("moving to line 1") == 1
    assert "<b>now</b>" not in told
    assert "&lt;b&gt;now&lt;/b&gt;" in told


def test_a_long_timeline_shows_its_end_and_says_how_much_it_leaves_out(
    entries: Sequence[Entry],
) -> None:
    lines = view(entries).lines * 500
    told = panels.timeline(lines)
    assert told.count("data-step") == panels.MOST_LINES
    assert f"{len(lines) - panels.MOST_LINES} earlier lines" in told


def test_an_answer_points_at_the_entries_the_nodes_and_the_things_it_rests_on(
    entries: Sequence[Entry],
) -> None:
    now = view(entries, 4)
    answer, _ = Dialogue().ask("What are you doing now?", now.moment)
    told = bubbles([Said("ada", "<i>hm</i>"), Said("robot", answer.text, answer)], SITE.problem)
    assert "<i>" not in told
    steps = told.partition('data-steps="')[2].partition('"')[0].split()
    assert steps
    assert all(int(step) < 5 for step in steps)
    assert "l1" in told.partition('data-things="')[2].partition('"')[0].split()


@pytest.mark.parametrize("at", [0, 2, 5, None])
def test_every_question_that_is_suggested_has_an_answer(
    entries: Sequence[Entry], at: int | None
) -> None:
    now = view(entries, at)
    dialogue = Dialogue()
    assert now.suggestions
    for question in now.suggestions:
        answer, dialogue = dialogue.ask(question, now.moment)
        assert answer.known, question


def test_the_age_of_a_fact_is_told_in_one_unit() -> None:
    now = datetime(2026, 5, 1, 12, 0, 0, tzinfo=UTC)
    ages = {
        age((now - timedelta(seconds=seconds)).isoformat(), now)
        for seconds in (3, 120, 7200, 172800)
    }
    assert ages == {"3 s", "2 min", "2 h", "2 d"}
    assert age((now + timedelta(seconds=5)).isoformat(), now) == "0 s"


def test_what_nobody_knows_and_what_was_seen_too_long_ago_are_shown_as_such() -> None:
    _, log = store_room.carried_out(store_room.veiled()[0])
    first = view(log, log[1].step)
    then = datetime.fromisoformat(log[1].time)
    table = panels.known(first.known(then), then)
    assert "<td>Whether the red room is locked.<br/>" in table
    assert "not known" in table
    assert "nobody has looked" in table
    looked = next(each for each in log if "full ramp" in str(getattr(each.event, "sensed", "")))
    after = datetime.fromisoformat(looked.time)
    (ramp,) = (k for k in view(log, looked.step).known(after) if k.fact.atom == "full ramp")
    assert ramp.text == "The ramp is full."
    assert "looked at by simulator" in panels.known([ramp], after)


def test_a_fact_fades_with_time_and_says_so() -> None:
    _, log = store_room.carried_out(store_room.veiled()[0])
    first = log[0].event
    assert isinstance(first, MissionAccepted)
    lasting = {"senses": [Sense("full {p}", ("eye",), lasts=600.0, needed=True).to_json()]}
    fading = [replace(log[0], event=replace(first, robot={**first.robot, **lasting})), *log[1:]]
    seen = datetime.fromisoformat(log[-1].time)
    assert view(fading).fades
    for minutes, kind in ((1, "false"), (30, "stale")):
        later = seen + timedelta(minutes=minutes)
        table = panels.known(view(fading).known(later), later)
        row = next(each for each in table.split("<tr ") if "fact full ramp" in each)
        assert f'class="{kind}"' in row
    assert "not sure any more" in row
    assert "when I last knew" in row


def test_two_robots_at_work_are_both_told_and_both_drawn_as_busy() -> None:
    started = [
        ActionStarted("drive cart bay desk", 0, "m/1"),
        ActionStarted("drive fork bay plug", 1, "m/2"),
    ]
    events: list[Event] = [two_robots.accepted(two_robots.APART), *started]
    log = [Entry(i, "2026-05-01T08:00:00+00:00", 0, each) for i, each in enumerate(events)]
    seen = view(log)
    assert seen.actions == tuple(each.action for each in started)
    assert "desk" in seen.doing
    assert "plug" in seen.doing
    assert seen.map.count('class="robot busy"') == 2
