"""The house around the code: what holds for every file, whatever it is about."""

import ast
import re
import subprocess
import sys
import tomllib
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
SOURCE = ROOT / "src" / "plainspoken"

# Written in halves, so that this file passes its own test.
FOREIGN = re.compile(
    "|".join(
        [
            r"(?:pypi|pythonhosted|debian|npmjs)" + r"\.(?:org|com)",
            r"(?<![\w.}~-])/(?:" + r"work|root|home/\w+|Users/\w+" + r")/",
        ]
    )
)
RULE = re.compile(r'^\s*"(?P<rule>[A-Z]{1,5}\d{0,4})",(?P<rest>.*)$')
TARGET = re.compile(r"^(?P<target>[a-z][a-z-]*):(?!=)(?P<rest>.*)$", re.MULTILINE)
CODE = re.compile(r"^```.*?^```|`[^`\n]+`", re.MULTILINE | re.DOTALL)
# At the start of a line of code, or of a span: "make sure" is said in transcripts.
MAKE = re.compile(r"(?:^|`|\$ |&& )make +(?P<target>[a-z][a-z-]*)", re.MULTILINE)


def files_of_the_repository() -> list[Path]:
    """What git holds, and what it would be given next."""
    listed = subprocess.run(
        ["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
        cwd=ROOT,
        check=True,
        capture_output=True,
        text=True,
    ).stdout
    return [ROOT / name for name in listed.split("\0") if name and (ROOT / name).is_file()]


def foreign_places(text: str) -> list[str]:
    return [found.group() for found in FOREIGN.finditer(text)]


def rules_without_a_reason(pyproject: str) -> list[str]:
    """Name the lint rules that a list of ignored ones holds with no comment on their line."""
    section = pyproject.partition("[tool.ruff.lint]")[2].partition("[tool.mypy]")[0]
    _, _, ignored = section.partition("ignore = [")
    return [
        rule["rule"]
        for line in ignored.splitlines()
        if (rule := RULE.match(line)) and not re.match(r"\s*#\s*\w", rule["rest"])
    ]


def targets_of(makefile: str) -> dict[str, str]:
    return {found["target"]: found["rest"] for found in TARGET.finditer(makefile)}


def make_commands_in(page: str) -> set[str]:
    """Name the targets that a page's code, not its prose, tells the reader to make."""
    return {found["target"] for code in CODE.findall(page) for found in MAKE.finditer(code)}


def locked_names(lock: str) -> set[str]:
    return set(re.findall(r"^([a-z0-9-]+)==", lock, re.MULTILINE))


def unhashed(lock: str) -> list[str]:
    """Name the requirements whose own lines carry no hash."""
    entries = lock.replace("\\\n", " ").splitlines()
    return [
        entry.split()[0]
        for entry in entries
        if entry.strip() and not entry.startswith("#") and "--hash=sha256:" not in entry
    ]


def test_no_file_names_a_registry_or_a_place_on_one_machine() -> None:
    found = {
        str(file.relative_to(ROOT)): places
        for file in files_of_the_repository()
        if (places := foreign_places(file.read_bytes().decode("utf-8", errors="replace")))
    }
    assert found == {}


@pytest.mark.parametrize(
    "text",
    [
        "--index-url https://" + "pypi" + ".org/simple",
        "https://files." + "pythonhosted" + ".org/packages/x.whl",
        "deb http://deb." + "debian" + ".org/debian bookworm main",
        'open("' + "/work" + '/main/domain.pddl")',
        "file://" + "/root" + "/x",
        "see " + "/home" + "/ada/plan.json",
    ],
)
def test_a_registry_or_a_place_on_one_machine_would_be_found(text: str) -> None:
    assert foreign_places(text)


@pytest.mark.parametrize(
    "text", ["./work/", "the /work of a robot", "docs/root/", "${HOME}/work/", "~/work/x"]
)
def test_a_relative_path_is_not_taken_for_a_place_on_one_machine(text: str) -> None:
    assert not foreign_places(text)


def test_every_ignored_lint_rule_has_a_reason_on_its_line() -> None:
    pyproject = (ROOT / "pyproject.toml").read_text()
    lint = tomllib.loads(pyproject)["tool"]["ruff"]["lint"]
    per_file = [rule for rules in lint["per-file-ignores"].values() for rule in rules]
    on_a_line = [RULE.match(line) for line in pyproject.splitlines()]
    assert [rule["rule"] for rule in on_a_line if rule] == [*lint["ignore"], *per_file]
    assert rules_without_a_reason(pyproject) == []


def test_an_ignored_lint_rule_without_a_reason_would_be_found() -> None:
    assert rules_without_a_reason(
        '[tool.ruff.lint]\nignore = [\n  "D1", # why\n  "S101",\n  "EM", #\n]\n[tool.mypy]\n'
    ) == ["S101", "EM"]


@pytest.mark.parametrize("page", ["README.md", "CONTRIBUTING.md"])
def test_every_make_command_on_a_page_for_newcomers_exists(page: str) -> None:
    promised = make_commands_in((ROOT / page).read_text())
    assert promised, f"{page} tells nobody what to make"
    assert promised <= set(targets_of((ROOT / "Makefile").read_text()))


def test_a_make_command_is_looked_for_in_code_and_not_in_prose() -> None:
    page = "To make sure, run `make tset`:\n```sh\ngit pull && make demo\n```\n"
    assert make_commands_in(page) == {"tset", "demo"}


def test_plain_make_lists_every_target_with_a_line_of_help() -> None:
    listed = subprocess.run(
        ["make", "--no-print-directory"], cwd=ROOT, check=True, capture_output=True, text=True
    ).stdout
    for target, rest in targets_of((ROOT / "Makefile").read_text()).items():
        assert re.search(r"## \w", rest), f"{target} has no help"
        assert f"make {target} " in listed


@pytest.mark.parametrize(
    "module", sorted(SOURCE.rglob("*.py")), ids=lambda file: str(file.relative_to(SOURCE))
)
def test_every_module_says_what_it_is_for(module: Path) -> None:
    assert ast.get_docstring(ast.parse(module.read_text()))


@pytest.mark.parametrize("lock", [lock.name for lock in ROOT.glob("requirements*.lock")])
def test_every_locked_package_has_a_hash_and_comes_from_nowhere_in_particular(lock: str) -> None:
    text = (ROOT / lock).read_text()
    assert locked_names(text)
    assert unhashed(text) == []
    assert not re.search(r"^\s*-(?!-hash)|://|^[./]", text, re.MULTILINE)


def test_a_locked_package_without_a_hash_would_be_found() -> None:
    assert unhashed("a==1 \\\n    --hash=sha256:00\nb==2\n# c\n") == ["b==2"]


def test_the_locks_hold_everything_that_the_project_asks_for() -> None:
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())
    groups = project["dependency-groups"]
    run = [*project["project"]["dependencies"], *groups["build"]]
    dev = [*run, *(asked for asked in groups["dev"] if isinstance(asked, str))]
    extras = project["project"]["optional-dependencies"]
    llm = [*project["project"]["dependencies"], *extras["llm"], *extras["local-llm"]]
    for asked, lock in (
        (run, "requirements.lock"),
        (dev, "requirements-dev.lock"),
        (llm, "requirements-llm.lock"),
    ):
        names = {re.split(r"[^a-z0-9-]", requirement)[0] for requirement in asked}
        assert names <= locked_names((ROOT / lock).read_text()), f"{lock}: run `make lock`"


