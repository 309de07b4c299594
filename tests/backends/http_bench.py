"""The reference server of `examples/robots`, which can be lost and found again."""

from __future__ import annotations

import threading
from contextlib import ExitStack
from http.server import ThreadingHTTPServer
from importlib.util import module_from_spec, spec_from_file_location
from pathlib import Path
from types import ModuleType
from typing import Any

from tests.mission.small_vineyard import PROBLEM
from tests.stores import store_in

from plainspoken.backends.activities.configuration import robot_from
from plainspoken.mission.robot import Robot
from plainspoken.world.domain import State

EXAMPLES = Path(__file__).parents[2] / "examples" / "robots"


def _module() -> ModuleType:
    spec = spec_from_file_location("http_robot", EXAMPLES / "http_robot.py")
    assert spec is not None
    assert spec.loader is not None
    module = module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


SERVER = _module()


class HttpBench:
    """A robot behind a server on loopback."""

    problem = PROBLEM
    action = "move rob wh l0"
    rejected = "move rob l0 wh"

    def __init__(self, folder: Path, stack: ExitStack, *, pace: float = 0.05) -> None:
        self.folder, self._stack = folder, stack
        self.far: Any = SERVER.VineyardRobot(PROBLEM, pace=pace)
        self._server: ThreadingHTTPServer = SERVER.served(self.far)
        self.port = self._server.server_port
        self.file = folder / "robots.yaml"
        text = (EXAMPLES / "http.yaml").read_text()
        self.file.write_text(
            text.replace(":8800", f":{self.port}").replace("pause: 1", "pause: 0.01")
        )
        self._serve()
        stack.callback(self.lose)

    def robot(self, state: State | None = None) -> Robot:
        store = self._stack.enter_context(store_in(self.folder))
        return self._stack.enter_context(robot_from(self.file, PROBLEM, store, state=state))

    def begun(self) -> int:
        return len(self.far.begun)

    def lose(self) -> None:
        self._server.shutdown()
        self._server.server_close()

    def restore(self) -> None:
        self._server = SERVER.served(self.far, self.port)
        self._serve()

    def _serve(self) -> None:
        threading.Thread(
            target=self._server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True
        ).start()
