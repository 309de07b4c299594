"""Where missions are kept: the option that says so, and the store that it opens."""

from __future__ import annotations

from collections.abc import Sequence

import click

from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import store_path
from plainspoken.knowledge.store import Store
from plainspoken.world.event import Entry

STORE_VARIABLE = "PLAINSPOKEN_STORE"
POSTGRES = ("postgresql://", "postgres://")

store_option = click.option(
    "--store",
    metavar="URL",
    envvar=STORE_VARIABLE,
    help="Where missions are kept: a path, sqlite:///PATH or postgresql://USER@HOST/DATABASE "
    "(or PLAINSPOKEN_STORE).",
)


def open_store(url: str | None) -> Store:
    """The store that `--store` names, made where there is none yet.

    raises PlainspokenError: when it is no store, or cannot be reached
    """
    if url and url.startswith(POSTGRES):
        from plainspoken.backends.postgres import PostgresDatabase

        return Store(PostgresDatabase(url))
    from plainspoken.knowledge.sqlite import SqliteDatabase

    return Store(SqliteDatabase(store_path(url)))


def entries_in(kept: Store, mission: str | None) -> Sequence[Entry]:
    """The log of a mission, of the last one where none is named.

    raises PlainspokenError: when the store has no such mission
    """
    known = kept.missions()
    id = mission if mission is not None else (known[-1] if known else None)
    if id not in known or id is None:
        raise PlainspokenError(
            "there are no missions yet" if mission is None else f"no mission {mission!r}",
            where=kept.database.place,
            hint="`plainspoken missions` lists them; `plainspoken run` starts one",
        )
    return kept.entries(id)


def entries_of(mission: str | None, store: str | None) -> Sequence[Entry]:
    """The log of a mission in the store that `--store` names; see `entries_in`."""
    with open_store(store) as kept:
        return entries_in(kept, mission)
