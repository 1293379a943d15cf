"""Sheet factors: a wide blade between rigid clamps in its own plane against the beam of it."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range

__all__ = [
    "CARDS",
    "GUIDED_ERROR",
    "HELD_ERROR",
    "SHEET_ERROR",
    "WIDEST",
    "axial_factor",
    "bending_factor",
    "block_axial_factor",
    "guided_factor",
    "held_growth",
]

Floats = NDArray[np.float64]

SHEET_ERROR = 1.2e-3
"""Largest error of stretching and pure bending in the plane, ν ≤ 0.45 and b/l ≤ 5 [-]."""

GUIDED_ERROR = 8e-3
"""Largest error of the S shape in the plane, ν ≤ 0.45 and b/l ≤ 5 [-]."""


HELD_ERROR = 0.04
"""Largest error of the stretching of a blade with its thickness, a share of what clamps stiffen:
bricks of the fourth order left 0.037 of 80 (h/l 0.02 to 0.6, b from h to 6 l, ν 0.1 to 0.48)."""

WIDEST = 5.0
"""Largest b/l of what was compared [-]."""


def axial_factor(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the stiffness of a blade along itself over E h b/l.

    ``k = 1/(1 − ν² ρ)``, ``ρ/(1 − ρ) = 0.267 x (1 + 0.619 x²)/(1 + 0.167 x²)``, x = b/l: its
    clamps keep it from narrowing.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    k : array
        From 1 (narrow) to 1/(1 − ν²) (wide) [-].

    Notes
    -----
    Within 1.2e-3 of plane stress solved by Ritz's method, b/l ≤ 5 and ν ≤ 0.45.

    Examples
    --------
    >>> round(float(axial_factor(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    1.012

    References
    ----------
    Derived here: Ritz's method on the sheet in plane stress, two sides clamped, two free.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    odds = x * (0.26709 + 0.16545 * x**2) / (1.0 + 0.16713 * x**2)
    return _kept_from_narrowing(odds, poisson_ratio)


def bending_factor(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the stiffness of a blade in pure bending across its width over E h b³/(12 l).

    ``k = 1/(1 − ν² ρ)``, ``ρ/(1 − ρ) = x (0.124 + 0.0235 x²)/(1 + 0.0497 x + 0.0700 x²)``.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    k : array
        From 1 (narrow) to 1/(1 − ν²) (wide) [-].

    Notes
    -----
    Within 1.2e-3 of plane stress solved by Ritz's method, b/l ≤ 5 and ν ≤ 0.45.

    Examples
    --------
    >>> round(float(bending_factor(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    1.005

    References
    ----------
    Derived here: Ritz's method on the sheet in plane stress, two sides clamped, two free.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    odds = x * (0.12365 + 0.02351 * x**2) / (1.0 + 0.04974 * x + 0.07004 * x**2)
    return _kept_from_narrowing(odds, poisson_ratio)


def guided_factor(
    *, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike, shear: ArrayLike = 1.0
) -> Floats:
    """Return the stiffness of the S shape across the width over Timoshenko's 12EI/(l³(1 + Φ)).

    ``k = (1 + Φ)/(1/k_b + Φ (1 − g/6))`` with Φ of ``shear_parameter`` for the depth b: the
    clamps keep the section plane, whose shear is then even (g = 1), and from narrowing (k_b).

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].
    shear : array_like
        Shear modulus over that of the isotropic sheet, see ``directed_error`` [-].

    Returns
    -------
    k : array
        From 1 (narrow) to 6/5 (wide) [-].

    Notes
    -----
    Within 8e-3 of plane stress solved by Ritz's method, b/l ≤ 5 and ν ≤ 0.45.

    Examples
    --------
    >>> round(float(guided_factor(b=1.0, l=1.0, poisson_ratio=0.0)), 3)
    1.022

    References
    ----------
    Derived here: Ritz's method on the sheet in plane stress, two sides clamped, two free.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    Phi = 2.4 * (1.0 + nu) / np.asarray(shear, dtype=np.float64) * x**2
    held = _kept_from_narrowing(x * (0.42684 + 1.34298 * x**2), nu)
    even = 0.37325 * x**2 / (1.0 + 0.62452 * x + 0.37325 * x**2)
    return np.asarray((1.0 + Phi) / (1.0 / held + Phi * (1.0 - even / 6.0)))


