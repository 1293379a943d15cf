"""A bar whose section is strips that cross, between rigid clamps: six springs with their errors."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.clamped_blade import ClampedSprings, clamped_blade
from flexcli.formulas.torsion_shapes import (
    SHORT_ARM,
    star_area,
    star_arm,
    star_core_error,
    star_polar_moment,
    star_torsion_constant,
)

__all__ = ["CARDS", "OF_STARS", "STRESSED", "clamped_star", "stiffer_across"]

Floats = NDArray[np.float64]

OF_STARS = (
    Range("b/l", most=0.9, why="wider stars were not compared with solids"),
    Range("h/b", most=0.33, why="thicker strips were not compared with solids"),
    SHORT_ARM,
    Range("strips", least=2.0, most=6.0, why="more strips were not compared with solids"),
    Range("ν", most=0.45, why="no other was compared with solids"),
)
"""Stars whose springs were compared with those of CalculiX's solids."""

STRESSED = 0.2
"""Largest h/b of stars whose stress was compared with that of solids."""

SOFTER, STIFFER = 0.01, 0.05
"""How far springs are off at most: CalculiX's solids had up to 0.031 more, nothing less
(``tests/benchmarks/stars_in_space.py``)."""

SHEARED, SHORT = 0.05, 0.5
"""How much stiffer a star is across besides, at most, and from which b/l on: the roots between its
arms shear less than each strip does by itself, and solids had up to 0.079 more."""


def clamped_star(
    *, E: float, G: float, h: float, l: float, b: float, strips: int
) -> ClampedSprings:
    """Return the six springs of a bar of strips that cross on its axis, its ends free to warp.

    ``k_x = n k_x1 A/(n h b)``, ``k_y = k_z = ½ n (k_z1 + k_y1) I/I_n``,
    ``k_θx = G J/l``, ``k_θy = k_θz = ½ n (k_θy1 + k_θz1) I/I_n`` with the springs k_·1 of one
    strip between clamps (``clamped-blade``).

    Parameters
    ----------
    E, G : float
        Young's and shear modulus [Pa].
    h, b : float
        Thickness and full width of a strip, edge to edge [m].
    l : float
        Length of the bar [m].
    strips : int
        Number n of strips, at even angles.

    Returns
    -------
    ClampedSprings
        Stiffness with errors, shape (6,); alike across in all directions.

    Notes
    -----
    Each strip is a sheet of its own, bent and sheared across its width by the part of the motion
    along it, ½ of n of them; what strips have in common is counted once in area and second moment
    I, beside n h b and I_n of strips by themselves. Torsion is Saint-Venant's.

    Examples
    --------
    >>> k = clamped_star(E=2.6, G=1.0, h=0.002, l=1.0, b=0.1, strips=2)
    >>> round(float(k.stiffness[5] / (2.6 * 0.002 * 0.1**3 / 12.0)), 2)
    1.0

    References
    ----------
    Derived here: the sheets of ``clamped-blade`` in one section.

    """
    one = clamped_blade(E=E, G=G, h=h, l=l, b=b)
    x, y, z, _, about_y, about_z = one.stiffness
    J = float(star_torsion_constant(h, b, strips))
    area = float(star_area(h, b, strips)) / (strips * h * b)
    bent = float(star_polar_moment(h, b, strips)) / (strips * h * b * (h**2 + b**2) / 12.0)
    across, about = strips / 2.0 * (y + z) * bent, strips / 2.0 * (about_y + about_z) * bent
    stiffness = np.array([strips * x * area, across, across, G * J / l, about, about])
    core = star_core_error(float(star_arm(h, b, strips)), strips) * h**4 / J
    low, high = np.full(6, -SOFTER), np.full(6, STIFFER)
    low[3], high[3] = -core, core
    high[1:3] += stiffer_across(b / l)
    return ClampedSprings(stiffness, low, high)


def stiffer_across(wide: float) -> float:
    """Return how much stiffer across a star of a width over length may be than its strips say."""
    return SHEARED * min(wide / SHORT, 1.0)


CARDS = (
    Card(
        "clamped-star",
        clamped_star,
        {"E": 114e9, "G": 42.5e9, "h": 0.25e-3, "l": 30e-3, "b": 5e-3, "strips": 2},
        OF_STARS,
    ),
)
