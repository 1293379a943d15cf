"""Bending of a strip of a crystal or sheet between rigid clamps, at any angle to its axes.

Kirchhoff's plate with all six bending stiffnesses, solved by Ritz's method: two ends clamped, two
sides free. Where D_16 or D_26 is none of zero it twists as it bends, which its clamps keep it from.
"""

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas import plate_factors as plates
from flexcli.formulas.anisotropy import StripConstants

__all__ = ["ShapeRanges", "StripBending", "beside_isotropic", "is_compared", "strip_bending"]

Floats = NDArray[np.float64]

LAYER, PIECES = 0.4, (4.0, 1.0, 0.3, 0.06)
"""Share of the smaller of width and length within which a clamp's own strains are resolved, and
where its pieces end."""

OF_CHANGE, OF_THICK = 0.15, 0.2
"""Errors of what a blade is stiffer than an isotropic one: a share of that, beside h/b of it; and
of what this one stiffens, times h/b [-]."""

ROUNDING = 1e-9
"""Compliance over that along a strip below which it is none [-]."""

ORDERS = ((6, 9), (7, 13))
"""Degrees along a piece of the length and across the width, of two solutions."""

TWISTS, SKEWS, SHEARS, LARGEST_NU = 0.05, 0.1, 6.0, 0.48
"""Strips that were compared with solids: S_15²/(S_11 S_55), S_16²/(S_11 S_66), E/G_12 and ν, up to
these [-]."""


class StripBending(NamedTuple):
    """Stiffness of a clamped strip over that of the beam which may twist, E_1 I/l and 12 E_1 I/l³.

    ``arc`` is that of an arc whose ends are kept from twisting, ``loose`` of one whose ends may
    twist as they turn, ``guided`` of an S [-].
    """

    arc: float
    loose: float
    guided: float


def strip_bending(compliance: ArrayLike, *, b: float, l: float) -> tuple[StripBending, float]:
    """Return how stiff a thin strip of any plane anisotropy is between rigid clamps.

    The least energy of ``½ ∫ κᵀ D κ dx dz``, κ = (w_xx, w_zz, 2 w_xz), by C¹ polynomials along it
    and Legendre's across it.

    Parameters
    ----------
    compliance : array_like, shape (3, 3)
        In plane stress: along the strip, across its width, shear of both [1/Pa].
    b, l : float
        Width and length [m].

    Returns
    -------
    bending : StripBending
        An upper bound of each, but for the rounding.
    error : float
        The largest relative difference of two orders [-].

    Notes
    -----
    Turned by half about its normal a strip is itself: an arc goes with a twist of its ends, an S
    with none, so a guided one asks nothing of what keeps its ends from twisting.

    Examples
    --------
    >>> E, nu = 1.0, 0.3
    >>> S = [[1.0, -nu, 0.0], [-nu, 1.0, 0.0], [0.0, 0.0, 2.0 * (1.0 + nu)]]
    >>> found, error = strip_bending(S, b=0.5, l=1.0)
    >>> round(found.arc, 3), round(found.guided, 3), error < 2e-4
    (1.038, 1.068, True)

    References
    ----------
    Lekhnitskii (1968), Anisotropic Plates, for the energy; the solution is our own.

    """
    S = np.asarray(compliance, dtype=np.float64)
    scaled = S / S[0, 0]
    scaled[np.abs(scaled) < ROUNDING] = 0.0
    rough, fine = (_solved(tuple(scaled.ravel().tolist()), b / l, order) for order in ORDERS)
    return fine, max(abs(one / two - 1.0) for one, two in zip(rough, fine, strict=True))


def is_compared(strip: StripConstants) -> bool:
    """Return whether blades of such constants were compared with solids."""
    return (
        strip.twists <= TWISTS
        and strip.skews <= SKEWS
        and SHEARS * strip.G_thin >= strip.E
        and 0.0 <= strip.nu <= LARGEST_NU
    )


class ShapeRanges(NamedTuple):
    """Between what relative changes the stiffness of an arc and of an S is, lowest first [-]."""

    arc: tuple[float, float]
    guided: tuple[float, float]


