import pytest
from hypothesis import given
from hypothesis import strategies as st

from plainspoken.evaluation.corpus import Mention
from plainspoken.evaluation.metric import (
    Mentions,
    Share,
    compared,
    differs_in_grounding,
    percentile,
    wilson,
)
from plainspoken.logic.syntax import parse

shares = st.integers(1, 400).flatmap(lambda n: st.tuples(st.integers(0, n), st.just(n)))


@pytest.mark.parametrize(
    ("count", "total", "low", "high"),
    [
        # By hand, z = 1.96: 0 of 10 is 3.8416 / 13.8416 at most.
        (0, 10, 0.0, 0.2775),
        (10, 10, 0.7225, 1.0),
        # (0.5 + 0.19208 -+ 1.96 * sqrt(0.025 + 0.009604)) / 1.38416
        (5, 10, 0.2366, 0.7634),
        (1, 10, 0.0179, 0.4042),
        # Newcombe, Statistics in Medicine 17 (1998), table I: 81 of 263 and 15 of 148.
        (81, 263, 0.2553, 0.3662),
        (15, 148, 0.0624, 0.1605),
        (0, 0, 0.0, 1.0),
    ],
)
def test_wilson_intervals_agree_with_a_table(
    count: int, total: int, low: float, high: float
) -> None:
    assert wilson(count, total) == pytest.approx((low, high), abs=1e-4)


@given(shares)
def test_the_ends_of_a_wilson_interval_are_where_the_score_test_turns(
    share: tuple[int, int],
) -> None:
    count, total = share
    for end in wilson(count, total):
        if 0 < end < 1:
            score = (count / total - end) / (end * (1 - end) / total) ** 0.5
            assert abs(score) == pytest.approx(1.959964, abs=1e-4)


@given(shares)
def test_an_interval_holds_the_share_and_mirrors_that_of_the_failures(
    share: tuple[int, int],
) -> None:
    count, total = share
    low, high = wilson(count, total)
    assert 0 <= low <= count / total <= high <= 1
    assert wilson(total - count, total) == pytest.approx((1 - high, 1 - low))


def test_more_right_than_there_are_is_an_error() -> None:
    with pytest.raises(ValueError, match="3 of 2"):
        wilson(3, 2)


def test_a_percentile_is_one_of_the_values() -> None:
    assert percentile([], 50) is None
    assert percentile([7.0], 95) == 7.0
    assert percentile([3.0, 1.0, 2.0], 50) == 2.0
    assert percentile([float(n) for n in range(1, 21)], 95) == 19.0


@pytest.mark.parametrize(
    ("recognised", "gold", "expected"),
    [
        ("F a & G !c", "F a & G !b", True),
        ("F(c & F d)", "F(a & F b)", True),
        ("F(b & F a)", "F(a & F b)", False),  # the order, not the places
        ("F(c & F a)", "F(a & F b)", False),  # both
        ("F a", "F a & F b", False),
        ("G !c", "F a", False),
        ("F a", "F a", False),
    ],
)
def test_a_wrong_symbol_is_told_from_a_wrong_formula(
    recognised: str, gold: str, *, expected: bool
) -> None:
    assert differs_in_grounding(parse(recognised), parse(gold)) is expected


def mention(start: int, end: int, symbol: str) -> Mention:
    return Mention("x" * (end - start), start, end, symbol)


def test_mentions_are_matched_by_place_and_symbol() -> None:
    gold = [mention(0, 5, "a"), mention(10, 15, "b"), mention(20, 25, "c")]
    found = [mention(2, 7, "a"), mention(10, 15, "d"), mention(30, 35, "c")]
    # a is found, b is taken for d, c is not seen; what is said of 30 to 35 is nothing.
    assert compared(found, gold) == Mentions(Share(1, 3), Share(1, 3), Share(1, 2))


def test_pieces_that_only_touch_do_not_overlap() -> None:
    assert compared([mention(5, 9, "a")], [mention(0, 5, "a")]).recall == Share(0, 1)


def test_mentions_of_many_sentences_add_up() -> None:
    one = Mentions(Share(1, 2), Share(1, 1), Share(1, 1))
    other = Mentions(Share(0, 1), Share(0, 3), Share(0, 1))
    assert one + other == Mentions(Share(1, 3), Share(1, 4), Share(1, 2))
