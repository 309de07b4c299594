"""A simulated robot whose world is kept in a file, and goes on while nobody watches.

A real robot does not stop when the program that commands it is killed, and remembers what it was
told. This one does neither: what it was told ends at its own time, whichever process asks next.
"""

from __future__ import annotations

import json
import sqlite3
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing, contextmanager
from dataclasses import dataclass
from pathlib import Path

from plainspoken.errors import InputFileError
from plainspoken.mission.mission import GoalId
from plainspoken.mission.robot import (
    Failed,
    GoalStatus,
    Seconds,
    Succeeded,
    UnderWay,
    Unheard,
)
from plainspoken.mission.simulator import Simulator, Steering
from plainspoken.world.domain import GroundAction, Problem, State

WorldName = str

BUSY_SECONDS = 30.0
TABLES = """
CREATE TABLE IF NOT EXISTS world (name TEXT PRIMARY KEY, state TEXT NOT NULL);
CREATE TABLE IF NOT EXISTS command (
  number INTEGER PRIMARY KEY, goal TEXT NOT NULL UNIQUE, world TEXT NOT NULL, action TEXT NOT NULL,
  before TEXT NOT NULL, outcome TEXT NOT NULL, failure TEXT, begins REAL NOT NULL,
  ends REAL NOT NULL, status TEXT NOT NULL, repeats INTEGER NOT NULL DEFAULT 0);
"""
"""outcome: what the action leads to, if it comes to its end; repeats: see `Deed`."""


@dataclass(frozen=True, slots=True)
class Deed:
    """A command that the robot was given; times in seconds of the system's clock.

    status:  under way, done, failed
    repeats: how often it was sent again, after it was heard; that changed nothing
    """

    goal_id: GoalId
    action: GroundAction
    begins: Seconds
    ends: Seconds
    status: str
    repeats: int


