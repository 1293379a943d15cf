"""A wide hinge between rigid bodies: the plate of its thickness profile, by Ritz's method.

The plate is clamped where the profile ends and free along its sides. Its deflection is the beam's
and a part that vanishes at the clamps: products of polynomials, along the hinge in a coordinate
that follows the throat.
"""

from functools import cache, lru_cache
from math import asinh
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from flexcli.formulas.profile import Piece, Profile
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["WideHinge", "wide_hinge"]

Floats = NDArray[np.float64]

ALONG, ACROSS = (10, 20, 28), 8
"""Functions along half of the hinge, as many as it takes, and across half of its width."""

NODES = 64
"""Gauss nodes on a piece of the profile."""

SETTLED = 2e-4
"""Change of the stiffness by more functions at which there are enough: of notches these few are,
long fillets at a narrow blade take more."""

LEFT = 1.0
"""Share of the last such change by which the stiffness is less at most: blades of fillets up to
r = 0.47 l had half of it beside solids."""

STIFF = 4.0
"""Lengths over which the throat bends, beyond which a notch is rigid: 1e4 times as stiff."""

WIDE = 10.0
"""Width, in the same lengths, from which on the free sides know nothing of each other."""

HALVINGS = 40
"""Of the interval in which a place is looked for."""


class WideHinge(NamedTuple):
    """Stiffness in pure bending over the beam's, and shift of the middle over the beam's [-].

    The stiffness is ``less`` less at most, for want of functions. ``peak`` is the largest stress
    across the width of the throat over its mean: the middle is kept flat, the sides curl.
    """

    stiffness: float
    shift: float
    less: float
    peak: float


@lru_cache(maxsize=512)
def wide_hinge(
    shape: type[Profile], numbers: tuple[float, ...], l: float, b: float, poisson_ratio: float
) -> WideHinge:
    """Return how a wide hinge differs from the beam of its profile.

    Parameters
    ----------
    shape, numbers
        Kind of the profile, symmetric about its middle, and its parameters.
    l, b : float
        Length and width of the hinge [m].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    WideHinge
        Of the same rotation; the mean of the stress over the width is as the stiffness.

    Notes
    -----
    Kirchhoff's plate: thin against the length over which the throat bends. The stiffness is an
    upper bound.

    References
    ----------
    Timoshenko & Woinowsky-Krieger (1959), Theory of Plates and Shells, section 26 (energy); the
    solution is derived here.

    """
    whole = _half(shape(*numbers), l, l / 2.0)
    bends = 2.0 * float(whole.dx @ (1.0 / whole.d))
    half = _half(shape(*numbers), l, min(l / 2.0, STIFF * bends), bends)
    used = min(b, WIDE * bends)
    plate = _settled(half, used / bends, poisson_ratio)
    if b <= used or poisson_ratio == 0.0:
        return plate
    # the curl at the sides is what a plate flat all over lacks: its share falls as 1/b
    square, share = poisson_ratio**2, used / b
    curled = (1.0 - (1.0 - 1.0 / plate.stiffness) / square) * share
    stiffness, shift = 1.0 / (1.0 - square * (1.0 - curled)), 1.0 + (plate.shift - 1.0) * share
    peak = 1.0 + (plate.peak - 1.0) * share
    return WideHinge(stiffness, shift, plate.less * share, peak)


def _settled(half: "_Half", b: float, nu: float) -> WideHinge:
    """Return the solution by as many functions as settle its stiffness."""
    found = _plate(half, b, nu, ALONG[0])
    for along in ALONG[1:]:
        before, found = found, _plate(half, b, nu, along)
        change = abs(before.stiffness - found.stiffness)
        if change <= SETTLED:
            break
    return found._replace(less=LEFT * change)


class _Half(NamedTuple):
    """Half of a hinge from its middle, lengths over that over which the throat bends.

    Nodes and their weights, stiffness over that of the throat, the beam's slope under the moment
    that bends its throat by 1; and where the clamp is.
    """

    x: Floats
    dx: Floats
    d: Floats
    slope: Floats
    end: float


