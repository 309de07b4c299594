"""A robot of the vineyard behind HTTP: the reference server for `via: http`, and what tests run.

    python examples/robots/http_robot.py --port 8800 --pace 0.2

PUT    /goals/{id}   begin {"task": "drive", "to": "l1"}; the same id again is the same goal
GET    /goals/{id}   {"state": "going" | "done" | "failed", "progress", "doing", "result"}; 404
DELETE /goals/{id}   give it up
GET    /scene        {"atoms": [...]}: all that is true

The tasks are those of TASKS, and {"task": "tell", "grape": "g1", "is": "ripe"}: what a person
says of a grape that the robot could not judge. What they come to is drawn by a simulator; a robot
of yours would drive, look and pick instead.
"""

from __future__ import annotations

import argparse
import json
import threading
import time
from collections.abc import Mapping
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any, ClassVar
from urllib.parse import unquote

from plainspoken.mission.robot import Failed, Succeeded, UnderWay, Unheard
from plainspoken.mission.simulator import Simulator
from plainspoken.pipeline import bundled, open_site
from plainspoken.world.domain import Problem, State

TASKS = {
    "drive": ("move", ("robot", "from", "to")),
    "check": ("check-grape", ("robot", "grape", "at")),
    "pick": ("harvest-grape", ("robot", "grape", "at")),
    "drop": ("drop-grape", ("robot", "grape", "box")),
    "call": ("call-support", ("robot", "support", "from", "to")),
    "empty": ("empty-box", ("robot", "support", "box", "at", "to")),
    "sign": ("sign-off", ("robot", "at")),
}
"""Each task, the action of the domain that it is, and its fields in the action's order."""

DOING = {"drive": {"doing": "on the track"}, "pick": {"doing": "closing the gripper"}}
"""What the robot tells of some tasks while it is at them."""


class VineyardRobot:
    """What the server knows: goals by their ids, in a simulated vineyard."""

    def __init__(self, problem: Problem, *, seed: int = 0, pace: float = 0.0) -> None:
        # The simulated world moves on by itself: whoever asks finds it where the clock has it.
        self.simulator = Simulator(problem, seed=seed, pace=pace, sleep=lambda _: None)
        self._clock = time.monotonic()
        self.begun: list[str] = []
        self._tasks: dict[str, Mapping[str, Any]] = {}
        self._before: dict[str, State] = {}
        self._lock = threading.Lock()

    def put(self, id: str, task: Mapping[str, Any]) -> tuple[int, dict[str, Any]]:
        with self._lock:
            if id in self._tasks:
                return 200, {"state": "going"}
            if task.get("task") == "tell":
                return self._told(id, task)
            if task.get("task") not in TASKS:
                return 422, {"reason": f"no task {task.get('task')!r}: {', '.join(TASKS)}"}
            missing = [field for field in TASKS[task["task"]][1] if field not in task]
            if missing:
                return 422, {"reason": f"the task lacks {', '.join(missing)}"}
            self._tasks[id], self._before[id] = task, self.simulator.state()
            self.begun.append(id)
            self._clock = time.monotonic()
            self.simulator.send(id, self.action(id))
            return 202, {"state": "going"}

    def action(self, id: str) -> str:
        """The action of the domain that a goal is."""
        name, fields = TASKS[self._tasks[id]["task"]]
        return " ".join([name, *(str(self._tasks[id][field]) for field in fields)])

    def _told(self, id: str, task: Mapping[str, Any]) -> tuple[int, dict[str, Any]]:
        """Take in what a person says of a grape."""
        grape, kind = task.get("grape"), task.get("is")
        if f"unknown {grape}" not in self.simulator.state() or kind not in ("ripe", "unripe"):
            return 422, {"reason": f"there is nothing to tell of {grape!r}, or not {kind!r}"}
        self.simulator.disturb(added=[f"{kind} {grape}"], deleted=[f"unknown {grape}"])
        self._tasks[id] = task
        return 202, {"state": "going"}

    def get(self, id: str) -> tuple[int, dict[str, Any]]:
        with self._lock:
            now = time.monotonic()
            passed, self._clock = now - self._clock, now
            if self._tasks.get(id, {}).get("task") == "tell":
                return 200, {"state": "done"}
            match self.simulator.wait(id, passed):
                case Unheard():
                    return 404, {"reason": f"no goal {id}"}
                case UnderWay(progress):
                    task = self._tasks[id]["task"]
                    return 200, {"state": "going", "progress": progress, **DOING.get(task, {})}
                case Failed(reason):
                    return 200, {"state": "failed", "reason": reason}
                case Succeeded(state):
                    return 200, {"state": "done", "result": self._result(id, state)}

    def delete(self, id: str) -> tuple[int, dict[str, Any]]:
        with self._lock:
            self.simulator.cancel(id)
        return 202, {}

    def scene(self) -> dict[str, Any]:
        with self._lock:
            return {"atoms": sorted(self.simulator.state())}

    def _result(self, id: str, state: State) -> dict[str, Any]:
        """What the robot would say of its task: not facts of a domain, but its own words."""
        task, changed = self._tasks[id], state - self._before[id]
        match task["task"]:
            case "check":
                kinds = ("ripe", "unripe", "unknown")
                return {"grape": next(k for k in kinds if f"{k} {task['grape']}" in changed)}
            case "drop":
                return {"full": f"full {task['box']}" in state}
            case "call":
                return {"came": f"robot-at {task['support']} {task['to']}" in state}
            case _:
                return {}


