"""The alternatives of a sizing: designs of a Pareto front, and options of the spec."""

from collections.abc import Mapping
from typing import Any, NamedTuple

__all__ = ["ChoiceRow", "Choices", "Front", "FrontPoint"]


class FrontPoint(NamedTuple):
    """A design of a front: both objectives and its sizes [SI], how sure it is, what was chosen.

    ``bound`` is what was asked of the second objective, nothing where the spec's own bound.
    """

    first: float
    second: float
    bound: float | None
    sizes: Mapping[str, float]
    certificate: str
    chosen: Mapping[str, Any]


class Front(NamedTuple):
    """Designs of which none is better in both objectives, by the second; each passes its check.

    ``knee`` is the place of the one farthest from the line between the ends, in logarithms:
    beyond it little of one costs much of the other; nothing where the front is straight.
    ``proved`` says that each is the global optimum at its bound. ``remarks`` tell the ends.
    """

    first: str
    first_unit: str
    second: str
    second_unit: str
    points: tuple[FrontPoint, ...]
    knee: int | None
    proved: bool
    remarks: tuple[str, ...]


class ChoiceRow(NamedTuple):
    """One combination of options, how its sizing ended, its objective, and why it has none."""

    option: Mapping[str, Any]
    status: str
    objective: float | None
    reason: str


class Choices(NamedTuple):
    """The combinations that were sized, and the one that was taken, if any."""

    objective: str
    unit: str
    rows: tuple[ChoiceRow, ...]
    chosen: Mapping[str, Any]
