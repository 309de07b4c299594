"""What a view holds, as HTML. Whoever speaks is told by words and signs, never by colour alone."""

from __future__ import annotations

from collections.abc import Sequence
from datetime import datetime

from plainspoken.automata.verdict import Verdict
from plainspoken.knowledge.facts import Knowledge, Source
from plainspoken.mission.mission import Status
from plainspoken.questions.chronicle import Line
from plainspoken.web.page.drawing import LegendEntry
from plainspoken.web.page.markup import Html, tag
from plainspoken.web.page.view import Clause, Known, age

MOST_LINES = 150
"""Lines of a log that are shown at once; the slider reaches the others."""

_VERDICTS = {
    Verdict.SATISFIED: ("✓", "done", "good"),
    Verdict.HOLDS_SO_FAR: ("✓", "kept so far", "kept"),
    Verdict.OPEN: ("○", "still open", "open"),
    Verdict.VIOLATED: ("×", "broken", "bad"),
}
_STATUS = {
    Status.PLANNING: ("…", "planning"),
    Status.RUNNING: ("▶", "running"),
    Status.PAUSED: ("❚❚", "paused"),
    Status.FINISHED: ("✓", "finished"),
    Status.CANCELLED: ("×", "cancelled"),
    Status.STOPPED: ("■", "stopped"),
}
_SORTS = {
    "action": ("●", "action"),
    "seen": ("◉", "seen"),
    "trouble": ("▲", "trouble"),
    "person": ("☻", "person"),
    "plan": ("◆", "plan"),
    "end": ("■", "end"),
}
_SOURCES = {
    Source.INITIAL: "from the start",
    Source.ACTION: "seen after an action",
    Source.OBSERVATION: "looked at",
    Source.REPORT: "reported",
}


def status(of: Status) -> Html:
    """Where a mission stands, as a small sign with its word."""
    sign, word = _STATUS[of]
    return tag("span", _sign(sign), f" {word}", class_=f"status {of}")


def clauses(parts: Sequence[Clause]) -> Html:
    """Each part of the request with its verdict."""
    rows = []
    for each in parts:
        sign, word, tone = _VERDICTS[each.verdict]
        verdict = tag("span", _sign(sign), f" {word}", class_=f"verdict {tone}")
        rows.append(tag("li", tag("span", each.english), verdict))
    return tag("ul", *rows, class_="clauses")


def timeline(lines: Sequence[Line], most: int = MOST_LINES) -> Html:
    """The latest lines of a log, the oldest first."""
    left_out = len(lines) - most
    rows = [_line(each) for each in lines[-most:]]
    if left_out > 0:
        rows.insert(0, tag("li", f"{left_out} earlier lines: move the slider to see them",
                           class_="earlier", data_key="earlier"))  # fmt: skip
    return tag("ol", *rows, class_="timeline")


def _line(line: Line) -> Html:
    sign, word = _SORTS[line.sort]
    going = " going" if line.going else ""
    return tag(
        "li",
        tag("button", _clock(line.time), type="button", class_="moment", data_pick=str(line.step),
            aria_label=f"show how it was at {_clock(line.time)}, step {line.step}"),
        tag("span", _sign(sign), tag("span", word, class_="spoken-only"),
            class_=f"sort {line.sort}"),
        tag("span", tag("b", line.text), f" {line.came_of}" if line.came_of else None),
        data_key=f"line {line.steps[0] if line.steps else line.time}",
        data_step=" ".join(map(str, line.steps)),
        class_=f"line{going}",
    )  # fmt: skip


def known(facts: Sequence[Known], now: datetime, *, is_past: bool = False) -> Html:
    """A table of what is known, how old it is, and what says so; and of what is not.

    is_past: whether `now` is a moment that is looked back at, from which nothing grows older
    """
    head = tag("tr", *(tag("th", word, scope="col") for word in ("fact", "since", "how I know")))
    rows = [_fact(each, now, is_past=is_past) for each in facts]
    return tag("table", tag("thead", head), tag("tbody", *rows), class_="known")


def _fact(each: Known, now: datetime, *, is_past: bool) -> Html:
    known, fact = each.knowledge, each.fact
    kind = "true" if known.holds else "false" if known.holds is False else "unknown"
    doubt, since = None, fact.time
    if known.is_stale:
        doubt, since, kind = "too long ago: not sure any more", known.seen, "stale"
    elif known.holds is None:
        doubt = "not known"
    said = tag("span", _sign("?"), f" {doubt}", class_="verdict open") if doubt else None
    old = age(since, now)
    when: str = old if is_past else tag("time", old, datetime=since)
    if kind == "unknown":
        when = "–"
    return tag(
        "tr",
        tag("td", each.text, tag("br") if said else None, said),
        tag("td", when, title=f"step {known.step if doubt else fact.step}"),
        tag("td", _how(known)),
        data_key=f"fact {fact.atom}",
        data_thing=" ".join(each.things),
        class_=kind,
    )


def _how(known: Knowledge) -> str:
    """Where a fact is known from, or why it is not."""
    fact = known.fact
    if known.vain is not None:
        return "looked at since, and could not tell"
    if fact.holds is None:
        return "nobody has looked"
    if fact.source is Source.OBSERVATION and fact.by == "model":
        return "follows from what was seen"
    by = f" by {fact.by}" if fact.by and fact.source in (Source.REPORT, Source.OBSERVATION) else ""
    return f"{_SOURCES[fact.source]}{by}"


def legend(entries: Sequence[LegendEntry]) -> Html:
    """What the signs of a map mean."""
    return tag(
        "ul",
        *(
            tag("li", _sign(each.mark.sign, f"dot {each.mark.tone}"), each.words)
            for each in entries
        ),
        class_="legend",
    )  # fmt: skip


def buttons(texts: Sequence[str], label: str, kind: str = "chip") -> Html:
    """Texts to pick from; what is picked is its place."""
    return tag(
        "div",
        *(
            tag("button", text, type="button", class_=kind, data_pick=str(index))
            for index, text in enumerate(texts)
        ),
        class_="choices",
        role="group",
        aria_label=label,
    )


def _sign(sign: str, classes: str = "sign") -> Html:
    return tag("span", sign, aria_hidden="true", class_=classes)


def _clock(time: str) -> str:
    return datetime.fromisoformat(time).astimezone().strftime("%H:%M:%S")


def tabs(names: Sequence[str]) -> Html:
    """The parts of a page that are shown one at a time where there is little room."""
    return tag(
        "div",
        *(
            tag("button", name, type="button", role="tab", id=f"tab-{name.lower()}",
                aria_controls=name.lower(), aria_selected="false", data_tab=name.lower())
            for name in names
        ),
        role="tablist",
        aria_label="parts of this page",
    )  # fmt: skip


def graph_legend() -> Html:
    """What the shapes of a plan mean."""
    words = {
        "past": "was done",
        "present": "now",
        "future": "may come",
        "missed": "can come no more",
        "stop": "done",
        "fold": "several, opens",
    }
    return tag(
        "ul",
        *(tag("li", tag("span", class_=f"box {kind}", aria_hidden="true"), said)
          for kind, said in words.items()),
        class_="legend",
    )  # fmt: skip
