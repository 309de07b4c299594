"""What the tests of the web speak to: a desk with a vineyard of one line, behind the gate."""

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from starlette.applications import Starlette
from starlette.routing import Mount
from starlette.testclient import TestClient
from starlette.types import ASGIApp
from tests.mission.small_vineyard import DOMAIN_TEXT, PROBLEM, PROBLEM_TEXT

from plainspoken.logic.syntax import parse
from plainspoken.mission.robot import Robot
from plainspoken.mission.run import Patience
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import Request, Site
from plainspoken.planning.solver import Solved
from plainspoken.web.access import Access, Grant, Role, Token, new_grant
from plainspoken.web.address import Names
from plainspoken.web.api import Office, create_api
from plainspoken.web.api.application import PREFIX
from plainspoken.web.desk import Desk
from plainspoken.web.gate import Gate
from plainspoken.web.hearing import Hearing
from plainspoken.web.rate import Rates
from plainspoken.world.event import Entry

SITE = Site(PROBLEM, DOMAIN_TEXT, PROBLEM_TEXT)
GOAL = "F (cleared_l0 & F robot_at_rob_wh)"
HERE = "http://127.0.0.1:8765"


@contextmanager
def slow_robot(
    site: Site, set_up: Mapping[str, Any], entries: Sequence[Entry]
) -> Iterator[tuple[Robot, Patience]]:
    """Each action takes some hundredths of a second."""
    del set_up
    state = None
    for entry in entries:
        state = getattr(entry.event, "state", state)
    yield Simulator(site.problem, state=state, pace=0.01), Patience(news=0.02)


@contextmanager
def endless_robot(
    site: Site, set_up: Mapping[str, Any], entries: Sequence[Entry]
) -> Iterator[tuple[Robot, Patience]]:
    """A mission that lasts until it is cancelled: its first action takes an hour."""
    del set_up, entries
    yield Simulator(site.problem, pace=60.0), Patience(news=0.02)


@dataclass
class Bench:
    """A server in this process, and clients of it."""

    desk: Desk
    office: Office
    access: Access
    app: ASGIApp

    def client(self, token: Token | None = None, **more: Any) -> TestClient:
        """A program that shows a token."""
        headers = {} if token is None else {"Authorization": f"Bearer {token}"}
        return TestClient(self.app, base_url=HERE, headers=headers, **more)

    def started(self, mission: str = "m") -> str:
        """A mission that goes on."""
        goal = parse(GOAL)
        ending = self.desk.plan("vineyard", goal)
        assert isinstance(ending, Solved)
        return self.desk.start("vineyard", Request(mission, goal), ending.policy)

    def at_work(self) -> str:
        """A mission whose first action is under way."""
        name = self.started()
        over = time.monotonic() + 60
        while all(each.kind != "action_started" for each in self.desk.entries(name)):
            assert time.monotonic() < over, "the robot was never told anything"
            time.sleep(0.005)
        return name


def bench(
    desk: Desk,
    access: Access,
    rates: Rates | None = None,
    *,
    patience: float = 60,
    hearing: Hearing | None = None,
) -> Bench:
    """A server at a desk; patience: for commands, less where nobody is there to hear them."""
    office = Office(desk, rates=rates, patience=patience, hearing=hearing)
    inside = Starlette(routes=[Mount(PREFIX, create_api(office))])
    app = Gate(inside, access, Names.of("127.0.0.1", ["testserver"]), rates=rates)
    return Bench(desk, office, access, app)


def granted(*people: tuple[Role, str]) -> tuple[dict[str, Token], Access]:
    """The tokens of some people, and the access that they give."""
    tokens: dict[str, Token] = {}
    grants: list[Grant] = []
    for role, name in people:
        tokens[name], grant = new_grant(role, name)
        grants.append(grant)
    return tokens, Access(lambda: tuple(grants))


def until(so: Callable[[], bool]) -> None:
    """Wait for something that is about to be so."""
    deadline = time.monotonic() + 60
    while not so():
        assert time.monotonic() < deadline, "waited for too long"
        time.sleep(0.01)
