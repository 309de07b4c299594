"""A log in lines: looks with what they told, who does what, and what cannot hold any more."""

from collections.abc import Iterable

from tests.mission import two_robots
from tests.mission.store_room import carried_out, veiled

from plainspoken.mission.simulator import Simulator
from plainspoken.questions.chronicle import Line, chronicle
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import lexicon_of
from plainspoken.world.event import (
    ActionStarted,
    Entry,
    Event,
    LookRequested,
    MissionAccepted,
    MissionEnded,
    ObservationMade,
    VerdictReached,
)


def told(*events: Event) -> tuple[Line, ...]:
    entries: Iterable[Entry] = (Entry(i, "t", 0, each) for i, each in enumerate(events))
    return chronicle(entries, Lexicon(two_robots.PROBLEM, two_robots.SITE.landmarks))


def test_a_look_tells_what_it_found_and_what_it_could_not_tell() -> None:
    _, entries = carried_out(veiled()[0])
    first = entries[0].event
    assert isinstance(first, MissionAccepted)
    looks = [each for each in chronicle(entries, lexicon_of(first)) if each.sort == "seen"]
    sensed = [e for e in entries if isinstance(e.event, ObservationMade) and e.event.sensed]
    assert sensed
    assert [each.step for each in looks] == [each.step for each in sensed]
    assert all(each.came_of and "nothing has changed" not in each.came_of for each in looks)
    state = Simulator(two_robots.PROBLEM).state()
    telling = {"atom": "battery-low cart", "holds": None, "by": "gauge", "time": "t"}
    (line,) = told(ObservationMade("gauge", (), (), state, (telling,)))
    assert line.text == "looked (gauge)"
    assert line.came_of.startswith("cannot tell whether")


def test_who_wants_to_know_what_is_told() -> None:
    (line,) = told(LookRequested("ada", ("battery-low cart",)))
    assert line.sort == "person"
    assert line.text.startswith("ada wants to know whether")


def test_of_several_robots_each_line_says_which_one_acts() -> None:
    lines = told(
        ActionStarted("drive cart bay desk", 0, "m/1"),
        ActionStarted("drive fork bay plug", 1, "m/2"),
    )
    assert [each.going for each in lines] == [True, True]
    assert len({each.text.partition(":")[0] for each in lines}) == 2


def test_what_cannot_hold_any_more_is_said_in_words() -> None:
    clause, other = "F robot_at_cart_desk", "F robot_at_fork_plug"
    one, both, why = told(
        VerdictReached("violated", clause),
        VerdictReached("violated", together=(clause, other)),
        VerdictReached("violated", reason="The desk cannot be reached."),
    )
    assert one.came_of == "Visit the office."
    assert both.came_of.startswith("not all of these: Visit the office. ")
    assert why.came_of == "The desk cannot be reached."
    _, end = told(
        VerdictReached("violated", clause),
        MissionEnded("stopped", False, f"the request can no longer be met: {clause} is violated"),
    )
    met = "the request can no longer be met: “Visit the office” is violated"
    assert end.came_of == f"not satisfied: {met}"
