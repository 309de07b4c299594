from dataclasses import replace
from datetime import UTC, datetime, timedelta
from functools import reduce

import pytest
from hypothesis import given
from hypothesis import strategies as st
from tests.knowledge.a_run import ACCEPTED, ENTRIES

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.facts import Fact, Source, facts_after, trace_of
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    Entry,
    MissionAccepted,
    ObservationMade,
    ReportReceived,
)
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


def test_a_fact_nobody_knows_is_neither_true_nor_false() -> None:
    first = replace(ACCEPTED, unknown=("shut door", "lit lamp"), **PLANNED)
    facts = facts_after([Entry(0, "2026-11-22T10:00:00Z", 0, first)])
    for atom in ("shut door", "lit lamp"):  # one is assumed to be true, the other is not
        known = facts.known(atom, LAST_LOOK)
        assert known.holds is None
        assert not known.is_stale
        assert known.seen == ""


PLANNED = {
    "domain": """(define (domain d) (:predicates (lit ?x) (open ?x))
      (:action light :parameters (?x) :precondition (and) :effect (lit ?x))
      (:action try :parameters (?x) :precondition (and) :effect (oneof (open ?x) (lit ?x))))""",
    "problem": "(define (problem p) (:domain d) (:objects a b) (:init) (:goal (lit a)))",
}
HIDDEN = ("lit a", "lit b", "open a", "open b")
NEEDED = [{"atom": "lit {x}", "by": ["eye"], "lasts": 50, "needed": True}]
_HOLDS = st.sampled_from([True, False, None])
SAYINGS = st.one_of(
    st.tuples(st.just("sensed"), st.sampled_from(HIDDEN), _HOLDS),
    st.tuples(st.just("report"), st.sampled_from(HIDDEN), st.booleans()),
    st.tuples(st.just("light"), st.sampled_from("ab"), st.none()),
    st.tuples(st.just("try"), st.sampled_from("ab"), st.sampled_from(["open", "lit"])),
    st.tuples(st.just("fails"), st.none(), st.none()),
)


@given(
    st.lists(SAYINGS, max_size=12),
    st.frozensets(st.sampled_from(HIDDEN)),
    st.integers(0, 200),
)
def test_no_log_makes_known_what_no_event_says_and_nothing_stale_is_known(
    sayings: list[tuple[str, str | None, bool | str | None]], unknown: frozenset[str], later: int
) -> None:
    start = datetime(2026, 11, 22, 10, tzinfo=UTC)
    first = replace(
        ACCEPTED,
        static=(),
        state=frozenset(),
        robot={"senses": NEEDED},
        unknown=tuple(sorted(unknown)),
        **PLANNED,
    )
    entries = [Entry(0, start.isoformat(), 0, first)]
    # The judge: of each atom, the last that was said of it, and when. Nothing else is known.
    said: dict[str, tuple[bool, int]] = {a: (False, 0) for a in HIDDEN if a not in unknown}
    state: frozenset[str] = frozenset()
    instant = 0
    for step, (what, about, how) in enumerate(sayings, start=1):
        event, told = _event(what, about, how, state)
        for atom, holds in told.items():
            said[atom] = (holds, step)
        changed = event.state ^ state
        assert changed <= told.keys()
        is_action = isinstance(event, ActionFinished)
        instant += is_action or bool(changed)
        state = event.state
        if not isinstance(event, ObservationMade | ReportReceived):
            # A look at the world tells of all that is not looked at one by one, once it is known.
            for atom in ("open a", "open b"):
                if atom in said:
                    said[atom] = (atom in state, step)
        time = (start + timedelta(seconds=10 * step)).isoformat()
        entries.append(Entry(step, time, instant, event))
    at = start + timedelta(seconds=10 * len(sayings) + later)
    facts = facts_after(entries)
    for atom in HIDDEN:
        holds, step = said.get(atom, (None, 0))
        if atom.startswith("lit") and (at - start).total_seconds() - 10 * step > 50:
            holds = None
        assert facts.known(atom, at).holds is holds


def _event(
    what: str,
    about: str | None,
    how: bool | str | None,  # noqa: FBT001 - drawn
    state: frozenset[str],
) -> tuple[ActionFailed | ActionFinished | ObservationMade | ReportReceived, dict[str, bool]]:
    """An event, and what it says of single atoms."""
    match what:
        case "sensed" | "report":
            told = {} if how is None else {str(about): bool(how)}
            true = {atom for atom, holds in told.items() if holds}
            now = (state - told.keys()) | true
            document = ({"atom": about, "holds": how, "by": "eye"},)
            if what == "sensed":
                return ObservationMade("eye", (), (), now, document), told
            return ReportReceived("ada", "", (), (), now, document), told
        case "light" | "try":
            atom = f"{'lit' if what == 'light' else how} {about}"
            known = {atom: True} if what == "light" or atom not in state else {}
            return ActionFinished(f"{what} {about}", "g", state | {atom}, None), known
        case _:
            return ActionFailed("light a", "g", "no", state), {}
