"""A PostgreSQL server of one's own: in a folder that goes away, on a free port of this machine.

`PLAINSPOKEN_TEST_POSTGRES`, the URL of a server where databases may be made, is used instead where
it is set.
"""

from __future__ import annotations

import os
import pwd
import secrets
import shutil
import socket
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from urllib.parse import urlsplit

GIVEN = "PLAINSPOKEN_TEST_POSTGRES"


def why_not() -> str | None:
    """Why there can be no server here; None where there can."""
    if os.environ.get(GIVEN):
        return None
    if _programs() is None:
        return f"PostgreSQL is not installed (no initdb found), and {GIVEN} is not set"
    return None


@contextmanager
def server() -> Iterator[str]:
    """The URL of a server, without a database."""
    given = os.environ.get(GIVEN)
    if given:
        yield given
        return
    programs = _programs()
    if programs is None:
        raise RuntimeError(why_not())
    folder = Path(tempfile.mkdtemp(prefix="plainspoken-postgres-"))
    user = _user()
    if user is not None:
        shutil.chown(folder, user)
    port = _free_port()

    def call(program: str, *arguments: str) -> None:
        subprocess.run(
            [str(programs / program), "-D", str(folder / "data"), *arguments],
            check=True,
            stdout=subprocess.DEVNULL,
            user=user,
            cwd=folder,
        )

    try:
        call("initdb", "--auth=trust", "--username=plain", "--no-sync")
        options = f"-p {port} -c listen_addresses=127.0.0.1 -k {folder}"
        call("pg_ctl", "-w", "-l", str(folder / "log"), "-o", options, "start")
        try:
            yield f"postgresql://plain@127.0.0.1:{port}"
        finally:
            call("pg_ctl", "-m", "immediate", "stop")
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def new_database(url: str) -> str:
    """Make an empty database on a server; gives its URL."""
    import psycopg

    name = f"plainspoken_{secrets.token_hex(4)}"
    with psycopg.connect(f"{url}/postgres", autocommit=True) as connection:
        connection.execute(f"CREATE DATABASE {name}".encode())
    return urlsplit(url)._replace(path=f"/{name}").geturl()


def _programs() -> Path | None:
    found = shutil.which("initdb")
    folders = sorted(Path("/usr/lib/postgresql").glob("*/bin"), reverse=True)
    folders += [Path(found).resolve().parent] if found else []
    return next((folder for folder in folders if (folder / "initdb").exists()), None)


def _user() -> str | None:
    """PostgreSQL refuses to run as root: somebody else has to."""
    if os.getuid() != 0:
        return None
    names = {entry.pw_name for entry in pwd.getpwall()}
    return next(name for name in ("postgres", "nobody") if name in names)


def _free_port() -> int:
    with socket.socket() as found:
        found.bind(("127.0.0.1", 0))
        port: int = found.getsockname()[1]
        return port
