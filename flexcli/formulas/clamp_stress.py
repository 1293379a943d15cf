"""Clamp stress: a clamp keeps a blade from narrowing, which raises the stress in its mid-width."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import bound

__all__ = ["CARDS", "CLAMP_ERROR", "at_clamp", "pure_bending_peak", "s_shape_peak"]

Floats = NDArray[np.float64]

CLAMP_ERROR = 0.008
"""Largest error of the two factors against thin plates, ν ≤ ½ and any b/l [-]."""


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


_BLADE = {"b": 10e-3, "l": 20e-3, "poisson_ratio": 0.3}
_THIN = (Range("b/h", least=3.0, why="a thick blade is no plate where it is clamped"),)

CARDS = (
    Card("clamp-stress-pure-bending", pure_bending_peak, _BLADE, _THIN),
    Card("clamp-stress-guided", s_shape_peak, _BLADE, _THIN),
    Card("clamp-stress-equivalent", at_clamp, {"peak": 1.2, "poisson_ratio": 0.3}),
)
