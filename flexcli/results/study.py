"""Results of a study: a row for each design, its values and checks as columns."""

from collections.abc import Mapping
from typing import NamedTuple

__all__ = ["Column", "StudyResult", "StudyRow"]


class Column(NamedTuple):
    """A column of numbers or words: its name, SI unit ("" for none), its meaning."""

    name: str
    unit: str
    label: str


class StudyRow(NamedTuple):
    """One design: the values that were put in, how it ended and why, its cells by column.

    ``decided_by`` is the check nearest its limit or beyond it, ``model`` the one that decided it.
    """

    point: Mapping[str, str]
    status: str
    decided_by: str
    model: str
    reason: str
    cells: Mapping[str, float | str]


class StudyResult(NamedTuple):
    """Rows in the order of the study, and the columns of their cells; ``shown`` go to the screen.

    ``points`` is how many rows it has when it is done.
    """

    varied: tuple[str, ...]
    each: str
    columns: tuple[Column, ...]
    rows: tuple[StudyRow, ...]
    points: int
    shown: tuple[str, ...] = ()

    @property
    def passed(self) -> int:
        """Return how many designs pass."""
        return sum(row.status == "pass" for row in self.rows)
