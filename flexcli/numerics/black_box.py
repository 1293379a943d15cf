"""Programs whose rows are known only as numbers: their values, expansions and parts."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from flexcli.numerics.log_stencil import Field, Taylor, differences, gradients
from flexcli.numerics.signomial import Floats

__all__ = ["BlackBox"]


@dataclass(frozen=True, eq=False)
class BlackBox:
    """Minimise row 0 over y = ln x, with the rows that follow ≤ 0 and the last ones = 0.

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
    base
        Cheaper rows of nearly the same shape. Where given, only the difference of the true rows
        from these is expanded, to first order: a monomial correction of each (space mapping).
    noise
        Rounding of the rows, in logarithms.
    """

    names: tuple[str, ...]
    rows: Field
    inequalities: int
    low: Floats
    high: Floats
    base: Field | None = None
    noise: float = 1e-14

    def taylor(self, y: Floats) -> Taylor:
        """Return the expansion of all rows at one point."""
        base = self.base
        if base is None:
            return differences(self.rows, y)
        inner = differences(base, y)
        values, slopes = gradients(lambda points: self.rows(points) - base(points), y)
        return Taylor(inner.values + values, inner.gradients + slopes, inner.curvatures)

    def violation(self, values: Floats) -> float:
        """Return the largest log violation, 0 where all rows hold."""
        unequal, equal = values[1 : 1 + self.inequalities], values[1 + self.inequalities :]
        return max(float(unequal.max(initial=0.0)), float(np.abs(equal).max(initial=0.0)))

    def chosen(self, kept: Sequence[int]) -> BlackBox:
        """Return the program with some of its inequalities, and without equalities."""
        picked = [0, *(1 + i for i in kept)]

        def some_of(field: Field) -> Field:
            return lambda y: field(y)[picked]

        return replace(
            self,
            rows=some_of(self.rows),
            base=some_of(self.base) if self.base is not None else None,
            inequalities=len(kept),
        )

    def along(self, origin: Floats, basis: Floats) -> BlackBox:
        """Return the program on the plane y = origin + basis z of orthonormal directions."""

        def on_plane(field: Field) -> Field:
            return lambda z: field(origin[:, None] + basis @ z)

        reach = np.full(basis.shape[1], float((self.high - self.low).max()))
        return replace(
            self,
            names=tuple(f"direction {k}" for k in range(basis.shape[1])),
            rows=on_plane(self.rows),
            base=on_plane(self.base) if self.base is not None else None,
            low=-reach,
            high=reach,
        )