def test_both_locks_hold_the_same_versions() -> None:
    run, dev = (
        set(re.findall(r"^\S+==\S+", (ROOT / lock).read_text(), re.MULTILINE))
        for lock in ("requirements.lock", "requirements-dev.lock")
    )
    assert run <= dev


def test_the_lock_of_language_models_holds_no_version_that_the_others_do_not() -> None:
    dev, llm = (
        dict(re.findall(r"^([a-z0-9-]+)==(\S+)", (ROOT / lock).read_text(), re.MULTILINE))
        for lock in ("requirements-dev.lock", "requirements-llm.lock")
    )
    assert {name: llm[name] for name in dev.keys() & llm.keys()} == {
        name: dev[name] for name in dev.keys() & llm.keys()
    }


def test_the_wheel_carries_every_example_and_the_marker_for_types(tmp_path: Path) -> None:
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", "wheel", "-d", tmp_path],
        cwd=ROOT,
        check=True,
        capture_output=True,
    )
    (wheel,) = tmp_path.glob("*.whl")
    carried = set(zipfile.ZipFile(wheel).namelist())
    examples = {
        f"plainspoken/_examples/{file.relative_to(ROOT / 'examples').as_posix()}"
        for file in files_of_the_repository()
        if file.is_relative_to(ROOT / "examples")
    }
    assert examples
    assert examples <= carried
    assert "plainspoken/py.typed" in carried
