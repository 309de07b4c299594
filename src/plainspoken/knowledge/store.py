"""Where missions live: their logs, their places in the queue, and what is asked of them.

An append may carry what it answers: then the log holds what a request led to exactly when the
request is done with, whenever a process is killed.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge import queue
from plainspoken.knowledge.chain import MissionId
from plainspoken.knowledge.database import Session, WorkerId
from plainspoken.knowledge.log import Also, Log
from plainspoken.knowledge.queue import Message, MessageNumber, Place, RobotName, Standing
from plainspoken.world.event import Entry, Event, Instant, MissionEnded, Step


class AskedMeanwhileError(PlainspokenError):
    """Somebody else was quicker to ask something of a mission."""

    def __init__(self, mission: MissionId) -> None:
        super().__init__(f"somebody else asked something of the mission {mission} just now")


class Store(Log):
    """The log of missions, and all that processes have to agree on to carry them out."""

    def append(
        self,
        mission: MissionId,
        time: str,
        instant: Instant,
        events: Sequence[Event],
        *,
        at: Step | None = None,
        also: Also | None = None,
        answered: MessageNumber | None = None,
    ) -> tuple[Entry, ...]:
        """Keep events as `Log.append` does; answered: the last message that they answer."""

        def kept(session: Session, step: Step) -> None:
            if answered is not None:
                queue.answer(session, mission, answered, step)
            if also is not None:
                also(session, step)

        return super().append(mission, time, instant, events, at=at, also=kept)

    def begin(
        self,
        mission: MissionId,
        time: str,
        events: Sequence[Event],
        robots: Iterable[RobotName],
        worker: WorkerId | None = None,
    ) -> tuple[Entry, ...]:
        """Keep the first events of a mission, and give it a place behind all others.

        One that is over already, since what is asked for holds, keeps no robot from others.

        robots: missions of one robot wait for each other
        worker: who carries it out already, None where any may take it
        """

        def enlisted(session: Session, _: Step) -> None:
            self.database.alone(session)
            over = isinstance(events[-1], MissionEnded)
            standing = Standing.OVER if over else Standing.GOING
            queue.enlist(session, mission, robots, worker, standing)

        return self.append(mission, time, 0, events, at=0, also=enlisted)

    def enlist(self, mission: MissionId, robots: Iterable[RobotName]) -> None:
        """Give a mission a place that has a log, but no place yet: one of an older store."""
        with self.database.writing() as session:
            self.database.alone(session)
            if queue.place(session, mission) is None:
                queue.enlist(session, mission, robots, None)
                session.change(
                    "UPDATE place SET standing = ? WHERE mission = ?", (Standing.RESTING, mission)
                )

    def places(self) -> tuple[Place, ...]:
        """The missions that have a place, in order."""
        with self.database.reading() as session:
            return queue.places(session)

    def place(self, mission: MissionId) -> Place | None:
        with self.database.reading() as session:
            return queue.place(session, mission)

    def is_done(self) -> bool:
        """Whether no mission is to be carried out, by anyone."""
        with self.database.reading() as session:
            return queue.is_done(session)

    # -- requests ------------------------------------------------------------------------------

    def post(
        self, mission: MissionId, document: str, *, after: MessageNumber | None = None
    ) -> MessageNumber:
        """Ask something of a mission, whoever carries it out.

        after: the last message that whoever asks knows of
        raises AskedMeanwhileError: when there is a later one
        raises PlainspokenError: when the mission is over, or has no place
        """
        with self.database.writing() as session:
            self.database.alone(session)  # so that a later number is never seen before an earlier
            if after is not None and queue.last_message(session, mission) != after:
                raise AskedMeanwhileError(mission)
            number = queue.post(session, mission, document)
        if number is None:
            raise PlainspokenError(
                f"nothing can be asked of the mission {mission} any more: it is over",
                hint="`plainspoken ask` tells of it; `plainspoken missions` lists the others",
            )
        return number

    def messages(self, worker: WorkerId) -> tuple[Message, ...]:
        """What was asked of a worker's missions, and is not in their logs yet."""
        with self.database.reading() as session:
            return queue.messages(session, worker)

    def unanswered(self, mission: MissionId) -> tuple[Message, ...]:
        """What was asked of a mission, and is not in its log yet."""
        with self.database.reading() as session:
            return queue.unanswered(session, mission)

    def last_message(self, mission: MissionId) -> MessageNumber:
        """What was asked of a mission last; 0 before anything was."""
        with self.database.reading() as session:
            return queue.last_message(session, mission)

    def is_answered(self, mission: MissionId, number: MessageNumber) -> bool:
        """Whether the log holds what a message led to, or that was nothing."""
        return all(message.number != number for message in self.unanswered(mission))

    def dismiss(self, mission: MissionId, upto: MessageNumber, step: Step) -> None:
        """Note that what was asked, up to a message, needs no entry in the log."""
        with self.database.writing() as session:
            queue.answer(session, mission, upto, step)

    # -- workers -------------------------------------------------------------------------------

    def enrol(self, worker: WorkerId) -> None:
        """Begin as a worker, which has to `beat` from now on."""
        self.database.stay(worker)
        with self.database.writing() as session:
            queue.enrol(session, worker)

    def beat(self, worker: WorkerId) -> bool:
        """Be heard of; False where that comes too late, and the worker's missions are lost."""
        with self.database.writing() as session:
            return queue.beat(session, worker)

    def workers(self) -> tuple[WorkerId, ...]:
        with self.database.reading() as session:
            return queue.workers(session)

    def claim(self, worker: WorkerId, most: int) -> tuple[MissionId, ...]:
        """Take missions that wait, in their order, and those of workers that are gone."""
        self.bury()
        with self.database.reading() as session:
            if not queue.free(session, most):
                return ()
        with self.database.writing() as session:
            self.database.alone(session)
            found = queue.free(session, most)
            return tuple(one for one in found if queue.claim(session, worker, one))

    def claim_this(self, worker: WorkerId, mission: MissionId) -> bool:
        """Take one mission, out of turn; False where somebody carries it out, or it is over."""
        self.bury()
        with self.database.writing() as session:
            return queue.claim(session, worker, mission)

    def ahead_of(self, mission: MissionId) -> tuple[MissionId, ...]:
        """The missions that have a mission's robots before it."""
        with self.database.reading() as session:
            return queue.ahead_of(session, mission)

    def release(
        self,
        worker: WorkerId,
        mission: MissionId,
        standing: Standing,
        trouble: str | None = None,
    ) -> None:
        """Hand a mission back, unless somebody else has it by now."""
        with self.database.writing() as session:
            queue.release(session, worker, mission, standing, trouble)

    def retire(self, worker: WorkerId) -> None:
        """End as a worker: others may take what it has."""
        with self.database.writing() as session:
            queue.bury(session, [worker])
        self.database.leave(worker)

    def bury(self) -> tuple[WorkerId, ...]:
        """Take their missions from workers that are gone; gives who they were."""
        with self.database.reading() as session:
            if not queue.dead(self.database, session):
                return ()
        with self.database.writing() as session:
            gone = queue.dead(self.database, session)
            queue.bury(session, gone)
        for worker in gone:
            self.database.leave(worker)
        return tuple(gone)
