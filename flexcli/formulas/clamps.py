"""Clamps: they keep a blade from narrowing, and are compliant where one piece with the blade.

The first raises the stress in mid-width at the clamp, the other makes the blade softer.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import bound

__all__ = [
    "CARDS",
    "ClampCompliance",
    "at_clamp",
    "clamp_compliance",
    "extra_length",
    "fillet_compliance",
    "pure_bending_peak",
    "s_shape_peak",
]

Floats = NDArray[np.float64]

TURN = 5.0
"""Rotation of the root of a blade that stands on a half-plane, θ E b h²/M [-]."""

LEAST_TURN = 4.75
"""The same, at least, where the body ends in something rigid 2 h behind the root [-]."""

MOST_TURN, MOST_FLUSH = 5.25, 8.3
"""The same, at most, of a body reaching h beyond both faces; of a face flush with its side."""

LEAST_FILLETED, MOST_FILLETED = 0.92, 1.11
"""Least and greatest rotation of a filleted root on such bodies, over the fit [-]."""

OF_FILLET = 0.2
"""Relative error of the rotation of fillets on a rigid body [-]."""

NARROW = 0.2
"""Part of the root's rotation that is uncertain for a blade as thick as wide on a wider body."""


class ClampCompliance(NamedTuple):
    """Compliance of the root of a blade, times E b and a power of h [-].

    The ``least`` and ``most`` of θ h²/M; then upper bounds: ``shift`` across the blade per shear
    force, ``mixed`` for h times the shift per moment, ``stretch`` along the blade per axial force.
    The lower bound of these three is zero; a moment that acts on the blade also shifts its root.
    """

    least: float
    most: float
    shift: float
    mixed: float
    stretch: float


