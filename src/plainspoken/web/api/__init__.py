"""The same for programs: missions, events, questions, reports and commands over HTTP.

`create_api` makes an application of its own, which is put at `/api/v1` beside the page. Who calls,
and whether they may come in at all, is for the gate to say; what they may do is said here.
"""

from __future__ import annotations

from plainspoken.web.api.application import create_api
from plainspoken.web.api.office import Office

__all__ = ["Office", "create_api"]