def _plate(half: _Half, b: float, nu: float, count: int) -> WideHinge:
    """Return the solution of a quarter of the plate, by the beam and what it lacks."""
    x, dx, d, turned, end = half
    turned_all = float(dx @ (1.0 / d))
    along = _along(x, end, count)
    eta, weight = gauss_rule(2 * ACROSS + 4)
    across = [
        coefficients @ legendre.legvander(eta, coefficients.shape[1] - 1).T * (2.0 / b) ** order
        for order, coefficients in enumerate(_across())
    ]
    A = {(i, j): (along[i] * d * dx) @ along[j].T for i in range(3) for j in range(3)}
    B = {(i, j): (across[i] * weight) @ across[j].T for i in range(3) for j in range(3)}
    K = np.kron(A[2, 2], B[0, 0]) + np.kron(A[0, 0], B[2, 2])
    K += nu * (np.kron(A[2, 0], B[0, 2]) + np.kron(A[0, 2], B[2, 0]))
    K += 2.0 * (1.0 - nu) * np.kron(A[1, 1], B[1, 1])
    # the beam's moment is the same all along: d w_0'' = 1
    load = nu * np.kron(along[0] @ dx, across[2] @ weight)
    scale = 1.0 / np.sqrt(np.diag(K))
    c = -scale * np.linalg.solve(K * scale[:, None] * scale, scale * load)
    stiffness = (1.0 + float(load @ c) / turned_all) / (1.0 - nu**2)
    mean = c.reshape(count, ACROSS) @ (across[0] @ weight)
    squares = np.kron((along[1] * dx) @ along[1].T, B[0, 0])
    change = 2.0 * float((turned * dx) @ along[1].T @ mean) + float(c @ squares @ c)
    shift = 1.0 - change / float(dx @ (turned_all**2 - turned**2))
    # moments in the throat, where that of the beam is 1
    flat, _, bent = (part[:, 0] for part in _along(np.zeros(1), end, count))
    by = c.reshape(count, ACROSS)
    moments = 1.0 + bent @ by @ across[0] + nu * (flat @ by @ across[2])
    peak = float(np.max(moments) / (weight @ moments))
    return WideHinge(stiffness, shift, 0.0, peak)


def _along(x: Floats, end: float, count: int) -> list[Floats]:
    """Return functions that vanish with their slope at the clamp, and two derivatives.

    They are (1 − t²)² times even Legendre polynomials, x ~ sinh t.
    """
    reach = asinh(end)
    t = np.arcsinh(x) / reach
    first = 1.0 / (reach * np.hypot(x, 1.0))
    second = -x / (reach * np.hypot(x, 1.0) ** 3)
    value, slope, bend = (
        coefficients @ legendre.legvander(t, coefficients.shape[1] - 1).T
        for coefficients in _vanishing(count)
    )
    return [value, slope * first, bend * first**2 + slope * second]


@cache
def _across() -> list[Floats]:
    """Return even Legendre polynomials and two derivatives, as coefficients of such."""
    return _derivatives(np.eye(2 * ACROSS - 1)[::2])


@cache
def _vanishing(count: int) -> list[Floats]:
    """Return (1 − t²)² times even Legendre polynomials and two derivatives."""
    factor = np.array([8.0 / 15.0, 0.0, -16.0 / 21.0, 0.0, 8.0 / 35.0])
    size = 2 * count + 3
    rows = [legendre.legmul(factor, row) for row in np.eye(2 * count - 1)[::2]]
    return _derivatives(np.stack([np.pad(row, (0, size - len(row))) for row in rows]))


def _derivatives(rows: Floats) -> list[Floats]:
    return [np.stack([legendre.legder(row, order) for row in rows]) for order in range(3)]


def _half(profile: Profile, l: float, reach: float, unit: float = 1.0) -> _Half:
    """Return the half of a hinge up to a clamp at a reach from its middle [m]."""
    u, weight = gauss_rule(NODES)
    whole = _integrals(NODES)
    found, start, e = [], 0.0, 0.0
    for piece in profile.pieces(l):
        low, high = (_where(piece, l / 2.0 + x) for x in (0.0, reach))
        if low == high:
            continue
        at = low + (high - low) * u
        e = e or float(piece.thickness(np.array([low]))[0])
        d = (piece.thickness(at) / e) ** 3
        growth = piece.slope(at) * (high - low) / unit
        slope = start + whole @ (growth / d)
        start += float(weight @ (growth / d))
        found.append(((piece.position(at) - l / 2.0) / unit, growth * weight, d, slope))
    x, dx, d, slope = (np.concatenate(part) for part in zip(*found, strict=True))
    return _Half(x, dx, d, slope, reach / unit)


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
