"""Rows of a geometric program: ratios of posynomials that must not exceed, or must equal, one."""

from __future__ import annotations

from dataclasses import dataclass

from flexcli.numerics.signomial import Signomial, as_signomial


@dataclass(frozen=True, eq=False)
class Quotient:
    """numerator / denominator, both posynomials."""

    name: str
    numerator: Signomial
    denominator: Signomial

    def __post_init__(self) -> None:
        for side in ("numerator", "denominator"):
            signomial: Signomial = getattr(self, side)
            if not signomial.is_posynomial:
                raise ValueError(f"{self.name}: the {side} {signomial!r} is not a posynomial")


class Ratio(Quotient):
    """numerator / denominator ≤ 1.

    Convex in the logarithms of the variables when the denominator is a monomial.
    """

    @property
    def is_convex(self) -> bool:
        """Whether ln(numerator/denominator) is convex in the logarithms."""
        return self.denominator.is_monomial


class Equality(Quotient):
    """numerator / denominator = 1; affine when both are monomials."""

    @property
    def is_convex(self) -> bool:
        """Whether the equality is affine in the logarithms."""
        return self.numerator.is_monomial and self.denominator.is_monomial


@dataclass(frozen=True)
class Settled:
    """A requirement that holds, or fails, for all positive values of the variables."""

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