def pure_bending_peak(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return σ_x at the faces in the mid-width of a clamp over the beam's M c/I, pure bending.

    ``1 + (0.600 ν + 1.132 ν³) A + ν²/(1 − ν²) B``: A of a narrow blade fades with b/l as B, that
    of a wide one, comes in.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        For the same rotation [-].

    Notes
    -----
    Within 0.8 % of thin plates solved by Ritz's method, ν ≤ ½. Towards the corners of the clamp
    the stress falls, and rises again within less than a thickness or so, where it is singular.

    Examples
    --------
    >>> round(float(pure_bending_peak(b=0.01, l=1.0, poisson_ratio=0.3)), 2)
    1.21

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate, two sides clamped, two free.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    narrow = 1.0 / (1.0 + 0.16468 * x + 0.38773 * x**4)
    wide = x * (0.33482 + 4.25741 * x) / (1.0 + 0.37615 * x + 4.25741 * x**2)
    return np.asarray(1.0 + nu * (0.60033 + 1.13196 * nu**2) * narrow + bound(nu) * wide)


def s_shape_peak(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return σ_x at the faces in the mid-width of a clamp over the beam's M c/I, S shape.

    ``1 + (0.630 ν + 0.981 ν³) A + ν²/(1 − ν²) B``.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        For the same travel [-].

    Notes
    -----
    Within 0.8 % of thin plates solved by Ritz's method, ν ≤ ½.

    Examples
    --------
    >>> round(float(s_shape_peak(b=0.5, l=1.0, poisson_ratio=0.3)), 2)
    1.16

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate, two sides clamped, two free.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    narrow = 1.0 / (1.0 + 2.35171 * x + 0.68723 * x**2 + 7.43301 * x**4)
    wide = x * (3.07259 + 15.45393 * x) / (1.0 + 2.60682 * x + 15.45393 * x**2)
    return np.asarray(1.0 + nu * (0.63036 + 0.98071 * nu**2) * narrow + bound(nu) * wide)


def at_clamp(*, peak: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return von Mises' stress at the clamp over the nominal stress, from that of σ_x.

    ``peak √(1 − ν + ν²)``: the clamp adds σ_y = ν σ_x.

    Parameters
    ----------
    peak : array_like
        σ_x over the nominal stress [-].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        The equivalent stress, as yield takes it [-].

    Examples
    --------
    >>> round(float(at_clamp(peak=1.2, poisson_ratio=0.3)), 3)
    1.067

    References
    ----------
    von Mises (1913), Mechanik der festen Körper im plastisch-deformablen Zustand, in plane stress.

    """
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    return np.asarray(np.asarray(peak) * np.sqrt(1.0 - nu + nu**2))


def clamp_compliance(
    *, h: float, b: float, poisson_ratio: float, r: float = 0.0, flush: bool = False
) -> ClampCompliance:
    """Return the least and the greatest compliance of a root cut from one piece with its body.

    ``θ = c M/(E b h²)``, c = 5.0 on a half-plane, 7.7 where a face of the blade is in line with a
    side of the body; 1 − ν² of it where the blade is wide. With fillets, on top of the beam of
    their profile, c = 5.0 (h + 0.1 r)/(h + 1.1 r).

    Parameters
    ----------
    h, b : float
        Thickness and width [m].
    poisson_ratio : float
        ν [-].
    r : float
        Radius of the fillets at the root; 0 for sharp corners [m].
    flush : bool
        Whether a face of the blade may be in line with a side of its body.

    Returns
    -------
    least, most : float
        Rotation per moment, θ E b h²/M, between which it lies [-].
    shift, mixed, stretch : float
        Shift across per shear force and per moment over h, and along per axial force, at most [-].

    Notes
    -----
    Bodies that reach at least h beyond both faces (or, flush, beyond one) and 2 h behind the
    root, at most 100 h, and are stiff themselves: what a slender body bends is no part of it.
    Fillets of h/r from 0.2 on; h ≤ b. Plane stress is the most, by complementary energy; plane
    strain and a body wider than the blade are the least. Rotation is settled within 5 h; the shifts
    grow with the logarithm of the body's size, which is why they have bounds alone.

    O'Donnell takes the stress at the root as linear and so 16.67/π = 5.31 for c.

    Examples
    --------
    >>> found = clamp_compliance(h=0.2e-3, b=10e-3, poisson_ratio=0.3)
    >>> round(found.least, 2), found.most
    (4.31, 5.25)

    References
    ----------
    Computed here with finite elements of high order for plane bodies; after W. J. O'Donnell
    (1960), The additional deflection of a cantilever due to the elasticity of the support,
    Journal of Applied Mechanics 27, 461–464.

    """
    held = (1.0 - poisson_ratio**2) * (1.0 - NARROW * min(1.0, h / b))
    least, most = LEAST_TURN, MOST_TURN
    if r > 0.0:
        turn = TURN * (h + 0.1 * r) / (h + 1.1 * r)
        least = min(least, LEAST_FILLETED * turn)
        most = min(most, MOST_FILLETED * turn)
    if flush:
        return ClampCompliance(least * held, MOST_FLUSH, shift=40.0, mixed=3.0, stretch=32.0)
    return ClampCompliance(least * held, most, shift=15.0, mixed=1.7, stretch=8.0)


def fillet_compliance(*, h: float, r: float) -> ClampCompliance:
    """Return the least and the greatest compliance of fillets on a rigid body beyond their beam.

    ``θ = c M/(E b h²)``, ``c = 1.3/(1 + 0.3 (h/r)²)``: the beam of their profile takes sections for
    plane that are not.

    Parameters
    ----------
    h, r : float
        Thickness of the blade and radius of its fillets [m].

    Returns
    -------
    least, most : float
        Rotation per moment, θ E b h²/M, between which it lies [-].
    shift, mixed, stretch : float
        Of forces, nothing [-].

    Notes
    -----
    Quarter circles that meet the body at right angles; h/r from 0.2 to 20, plane stress.

    Examples
    --------
    >>> found = fillet_compliance(h=1.0, r=1.0)
    >>> round(found.least, 2), round(found.most, 2)
    (0.8, 1.2)

    References
    ----------
    Fitted here to finite elements of high order for plane bodies.

    """
    turn = 1.3 / (1.0 + 0.3 * (h / r) ** 2)
    return ClampCompliance(max(turn - OF_FILLET, 0.0), turn + OF_FILLET, 0.0, 0.0, 0.0)


def extra_length(*, h: float, turn: float = TURN) -> float:
    """Return the length by which a compliant root lengthens a blade in bending, at each end.

    ``Δ = c h/12``: on a half-plane 0.42 h.

    Parameters
    ----------
    h : float
        Thickness [m].
    turn : float
        c of ``clamp-compliance`` [-].

    Returns
    -------
    length : float
        Δ [m].

    Notes
    -----
    A guided blade is softer by 6 Δ/l, one in pure bending by 2 Δ/l, Euler's load of one clamped
    at both ends lower by 4 Δ/l, to first order.

    Examples
    --------
    >>> round(extra_length(h=1.2), 9)
    0.5

    References
    ----------
    From the rotation of a root.

    """
    return turn * h / 12.0


_BLADE = {"b": 10e-3, "l": 20e-3, "poisson_ratio": 0.3}
_ROOT = {"h": 0.2e-3, "b": 10e-3, "poisson_ratio": 0.3, "r": 0.0, "flush": False}
_THIN = (Range("b/h", least=3.0, why="a thick blade is no plate where it is clamped"),)

CARDS = (
    Card("clamp-stress-pure-bending", pure_bending_peak, _BLADE, _THIN),
    Card("clamp-stress-guided", s_shape_peak, _BLADE, _THIN),
    Card("clamp-stress-equivalent", at_clamp, {"peak": 1.2, "poisson_ratio": 0.3}),
    Card("clamp-compliance", clamp_compliance, _ROOT),
    Card("fillet-compliance", fillet_compliance, {"h": 0.2e-3, "r": 0.15e-3}),
    Card("extra-length", extra_length, {"h": 0.2e-3}),
)
