"""Scripts are the same for the whole process: each test begins without any."""

import pytest
from tests.backends.activities.scripted import AWAY, CALLED, CANCELLED, SCRIPTS, SERVICES


@pytest.fixture(autouse=True)
def _no_scripts() -> None:
    for each in (AWAY, CALLED, CANCELLED, SCRIPTS, SERVICES):
        each.clear()
