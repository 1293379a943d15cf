"""Plate factors: a wide blade between rigid clamps against the beam of the same section.

A beam narrows and widens across its faces as it bends (E); clamps keep it from doing so near them,
a very wide blade all over (E/(1 − ν²)). Every factor is k = 1/(1 − ν² ρ): ρ, the share of the
blade that is kept flat, depends on width over length.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.section import shear_parameter

__all__ = [
    "CARDS",
    "FIT_ERROR",
    "FlatShare",
    "beyond_plate",
    "bound",
    "cantilever_factor",
    "clamped_thickness",
    "effective_width",
    "end_moment_factor",
    "factor_error",
    "flat_share",
    "guided_factor",
    "limb_hinge_factor",
    "pivot_factor",
    "pure_bending_factor",
    "ratio",
]

Floats = NDArray[np.float64]

FIT_ERROR = 7e-4
"""Largest error of the two bending factors against thin plates, ν ≤ ½ and any b/l [-]."""

OF_WIDENING = 0.12
"""Largest error of a fit where the widening is small, as a share of it."""

THICKNESS_SHARE = 0.3
"""Largest error of ``effective_width``, as a share of what it takes from a factor."""


TINY = 1e-12
"""Stiffening of a plate below which there is none."""


class FlatShare(NamedTuple):
    """ρ/(1 − ρ) = x (p_0 + p_1 x + p_2 x²)/(1 + q_1 x + q_2 x²), x = b/l; ρ → 1 for wide ones."""

    p_0: float
    p_1: float
    p_2: float
    q_1: float
    q_2: float

    def factor(self, x: Floats, poisson_ratio: ArrayLike) -> Floats:
        """Return k = 1/(1 − ν² ρ)."""
        top = x * (self.p_0 + self.p_1 * x + self.p_2 * x**2)
        rho = top / (top + 1.0 + self.q_1 * x + self.q_2 * x**2)
        return np.asarray(1.0 / (1.0 - np.asarray(poisson_ratio) ** 2 * rho))


# least squares with weights towards the largest error, on Ritz solutions of the clamped plate at
# 27 widths from l/50 to 100 l and six Poisson's ratios from 0.1 to 0.5
_PURE = FlatShare(0.89777, -0.35171, 3.52216, -0.15247, 1.12239)
_S_SHAPE = FlatShare(2.52723, 2.28081, 22.19553, 0.24683, 3.21660)


def bound(poisson_ratio: ArrayLike) -> Floats:
    """Return the most that a plate is stiffer than the beam.

    ``1/(1 − ν²) − 1``.

    Parameters
    ----------
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    change : array
        Plate over beam stiffness, less one [-].

    Examples
    --------
    >>> round(float(bound(0.3)), 4)
    0.0989

    References
    ----------
    Timoshenko & Woinowsky-Krieger (1959), Theory of Plates and Shells, section 2.

    """
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    return np.asarray(nu**2 / (1.0 - nu**2))


def effective_width(*, b: ArrayLike, h: ArrayLike) -> Floats:
    """Return the width of the thin plate that is as much stiffer than the beam as a thick blade.

    ``b (1 − 1.25 t + 0.87 t²)``, t = h/b, at most 1.

    Parameters
    ----------
    b, h : array_like
        Width and thickness [m].

    Returns
    -------
    b_e : array
        Width to take in the factors of thin plates [m].

    Notes
    -----
    h ≤ b. From solids by Ritz's method, ν = 0.3: what it leaves of the widening is within 30 %
    of what it takes away.

    Examples
    --------
    >>> round(float(effective_width(b=10.0, h=1.0)), 3)
    8.837

    References
    ----------
    Derived here, from solids between rigid clamps; h/l ≤ 0.1.

    """
    width = np.asarray(b, dtype=np.float64)
    t = np.minimum(np.asarray(h, dtype=np.float64) / width, 1.0)
    return np.asarray(width * (1.0 - 1.25 * t + 0.87 * t**2))


def pure_bending_factor(
    *, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness of a clamped blade in pure bending over the beam's EI/l.

    ``k = 1/(1 − ν² ρ)``, ρ a fraction of polynomials of b/l.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        From 1 (narrow) to 1/(1 − ν²) (wide) [-].

    Notes
    -----
    Both ends on rigid bodies that turn oppositely, no force across. Within 7e-4 of thin plates
    solved by Ritz's method, at any b/l, ν ≤ ½; small curvature (β ≤ 1 of ``anticlastic``).

    Examples
    --------
    >>> round(float(pure_bending_factor(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    1.037

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate, two sides clamped, two free.

    """
    return _PURE.factor(ratio(b, h, l), poisson_ratio)


