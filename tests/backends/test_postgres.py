"""What only PostgreSQL does; `tests/knowledge/test_store.py` has what every store does."""

import sys
from pathlib import Path

import psycopg
import pytest
from benchmarks.postgres_server import new_database
from tests.mission.small_vineyard import accepted
from tests.work.workshop import at_work, deeds, kinds, queue_up, robot_for, standing, until

from plainspoken.backends.postgres import PostgresDatabase
from plainspoken.cli.store import open_store
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.database import StoreError
from plainspoken.knowledge.store import Store
from plainspoken.logic.syntax import parse
from plainspoken.mission.mission import Status
from plainspoken.work.worker import Worker


@pytest.fixture
def url(postgres: str) -> str:
    return new_database(postgres)


def begun(url: str) -> Store:
    store = Store(PostgresDatabase(url))
    store.begin("m", "t", [accepted(parse("F cleared_l0"))], ["rob"])
    return store


@pytest.mark.parametrize(
    "deed",
    [
        "UPDATE plainspoken.entry SET document = '{}'",
        "DELETE FROM plainspoken.entry",
        "TRUNCATE plainspoken.entry",
    ],
)
def test_the_database_refuses_to_change_the_log(url: str, deed: str) -> None:
    with begun(url) as store, psycopg.connect(url) as connection:
        with pytest.raises(psycopg.Error, match="only ever appended"):
            connection.execute(deed.encode())
        connection.rollback()
        assert store.verify("m") is None


def test_a_changed_entry_is_found_by_the_chain(url: str) -> None:
    with begun(url) as store:
        with psycopg.connect(url) as connection:
            connection.execute("ALTER TABLE plainspoken.entry DISABLE TRIGGER only_append")
            connection.execute(
                "UPDATE plainspoken.entry SET document = replace(document, 'cleared', 'clouded')"
            )
        broken = store.verify("m")
        assert broken is not None
        assert broken.step == 0


def test_a_server_that_drops_every_connection_is_connected_to_again(url: str) -> None:
    with begun(url) as store:
        with psycopg.connect(url, autocommit=True) as connection:
            connection.execute(
                "SELECT pg_terminate_backend(pid) FROM pg_stat_activity"
                " WHERE datname = current_database() AND pid <> pg_backend_pid()"
            )
        with pytest.raises(StoreError):
            store.missions()
        assert store.missions() == ("m",)


def test_a_worker_goes_on_when_the_server_has_dropped_it(url: str, tmp_path: Path) -> None:
    with open_store(url) as store:
        queue_up(store, "m", tmp_path / "world", pace=0.02)
        with at_work(Worker(store, robot_for)), open_store(url) as other:
            until(lambda: "action_started" in kinds(other, "m"))
            with other.database.writing() as session:
                session.rows(
                    "SELECT pg_terminate_backend(pid) FROM pg_stat_activity"
                    " WHERE datname = current_database() AND pid <> pg_backend_pid()"
                )
            until(lambda: standing(other, "m").is_over)
            assert standing(other, "m").status is Status.FINISHED
            assert other.verify("m") is None
    assert [deed.repeats for deed in deeds(tmp_path / "world", "m")] == [0, 0, 0, 0]


def test_a_server_that_is_not_there_is_named_without_its_password() -> None:
    with pytest.raises(StoreError) as caught:
        open_store("postgresql://ada:secret@127.0.0.1:1/missions")
    said = str(caught.value)
    assert "postgresql://ada@127.0.0.1:1/missions" in said
    assert "secret" not in said
    assert "hint:" in said


def test_without_psycopg_the_way_to_get_it_is_said(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "psycopg", None)
    with pytest.raises(PlainspokenError, match="psycopg") as caught:
        open_store("postgresql://127.0.0.1:1/missions")
    assert "plainspoken[postgres]" in str(caught.value)
