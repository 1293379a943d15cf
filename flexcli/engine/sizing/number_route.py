"""Sizing by limits that are numbers: local optima of convex models from many starts."""

from collections.abc import Mapping

from flexcli.engine.sizing.balanced import Balanced, NotBalanced
from flexcli.engine.sizing.grid import GridPoint, best_on_grid
from flexcli.engine.sizing.number_balanced import balanced
from flexcli.engine.sizing.number_conflict import explain_conflict
from flexcli.engine.sizing.number_grid import number_task
from flexcli.engine.sizing.number_optimum import STARTS, optimum, refuse_undetermined, sensitivities
from flexcli.engine.sizing.number_program import goal_of
from flexcli.engine.sizing.number_rows import NumberSizing, Term
from flexcli.engine.sizing.optimum import active_rows, refuse_unsolved
from flexcli.engine.sizing.program import ties
from flexcli.errors import NoSolution
from flexcli.numerics.geometric_program import Outcome, Solution
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Grid, Objective
from flexcli.results import Relaxation, Sensitivity

__all__ = ["NumberRoute"]


class NumberRoute:
    """A design as rows of numbers."""

    def __init__(self, design: DesignSpec, sizing: NumberSizing) -> None:
        self.design = design
        self.sizing = sizing

    @property
    def names(self) -> tuple[str, ...]:
        """Return the free dimensions."""
        return self.sizing.names

    def complete(self, x: Mapping[str, float]) -> Sizes:
        """Return the sizes of a solution, fixed dimensions included."""
        return self.sizing.complete({name: x[name] for name in self.names})

    def _objectives(self, objective: Objective) -> list[Term]:
        goal = goal_of(objective, self.sizing)
        order = [Term(f"size {name}") for name in ties(self.names)]
        return list(dict.fromkeys([goal, Term("volume"), *order]))

    def least(self, objective: Objective) -> Solution:
        """Return the best design, ties broken by the volume, then by l, b and h."""
        sizing = self.sizing
        return optimum(sizing, self._objectives(objective), sizing.limits(), sizing.equalities())

    def refuse(self, objective: Objective, solution: Solution, smallest: Solution) -> None:
        """Raise where a solution is no design, or not even the volume makes it the only one."""
        if solution.outcome is Outcome.STALLED:
            raise NoSolution(
                "did-not-converge",
                "the sizing did not converge on limits that are numbers",
                "bound the free dimensions more closely; a limit with a kink needs a limit of its "
                "own for each of its branches",
            )
        refuse_unsolved(solution, self.sizing)
        if not (solution.unique or smallest.converged):
            goal = goal_of(objective, self.sizing)
            refuse_undetermined(self.sizing, goal, solution, smallest)

    def certificate(self, solution: Solution) -> str:
        """Return how sure an optimum is, in words."""
        count = len(self.sizing.starts) or STARTS
        starts = f"{count} starts" if count > 1 else "1 start"
        found = f"best of {solution.optima} found" if solution.optima > 1 else "the only one found"
        return f"local optimum, {starts}: {found}"

    def active(self, solution: Solution) -> tuple[str, ...]:
        """Return the names of what holds an optimum."""
        return active_rows(solution, self.sizing)

    def sensitivities(self, objective: Objective, solution: Solution) -> tuple[Sensitivity, ...]:
        """Return what 1 % more demand in each active row moves."""
        return sensitivities(self.sizing, self._objectives(objective), solution)

    def conflict(self) -> tuple[tuple[Relaxation, ...], str]:
        """Return the requirements that conflict, and how sure that is."""
        return explain_conflict(self.sizing)

    def balanced(self) -> Balanced | NotBalanced:
        """Return the balanced design, or why there is none."""
        return balanced(self.sizing)

    def on_grid(
        self, grids: Mapping[str, Grid], objective: Objective | None, centre: Mapping[str, float]
    ) -> GridPoint:
        """Return the best point on a grid; without an objective the nearest to the centre."""
        objectives = None if objective is None else self._objectives(objective)
        task = number_task(self.sizing, grids, objectives, centre)
        return best_on_grid(self.design, grids, centre, task)
