"""Rows of a geometric program: ratios of posynomials that must not exceed, or must equal, one."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from flexcli.numerics.signomial import Signomial, as_signomial


@dataclass(frozen=True, eq=False)
class Ratio:
    """numerator / denominator ≤ 1, with both sides posynomials.

    Convex in the logarithms of the variables when the denominator is a monomial.
    """

    name: str
    numerator: Signomial
    denominator: Signomial

    def __post_init__(self) -> None:
        _require_posynomials(self.name, self.numerator, self.denominator)

    @property
    def is_convex(self) -> bool:
        """Whether ln(numerator/denominator) is convex in the logarithms."""
        return self.denominator.is_monomial


@dataclass(frozen=True, eq=False)
class Equality:
    """numerator / denominator = 1, with both sides posynomials; affine when both are monomials."""

    name: str
    numerator: Signomial
    denominator: Signomial

    def __post_init__(self) -> None:
        _require_posynomials(self.name, self.numerator, self.denominator)

    @property
    def is_convex(self) -> bool:
        """Whether the equality is affine in the logarithms."""
        return self.numerator.is_monomial and self.denominator.is_monomial


@dataclass(frozen=True)
class Settled:
    """A requirement whose signs decide it for all positive values of the variables."""

    name: str
    holds: bool


def at_most(name: str, demand: Signomial | float, capacity: Signomial | float) -> Ratio | Settled:
    """Return demand ≤ capacity as a row, with negative terms moved to the other side.

    Parameters
    ----------
    name
        The row's name in results.
    demand, capacity
        Signomials or numbers, of any sign.

    Returns
    -------
    A `Ratio`, or a `Settled` row when the signs alone decide.

    Notes
    -----
    Like terms stay on their sides, so that the ratio reads as utilisation, unless merging them
    makes the denominator a monomial and thereby the row convex.
    """
    left, right = as_signomial(demand), as_signomial(capacity)
    merged = left - right
    needed, offered = merged.positive_part(), merged.negative_part()
    if needed.is_zero:
        return Settled(name, holds=True)
    if offered.is_zero:
        return Settled(name, holds=False)
    above = left.positive_part() + right.negative_part()
    below = right.positive_part() + left.negative_part()
    if offered.is_monomial and not below.is_monomial:
        return Ratio(name, needed, offered)
    return Ratio(name, above, below)


def monomial_below(posynomial: Signomial, x: Mapping[str, float]) -> Signomial:
    r"""Return the best monomial that lies below a posynomial and touches it at x.

    .. math:: u(x) \ge \prod_k \left(\frac{u_k(x)}{w_k}\right)^{w_k}, \quad
              w_k = \frac{u_k(x_0)}{u(x_0)}

    by the inequality of arithmetic and geometric means. A ratio whose denominator is replaced
    by it is larger than the true one: what satisfies the replaced row satisfies the true row.

    Reference: M. Avriel, A. C. Williams (1970), Complementary geometric programming, SIAM J.
    Appl. Math. 19(1); S. Boyd, S.-J. Kim, L. Vandenberghe, A. Hassibi (2007), A tutorial on
    geometric programming, Optim. Eng. 8, §9.1, doi:10.1007/s11081-007-9001-7.
    """
    point = np.log([x[name] for name in posynomial.names])
    logs = np.log(posynomial.coefficients) + posynomial.exponents @ point
    shares = np.exp(logs - logs.max())
    shares /= shares.sum()
    exponents = shares @ posynomial.exponents
    log_value = logs.max() + np.log(np.exp(logs - logs.max()).sum())
    coefficient = np.exp(log_value - exponents @ point)
    return Signomial(posynomial.names, np.array([coefficient]), exponents[None, :])


def _require_posynomials(name: str, numerator: Signomial, denominator: Signomial) -> None:
    for side, signomial in (("numerator", numerator), ("denominator", denominator)):
        if not signomial.is_posynomial:
            raise ValueError(f"{name}: the {side} {signomial!r} is not a posynomial")
