"""`plainspoken doctor`: what is installed, and which symbols a problem has."""

from __future__ import annotations

import json
import os
import platform
import shutil
import sys
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

import click
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from plainspoken.cli.exit import NO
from plainspoken.cli.site import FILE, chosen_site, site_options
from plainspoken.cli.store import STORE_VARIABLE
from plainspoken.knowledge.database import without_password
from plainspoken.knowledge.log import store_path

if TYPE_CHECKING:
    from plainspoken.pipeline import Site

PACKAGES = {
    "plainspoken": "all of it",
    "click": "the command line",
    "rich": "what you see in the terminal",
    "simplemma": "lemmas: harvesting is harvest",
}
PROGRAMS = {"dot": ("Graphviz, to draw `export dot`", "install the package graphviz")}


@click.command()
@site_options
@click.option("--robots", type=FILE, metavar="FILE", help="Check a robots' file, and its services.")
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def doctor(
    domain: Path | None,
    problem: Path | None,
    landmarks: Path | None,
    robots: Path | None,
    *,
    as_json: bool,
) -> None:
    """See what is installed, what is missing and how to get it.

    With --domain and --problem: the symbols that a sentence or a formula may use there. With
    --robots: whether the file fits the domain, and which of its services answer.
    """
    if robots is not None:
        _show_services(robots, chosen_site(domain, problem, landmarks), as_json=as_json)
        return
    if domain is not None or problem is not None or landmarks is not None:
        _show_symbols(chosen_site(domain, problem, landmarks), as_json=as_json)
        return
    findings = [("Python", platform.python_version(), "", "")]
    findings += [
        (name, _version(name), use, f"pip install {name}") for name, use in PACKAGES.items()
    ]
    for name, (use, remedy) in PROGRAMS.items():
        findings.append((name, shutil.which(name) or "", use, remedy))
    remedy = "pip install 'plainspoken[postgres]'"
    findings.append(("psycopg", _version("psycopg"), "--store postgresql://...", remedy))
    findings += robot_findings()
    findings += speech_findings()
    findings += model_findings(os.environ)
    store = os.environ.get(STORE_VARIABLE) or str(store_path(None))
    findings.append(("store", without_password(store), "missions", ""))
    if as_json:
        keys = ("name", "found", "use", "remedy")
        click.echo(json.dumps([dict(zip(keys, row, strict=True)) for row in findings], indent=2))
        return
    table = Table("what", "found", "for", "if missing", title="plainspoken doctor")
    for name, found, use, remedy in findings:
        table.add_row(name, found or "[yellow]missing[/]", use, "" if found else escape(remedy))
    Console().print(table)


def robot_findings() -> list[tuple[str, str, str, str]]:
    """Which robots can be reached from here, and what is missing for the others."""
    from plainspoken.cli.robots import GET_IT

    ros = _version("ros-rclpy") or ("a ROS installation's" if find_spec("rclpy") else "")
    ros_remedy = "pip install 'plainspoken[ros2]', or source a ROS 2 installation"
    return [
        ("py-trees", _version("py-trees"), "run --robots FILE: activities", GET_IT),
        ("pyyaml", _version("pyyaml"), "run --robots FILE: the file", GET_IT),
        ("rclpy", ros, "run --robots FILE: robots over ROS 2", ros_remedy),
    ]


def speech_findings() -> list[tuple[str, str, str, str]]:
    """What there is to listen and to speak with, and what is missing."""
    from plainspoken.backends import espeak, whisper

    weights = ", ".join(sorted({part.parent.name for part in whisper.packaged_weights()}))
    chosen = os.environ.get(whisper.MODEL_VARIABLE, "")
    remedy = f"{whisper.GET_WEIGHTS}, or name a folder with --whisper"
    return [
        ("faster-whisper", _version("faster-whisper"), "listen", whisper.GET_IT),
        ("Whisper's weights", chosen or weights, "listen", remedy),
        (espeak.PROGRAM, shutil.which(espeak.PROGRAM) or "", "ask --speak", espeak.GET_IT),
    ]


def model_findings(environment: Mapping[str, str]) -> list[tuple[str, str, str, str]]:
    """Which language models can be asked, and what is missing for the others.

    A provider is not called; a server of one's own is only knocked at. Of a key it is told where
    it stands, never what it is.
    """
    from plainspoken.backends import local_llm, pydantic_ai
    from plainspoken.cli.translator import MODEL_VARIABLE

    second = "a second opinion on sentences"
    weights = local_llm.packaged_weights()
    findings = [
        ("pydantic-ai", _version("pydantic-ai-slim"), second, pydantic_ai.GET_IT),
        ("xllamacpp", _version("xllamacpp"), "--model local", local_llm.GET_SERVER),
        ("weights", weights.name if weights else "", "--model local", local_llm.GET_WEIGHTS),
    ]
    for provider, keys in pydantic_ai.KEYS.items():
        if provider != "openai-chat":
            held = next((key for key in keys if environment.get(key)), "")
            remedy = f"set {' or '.join(keys)}"
            findings.append((provider, held, f"--model {provider}:NAME", remedy))
    ollama = environment.get("OLLAMA_BASE_URL") or pydantic_ai.OLLAMA
    servers = {"ollama": (ollama, "start it: ollama serve")}
    if environment.get("OPENAI_BASE_URL"):
        servers["openai server"] = (environment["OPENAI_BASE_URL"], "start it")
    for name, (url, remedy) in servers.items():
        found = url if pydantic_ai.answers(url) else ""
        findings.append((name, found, "--model " + name.split()[0] + ":NAME", remedy))
    chosen = environment.get(MODEL_VARIABLE, "")
    findings.append((MODEL_VARIABLE, chosen, "which model is asked", "or give --model"))
    return findings


def _version(package: str) -> str:
    try:
        return version(package)
    except PackageNotFoundError:
        return ""


def _show_services(file: Path, site: Site, *, as_json: bool) -> None:
    """Whether each service of a robots' file can be reached; exit status 3 where one cannot."""
    from plainspoken.cli.robots import reach

    found = reach(file, site)
    if as_json:
        click.echo(json.dumps(found, indent=2, ensure_ascii=False))
    else:
        table = Table("service", "answers", title=f"{file}: fits {site.problem.domain.name}")
        for name, trouble in found.items():
            table.add_row(name, f"[yellow]{escape(trouble)}[/]" if trouble else "yes")
        Console().print(table)
    if any(found.values()):
        sys.exit(NO)


def _show_symbols(site: Site, *, as_json: bool) -> None:
    if as_json:
        from plainspoken.world.landmark import landmarks_to_json

        click.echo(json.dumps(landmarks_to_json(site.landmarks), indent=2, ensure_ascii=False))
        return
    table = Table(
        "symbol", "type", "say", title=f"{site.problem.name}: {len(site.landmarks)} symbols"
    )
    for one in site.landmarks.values():
        table.add_row(one.id, one.type, " / ".join(one.phrases))
    Console().print(table)
