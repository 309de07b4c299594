"""The voice of espeak-ng, a program of its own (GPL): only called, never linked or shipped."""

from __future__ import annotations

import shutil
import subprocess
from dataclasses import dataclass

from plainspoken.language.patience import Seconds
from plainspoken.language.speaking import SpeechError, sayable

PROGRAM = "espeak-ng"
GET_IT = "install the package espeak-ng (Debian, Ubuntu: apt install espeak-ng), or read the text"


def is_installed() -> bool:
    """Whether the program is there."""
    return shutil.which(PROGRAM) is not None


@dataclass(frozen=True, slots=True)
class Espeak:
    """A `Speaker`. voice: one of `espeak-ng --voices=en`; speed: words a minute."""

    voice: str = "en-gb"
    speed: int = 160
    patience: Seconds = 180.0

    def say(self, text: str, /) -> None:
        self._run(text)

    def recorded(self, text: str, /) -> bytes:
        return self._run(text, "--stdout")

    def _run(self, text: str, *options: str) -> bytes:
        program = shutil.which(PROGRAM)
        if program is None:
            raise SpeechError(f"{PROGRAM} is not installed", hint=GET_IT)
        try:
            ended = subprocess.run(  # noqa: S603 - found above; the text goes in on its standard input
                [program, "-v", self.voice, "-s", str(self.speed), "--stdin", *options],
                input=sayable(text).encode(),
                capture_output=True,
                timeout=self.patience,
                check=False,
            )
        except (OSError, subprocess.TimeoutExpired) as error:
            raise SpeechError(f"{PROGRAM} does not run: {error}", hint=GET_IT) from error
        trouble = ended.stderr.decode(errors="replace").strip()
        # Without a sound card it complains, and ends as if all were well; ALSA's own lines may
        # complain of what does no harm.
        failed = any(line.lower().startswith("error") for line in trouble.splitlines())
        if ended.returncode or failed:
            raise SpeechError(
                f"{PROGRAM} said nothing: {trouble.splitlines()[-1] if trouble else 'no reason'}",
                hint=f"is there a sound card? `{PROGRAM} --voices=en` lists the voices",
            )
        return ended.stdout
