"""Posynomials in logarithms, packed: every row's value, gradient and curvature at once."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.ratios import Equality, Ratio
from flexcli.numerics.signomial import Floats, Signomial


@dataclass(frozen=True, eq=False)
class Expansion:
    """Values (R,), Jacobian (R, n) and, for given row weights, the summed Hessian (n, n)."""

    values: Floats
    jacobian: Floats
    curvature: Callable[[Floats], Floats]


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
        """Return f(y), shape (R,); the largest term is factored out, so nothing overflows."""
        u = self.exponents @ y + self.logs
        top = np.maximum.reduceat(u, self.first)
        return np.asarray(top + np.log(np.add.reduceat(np.exp(u - top[self.row]), self.first)))

    def expand(self, y: Floats) -> Expansion:
        """Return values, gradients and curvature at y."""
        first, row, a = self.first, self.row, self.exponents
        u = a @ y + self.logs
        top = np.maximum.reduceat(u, first)
        e = np.exp(u - top[row])
        total = np.add.reduceat(e, first)
        shares = e / total[row]
        jacobian = np.add.reduceat(shares[:, None] * a, first, axis=0)

        def curvature(weights: Floats) -> Floats:
            # Covariance of the exponents about their mean: semidefinite by construction.
            spread = a - jacobian[row]
            return np.asarray(spread.T @ (spread * (shares * weights[row])[:, None]))

        return Expansion(top + np.log(total), jacobian, curvature)

    def rows(self, chosen: Iterable[int]) -> LogSumExp:
        """Return a pack of the chosen rows, in that order."""
        ends = np.append(self.first[1:], self.logs.size)
        pieces = [np.arange(self.first[r], ends[r]) for r in chosen]
        take = np.concatenate(pieces) if pieces else np.zeros(0, dtype=np.intp)
        counts = np.array([piece.size for piece in pieces], dtype=np.intp)
        first = np.concatenate([[0], np.cumsum(counts)[:-1]]).astype(np.intp)[: counts.size]
        return LogSumExp(self.exponents[take], self.logs[take], first)

    def joined(self, lines: Floats, logs: Floats) -> LogSumExp:
        """Return the rows followed by affine rows `lines` y + `logs`."""
        terms = self.logs.size
        return LogSumExp(
            np.vstack([self.exponents, lines]),
            np.concatenate([self.logs, logs]),
            np.concatenate([self.first, terms + np.arange(logs.size)]),
        )

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


@dataclass(frozen=True, eq=False)
class Program:
    """A geometric program in logarithms: row 0 the objective, then inequalities, equalities.

    Row r is ln numerator − ln denominator. Monomial denominators are folded into `above`;
    `below` holds the others, and `split` the rows they belong to. `is_convex` tells that there
    are none and the equalities are affine; `bends` that some equality is not.
    """

    names: tuple[str, ...]
    above: LogSumExp
    below: LogSumExp
    split: NDArray[np.intp]
    inequalities: int
    equalities: int
    is_convex: bool
    bends: bool

    def values(self, y: Floats) -> Floats:
        """Return ln(numerator/denominator) of every row."""
        values = self.above.values(y)
        if self.split.size:
            values[self.split] -= self.below.values(y)
        return values

    def expand(self, y: Floats) -> Expansion:
        """Return values, gradients and curvature of every row."""
        above = self.above.expand(y)
        if not self.split.size:
            return above
        below = self.below.expand(y)
        values, jacobian = above.values.copy(), above.jacobian.copy()
        values[self.split] -= below.values
        jacobian[self.split] -= below.jacobian
        return Expansion(
            values,
            jacobian,
            lambda weights: above.curvature(weights) - below.curvature(weights[self.split]),
        )

    def condensed(self, y: Floats) -> tuple[LogSumExp, Floats, Floats]:
        """Return the convex program that touches this one at y: rows, G, d with G y = d.

        Each denominator is replaced by its tangent monomial, an inner approximation (see
        `ratios.monomial_below`); equalities by their tangents, which is Newton's step for them.
        """
        above = self.above
        keep = 1 + self.inequalities
        if self.split.size:
            below = self.below.expand(y)
            slope = np.zeros((above.first.size, y.size))
            offset = np.zeros(above.first.size)
            slope[self.split] = below.jacobian
            offset[self.split] = below.values - below.jacobian @ y
            above = LogSumExp(
                above.exponents - slope[above.row], above.logs - offset[above.row], above.first
            )
        if not self.equalities:
            return above, np.zeros((0, y.size)), np.zeros(0)
        tangent = self.expand(y)
        G = tangent.jacobian[keep:]
        return above.rows(range(keep)), G, G @ y - tangent.values[keep:]


def program(
    objective: Ratio,
    constraints: Sequence[Ratio],
    equalities: Sequence[Equality],
    names: tuple[str, ...],
) -> Program:
    """Pack a geometric program."""
    rows: list[Ratio | Equality] = [objective, *constraints, *equalities]
    above, below, split = [], [], []
    for r, entry in enumerate(rows):
        if entry.denominator.is_monomial:
            above.append(entry.numerator / entry.denominator)
        else:
            above.append(entry.numerator)
            below.append(entry.denominator)
            split.append(r)
    return Program(
        names,
        pack(above, names),
        pack(below, names),
        np.array(split, dtype=np.intp),
        len(constraints),
        len(equalities),
        all(entry.is_convex for entry in rows),
        not all(entry.is_convex for entry in equalities),
    )
