"""How hypothesis draws: freely on a developer's machine, the same every time where CI is set."""

import os

from hypothesis import settings
from tests.stores import postgres, store, store_url

__all__ = ["postgres", "store", "store_url"]

# No deadline in either: the first draw of a planning task may take a second on a cold machine.
settings.register_profile("default", deadline=None, print_blob=True)
settings.register_profile("ci", deadline=None, derandomize=True, database=None)
settings.load_profile("ci" if os.environ.get("CI") else "default")
