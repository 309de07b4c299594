"""Whose turn it is: missions that wait for their robots, and the workers that carry them out.

A mission has a place in the queue from when it is begun until it is over, reserves its robots in
the order of places, and is carried out by one worker at a time. Two things keep two workers apart:
a worker that is not heard of loses its missions, and one that writes to the log of a mission that
it lost is refused there, before its robot hears of anything. The log says how a mission stands;
`standing` only says whether it is worth a worker's look.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from enum import StrEnum

from plainspoken.knowledge.chain import MissionId
from plainspoken.knowledge.database import Database, Session, WorkerId
from plainspoken.world.event import Step

RobotName = str
MessageNumber = int
Seconds = float

LEASE: Seconds = 3.0
"""A worker that was not heard of for so long has lost its missions."""


class Standing(StrEnum):
    """What a mission needs of a worker."""

    GOING = "going"
    """It is to be carried out."""
    RESTING = "resting"
    """Nothing, until somebody asks for something. It keeps its robots."""
    OVER = "over"
    """Nothing, ever."""


@dataclass(frozen=True, slots=True)
class Place:
    """A mission in the queue.

    robots:  that it reserves, until it is over
    worker:  who carries it out, None where nobody does
    trouble: why the last worker could not go on with it
    """

    mission: MissionId
    standing: Standing
    robots: tuple[RobotName, ...]
    worker: WorkerId | None
    trouble: str | None = None


@dataclass(frozen=True, slots=True)
class Message:
    """Something asked of a mission; document: see `mission.mailbox`."""

    number: MessageNumber
    mission: MissionId
    document: str


def enlist(
    session: Session,
    mission: MissionId,
    robots: Iterable[RobotName],
    worker: WorkerId | None,
    standing: Standing = Standing.GOING,
) -> None:
    """Give a new mission a place, behind all others; worker: who has it already."""
    session.change(
        "INSERT INTO place (mission, standing, worker) VALUES (?, ?, ?)",
        (mission, standing, worker),
    )
    for robot in sorted(set(robots)):
        session.change("INSERT INTO reservation (mission, robot) VALUES (?, ?)", (mission, robot))


def places(session: Session) -> tuple[Place, ...]:
    """Every place, in order."""
    robots: dict[MissionId, list[RobotName]] = {}
    for mission, robot in session.rows("SELECT mission, robot FROM reservation ORDER BY robot"):
        robots.setdefault(mission, []).append(robot)
    rows = session.rows("SELECT mission, standing, worker, trouble FROM place ORDER BY number")
    return tuple(
        Place(mission, Standing(standing), tuple(robots.get(mission, ())), worker, trouble)
        for mission, standing, worker, trouble in rows
    )


def place(session: Session, mission: MissionId) -> Place | None:
    """The place of one mission; None where it never had one."""
    rows = session.rows("SELECT standing, worker, trouble FROM place WHERE mission = ?", (mission,))
    if not rows:
        return None
    standing, worker, trouble = rows[0]
    robots = session.rows(
        "SELECT robot FROM reservation WHERE mission = ? ORDER BY robot", (mission,)
    )
    return Place(mission, Standing(standing), tuple(name for (name,) in robots), worker, trouble)


def is_done(session: Session) -> bool:
    """Whether no mission is to be carried out, by anyone."""
    return not session.rows("SELECT 1 FROM place WHERE standing = 'going' LIMIT 1")


_AHEAD = """
SELECT q.mission FROM reservation AS mine
 JOIN reservation AS theirs ON theirs.robot = mine.robot AND theirs.mission <> mine.mission
 JOIN place AS q ON q.mission = theirs.mission
 WHERE mine.mission = p.mission AND q.number < p.number AND q.standing <> 'over'
"""
_FREE = f"""
SELECT p.mission FROM place AS p WHERE p.worker IS NULL AND p.standing <> 'over'
 AND (p.standing = 'going' OR (p.standing = 'resting' AND EXISTS (
   SELECT 1 FROM message WHERE message.mission = p.mission AND message.answered IS NULL)))
 AND NOT EXISTS ({_AHEAD}) ORDER BY p.number LIMIT ?
"""  # noqa: S608 - both parts are ours
_AHEAD_OF = f"""
SELECT o.mission FROM place AS p, place AS o
 WHERE p.mission = ? AND o.mission IN ({_AHEAD}) ORDER BY o.number
