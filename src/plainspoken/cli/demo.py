"""`plainspoken demo`: one mission on the bundled vineyard, from a sentence to answers."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import ExitStack

import click
from rich.console import Console, Group
from rich.padding import Padding
from rich.panel import Panel
from rich.rule import Rule
from rich.text import Text

from plainspoken.cli.extract import explained
from plainspoken.cli.record import recorder, utc_now
from plainspoken.cli.tree import policy_tree
from plainspoken.cli.watch import Scoreboard, watch
from plainspoken.errors import PlainspokenError
from plainspoken.knowledge.log import SqliteLog, store_path
from plainspoken.mission.mission import new_mission_id
from plainspoken.mission.simulator import Simulator, steering_from
from plainspoken.pipeline import (
    Request,
    Site,
    bundled,
    carry_out,
    find_policy,
    open_site,
    understand,
)
from plainspoken.planning.policy import Policy
from plainspoken.planning.solver import Solved
from plainspoken.questions.dialogue import Dialogue
from plainspoken.questions.lexicon import Lexicon
from plainspoken.questions.moment import Moment
from plainspoken.world.event import ActionStarted, Entry

SENTENCE = (
    "Clear line 2, but never enter line 3 while the bin is full, "
    "and call the support robot as soon as it is."
)
STEERING = ("ripe g2", "full b")
ASKED_AT = 5
"""The questions are asked while the robot is at its fifth action."""
QUESTIONS = (
    "What are you doing now?",
    "Why?",
    "What have you done so far?",
    "What will you do next?",
)
LAST_QUESTIONS = ("Is the box full?", "How far are you?", "Did you enter line 3?")
PACE = 0.06
"""Real seconds for each simulated second, where somebody watches."""
NEXT = (
    'plainspoken ask "Why did you call the support robot?"',
    'plainspoken run --say "Check grape 1, then go to the warehouse" --steer "unripe g1"',
    'plainspoken extract "Whenever the box is full, call the support robot" --explain',
    'plainspoken plan --say "Visit line 3 but never visit line 2" --out policy.json',
    "plainspoken plan --domain YOUR.pddl --problem YOUR.pddl --goal 'F done'",
    "plainspoken --help",
)


@click.command()
@click.option("--pace", type=click.FloatRange(min=0), help="Real seconds for each simulated one.")
@click.option("--store", metavar="URL", help="Where the mission is kept: sqlite:///PATH or PATH.")
def demo(pace: float | None, store: str | None) -> None:
    """Play the whole story: a sentence becomes a mission that runs and answers.

    No network, no key, no server. The vineyard is simulated; two of its chances are set, so
    that the story has something to tell.
    """
    console = Console()
    if pace is None:
        pace = PACE if console.is_terminal else 0.0
    play_demo(console, pace=pace, store=store)


def play_demo(console: Console, *, pace: float, store: str | None) -> None:
    """Print the story on a console.

    pace: real seconds for each simulated one
    """
    clock = Stopwatch(time.perf_counter)
    console.print(Rule("plainspoken: from a sentence to a mission that answers"))
    with clock:
        folder = bundled("vineyard")
        site = open_site(folder / "domain.pddl", folder / "problem.pddl", folder / "landmarks.json")
        extraction = understand(SENTENCE, site)
    said = Text.assemble("\nA person says: ", (f"“{SENTENCE}”", "bold"), "\n")
    console.print(Padding(said, (0, 2)))
    explained(extraction, site.vocabulary, console)
    if extraction.formula is None:
        raise PlainspokenError("the demo's own sentence was not understood")
    with clock:
        ending = find_policy(site.problem, extraction.formula)
    if not isinstance(ending, Solved):
        raise PlainspokenError("the demo's own mission has no policy")
    lexicon = Lexicon(site.problem, site.landmarks)
    console.print(_plan_panel(ending.policy, lexicon))
    request = Request(new_mission_id(utc_now), extraction.formula, SENTENCE)
    _play(site, request, ending.policy, console, pace=pace, store=store, clock=clock)
    computed = Text.assemble(
        "\nExtracted, planned, validated and simulated in ",
        (f"{clock.seconds:.2f} s", "bold"),
        f" of computing.\nThe mission is kept in {store_path(store)}\n",
    )
    console.print(Padding(computed, (0, 2)))
    console.print(
        Panel(Text("\n".join(NEXT)), title="what to try next", title_align="left", style="green")
    )


class Stopwatch:
    """Adds up the time spent in `with` blocks: computing, not showing."""

    def __init__(self, now: Callable[[], float]) -> None:
        self._now = now
        self._started = 0.0
        self.seconds = 0.0

    def __enter__(self) -> None:
        self._started = self._now()

    def __exit__(self, *error: object) -> None:
        self.seconds += self._now() - self._started


def _plan_panel(policy: Policy, lexicon: Lexicon) -> Panel:
    took = policy.seconds.get("total", 0.0) * 1000
    said = Text(
        f"{len(policy.nodes)} states, found in {took:.0f} ms and validated independently: "
        "whatever happens, it gets there.\n",
        style="dim",
    )
    return Panel(Group(said, policy_tree(policy, lexicon)), title="5  plan", title_align="left")


def _play(
    site: Site,
    request: Request,
    policy: Policy,
    console: Console,
    *,
    pace: float,
    store: str | None,
    clock: Stopwatch,
) -> None:
    """Carry the mission out, with questions in the middle and at the end."""
    wishes = [steering_from(text, site.problem) for text in STEERING]
    simulator = Simulator(site.problem, steering=wishes, pace=pace)
    board = Scoreboard(Lexicon(site.problem, site.landmarks))
    entries: list[Entry] = []

    def half_way(entry: Entry) -> bool:
        entries.append(entry)
        return sum(isinstance(one.event, ActionStarted) for one in entries) == ASKED_AT

    def to_the_end(entry: Entry) -> bool:
        entries.append(entry)
        return False

    console.print(Rule("the mission", style="dim"))
    with ExitStack() as stack:
        kept = stack.enter_context(SqliteLog(store_path(store)))
        record = recorder(kept, request.mission, utc_now)
        events = carry_out(site, request, policy, simulator, record)
        with clock if pace == 0.0 else ExitStack():
            watch(events, board, console, until=half_way)
        _ask(QUESTIONS, entries, console, "asked while it works")
        with clock if pace == 0.0 else ExitStack():
            watch(events, board, console, until=to_the_end)
    _ask(LAST_QUESTIONS, entries, console, "asked when it is over")


def _ask(questions: Sequence[str], entries: Sequence[Entry], console: Console, title: str) -> None:
    talk = Text()
    moment, dialogue = Moment(entries), Dialogue()
    for question in questions:
        answer, dialogue = dialogue.ask(question, moment)
        talk.append(f"{question}\n", style="bold")
        talk.append(f"  {answer.text}\n")
    talk.rstrip()
    console.print(Panel(talk, title=title, title_align="left", style="cyan"))
