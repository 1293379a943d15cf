"""Sizing by closed forms that are signomials: geometric programs, global where convex."""

from collections.abc import Mapping

from flexcli.engine.sizing.balanced import Balanced, NotBalanced, balanced
from flexcli.engine.sizing.grid import GridPoint, best_on_grid, posynomial_task
from flexcli.engine.sizing.optimum import (
    active_rows,
    certificate,
    explain_conflict,
    optimum,
    refuse_undetermined,
    refuse_unsolved,
    sensitivities,
)
from flexcli.engine.sizing.program import objective_of, sizing_program, ties
from flexcli.numerics.geometric_program import Solution
from flexcli.numerics.signomial import Signomial, as_signomial
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Grid, Objective
from flexcli.results import Relaxation, Sensitivity

__all__ = ["PosynomialRoute"]


class PosynomialRoute:
    """A design as a geometric program."""

    def __init__(self, design: DesignSpec) -> None:
        self.design = design
        self.program = sizing_program(design)
        self.volume = objective_of(design, "least-volume", self.program.sizes)

    @property
    def names(self) -> tuple[str, ...]:
        """Return the free dimensions."""
        return self.program.names

    def complete(self, x: Mapping[str, float]) -> Sizes:
        """Return the sizes of a solution, fixed dimensions included."""
        return self.program.complete({name: x[name] for name in self.names})

    def _goal(self, objective: Objective) -> Signomial:
        return objective_of(self.design, objective, self.program.sizes)

    def _ties(self) -> list[Signomial]:
        sizes = self.program.sizes._asdict()
        return [as_signomial(sizes[name]) for name in ties(sizes)]

    def _objectives(self, objective: Objective) -> list[Signomial]:
        return [self._goal(objective), self.volume, *self._ties()]

    def least(self, objective: Objective) -> Solution:
        """Return the best design, ties broken by the volume, then by l, b and h."""
        objectives = self._objectives(objective)
        if objective == "least-volume":
            objectives = objectives[1:]
        return optimum(self.program, objectives, self.program.constraints, self.program.equalities)

    def refuse(self, objective: Objective, solution: Solution, smallest: Solution) -> None:
        """Raise where a solution is no design, or not even the volume makes it the only one."""
        refuse_unsolved(solution, self.program)
        if not (solution.unique or smallest.converged):
            refuse_undetermined(self._goal(objective), solution, smallest, self.program)

    def certificate(self, solution: Solution) -> str:
        """Return how sure an optimum is, in words."""
        return certificate(solution, self.program)

    def active(self, solution: Solution) -> tuple[str, ...]:
        """Return the names of what holds an optimum."""
        return active_rows(solution, self.program)

    def sensitivities(self, objective: Objective, solution: Solution) -> tuple[Sensitivity, ...]:
        """Return what 1 % more demand in each active row moves."""
        return sensitivities(self.program, self._objectives(objective), solution)

    def conflict(self) -> tuple[tuple[Relaxation, ...], str]:
        """Return the requirements that conflict, and how sure that is."""
        return explain_conflict(self.program)

    def balanced(self) -> Balanced | NotBalanced:
        """Return the balanced design, or why there is none."""
        return balanced(self.program, self.volume)

    def on_grid(
        self, grids: Mapping[str, Grid], objective: Objective | None, centre: Mapping[str, float]
    ) -> GridPoint:
        """Return the best point on a grid; without an objective the nearest to the centre."""
        objectives = None if objective is None else self._objectives(objective)
        task = posynomial_task(self.program, grids, objectives, centre)
        return best_on_grid(self.design, grids, centre, task)