class Handler(BaseHTTPRequestHandler):
    """Routes requests to the robot of the server."""

    robot: ClassVar[VineyardRobot]
    protocol_version = "HTTP/1.1"

    def do_PUT(self) -> None:
        length = int(self.headers.get("Content-Length", 0))
        self._answer(*self.robot.put(self._id(), json.loads(self.rfile.read(length) or b"{}")))

    def do_GET(self) -> None:
        if self.path == "/scene":
            self._answer(200, self.robot.scene())
        elif self.path.startswith("/goals/"):
            self._answer(*self.robot.get(self._id()))
        else:
            self._answer(200, {"robot": "vineyard"})

    def do_DELETE(self) -> None:
        self._answer(*self.robot.delete(self._id()))

    def log_message(self, format: str, *arguments: object) -> None:
        """Say nothing: a poll would fill the terminal."""

    def _id(self) -> str:
        return unquote(self.path.removeprefix("/goals/"))

    def _answer(self, status: int, body: Mapping[str, Any]) -> None:
        content = json.dumps(body).encode()
        self.send_response(status)
        self.send_header("Content-Type", "application/json")
        self.send_header("Content-Length", str(len(content)))
        self.end_headers()
        self.wfile.write(content)


def served(robot: VineyardRobot, port: int = 0) -> ThreadingHTTPServer:
    """A server of one robot on loopback; port 0 takes a free one."""
    handler = type("RobotHandler", (Handler,), {"robot": robot})
    server = ThreadingHTTPServer(("127.0.0.1", port), handler)
    server.daemon_threads = True
    return server


def main() -> None:
    """Serve until Ctrl-C."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n", 1)[0])
    parser.add_argument("--port", type=int, default=8800)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--pace", type=float, default=0.2, help="seconds for each simulated one")
    asked = parser.parse_args()
    folder = bundled("vineyard")
    site = open_site(folder / "domain.pddl", folder / "problem.pddl")
    robot = VineyardRobot(site.problem, seed=asked.seed, pace=asked.pace)
    with served(robot, asked.port) as server:
        print(f"a robot of the vineyard listens at http://127.0.0.1:{server.server_port}")  # noqa: T201 - to the person at the terminal
        server.serve_forever()


if __name__ == "__main__":
    main()
