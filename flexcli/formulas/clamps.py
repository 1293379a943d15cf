"""Clamps: they keep a blade from narrowing, and are compliant where one piece with the blade.

The first raises the stress in mid-width at the clamp, the other makes the blade softer.
"""

from collections.abc import Sequence
from typing import Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import bound

__all__ = [
    "CARDS",
    "ClampCompliance",
    "FilletCompliance",
    "RootBody",
    "at_clamp",
    "clamp_compliance",
    "extra_length",
    "fillet_compliance",
    "filleted_root",
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

NARROW = 0.2
"""Part of the root's rotation that is uncertain for a blade as thick as wide on a wider body."""


RootBody: TypeAlias = Literal["wide", "side", "flush"]
"""The body that a blade with fillets is cut from: reaching far beyond them and 2 h deep, the least;
100 h deep, but ending h beyond one face and ½ h beyond its fillet, the most; or a face of the blade
in line with its side, so that it has a fillet on the other face alone."""

Rows: TypeAlias = tuple[tuple[float, ...], ...]
"""Coefficients of the powers of u, a row for every power of ν."""

RIGID: tuple[Rows, Rows, Rows, Rows] = (
    (
        (1.089, -1.976, -3.547, 7.081, 5.359, -10.365, -3.202, 5.666),
        (-0.346, -0.724, 0.876, 1.609, -0.719, -0.164, 0.116, -1.073),
        (-0.276, -1.066, -0.016, 3.728, 0.198, -6.821, -0.233, 4.277),
    ),
    (
        (-0.265, 2.177, -3.972, -1.359, 6.314, 0.109, -3.539, 0.364),
        (0.874, -1.639, -1.189, 3.177, 2.235, -3.769, -1.414, 1.790),
        (0.214, -0.141, -0.999, 0.542, 1.617, -0.912, -0.916, 0.524),
    ),
    (
        (0.028, -0.699, 3.017, -4.366, -0.837, 4.867, 0.127, -2.284),
        (-0.446, 1.925, -2.745, 0.151, 2.686, -1.030, -1.523, 0.979),
        (-0.100, 0.364, 0.016, -1.222, 0.110, 1.839, -0.018, -1.070),
    ),
    (
        (0.089, -0.364, 0.393, 0.067, -0.178, -0.017),
        (-0.110, 0.162, 0.093, -0.179, -0.091, 0.081),
        (-0.129, 0.033, 0.025, -0.015, -0.015, 0.013),
    ),
)
"""Turn, mixed, shift and stretch of fillets on a rigid body; the shift times w = √x/(1 + √x)."""

CUT: dict[RootBody, tuple[tuple[float, ...], ...]] = {
    "wide": (
        (2.353, 3.768, 1.012, -2.386, -1.367, 1.286),
        (-1.555, 1.034, 0.516, 0.055, -0.816),
        (1.247, 2.206, -4.317, -0.173, 9.354, -7.345),
        (0.521, 0.547, -0.154, -0.417, 0.254),
    ),
    "side": (
        (2.715, 4.506, 0.589, -3.612, -0.925, 2.081),
        (-2.610, 0.512, 2.118, -0.002, -1.887),
        (7.865, 6.244, 1.322, -0.451),
        (7.163, 3.497, -4.467, 1.485),
    ),
    "flush": (
        (3.197, 3.081, 3.300, -0.754, -1.304),
        (-1.691, -0.171, -1.080, 0.233, -0.332),
        (2.802, 4.411, 7.605, 1.823),
        (4.935, 4.479, 0.921, -0.973, 0.392),
    ),
}
"""The same on bodies that give way, of any ν but for the mixed; of two the shifts at the least and
at the most ν."""

SCALED: dict[RootBody, tuple[int, int, int, int]] = {
    "wide": (0, 0, 0, 0),
    "side": (0, 0, 1, 0),
    "flush": (1, 2, 3, 1),
}
"""Powers of w that these are times: a fillet on one face alone is a crooked beam."""

LARGEST = 0.03
"""Least h/r of fillets that were compared on bodies that give way; larger ones do as if rigid at
least, and at most as these, scaled."""

SHEARS = 1.195
"""Increase of the mixed compliance with ν: the turn of a section that a parabola of shear bends."""


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


class FilletCompliance(NamedTuple):
    """Compliance of a root where its fillets begin, beyond their beam, times E b and a power of h.

    The turn per moment; ``mixed`` the turn per force across that raises the moment into the blade,
    and the shift per moment; ``shift`` per that force and ``stretch`` per axial force [-].
    """

    turn: float
    mixed: float
    shift: float
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
    *, h: float, b: float, poisson_ratio: float, flush: bool = False
) -> ClampCompliance:
    """Return the least and the greatest compliance of a sharp root of one piece with its body.

    ``θ = c M/(E b h²)``, c = 5.0 on a half-plane, 7.7 where a face of the blade is in line with a
    side of the body; 1 − ν² of it where the blade is wide.

    Parameters
    ----------
    h, b : float
        Thickness and width [m].
    poisson_ratio : float
        ν [-].
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
    h ≤ b. Plane stress is the most, by complementary energy; plane strain and a body wider than
    the blade are the least. Rotation is settled within 5 h; the shifts grow with the logarithm of
    the body's size, which is why they have bounds alone. With fillets see ``filleted-root``.

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
    if flush:
        return ClampCompliance(least * held, MOST_FLUSH, shift=40.0, mixed=3.0, stretch=32.0)
    return ClampCompliance(least * held, most, shift=15.0, mixed=1.7, stretch=8.0)


def fillet_compliance(*, h: float, r: float, poisson_ratio: float) -> FilletCompliance:
    """Return what fillets on a rigid body give way where they begin, beyond their beam.

    ``θ = c M/(E b h²)`` and so on: polynomials in u = (√x − 1)/(√x + 1), x = h/r, and in ν; of
    plane stress, and of plane strain with ν/(1 − ν) and E/(1 − ν²).

    Parameters
    ----------
    h, r : float
        Thickness of the blade and radius of its fillets [m].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    turn : float
        Turn per moment where the fillets begin, θ E b h²/M [-].
    mixed : float
        Turn there per force across, which raises the moment into the blade, and shift per
        moment, times E b h [-].
    shift, stretch : float
        Shift per that force and stretch per axial force, times E b [-].

    Notes
    -----
    The beam of their profile takes sections for plane that are not, and lets them narrow at the
    body. Quarter circles that meet it at right angles; any h/r, ν to 1 (plane strain of ½). Within
    0.03, 0.03, 0.012 (1 + √(r/h)) and 0.007 of plane bodies; blades between two of them are within
    0.1 % of such bodies in arc, S and tension down to h/4 between the fillets, 2 % where h = 10 r
    and ν = 0.9.

    Examples
    --------
    >>> found = fillet_compliance(h=1.0, r=1.0, poisson_ratio=0.3)
    >>> [round(part, 2) for part in found]
    [0.96, 0.02, -0.23, 0.04]

    References
    ----------
    Fitted here to finite elements of high order for plane bodies: 22 h/r from 0.005 to 400 and 5 ν,
    and held against 60 at random.

    """
    u, w = _sharpness(h, r)
    turn, mixed, shift, stretch = (
        sum(poisson_ratio**power * _polynomial(row, u) for power, row in enumerate(rows))
        for rows in RIGID
    )
    return FilletCompliance(turn, mixed, shift / w, stretch)


def filleted_root(*, h: float, r: float, poisson_ratio: float, body: RootBody) -> FilletCompliance:
    """Return what a root with fillets of one piece with its body gives way where they begin.

    ``θ = c M/(E b h²)`` and so on, beyond the beam of the fillets' profile: polynomials in
    u = (√x − 1)/(√x + 1), x = h/r.

    Parameters
    ----------
    h, r : float
        Thickness of the blade and radius of its fillets [m].
    poisson_ratio : float
        ν [-].
    body : str
        ``wide`` and 2 h deep, the least; ``side``, 100 h deep and ending h beyond one face and
        ½ h beyond its fillet, the most; ``flush`` with one face, which has no fillet.

    Returns
    -------
    turn, mixed, shift, stretch : float
        Turn, mixed compliance, shift and stretch as of ``fillet-compliance`` [-].

    Notes
    -----
    A body that is larger beside the blade, or rigid nearer behind it, gives way less under every
    load. Plane stress, for h/r from 0.03 to 300. But for the mixed one they are those of whichever
    ν bounds, 0 or 0.95: of ``wide`` the turn is up to 0.12 more and the stretch 0.35, of the others
    the stretch up to 0.25 less. Within 0.03, 0.06, 0.1 and 0.12 of plane bodies; the shift of
    ``side`` within 0.06 (1 + √(r/h)), parts of ``flush`` within 0.02 times powers of that.

    Examples
    --------
    >>> found = filleted_root(h=1.0, r=1.0, poisson_ratio=0.3, body="wide")
    >>> [round(part, 2) for part in found]
    [2.35, -1.2, 1.25, 0.52]

    References
    ----------
    Fitted here to finite elements of high order for plane bodies: 16 h/r from 0.03 to 300 and 4 ν.

    """
    if body == "wide" and h < LARGEST * r:
        return fillet_compliance(h=h, r=r, poisson_ratio=poisson_ratio)
    u, w = _sharpness(max(h, LARGEST * r), r)[0], _sharpness(h, r)[1]
    turn, mixed, shift, stretch = (
        _polynomial(row, u) / w**power for row, power in zip(CUT[body], SCALED[body], strict=True)
    )
    return FilletCompliance(turn, mixed + SHEARS * poisson_ratio, shift, stretch)


def _sharpness(h: float, r: float) -> tuple[float, float]:
    """Return u of the fits and w, which falls to nothing with h/r."""
    root = (h / r) ** 0.5
    return (root - 1.0) / (root + 1.0), root / (1.0 + root)


def _polynomial(coefficients: Sequence[float], u: float) -> float:
    found = 0.0
    for each in reversed(coefficients):
        found = found * u + each
    return found


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
_ROOT = {"h": 0.2e-3, "b": 10e-3, "poisson_ratio": 0.3, "flush": False}
_FILLETS = {"h": 0.2e-3, "r": 0.15e-3, "poisson_ratio": 0.3}
_THIN = (Range("b/h", least=3.0, why="a thick blade is no plate where it is clamped"),)
_COMPARED = (Range("h/r", least=LARGEST, why="larger fillets were not compared"),)

CARDS = (
    Card("clamp-stress-pure-bending", pure_bending_peak, _BLADE, _THIN),
    Card("clamp-stress-guided", s_shape_peak, _BLADE, _THIN),
    Card("clamp-stress-equivalent", at_clamp, {"peak": 1.2, "poisson_ratio": 0.3}),
    Card("clamp-compliance", clamp_compliance, _ROOT),
    Card("fillet-compliance", fillet_compliance, _FILLETS),
    Card("filleted-root", filleted_root, _FILLETS | {"body": "side"}, _COMPARED),
    Card("extra-length", extra_length, {"h": 0.2e-3}),
)
