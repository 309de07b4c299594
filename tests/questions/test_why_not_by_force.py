"""Contrastive answers by brute force: with the obstacle that is named gone, the action works."""

from random import Random

import pytest
from tests.questions.missions import run

from plainspoken.questions.answer import answer_at
from plainspoken.questions.moment import Moment
from plainspoken.world.domain import Problem
from plainspoken.world.scene import is_applicable


def _actions(problem: Problem) -> list[str]:
    return [
        " ".join([schema.name, *binding.values()])
        for schema in problem.domain.actions
        for binding in problem.bindings(schema.parameters)
    ]


@pytest.mark.parametrize("name", ["vineyard", "depot", "soup", "hospital", "reading_room"])
def test_without_the_named_obstacle_the_action_can_be_done(name: str) -> None:
    chance = Random(name)
    entries = run(name, 5, most=60)
    cases = 0
    while cases < 20:
        moment = Moment(entries, chance.randrange(1, len(entries)))
        wanted = chance.choice(_actions(moment.problem))
        question = f"Why don't you {moment.lexicon.deed(wanted).bare}?"
        found = answer_at(question, moment)
        if not found.known or not found.text.startswith("I can't "):
            continue
        cases += 1
        hindering = {claim.fluent for claim in found.claims if claim.end == moment.now}
        lacking = {claim.fluent for claim in found.denied if claim.end == moment.now}
        assert hindering | lacking, found.text
        state = (moment.whole(moment.state) - hindering) | lacking
        # The words name the action; which of its instances is meant is for the answer to choose.
        same = [
            action
            for action in _actions(moment.problem)
            if moment.lexicon.deed(action).bare == found.text[8:].partition(" now because")[0]
        ]
        assert same, found.text
        assert any(is_applicable(moment.problem, state, action) for action in same), found.text
        # It is an obstacle: as things are, none of them can be done.
        here = moment.whole(moment.state)
        assert not any(is_applicable(moment.problem, here, action) for action in same), found.text
