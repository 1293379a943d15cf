"""The axial force that buckles a wide hinge between rigid bodies over that of its beam, by Ritz.

The plate of its thickness profile is clamped in bodies that keep straight, and free along its
sides. The force acts on a body, at the middle of the hinge; what holds the body is as of a column.
"""

from functools import lru_cache
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre
from numpy.typing import NDArray

from flexcli.formulas.profile import Profile
from flexcli.mechanics.hinge_plate import (
    Half,
    across_width,
    along_hinge,
    crossed,
    from_middle,
    half_of,
    plate_energy,
    products,
)
from flexcli.mechanics.wide_hinge import ALONG, LEFT, SETTLED, STIFF, WIDE

__all__ = ["BuckledHinge", "buckled_hinge"]

Floats = NDArray[np.float64]

MOMENTS = 12
"""Polynomials for the moment along half of the hinge, whose mean deflection is a beam's."""


class BuckledHinge(NamedTuple):
    """Critical force of a plate over that of the beam, and what it is off at most [-]."""

    factor: float
    error: float


class _Bent(NamedTuple):
    """A hinge bent evenly or oddly: its energy, what an axial force works on, and its ends.

    ``turn`` is the rotation of one end from the other, ``across`` how far the middle, on the body,
    moves from the base. The first ``MOMENTS`` unknowns are the beam's.
    """

    K: Floats
    G: Floats
    turn: Floats
    across: Floats


@lru_cache(maxsize=512)
def buckled_hinge(
    shape: type[Profile],
    numbers: tuple[float, ...],
    l: float,
    b: float,
    poisson_ratio: float,
    ends: str,
) -> BuckledHinge:
    """Return by how much more force a wide hinge buckles than the beam of its profile.

    ``P = min w'Kw / w'Gw``: the plate's energy over the work of an even axial force.

    Parameters
    ----------
    shape, numbers
        Kind of the profile, symmetric about its middle, and its parameters.
    l, b : float
        Length and width of the hinge [m].
    poisson_ratio : float
        ν [-].
    ends : str
        A key of :data:`~flexcli.formulas.buckling.EFFECTIVE_LENGTH`: what holds the hinge and the
        body, which turns about the middle of the hinge.

    Returns
    -------
    BuckledHinge
        Its factor.

    Notes
    -----
    Kirchhoff's plate, thin against the length over which the throat bends. Beyond ten such lengths
    of width the factor rises by no more than the curl at its sides gets less.

    Examples
    --------
    >>> from flexcli.formulas.profile import Notch
    >>> found = buckled_hinge(Notch, (0.1, 1.0), 2.0, 0.37, 0.3, "clamped-guided")
    >>> round(found.factor, 3)
    1.043

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 8.2 (energy of buckled plates);
    the solution is derived here.

    """
    profile = shape(*numbers)
    whole = half_of(profile, l, l / 2.0)
    bends = 2.0 * float(whole.dx @ (1.0 / whole.d))
    full = half_of(profile, l, l / 2.0, bends)
    near = half_of(profile, l, min(l / 2.0, STIFF * bends), bends)
    used = min(b, WIDE * bends)
    factor, error = _settled(full, near, used / bends, poisson_ratio, ends)
    if b > used and poisson_ratio:
        square = poisson_ratio**2
        curled = (1.0 - (1.0 - 1.0 / factor) / square) * used / b
        error += abs(1.0 / (1.0 - square * (1.0 - curled)) - factor)
    return BuckledHinge(factor, error)


def _settled(full: Half, near: Half, b: float, nu: float, ends: str) -> tuple[float, float]:
    """Return the factor by as many functions as settle it, and its error."""
    found = _factor(full, near, b, nu, ALONG[0], ends)
    for count in ALONG[1:]:
        before, found = found, _factor(full, near, b, nu, count, ends)
        change = abs(before - found)
        if change <= SETTLED:
            break
    return found, LEFT * change


def _factor(full: Half, near: Half, b: float, nu: float, count: int, ends: str) -> float:
    """Return the plate's critical force over the beam's."""
    even, odd = (_bent(full, near, b, nu, count, odd=odd) for odd in (False, True))
    narrow = 1.0 - nu**2
    beam = _critical(_beam(even, narrow), _beam(odd, narrow), full.end, ends)
    return _critical(even, odd, full.end, ends) / beam