def beside_isotropic(
    compliance: ArrayLike, *, h: float, b: float, l: float, poisson_ratio: float
) -> ShapeRanges:
    """Return what a blade of any plane anisotropy is stiffer than an isotropic plate of its E_1 I.

    The factors of ``strip_bending`` over those of ``plate_factors``, both of the blade's width and
    of that of a thin plate that curls as much; ``0.15 + h/b`` of the largest change to either side,
    and ``0.2 h/b`` of what the isotropic one stiffens.

    Parameters
    ----------
    compliance : array_like, shape (3, 3)
        In plane stress: along the strip, across its width, shear of both [1/Pa].
    h, b, l : float
        Thickness, width and length [m].
    poisson_ratio : float
        ν of the isotropic plate [-].

    Returns
    -------
    ShapeRanges
        An arc's is from ends that may twist to ends that may not. How thick blades shear, and what
        clamps keep from thinning, is not in it: see ``anisotropy.sheared_in_plane``.

    Notes
    -----
    Of single blades between rigid bodies by bricks: 76 that it was chosen by, and 26 drawn after
    that, h from l/134 to l/17, b/h from 1 to 47 and b ≤ 2 l, which had 0.82 of it at most, with
    1.3 times ``sheared_in_plane`` and what ``thick_plates`` is off.

    Examples
    --------
    >>> nu = 0.3
    >>> S = [[1.0, -nu, 0.0], [-nu, 1.0, 0.0], [0.0, 0.0, 2.0 * (1.0 + nu)]]
    >>> found = beside_isotropic(S, h=0.005, b=0.2, l=1.0, poisson_ratio=nu)
    >>> all(abs(end) < 1e-3 for ends in found for end in ends)
    True

    References
    ----------
    Ritz's method for the plate; the rest is measured, CalculiX's bricks of the second order.

    """
    size = {"l": l, "poisson_ratio": poisson_ratio}
    arcs, guided = list[float](), list[float]()
    widened = unsure = 0.0
    for width in (b, float(plates.effective_width(b=b, h=h))):
        own, error = strip_bending(compliance, b=width, l=l)
        arc = float(plates.pure_bending_factor(b=width, **size))
        s_shape = float(plates.guided_factor(b=width, **size))
        arcs += [own.loose / arc - 1.0, own.arc / arc - 1.0]
        guided.append(own.guided / s_shape - 1.0)
        widened, unsure = max(widened, s_shape - 1.0), max(unsure, error)
    off = unsure + OF_THICK * h / b * widened

    def between(changes: list[float]) -> tuple[float, float]:
        more = off + (OF_CHANGE + h / b) * max(map(abs, changes))
        return min(changes) - more, max(changes) + more

    return ShapeRanges(between(arcs), between(guided))


@lru_cache(maxsize=256)
def _solved(compliance: tuple[float, ...], b: float, order: tuple[int, int]) -> StripBending:
    """Return the factors of a strip of length 1 and width b, E_1 being 1."""
    Q = np.linalg.inv(np.array(compliance).reshape(3, 3))
    degree, powers = order
    layer = LAYER * min(b, 1.0)
    ends = 0.5 - layer * np.array(PIECES)
    nodes = np.unique([0.0, 0.5, *ends[ends > 0.0]])
    even, odd = (_along(nodes, degree, odd=is_odd) for is_odd in (False, True))
    flat, askew = (_across(powers, b, first=first) for first in (0, 1))
    # the first of each is what its clamps do: an arc or an S goes with P_0, a twist with P_1
    bent = _stiffness(Q, [(even, flat, 1), (odd, askew, 1)])
    arc, twist = 0, _size(even, flat, 1)
    guided = _stiffness(Q, [(odd, flat, 1), (even, askew, 0)])
    return StripBending(
        arc=_left(bent, arc, without=twist) / b,
        loose=_left(bent, arc) / b,
        guided=_left(guided, 0) / (12.0 * b),
    )


class _Curvature(NamedTuple):
    """Orders of the derivatives along and across, and how often they count."""

    along: int
    across: int
    scale: float


CURVED = (_Curvature(2, 0, 1.0), _Curvature(0, 2, 1.0), _Curvature(1, 1, 2.0))
"""w_xx, w_zz and 2 w_xz."""


class _Line(NamedTuple):
    """Functions of one coordinate: weights (p,), values and derivatives (3, n, p)."""

    weights: Floats
    values: Floats


def _along(nodes: Floats, degree: int, *, odd: bool) -> _Line:
    """Return even or odd functions of x from 0 to ½ with value and slope zero at ½.

    The first one is the motion of the clamps instead: x²/2, or (3 x − 4 x³)/2. Integrals are those
    of the whole length.
    """
    points, weights, cubics, bubbles = _pieces(degree)
    pieces = nodes.size - 1
    last = 1 + 2 * nodes.size
    values = np.zeros((3, last + pieces * bubbles.shape[1], pieces * points.size))
    half = np.diff(nodes) / 2.0
    x = (nodes[:-1, None] + half[:, None] * (1.0 + points)).ravel()
    for k, a in enumerate(half):
        at = slice(k * points.size, (k + 1) * points.size)
        derived = a ** -np.arange(3.0)[:, None, None]
        slopes = np.array([1.0, a, 1.0, a])[:, None]  # value and slope at either end
        values[:, 1 + 2 * k : 5 + 2 * k, at] = derived * slopes * cubics
        first = last + k * bubbles.shape[1]
        values[:, first : first + bubbles.shape[1], at] = derived * bubbles
    base = np.poly1d([-2.0, 0.0, 1.5, 0.0] if odd else [0.5, 0.0, 0.0])
    for order in range(3):
        values[order, 0] = np.polyval(np.polyder(base, order), x)
    # the middle's value or slope, and both at the clamp
    out = [1 if odd else 2, last - 2, last - 1]
    return _Line((2.0 * half[:, None] * weights).ravel(), np.delete(values, out, axis=1))


