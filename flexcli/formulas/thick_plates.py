"""Thick wide blades: a solid between rigid clamps against the beam of the same section that shears.

As a plate of ``plate_factors``, of less width, that keeps its thickness at its clamps and shears as
a beam does, whatever it bends by. Widths and clamps are fitted to solids.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import (
    FIT_ERROR,
    TINY,
    bound,
    clamped_thickness,
    guided_factor,
    pure_bending_factor,
)
from flexcli.formulas.section import shear_parameter

__all__ = ["CARDS", "LARGEST_NU", "THICKEST", "thick_arc_factor", "thick_error", "thick_s_factor"]

Floats = NDArray[np.float64]

THICKEST = 0.6
"""Thickness over length up to which solids were compared [-]."""

LARGEST_NU = 0.48
"""Poisson's ratio up to which, from none on [-]."""

OF_FLAT, OF_SMALL = 0.025, 0.2
"""Largest error of a fit where h ≤ 0.3 l: a share of what a plate stiffens at most, beside that of
thin plates, and of what the blade stiffens where that is small. Solids of the fit (156, ν from 0.15
to 0.48, b to 15 l; less 0.1 to 3 % of what clamps stiffen, by which finer bricks are softer) left
0.6 of it, 52 drawn at random (h/l from 0.015, ν from 0.1) 0.66, by which the second was chosen, 18
drawn after that 0.55."""

THIN, THICK = 0.05, 0.3
"""Thickness over length from which on that is all of it, and beyond which it grows."""

GROWS = 6.0
"""By how many times over a further 0.3 l: solids at 0.4 l and 0.6 l (18) had 0.4 and 0.6 of it."""


class _Fit(NamedTuple):
    """Width ``b (1 + t (a_1 + a_2 ν + a_3 t) + t h/l (a_4 + a_5 l/(l + b)))``, t = h/b.

    The ends of a blade that is flat to a share f keep its thickness by ``f^m (1 + c h/l)`` of what
    those of a very wide one do.
    """

    a_1: float
    a_2: float
    a_3: float
    a_4: float
    a_5: float
    m: float
    c: float

    def width(self, h: Floats, l: Floats, b: Floats, nu: Floats) -> Floats:
        """Return the width of the thin plate that curls as much [m]."""
        t, short = h / b, h / l
        lost = self.a_1 + self.a_2 * nu + self.a_3 * t
        return b * (1.0 + t * (lost + short * (self.a_4 + self.a_5 / (1.0 + b / l))))

    def bent(self, plate: Floats, ends: float, h: Floats, l: Floats, nu: Floats) -> Floats:
        """Return what it stiffens in bending, by that of the plate of this width."""
        flat = (plate - 1.0) / np.maximum(bound(nu), TINY)
        kept = clamped_thickness(h=h, l=l, poisson_ratio=nu, ends=ends)
        return plate * (1.0 + kept * flat**self.m * (1.0 + self.c * h / l))


_ARC = _Fit(-1.3194, 0.1989, 0.7490, -1.6011, 2.8274, 9.2939, 0.5592)
_S_SHAPE = _Fit(-1.2377, 0.2234, 0.8472, 4.3524, -5.0430, 5.3712, 0.9069)
_EVEN, _EVEN_NU = 0.0329, 0.0403
"""Parts of the shear, over h/l and over ν h/l, that clamps take by keeping ends from warping."""


