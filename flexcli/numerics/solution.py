"""How a program over positive variables was solved: outcome, optimum, multipliers, certificate."""

from dataclasses import dataclass
from typing import Literal

from flexcli.errors import Outcome

__all__ = ["ACTIVE", "Solution"]

ACTIVE = 1e-7
"""A constraint is active when its log utilisation is within this of zero: far above the solver's
residual, far below any tolerance of manufacture."""


@dataclass(frozen=True, eq=False)
class Solution:
    """Result of a program in logarithms.

    Parameters
    ----------
    outcome
        How the solve ended. Unless it converged, `x` is the last or the least violating point.
    x, objective
        The minimiser and the minimum.
    multipliers
        λ ≥ 0 of each constraint: ln objective falls by λ per unit by which ln(numerator /
        denominator) may exceed zero, to first order.
    equality_multipliers
        The same for equalities, of either sign.
    active
        Constraints whose log utilisation is within `ACTIVE` of zero.
    slack
        ln(numerator/denominator) of each constraint: negative inside.
    gap
        Duality gap of ln objective, so relative to the objective.
    kkt_residual
        Largest violation of the optimality conditions, in logarithms. A sum that just reaches one
        at a single point (x + 1/x ≤ 2) has no multiplier and leaves its part here.
    iterations
        Newton steps of the interior-point runs.
    certificate
        "global" when every row is convex in logarithms, else "local".
    unique
        Whether no direction leads to equally good points (of this optimum, when local).
    optima
        Local optima met that differ in their objective; 1 for a global certificate.
    violation
        Least largest log violation when infeasible, else the largest one at x.
    runaway
        Variables that run away when unbounded.
    tied
        Whether a further objective chose among equally good points.
    """

    outcome: Outcome
    x: dict[str, float]
    objective: float
    multipliers: dict[str, float]
    equality_multipliers: dict[str, float]
    active: tuple[str, ...]
    slack: dict[str, float]
    gap: float
    kkt_residual: float
    iterations: int
    certificate: Literal["global", "local"]
    unique: bool
    optima: int
    violation: float
    runaway: tuple[str, ...] = ()
    tied: bool = False

    @property
    def converged(self) -> bool:
        """Whether x is a solution."""
        return self.outcome is Outcome.CONVERGED