def held_growth(
    *, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return how much longer a blade grows for what its clamps keep it from growing across [-].

    ``ν ρ`` with the ρ of ``axial_factor``, of a sheet: clamps that hold a strain across of ε
    lengthen a blade by ν ρ ε l. By Betti's theorem that is the work of what keeps a stretched one
    from narrowing. Those of a blade of a thickness h hold that too and make it longer by
    ``ν ε (a b/(1 + x²/3) + c h)`` more, x = b/l, ``a = 0.013 + 0.085 (0.3 − ν)``,
    ``c = 0.485 + 0.75 (ν − 0.3) − (0.083 + 0.33 (ν − 0.3)) h/b``.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness [m], of which the larger of both is the width; 0 is a sheet.

    Returns
    -------
    share : array
        From 0 (narrow) to ν (wide) of a sheet [-].

    Notes
    -----
    A sheet is as exact as ``axial_factor``. A blade is within 4 % of solids of high order,
    b/l ≤ 5, h/b from 0.02, h/l ≤ 0.6 and 0.1 ≤ ν ≤ 0.48; clamps that hold different strains count
    by their mean.

    Examples
    --------
    >>> round(float(held_growth(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    0.039
    >>> round(float(held_growth(b=0.5, h=0.05, l=1.0, poisson_ratio=0.3)), 3)
    0.048

    References
    ----------
    Derived here, from ``axial_factor`` and Ritz's method on solids between rigid clamps.

    """
    nu, length = (np.asarray(each, dtype=np.float64) for each in (poisson_ratio, l))
    one, other = (np.asarray(each, dtype=np.float64) for each in (b, h))
    width, thick = np.maximum(one, other), np.minimum(one, other)
    stiffer = axial_factor(b=width, l=length, poisson_ratio=nu)
    over = nu - 0.3
    a = (0.013 - 0.085 * over) / (1.0 + (width / length) ** 2 / 3.0)
    c = 0.485 + 0.75 * over - (0.083 + 0.33 * over) * thick / width
    held = np.where(thick > 0.0, nu * (a * width + c * thick) / length, 0.0)
    # 1/k = 1 − ν² ρ
    with np.errstate(invalid="ignore", divide="ignore"):
        return np.where(nu > 0.0, (1.0 - 1.0 / stiffer) / nu + held, 0.0)


def block_axial_factor(
    *, h: ArrayLike, l: ArrayLike, b: ArrayLike, poisson_ratio: ArrayLike
) -> Floats:
    """Return the stiffness of a blade along itself over E h b/l, kept from thinning as well.

    ``k = 1/(1 − ν s)``, s of ``held_growth``: what clamps hold of the growth of a body lessens, by
    ν, how far a force draws it out.

    Parameters
    ----------
    h, l, b : array_like
        Thickness, length and width [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    k : array
        From 1 to a little above 1/(1 − ν²) [-].

    Notes
    -----
    Within ``HELD_ERROR`` (k − 1) of solids between rigid bodies, b/l ≤ 5, h/l ≤ 0.6, ν ≤ 0.48.

    Examples
    --------
    >>> round(float(block_axial_factor(h=0.3, l=1.0, b=3.0, poisson_ratio=0.3)), 3)
    1.081

    References
    ----------
    Betti's reciprocal theorem, for strains that clamps hold and a force along the body.

    """
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    return np.asarray(1.0 / (1.0 - nu * held_growth(b=b, h=h, l=l, poisson_ratio=nu)))


def _kept_from_narrowing(odds: Floats, poisson_ratio: ArrayLike) -> Floats:
    """Return 1/(1 − ν² ρ) from ρ/(1 − ρ)."""
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    return np.asarray(1.0 / (1.0 - nu**2 * odds / (1.0 + odds)))


_SHEET = {"b": 10e-3, "l": 20e-3, "poisson_ratio": 0.3}
_FITTED = (Range("b/l", most=WIDEST, why="wider blades were not compared"),)

CARDS = (
    Card("sheet-axial", axial_factor, _SHEET, _FITTED),
    Card("sheet-held-growth", held_growth, _SHEET, _FITTED),
    Card("block-axial", block_axial_factor, {"h": 2e-3, **_SHEET}, _FITTED),
    Card("sheet-bending", bending_factor, _SHEET, _FITTED),
    Card("sheet-guided", guided_factor, _SHEET, _FITTED),
)
