"""A server of the page whose robots end an action only when they may.

usage: serving.py PORT STORE FILE [--tokens TOKENS] [--deaf | --whisper]

FILE holds how many actions of each mission may end; where there is none, all may. So a test can
look at a mission in its third action for as long as it likes, on a machine that is slow or fast.

What is said to it is heard by pitch: "never visit line N" is a tone of N hundred hertz. So a test
knows that what the browser sent is what its microphone heard.
"""

import argparse
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

from plainspoken.cli.serve import EXAMPLES
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.knowledge.store import Store
from plainspoken.language.transcription import SAMPLE_RATE, HeardWord, Samples, Transcript
from plainspoken.mission.robot import GoalStatus, Robot, UnderWay
from plainspoken.mission.run import Patience
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Site, bundled, open_site
from plainspoken.web.access import Access, GrantFile
from plainspoken.web.address import Names
from plainspoken.web.desk import Desk
from plainspoken.web.front import behind_gate, caller_of
from plainspoken.web.hearing import Hearing, whisper_hearing
from plainspoken.web.page.layout import read_layout
from plainspoken.web.server import create_app, run
from plainspoken.world.domain import Problem, State
from plainspoken.world.event import Entry


class Led(Simulator):
    """A simulated robot that waits with the end of an action until it may come."""

    def __init__(self, problem: Problem, allowed: Path, state: State | None) -> None:
        super().__init__(problem, state=state)
        self._allowed = allowed
        self._given_up: set[str] = set()

    def cancel(self, goal_id: str) -> None:
        super().cancel(goal_id)
        self._given_up.add(goal_id)

    def wait(self, goal_id: str, timeout: float) -> GoalStatus:
        number = int(goal_id.rpartition("/")[2])
        waits = self._allowed.exists() and number > int(self._allowed.read_text())
        if waits and goal_id in self._goals and goal_id not in self._given_up:
            time.sleep(min(timeout, 0.05))
            return UnderWay(0.5)
        return super().wait(goal_id, timeout)


def by_pitch(samples: Samples, _: Sequence[str], /) -> Transcript:
    """What is said by a tone."""
    loudest = int(np.abs(np.fft.rfft(samples)).argmax())
    number = round(loudest * SAMPLE_RATE / len(samples) / 100)
    said = ("Never", "visit", "line", f"{number}")
    words = (HeardWord(each, i / 2, i / 2 + 0.4, 0.9) for i, each in enumerate(said))
    return Transcript(tuple(words), len(samples) / SAMPLE_RATE)


def main() -> None:
    parser = argparse.ArgumentParser()
    parser.add_argument("port", type=int)
    parser.add_argument("store", type=Path)
    parser.add_argument("allowed", type=Path)
    parser.add_argument("--tokens", type=Path)
    parser.add_argument("--deaf", action="store_true")
    parser.add_argument("--whisper", action="store_true")
    chosen = parser.parse_args()
    hearing = Hearing(lambda: by_pitch, "pip install ears" if chosen.deaf else None)
    if chosen.whisper:
        hearing = whisper_hearing()
    grants = None if chosen.tokens is None else GrantFile(chosen.tokens)
    serve(chosen, hearing, Access(grants, everyone="operator"))


def serve(chosen: argparse.Namespace, hearing: Hearing, access: Access) -> None:
    @contextmanager
    def robot_for(
        site: Site, _: Mapping[str, Any], entries: Sequence[Entry]
    ) -> Iterator[tuple[Robot, Patience]]:
        states = [each.event.state for each in entries if hasattr(each.event, "state")]
        robot = Led(site.problem, chosen.allowed, states[-1] if states else None)
        yield robot, Patience(news=0.05)

    sites = {name: site_in(bundled(name)) for name in EXAMPLES}
    layout = read_layout(bundled("vineyard") / "layout.json")
    with Store(SqliteDatabase(chosen.store)) as kept:
        desk = Desk(sites, kept, robot_for)
        layouts = {sites["vineyard"].problem.name: layout}
        page = create_app(desk, layouts=layouts, visitor_of=caller_of, missing=hearing.missing)
        app = behind_gate(page, desk, access, Names.of("127.0.0.1"), hearing=hearing)
        try:
            run(app, host="127.0.0.1", port=chosen.port)
        finally:
            desk.close()


def site_in(folder: Path) -> Site:
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


if __name__ == "__main__":
    main()
