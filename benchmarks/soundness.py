"""Whether every claim of an answer is so, judged from outside, and how much of the truth is told.

    python benchmarks/soundness.py [--triples 1000] [--seed 0] [--work FOLDER]

The judge shares nothing with the answers but the files: it runs `plainspoken run --log`, asks with
`plainspoken ask --batch`, and reads the JSON of both. What is claimed of now and of the past is
compared with the states of the log; what will be, with every execution of the policy in the log;
what may be, with at least one.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from random import Random
from statistics import fmean, median
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
FOLDERS = {
    "vineyard": ROOT / "examples" / "vineyard",
    "warehouse": ROOT / "examples" / "warehouse",
    "kitchen": ROOT / "examples" / "kitchen",
    "hospital": ROOT / "tests" / "questions" / "domains" / "hospital",
    "reading_room": ROOT / "tests" / "questions" / "domains" / "reading_room",
}
GOALS: Mapping[str, tuple[str, ...]] = {
    "vineyard": (
        "F cleared_l0 & F cleared_l1 & F cleared_l2 & F cleared_l3",
        "F cleared_l0 & F cleared_l1 & G !robot_at_rob_l3",
        "F cleared_l2 & (full_b -> X call_support_executed)",
    ),
    "warehouse": (
        "F delivered_crate & F delivered_drum & G(battery_low_cart -> F !battery_low_cart)",
        "F delivered_crate & (!robot_at_cart_plug W delivered_crate)",
    ),
    "kitchen": ("F served_soup & F !open_fridge", "F served_soup"),
    "hospital": (
        "F charted_adams & F charted_brown & F nurse_informed",
        "F charted_adams & (!robot_at_medi_room_2 U given_aspirin_adams)",
    ),
    "reading_room": ("F shelved_atlas & F shelved_sonnets & G(torn_diary -> F mended_diary)",),
}
FAULTS = ((), ("failing:0.2",), ("person:0.15",), ("failing:0.1", "person:0.1"))
LENGTHS = ("brief", "normal", "full")
GENERAL: Mapping[str, tuple[str, ...]] = {
    "now": (
        "What are you doing now?",
        "What is the current situation?",
        "What's going on?",
        "What are you up to?",
    ),
    "past": (
        "What did you do so far?",
        "What have you done?",
        "What has happened so far?",
        "Fill me in on what you did.",
    ),
    "future": (
        "What are you going to do next?",
        "What is your plan?",
        "What will you do from now on?",
        "What's still ahead of you?",
    ),
}
"""Questions about a whole part of the trace, of which completeness can be asked."""
FURTHER = (
    "Why are you doing that?",
    "How far are you?",
    "What was the last thing you did?",
    "What did you do before that?",
    "Where are you?",
    "What is left to do?",
    "How long will it take?",
    "Are you finished?",
    "What will you do last?",
    "What happens after that?",
    "Did anything go wrong?",
    "What do you still have to do?",
    "Are you keeping to what I asked?",
)
FACT_FORMS = (
    "Is it true that {}?",
    "Was it ever so that {}?",
    "Since when is it so that {}?",
    "Why is it that {}?",
    "What if {}?",
    "Will it be that {}?",
    "How often was it so that {}?",
)
DEED_FORMS = (
    "Why did you {}?",
    "Why don't you {}?",
    "Will you {}?",
    "Did you {}?",
    "When did you {}?",
    "How often did you {}?",
    "What do you do after you {}?",
    "When will you {}?",
)


# -- the truth ---------------------------------------------------------------------------------


class Truth:
    """What a log says at one of its steps, and what its policy allows from there."""

    def __init__(self, events: Sequence[Mapping[str, Any]], step: int) -> None:
        self.states: dict[int, frozenset[str]] = {}
        self.done: dict[int, str] = {}
        self.static: frozenset[str] = frozenset()
        self._policy: dict[int, Mapping[str, Any]] = {}
        self._node: int | None = None
        for event in events:
            if event["step"] <= step:
                self._read(event)
        self.now = max(self.states)
        if self._node is not None:
            here = frozenset(self._policy[self._node]["state"]) - self.static
            if here != self.states[self.now]:
                self._node = None  # The policy says nothing of other states than its nodes'.

    def _read(self, event: Mapping[str, Any]) -> None:
        kind = event["kind"]
        if kind == "mission_accepted":
            self.static = frozenset(event["static"])
        if kind == "policy_chosen":
            self._policy = {node["id"]: node for node in event["policy"]["nodes"]}
            self._node = event["policy"]["initial"]
        elif kind == "mission_ended":
            self._node = None
        elif event.get("node") is not None:
            self._node = event["node"]
        if "state" in event:
            self.states[event["instant"]] = frozenset(event["state"]) - self.static
        if kind == "action_finished":
            self.done[event["instant"]] = event["action"]

    def _layers(self, most: int) -> list[frozenset[int]]:
        """The nodes where an execution can be after 0, 1, 2 ... further actions."""
        found = [frozenset() if self._node is None else frozenset({self._node})]
        while len(found) <= most:
            found.append(frozenset(s for id in found[-1] for s in self._policy[id]["successors"]))
        return found

    def _stopped_before(self, layers: Sequence[frozenset[int]]) -> bool:
        return any(not self._policy[id]["successors"] for layer in layers for id in layer)

    def _so(self, id: int, fluent: str) -> bool:
        return fluent in self._policy[id]["state"] or fluent in self.static

    def claims(self, claim: Mapping[str, Any]) -> bool:
        """Whether a claim about a fluent is so."""
        fluent, start, end = claim["fluent"], claim["from"], claim["to"]
        certainty = claim["certainty"]
        if not 0 <= start <= end:
            return False
        if certainty in ("is", "was"):
            if end > self.now or (certainty == "is" and end < self.now):
                return False
            return all(fluent in self.states[i] | self.static for i in range(start, end + 1))
        if start <= self.now:
            return False
        layers = self._layers(end - self.now)
        if certainty == "will":
            span = layers[start - self.now : end - self.now + 1]
            reached = all(span) and not self._stopped_before(layers[: end - self.now])
            return reached and all(self._so(id, fluent) for layer in span for id in layer)
        alive = {id for id in layers[start - self.now] if self._so(id, fluent)}
        for _ in range(start, end):
            after = {s for id in alive for s in self._policy[id]["successors"]}
            alive = {id for id in after if self._so(id, fluent)}
        return bool(alive)

    def denies(self, claim: Mapping[str, Any]) -> bool:
        """Whether what is said not to be so is not, at these instants."""
        span = range(claim["from"], claim["to"] + 1)
        return bool(span) and not any(
            claim["fluent"] in self.states.get(i, frozenset()) | self.static for i in span
        )

    def acts(self, claim: Mapping[str, Any]) -> bool:
        """Whether an action led, will lead or may lead to an instant."""
        action, at, certainty = claim["action"], claim["at"], claim["certainty"]
        if certainty == "was":
            return self.done.get(at) == action
        if at <= self.now:
            return False
        layers = self._layers(at - self.now - 1)
        actions = {self._policy[id]["action"] for id in layers[-1]}
        if certainty == "will":
            return actions == {action} and not self._stopped_before(layers)
        return action in actions

    def part(self, about: str) -> dict[int, frozenset[str]]:
        """What is true, and could be otherwise, at each instant of a part of the trace."""
        if about == "now":
            return {self.now: self.states[self.now]}
        if about == "past":
            return {i: self.states[i] for i in range(1, self.now + 1)}
        found = {}
        layers = self._layers(60)
        for number, layer in enumerate(layers):
            if not layer or self._stopped_before(layers[:number]):
                break
            states = [frozenset(self._policy[id]["state"]) - self.static for id in layer]
            found[self.now + number] = frozenset.intersection(*states)
        return found if len(found) > 1 else {}


# -- the answers -------------------------------------------------------------------------------


@dataclass(frozen=True)
class Mission:
    """A domain, and one run in it."""

    domain: str
    log: Path
    events: Sequence[Mapping[str, Any]]


@dataclass
class Tally:
    """What was counted."""

    triples: int = 0
    claims: Counter[str] = field(default_factory=Counter)
    false: list[str] = field(default_factory=list)
    told: dict[tuple[str, str], list[float]] = field(default_factory=dict)
    words: dict[tuple[str, str], list[int]] = field(default_factory=dict)


def missions(work: Path, number: int, chance: Random) -> Iterator[Mission]:
    """Runs with different goals, chances and faults, over all domains in turn."""
    for index in range(number):
        domain = list(FOLDERS)[index % len(FOLDERS)]
        folder, log = FOLDERS[domain], work / f"run-{index}.jsonl"
        command = ["run", "--log", str(log), "--overwrite", "--seed", str(chance.randrange(10**6))]
        command += ["--domain", str(folder / "domain.pddl")]
        command += ["--problem", str(folder / "problem.pddl"), "--json"]
        if (folder / "landmarks.json").exists():
            command += ["--landmarks", str(folder / "landmarks.json")]
        command += ["--goal", chance.choice(GOALS[domain])]
        for fault in chance.choice(FAULTS):
            command += ["--fault", fault]
        plainspoken(command, work)
        yield Mission(domain, log, read_jsonl(log))


def plainspoken(arguments: Sequence[str], work: Path) -> None:
    """Run a command; 3 is an honest no, such as a mission that could not be finished."""
    done = subprocess.run(
        [sys.executable, "-m", "plainspoken", *arguments],
        check=False,
        capture_output=True,
        text=True,
        env={"PLAINSPOKEN_HOME": str(work)},
    )
    if done.returncode not in (0, 3):
        raise SystemExit(f"{' '.join(arguments)}: {done.stderr}")


def read_jsonl(path: Path) -> list[dict[str, Any]]:
    """The objects of a file, one a line."""
    return [json.loads(line) for line in path.read_text().splitlines()]


def questions(mission: Mission, number: int, chance: Random) -> Iterator[tuple[str, str]]:
    """So many questions, each with the part of the trace it is about, or nothing."""
    path = FOLDERS[mission.domain] / "landmarks.json"
    words = json.loads(path.read_text()).values() if path.exists() else ()
    facts = [each["description"] for each in words if each["type"] == "condition"]
    deeds = [each["description"][3:] for each in words if each["type"] == "action"]
    for _ in range(number):
        draw = chance.random()
        if draw < 0.4:
            about = chance.choice(list(GENERAL))
            yield chance.choice(GENERAL[about]), about
        elif draw < 0.55 or not facts:
            yield chance.choice(FURTHER), ""
        elif draw < 0.8:
            yield chance.choice(FACT_FORMS).format(chance.choice(facts)), ""
        else:
            yield chance.choice(DEED_FORMS).format(chance.choice(deeds)), ""


def asked(
    mission: Mission, step: int, length: str, texts: Sequence[str], work: Path
) -> list[dict[str, Any]]:
    """The answers to some questions as if asked at a step."""
    batch, out = work / "questions.jsonl", work / "answers.jsonl"
    batch.write_text(
        "".join(json.dumps({"id": i, "question": t}) + "\n" for i, t in enumerate(texts))
    )
    command = ["ask", "--log", str(mission.log), "--at", str(step), "--length", length]
    plainspoken([*command, "--batch", str(batch), "--out", str(out)], work)
    return read_jsonl(out)


def judge(answer: Mapping[str, Any], truth: Truth, where: str, tally: Tally) -> None:
    """Count the claims of an answer, and note those that are not so."""
    judged = [(truth.claims, each) for each in answer["claims"]]
    judged += [(truth.denies, each) for each in answer.get("denied", ())]
    judged += [(truth.acts, each) for each in answer.get("actions", ())]
    for holds, claim in judged:
        tally.claims[claim["certainty"]] += 1
        if not holds(claim):
            tally.false.append(f"{where}: {answer['question']} {answer['answer']} -- {claim}")


def completeness(answer: Mapping[str, Any], part: Mapping[int, frozenset[str]]) -> float:
    """The mean share of what is true at an instant that is claimed for it."""
    shares = []
    for instant, true in part.items():
        said = {
            claim["fluent"] for claim in answer["claims"] if claim["from"] <= instant <= claim["to"]
        }
        shares.append(len(true & said) / len(true) if true else 1.0)
    return fmean(shares)


def measured(triples: int, seed: int, work: Path, at_once: int = 8) -> Tally:
    """Ask at random, and judge."""
    chance = Random(seed)
    tally = Tally()
    runs = list(missions(work, min(30, max(5, triples // 30)), chance))
    while tally.triples < triples:
        mission = chance.choice(runs)
        step = chance.randrange(len(mission.events))
        length = chance.choice(LENGTHS)
        truth = Truth(mission.events, step)
        chosen = list(questions(mission, min(at_once, triples - tally.triples), chance))
        answers = asked(mission, step, length, [text for text, _ in chosen], work)
        for answer, (_, about) in zip(answers, chosen, strict=True):
            tally.triples += 1
            judge(answer, truth, f"{mission.log.name} step {step} {length}", tally)
            part = truth.part(about) if about else {}
            if part:
                key = (length, about)
                tally.told.setdefault(key, []).append(completeness(answer, part))
                tally.words.setdefault(key, []).append(len(answer["answer"].split()))
    return tally


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n", 1)[0])
    parser.add_argument("--triples", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--work", type=Path, help="keep the logs there")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        work = options.work or Path(folder)
        work.mkdir(parents=True, exist_ok=True)
        tally = measured(options.triples, options.seed, work)
    for each in tally.false:
        print(f"false: {each}", file=sys.stderr)
    number = tally.claims.total()
    sound = 1 - len(tally.false) / number
    counts = ", ".join(f"{count} {word}" for word, count in sorted(tally.claims.items()))
    print(f"{tally.triples} triples, {number} claims ({counts}); soundness {sound:.3f}\n")
    print("| length | about | answers | completeness | words (median) |")
    print("| --- | --- | ---: | ---: | ---: |")
    for length in LENGTHS:
        for about in GENERAL:
            told = tally.told.get((length, about), [])
            if told:
                words = median(tally.words[length, about])
                print(f"| {length} | {about} | {len(told)} | {fmean(told):.3f} | {words:g} |")
    sys.exit(1 if tally.false else 0)


if __name__ == "__main__":
    main()
