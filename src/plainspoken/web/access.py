"""Who may do what: tokens, the logins they give, and the two roles.

A token is drawn by us, so that it cannot be guessed; only its digest is kept. A login is a cookie
that is signed with the digest of the token it was made by: it outlives a restart of the server,
and ends with the token, or after some hours.
"""

from __future__ import annotations

import hmac
import os
import re
import secrets
import stat
import time
from base64 import urlsafe_b64decode, urlsafe_b64encode
from collections.abc import Callable
from dataclasses import dataclass
from enum import StrEnum
from hashlib import sha256
from pathlib import Path

from plainspoken.errors import InputFileError, PlainspokenError

Token = str
Cookie = str
Digest = str
"""Sixty-four hexadecimal digits."""
EpochSeconds = float

TOKENS_VARIABLE = "PLAINSPOKEN_TOKENS"
LOGIN_LASTS = 12 * 3600
"""Seconds after which somebody has to log in again: a working day."""
HOW_TO_GRANT = "`plainspoken token NAME --role operator --file FILE` makes a token and the file"

_LINE = re.compile(r"(?P<role>\S+)\s+(?P<name>\S+)\s+(?P<digest>[0-9a-f]{64})")
_NAME = re.compile(r"[\w.@+-]{1,64}")


class Role(StrEnum):
    """What somebody may do."""

    VIEWER = "viewer"
    """Look, and ask."""
    OPERATOR = "operator"
    """Command, too."""


@dataclass(frozen=True, slots=True)
class Caller:
    """Somebody who may come in; until: when a login ends, None where it does not."""

    name: str
    role: Role
    until: EpochSeconds | None = None

    @property
    def may_command(self) -> bool:
        return self.role is Role.OPERATOR


@dataclass(frozen=True, slots=True)
class Grant:
    """What a token allows, and to whom."""

    role: Role
    name: str
    digest: Digest

    def __str__(self) -> str:
        return f"{self.role} {self.name} {self.digest}"


Grants = Callable[[], tuple[Grant, ...]]
"""The grants as they are now: a token may be taken back at any time."""


def new_grant(role: Role, name: str) -> tuple[Token, Grant]:
    """Draw a token; it is not kept anywhere.

    raises PlainspokenError: when the name could not stand in a line of grants
    """
    if not _NAME.fullmatch(name):
        raise PlainspokenError(
            f"nobody can be called {name!r} here",
            hint="letters, digits and . _ @ + - without spaces, 64 at most",
        )
    token = f"ps-{secrets.token_urlsafe(32)}"
    return token, Grant(role, name, digest_of(token))


def digest_of(token: Token) -> Digest:
    """What is kept of a token. It is drawn from 2^256, so a plain hash cannot be tried out."""
    return sha256(token.encode("utf-8", "surrogatepass")).hexdigest()


def grants_in(text: str, source: str | Path) -> tuple[Grant, ...]:
    """Read grants, one a line: `ROLE NAME DIGEST`; empty lines and `#` lines are skipped.

    raises InputFileError: with the line; never with what stands in it, which may be a secret
    """
    found: list[Grant] = []
    for number, line in enumerate(text.splitlines(), start=1):
        if not line.strip() or line.lstrip().startswith("#"):
            continue
        match = _LINE.fullmatch(line.strip())
        if match is None or match["role"] not in set(Role) or not _NAME.fullmatch(match["name"]):
            raise InputFileError(
                "expected `viewer NAME DIGEST` or `operator NAME DIGEST`",
                source,
                line=number,
                hint=HOW_TO_GRANT,
            )
        if any(grant.name == match["name"] for grant in found):
            raise InputFileError(
                f"there are two tokens of {match['name']}",
                source,
                line=number,
                hint="a name says who did something: give each person and program their own",
            )
        found.append(Grant(Role(match["role"]), match["name"], match["digest"]))
    return tuple(found)


class GrantFile:
    """The grants of a file, which is read again when it was changed."""

    def __init__(self, path: Path) -> None:
        """Read the file.

        raises InputFileError: when it cannot be read, is not ours alone, or grants nothing
        """
        self._path = path
        self._seen: tuple[int, ...] = ()
        self._grants: tuple[Grant, ...] = ()
        if not self():
            raise InputFileError("the file grants nobody anything", path, hint=HOW_TO_GRANT)

    def __call__(self) -> tuple[Grant, ...]:
        try:
            about = self._path.stat()
            seen = (about.st_mtime_ns, about.st_size, about.st_ino, about.st_mode)
            if seen != self._seen:
                _refuse_readable_by_others(about, self._path)
                self._grants = grants_in(self._path.read_text(encoding="utf-8"), self._path)
                self._seen = seen
        except (OSError, UnicodeDecodeError) as error:
            reason = getattr(error, "strerror", None) or "not UTF-8"
            raise InputFileError(
                f"cannot read the file of tokens: {reason}", self._path, hint=HOW_TO_GRANT
            ) from error
        return self._grants


