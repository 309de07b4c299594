import asyncio
import json
import threading
from pathlib import Path
from typing import Any
from urllib.parse import quote

import pytest
from starlette.testclient import TestClient
from tests.web.bench import GOAL, SITE, Bench, bench, granted, slow_robot, until

from plainspoken.cli.store import open_store
from plainspoken.knowledge.database import StoreError
from plainspoken.knowledge.jsonl import read_jsonl
from plainspoken.mission.mission import Status
from plainspoken.planning.solver import Ending
from plainspoken.web.access import Access, Role
from plainspoken.web.api import create_api
from plainspoken.web.api.office import COMMANDING, THINKING
from plainspoken.web.desk import Desk, PlanningStopped

API = "/api/v1"


def planned(client: TestClient, formula: str = GOAL) -> dict[str, Any]:
    found = client.post(f"{API}/places/vineyard/plans", json={"formula": formula})
    assert found.status_code == 200, found.text
    document: dict[str, Any] = found.json()
    return document


def command(client: TestClient, mission: str, what: str, **body: Any) -> Any:
    return client.post(f"{API}/missions/{mission}/{what}", json=body)


# -- from a sentence to the end of a mission ---------------------------------------------------


def test_a_program_has_a_sentence_understood_planned_confirmed_and_carried_out(here: Bench) -> None:
    client = here.client()
    assert client.get(f"{API}/places").json() == [
        {"place": "vineyard", "landmarks": len(SITE.landmarks)}
    ]
    said = client.post(
        f"{API}/places/vineyard/understandings", json={"sentence": "Clear line 0"}
    ).json()
    assert (said["status"], said["formula"]) == ("ok", "F cleared_l0")
    assert said["referring_expressions"][0]["symbol"] == "cleared_l0"
    plan = planned(client, said["formula"])
    assert plan["status"] == "solved"
    assert plan["english"] == said["english"]
    begun = client.post(f"{API}/missions", json={"plan": plan["plan"], "confirm": plan["formula"]})
    assert begun.status_code == 201
    name = begun.json()["mission"]
    assert begun.headers["location"] == f"missions/{name}"
    until(lambda: bool(client.get(f"{API}/missions/{name}").json()["over"]))
    over = client.get(f"{API}/missions/{name}").json()
    assert (over["status"], over["satisfied"], over["now"], over["plan"]) == (
        "finished", True, None, None,
    )  # fmt: skip
    assert [clause["verdict"] for clause in over["clauses"]] == ["satisfied"]
    listed = client.get(f"{API}/missions").json()
    assert [each["mission"] for each in listed["missions"]] == [name]


def test_a_sentence_that_cannot_be_grounded_is_refused_with_a_reason(here: Bench) -> None:
    said = here.client().post(
        f"{API}/places/vineyard/understandings", json={"sentence": "Paint the moon blue"}
    )
    assert said.status_code == 200
    assert (said.json()["status"], said.json()["formula"]) == ("reject", None)
    assert said.json()["reason"]


def test_an_impossible_request_is_told_why(here: Bench) -> None:
    told = planned(here.client(), "F robot_at_rob_l0 & G ! robot_at_rob_l0")
    assert (told["status"], told["plan"]) == ("unsolvable", None)
    assert told["reason"]


@pytest.mark.parametrize(
    ("formula", "what"),
    [("F (", "not an LTLf formula"), ("F paint_moon", "no symbol"), ("F " * 1999 + "a", "LTLf"),
     ("\x00", "LTLf"), ("𝔽 a", "LTLf"), ("paint moon", "LTLf")],
)  # fmt: skip
def test_a_formula_that_cannot_be_used_is_told_with_its_place(
    here: Bench, formula: str, what: str
) -> None:
    refused = here.client().post(f"{API}/places/vineyard/plans", json={"formula": formula})
    assert refused.status_code == 422
    assert what in refused.json()["what"]