@lru_cache(maxsize=8)
def _pieces(degree: int) -> tuple[Floats, Floats, Floats, Floats]:
    """Return points and weights from −1 to 1, and functions there with two derivatives.

    Cubics of value and slope at −1 and at 1, and what vanishes with its slope at both.
    """
    points, weights = np.polynomial.legendre.leggauss(degree + 2)
    cubics = [
        [0.25, 0.0, -0.75, 0.5],
        [0.25, -0.25, -0.25, 0.25],
        [-0.25, 0.0, 0.75, 0.5],
        [0.25, 0.25, -0.25, -0.25],
    ]
    flat = [1.0, 0.0, -2.0, 0.0, 1.0]
    bubbles = [np.polymul(flat, _legendre(k)) for k in range(degree - 3)]
    return points, weights, _derived(cubics, points), _derived(bubbles, points)


def _across(powers: int, b: float, *, first: int) -> _Line:
    """Return every second of Legendre's polynomials of z/(b/2)."""
    weights, values = _legendres(powers, first)
    scale = (b / 2.0) ** -np.arange(3.0)[:, None, None]
    return _Line(b / 2.0 * weights, scale * values)


@lru_cache(maxsize=8)
def _legendres(powers: int, first: int) -> tuple[Floats, Floats]:
    """Return weights and the polynomials with two derivatives, of a coordinate from −1 to 1."""
    points, weights = np.polynomial.legendre.leggauss(powers + 1)
    return weights, _derived([_legendre(k) for k in range(first, powers + 1, 2)], points)


def _derived(shapes: Sequence[ArrayLike], points: Floats) -> Floats:
    """Return polynomials with two derivatives, shape (3, n, points)."""
    return np.array([
        [np.polyval(np.polyder(np.poly1d(shape), order), points) for shape in shapes]
        for order in range(3)
    ])  # fmt: skip


def _legendre(k: int) -> Floats:
    """Return the coefficients of Legendre's polynomial, the highest first."""
    return np.asarray(np.polynomial.legendre.leg2poly([0.0] * k + [1.0])[::-1], dtype=np.float64)


def _size(x: _Line, z: _Line, bases: int) -> int:
    """Return how many products of functions there are, with the first of z alone for a base."""
    return bases + (len(x.values[0]) - 1) * len(z.values[0])


def _stiffness(Q: Floats, products: list[tuple[_Line, _Line, int]]) -> Floats:
    """Return the matrix of twice the energy of products X(x) Z(z), those of bases first.

    Each pair of lines has one base, or none.
    """
    rows = []
    for x, z, bases in products:
        row = []
        for u, v, others in products:
            block = np.zeros(
                [len(x.values[0]), len(z.values[0]), len(u.values[0]), len(v.values[0])]
            )
            for a, b in np.argwhere(Q):
                one, other = CURVED[a], CURVED[b]
                along = (x.values[one.along] * x.weights) @ u.values[other.along].T
                across = (z.values[one.across] * z.weights) @ v.values[other.across].T
                scale = Q[a, b] * one.scale * other.scale
                block += scale * along[:, None, :, None] * across[:, None, :]
            flat = block.reshape(len(x.values[0]) * len(z.values[0]), -1)
            kept = np.delete(flat, _left_out(z, bases), axis=0)
            row.append(np.delete(kept, _left_out(v, others), axis=1))
        rows.append(row)
    return np.asarray(np.block(rows), dtype=np.float64)


def _left_out(z: _Line, bases: int) -> range:
    """Return which products of a base are none: clamps are rigid."""
    return range(bases, z.values.shape[1])


def _left(K: Floats, one: int, without: int | None = None) -> float:
    """Return the stiffness of one coordinate where all others are free, but for one at rest."""
    free = [k for k in range(K.shape[0]) if k not in (one, without)]
    follows = np.linalg.solve(K[np.ix_(free, free)], K[free, one])
    return float(K[one, one] - K[one, free] @ follows)
