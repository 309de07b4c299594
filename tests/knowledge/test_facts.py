from dataclasses import replace
from datetime import UTC, datetime, timedelta
from functools import reduce

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.knowledge.a_run import ACCEPTED, ENTRIES

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.facts import Fact, Source, facts_after, trace_of
from plainspoken.world.event import ActionFinished, Entry, MissionAccepted
from plainspoken.world.symbol import ActionSymbol, AtomSymbol

ATOMS = st.sampled_from(["a", "b", "c x", "d x y"])
STATES = st.lists(st.frozensets(ATOMS), min_size=1, max_size=12)


def test_each_fact_says_since_when_and_because_of_what() -> None:
    facts = facts_after(ENTRIES)
    noon = "2026-11-22T10:00:"
    assert facts.fact("open door") == Fact(
        "open door", True, Source.ACTION, 3, 1, f"{noon}03Z", "open door"
    )
    assert facts.fact("lit lamp") == Fact(
        "lit lamp", False, Source.OBSERVATION, 7, 3, f"{noon}07Z", "light lamp"
    )
    assert facts.fact("part-of lamp room") == Fact(
        "part-of lamp room", True, Source.INITIAL, 0, 0, f"{noon}00Z"
    )
    assert facts.fact("never heard of") == Fact(
        "never heard of", False, Source.INITIAL, 0, 0, f"{noon}00Z"
    )


def test_a_report_is_the_source_until_something_else_changes_the_atom() -> None:
    assert facts_after(ENTRIES[:7]).fact("lit lamp").source is Source.REPORT


def test_the_trace_holds_each_state_once_with_the_action_that_led_to_it() -> None:
    assert [(m.instant, m.action, m.step) for m in trace_of(ENTRIES)] == [
        (0, None, 0),
        (1, "open door", 3),
        (2, None, 5),
        (3, None, 7),
    ]


def test_letters_hold_the_symbols_of_states_static_atoms_and_actions() -> None:
    symbols = (
        AtomSymbol("open_door", "open door"),
        AtomSymbol("part_of_lamp_room", "part-of lamp room"),
        ActionSymbol("open_executed", "open"),
    )
    always = frozenset({"part_of_lamp_room"})
    assert facts_after(ENTRIES).letters(symbols) == (
        always,
        always | {"open_door", "open_executed"},
        always | {"open_door"},
        always | {"open_door"},
    )


@given(STATES)
def test_the_fold_of_any_run_knows_the_last_state_and_nothing_else(
    states: list[frozenset[str]],
) -> None:
    facts = facts_after(_run(states))
    assert facts.state == states[-1]
    assert {atom for atom in facts.changed if facts.fact(atom).holds} == states[-1]
    assert [moment.state for moment in facts.trace] == states


@given(STATES)
def test_a_fact_has_held_in_every_state_since_its_instant_and_not_before(
    states: list[frozenset[str]],
) -> None:
    for fact in facts_after(_run(states)).changed.values():
        assert all((fact.atom in state) == fact.holds for state in states[fact.instant :])
        if fact.instant:
            assert (fact.atom in states[fact.instant - 1]) != fact.holds


def test_entries_that_do_not_begin_a_log_are_refused_with_their_step() -> None:
    with pytest.raises(PlainspokenError, match="begins with mission_accepted") as caught:
        facts_after(ENTRIES[2:])
    assert "step 2" in str(caught.value)
    with pytest.raises(PlainspokenError, match="empty log"):
        facts_after(())


def test_a_missing_instant_is_refused() -> None:
    with pytest.raises(PlainspokenError, match="expected instant 1, got 2"):
        facts_after(ENTRIES[:3] + ENTRIES[5:])


def _run(states: list[frozenset[str]]) -> list[Entry]:
    first = MissionAccepted("m", None, "true", "", "", "", {}, (), states[0])
    return reduce(
        lambda entries, state: [
            *entries,
            Entry(len(entries), "", len(entries), ActionFinished("do", "", state, None)),
        ],
        states[1:],
        [Entry(0, "", 0, first)],
    )


def test_static_atoms_are_part_of_what_is_true_now() -> None:
    assert facts_after([Entry(0, "", 0, ACCEPTED)]).state == {"shut door", "part-of lamp room"}


STALE = replace(ACCEPTED, robot={"senses": [{"atom": "lit {x}", "lasts": 60.0}]})
LAST_LOOK = datetime(2026, 11, 22, 10, 0, 7, tzinfo=UTC)


@pytest.mark.parametrize(
    ("atom", "later", "holds"),
    [
        ("lit lamp", 60, False),
        ("lit lamp", 61, None),
        ("open door", 3600, True),
        ("part-of lamp room", 3600, True),
    ],
)
def test_a_fact_that_was_seen_too_long_ago_is_not_known_any_more(
    atom: str, later: int, *, holds: bool | None
) -> None:
    facts = facts_after([replace(ENTRIES[0], event=STALE), *ENTRIES[1:]])
    known = facts.known(atom, LAST_LOOK + timedelta(seconds=later))
    assert known.holds is holds
    assert known.fact == facts.fact(atom)
    assert datetime.fromisoformat(known.seen) == LAST_LOOK