def test_only_the_formula_that_was_said_back_starts_a_mission_and_only_once(here: Bench) -> None:
    client = here.client()
    plan = planned(client)
    start = {"plan": plan["plan"], "confirm": "F cleared_l0"}
    refused = client.post(f"{API}/missions", json=start)
    assert refused.status_code == 409
    assert plan["formula"] in refused.json()["what"]
    start["confirm"] = plan["formula"]
    assert client.post(f"{API}/missions", json=start).status_code == 201
    assert client.post(f"{API}/missions", json=start).status_code == 404
    assert client.post(f"{API}/missions", json={"plan": "x", "confirm": "F a"}).status_code == 404
    assert len(here.desk.missions()) == 1


def test_planning_stops_when_whoever_asked_hangs_up(
    here: Bench, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, ended = threading.Event(), threading.Event()

    def endless(*_: Any, stopped: threading.Event, **__: Any) -> Ending:
        begun.set()
        assert stopped.wait(60)
        ended.set()
        raise PlanningStopped

    monkeypatch.setattr(here.desk, "plan", endless)

    async def hang_up() -> list[Any]:
        body = json.dumps({"formula": GOAL}).encode()
        messages: list[dict[str, Any]] = [{"type": "http.request", "body": body}]
        sent: list[Any] = []

        async def receive() -> dict[str, Any]:
            if messages:
                return messages.pop()
            await asyncio.to_thread(begun.wait, 60)
            return {"type": "http.disconnect"}

        async def send(message: Any) -> None:
            sent.append(message)

        scope = {
            "type": "http", "method": "POST", "path": f"{API}/places/vineyard/plans",
            "raw_path": b"", "root_path": "", "query_string": b"", "scheme": "http",
            "headers": [(b"host", b"127.0.0.1"), (b"content-type", b"application/json")],
            "client": ("127.0.0.1", 5), "http_version": "1.1",
        }  # fmt: skip
        await asyncio.wait_for(here.app(scope, receive, send), 60)  # type: ignore[arg-type]
        return sent

    asyncio.run(hang_up())
    assert ended.wait(60)
    monkeypatch.undo()
    until(lambda: not here.office.planners._taken)
    assert planned(here.client())["status"] == "solved"


def test_one_caller_plans_one_thing_at_a_time(here: Bench) -> None:
    with here.office.planners.seat("ada"):
        refused = here.client().post(f"{API}/places/vineyard/plans", json={"formula": GOAL})
    assert refused.status_code == 429
    assert int(refused.headers["retry-after"]) >= 1


# -- commands ----------------------------------------------------------------------------------


def test_a_mission_is_paused_told_something_resumed_and_cancelled(standstill: Bench) -> None:
    client, name = standstill.client(), standstill.started()
    paused = command(client, name, "pause").json()
    assert (paused["heard"], paused["status"]) == (True, "paused")
    assert client.get(f"{API}/missions/{name}").json()["paused_by"] == "ada"
    told = command(client, name, "reports", text="I saw it", added=["Robot-AT  sup l0"]).json()
    assert told["heard"]
    assert standstill.desk.entries(name)[-1].kind == "report_received"
    resumed = command(client, name, "resume", seen=told["seen"]).json()
    assert resumed["heard"]
    assert standstill.desk.mission(name).paused_by is None
    cancelled = command(client, name, "cancel", seen=resumed["seen"], confirm=True).json()
    assert cancelled["heard"]
    until(lambda: standstill.desk.mission(name).is_over)
    assert standstill.desk.mission(name).status is Status.CANCELLED
    late = command(client, name, "resume", seen=resumed["seen"])
    assert (late.status_code, late.json()["what"]) == (409, f"the mission {name} is over")


def test_of_two_who_command_at_once_the_second_is_told_who_was_first(tmp_path: Path) -> None:
    tokens, access = granted((Role.OPERATOR, "ada"), (Role.OPERATOR, "bob"))
    with open_store(str(tmp_path / "store.sqlite")) as store:
        desk = Desk({"vineyard": SITE}, store, slow_robot, most=0)  # nobody carries it out
        both = bench(desk, access, patience=0.01)
        ada, bob = both.client(tokens["ada"]), both.client(tokens["bob"])
        name = both.started()
        seen = ada.get(f"{API}/missions/{name}").json()["seen"]
        assert command(ada, name, "resume", seen=seen).status_code == 200
        refused = command(bob, name, "cancel", seen=seen, confirm=True)
        assert refused.status_code == 409
        assert refused.json()["unseen"] == [{"by": "ada", "asked": "asked to resume", "step": None}]
        stopped = command(bob, name, "pause", seen=seen)
        assert stopped.status_code == 200
        assert [each["by"] for each in stopped.json()["meanwhile"]] == ["ada"]
        desk.close()


def test_a_command_that_does_not_know_of_another_in_the_log_is_refused(standstill: Bench) -> None:
    client, name = standstill.client(), standstill.started()
    seen = client.get(f"{API}/missions/{name}").json()["seen"]
    step = command(client, name, "pause").json()["seen"]
    refused = command(client, name, "resume", seen=seen)
    assert refused.status_code == 409
    assert refused.json()["unseen"] == [{"by": "ada", "asked": "paused", "step": step}]
    assert command(client, name, "resume", seen=step).status_code == 200


def test_of_many_commands_at_the_same_moment_one_gets_through(standstill: Bench) -> None:
    name = standstill.started()
    seen = command(standstill.client(), name, "pause").json()["seen"]
    statuses: list[int] = []

    def resume() -> None:
        answer = command(standstill.client(), name, "resume", seen=seen)
        statuses.append(answer.status_code)

    threads = [threading.Thread(target=resume) for _ in range(8)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert sorted(statuses) == [200] + [409] * 7
    kinds = [entry.kind for entry in standstill.desk.entries(name)]
    assert kinds.count("resumed") == 1


def test_a_report_in_words_is_said_back_before_it_is_recorded(standstill: Bench) -> None:
    client, name = standstill.client(), standstill.at_work()
    read = command(
        client, name, "reports/understandings", text="I checked the grape, it is ripe"
    ).json()
    assert read["status"] == "ok", read
    assert not any(e.kind == "report_received" for e in standstill.desk.entries(name))
    facts = {each: read[each] for each in ("added", "deleted")}
    assert command(client, name, "reports", text=read["text"], **facts).json()["heard"]
    assert set(read["added"]) <= standstill.desk.mission(name).state
    refused = command(client, name, "reports/understandings", text="What a day").json()
    assert refused["status"] == "reject"
    assert refused["reason"]


def test_a_change_of_mind_is_made_once_its_english_is_confirmed(standstill: Bench) -> None:
    client, name = standstill.client(), standstill.started()
    seen = command(client, name, "pause").json()["seen"]
    read = command(client, name, "changes/understandings", text="Visit line 0 instead").json()
    assert read["status"] == "ok", read
    ask = {"text": read["text"], "seen": seen}
    unconfirmed = command(client, name, "changes", confirm="yes", **ask)
    assert unconfirmed.status_code == 409
    assert read["english"] in unconfirmed.json()["what"]
    assert command(client, name, "changes", confirm=read["english"], **ask).json()["heard"]
    event = standstill.desk.entries(name)[-1].event
    assert getattr(event, "english", None) == read["english"]
    assert command(client, name, "changes", confirm="", text="Dance!", seen=0).status_code == 422


@pytest.mark.parametrize(
    ("what", "body"),
    [("cancel", {"seen": 1}), ("cancel", {"seen": 1, "confirm": False}), ("resume", {}),
     ("resume", {"seen": -1}), ("resume", {"seen": 10**6}), ("pause", {"sen": 1}),
     ("reports", {"text": ""}), ("reports", {"text": "x", "added": ["made-up rob"]}),
     ("reports", {"text": "x", "added": ["robot-at rob"]}),
     ("reports", {"text": "x", "added": ["robot-at b wh"]}),
     ("reports", {"text": "x", "deleted": ["adjacent wh l0"]})],
)  # fmt: skip
def test_a_command_without_what_it_needs_is_refused(
    standstill: Bench, what: str, body: dict[str, Any]
) -> None:
    name = standstill.started()
    refused = command(standstill.client(), name, what, **body)
    assert refused.status_code == 422
    assert refused.json()["what"]
    assert "cancelled" not in {entry.kind for entry in standstill.desk.entries(name)}


def test_a_viewer_may_look_and_ask_and_not_command(tmp_path: Path) -> None:
    tokens, access = granted((Role.VIEWER, "vic"))
    with open_store(str(tmp_path / "store.sqlite")) as store:
        desk = Desk({"vineyard": SITE}, store, slow_robot, most=0)
        it = bench(desk, access, patience=0.01)
        client, name = it.client(tokens["vic"]), it.started()
        before = desk.entries(name)
        for path in ("places", "missions", f"missions/{name}", f"missions/{name}/events"):
            assert client.get(f"{API}/{path}").status_code == 200
        asked = client.post(f"{API}/missions/{name}/questions", json={"question": "What now?"})
        assert asked.status_code == 200
        for path, body in [
            ("places/vineyard/plans", {"formula": GOAL}),
            ("missions", {"plan": "x", "confirm": "F a"}),
            (f"missions/{name}/pause", {}),
            (f"missions/{name}/resume", {"seen": 1}),
            (f"missions/{name}/cancel", {"seen": 1, "confirm": True}),
            (f"missions/{name}/reports", {"text": "I did it"}),
            (f"missions/{name}/changes", {"text": "x", "confirm": "x", "seen": 0}),
        ]:
            refused = client.post(f"{API}/{path}", json=body)
            assert (refused.status_code, path) == (403, path)
            assert "vic may look and ask" in refused.json()["what"]
        assert desk.entries(name) == before
        assert not store.unanswered(name)
        desk.close()


# -- looking and asking ------------------------------------------------------------------------


def test_an_answer_carries_its_evidence(here: Bench) -> None:
    client, name = here.client(), here.started()
    until(lambda: here.desk.mission(name).is_over)
    answer = client.post(
        f"{API}/missions/{name}/questions", json={"question": "What did you do last?"}
    ).json()
    assert "warehouse" in answer["answer"]
    assert set(answer["evidence"]) <= {entry.step for entry in here.desk.entries(name)}
    assert answer["claims"]
    early = client.post(
        f"{API}/missions/{name}/questions", json={"question": "What did you do?", "at": 0}
    ).json()
    assert early["actions"] == []


def test_the_log_comes_in_pages_that_join(here: Bench) -> None:
    client, name = here.client(), here.started()
    until(lambda: here.desk.mission(name).is_over)
    found: list[dict[str, Any]] = []
    since: int | None = 0
    while since is not None:
        page = client.get(f"{API}/missions/{name}/events", params={"since": since, "most": 3})
        found += page.json()["events"]
        since = page.json()["since"]
    assert found == [json.loads(json.dumps(e.to_json())) for e in here.desk.entries(name)]


def test_the_exported_log_is_read_again_and_says_the_same(here: Bench, tmp_path: Path) -> None:
    client, name = here.client(), here.started()
    until(lambda: here.desk.mission(name).is_over)
    exported = client.get(f"{API}/missions/{name}/log")
    assert exported.headers["content-disposition"] == f'attachment; filename="{name}.jsonl"'
    (tmp_path / "log.jsonl").write_bytes(exported.content)
    assert read_jsonl(tmp_path / "log.jsonl").entries == here.desk.entries(name)


def test_the_policy_is_the_document_that_plan_writes(here: Bench) -> None:
    client, name = here.client(), here.started()
    document = client.get(f"{API}/missions/{name}/policy").json()
    assert document["status"] == "solved"
    assert client.get(f"{API}/missions/{name}").json()["plan"]["nodes"] == len(document["nodes"])


def test_missions_are_listed_in_pages_newest_first(standstill: Bench) -> None:
    names = [standstill.started(f"m{number}") for number in range(5)]
    client, found, before = standstill.client(), [], None
    for _ in range(3):
        params = {"most": 2} | ({"before": before} if before else {})
        page = client.get(f"{API}/missions", params=params).json()
        found += [each["mission"] for each in page["missions"]]
        before = page["before"]
    assert found == names[::-1]
    assert before is None


@pytest.mark.parametrize("name", ["a/b", "ünïcode", "a b", "<script>", "50%", "a" * 300])
def test_any_name_of_a_mission_can_stand_in_an_address(here: Bench, name: str) -> None:
    here.started(name)
    at = f"{API}/missions/{quote(name, safe='/')}"
    assert here.client().get(at).json()["mission"] == name
    assert here.client().get(f"{at}/events").json()["events"][0]["mission"] == name
    assert here.client().get(f"{at}/log").status_code == 200


@pytest.mark.parametrize(
    ("method", "path", "status"),
    [("GET", "missions/none", 404), ("GET", "missions/none/events", 404),
     ("GET", "missions/none/stream", 404), ("GET", "missions/none/log", 404),
     ("GET", "missions/none/policy", 404), ("GET", "nothing", 404), ("DELETE", "missions", 405),
     ("GET", "missions?most=0", 422), ("GET", "missions?before=none", 404),
     ("GET", "missions/none/events?since=-1", 422)],
)  # fmt: skip
def test_what_is_not_there_is_told_in_one_form(
    here: Bench, method: str, path: str, status: int
) -> None:
    refused = here.client().request(method, f"{API}/{path}")
    assert refused.status_code == status
    assert set(refused.json()) == {"what", "where", "hint", "unseen"}


@pytest.mark.parametrize(
    ("body", "status"),
    [(b"{", 400), (b"\xff\xfe", 400), (b"[]", 422), (b'"x"', 422), (b"null", 422), (b"", 422),
     (b'{"sentence": 5}', 422), (b'{"sentence": "x", "more": 1}', 422), (b"[" * 60_000, 400),
     (b'{"sentence": "\\ud800"}', 422), (b'{"sentence": "' + b"x" * 60_000 + b'"}', 422)],
)  # fmt: skip
def test_a_body_that_cannot_be_read_is_told_so(here: Bench, body: bytes, status: int) -> None:
    refused = here.client().post(
        f"{API}/places/vineyard/understandings",
        content=body,
        headers={"Content-Type": "application/json"},
    )
    assert (refused.status_code, refused.json()["what"] != "") == (status, True)


def test_a_refusal_does_not_say_back_what_was_sent(here: Bench) -> None:
    sent = {"sentence": {"secret": "hunter2"}}
    refused = here.client().post(f"{API}/places/vineyard/understandings", json=sent)
    assert "hunter2" not in refused.text


@pytest.mark.parametrize("rate", [THINKING, COMMANDING])
def test_what_costs_more_may_be_asked_for_less_often(
    here: Bench, rate: Any, monkeypatch: pytest.MonkeyPatch
) -> None:
    now = [0.0]
    monkeypatch.setattr(here.office.rates, "_now", lambda: now[0])
    path, body = (
        ("places/vineyard/understandings", {"sentence": "Clear line 0"})
        if rate is THINKING
        else ("missions", {"plan": "x", "confirm": "F a"})
    )
    seen = [here.client().post(f"{API}/{path}", json=body) for _ in range(int(rate.at_once) + 1)]
    assert [each.status_code == 429 for each in seen] == [False] * int(rate.at_once) + [True]
    assert "Retry-After" in seen[-1].headers
    assert here.client().get(f"{API}/missions").status_code == 200


def test_without_the_gate_nobody_is_let_in(here: Bench) -> None:
    assert TestClient(create_api(here.office)).get("/missions").status_code == 401


def test_a_store_that_is_away_may_come_back(here: Bench, monkeypatch: pytest.MonkeyPatch) -> None:
    def away() -> None:
        raise StoreError("the store cannot be reached")

    monkeypatch.setattr(here.desk, "missions", away)
    refused = here.client().get(f"{API}/missions")
    assert (refused.status_code, refused.headers["retry-after"]) == (503, "5")


def test_everybody_may_see_what_there_is_to_call(tmp_path: Path) -> None:
    with open_store(str(tmp_path / "store.sqlite")) as store:
        desk = Desk({"vineyard": SITE}, store, slow_robot)
        document = bench(desk, Access(None)).client().get(f"{API}/openapi.json").json()
        desk.close()
    assert document["servers"] == [{"url": "/api/v1"}]
    for path, routes in document["paths"].items():
        for method, route in routes.items():
            assert "429" in route["responses"], (path, method)
            assert "description" in route or "summary" in route
