"""`plainspoken doctor`: what is installed, and which symbols a problem has."""

from __future__ import annotations

import json
import os
import platform
import shutil
from collections.abc import Mapping
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

import click
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from plainspoken.cli.site import chosen_site, site_options
from plainspoken.cli.store import STORE_VARIABLE
from plainspoken.knowledge.database import without_password
from plainspoken.knowledge.log import store_path

PACKAGES = {
    "plainspoken": "all of it",
    "click": "the command line",
    "rich": "what you see in the terminal",
    "simplemma": "lemmas: harvesting is harvest",
}
PROGRAMS = {"dot": ("Graphviz, to draw `export dot`", "install the package graphviz")}


@click.command()
@site_options
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def doctor(
    domain: Path | None, problem: Path | None, landmarks: Path | None, *, as_json: bool
) -> None:
    """See what is installed, what is missing and how to get it.

    With --domain and --problem: the symbols that a sentence or a formula may use there.
    """
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


def _show_symbols(site: object, *, as_json: bool) -> None:
    from plainspoken.pipeline import Site

    assert isinstance(site, Site)  # noqa: S101 - chosen_site gives nothing else
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
