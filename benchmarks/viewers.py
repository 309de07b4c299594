"""Many who watch one mission: how soon each of them sees what happens.

    python benchmarks/viewers.py [--viewers 50] [--pages 10] [--seconds 30] [--markdown]

A server of its own (`plainspoken serve`) carries a mission out, there and back between two lines.
So many viewers follow it as server-sent events; so many have its page open, each with a NiceGUI
websocket. What is measured is the time from when an entry is dated, just before it is stored, until
a viewer has read it, for every entry and viewer; for pages, until the next message of the server to
that page after an entry. Server, viewers and robot share the machine's cores. Exit status 1 where
the 95th percentile of the events is 500 ms or more, or a viewer missed an entry.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import os
import re
import signal
import socket
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from datetime import datetime
from pathlib import Path

import httpx
from websockets.asyncio.client import connect

WITHIN = 0.5
STOPS = 16
GOAL = "".join(f"F(robot_at_rob_l{stop % 2} & " for stop in range(STOPS)) + "true" + ")" * STOPS
"""There and back between two lines, many times."""
API = "/api/v1"


@dataclass
class Viewer:
    """What one of them saw: seconds for each entry, by its step."""

    since: float = 0.0
    delays: dict[int, float] = field(default_factory=dict)
    dated: dict[int, float] = field(default_factory=dict)


@contextmanager
def served(folder: Path) -> Iterator[str]:
    """A server whose simulated robot takes a third of a second for each action."""
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    command = [sys.executable, "-m", "plainspoken", "serve", "--port", str(port)]
    command += ["--store", str(folder / "store.sqlite"), "--pace", "0.1"]
    with (folder / "written").open("wb") as written:
        process = subprocess.Popen(command, stdout=written, stderr=subprocess.STDOUT)
    base = f"http://127.0.0.1:{port}"
    try:
        for _ in range(600):
            with suppress(httpx.TransportError):
                httpx.get(f"{base}{API}/places", timeout=60)
                break
            if process.poll() is not None:
                sys.exit((folder / "written").read_text())
            time.sleep(0.1)
        yield base
    finally:
        process.send_signal(signal.SIGTERM)
        process.wait()


async def started(client: httpx.AsyncClient) -> str:
    """A mission in the vineyard, confirmed."""
    wanted = {"formula": GOAL, "timeout": 120}
    planned = await client.post(f"{API}/places/vineyard/plans", json=wanted)
    if planned.is_error or planned.json()["plan"] is None:
        sys.exit(planned.text)
    plan = planned.json()
    begun = await client.post(
        f"{API}/missions", json={"plan": plan["plan"], "confirm": plan["formula"]}
    )
    begun.raise_for_status()
    mission: str = begun.json()["mission"]
    return mission


async def watch(client: httpx.AsyncClient, mission: str, viewer: Viewer) -> None:
    """Follow one mission until its end."""
    step = 0
    async with client.stream("GET", f"{API}/missions/{mission}/stream") as stream:
        stream.raise_for_status()
        viewer.since = time.time()
        async for line in stream.aiter_lines():
            seen = time.time()
            if line.startswith("id: "):
                step = int(line[4:])
            elif line.startswith("data: "):
                viewer.dated[step] = datetime.fromisoformat(
                    json.loads(line[6:])["time"]
                ).timestamp()
                viewer.delays[step] = seen - viewer.dated[step]


async def look(client: httpx.AsyncClient, mission: str, times: list[float]) -> None:
    """Have the page of a mission open; note when the server tells it something."""
    page = (await client.get(f"/missions/{mission}", timeout=60)).text
    found = re.search(r"query: (.*),\n", page)
    if found is None:
        sys.exit(f"the page of {mission} has changed: {page[:300]}")
    asked = dict(re.findall(r"""['"](\w+)['"]: ['"]?([\w-]+)""", found.group(1)))
    hello = {
        "client_id": asked["client_id"],
        "tab_id": os.urandom(8).hex(),
        "old_tab_id": None,
        "document_id": os.urandom(8).hex(),
        "next_message_id": int(asked["next_message_id"]),
    }
    at = str(client.base_url).replace("http", "ws").rstrip("/")
    at += f"/_nicegui_ws/socket.io/?EIO=4&transport=websocket&client_id={asked['client_id']}"
    async with connect(at, max_size=None) as link:
        async for frame in link:
            if frame == "2":
                await link.send("3")
            elif isinstance(frame, str) and frame.startswith("0"):
                await link.send("40")
            elif isinstance(frame, str) and frame.startswith("40"):
                await link.send("420" + json.dumps(["handshake", hello]))
            elif isinstance(frame, bytes) or frame.startswith(("42", "45")):
                times.append(time.time())


def quantiles(found: list[float]) -> tuple[float, float, float]:
    """The median, the 95th percentile, and the most, in milliseconds."""
    ordered = sorted(found)
    return tuple(
        1000 * ordered[min(len(ordered) - 1, int(len(ordered) * q))] for q in (0.5, 0.95, 1)
    )  # type: ignore[return-value]


async def measured(
    base: str, options: argparse.Namespace
) -> tuple[list[Viewer], list[list[float]]]:
    """Missions, one after another, each watched by everybody from its beginning to its end."""
    limits = httpx.Limits(max_connections=None)
    viewers: list[Viewer] = []
    pages: list[list[float]] = []
    deadline = time.monotonic() + options.seconds
    async with httpx.AsyncClient(base_url=base, limits=limits, timeout=3600) as client:
        while time.monotonic() < deadline:
            mission = await started(client)
            mine = [Viewer() for _ in range(options.viewers)]
            looking: list[list[float]] = [[] for _ in range(options.pages)]
            open_pages = [asyncio.create_task(look(client, mission, times)) for times in looking]
            await asyncio.gather(*(watch(client, mission, viewer) for viewer in mine))
            last = max(mine[0].dated.values())
            for _ in range(200):  # what the pages are still told
                if all(times and times[-1] >= last for times in looking):
                    break
                await asyncio.sleep(0.1)
            for task in open_pages:
                task.cancel()
            ended = await asyncio.gather(*open_pages, return_exceptions=True)
            for one in ended:
                if isinstance(one, Exception):
                    raise one
            steps = set(mine[0].delays)
            if any(set(viewer.delays) != steps for viewer in mine):
                sys.exit("a viewer missed an entry")
            # What happened before the last of them was there is not what they wait for.
            first = max(viewer.since for viewer in mine)
            dated = sorted(at for at in mine[0].dated.values() if at > first)
            for viewer in mine:
                viewer.delays = {s: d for s, d in viewer.delays.items() if viewer.dated[s] > first}
            viewers += mine
            pages += [
                [next((told - at for told in times if told >= at), 60.0) for at in dated]
                for times in looking
            ]
    return viewers, pages


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--viewers", type=int, default=50)
    parser.add_argument("--pages", type=int, default=10)
    parser.add_argument("--seconds", type=float, default=30)
    parser.add_argument("--markdown", action="store_true", help="for docs/results.md")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder, served(Path(folder)) as base:
        viewers, pages = asyncio.run(measured(base, options))
    rows = [
        ("server-sent events", options.viewers, [d for v in viewers for d in v.delays.values()])
    ]
    if options.pages:
        rows.append(("pages over a websocket", options.pages, [d for each in pages for d in each]))
    if options.markdown:
        print("| watching by | viewers at once | updates | median | 95th percentile | most |")
        print("|---|---:|---:|---:|---:|---:|")
    for name, count, delays in rows:
        median, p95, most = quantiles(delays)
        form = (
            "| {} | {} | {} | {:.0f} ms | {:.0f} ms | {:.0f} ms |"
            if options.markdown
            else (
                "{}: {} at once, {} updates: {:.0f} ms (median), {:.0f} ms (95th percentile), "
                "{:.0f} ms (most)"
            )
        )
        print(form.format(name, count, len(delays), median, p95, most))
    sys.exit(quantiles(rows[0][2])[1] >= 1000 * WITHIN)


if __name__ == "__main__":
    main()