def guided_factor(
    *, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness of a guided blade, bent in an S, over the beam's 12EI/l³.

    ``k = 1/(1 − ν² ρ)``, ρ a fraction of polynomials of b/l.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        From 1 (narrow) to 1/(1 − ν²) (wide) [-].

    Notes
    -----
    Both ends on rigid bodies that do not turn. Within 7e-4 of thin plates solved by Ritz's
    method, at any b/l, ν ≤ ½. A thick blade shears besides.

    Examples
    --------
    >>> round(float(guided_factor(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    1.068

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate, two sides clamped, two free.

    """
    return _S_SHAPE.factor(ratio(b, h, l), poisson_ratio)


def pivot_factor(
    *, b: ArrayLike, l: ArrayLike, delta: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness of a blade that turns about a centre on its line over the beam's.

    ``k = (k_pb + 12 (½ + δ)² k_S)/(1 + 12 (½ + δ)²)``.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    delta : array_like
        δ = p/l, the centre outside the blade's end over its length [-].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        Factor of the rotational stiffness [-].

    Notes
    -----
    By symmetry pure bending and the S shape about the middle store their energies apart.

    Examples
    --------
    >>> middle = pivot_factor(b=0.5, l=1.0, delta=-0.5, poisson_ratio=0.3)
    >>> bool(middle == pure_bending_factor(b=0.5, l=1.0, poisson_ratio=0.3))
    True

    References
    ----------
    Derived here, from the two factors.

    """
    blade = {"b": b, "l": l, "poisson_ratio": poisson_ratio, "h": h}
    share = 12.0 * (0.5 + np.asarray(delta)) ** 2
    return np.asarray(
        (pure_bending_factor(**blade) + share * guided_factor(**blade)) / (1.0 + share)
    )


def end_moment_factor(
    *, b: ArrayLike, l: ArrayLike, delta: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the larger end moment of a blade of a pivot at a given rotation over the beam's.

    ``k = (k_pb + 6 |½ + δ| k_S)/(1 + 6 |½ + δ|)``.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    delta : array_like
        δ = p/l [-].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        Factor of the nominal bending stress, the mean over the width [-].

    Examples
    --------
    >>> blade = {"b": 0.5, "l": 1.0, "poisson_ratio": 0.3}
    >>> bool(end_moment_factor(delta=1e9, **blade) < guided_factor(**blade))
    True

    References
    ----------
    Derived here: moments of the two shapes add where their signs agree.

    """
    blade = {"b": b, "l": l, "poisson_ratio": poisson_ratio, "h": h}
    share = 6.0 * np.abs(0.5 + np.asarray(delta))
    return np.asarray(
        (pure_bending_factor(**blade) + share * guided_factor(**blade)) / (1.0 + share)
    )


def cantilever_factor(
    *, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness of a cantilever with a rigid body on its tip over the beam's 3EI/l³.

    ``1/k = ¾/k_pb + ¼/k_S``: the force bends purely by its moment about the middle.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        Factor of the stiffness, and of the moment at the clamp at a given travel [-].

    Examples
    --------
    >>> round(float(cantilever_factor(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    1.045

    References
    ----------
    Derived here, from the two factors.

    """
    blade = {"b": b, "l": l, "poisson_ratio": poisson_ratio, "h": h}
    return np.asarray(1.0 / (0.75 / pure_bending_factor(**blade) + 0.25 / guided_factor(**blade)))


def limb_hinge_factor(
    *, b: ArrayLike, l: ArrayLike, arm: ArrayLike, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the stiffness of a short blade against a force at a distance over the beam's.

    ``(arm² + l²/12)/k = arm²/k_pb + l²/(12 k_S)``: a hinge at the end of a rigid limb.

    Parameters
    ----------
    b, l : array_like
        Width and length of the short blade [m].
    arm : array_like
        From its middle to where the force across acts [m].
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        Factor of the stiffness at that place [-].

    Examples
    --------
    >>> blade = {"b": 0.5, "l": 1.0, "poisson_ratio": 0.3}
    >>> bool(abs(limb_hinge_factor(arm=0.5, **blade) - cantilever_factor(**blade)) < 1e-15)
    True

    References
    ----------
    Derived here, from the two factors.

    """
    blade = {"b": b, "l": l, "poisson_ratio": poisson_ratio, "h": h}
    pure, sheared = np.asarray(arm) ** 2, np.asarray(l) ** 2 / 12.0
    return np.asarray(
        (pure + sheared) / (pure / pure_bending_factor(**blade) + sheared / guided_factor(**blade))
    )


def factor_error(factor: ArrayLike, thin: ArrayLike, fit: float = FIT_ERROR) -> Floats:
    """Return the error of a factor of a thick blade.

    ``min(fit, 0.12 (k − 1)) + 0.3 (k_thin − k)``.

    Parameters
    ----------
    factor, thin : array_like
        The factor with the blade's thickness, and with h = 0 [-].
    fit : float
        Largest error of the fit [-].

    Returns
    -------
    error : array
        To either side [-].

    Examples
    --------
    >>> float(factor_error(1.0, 1.0))
    0.0

    References
    ----------
    Measured here: thin plates and solids by Ritz's method.

    """
    k = np.asarray(factor, dtype=np.float64)
    small = np.minimum(fit, OF_WIDENING * (k - 1.0))
    return np.asarray(small + THICKNESS_SHARE * (np.asarray(thin) - k))


def beyond_plate(
    *,
    h: ArrayLike,
    l: ArrayLike,
    poisson_ratio: ArrayLike,
    flat: ArrayLike = 1.0,
    ends: ArrayLike = 6.0,
) -> tuple[Floats, Floats]:
    """Return by how much less, and more, a blade may be stiff than a thin plate that shears.

    More by ``n c ν'² h/l``, where c = 0.0655 − 0.0155 ν' and ν' = ν/(1 − ν): a rigid clamp keeps a
    wide blade from thinning; and by ``0.04 s h/l``, s = Φ/(1 + Φ), for it keeps it from warping.
    Less by ``s ν²/(1 − ν²)``, for shear does not follow a plate's bending.

    Parameters
    ----------
    h, l : array_like
        Thickness and length [m].
    poisson_ratio : array_like
        ν [-].
    flat : array_like
        Share of the plate's stiffening that the blade has, 1 where it is wide [-].
    ends : array_like
        n, squares of both end moments over the mean square: 2 of an arc, 3 of a cantilever, 6 of
        an S, in between of what shears less [-].

    Returns
    -------
    less, more : tuple of arrays
        Shares of the stiffness [-].

    Notes
    -----
    Solids between rigid bodies (CalculiX), guided and as hinges of limbs, had no more, for h/l from
    0.1 to 1.5, b/h from 1 to 20 and ν up to 0.45; bricks of the fourth order no less, to h/l = 0.6
    and b = 15 l, where both clamps' thickness was not set against the shear.

    Examples
    --------
    >>> [round(float(each), 4) for each in beyond_plate(h=0.1, l=1.0, poisson_ratio=0.3)]
    [0.003, 0.0066]

    References
    ----------
    Derived here, from both.

    """
    slender = np.asarray(h, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    nu, n, flat = (np.asarray(each, dtype=np.float64) for each in (poisson_ratio, ends, flat))
    Phi = shear_parameter(depth=slender, l=1.0, poisson_ratio=nu)
    sheared = (n - 2.0) / 4.0 * Phi / (1.0 + Phi)
    kept = clamped_thickness(h=h, l=l, poisson_ratio=nu, ends=n)
    return np.asarray(flat * sheared * bound(nu)), np.asarray(
        flat * kept + 0.04 * sheared * slender
    )


def clamped_thickness(
    *, h: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike, ends: ArrayLike
) -> Floats:
    """Return by how much stiffer a very wide blade bends for clamps that keep it from thinning.

    ``n c ν'² h/l``, c = 0.0655 − 0.0155 ν' and ν' = ν/(1 − ν): each clamp shortens it by c ν'² h.

    Parameters
    ----------
    h, l : array_like
        Thickness and length [m].
    poisson_ratio : array_like
        ν [-].
    ends : array_like
        n, as of ``beyond_plate`` [-].

    Returns
    -------
    more : array
        Share of the stiffness in bending [-].

    Examples
    --------
    >>> round(float(clamped_thickness(h=0.1, l=1.0, poisson_ratio=0.3, ends=2.0)), 5)
    0.00216

    References
    ----------
    Derived here: plane bodies of finite elements (degree 7), half a blade clamped at its end.

    """
    slender = np.asarray(h, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    plane = nu / (1.0 - nu)
    return np.asarray(np.asarray(ends) * (0.0655 - 0.0155 * plane) * plane**2 * slender)


def flat_share(factor: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the share of a plate's stiffening that a blade has, none without Poisson's ratio."""
    over = np.maximum(bound(poisson_ratio), TINY)
    return np.asarray((np.asarray(factor, dtype=np.float64) - 1.0) / over)


def ratio(b: ArrayLike, h: ArrayLike, l: ArrayLike) -> Floats:
    """Return b/l of the thin plate that stands for the blade, see :func:`effective_width`."""
    return np.asarray(effective_width(b=b, h=h) / np.asarray(l, dtype=np.float64))


_BLADE = {"b": 10e-3, "l": 20e-3, "poisson_ratio": 0.3, "h": 0.2e-3}
_WIDE = (Range("b/h", least=1.0, why="a plate is no thicker than wide"),)
_CHART = {
    "b/l": Table(
        "b/l",
        (0.05, 0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 20.0),
        {
            "pure bending": (
                "",
                lambda x: float(pure_bending_factor(b=x, l=1.0, poisson_ratio=0.3)),
            ),
            "S shape": ("", lambda x: float(guided_factor(b=x, l=1.0, poisson_ratio=0.3))),
        },
        "thin, ν = 0.3",
    )
}

CARDS = (
    Card("plate-pure-bending", pure_bending_factor, _BLADE, _WIDE, _CHART),
    Card("plate-guided", guided_factor, _BLADE, _WIDE, _CHART),
    Card("plate-pivot", pivot_factor, {**_BLADE, "delta": 0.1}, _WIDE),
    Card("plate-end-moment", end_moment_factor, {**_BLADE, "delta": 0.1}, _WIDE),
    Card("plate-cantilever", cantilever_factor, _BLADE, _WIDE),
    Card("plate-hinge", limb_hinge_factor, {**_BLADE, "arm": 15e-3}, _WIDE),
    Card("plate-effective-width", effective_width, {"b": 10e-3, "h": 1e-3}, _WIDE),
    Card("plate-bound", bound, {"poisson_ratio": 0.3}),
    Card("plate-beyond", beyond_plate, {"h": 1e-3, "l": 20e-3, "poisson_ratio": 0.3}),
)
