"""A run as a person would want to see it: a line for each thing that happens, and a bar."""

from __future__ import annotations

from collections.abc import Callable, Generator
from dataclasses import dataclass, replace

from rich.console import Console, Group
from rich.live import Live
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn
from rich.table import Table
from rich.text import Text

from plainspoken.logic.english import say
from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import Mission
from plainspoken.planning.policy import Policy, policy_from_json
from plainspoken.questions.chronicle import news, remark
from plainspoken.questions.lexicon import Lexicon
from plainspoken.world.domain import State
from plainspoken.world.event import (
    ActionFailed,
    ActionFinished,
    ActionProgressed,
    ActionStarted,
    Entry,
    MissionAccepted,
    MissionEnded,
    PolicyChosen,
    VerdictReached,
)

ROWS = 14
"""Rows of the live table; older ones scroll out of it."""

UNDER_WAY = "bold"


@dataclass(frozen=True, slots=True)
class Row:
    instant: str
    what: str
    seen: str
    style: str = ""


class Scoreboard:
    """What has happened so far, as something rich can draw."""

    def __init__(self, lexicon: Lexicon) -> None:
        self._lexicon = lexicon
        self._rows: list[Row] = []
        self._state: State = frozenset()
        self._distance: dict[int, int] = {}
        self._progress = Progress(
            TextColumn("  {task.description}"),
            BarColumn(),
            MofNCompleteColumn(),
            TextColumn("steps"),
        )
        self._bar = self._progress.add_task("shortest way", total=None)
        self._done = 0
        self._printed = 0
        self._going: dict[str, Row] = {}

    def __rich__(self) -> Group:
        return Group(self._table(self._rows[-ROWS:]), self._progress)

    def news(self) -> Table:
        """The rows since this was last asked for; one under way is told again when it is over."""
        table = self._table(self._rows[self._printed :])
        self._printed = len(self._rows) - self._under_way
        return table

    def _table(self, rows: list[Row]) -> Table:
        table = Table(box=None, padding=(0, 2))
        table.add_column("instant", justify="right", style="dim")
        table.add_column("what I do", min_width=30)
        table.add_column("what I see then")
        for row in rows:
            table.add_row(row.instant, Text(row.what), Text(row.seen), style=row.style)
        return table

    def add(self, entry: Entry) -> None:
        """Take in one entry of the log."""
        match entry.event:
            case MissionAccepted(state=state):
                self._state = state
            case PolicyChosen(document, reason, repeats):
                self._distance = distances(policy_from_json(document, "policy"))
                if reason is not None and not repeats:
                    self._rows.append(Row("", f"planned again: {reason}", "", "yellow"))
                self._advance_bar(document["initial"])
            case ActionStarted(action, _, goal_id):
                doing = self._lexicon.deed(action).doing
                self._going[goal_id] = Row("", f"{doing} ...", "", UNDER_WAY)
                self._rows.append(self._going[goal_id])
            case ActionProgressed(goal_id, _, part) if part is not None and goal_id in self._going:
                row = self._going[goal_id]
                self._going[goal_id] = replace(row, seen=part)
                self._rows[self._place_of(row)] = self._going[goal_id]
            case ActionFinished(action, goal_id, state, node, misreported):
                seen = self._news(state)
                if misreported:
                    seen += " (the robot said otherwise)"
                self._settle(
                    goal_id, Row(str(entry.instant), self._lexicon.deed(action).doing, seen)
                )
                self._done += 1
                self._advance_bar(node)
            case ActionFailed(action, goal_id, reason, state):
                doing = self._lexicon.deed(action).doing
                self._settle(goal_id, Row(str(entry.instant), doing, f"failed: {reason}", "red"))
                self._state = state
            case VerdictReached("violated", clause, together):
                lost = " | ".join(
                    say(parse(each), self._lexicon.landmarks).rstrip(".")
                    for each in together or (() if clause is None else (clause,))
                )
                row = Row("", "cannot be met any more", lost, "bold red")
                self._rows.insert(len(self._rows) - self._under_way, row)
            case MissionEnded(outcome, satisfied):
                verdict = "everything asked for is satisfied" if satisfied else "not satisfied"
                self._going.clear()
                self._rows.append(
                    Row("", outcome, verdict, "bold green" if satisfied else "bold red")
                )
            case event:
                told = remark(event)
                if told is not None:
                    self._rows.insert(
                        len(self._rows) - self._under_way, Row("", told, "", "yellow")
                    )

    @property
    def _under_way(self) -> int:
        """How many actions are under way; theirs are the last rows."""
        return len(self._going)

    def _place_of(self, row: Row) -> int:
        """Where the row of an action under way is; it is one of the last."""
        first = len(self._rows) - len(self._going)
        return first + self._rows[first:].index(row)

    def _settle(self, goal_id: str, row: Row) -> None:
        """What became of an action, before the rows of those that are still under way."""
        going = self._going.get(goal_id)
        if going is not None:
            self._rows.pop(self._place_of(going))
            del self._going[goal_id]
        self._rows.insert(len(self._rows) - self._under_way, row)

    def _advance_bar(self, node: int | None) -> None:
        left = self._distance.get(node, 0) if node is not None else 0
        self._progress.update(self._bar, completed=self._done, total=self._done + left)

    def _news(self, state: State) -> str:
        before, self._state = self._state, state
        return news(before, state, self._lexicon)


def distances(policy: Policy) -> dict[int, int]:
    """For each node the fewest actions from it to a stop."""
    before: dict[int, list[int]] = {}
    for node, successor in policy.edges():
        before.setdefault(successor.id, []).append(node.id)
    found = {node.id: 0 for node in policy.nodes if node.action is None}
    level = list(found)
    while level:
        following = []
        for id in level:
            for earlier in before.get(id, ()):
                if earlier not in found:
                    found[earlier] = found[id] + 1
                    following.append(earlier)
        level = following
    return found


def never(entry: Entry) -> bool:
    """Watch to the end."""
    del entry
    return False


def watch(
    events: Generator[Entry, None, Mission],
    board: Scoreboard,
    console: Console,
    until: Callable[[Entry], bool] = never,
) -> Mission | None:
    """Draw a run as it goes on; gives the mission when it is over or paused.

    until: stop watching, not the run, after such an entry; then there is no mission yet
    """
    mission: Mission | None
    with Live(board, console=console, transient=True, auto_refresh=False) as live:
        while True:
            try:
                entry = next(events)
            except StopIteration as end:
                mission = end.value
                break
            board.add(entry)
            live.update(board, refresh=console.is_terminal)
            if until(entry):
                mission = None
                break
    console.print(board.news())
    return mission
