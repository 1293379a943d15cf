"""Geometric programs in logarithms, packed: rows of which each is a ratio of posynomials."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.log_sum_exp import Expansion, LogSumExp, pack
from flexcli.numerics.ratios import Equality, Quotient, Ratio
from flexcli.numerics.signomial import Floats

__all__ = ["SignomialProgram", "signomial_program"]

END = 100.0
"""Logarithm beyond which a variable without bounds counts as unbounded."""


@dataclass(frozen=True, eq=False)
class SignomialProgram:
    """Minimise row 0 over y = ln x, with the rows that follow ≤ 0 and the last ones = 0.

    Row r is ln numerator − ln denominator. Monomial denominators are folded into `above`;
    `below` holds the others, and `split` the rows they belong to. A local run that gets to the
    ends `low` and `high` is unbounded.
    """

    names: tuple[str, ...]
    above: LogSumExp
    below: LogSumExp
    split: NDArray[np.intp]
    inequalities: int
    low: Floats
    high: Floats

    @property
    def is_convex(self) -> bool:
        """Whether every row is convex, and the equalities are affine."""
        counts = np.diff(self.above.first, append=self.above.logs.size)
        return not self.split.size and bool((counts[1 + self.inequalities :] == 1).all())

    def rows(self, y: Floats) -> Floats:
        """Return every row at a point (n,) or at many (n, points)."""
        values = self.above.values(y)
        if self.split.size:
            values[self.split] -= self.below.values(y)
        return values

    def expand(self, y: Floats) -> Expansion:
        """Return values, gradients and curvatures of every row at one point."""
        above = self.above.expand(y)
        if self.split.size:
            for whole, part in zip(above, self.below.expand(y), strict=True):
                whole[self.split] -= part
        return above

    def model(self, _at: Expansion, y: Floats) -> LogSumExp:
        r"""Return convex rows over the step from a point, without the equalities.

        Each denominator is replaced by the best monomial that lies below it and touches it there,

        .. math:: u(x) \ge \prod_k \left(\frac{u_k(x)}{w_k}\right)^{w_k}, \quad
                  w_k = \frac{u_k(x_0)}{u(x_0)}

        by the inequality of arithmetic and geometric means: in logarithms its tangent. What
        satisfies the rows of the model satisfies the true rows.

        Reference: M. Avriel, A. C. Williams (1970), Complementary geometric programming, SIAM J.
        Appl. Math. 19(1); S. Boyd, S.-J. Kim, L. Vandenberghe, A. Hassibi (2007), A tutorial on
        geometric programming, Optim. Eng. 8, §9.1, doi:10.1007/s11081-007-9001-7.
        """
        above = self.above.along(y, np.eye(y.size))
        if self.split.size:
            below = self.below.expand(y)
            slope, offset = np.zeros((above.first.size, y.size)), np.zeros(above.first.size)
            slope[self.split], offset[self.split] = below.jacobian, below.values
            above = LogSumExp(
                above.exponents - slope[above.row], above.logs - offset[above.row], above.first
            )
        return above.rows(range(1 + self.inequalities))

    def chosen(self, kept: Sequence[int]) -> SignomialProgram:
        """Return the program with some of its inequalities, and without equalities."""
        picked = [0, *(1 + i for i in kept)]
        split = [r for r in picked if r in self.split]
        return replace(
            self,
            above=self.above.rows(picked),
            below=self.below.rows([int(np.searchsorted(self.split, r)) for r in split]),
            split=np.array([picked.index(r) for r in split], dtype=np.intp),
            inequalities=len(kept),
        )

    def along(self, origin: Floats, basis: Floats) -> SignomialProgram:
        """Return the program on the plane y = origin + basis z of orthonormal directions."""
        reach = np.full(basis.shape[1], float((self.high - self.low).max()))
        return replace(
            self,
            names=tuple(f"direction {k}" for k in range(basis.shape[1])),
            above=self.above.along(origin, basis),
            below=self.below.along(origin, basis),
            low=-reach,
            high=reach,
        )


def signomial_program(
    objective: Ratio,
    constraints: Sequence[Ratio],
    equalities: Sequence[Equality],
    names: tuple[str, ...],
    ends: tuple[Floats, Floats] | None = None,
) -> SignomialProgram:
    """Pack a geometric program; ``ends`` are those of each variable's logarithm."""
    rows: list[Quotient] = [objective, *constraints, *equalities]
    above, below, split = [], [], []
    for r, entry in enumerate(rows):
        if entry.denominator.is_monomial:
            above.append(entry.numerator / entry.denominator)
        else:
            above.append(entry.numerator)
            below.append(entry.denominator)
            split.append(r)
    low, high = ends or (np.full(len(names), -END), np.full(len(names), END))
    return SignomialProgram(
        names, pack(above, names), pack(below, names), np.array(split, dtype=np.intp),
        len(constraints), low, high,
    )  # fmt: skip
