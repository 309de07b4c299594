"""What the description of the interface promises, tried with made-up requests of every kind."""

from collections.abc import Iterator
from itertools import count
from pathlib import Path
from typing import Any, cast

import pytest
import schemathesis
from hypothesis import HealthCheck, given, settings
from hypothesis.errors import Unsatisfiable
from schemathesis.checks import not_a_server_error
from schemathesis.generation import GenerationMode
from schemathesis.specs.openapi.checks import (
    content_type_conformance,
    response_schema_conformance,
    status_code_conformance,
)
from tests.language.recordings import heard
from tests.web.bench import SITE, bench, slow_robot, until

from plainspoken.cli.store import open_store
from plainspoken.web.access import Access
from plainspoken.web.api import Office, create_api
from plainspoken.web.desk import Desk
from plainspoken.web.hearing import Hearing
from plainspoken.web.rate import Rates

API = "/api/v1"
schemathesis.serializer.alias("audio/wav", "application/octet-stream")
CHECKS = [
    not_a_server_error,
    status_code_conformance,
    content_type_conformance,
    response_schema_conformance,
]
OPERATIONS = [
    (method, path)
    for path, routes in create_api(cast("Office", None)).openapi()["paths"].items()
    for method in routes
]
OVER, PAUSED = "over", "paused/1"


@pytest.fixture(scope="module")
def described(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The description of a server with a mission that is over, and one that rests."""
    folder: Path = tmp_path_factory.mktemp("schema")
    days = count(0, 86400)
    with open_store(str(folder / "store.sqlite")) as store:
        desk = Desk({"vineyard": SITE}, store, slow_robot)
        it = bench(desk, Access(None, everyone="ada"), Rates(lambda: next(days)), patience=0.1,
                   hearing=Hearing(lambda: lambda *_: heard("never")))  # fmt: skip
        it.started(OVER)
        it.started(PAUSED)
        desk.pause(PAUSED, "ada")
        until(lambda: desk.mission(OVER).is_over and not desk.is_running(PAUSED))
        schema = schemathesis.openapi.from_asgi(f"{API}/openapi.json", it.app)

        @schema.hook
        def map_path_parameters(context: Any, found: dict[str, Any]) -> dict[str, Any]:
            """Speak of what there is, half of the time; of what goes on, no stream would end."""
            path = context.operation.path
            if found and "mission" in found and len(str(found["mission"])) % 2:
                found["mission"] = OVER if path.endswith("stream") else PAUSED
            if found and "place" in found and len(str(found["place"])) % 2:
                found["place"] = "vineyard"
            return found

        try:
            yield schema
        finally:
            desk.close()


@pytest.mark.timeout(600)
@pytest.mark.parametrize(("method", "path"), OPERATIONS)
@pytest.mark.parametrize("mode", GenerationMode)
def test_whatever_is_sent_the_answer_is_one_that_was_promised(
    described: Any, method: str, path: str, mode: GenerationMode
) -> None:
    operation = described[path][method]

    @settings(
        max_examples=8, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
    )
    @given(case=operation.as_strategy(generation_mode=mode))
    def tried(case: Any) -> None:
        case.call_and_validate(checks=CHECKS)

    try:
        tried()
    except Unsatisfiable:
        assert mode is GenerationMode.NEGATIVE  # an operation that takes nothing has no wrong way