class KeptSimulator:
    """A robot in one world of a file; a file may hold many."""

    def __init__(
        self,
        path: str | Path,
        world: WorldName,
        problem: Problem,
        *,
        seed: int = 0,
        steering: Sequence[Steering] = (),
        durations: Mapping[str, tuple[Seconds, Seconds]] | None = None,
        pace: float = 0.0,
        clock: Callable[[], Seconds] = time.time,
        sleep: Callable[[Seconds], None] = time.sleep,
    ) -> None:
        """Find a world, or make it as the problem's s0 has it; else as `Simulator` is set up.

        clock: has to be one for all processes
        raises InputFileError: when the file holds something else
        """
        self._path, self._world, self._problem = Path(path), world, problem
        self._seed, self._steering, self._durations = seed, tuple(steering), durations
        self._pace, self._clock, self._sleep = pace, clock, sleep
        self._path.parent.mkdir(parents=True, exist_ok=True)
        with self._opened() as file:
            file.execute("PRAGMA journal_mode = WAL")
            file.executescript(TABLES)
        with self._now() as file:
            file.execute(
                "INSERT OR IGNORE INTO world VALUES (?, ?)", (world, _text(problem.initial))
            )

    def state(self) -> State:
        with self._now() as file:
            return self._state(file)

    def send(self, goal_id: GoalId, action: GroundAction) -> None:
        """Begin an action. A goal id heard before is ignored, and counted."""
        with self._now() as file:
            known = file.execute(
                "UPDATE command SET repeats = repeats + 1 WHERE goal = ?", (goal_id,)
            )
            if known.rowcount:
                return
            before = self._state(file)
            outcome, failure, lasts = self._foretold(file, before, action)
            now = self._clock()
            file.execute(
                "INSERT INTO command (goal, world, action, before, outcome, failure, begins, ends,"
                " status) VALUES (?, ?, ?, ?, ?, ?, ?, ?, 'under way')",
                (
                    goal_id,
                    self._world,
                    action,
                    _text(before),
                    _text(outcome),
                    failure,
                    now,
                    now + lasts * self._pace,
                ),
            )

    def wait(self, goal_id: GoalId, timeout: Seconds) -> GoalStatus:
        status = self._status(goal_id)
        if isinstance(status, UnderWay):
            with self._opened() as file:
                (ends,) = file.execute(
                    "SELECT ends FROM command WHERE goal = ?", (goal_id,)
                ).fetchone()
            self._sleep(max(0.0, min(timeout, ends - self._clock())))
            status = self._status(goal_id)
        return status

    def cancel(self, goal_id: GoalId) -> None:
        """Give an action up: it changes nothing."""
        with self._now() as file:
            file.execute(
                "UPDATE command SET status = 'failed', failure = 'cancelled', ends = ?"
                " WHERE goal = ? AND status = 'under way'",
                (self._clock(), goal_id),
            )

    def deeds(self) -> tuple[Deed, ...]:
        """What the robot was told in this world, in order."""
        with self._now() as file:
            rows = file.execute(
                "SELECT goal, action, begins, ends, status, repeats FROM command WHERE world = ?"
                " ORDER BY number",
                (self._world,),
            ).fetchall()
        return tuple(Deed(*row) for row in rows)

    # -- inside --------------------------------------------------------------------------------

    def _status(self, goal_id: GoalId) -> GoalStatus:
        with self._now() as file:
            row = file.execute(
                "SELECT status, failure, begins, ends FROM command WHERE goal = ?", (goal_id,)
            ).fetchone()
            if row is None:
                return Unheard()
            status, failure, begins, ends = row
            match status:
                case "done":
                    return Succeeded(self._state(file))
                case "failed":
                    return Failed(failure, self._state(file))
                case _:
                    share = (self._clock() - begins) / max(ends - begins, 1e-9)
                    return UnderWay(min(max(share, 0.0), 1.0))

    def _foretold(
        self, file: sqlite3.Connection, before: State, action: GroundAction
    ) -> tuple[State, str | None, Seconds]:
        """What an action will lead to, why it will fail if it will, and how long it takes."""
        done = file.execute(
            "SELECT before, action FROM command WHERE world = ? AND status = 'done'"
            " ORDER BY number",
            (self._world,),
        ).fetchall()
        simulator = Simulator(
            self._problem,
            seed=self._seed,
            steering=self._steering,
            state=before,
            history=[(_state(text), deed) for text, deed in done],
            durations=self._durations,
        )
        simulator.send("", action)
        status = simulator.wait("", 0.0)
        failure = status.reason if isinstance(status, Failed) else None
        return simulator.state(), failure, simulator.elapsed

    def _state(self, file: sqlite3.Connection) -> State:
        (text,) = file.execute("SELECT state FROM world WHERE name = ?", (self._world,)).fetchone()
        return _state(text)

    @contextmanager
    def _now(self) -> Iterator[sqlite3.Connection]:
        """One transaction, once all that is due by now has come to its end."""
        with self._opened() as file:
            file.execute("BEGIN IMMEDIATE")
            with file:  # commits, or takes everything back
                self._come_to_an_end(file)
                yield file

    def _come_to_an_end(self, file: sqlite3.Connection) -> None:
        due = file.execute(
            "SELECT goal, before, outcome, failure FROM command"
            " WHERE world = ? AND status = 'under way' AND ends <= ? ORDER BY ends",
            (self._world, self._clock()),
        ).fetchall()
        for goal, before, outcome, failure in due:
            status = "done" if failure is None else "failed"
            file.execute("UPDATE command SET status = ? WHERE goal = ?", (status, goal))
            # What it changes, and no more: another action may have ended meanwhile.
            was, then = _state(before), _state(outcome)
            state = (self._state(file) - (was - then)) | (then - was)
            file.execute("UPDATE world SET state = ? WHERE name = ?", (_text(state), self._world))

    @contextmanager
    def _opened(self) -> Iterator[sqlite3.Connection]:
        try:
            with closing(
                sqlite3.connect(self._path, timeout=BUSY_SECONDS, isolation_level=None)
            ) as file:
                # The robot outlives a process, not a power cut: that is for the log to survive.
                file.execute("PRAGMA synchronous = OFF")
                yield file
        except sqlite3.Error as error:
            raise InputFileError(
                f"cannot use the simulated robot's world: {error}",
                self._path,
                hint="give another file",
            ) from error


def _text(state: State) -> str:
    return json.dumps(sorted(state))


def _state(text: str) -> State:
    return frozenset(json.loads(text))
