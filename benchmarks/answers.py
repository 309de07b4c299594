"""How long an answer takes on logs of 1,000 and of 100,000 events, question by question.

    python benchmarks/answers.py [--events N,N]
    python benchmarks/answers.py --questions FILE    # how many are understood instead; see below

A robot shuttles between two lines of the vineyard; each question is asked of the end of the log as
the first one about it, so that nothing worked out for another is at hand.

A FILE of questions has the lines that `tests/questions/asked.py` describes: each question with the
kind and the things that it is about.
"""

from __future__ import annotations

import argparse
import json
import sys
import time
from pathlib import Path
from statistics import median

from plainspoken.pipeline import bundled
from plainspoken.questions.answer import answer_at
from plainspoken.questions.moment import Moment
from plainspoken.world.event import ActionFinished, ActionStarted, Entry, Event, MissionAccepted
from plainspoken.world.pddl import parse_domain, parse_problem

QUESTIONS = (
    "What are you doing?",
    "What did you do so far?",
    "What did you do last?",
    "How often did you move?",
    "When were you first at line 1?",
    "Was the box ever full?",
    "Is grape 1 ripe?",
    "Where is the support robot?",
    "Why don't you check grape 3?",
    "How far are you?",
    "Are you keeping away from line 3?",
    "What happened before you went to line 0?",
)
REPEATS = 5


def log_of(events: int) -> list[Entry]:
    """A log of so many events."""
    folder = bundled("vineyard")
    domain, problem = (folder / f"{each}.pddl" for each in ("domain", "problem"))
    read = parse_problem(problem.read_text(), parse_domain(domain.read_text(), "d"), "p")
    changing = read.changing_predicates
    state = frozenset(atom for atom in read.initial if atom.split()[0] in changing)
    accepted = MissionAccepted(
        "m",
        None,
        "F cleared_l0 & G !robot_at_rob_l3",
        "",
        domain.read_text(),
        problem.read_text(),
        json.loads((folder / "landmarks.json").read_text()),
        tuple(sorted(read.initial - state)),
        state,
        {},
    )
    found: list[Entry] = [Entry(0, "", 0, accepted)]
    instant, here, there = 0, "l0", "l1"
    while len(found) < events:
        action = f"move rob {here} {there}"
        state = (state - {f"robot-at rob {here}"}) | {f"robot-at rob {there}"}
        both: tuple[Event, Event] = (
            ActionStarted(action, None, str(instant)),
            ActionFinished(action, str(instant), state, None),
        )
        found.append(Entry(len(found), "", instant, both[0]))
        instant += 1
        found.append(Entry(len(found), "", instant, both[1]))
        here, there = there, here
    return found


def understanding(paths: list[Path]) -> None:
    """Print what is understood of the questions of files, by rules, listener, and both."""
    sys.path.insert(0, str(Path(__file__).parents[1]))
    from tests.questions.asked import asked_in, report

    for path in paths:
        print(report(asked_in(path)))


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--events", default="1000,100000")
    parser.add_argument("--questions", type=Path, nargs="+", help="measure what is understood")
    options = parser.parse_args()
    if options.questions:
        understanding(options.questions)
        return
    print("| events | reading the log | median answer | slowest answer | question |")
    print("| ---: | ---: | ---: | ---: | --- |")
    for number in map(int, options.events.split(",")):
        entries = log_of(number)
        answer_at(QUESTIONS[0], Moment(entries))  # What a process does once: the words of a domain.
        began = time.perf_counter()
        Moment(entries)
        reading = time.perf_counter() - began
        taken: dict[str, float] = {}
        for question in QUESTIONS:
            times = []
            for _ in range(REPEATS):
                fresh = Moment(entries)
                began = time.perf_counter()
                answer_at(question, fresh)
                times.append(time.perf_counter() - began)
            taken[question] = median(times)
        slowest = max(taken, key=lambda each: taken[each])
        shown = [reading, median(taken.values()), taken[slowest]]
        cells = " | ".join(f"{1000 * each:.1f} ms" for each in shown)
        print(f"| {number} | {cells} | {slowest} |")


if __name__ == "__main__":
    main()
