from collections.abc import Iterator
from pathlib import Path

import pytest
from tests.web.bench import SITE, Bench, bench, endless_robot, slow_robot

from plainspoken.cli.store import open_store
from plainspoken.web.access import Access
from plainspoken.web.desk import Desk


@pytest.fixture
def here(tmp_path: Path) -> Iterator[Bench]:
    """A server that asks nobody for a token."""
    with open_store(str(tmp_path / "store.sqlite")) as store:
        desk = Desk({"vineyard": SITE}, store, slow_robot)
        yield bench(desk, Access(None, everyone="ada"))
        desk.close()


@pytest.fixture
def standstill(tmp_path: Path) -> Iterator[Bench]:
    """The same, with a robot whose first action never ends."""
    with open_store(str(tmp_path / "standstill.sqlite")) as store:
        desk = Desk({"vineyard": SITE}, store, endless_robot)
        yield bench(desk, Access(None, everyone="ada"))
        desk.close()
