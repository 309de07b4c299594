"""What-if and contrastive answers against executions enumerated and the model tried by hand."""

from collections.abc import Iterator
from itertools import islice
from random import Random

import pytest
from tests.questions.judge import Judge
from tests.questions.missions import run

from plainspoken.logic.formula import Formula, atoms, conjuncts
from plainspoken.logic.syntax import parse
from plainspoken.logic.trace import holds
from plainspoken.questions.answer import answer_at
from plainspoken.questions.kind import Kind
from plainspoken.questions.moment import Moment
from plainspoken.questions.question import Question
from plainspoken.questions.referent import Referents
from plainspoken.world.event import Entry
from plainspoken.world.scene import applicable_actions, successors
from plainspoken.world.symbol import letter, resolve_all

NAMES = ["vineyard", "depot", "soup", "hospital", "reading_room"]
CASES = 20


def _moments(name: str, chance: Random) -> Iterator[tuple[Moment, Judge]]:
    """Random instants of random runs at which the plan has something to do yet."""
    runs: list[tuple[Entry, ...]] = [run(name, seed, most=60) for seed in range(3)]
    while True:
        entries = chance.choice(runs)
        at = chance.randrange(1, len(entries))
        moment = Moment(entries, at)
        if moment.node is not None and moment.node.action is not None:
            yield moment, Judge(entries, at)


def _what_if(atom: str, moment: Moment, *, negative: bool = False) -> Question:
    said = moment.lexicon.clause(atom).said() + (", or rather not" if negative else "")
    return Question(Kind.WHAT_IF, f"What if {said}?", Referents(atoms=(atom,)))


def _where(judge: Judge, atom: str, *, holds: bool) -> tuple[int, set[str]] | None:
    """After how many actions a fact can first be so (or not), and what is done then."""
    seen: set[int] = set()
    for distance, layer in enumerate(judge.layers(80)):
        there = {i for i in layer if (atom in judge.policy[i]["state"]) == holds}
        if there:
            return distance, {judge.policy[i]["action"] for i in there if judge.policy[i]["action"]}
        if layer <= seen:
            return None
        seen |= layer
    return None


@pytest.mark.parametrize("name", NAMES)
def test_what_if_follows_the_branch_that_every_execution_there_takes(name: str) -> None:
    chance = Random(f"what if {name}")
    cases = {"can be": 0, "won't": 0}
    for moment, judge in _moments(name, chance):
        atoms = sorted({a for node in judge.policy.values() for a in node["state"]} - moment.static)
        atom = chance.choice(atoms)
        if atom in moment.state:
            continue
        found = answer_at(_what_if(atom, moment), moment)
        there = _where(judge, atom, holds=True)
        if there is None:
            assert "not" in found.text or "n't" in found.text, found.text
            cases["won't"] += 1
        else:
            distance, then = there
            assert {c.start for c in found.claims if c.fluent == atom} == {moment.now + distance}
            at = moment.now + distance + 1
            assert {a.action for a in found.actions if a.at == at} == then, found.text
            for action in then:
                assert moment.lexicon.deed(action).bare in found.text
            cases["can be"] += 1
        if cases["can be"] >= CASES:
            return


@pytest.mark.parametrize("name", NAMES)
def test_what_if_not_follows_the_branches_on_which_it_is_not_so(name: str) -> None:
    chance = Random(f"what if not {name}")
    for moment, judge in islice(_moments(name, chance), CASES):
        atom = chance.choice(
            sorted({a for node in judge.policy.values() for a in node["state"]} - moment.static)
        )
        found = answer_at(_what_if(atom, moment, negative=True), moment)
        assert judge.failures(found.to_json(0, "", 0.0)) == [], found.text
        if atom in moment.state:
            there = _where(judge, atom, holds=False)
            if there is None:
                assert "can't be" in found.text, found.text
            else:
                at = moment.now + there[0] + 1
                assert {a.action for a in found.actions if a.at == at} == there[1], found.text
        elif len(found.actions) > 1:
            # The first action claimed decides; each of the others follows where it fails to come.
            decides, *then = sorted(found.actions, key=lambda each: each.at)
            nodes = judge.layers(decides.at - moment.now - 1)[-1]
            deciding = [i for i in nodes if judge.policy[i]["action"] == decides.action]
            outcomes = [o for i in deciding for o in judge.policy[i]["successors"]]
            allowed = {
                judge.policy[o]["action"] for o in outcomes if atom not in judge.policy[o]["state"]
            }
            assert {each.action for each in then} <= allowed, found.text


def _letters(moment: Moment, more: list[tuple[frozenset[str], str]]) -> list[frozenset[str]]:
    """What the request reads of the trace so far and of some instants after it."""
    seen = list(zip(moment.states, moment.actions, strict=True))
    whole = [(state | moment.static, action) for state, action in [*seen, *more]]
    symbols = resolve_all(atoms(parse(moment.mission.goal)), moment.problem)
    return [letter(symbols, state, action) for state, action in whole]


def _lost(trace: list[frozenset[str]], part: Formula, chance: Random) -> bool:
    """Whether none of many ways on would still satisfy a part of the request."""
    names = sorted(atoms(part))
    for _ in range(300):
        further = [
            frozenset(name for name in names if chance.random() < 0.5)
            for _ in range(chance.randrange(4))
        ]
        if holds(part, [*trace, *further]):
            return False
    return True


@pytest.mark.parametrize("name", ["depot", "hospital"])
def test_what_would_break_the_request_leaves_no_way_to_keep_it(name: str) -> None:
    chance = Random(f"broken {name}")
    cases = 0
    for moment, _ in islice(_moments(name, chance), 400):
        state = moment.whole(moment.state)
        action = chance.choice(sorted(applicable_actions(moment.problem, state)))
        schema, *arguments = action.split()
        asked = Referents(objects=tuple(arguments), actions=(schema,))
        deed = moment.lexicon.deed(action).bare
        found = answer_at(Question(Kind.WHY_NOT, f"Why don't you {deed}?", asked), moment)
        parts = conjuncts(parse(moment.mission.goal))
        before = _letters(moment, [])
        lost = {
            part
            for after in successors(moment.problem, state, action)
            for part in parts
            if not _lost(before, part, chance)
            and _lost(_letters(moment, [(after, action)]), part, chance)
        }
        if found.text.startswith(f"I could {deed}, but you want"):
            assert lost, found.text
            cases += 1
        elif found.text.startswith(f"I could {deed} now"):
            assert not lost, found.text
    assert cases >= (1 if name == "hospital" else 5)
