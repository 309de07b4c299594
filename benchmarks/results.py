"""Puts the tables that the benchmarks print into docs/results.md; see README.md beside this.

    python benchmarks/results.py FOLDER [--limit S]

FOLDER holds planning.md, warm.md, automata.md, unripe.md, ripe.md, unchecked.md, faults.md,
adversary.md, viewers.md and speech.md, as the benchmarks print them; S is the limit that
planning.py was run with.
"""

from __future__ import annotations

import argparse
import os
import platform
from pathlib import Path

RESULTS = Path(__file__).resolve().parents[1] / "docs" / "results.md"

PAGE = """\
# Results

Made by `benchmarks/results.py` from what the scripts in `benchmarks/` print;
`benchmarks/README.md` says how. Measured on {machine}, shared with other work: CPU seconds,
where nothing else is said.

## Planning beside other planners

Each row is one process of `plainspoken plan --out` with a limit of {limit} s: start, parsing,
grounding, search, validation and writing included. What was written was then checked once more.
The other columns are what came with the problems: PRP (Muise's planner for relevant policies),
Paladinus, and FOND4LTLf followed by PRP, each with a limit of 60 s for the FOND rows, `-` where
they found nothing.

![FOND rows decided within a CPU time](coverage.svg)

{planning}

### Warm, in one process

Rows that some baseline takes less than a second for; the median of seven rounds.

```
{warm}
```

## Automata

Formulas that make other constructions explode. The targets are a second and 200 MB for each
process; `tests/automata/test_growth.py` holds them.

{automata}

## Growth: vineyards

"Clear every line, never enter one while the box is full" in vineyards of more and more lines
with a grape each, made by `benchmarks/vineyards.py`, which says what the formula is. What is
known of the grapes at the start makes three different problems.

**Nothing to pick** (every grape is known to be unripe). There are as many automata, states and
actions as below, and no outcome to plan for: this is how grounding, automata, heuristic and
policy grow.

{unripe}

**Everything to pick** (every grape is known to be ripe). The box may be full after each drop,
and the support robot may be busy. Which grapes are stored stays in the state, so a policy that
empties the box only when it is full has states for each pair of a line and the line where it
last did. The time is spent in the planner's weak searches, one for each such state that no rule
covers; 64 lines are out of reach within a minute.

{ripe}

**Nothing known** (every grape has to be checked). What a check finds stays in the state for
good, ripe or unripe. So every policy that is a graph of states has at least 2^n of them for n
lines: what grows here is the answer, whoever searches for it.

{unchecked}

## Missions when something goes wrong

What becomes of missions on a simulated robot that a kind of fault strikes, at three actions in
ten, or that all strike: 20 seeds each, by `benchmarks/faults.py`. "Wrong" is a final verdict
in the log that is not what the plain semantics says of the recorded trace.

{faults}

Adversaries of `benchmarks/adversary.py`: mixtures of all these faults, people who report what is
so or is not, and chance that is unfair for ever. After every instant of every run the log's
verdict, of the whole and of each clause, is compared with the plain semantics.

{adversary}
## Watching

One server carries a mission out and serves everybody who watches it; server, robot and viewers
share the cores. Wall time from when an entry of the log is dated until a viewer has read it, and
for pages until the server's next message to them after that, by `benchmarks/viewers.py`. The
target is 500 ms for 95% of the updates. Other work on the machine had a lower priority meanwhile.

{viewers}

## Speech

Sentences of the three bundled domains, each with a negation, a limit or a number, said by espeak-ng
in eight voices at three speeds, with pink noise. Whisper base (int8) hears each once told the
domain's words and once not. "Weighty" are the negations, limits and numbers: how many were lost,
and how many of those where no word there or beside it is marked, so that only reading the whole
sentence finds them. Of sentences that are understood as they are written: whether the text that was
heard gives the same formula, is asked about or refused, or gives another formula, and how many of
the last have no word marked as unclear. Nobody has confirmed or corrected anything here: that is
what a person is shown the text for. [Speaking and listening](speech.md) tells more.

{speech}
"""


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=Path)
    parser.add_argument("--limit", type=int, default=60)
    chosen = parser.parse_args()
    names = (
        "planning", "warm", "automata", "unripe", "ripe", "unchecked",
        "faults", "adversary", "viewers", "speech",
    )  # fmt: skip
    tables = {name: (chosen.folder / f"{name}.md").read_text().strip() for name in names}
    machine = f"{os.cpu_count()} cores, {platform.machine()} {platform.system()}"
    machine += f", Python {platform.python_version()}"
    RESULTS.write_text(PAGE.format(machine=machine, limit=chosen.limit, **tables))


if __name__ == "__main__":
    main()
