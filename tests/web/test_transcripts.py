"""Recordings that are sent to the server: who may, how much, how often, and whatever they hold."""

from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from starlette.testclient import TestClient
from tests.language.recordings import heard, pcm16, tone, wav
from tests.web.bench import SITE, Bench, bench, endless_robot, granted

from plainspoken.cli.store import open_store
from plainspoken.language.transcription import Samples, Transcript
from plainspoken.web.access import Access, Role
from plainspoken.web.desk import Desk
from plainspoken.web.hearing import MOST_BYTES, RECORDINGS, Hearing
from plainspoken.web.rate import Rates

TRANSCRIPTS = "/api/v1/transcripts"
HERE = f"{TRANSCRIPTS}?place=vineyard"
WAV = {"Content-Type": "audio/wav"}
SOUND = wav(pcm16(tone(440, 1)))
ADA = Access(None, everyone="ada")


def hears(_: Samples, hints: Sequence[str], /) -> Transcript:
    return heard(f"never {' '.join(sorted(hints)[:1])}")


@pytest.fixture(scope="module")
def desk(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Desk]:
    folder: Path = tmp_path_factory.mktemp("transcripts")
    with open_store(str(folder / "store.sqlite")) as store:
        found = Desk({"vineyard": SITE}, store, endless_robot)
        yield found
        found.close()


def at(desk: Desk, access: Access = ADA, hearing: Hearing | None = None, **more: Any) -> Bench:
    return bench(desk, access, hearing=hearing or Hearing(lambda: hears), **more)


def sent(client: TestClient, content: bytes = SOUND, address: str = HERE) -> tuple[int, Any]:
    answer = client.post(address, content=content, headers=WAV)
    return answer.status_code, answer.json()


def test_what_is_heard_comes_back_with_its_weighty_words(desk: Desk) -> None:
    status, found = sent(at(desk).client())
    assert status == 200
    assert found["text"].startswith("never ")
    assert found["emphases"][0] == {"start": 0, "end": 5, "weight": "negation"}


def test_of_a_mission_the_words_of_its_place_are_expected(desk: Desk) -> None:
    here = at(desk)
    mission = here.started("spoken of")
    client = here.client()
    assert sent(client, SOUND, f"{TRANSCRIPTS}?mission={mission}")[0] == 200
    assert sent(client, SOUND, f"{TRANSCRIPTS}?mission=nobody")[0] == 404
    assert sent(client, SOUND, f"{TRANSCRIPTS}?place=nowhere")[0] == 404
    assert sent(client, SOUND, f"{TRANSCRIPTS}?place=vineyard&mission={mission}")[0] == 422
    assert sent(client, SOUND, TRANSCRIPTS)[0] == 422


def test_a_viewer_is_not_heard_nor_is_a_stranger(desk: Desk) -> None:
    tokens, access = granted((Role.OPERATOR, "ada"), (Role.VIEWER, "vera"))
    here = at(desk, access)
    assert sent(here.client(tokens["ada"]))[0] == 200
    assert sent(here.client(tokens["vera"]))[0] == 403
    assert sent(here.client())[0] == 401


def test_a_recording_is_as_large_as_a_minute_and_no_larger(desk: Desk) -> None:
    client = at(desk).client()
    assert sent(client, wav(pcm16(tone(440, 59.0))))[0] == 200
    status, told = sent(client, b"R" * (MOST_BYTES + 1))
    assert status == 413
    assert str(MOST_BYTES) in told["what"]


def test_silence_and_other_kinds_of_files_are_refused_with_what_to_do(desk: Desk) -> None:
    client = at(desk).client()
    status, told = sent(client, wav(b"\0" * 32_000))
    assert (status, "no speech" in told["what"]) == (422, True)
    answer = client.post(HERE, content=SOUND, headers={"Content-Type": "audio/webm"})
    assert (answer.status_code, "audio/wav" in answer.json()["hint"]) == (422, True)


def test_who_speaks_without_end_is_told_when_to_go_on(desk: Desk) -> None:
    client = at(desk, rates=Rates(lambda: 0.0)).client()
    answers = [client.post(HERE, content=SOUND, headers=WAV) for _ in range(7)]
    assert [each.status_code for each in answers] == [200] * int(RECORDINGS.at_once) + [429]
    assert answers[-1].headers["Retry-After"] == "5"


def test_without_a_recogniser_it_says_how_to_get_one(desk: Desk) -> None:
    def load() -> Any:
        raise AssertionError("there is nothing to load")

    status, told = sent(at(desk, hearing=Hearing(load, "pip install ears")).client())
    assert (status, told["hint"]) == (503, "pip install ears")
    assert sent(bench(desk, ADA).client())[0] == 503


def test_weights_are_loaded_when_somebody_first_speaks_and_once(desk: Desk) -> None:
    loaded: list[int] = []

    def load() -> Any:
        loaded.append(1)
        return hears

    client = at(desk, hearing=Hearing(load)).client()
    assert loaded == []
    assert [sent(client)[0] for _ in range(2)] == [200, 200]
    assert loaded == [1]


@st.composite
def spoilt(draw: st.DrawFn) -> bytes:
    """A WAV file in which some bytes are others, or which ends too early, or none at all."""
    if draw(st.booleans()):
        return draw(st.binary(max_size=200))
    whole = bytearray(wav(pcm16(tone(440, 0.01))))
    places = st.dictionaries(st.integers(0, 60), st.integers(0, 255), max_size=8)
    for place, byte in draw(places).items():
        whole[place] = byte
    return bytes(whole[: draw(st.integers(0, len(whole)))])


KINDS = st.sampled_from(["audio/wav", "audio/wav; codecs=1", "text/plain", "", "a" * 9000])


@pytest.mark.timeout(300)
def test_whatever_is_uploaded_is_heard_or_refused(desk: Desk) -> None:
    days = iter(range(0, 10**9, 86400))
    client = at(desk, rates=Rates(lambda: next(days))).client()

    @settings(
        max_examples=150, deadline=None, derandomize=True, suppress_health_check=list(HealthCheck)
    )
    @given(content=spoilt(), kind=KINDS)
    def tried(content: bytes, kind: str) -> None:
        answer = client.post(HERE, content=content, headers={"Content-Type": kind})
        assert answer.status_code in (200, 422)
        assert answer.json().get("what") or answer.json().get("text")

    tried()
