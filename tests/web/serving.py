"""A server of the page whose robots end an action only when they may: `serving.py PORT STORE FILE`.

FILE holds how many actions of each mission may end; where there is none, all may. So a test can
look at a mission in its third action for as long as it likes, on a machine that is slow or fast.
"""

import sys
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from plainspoken.cli.serve import EXAMPLES
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.knowledge.store import Store
from plainspoken.mission.robot import GoalStatus, Robot, UnderWay
from plainspoken.mission.run import Patience
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Site, bundled, open_site
from plainspoken.web.access import Access
from plainspoken.web.address import Names
from plainspoken.web.desk import Desk
from plainspoken.web.front import behind_gate, caller_of
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


def main(port: str, store: str, allowed: str) -> None:
    @contextmanager
    def robot_for(
        site: Site, _: Mapping[str, Any], entries: Sequence[Entry]
    ) -> Iterator[tuple[Robot, Patience]]:
        states = [each.event.state for each in entries if hasattr(each.event, "state")]
        robot = Led(site.problem, Path(allowed), states[-1] if states else None)
        yield robot, Patience(news=0.05)

    sites = {name: site_in(bundled(name)) for name in EXAMPLES}
    layout = read_layout(bundled("vineyard") / "layout.json")
    with Store(SqliteDatabase(Path(store))) as kept:
        desk = Desk(sites, kept, robot_for)
        layouts = {sites["vineyard"].problem.name: layout}
        page = create_app(desk, layouts=layouts, visitor_of=caller_of)
        access = Access(None, everyone="operator")
        app = behind_gate(page, desk, access, Names.of("127.0.0.1"))
        try:
            run(app, host="127.0.0.1", port=int(port))
        finally:
            desk.close()


def site_in(folder: Path) -> Site:
    return open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")


if __name__ == "__main__":
    main(*sys.argv[1:])
