"""Stores of both kinds, for the tests of whatever is kept in them."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from benchmarks.postgres_server import new_database, server, why_not

from plainspoken.cli.store import open_store
from plainspoken.knowledge.sqlite import SqliteDatabase
from plainspoken.knowledge.store import Store


def store_in(folder: Path) -> Store:
    """The store of a folder, a SQLite file; a context that closes it."""
    return Store(SqliteDatabase(folder / "store.sqlite"))


@pytest.fixture(scope="session")
def postgres() -> Iterator[str]:
    """A server for the tests of one process."""
    reason = why_not()
    if reason is not None:
        pytest.skip(reason)
    with server() as url:
        yield url


@pytest.fixture(params=["sqlite", "postgresql"])
def store_url(request: pytest.FixtureRequest, tmp_path: Path) -> str:
    """An empty store of each kind."""
    if request.param == "sqlite":
        return str(tmp_path / "store.sqlite")
    return new_database(request.getfixturevalue("postgres"))


@pytest.fixture
def store(store_url: str) -> Iterator[Store]:
    with open_store(store_url) as store:
        yield store