def _refuse_readable_by_others(about: os.stat_result, path: Path) -> None:
    if about.st_uid != os.geteuid() or stat.S_IMODE(about.st_mode) & 0o077:
        raise InputFileError(
            "the file of tokens can be read or changed by others",
            path,
            hint="make it yours alone: chmod 600",
        )


def append_grant(path: Path, grant: Grant) -> None:
    """Add a grant to a file, made where there is none, for its owner alone.

    raises InputFileError: when it cannot be written, or grants somebody of that name something
    """
    try:
        text = path.read_text(encoding="utf-8") if path.exists() else ""
        grants_in(f"{text}\n{grant}", path)
        descriptor = os.open(path, os.O_WRONLY | os.O_APPEND | os.O_CREAT, 0o600)
        with os.fdopen(descriptor, "w", encoding="utf-8") as file:
            _refuse_readable_by_others(os.fstat(descriptor), path)
            file.write(f"{'' if text.endswith(chr(10)) or not text else chr(10)}{grant}\n")
    except OSError as error:
        raise InputFileError(f"cannot write the file: {error.strerror}", path) from error


class Access:
    """Tells who somebody is, from what they show."""

    def __init__(
        self,
        grants: Grants | None,
        *,
        everyone: str = "somebody",
        lasts: float = LOGIN_LASTS,
        now: Callable[[], EpochSeconds] = time.time,
    ) -> None:
        """Let in who has a token; without grants, everyone, as an operator of that name."""
        self._grants = grants
        self._everyone = Caller(everyone, Role.OPERATOR)
        self.lasts = int(lasts)
        self._now = now
        self._left: dict[Cookie, EpochSeconds] = {}

    @property
    def is_open(self) -> bool:
        """Whether everyone who reaches the address may do everything."""
        return self._grants is None

    def anyone(self) -> Caller | None:
        """Who somebody is that shows nothing."""
        return self._everyone if self.is_open else None

    def by_token(self, token: Token) -> Caller | None:
        """Whose token it is; all are compared, and each takes the same time."""
        shown, found = digest_of(token), None
        for grant in self._granted():
            if hmac.compare_digest(grant.digest, shown):
                found = Caller(grant.name, grant.role)
        return found

    def login(self, token: Token) -> tuple[Cookie, Caller] | None:
        """A cookie for a token, None where there is no such token."""
        caller = self.by_token(token)
        if caller is None:
            return None
        until = int(self._now() + self.lasts)
        name = urlsafe_b64encode(caller.name.encode()).decode().rstrip("=")
        signed = f"{name}.{until}.{secrets.token_urlsafe(12)}"
        cookie = f"{signed}.{_signature(digest_of(token), signed)}"
        return cookie, Caller(caller.name, caller.role, until)

    def by_cookie(self, cookie: Cookie) -> Caller | None:
        """Whose login it is; None where it has ended, or its token is gone."""
        signed, _, signature = cookie.rpartition(".")
        try:
            encoded, until, _nonce = signed.split(".")
            name = urlsafe_b64decode(encoded + "=" * (-len(encoded) % 4)).decode()
            ends = int(until)
        except ValueError:
            return None
        if ends <= self._now() or cookie in self._left:
            return None
        for grant in self._granted():
            expected = _signature(grant.digest, signed)
            if grant.name == name and hmac.compare_digest(expected.encode(), signature.encode()):
                return Caller(grant.name, grant.role, ends)
        return None

    def logout(self, cookie: Cookie) -> None:
        """End a login before its time."""
        caller = self.by_cookie(cookie)
        now = self._now()
        self._left = {each: ends for each, ends in self._left.items() if ends > now}
        if caller is not None and caller.until is not None:
            self._left[cookie] = caller.until

    def _granted(self) -> tuple[Grant, ...]:
        return () if self._grants is None else self._grants()


def _signature(digest: Digest, signed: str) -> str:
    key = b"plainspoken login\n" + bytes.fromhex(digest)
    return hmac.new(key, signed.encode("utf-8", "surrogatepass"), sha256).hexdigest()


def chosen_grants(file: Path | None, environment: str | None) -> Grants | None:
    """The grants of a file, or of the variable PLAINSPOKEN_TOKENS; None where there are none.

    raises InputFileError: when they cannot be used
    """
    if file is not None:
        return GrantFile(file)
    if not environment:
        return None
    found = grants_in(environment.replace(";", "\n"), TOKENS_VARIABLE)
    if not found:
        raise InputFileError("it grants nobody anything", TOKENS_VARIABLE, hint=HOW_TO_GRANT)
    return lambda: found
