"""Posynomials in logarithms, packed: every row's value, gradient and curvature at once."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.signomial import Floats, Signomial


class Expansion(NamedTuple):
    """Values (R,), Jacobian (R, n) and curvatures (R, n, n) of all rows at one point."""

    values: Floats
    jacobian: Floats
    curvatures: Floats

    @property
    def is_finite(self) -> bool:
        """Whether all of it are numbers."""
        return all(bool(np.isfinite(part).all()) for part in self)

    def curvature(self, weights: Floats) -> Floats:
        """Return the curvature (n, n) of the weighted sum of the rows."""
        return np.asarray(np.tensordot(weights, self.curvatures, axes=1))


@dataclass(frozen=True, eq=False)
class LogSumExp:
    r"""Rows :math:`f_r(y) = \ln \sum_{k \in r} \exp(a_k y + b_k)`, convex in y.

    Parameters
    ----------
    exponents
        a, shape (K, n), the terms of row 0 first, then of row 1, and so on.
    logs
        b, shape (K,).
    first
        Index of each row's first term, shape (R,).
    """

    exponents: Floats
    logs: Floats
    first: NDArray[np.intp]
    row: NDArray[np.intp] = field(init=False)

    def __post_init__(self) -> None:
        counts = np.diff(self.first, append=self.logs.size)
        object.__setattr__(self, "row", np.repeat(np.arange(self.first.size), counts))

    def values(self, y: Floats) -> Floats:
        """Return f(y) at a point (n,) or at many (n, points), rows first.

        The largest term is factored out, so nothing overflows.
        """
        logs = self.logs if y.ndim == 1 else self.logs[:, None]
        u = self.exponents @ y + logs
        top = np.maximum.reduceat(u, self.first)
        return np.asarray(top + np.log(np.add.reduceat(np.exp(u - top[self.row]), self.first)))

    def expand(self, y: Floats) -> Expansion:
        """Return values, gradients and curvatures at y."""
        first, row, a = self.first, self.row, self.exponents
        u = a @ y + self.logs
        top = np.maximum.reduceat(u, first)
        e = np.exp(u - top[row])
        total = np.add.reduceat(e, first)
        shares = e / total[row]
        jacobian = np.add.reduceat(shares[:, None] * a, first, axis=0)
        # covariance of the exponents about their mean: semidefinite by construction
        spread = a - jacobian[row]
        squares = (shares[:, None] * spread)[:, :, None] * spread[:, None, :]
        return Expansion(top + np.log(total), jacobian, np.add.reduceat(squares, first, axis=0))

    def rows(self, chosen: Iterable[int]) -> LogSumExp:
        """Return a pack of the chosen rows, in that order."""
        ends = np.append(self.first[1:], self.logs.size)
        pieces = [np.arange(self.first[r], ends[r]) for r in chosen]
        take = np.concatenate(pieces) if pieces else np.zeros(0, dtype=np.intp)
        counts = np.array([piece.size for piece in pieces], dtype=np.intp)
        first = np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.intp)[: counts.size]
        return LogSumExp(self.exponents[take], self.logs[take], first)

    def along(self, origin: Floats, basis: Floats) -> LogSumExp:
        """Return the rows as functions of z with y = origin + basis z."""
        return LogSumExp(self.exponents @ basis, self.logs + self.exponents @ origin, self.first)


def pack(posynomials: Sequence[Signomial], names: tuple[str, ...]) -> LogSumExp:
    """Return posynomials as packed rows over `names`."""
    sizes = [p.coefficients.size for p in posynomials]
    return LogSumExp(
        np.concatenate([p.aligned(names) for p in posynomials] or [np.zeros((0, len(names)))]),
        np.log(np.concatenate([p.coefficients for p in posynomials] or [np.zeros(0)])),
        np.cumsum([0, *sizes])[:-1].astype(np.intp),
    )
