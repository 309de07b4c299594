"""Nothing false is ever claimed: every claim of random answers goes before an outside judge."""

import re
from random import Random

import pytest
from tests.questions.judge import Judge
from tests.questions.missions import FURTHER, SETTINGS, run

from plainspoken.questions.answer import answer_at
from plainspoken.questions.length import Length
from plainspoken.questions.moment import Moment

QUESTIONS = (
    "What are you doing?",
    "What did you do so far?",
    "What did you do last?",
    "What are you going to do next?",
    "What is your plan?",
    "Why are you doing that?",
    "How far are you?",
    "Are you done?",
    "Where are you?",
    "When did you last move?",
    "What is the situation?",
    "How many actions have you done?",
)
VINEYARD = (
    "Is the box full?",
    "Which grapes are ripe?",
    "Which lines are not cleared?",
    "How many ripe grapes did you find?",
    "Where is the support robot?",
    "Did you check grape 1?",
    "Will you check grape 3?",
    "Will the box be full?",
    "What do you do after checking grape 2?",
    "How often did you call the support robot?",
    "Why did you check grape 1?",
    "Are you keeping away from line 3?",
    "When was line 1 cleared?",
    "What do you know about grape 1?",
    "Was the box ever full?",
    "What did you do before checking grape 1?",
    "When will you sign off line 2?",
)
WAREHOUSE = (
    "Is the door open?",
    "What are you holding?",
    "Where is package 1?",
    "Is package 2 damaged?",
    "Which packages are scanned?",
    "Will you pick up package 2?",
    "Why did you scan package 1?",
)
KITCHEN = (
    "Is plate 1 clean?",
    "Which dishes are dirty?",
    "Where is the red mug?",
    "How often did you wash plate 1?",
    "Is the water hot?",
    "Will you put away the red mug?",
    "Why did you heat the water?",
)
OWN = {"vineyard": VINEYARD, "avoiding": VINEYARD, "warehouse": WAREHOUSE, "kitchen": KITCHEN}


@pytest.mark.parametrize("name", SETTINGS)
@pytest.mark.parametrize("seed", range(6))
def test_every_claim_is_true_of_the_log_and_of_the_policy(name: str, seed: int) -> None:
    entries = run(name, seed)
    chance = Random(seed)
    for at in sorted(chance.sample(range(1, len(entries)), min(8, len(entries) - 1))):
        moment, judge = Moment(entries, at), Judge(entries, at)
        for question in (*QUESTIONS, *OWN[name]):
            for length in Length:
                found = answer_at(question, moment, length=length).to_json(0, question, 0.0)
                assert judge.failures(found) == [], (question, at, length, found["answer"])
                assert found["answer"], question


def test_the_judge_finds_what_is_false() -> None:
    entries = run("vineyard", 1)
    judge = Judge(entries, 10)
    false = {"claims": [], "denied": [], "actions": []}
    claim = {"fluent": "cleared l3", "from": 0, "to": judge.now, "certainty": "is"}
    assert judge.failures({**false, "claims": [claim]})
    assert judge.failures({**false, "claims": [{**claim, "certainty": "was"}]})
    soon = {"fluent": "cleared l3", "from": judge.now + 1, "to": judge.now + 1}
    assert judge.failures({**false, "claims": [{**soon, "certainty": "will"}]})
    assert judge.failures({**false, "claims": [{**soon, "certainty": "may"}]})
    here = {"fluent": "robot-at rob l2", "from": judge.now, "to": judge.now, "certainty": "is"}
    assert judge.failures({**false, "denied": [here]})
    assert judge.failures(
        {**false, "actions": [{"action": "move rob l0 l1", "at": 2, "certainty": "was"}]}
    )


@pytest.mark.parametrize("name", SETTINGS)
def test_a_brief_answer_claims_only_what_its_words_speak_of(name: str) -> None:
    entries = run(name, 2)
    for at in range(1, len(entries), 3):
        moment = Moment(entries, at)
        lexicon = moment.lexicon
        for question in QUESTIONS:
            found = answer_at(question, moment)
            text = found.text.lower()
            if found.rest or "only" in text:
                continue  # Then it speaks of all the others, too.
            changed = {claim.at for claim in found.actions}
            for claim in found.claims:
                clause = lexicon.clause(claim.fluent)
                # The noun of it, alone or in a list: "grapes 0 and 1".
                nouns = [lexicon.type_words(each) for each in claim.fluent.split()[1:]]
                spoken = [clause.complement, clause.subject, *nouns]
                by_a_deed = claim.start in changed or claim.end + 1 in changed
                assert by_a_deed or any(each.lower() in text for each in spoken), (text, claim)


@pytest.mark.parametrize("name", [*SETTINGS, *FURTHER])
@pytest.mark.parametrize("length", Length)
def test_no_answer_holds_names_of_the_files_or_logic(name: str, length: Length) -> None:
    entries = run(name, 4, most=60)
    problem = Moment(entries).problem
    codes = [o for o in problem.objects if re.fullmatch(r"[a-z]{1,2}\d*|.*_.*", o)]
    files = {*codes, *(p for p in problem.domain.predicates if "-" in p)}
    files -= {"a", "i"}
    foreign = re.compile(
        rf"(?<![\w-])(?:{'|'.join(map(re.escape, sorted(files))) or '(?!)'})(?![\w-])"
        r"|[a-z]_[a-z]|\?[a-z]|[&|~^<>{}]|\b[GFXUWR] ?\(|\(|\bLTL|\bnode \d|\bNone\b"
    )
    for at in range(1, len(entries), 6):
        moment = Moment(entries, at)
        for question in QUESTIONS:
            text = answer_at(question, moment, length=length).text
            assert not foreign.search(text), text
