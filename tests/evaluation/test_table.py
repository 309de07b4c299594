from pathlib import Path
from xml.etree import ElementTree as ET

import pytest
from tests.evaluation.small_corpus import accepted, mentioned, right, small_rows, told

from plainspoken.evaluation.corpus import Row
from plainspoken.evaluation.experiment import run_experiment
from plainspoken.evaluation.figure import BAR, picture
from plainspoken.evaluation.metric import Share
from plainspoken.evaluation.summary import Summary, summarised, summary_to_json
from plainspoken.evaluation.table import confusion, markdown, mistaken, shown, tables
from plainspoken.language.extraction import Extraction, Status

SVG = "{http://www.w3.org/2000/svg}"


def wrong(row: Row) -> Extraction:
    return accepted(
        row,
        "F cellar & F attic",
        pattern="Visit",
        referring_expressions=(
            mentioned(row, "The hall", "cellar"),
            mentioned(row, "the attic", "attic"),
        ),
    )


def refused(row: Row) -> Extraction:
    return Extraction(row.utterance, Status.REJECT, reason="neither | nor\n& <b>")


@pytest.fixture
def summary(tmp_path: Path) -> Summary:
    rows = small_rows(tmp_path)
    translate = told({"one": right, "two": wrong, "three": refused})
    results = [result for result, _ in run_experiment(rows, "test", translate, timed=False)]
    return summarised(rows, results, corpus="a & b", mode="test", version="1")


def test_the_figures_are_split_by_group_and_by_pattern(summary: Summary) -> None:
    assert summary.total.literal == Share(1, 3)
    assert [(each.name, each.literal) for each in summary.groups] == [
        ("navigation", Share(1, 2)),
        ("generic", Share(0, 1)),
    ]
    assert {each.name: each.executable for each in summary.patterns} == {
        "visit": Share(1, 1),
        "sequenced visit": Share(0, 1),
        "past avoidance": Share(0, 1),
    }
    # "the hall" of the first sentence is not recognised, that of the second is taken for another
    assert summary.mentions.recall == Share(1, 3)
    assert summary.mentions.grounding == Share(1, 2)


def test_the_confusion_has_a_cell_for_every_sentence(summary: Summary) -> None:
    assert summary.confusion == {
        ("visit", "visit"): 1,
        ("sequenced visit", "visit"): 1,
        ("past avoidance", "(refused)"): 1,
    }
    table = confusion(summary)
    assert table.columns == ("gold", "visit", "(refused)")
    assert ("sequenced visit", "1", "") in table.rows
    assert ("sequenced visit", "visit", "1") in mistaken(summary).rows
    assert all(gold != recognised for gold, recognised, _ in mistaken(summary).rows)


def test_a_share_is_shown_with_its_interval() -> None:
    assert shown(Share(5, 10)) == "50.0% [23.7, 76.3] 5/10"
    assert shown(Share(0, 0)) == "-"


def test_the_page_lists_what_is_not_right_without_breaking_its_tables(summary: Summary) -> None:
    page = markdown(summary)
    assert "neither \\| nor & <b>" in page
    assert "Go to the hall." not in page
    for block in page.split("\n\n"):
        if block.startswith("|"):
            cells = {line.replace("\\|", "").count("|") for line in block.splitlines()}
            assert len(cells) == 1
    assert [table.title for table in tables(summary)] == [
        line.removeprefix("## ") for line in page.splitlines() if line.startswith("## ")
    ][:-1]


def test_the_json_holds_every_figure_with_its_interval(summary: Summary) -> None:
    document = summary_to_json(summary)
    assert document["total"]["literal"]["count"] == 1
    assert document["total"]["literal"]["ci95"] == pytest.approx([0.0615, 0.7923], abs=1e-4)
    assert sum(document["outcomes"].values()) == 3
    assert [each["id"] for each in document["failures"]] == ["two", "three"]


def test_the_picture_has_a_bar_and_an_interval_for_every_share(summary: Summary) -> None:
    root = ET.fromstring(picture(summary))  # noqa: S314 - our own text
    lines = 1 + len(summary.groups) + len(summary.patterns)
    whiskers = root.findall(f"{SVG}path")
    # The first rectangle of each kind is its entry in the legend.
    bars = [each for each in root.findall(f"{SVG}rect") if each.get("class") == "literal"][1:]
    assert len(bars) == lines
    assert len(whiskers) == 2 * lines
    lengths = {
        each.literal.value: bar.get("width")
        for each, bar in zip((summary.total, *summary.groups, *summary.patterns), bars, strict=True)
    }
    assert lengths[0.5] == f"{BAR / 2:.1f}"


def test_a_name_with_signs_of_xml_does_not_break_the_picture(tmp_path: Path) -> None:
    rows = small_rows(tmp_path)[:1]
    results = [result for result, _ in run_experiment(rows, "<&>", right)]
    made = summarised(rows, results, corpus="c", mode='<&">', version="1")
    assert ET.fromstring(picture(made)) is not None  # noqa: S314 - our own text
