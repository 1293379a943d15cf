"""The interface of a program in logarithms that its solvers use."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Protocol

import numpy as np

from flexcli.numerics.log_sum_exp import Expansion, LogSumExp
from flexcli.numerics.signomial import Floats

__all__ = ["LogProgram", "violation"]


class LogProgram(Protocol):
    """Minimise row 0 over y = ln x, with the next rows ≤ 0 and the last ones = 0."""

    @property
    def names(self) -> tuple[str, ...]:
        """Return the variables."""

    @property
    def inequalities(self) -> int:
        """Return the number of inequalities."""

    @property
    def low(self) -> Floats:
        """Return the lower limits of y."""

    @property
    def high(self) -> Floats:
        """Return the upper limits of y: a run that reaches one is unbounded."""

    @property
    def is_convex(self) -> bool:
        """Return whether ``model`` is the program itself, and its equalities are affine."""

    def rows(self, y: Floats) -> Floats:
        """Return all rows at many points, (n, points) to (rows, points), NaN outside the domain."""

    def expand(self, y: Floats) -> Expansion:
        """Return values, gradients and curvatures of all rows at one point."""

    def model(self, at: Expansion, y: Floats) -> LogSumExp:
        """Return convex rows over the step from a point, without the equalities."""

    def chosen(self, kept: Sequence[int]) -> LogProgram:
        """Return the program with some of its inequalities, and without equalities."""

    def along(self, origin: Floats, basis: Floats) -> LogProgram:
        """Return the program on the plane y = origin + basis z of orthonormal directions."""


def violation(program: LogProgram, values: Floats) -> Floats:
    """Return the largest log violation at each point, 0 where all rows hold."""
    unequal = values[1 : 1 + program.inequalities]
    equal = np.abs(values[1 + program.inequalities :])
    nothing = np.zeros((1, *values.shape[1:]))
    return np.asarray(np.concatenate([nothing, unequal, equal]).max(axis=0))
