"""The paper's experiment on extraction: every sentence is translated, and its ending is named.

source: section "Evaluating Process Extraction": accuracy is the share of formulas correctly
extracted. Correct here is equivalence over all non-empty finite traces, never likeness of text.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from concurrent.futures import Executor
from dataclasses import dataclass
from enum import StrEnum
from functools import lru_cache
from hashlib import sha256
from traceback import extract_tb

from plainspoken import __version__
from plainspoken.automata.equivalence import equivalent
from plainspoken.errors import PlainspokenError
from plainspoken.evaluation.corpus import Row, RowId, pattern_name
from plainspoken.evaluation.metric import Mentions, compared, differs_in_grounding
from plainspoken.language.extraction import Extraction, Status
from plainspoken.language.grounding import Vocabulary
from plainspoken.logic.syntax import unparse
from plainspoken.world.landmark import Landmark

Translate = Callable[[Row, Vocabulary], Extraction]
"""How a row's utterance becomes an extraction. For several processes, a function of a module."""
Key = str


class Outcome(StrEnum):
    """How the run of one sentence ended."""

    RIGHT = "right"
    WRONG_FORMULA = "wrong formula"
    WRONG_GROUNDING = "wrong grounding"
    ASKED = "asked"
    REFUSED = "refused"
    FAILED = "failed"
    UNEXPLAINED = "unexplained"


@dataclass(frozen=True, slots=True)
class Result:
    """What became of one sentence.

    key:        of everything that the result depends on
    outcome:    right where every reading that the corpus gives is right
    literal:    whether that reading is right
    executable: whether that one is; None where the corpus does not give it
    formula:    the recognised literal reading, where there is one
    pattern:    the recognised one; None where none was named
    reason:     why it was refused or failed, or what was asked
    mentions:   None where the corpus does not say what is mentioned
    seconds:    None where the time is not ours to measure
    """

    id: RowId
    key: Key
    outcome: Outcome
    literal: bool = False
    executable: bool | None = None
    formula: str | None = None
    pattern: str | None = None
    reason: str | None = None
    mentions: Mentions | None = None
    seconds: float | None = None


class UnexplainedError(PlainspokenError):
    """Some run ended in a way that has no name, so no figure can be trusted."""

    def __init__(self, results: Sequence[Result]) -> None:
        self.results = tuple(results)
        super().__init__(
            f"{len(results)} of the runs ended unexplained, so there is no table",
            where="\n".join(f"{each.id}: {each.reason}" for each in results[:10]),
            hint="this is a mistake in plainspoken: report it with these lines",
        )


def key_of(row: Row, mode: str) -> Key:
    """A digest of the sentence, its gold, its landmarks, the mode and our version."""
    parts = (__version__, mode, row.utterance, row.literal, row.executable, row.landmarks)
    return sha256(repr((*parts, row.mentions)).encode()).hexdigest()[:16]


def run_experiment(
    rows: Sequence[Row],
    mode: str,
    translate: Translate,
    *,
    known: Mapping[tuple[RowId, Key], Result] | None = None,
    executor: Executor | None = None,
    timed: bool = True,
) -> Iterator[tuple[Result, bool]]:
    """The result of each row, in the order of the rows, and whether it is new.

    known:    results of an earlier run; not run again, unless they failed, as a server may
    executor: runs sentences side by side; without one, each is run when it is asked for
    """
    keys = [key_of(row, mode) for row in rows]
    done = {
        each.id: each
        for row, key in zip(rows, keys, strict=True)
        if (each := (known or {}).get((row.id, key))) is not None
        and each.outcome not in (Outcome.FAILED, Outcome.UNEXPLAINED)
    }
    todo = [(row, key) for row, key in zip(rows, keys, strict=True) if row.id not in done]
    count = len(todo)
    arguments = (
        [row for row, _ in todo],
        [key for _, key in todo],
        [translate] * count,
        [timed] * count,
    )
    fresh = iter((executor.map if executor is not None else map)(run_one, *arguments))
    for row in rows:
        if row.id in done:
            yield done[row.id], False
        else:
            yield next(fresh), True


def run_one(row: Row, key: Key, translate: Translate, timed: bool) -> Result:  # noqa: FBT001 - map hands arguments over by place
    """Translate one sentence and judge what came of it. Never raises."""
    vocabulary = _vocabulary(row.landmarks)
    started = time.perf_counter()
    try:
        extraction = translate(row, vocabulary)
        seconds = round(time.perf_counter() - started, 6) if timed else None
        return judged(row, key, extraction, seconds)
    except PlainspokenError as error:
        return Result(row.id, key, Outcome.FAILED, reason=str(error))
    except Exception as error:  # noqa: BLE001 - it is written down, and fails the table
        place = extract_tb(error.__traceback__)[-1]
        reason = f"{type(error).__name__}: {error} ({place.name}, line {place.lineno})"
        return Result(row.id, key, Outcome.UNEXPLAINED, reason=reason)


def judged(row: Row, key: Key, extraction: Extraction, seconds: float | None) -> Result:
    """Compare an extraction with the gold of its row.

    raises FormulaTooLargeError: where two formulas are too large to be compared
    """
    literal, executable = False, None if row.executable is None else False
    reading = extraction.reading if extraction.status is Status.OK else None
    if reading is not None:
        literal = equivalent(reading.literal, row.literal)
        if row.executable is not None:
            executable = equivalent(reading.formula, row.executable)
    outcome, reason = _ending(row, extraction, right=literal and executable is not False)
    return Result(
        row.id,
        key,
        outcome,
        literal,
        executable,
        unparse(reading.literal) if reading is not None else None,
        pattern_name(extraction.pattern) if extraction.pattern else None,
        reason,
        None if row.mentions is None else compared(extraction.referring_expressions, row.mentions),
        seconds,
    )


def _ending(row: Row, extraction: Extraction, *, right: bool) -> tuple[Outcome, str | None]:
    match extraction.status:
        case Status.OK if right:
            return Outcome.RIGHT, None
        case Status.OK if (reading := extraction.reading) is not None:
            if differs_in_grounding(reading.literal, row.literal):
                return Outcome.WRONG_GROUNDING, None
            return Outcome.WRONG_FORMULA, None
        case Status.CLARIFY if extraction.question:
            return Outcome.ASKED, extraction.question
        case Status.REJECT if extraction.reason:
            return Outcome.REFUSED, extraction.reason
    return Outcome.UNEXPLAINED, f"status {extraction.status}, and neither formula nor words"


@lru_cache(maxsize=64)
def _vocabulary(landmarks: tuple[Landmark, ...]) -> Vocabulary:
    # A corpus shares its landmarks among hundreds of rows; the published sets have some a row.
    return Vocabulary.of({one.id: one for one in landmarks})
