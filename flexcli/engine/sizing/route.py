"""What a sizing asks of its solver: optimum, balance, grid, and why there is no design."""

from collections.abc import Mapping
from typing import Protocol

from flexcli.engine.sizing.balanced import Balanced, NotBalanced
from flexcli.engine.sizing.grid import GridPoint
from flexcli.numerics.geometric_program import Solution
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Grid, Objective
from flexcli.results import Relaxation, Sensitivity

__all__ = ["Route"]


class Route(Protocol):
    """A design's rows and a way to solve them."""

    @property
    def names(self) -> tuple[str, ...]:
        """Return the free dimensions."""

    def complete(self, x: Mapping[str, float]) -> Sizes:
        """Return the sizes of a solution, fixed dimensions included."""

    def least(self, objective: Objective) -> Solution:
        """Return the best design, ties broken by the volume, then by l, b and h."""

    def refuse(self, objective: Objective, solution: Solution, smallest: Solution) -> None:
        """Raise where a solution is no design, or not even the volume makes it the only one."""

    def certificate(self, solution: Solution) -> str:
        """Return how sure an optimum is, in words."""

    def active(self, solution: Solution) -> tuple[str, ...]:
        """Return the names of what holds an optimum."""

    def sensitivities(self, objective: Objective, solution: Solution) -> tuple[Sensitivity, ...]:
        """Return what 1 % more demand in each active row moves."""

    def conflict(self) -> tuple[tuple[Relaxation, ...], str]:
        """Return the requirements that conflict, and how sure that is."""

    def balanced(self) -> Balanced | NotBalanced:
        """Return the balanced design, or why there is none."""

    def on_grid(
        self, grids: Mapping[str, Grid], objective: Objective | None, centre: Mapping[str, float]
    ) -> GridPoint:
        """Return the best point on a grid; without an objective the nearest to the centre."""
