"""`plainspoken answer`: what missions wait for people to say or do."""

from __future__ import annotations

import json

import click
from rich.console import Console
from rich.table import Table

from plainspoken.backends.questions import Question, Questions
from plainspoken.cli.robots import person
from plainspoken.cli.store import open_store, store_option
from plainspoken.errors import PlainspokenError


@click.command()
@click.argument("answer", required=False, metavar="[ANSWER]")
@click.option("--call", metavar="ID", help="Which question, where several are open.")
@click.option("--by", metavar="NAME", help="Who answers (default: you).")
@store_option
@click.option("--json", "as_json", is_flag=True, help="Print the open questions as JSON.")
def answer(
    answer: str | None, call: str | None, by: str | None, store: str | None, *, as_json: bool
) -> None:
    """List what missions ask of people, or answer it.

    A mission waits for its answer, also over the end of the program that asked. "cannot" is an
    answer to every question: the action then fails.

    \b
    plainspoken answer
    plainspoken answer ripe
    plainspoken answer --call 1122-093005-7f3a/4:0#1 cannot
    """
    with open_store(store) as kept:
        questions = Questions(kept.database)
        found = questions.open()
        if answer is not None:
            chosen = _chosen(found, call)
            questions.answer(chosen.call, answer, by or person())
            click.echo(f"answered: {chosen.text}")
            return
    if as_json:
        rows = [{"call": q.call, "question": q.text, "answers": q.answers} for q in found]
        click.echo(json.dumps(rows, indent=2, ensure_ascii=False))
        return
    if not found:
        click.echo("nobody is asked anything")
        return
    table = Table("call", "question", "answers", "since")
    for question in found:
        table.add_row(question.call, question.text, " / ".join(question.answers), question.asked)
    Console().print(table)


def _chosen(found: tuple[Question, ...], call: str | None) -> Question:
    """The question that is answered.

    raises PlainspokenError: when there is none, or several and no --call
    """
    if call is not None:
        found = tuple(question for question in found if question.call == call)
    if len(found) == 1:
        return found[0]
    if not found:
        raise PlainspokenError(
            "nobody is asked anything" if call is None else f"no open question {call!r}",
            hint="`plainspoken answer` lists the open questions",
        )
    raise PlainspokenError(
        f"{len(found)} questions are open",
        hint=f"name one with --call: {', '.join(question.call for question in found)}",
    )
