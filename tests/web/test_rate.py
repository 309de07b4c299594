from contextlib import suppress

import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.web.rate import MOST_REMEMBERED, Rate, Rates, Seats, TooManyError

RATE = Rate("knocks", a_second=2, at_once=3)


def test_after_a_few_at_once_it_goes_slowly() -> None:
    now = [0.0]
    rates = Rates(lambda: now[0])
    for _ in range(3):
        rates.spend(RATE, "ada")
    with pytest.raises(TooManyError) as caught:
        rates.spend(RATE, "ada")
    assert caught.value.after == 1
    rates.spend(RATE, "bob")
    now[0] = 0.5
    rates.spend(RATE, "ada")
    with pytest.raises(TooManyError):
        rates.spend(RATE, "ada")


@given(st.lists(st.floats(0, 2), max_size=60))
def test_nobody_gets_more_than_the_rate(pauses: list[float]) -> None:
    now, served = [0.0], 0
    rates = Rates(lambda: now[0])
    for pause in pauses:
        now[0] += pause
        with suppress(TooManyError):
            rates.spend(RATE, "ada")
            served += 1
    assert served <= RATE.at_once + RATE.a_second * now[0] + 1e-6


def test_made_up_clients_do_not_fill_the_memory() -> None:
    rates = Rates()
    for number in range(MOST_REMEMBERED + 100):
        rates.spend(RATE, f"client {number}")
    assert len(rates._buckets) == MOST_REMEMBERED


def test_seats_are_counted_for_each_and_for_all_and_given_back() -> None:
    seats = Seats("chairs", total=3, each=2)
    with seats.seat("ada"), seats.seat("ada"):
        with pytest.raises(TooManyError, match="chairs"):
            seats.take("ada")
        with seats.seat("bob"), pytest.raises(TooManyError):
            seats.take("eve")
        seats.take("eve")
    seats.leave("eve")
    assert not seats._taken
