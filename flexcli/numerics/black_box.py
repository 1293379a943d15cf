"""Programs whose rows are known only as numbers: their values, expansions and convex models."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import ClassVar

import numpy as np

from flexcli.numerics.convex_model import posynomials
from flexcli.numerics.log_stencil import Field, differences
from flexcli.numerics.log_sum_exp import Expansion, LogSumExp
from flexcli.numerics.signomial import Floats

__all__ = ["BlackBox"]


@dataclass(frozen=True, eq=False)
class BlackBox:
    """Minimise row 0 over y = ln x, with the next rows ≤ 0 and the last ones = 0.

    Parameters
    ----------
    names
        The variables.
    rows
        All rows at many points at once; a point outside the domain gives NaN.
    inequalities
        How many rows after the first are ≤ 0; the rest are equalities.
    low, high
        Ends of the world in y: a run that gets there is unbounded.
    """

    is_convex: ClassVar[bool] = False

    names: tuple[str, ...]
    rows: Field
    inequalities: int
    low: Floats
    high: Floats

    def expand(self, y: Floats) -> Expansion:
        """Return the expansion of all rows at one point."""
        return differences(self.rows, y)

    def model(self, at: Expansion, _y: Floats) -> LogSumExp:
        """Return convex rows over the step from a point, up to the inequalities."""
        keep = 1 + self.inequalities
        return posynomials(Expansion(*(part[:keep] for part in at)))

    def chosen(self, kept: Sequence[int]) -> BlackBox:
        """Return the program with some of its inequalities, and without equalities."""
        picked = [0, *(1 + i for i in kept)]
        return replace(self, rows=lambda y: self.rows(y)[picked], inequalities=len(kept))

    def along(self, origin: Floats, basis: Floats) -> BlackBox:
        """Return the program on the plane y = origin + basis z of orthonormal directions."""
        reach = np.full(basis.shape[1], float((self.high - self.low).max()))
        return replace(
            self,
            names=tuple(f"direction {k}" for k in range(basis.shape[1])),
            rows=lambda z: self.rows(origin[:, None] + basis @ z),
            low=-reach,
            high=reach,
        )
