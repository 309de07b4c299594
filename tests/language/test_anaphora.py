"""Words that point at words, and words for all, any or none of a kind, in a laundry."""

# ruff: noqa: E501
# A sentence and its formula read best side by side.

import pytest
from tests.language.domains import vocabulary

from plainspoken.automata.equivalence import equivalent
from plainspoken.language.extraction import Status, extract
from plainspoken.logic.syntax import parse, unparse

LAUNDRY = vocabulary(
    """
    wash_room, l, the wash room, the laundry room
    d1, l, dryer 1
    d2, l, dryer 2
    d3, l, dryer 3
    desk, l, the front desk
    por_wash, c, the porter is at the wash room
    por_d1, c, the porter is at dryer 1
    por_d2, c, the porter is at dryer 2
    por_d3, c, the porter is at dryer 3
    por_desk, c, the porter is at the front desk
    full, c, the basket is full
    clogged, c, the filter is clogged
    run1, c, dryer 1 is running
    run2, c, dryer 2 is running
    run3, c, dryer 3 is running
    washed0, c, sheet 0 is washed
    washed1, c, sheet 1 is washed
    washed2, c, sheet 2 is washed
    dry0, c, sheet 0 is dry
    dry1, c, sheet 1 is dry
    dry2, c, sheet 2 is dry
    stained0, c, sheet 0 is stained
    stained1, c, sheet 1 is stained
    stained2, c, sheet 2 is stained
    raining, c, it is raining
    guests, c, there are guests in the wash room
    alarm, c, the alarm is ringing
    wash, a, to wash a sheet
    iron, a, to iron a sheet
    load, a, to put a sheet in the basket
    call, a, to call the porter
    empty, a, to empty the basket
    clean, a, to clean the filter
    ask, a, to ask the manager
    bell, a, to ring the bell
    note, a, to make an announcement
    porter_sweeps, a, the porter sweeps
    sweep, a, to sweep
    """
)

QUANTIFIED = """
    Visit all the dryers apart from dryer 3. => F d1 & F d2
    With the exception of sheet 2, every sheet has to be dry. => F dry0 & F dry1
    Apart from dryer 1, no dryer may be entered. => G !d2 & G !d3
    Every dryer except dryers 1 and 2 must be visited. => F d3
    All of the sheets, except sheet 1, must be washed. => F washed0 & F washed2
    None of the dryers except dryer 3 may ever run. => G !run1 & G !run2
    The sheets must all be dry. => F dry0 & F dry1 & F dry2
    One of the dryers must be visited. => F(d1 | d2 | d3)
    At least one sheet must end up dry. => F(dry0 | dry1 | dry2)
    If a sheet is stained, ask the manager. => G((stained0 | stained1 | stained2) -> F ask)
    If not all the sheets are dry, ring the bell. => G(!(dry0 & dry1 & dry2) -> F bell)
    Don't ring the bell until any of the sheets is dry. => !bell U (dry0 | dry1 | dry2)
    After every sheet you iron, ring the bell. => G(iron -> F bell)
"""
CONDITIONS = """
    If the basket is full while the porter is at the front desk, ring the bell. => G((full & por_desk) -> F bell)
    Whenever the basket is full, if dryer 1 is running, ring the bell. => G((full & run1) -> F bell)
    If the filter isn't clogged, then whenever the basket is full, empty it. => G((!clogged & full) -> F empty)
    When the basket is full, empty it, provided that dryer 2 is running. => G((full & run2) -> F empty)
    If sheet 0 is dry but sheet 1 isn't, ring the bell. => G((dry0 & !dry1) -> F bell)
    If sheet 0 is washed but not dry, go to dryer 1. => G((washed0 & !dry0) -> F d1)
    If the basket is full, call the porter; otherwise, go to dryer 1. => G(full -> F call) & G(!full -> F d1)
    If dryer 1 is running go to dryer 2, if not go to dryer 1. => G(run1 -> F d2) & G(!run1 -> F d1)
    On finding sheet 0 stained, ask the manager. => G(stained0 -> F ask)
    Were the basket to become full, you should empty it. => G(full -> F empty)
    If you notice that sheet 2 is stained, ask the manager. => G(stained2 -> F ask)
    Basket full and dryer 1 running? Call the porter. => G((full & run1) -> F call)
    Should it start raining, ring the bell. => G(raining -> F bell)
    While there are guests in the wash room, stay out of it. => G(guests -> !wash_room)
    If the alarm goes off, go to the front desk. => G(alarm -> F desk)
    When sheet 0 is stained, the manager must immediately be asked. => G(stained0 -> X ask)
    The porter may only be called if the basket is full. => G(call -> full)
    No announcements before the alarm rings. => !note U alarm
"""
POINTING = """
    If sheet 0 is stained, ask the manager; the same goes for sheet 1. => G(stained0 -> F ask) & G(stained1 -> F ask)
    As for sheet 2, see that it is washed. => F washed2
    Give the filter a clean. => F clean
    Wash a sheet, then put it in the basket. => F(wash & F load)
    Get sheet 0 washed, then dry. => F(washed0 & F dry0)
    Sheet 0 has to be washed and so does sheet 1. => F washed0 & F washed1
    Prevent the filter from getting clogged. => G !clogged
    The basket must never be allowed to get full. => G !full
    Send the porter to dryer 1, then go to the front desk. => F(por_d1 & F desk)
    Tell the porter to go to dryer 1 and then to dryer 2. => F(por_d1 & F por_d2)
    Wait at the front desk until the porter arrives. => desk U por_desk
    Wait at dryer 1 for sheet 0 to be dry. => d1 U dry0
    Call the porter and have him come to dryer 1. => F call & F por_d1
    The porter has to go to dryer 3 and then sweep. => F(por_d3 & F porter_sweeps)
    You and the porter must not be at dryer 3 together. => G !(d3 & por_d3)
    Stay at dryer 1 until sheet 0 is dry; after that go to the front desk. => d1 U dry0 & F(dry0 & F desk)
"""


def _cases(text: str) -> list[tuple[str, str]]:
    pairs = (line.split("=>") for line in text.strip().splitlines())
    return [(sentence.strip(), meant.strip()) for sentence, meant in pairs if meant.strip()]


@pytest.mark.parametrize(
    ("sentence", "meant"), _cases(QUANTIFIED) + _cases(CONDITIONS) + _cases(POINTING)
)
def test_what_is_pointed_at_is_said_in_full(sentence: str, meant: str) -> None:
    extraction = extract(sentence, LAUNDRY, None)
    assert extraction.status is Status.OK, extraction.reason or extraction.question
    assert extraction.reading is not None
    assert equivalent(extraction.reading.literal, parse(meant)), unparse(extraction.reading.literal)
