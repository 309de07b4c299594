"""Tables of an experiment on the terminal."""

from __future__ import annotations

from rich import box
from rich.table import Table
from rich.text import Text

from plainspoken.evaluation.table import Table as Values

MOST_SHOWN = 25
"""Rows of a table that are printed; more are counted."""


def shown_table(values: Values) -> Table:
    """A table of values as the terminal shows it."""
    table = Table(
        title=values.title,
        title_justify="left",
        box=box.SIMPLE_HEAD,
        padding=(0, 2, 0, 0),
        pad_edge=False,
    )
    for column in values.columns:
        table.add_column(column)
    for row in values.rows[:MOST_SHOWN]:
        table.add_row(*map(Text, row))
    return table