def thick_arc_factor(
    *, h: ArrayLike, l: ArrayLike, b: ArrayLike, poisson_ratio: ArrayLike
) -> Floats:
    """Return the stiffness of a thick clamped blade in pure bending over the beam's EI/l.

    ``k = k_pb(b_e) (1 + 2 c ν'² h/l fᵐ)``, b_e the width of the thin plate that curls as much.

    Parameters
    ----------
    h, l, b : array_like
        Thickness, length and width [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    k : array
        From 1 (narrow) to a little above 1/(1 − ν²) (wide) [-].

    Notes
    -----
    Within ``thick_error`` of solids between rigid bodies, h ≤ 0.6 l, h ≤ b, ν ≤ 0.48; b up to 15 l.

    Examples
    --------
    >>> round(float(thick_arc_factor(h=0.3, l=1.0, b=1.0, poisson_ratio=0.3)), 3)
    1.049

    References
    ----------
    Derived here: bricks of the fourth order, small towards the edges of the clamps.

    """
    h_, l_, b_, nu = (np.asarray(each, dtype=np.float64) for each in (h, l, b, poisson_ratio))
    width = _ARC.width(h_, l_, b_, nu)
    plate = pure_bending_factor(b=width, l=l_, poisson_ratio=nu)
    return np.asarray(_ARC.bent(plate, 2.0, h_, l_, nu))


def thick_s_factor(*, h: ArrayLike, l: ArrayLike, b: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the stiffness of a thick blade bent in an S over that of Timoshenko's beam.

    ``k = (1 + Φ)/(1/k_b + Φ (1 − s h/l))``, ``k_b = k_S(b_e) (1 + 6 c ν'² h/l fᵐ)``.

    Parameters
    ----------
    h, l, b : array_like
        Thickness, length and width [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    k : array
        Over 12 EI/(l³ (1 + Φ)) [-].

    Notes
    -----
    As :func:`thick_arc_factor`. What stiffens its bending stiffens none of its shear.

    Examples
    --------
    >>> round(float(thick_s_factor(h=0.3, l=1.0, b=1.0, poisson_ratio=0.3)), 3)
    1.073

    References
    ----------
    Derived here: bricks of the fourth order, small towards the edges of the clamps.

    """
    h_, l_, b_, nu = (np.asarray(each, dtype=np.float64) for each in (h, l, b, poisson_ratio))
    width = _S_SHAPE.width(h_, l_, b_, nu)
    plate = guided_factor(b=width, l=l_, poisson_ratio=nu)
    bent = _S_SHAPE.bent(plate, 6.0, h_, l_, nu)
    Phi = shear_parameter(depth=h_, l=l_, poisson_ratio=nu)
    sheared = Phi * (1.0 - (_EVEN + _EVEN_NU * nu) * h_ / l_)
    return np.asarray((1.0 + Phi) / (1.0 / bent + sheared))


def thick_error(
    factor: ArrayLike, *, h: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike
) -> Floats:
    """Return the error of a factor of a thick blade.

    ``min(7e-4 + 0.025 ν²/(1 − ν²), 0.2 (k − 1))``, less of thin ones, more beyond h = 0.3 l.

    Parameters
    ----------
    factor : array_like
        The factor [-].
    h, l : array_like
        Thickness and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    error : array
        To either side [-].

    Examples
    --------
    >>> round(float(thick_error(1.08, h=0.1, l=1.0, poisson_ratio=0.3)), 4)
    0.0032

    References
    ----------
    Measured here: solids of the fit and others (``tests/benchmarks/thick_plates.py``).

    """
    short = np.asarray(h, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    grown = 1.0 + GROWS * np.maximum(short / THICK - 1.0, 0.0)
    flat = OF_FLAT * np.minimum(short / THIN, 1.0) * bound(poisson_ratio)
    small = OF_SMALL * (np.asarray(factor, dtype=np.float64) - 1.0)
    return np.asarray(grown * np.minimum(FIT_ERROR + flat, small))


_BLADE = {"h": 2e-3, "l": 20e-3, "b": 20e-3, "poisson_ratio": 0.3}
_RANGES = (
    Range("b/h", least=1.0, why="a plate is no thicker than wide"),
    Range("h/l", most=THICKEST, why="no shorter solids were compared"),
)

CARDS = (
    Card("plate-thick-arc", thick_arc_factor, _BLADE, _RANGES),
    Card("plate-thick-s", thick_s_factor, _BLADE, _RANGES),
)
"""Thick wide blades: their increased stiffness against beams that shear."""