"""  # noqa: S608 - both parts are ours


def free(session: Session, most: int) -> list[MissionId]:
    """Missions that nobody carries out, and whose turn it is with all their robots."""
    return [mission for (mission,) in session.rows(_FREE, (most,))]


def ahead_of(session: Session, mission: MissionId) -> tuple[MissionId, ...]:
    """The missions that have a mission's robots before it, in the order of their places."""
    return tuple(ahead for (ahead,) in session.rows(_AHEAD_OF, (mission,)))


def claim(session: Session, worker: WorkerId, mission: MissionId) -> bool:
    """Take a mission that nobody carries out; False where somebody was quicker."""
    return bool(
        session.change(
            "UPDATE place SET worker = ?, trouble = NULL WHERE mission = ? AND worker IS NULL"
            " AND standing <> 'over' AND EXISTS (SELECT 1 FROM worker WHERE id = ?)",
            (worker, mission, worker),
        )
    )


def release(
    session: Session,
    worker: WorkerId,
    mission: MissionId,
    standing: Standing,
    trouble: str | None = None,
) -> None:
    """Hand a mission back, unless somebody else has it by now; what is over frees its robots."""
    released = session.change(
        "UPDATE place SET worker = NULL, standing = ?, trouble = ?"
        " WHERE mission = ? AND worker = ?",
        (standing, trouble, mission, worker),
    )
    if released and standing is Standing.OVER:
        session.change("DELETE FROM reservation WHERE mission = ?", (mission,))


def post(session: Session, mission: MissionId, document: str) -> MessageNumber | None:
    """Put something into the mailbox of a mission; None where it is over, or has no place."""
    found = session.rows(
        "INSERT INTO message (mission, document, posted) SELECT mission, ?, {now} FROM place"
        " WHERE mission = ? AND standing <> 'over' RETURNING number",
        (document, mission),
    )
    return found[0][0] if found else None


def messages(session: Session, worker: WorkerId) -> tuple[Message, ...]:
    """What was asked of a worker's missions, and is not in their logs yet."""
    rows = session.rows(
        "SELECT message.number, message.mission, document FROM message"
        " JOIN place ON place.mission = message.mission"
        " WHERE place.worker = ? AND message.answered IS NULL ORDER BY message.number",
        (worker,),
    )
    return tuple(Message(*row) for row in rows)


def unanswered(session: Session, mission: MissionId) -> tuple[Message, ...]:
    """What was asked of a mission, and is not in its log yet."""
    rows = session.rows(
        "SELECT number, mission, document FROM message WHERE mission = ? AND answered IS NULL"
        " ORDER BY number",
        (mission,),
    )
    return tuple(Message(*row) for row in rows)


def last_message(session: Session, mission: MissionId) -> MessageNumber:
    """What was asked of a mission last, answered or not; 0 before anything was."""
    found = session.rows("SELECT max(number) FROM message WHERE mission = ?", (mission,))
    return found[0][0] or 0


def answer(session: Session, mission: MissionId, upto: MessageNumber, step: Step) -> None:
    """Note that what was asked, up to a message, is in the log at a step."""
    session.change(
        "UPDATE message SET answered = ? WHERE mission = ? AND number <= ? AND answered IS NULL",
        (step, mission, upto),
    )


def enrol(session: Session, worker: WorkerId) -> None:
    """Begin as a worker."""
    session.change("INSERT INTO worker (id, heard) VALUES (?, {now})", (worker,))


def beat(session: Session, worker: WorkerId) -> bool:
    """Be heard of; False where that comes too late, and the worker's missions are lost."""
    return bool(session.change("UPDATE worker SET heard = {now} WHERE id = ?", (worker,)))


def workers(session: Session) -> tuple[WorkerId, ...]:
    """Those who carry missions out, as far as is known."""
    return tuple(id for (id,) in session.rows("SELECT id FROM worker ORDER BY heard"))


def dead(database: Database, session: Session, lease: Seconds = LEASE) -> list[WorkerId]:
    """Workers that were not heard of for too long, or are certain to have ended."""
    rows = session.rows("SELECT id, {now} - heard FROM worker")
    return [id for id, silence in rows if silence > lease or database.is_gone(id)]


def bury(session: Session, gone: Sequence[WorkerId]) -> None:
    """Take their missions from workers that are gone."""
    for worker in gone:
        session.change("UPDATE place SET worker = NULL WHERE worker = ?", (worker,))
        session.change("DELETE FROM worker WHERE id = ?", (worker,))
