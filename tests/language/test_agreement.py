"""What becomes of a sentence that the rules and the network have both read."""

from dataclasses import replace

import pytest
from tests.language.domains import DOMAINS

from plainspoken.language.agreement import evidence, likelihood, names_the_unknown, settled
from plainspoken.language.extracted import Extraction, Reading, Status
from plainspoken.language.extraction import by_rules, extract
from plainspoken.language.learned import Learned, learned
from plainspoken.language.sentence import Sentence
from plainspoken.logic.syntax import parse

HOSPITAL = DOMAINS["hospital"]
PLAIN = "Visit ward 1, then the lobby."


def heard(text: str | None, probability: float = 0.97, refusal: float = 0.0) -> Learned:
    """What a network might say."""
    if text is None:
        return Learned(None, probability, refusal or probability)
    formula = parse(text)
    return Learned(Reading(formula, formula, text, probability), probability, refusal)


def understood(utterance: str, said: Learned) -> Extraction:
    return extract(utterance, HOSPITAL, lambda _: said)


def places() -> tuple[str, str]:
    found = by_rules(Sentence.of(PLAIN, HOSPITAL))
    assert found.reading is not None
    first, second = (each.symbol for each in found.referring_expressions)
    return first, second


WARD, LOBBY = places()


def test_what_both_say_is_taken_and_the_surer_for_it() -> None:
    agreed = understood(PLAIN, heard(f"F({WARD} & F {LOBBY})"))
    assert agreed.status is Status.OK
    assert (agreed.confidence or 0) > 0.9


def test_where_they_differ_a_sure_network_is_followed() -> None:
    found = understood(PLAIN, heard(f"F({LOBBY} & F {WARD})", 0.999))
    assert found.status is Status.OK
    assert found.formula == parse(f"F({LOBBY} & F {WARD})")


def test_of_places_alone_the_rules_are_followed_where_the_network_is_not_sure() -> None:
    found = understood(PLAIN, heard(f"F({LOBBY} & F {WARD})", 0.9))
    assert found.status is Status.OK
    assert found.formula == parse(f"F({WARD} & F {LOBBY})")


def test_where_they_differ_and_neither_is_sure_the_person_is_asked() -> None:
    utterance = "Go to ward 1 while the floor is wet."
    found = understood(utterance, heard(f"F {WARD}", 0.2))
    mine = by_rules(Sentence.of(utterance, HOSPITAL)).reading
    assert mine is not None
    assert found.status is Status.CLARIFY
    assert [each.literal for each in found.alternatives] == [mine.literal, parse(f"F {WARD}")]
    assert found.question


def test_what_the_network_takes_for_no_mission_is_asked_about() -> None:
    found = understood(PLAIN, heard(None, 0.95))
    assert found.status is Status.CLARIFY
    assert len(found.alternatives) == 1


def test_a_reading_that_cannot_be_met_is_not_followed() -> None:
    found = understood(PLAIN, heard(f"F {WARD} & G !{WARD}", 0.999))
    assert found.status is Status.OK
    assert found.formula == parse(f"F({WARD} & F {LOBBY})")


def test_a_contradiction_is_never_accepted_on_the_networks_word() -> None:
    found = understood("Go to ward 1 but never go to ward 1.", heard(f"F {WARD}", 0.9999))
    assert found.status is not Status.OK


def test_what_the_rules_refuse_may_be_read_by_the_network() -> None:
    strange = "Ward 1 wants you to brighten its day at some stage."
    assert by_rules(Sentence.of(strange, HOSPITAL)).status is Status.REJECT
    assert understood(strange, heard(f"F {WARD}", 0.999)).formula == parse(f"F {WARD}")
    assert understood(strange, heard(f"F {WARD}", 0.02)).status is Status.REJECT


def test_the_rules_work_alone_where_no_network_is_wanted() -> None:
    assert extract(PLAIN, HOSPITAL, None).formula == parse(f"F({WARD} & F {LOBBY})")


def test_agreement_and_its_own_estimate_make_a_reading_likelier() -> None:
    ruled = by_rules(Sentence.of(PLAIN, HOSPITAL))

    def likely(probability: float, *, agreed: bool) -> float:
        return likelihood(evidence(heard("a", probability), ruled, agreed=agreed))

    assert likely(0.5, agreed=True) < likely(0.9, agreed=True)
    assert likely(0.9, agreed=False) < likely(0.9, agreed=True)


@pytest.mark.parametrize(
    "utterance",
    ["Dig a hole at ward 1.", "Go to ward 1 and dance.", "Tell Charlie to go to ward 1.",
     "Juggle at ward 1."],
)  # fmt: skip
def test_a_word_that_may_name_what_is_asked_for_is_asked_about(utterance: str) -> None:
    assert names_the_unknown(Sentence.of(utterance, HOSPITAL))
    assert understood(utterance, heard(f"F {WARD}", 0.999)).status is not Status.OK


@pytest.mark.parametrize(
    "utterance", ["Ward 1, chef's orders.", "Be a darling and see ward 1, sweetheart."]
)
def test_a_word_that_only_colours_a_mission_is_passed_over(utterance: str) -> None:
    assert not names_the_unknown(Sentence.of(utterance, HOSPITAL))


@pytest.mark.parametrize("utterance", ["After ward 1, you then go to the", "See ward 1, and"])
def test_a_sentence_that_breaks_off_is_not_accepted_on_the_networks_word(utterance: str) -> None:
    ruled = replace(by_rules(Sentence.of(utterance, HOSPITAL)), status=Status.REJECT)
    assert settled(Sentence.of(utterance, HOSPITAL), ruled, heard(f"F {WARD}", 0.999)) == ruled


def test_what_is_said_back_with_brackets_means_what_the_rules_read() -> None:
    said = "At every point (you are at ward 1 and the lobby is not open)."
    ruled = by_rules(Sentence.of(PLAIN, HOSPITAL))
    assert settled(Sentence.of(said, HOSPITAL), replace(ruled, utterance=said),
                   heard(f"F {WARD}", 0.999)).formula == ruled.formula  # fmt: skip


def test_an_expression_is_named_for_each_symbol_of_the_networks_reading() -> None:
    sentence = Sentence.of(PLAIN, HOSPITAL)
    found = settled(sentence, by_rules(sentence), heard(f"F {LOBBY} & G !{WARD}", 0.999))
    assert {each.symbol for each in found.referring_expressions} == {WARD, LOBBY}
    for each in found.referring_expressions:
        assert PLAIN[each.start : each.end] == each.text


def test_the_network_of_the_package_reads_a_plain_sentence() -> None:
    found = learned(Sentence.of(PLAIN, HOSPITAL))
    assert found.reading is not None
    assert found.reading.literal == parse(f"F({WARD} & F {LOBBY})")
