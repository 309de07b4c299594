"""What the interface for programs works with and keeps: plans that wait to be confirmed."""

from __future__ import annotations

import secrets
import threading
import time
from collections import OrderedDict
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

from plainspoken.logic.formula import Formula
from plainspoken.planning.policy import Policy
from plainspoken.web.access import Caller
from plainspoken.web.desk import HEARD_WITHIN, Desk, PlaceName
from plainspoken.web.feed import Feed
from plainspoken.web.hearing import Hearing
from plainspoken.web.rate import Rate, Rates, Seats
from plainspoken.web.standing import Standings

THINKING = Rate("sentences, questions and plans", 5, 30)
COMMANDING = Rate("commands", 5, 30)

PLAN_LASTS = 15 * 60.0
"""Seconds in which a plan has to be confirmed: the world goes on."""
MOST_PLANS = 64


@dataclass(frozen=True)
class WaitingPlan:
    """A policy that nobody has confirmed yet; by: whose it is."""

    by: str
    place: PlaceName
    goal: Formula
    sentence: str | None
    policy: Policy


class Plans:
    """Plans by name, each until it is taken, or too old."""

    def __init__(self, now: Callable[[], float] = time.monotonic) -> None:
        self._now = now
        self._lock = threading.Lock()
        self._plans: OrderedDict[str, tuple[float, WaitingPlan]] = OrderedDict()

    def keep(self, plan: WaitingPlan) -> str:
        """Give a plan a name."""
        name = secrets.token_urlsafe(12)
        with self._lock:
            self._plans[name] = (self._now() + PLAN_LASTS, plan)
            if len(self._plans) > MOST_PLANS:
                self._plans.popitem(last=False)
        return name

    def get(self, name: str, caller: Caller) -> WaitingPlan | None:
        """A plan of a caller; None where there is none any more."""
        with self._lock:
            until, plan = self._plans.get(name, (0.0, None))
        return plan if plan and until > self._now() and plan.by == caller.name else None

    def take(self, name: str) -> bool:
        """Have a plan lead to a mission, once; False where somebody was quicker."""
        with self._lock:
            return self._plans.pop(name, None) is not None


class Office:
    """The desk, and what programs need beside it.

    robot:   which robot carries out what is started here, for its log
    hearing: of recordings, None where there is none
    """

    def __init__(
        self,
        desk: Desk,
        *,
        robot: Mapping[str, Any] | None = None,
        rates: Rates | None = None,
        hearing: Hearing | None = None,
        patience: float = HEARD_WITHIN,
    ) -> None:
        """Open an office at a desk; patience: seconds to wait for a command to be heard."""
        self.desk = desk
        self.robot = dict(robot or {})
        self.hearing = hearing
        self.feed = Feed(desk)
        self.standings = Standings(desk)
        self.plans = Plans()
        self.rates = rates or Rates()
        self.patience = patience
        self.viewers = Seats("streams of events", total=256, each=64)
        self.planners = Seats("plans", total=2, each=1)
        self.askers = Seats("questions", total=8, each=4)