def _bent(full: Half, near: Half, b: float, nu: float, count: int, *, odd: bool) -> _Bent:
    """Return a hinge whose curvature is even or odd about its middle.

    Its mean deflection is that of a beam with polynomials for its moment; what it curls besides is
    of functions that vanish at its clamps and have no mean across.
    """
    reach = float(np.arcsinh(full.end))

    def moments(x: Floats) -> Floats:
        values = legendre.legvander(np.arcsinh(x) / reach, 2 * MOMENTS - 1)
        return np.asarray(values[:, int(odd) :: 2].T)

    curved = moments(full.x) / full.d
    slope, end = from_middle(full, curved)
    if odd:  # both ends keep the same slope, which is the body's own
        slope = slope - end[:, None]
    along, (across, weight) = along_hinge(near, count, odd=odd), across_width(b, 1)
    B = products(across, weight)
    bubbles = plate_energy(products(along, near.d * near.dx), B, nu)
    mixed = nu * crossed((moments(near.x) * near.dx) @ along[0].T, across[2] @ weight)
    size = MOMENTS + len(bubbles)
    K, G = np.zeros((size, size)), np.zeros((size, size))
    K[:MOMENTS, :MOMENTS] = (curved * full.d * full.dx) @ curved.T
    K[:MOMENTS, MOMENTS:], K[MOMENTS:, :MOMENTS], K[MOMENTS:, MOMENTS:] = mixed, mixed.T, bubbles
    G[:MOMENTS, :MOMENTS] = (slope * full.dx) @ slope.T
    G[MOMENTS:, MOMENTS:] = crossed((along[1] * near.dx) @ along[1].T, B[0, 0])
    turn, moved = np.zeros(size), np.zeros(size)
    if odd:
        moved[:MOMENTS] = 2.0 * slope @ full.dx
    else:
        turn[:MOMENTS] = 2.0 * end
    return _Bent(2.0 * K, 2.0 * G, turn, moved)


def _beam(bent: _Bent, narrow: float) -> _Bent:
    """Return the beam alone, which keeps no width from curling."""
    only = slice(None, MOMENTS)
    K, G = narrow * bent.K[only, only], bent.G[only, only]
    return _Bent(K, G, bent.turn[only], bent.across[only])


def _critical(even: _Bent, odd: _Bent, end: float, ends: str) -> float:
    """Return the least critical force of a hinge of half length ``end`` by its ends.

    The slope is half the turn, and an odd and an even part; as the body turns, the middle, on which
    the force acts, goes back by half the length times half the square of the turn.
    """
    if ends == "pinned-pinned":  # both bodies turn, neither moves across
        tilted = np.outer(odd.across, odd.across) / (2.0 * end)
        return min(_least(even.K, even.G, []), _least(odd.K, odd.G - tilted, []))
    G = even.G - np.outer(even.turn, even.turn) * end / 2.0
    if ends == "clamped-free":
        n, size = len(even.K), len(even.K) + len(odd.K)
        both = np.zeros((2, size, size))
        both[:, :n, :n], both[:, n:, n:] = (even.K, G), (odd.K, odd.G)
        both[1, :n, n:] = np.outer(even.turn, odd.across) / 2.0
        both[1, n:, :n] = both[1, :n, n:].T
        return _least(both[0], both[1], [])
    turns = ends == "clamped-pinned"
    moves = ends == "clamped-guided"
    return min(
        _least(even.K, G, [] if turns else [even.turn]),
        _least(odd.K, odd.G, [] if moves else [odd.across]),
    )


def _least(K: Floats, G: Floats, held: list[Floats]) -> float:
    """Return the least P > 0 of K w = P G w where ``held`` parts of w are zero."""
    scale = 1.0 / np.sqrt(np.diag(K))
    K, G = K * scale[:, None] * scale, G * scale[:, None] * scale
    for each in held:
        whole, _ = np.linalg.qr(np.column_stack([each * scale, np.eye(len(K))]))
        free = whole[:, 1 : len(K)]
        K, G = free.T @ K @ free, free.T @ G @ free
    inverse = np.linalg.inv(np.linalg.cholesky(K))
    most = float(np.linalg.eigvalsh(inverse @ G @ inverse.T)[-1])
    return 1.0 / most if most > 0.0 else inf
