"""Italian: forms by hand, and every template told of real missions."""

import re
from pathlib import Path
from string import Formatter

import pytest
from click.testing import CliRunner
from tests.questions.missions import EXAMPLES, VINEYARD, run
from tests.questions.test_soundness import QUESTIONS

from plainspoken.cli import plainspoken
from plainspoken.errors import InputFileError
from plainspoken.questions import italian
from plainspoken.questions.answer import answer_at
from plainspoken.questions.moment import Moment
from plainspoken.questions.retelling import retold
from plainspoken.questions.translated import Speaker, read_words

FILE = EXAMPLES / "vineyard" / "words.it.json"
WORDS = read_words(FILE, VINEYARD.parsed)
SPEAKER = Speaker(WORDS, VINEYARD.parsed, "rob")


@pytest.mark.parametrize(
    ("verb", "doing", "did", "shall"),
    [
        ("controllare", "sto controllando", "ho controllato", "controllerò"),
        ("mettere", "sto mettendo", "ho messo", "metterò"),
        ("andare", "sto andando", "sono andato", "andrò"),
        ("caricare", "sto caricando", "ho caricato", "caricherò"),
        ("lasciare", "sto lasciando", "ho lasciato", "lascerò"),
        ("pulire", "sto pulendo", "ho pulito", "pulirò"),
        ("fare", "sto facendo", "ho fatto", "farò"),
        ("raccogliere", "sto raccogliendo", "ho raccolto", "raccoglierò"),
    ],
)
def test_verbs_have_their_forms(verb: str, doing: str, did: str, shall: str) -> None:
    assert italian.is_doing(verb, me=True) == doing
    assert italian.has_done(verb, me=True) == did
    assert italian.future(verb, me=True) == shall


@pytest.mark.parametrize(
    ("noun", "one", "several"),
    [
        ("filare", "il filare", "i filari"),
        ("cassa", "la cassa", "le casse"),
        ("scaffale", "lo scaffale", "gli scaffali"),
        ("uva", "l'uva", "le uve"),
        ("armadio", "l'armadio", "gli armadi"),
        ("zaino", "lo zaino", "gli zaini"),
        ("banco", "il banco", "i banchi"),
        ("robot di supporto", "il robot di supporto", "i robot di supporto"),
        ("stazione", "la stazione", "le stazioni"),
        ("Anna", "Anna", "Anna"),
    ],
)
def test_nouns_have_articles_and_plurals(noun: str, one: str, several: str) -> None:
    feminine = italian.is_feminine(noun)
    assert italian.with_article(noun, feminine=feminine) == one
    if noun[0].islower():
        plural = italian.plural(noun)
        assert italian.with_article(plural, feminine=feminine, several=True) == several


def test_facts_agree_in_number_and_gender() -> None:
    assert SPEAKER.facts(["full b"]) == "la cassa è piena"
    assert SPEAKER.facts(["ripe g0", "ripe g1"]) == "i grappoli 0 e 1 sono maturi"
    assert SPEAKER.facts(["inside g0 b"], negative=True) == "il grappolo 0 non è nella cassa"
    assert SPEAKER.facts(["robot-at rob l1"]) == "sono al filare 1"
    assert SPEAKER.facts(["cleared l0"], "that") == "il filare 0 sia a posto"


def test_deeds_join_what_is_done_to_several_things() -> None:
    moves = ["move rob l0 l1", "move rob l1 l2", "move rob l2 wh"]
    assert SPEAKER.deeds(moves, "did") == "sono andato ai filari 1 e 2 e al magazzino"
    two = ["check-grape rob g0 l0", "harvest-grape rob g0 l0"]
    said = "controllerò il grappolo 0 o raccoglierò il grappolo 0"
    assert SPEAKER.deeds(two, "shall", "o") == said


def _answers() -> list[str]:
    found = []
    for name in ("vineyard", "avoiding"):
        for seed in (1, 2):
            entries = run(name, seed)
            for at in range(0, len(entries), 4):
                moment = Moment(entries, at)
                asked = (*QUESTIONS, "Why don't you move to line 3?", "What if grape 1 is ripe?")
                found += [retold(answer_at(each, moment), moment, WORDS) for each in asked]
    return found


def test_answers_hold_no_english_no_names_of_files_and_no_slots() -> None:
    foreign = re.compile(r"\b(?:the|is|are|I'm|grape|line|box|l\d|g\d|rob|sup|wh)\b|[{}]|\?[a-z]")
    for text in _answers():
        assert text, "an answer"
        assert not foreign.search(text), text
        assert text[0].isupper(), text
        assert text.endswith("."), text
        assert not re.search(r"\b(?:a|da|di|in|su) (?:il|lo|la|l'|i|gli|le) ", text), text


def test_most_templates_are_told_of_real_missions_and_each_fills_its_slots() -> None:
    told = " ".join(_answers()).lower()
    used = 0
    for name, template in italian.TEMPLATES.items():
        slots = {slot for _, slot, _, _ in Formatter().parse(template) if slot}
        filled = template.format(**dict.fromkeys(slots, "x"))
        assert "{" not in filled, name
        pieces = [piece for piece in re.split(r"\{\w+\}", template) if len(piece) > 4]
        used += bool(pieces) and all(piece in told for piece in pieces)
    assert used >= 20


def test_a_file_that_lacks_words_says_which(tmp_path: Path) -> None:
    path = tmp_path / "words.json"
    path.write_text(FILE.read_text().replace('"full"', '"fuller"'))
    with pytest.raises(InputFileError, match="no words for full"):
        read_words(path, VINEYARD.parsed)
    path.write_text("[]")
    with pytest.raises(InputFileError, match="no file of words"):
        read_words(path, VINEYARD.parsed)


def test_the_command_answers_in_italian(tmp_path: Path) -> None:
    log, home = tmp_path / "run.jsonl", {"PLAINSPOKEN_HOME": str(tmp_path)}
    carry_out = ["run", "--goal", "F cleared_l0", "--log", str(log)]
    assert CliRunner().invoke(plainspoken, carry_out, env=home).exit_code == 0
    asked = ["ask", "Where are you?", "--log", str(log), "--at", "2", "--language", "it"]
    done = CliRunner().invoke(plainspoken, asked)
    assert done.exit_code == 0, done.output
    assert done.output.startswith("Sono al "), done.output
