"""The look of our tables."""

from collections.abc import Iterable

from rich.table import Table

__all__ = ["table"]


def table(title: str, *columns: str, numbers: Iterable[int] = ()) -> Table:
    """Return an empty table without frame; columns of numbers stand right and never wrap."""
    empty = Table(title=title, title_justify="left", title_style="bold", box=None, pad_edge=False)
    right = set(numbers)
    for index, name in enumerate(columns):
        number = index in right
        empty.add_column(
            name, justify="right" if number else "left", no_wrap=number, overflow="fold"
        )
    return empty
