"""Which robot carries a mission out: a simulated one, or those that a file describes."""

from __future__ import annotations

import sys
import threading
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any, TextIO

import click

from plainspoken.cli.simulated import Settings, simulated
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.queue import RobotName
from plainspoken.knowledge.store import Store
from plainspoken.mission.mission import MissionId, mission_from
from plainspoken.mission.robot import Robot, Seconds
from plainspoken.mission.run import Patience
from plainspoken.pipeline import Site, accepted_of
from plainspoken.world.event import Entry

if TYPE_CHECKING:
    from plainspoken.backends.questions import Questions

SIMULATOR = "simulator"
KINDS = (SIMULATOR, "http", "ros2", "human")
GET_IT = "pip install 'plainspoken[robots]'"
LOOK_AGAIN: Seconds = 0.5
"""How often it is looked whether there is a question for the person at the terminal."""


@dataclass(frozen=True, slots=True)
class Robots:
    """What a log keeps of robots that a file describes.

    via:   the adapter of services that do not name one
    limit: seconds that an action may take
    names: missions that have a robot's name in common wait for each other
    """

    file: Path
    via: str | None = None
    limit: Seconds | None = None
    names: tuple[RobotName, ...] = ()

    def to_json(self) -> dict[str, Any]:
        """The field `robot` of an accepted mission."""
        document: dict[str, Any] = {
            "robot": self.via or "as the file says",
            "robots": str(self.file.absolute()),
        }
        if self.limit is not None:
            document["action_timeout"] = self.limit
        if self.names:
            document["names"] = list(self.names)
        return document


Chosen = Settings | Robots


def chosen_robot(robot: str | None, file: Path | None, settings: Settings) -> Chosen:
    """The robot that the options name; one of a file has the file's name where it has no other.

    raises UsageError: when they do not go together
    """
    if file is None:
        if robot in (None, SIMULATOR):
            return settings
        raise click.UsageError(f"--robot {robot} needs --robots FILE, which says what it can do")
    if robot == SIMULATOR:
        raise click.UsageError("--robots is for robots that are not simulated")
    if settings != Settings(limit=settings.limit, names=settings.names):
        raise click.UsageError(
            "--seed, --steer, --fault, --pace and --world are for the simulated robot"
        )
    return Robots(file, robot, settings.limit, tuple(settings.names) or (str(file.absolute()),))


def robot_in(document: Mapping[str, Any]) -> Chosen:
    """The robot that a mission's log names.

    raises PlainspokenError: when the mission is an action of another one, which has the robot
    """
    if "part_of" in document:
        raise PlainspokenError(
            f"the mission is an action of another one, {document['part_of']}",
            hint=f"plainspoken missions resume {document['part_of']}",
        )
    if "robots" not in document:
        return Settings.of(document)
    via = document["robot"] if document["robot"] in KINDS else None
    names = tuple(document.get("names", ()))
    return Robots(Path(document["robots"]), via, document.get("action_timeout"), names)


@contextmanager
def opened(
    site: Site,
    chosen: Chosen,
    *,
    mission: MissionId,
    store: Store | None,
    pace: float | None = None,
    entries: Sequence[Entry] = (),
) -> Iterator[tuple[Robot, Patience]]:
    """The robot of a mission with such a log so far, and what the mission is timed by.

    store: keeps what robots of a file were told; a simulated one needs none
    pace:  None for the one in the settings
    raises PlainspokenError: when its settings or its file are wrong, or an extra is missing
    """
    if isinstance(chosen, Settings):
        yield simulated(site, chosen, mission=mission, pace=pace, entries=entries)
        return
    state = mission_from(entries).world if entries else None
    if store is None:
        raise AssertionError("what robots of a file were told is kept in a store")
    limit = chosen.limit
    with _configuration().robot_from(
        chosen.file, site.problem, store, via=chosen.via, state=state
    ) as robot:
        yield robot, Patience(action=lambda _: limit)


@contextmanager
def robot_for(
    store: Store,
    site: Site,
    set_up: Mapping[str, Any],
    entries: Sequence[Entry],
    *,
    pace: float | None = None,
) -> Iterator[tuple[Robot, Patience]]:
    """Reach the robot that the log of a mission names, wherever the mission is carried out."""
    chosen, mission = robot_in(set_up), accepted_of(entries).mission
    with opened(site, chosen, mission=mission, store=store, pace=pace, entries=entries) as reached:
        yield reached


def reach(file: Path, site: Site) -> dict[str, str]:
    """Try every service of a robots' file; what is wrong with each, empty where nothing is.

    raises PlainspokenError: when the file is wrong, or an extra is missing
    """
    found: dict[str, str] = _configuration().reached(file, site.problem, None)
    return found


def _configuration() -> ModuleType:
    try:
        from plainspoken.backends.activities import configuration
    except ImportError as error:
        raise PlainspokenError(f"robots' files cannot be read: {error}", hint=GET_IT) from error
    return configuration


@contextmanager
def asking_here(
    store: Store,
    mission: MissionId,
    lines: TextIO | None = None,
    say: Callable[[str], None] = click.echo,
) -> Iterator[None]:
    """Put a mission's questions to the person at this terminal, too, while it goes on.

    lines: where answers come from; None is the terminal, or nothing where there is none
    """
    lines = sys.stdin if lines is None and sys.stdin.isatty() else lines
    if lines is None:
        yield
        return
    from plainspoken.backends.questions import Questions

    over = threading.Event()
    asked = threading.Thread(
        target=_ask, args=(Questions(store.database), mission, lines, say, over), daemon=True
    )
    asked.start()
    try:
        yield
    finally:
        over.set()


def _ask(
    questions: Questions,
    mission: MissionId,
    lines: TextIO,
    say: Callable[[str], None],
    over: threading.Event,
) -> None:
    """Ask, read a line, and ask again if it is no answer; ends with the lines, or the mission."""
    while not over.wait(LOOK_AGAIN):
        mine = (each for each in questions.open() if each.call.startswith(f"{mission}/"))
        question = next(mine, None)
        if question is None:
            continue
        choices = f" [{' / '.join(question.answers)}]" if question.answers else ""
        say(f"{question.text}{choices}")
        line = lines.readline()
        if not line:
            return
        try:
            questions.answer(question.call, line, person())
        except PlainspokenError as error:
            say(str(error))


def person() -> str:
    """Who is at this terminal, for the record."""
    import getpass

    try:
        return getpass.getuser()
    except (KeyError, OSError):
        return "somebody"
