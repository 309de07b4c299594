"""Which addresses are ours: what we listen on, what browsers may call us, who may call from where.

A page of somebody else that is open in the same browser can send requests here, too. Browsers say
in `Host` by which name they reached us, and in `Origin` which page asks; a name that is not ours
means that somebody pointed their own name at this computer (DNS rebinding).
"""

from __future__ import annotations

import re
import socket
from collections.abc import Iterable
from dataclasses import dataclass
from ipaddress import ip_address
from urllib.parse import urlsplit

from plainspoken.errors import PlainspokenError
from plainspoken.web.access import HOW_TO_GRANT

HostName = str

_HOST = re.compile(r"(?P<name>\[[0-9a-fA-F:.]+\]|[^\s:/@\[\]]+)(?::(?P<port>\d{1,5}))?")


def is_loopback(name: HostName) -> bool:
    """Whether a name reaches this computer alone."""
    if name.lower() == "localhost":
        return True
    try:
        return ip_address(name.strip("[]")).is_loopback
    except ValueError:
        return False


def refuse_exposure(host: HostName, names: Iterable[HostName], *, guarded: bool) -> None:
    """Have nobody listen where strangers are, unless they need a token.

    names: further names that we are reached by, through a proxy say
    raises PlainspokenError: where others than this computer's users could come in freely
    """
    foreign = [name for name in (host, *names) if not is_loopback(name)]
    if foreign and not guarded:
        raise PlainspokenError(
            f"whoever reaches {foreign[0]} could command the robots: nobody needs a token",
            where=f"--host {host}" if foreign[0] == host else f"--name {foreign[0]}",
            hint=f"give --tokens FILE; {HOW_TO_GRANT}",
        )


def at(host: HostName) -> str:
    """A host as it stands in an address."""
    return f"[{host}]" if ":" in host else host


@dataclass(frozen=True, slots=True)
class Names:
    """The names that we answer to.

    names: those that were given, lower case
    wide:  whether we listen to more than this computer: then by address, and by its name, too
    """

    names: frozenset[HostName]
    wide: bool = False

    @classmethod
    def of(cls, host: HostName, names: Iterable[HostName] = ()) -> Names:
        """The names of a server that listens on an address."""
        given = {host, *names} | ({socket.gethostname()} if not is_loopback(host) else set())
        return cls(frozenset(name.lower() for name in given), not is_loopback(host))

    def cover(self, host: str | None) -> bool:
        """Whether a `Host` is one of ours. An address is no name: nobody can point it elsewhere."""
        match = _HOST.fullmatch(host or "")
        if match is None:
            return False
        name = match["name"].lower()
        if name in self.names or is_loopback(name):
            return True
        return self.wide and _is_address(name)


def is_same_origin(origin: str, host: str | None) -> bool:
    """Whether a page came from the host that it calls.

    The scheme is not compared: before a proxy it is https, behind it http.
    """
    try:
        parts = urlsplit(origin)
    except ValueError:
        return False
    if parts.scheme not in ("http", "https") or not host:
        return False
    return _plain(parts.netloc) == _plain(host)


def _plain(netloc: str) -> str:
    return netloc.lower().removesuffix(":443").removesuffix(":80")


def _is_address(name: HostName) -> bool:
    try:
        ip_address(name.strip("[]"))
    except ValueError:
        return False
    return True
