"""Scripts are the same for the whole process: each test begins without any, and hears all."""

import pytest
from tests.backends.activities.scripted import AWAY, CALLED, CANCELLED, SCRIPTS, SERVICES

from plainspoken.backends.activities import tree


@pytest.fixture(autouse=True)
def _no_scripts(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tree, "TOLD_EVERY", 0.0)
    for each in (AWAY, CALLED, CANCELLED, SCRIPTS, SERVICES):
        each.clear()
