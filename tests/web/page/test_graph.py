import time

import pytest
from hypothesis import given
from hypothesis import strategies as st

pytest.importorskip("nicegui", reason="the page is an extra: pip install 'plainspoken[web]'")

from tests.mission.small_vineyard import PROBLEM

from plainspoken.planning.policy import Policy, PolicyNode
from plainspoken.questions.lexicon import Lexicon
from plainspoken.web.page.graph import PLENTY, graph_of, kinds_of, naming

LEXICON = Lexicon(PROBLEM, {})


def policy(*successors: tuple[int, ...]) -> Policy:
    """A policy of so many nodes; one without successors is where it stops."""
    nodes = [
        PolicyNode(i, frozenset(), "move rob l0 wh" if after else None, after)
        for i, after in enumerate(successors)
    ]
    return Policy("strong-cyclic", "F x", 0, frozenset(), tuple(nodes))


def chain(length: int) -> Policy:
    return policy(*((i + 1,) for i in range(length - 1)), ())


FORK = policy((1, 2), (3,), (3,), ())


def test_past_present_future_and_missed_are_told_apart() -> None:
    assert kinds_of(FORK, [0], 1) == {0: "past", 1: "present", 2: "missed", 3: "future"}


def test_at_the_start_everything_may_come_and_at_the_end_nothing() -> None:
    assert kinds_of(FORK, [], 0) == {0: "present", 1: "future", 2: "future", 3: "future"}
    assert kinds_of(FORK, [0, 1], 3) == {0: "past", 1: "past", 2: "missed", 3: "present"}


def test_without_a_present_nothing_is_still_to_come() -> None:
    assert set(kinds_of(FORK, [0], None).values()) == {"past", "missed"}


def test_the_arrow_that_was_gone_is_past_and_one_that_may_be_gone_is_future() -> None:
    arrows = {(a.source, a.target): a.kind for a in graph_of(FORK, [0], 1, LEXICON).arrows}
    assert arrows == {
        ("0", "1"): "past", ("0", "2"): "missed", ("1", "3"): "future", ("2", "3"): "missed",
    }  # fmt: skip


def test_a_small_policy_is_drawn_whole_and_a_large_one_folded() -> None:
    small, large = chain(PLENTY), chain(500)
    assert not graph_of(small, [], 0, LEXICON).folds
    graph = graph_of(large, [*range(100)], 100, LEXICON)
    assert len(graph.vertices) <= PLENTY
    labels = {v.label for v in graph.vertices if v.holds > 1}
    assert any("earlier" in label for label in labels)
    assert any("more" in label for label in labels)
    assert sum(v.holds for v in graph.vertices) == 500


def test_a_fold_opens_where_it_is_asked_to() -> None:
    large = chain(500)
    closed = graph_of(large, [], 0, LEXICON)
    (fold,) = closed.folds.values()
    opened = graph_of(large, [], 0, LEXICON, opened=frozenset({min(fold)}))
    assert str(min(fold)) in {v.id for v in opened.vertices}
    assert len(opened.vertices) > len(closed.vertices)


def test_everything_is_shown_when_nothing_is_to_be_folded_and_soon_enough() -> None:
    began = time.process_time()
    graph = graph_of(chain(500), [], 0, LEXICON, whole=True)
    assert len(graph.vertices) == 500
    assert time.process_time() - began < 20  # of the processor, whatever else it is doing


@given(
    st.lists(st.sets(st.integers(0, 59), max_size=3), min_size=60, max_size=60),
    st.lists(st.integers(0, 59), max_size=10),
    st.integers(0, 59) | st.none(),
    st.frozensets(st.integers(0, 59), max_size=3),
)
def test_every_node_is_drawn_once_or_folded_once_and_nothing_lies_upon_another(
    after: list[set[int]], past: list[int], present: int | None, opened: frozenset[int]
) -> None:
    whole = policy(*(tuple(sorted(each)) for each in after))
    graph = graph_of(whole, past, present, LEXICON, opened=opened)
    shown = [int(v.id) for v in graph.vertices if v.holds == 1 and not v.id.startswith("fold")]
    folded = [node for fold in graph.folds.values() for node in fold]
    assert sorted([*shown, *folded]) == list(range(60))
    drawn = {v.id for v in graph.vertices}
    assert all({a.source, a.target} <= drawn for a in graph.arrows)
    assert len({(v.x, v.y) for v in graph.vertices}) == len(graph.vertices)
    if present is not None:
        assert str(present) in drawn


def test_a_situation_is_found_by_the_words_of_what_is_done_there() -> None:
    assert naming(FORK, "Move", LEXICON) == [0, 1, 2]
    assert naming(FORK, "done", LEXICON) == [3]
    assert naming(FORK, "harvest", LEXICON) == []
