"""The plate of a hinge's thickness profile, clamped at both ends: its functions and its energy.

Products of polynomials, along the hinge in a coordinate that follows the throat, which vanish with
their slope at the clamps. Lengths are over that over which the throat bends, stiffness over that of
the throat; whatever is of the width is a mean over it.
"""

from functools import cache
from math import asinh
from typing import Any, NamedTuple, TypeAlias

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from flexcli.formulas.profile import Piece, Profile
from flexcli.numerics.quadrature import gauss_rule

__all__ = [
    "ACROSS",
    "Half",
    "Products",
    "across_width",
    "along_hinge",
    "crossed",
    "from_middle",
    "half_of",
    "plate_energy",
    "products",
]

Floats = NDArray[np.float64]

Products: TypeAlias = dict[tuple[int, int], Floats]
"""Integrals of products of functions by the orders of their derivatives (functions, functions)."""

ACROSS = 8
"""Functions across half of the width."""

NODES = 64
"""Gauss nodes on a piece of the profile."""

HALVINGS = 40
"""Of the interval in which a place is looked for."""


class Half(NamedTuple):
    """Half of a hinge from its middle, lengths over that over which the throat bends.

    Nodes and their weights, stiffness over that of the throat, the beam's slope under the moment
    that bends its throat by 1; and where the clamp is.
    """

    x: Floats
    dx: Floats
    d: Floats
    slope: Floats
    end: float


def half_of(profile: Profile, l: float, reach: float, unit: float = 1.0) -> Half:
    """Return the half of a hinge up to a clamp at a reach from its middle [m]."""
    u, weight = gauss_rule(NODES)
    found, start, e = [], 0.0, 0.0
    for piece in profile.pieces(l):
        low, high = (_where(piece, l / 2.0 + x) for x in (0.0, reach))
        if low == high:
            continue
        at = low + (high - low) * u
        e = e or float(piece.thickness(np.array([low]))[0])
        d = (piece.thickness(at) / e) ** 3
        growth = piece.slope(at) * (high - low) / unit
        slope = start + _integrals(NODES) @ (growth / d)
        start += float(weight @ (growth / d))
        found.append(((piece.position(at) - l / 2.0) / unit, growth * weight, d, slope))
    x, dx, d, slope = (np.concatenate(part) for part in zip(*found, strict=True))
    return Half(x, dx, d, slope, reach / unit)


def from_middle(half: Half, rates: Floats) -> tuple[Floats, Floats]:
    """Return the integrals of rates (functions, nodes) from the middle to each node and to the end.

    Examples
    --------
    >>> from flexcli.formulas.profile import Constant
    >>> half = half_of(Constant(1.0), 2.0, 1.0)
    >>> at, whole = from_middle(half, 1.0 / half.d[None])
    >>> bool(np.allclose(at[0], half.x)), round(float(whole[0]), 12)
    (True, 1.0)

    """
    _, weight = gauss_rule(NODES)
    grown = (rates * half.dx).reshape(len(rates), -1, NODES)
    pieces = grown.sum(axis=-1)
    before = np.cumsum(pieces, axis=-1) - pieces
    inside = (grown / weight) @ _integrals(NODES).T
    return (before[..., None] + inside).reshape(rates.shape), pieces.sum(axis=-1)


def along_hinge(half: Half, count: int, *, odd: bool = False) -> list[Floats]:
    """Return functions that vanish with their slope at the clamp, and two derivatives.

    They are (1 − t²)² times even or odd Legendre polynomials, x ~ sinh t.
    """
    reach, x = asinh(half.end), half.x
    t = np.arcsinh(x) / reach
    first = 1.0 / (reach * np.hypot(x, 1.0))
    second = -x / (reach * np.hypot(x, 1.0) ** 3)
    value, slope, bend = (
        coefficients @ legendre.legvander(t, coefficients.shape[1] - 1).T
        for coefficients in _vanishing(count, odd)
    )
    return [value, slope * first, bend * first**2 + slope * second]


def across_width(b: float, first: int = 0) -> tuple[list[Floats], Floats]:
    """Return even Legendre polynomials from a first on and two derivatives, and nodes' weights."""
    eta, weight = gauss_rule(2 * ACROSS + 4)
    return [
        coefficients[first:]
        @ legendre.legvander(eta, coefficients.shape[1] - 1).T
        * (2.0 / b) ** order
        for order, coefficients in enumerate(_across())
    ], weight


def products(functions: list[Floats], weight: Floats) -> Products:
    """Return the integrals of functions and their derivatives times each other."""
    return {(i, j): (functions[i] * weight) @ functions[j].T for i in range(3) for j in range(3)}


def plate_energy(along: Products, across: Products, nu: float) -> Floats:
    """Return twice the energy of products of functions, over half of the hinge."""
    K = crossed(along[2, 2], across[0, 0]) + crossed(along[0, 0], across[2, 2])
    K += nu * (crossed(along[2, 0], across[0, 2]) + crossed(along[0, 2], across[2, 0]))
    K += 2.0 * (1.0 - nu) * crossed(along[1, 1], across[1, 1])
    return K


def crossed(along: Any, across: Any) -> Floats:
    """Return what products of functions have of what they have along and across."""
    return np.asarray(np.kron(along, across))


@cache
def _across() -> list[Floats]:
    """Return even Legendre polynomials and two derivatives, as coefficients of such."""
    return _derivatives(np.eye(2 * ACROSS - 1)[::2])


@cache
def _vanishing(count: int, odd: bool) -> list[Floats]:
    """Return (1 − t²)² times even or odd Legendre polynomials and two derivatives."""
    factor = np.array([8.0 / 15.0, 0.0, -16.0 / 21.0, 0.0, 8.0 / 35.0])
    size = 2 * count + 3 + odd
    rows = [legendre.legmul(factor, row) for row in np.eye(2 * count - 1 + odd)[odd::2]]
    return _derivatives(np.stack([np.pad(row, (0, size - len(row))) for row in rows]))


def _derivatives(rows: Floats) -> list[Floats]:
    return [np.stack([legendre.legder(row, order) for row in rows]) for order in range(3)]


@cache
def _integrals(count: int) -> Floats:
    """Return the matrix that takes values at Gauss nodes on [0, 1] to integrals from 0 to each."""
    u, weight = gauss_rule(count)
    t = 2.0 * u - 1.0
    degrees = np.arange(count)
    fitted = (2.0 * degrees + 1.0)[:, None] * legendre.legvander(t, count - 1).T * weight
    primitive = [legendre.legval(t, legendre.legint(row, lbnd=-1.0)) for row in np.eye(count)]
    return np.asarray(np.stack(primitive, axis=1) @ fitted / 2.0)


def _where(piece: Piece, place: float) -> float:
    """Return the u in [−1, 1] at which a piece is at a place, or the end that is nearest."""
    low, high = -1.0, 1.0

    def position(u: float) -> float:
        return float(piece.position(np.array([u]))[0])

    if place >= position(high):
        return high
    if place <= position(low):
        return low
    for _ in range(HALVINGS):
        middle = (low + high) / 2.0
        low, high = (middle, high) if position(middle) < place else (low, middle)
    return high
