"""The command line: one module a command, imported only when it is used."""

from __future__ import annotations

import sys
from importlib import import_module

import click

from plainspoken.cli.exit import BAD_INPUT
from plainspoken.errors import PlainspokenError

COMMANDS = {
    "demo": "Play the whole story on the bundled vineyard.",
    "extract": "Turn a sentence into a formula, stage by stage.",
    "listen": "Turn a recording into text, and that into a formula.",
    "plan": "Find a policy that reaches a goal whatever happens.",
    "check": "Validate a policy from the PDDL and the formula alone.",
    "export": "Write a policy or an automaton for other tools.",
    "run": "Carry a mission out and record it.",
    "work": "Carry out the missions that wait in a store, as a worker.",
    "ask": "Ask what a robot is doing, has done, will do, and why.",
    "serve": "Open the page: say what should be done, watch it, ask about it.",
    "token": "Make a token for somebody who may look, or command, over the network.",
    "report": "Tell a mission what you did or saw.",
    "answer": "Answer what a mission asks of people.",
    "eval": "Measure how well sentences are understood, and how true answers are.",
    "missions": "List missions; pause, resume, cancel or change one; write its log.",
    "doctor": "See what is installed, and which symbols a problem has.",
}

EPILOG = """
\b
A first tour:
  plainspoken demo
  plainspoken extract "Visit line 2, then call the support robot" --explain
  plainspoken run --say "Clear line 2, but stay out of line 3" --log run.jsonl
  plainspoken ask "Why did you do that?" --log run.jsonl

Without --domain and --problem, commands speak of the bundled vineyard. Exit status: 0 for success,
2 for bad input, 3 where the answer is no (unsolvable, rejected, not valid).
"""


class _Commands(click.Group):
    """Finds commands by name without importing the others: --help has to be quick."""

    def list_commands(self, ctx: click.Context) -> list[str]:
        del ctx
        return list(COMMANDS)

    def get_command(self, ctx: click.Context, cmd_name: str) -> click.Command | None:
        del ctx
        if cmd_name not in COMMANDS:
            return None
        command = getattr(import_module(f"plainspoken.cli.{cmd_name}"), cmd_name)
        assert isinstance(command, click.Command)  # noqa: S101 - a slip of ours, not of the user
        return command

    def format_commands(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        del ctx
        with formatter.section("Commands"):
            formatter.write_dl(list(COMMANDS.items()))


@click.command(
    cls=_Commands, epilog=EPILOG, context_settings={"help_option_names": ["-h", "--help"]}
)
@click.version_option(package_name="plainspoken")
def plainspoken() -> None:
    """Tell a robot in plain words what should get done, and ask it how it is going."""


def main() -> None:
    """Run the command line; our errors go to standard error with their hint."""
    try:
        plainspoken.main(prog_name="plainspoken")
    except PlainspokenError as error:
        click.echo(f"plainspoken: {error}", err=True)
        sys.exit(BAD_INPUT)
