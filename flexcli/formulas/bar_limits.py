"""Between which stiffnesses any straight bar between rigid clamps is, however short it is.

By the two theorems of least energy, with the stresses of beams and with sections that stay rigid:
of proportions of which nothing else is known.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Card, Range

__all__ = ["CARDS", "ROUND_FACTOR", "BarLimits", "bar_limits"]

Floats = NDArray[np.float64]


ROUND_FACTOR = 27.0 / 32.0
"""κ of a circle by the energy of ``τ_xz = V (a² − z²)/(3 I)``, ``τ_xy = −V y z/(3 I)``: in balance
with bending, along its rim at the rim."""


class BarLimits(NamedTuple):
    """The least and the most of the six springs at the middle, shape (6,): x, y, z, about them.

    They are in N/m and N·m/rad.
    """

    least: Floats
    most: Floats


def bar_limits(
    *,
    E: float,
    G: float,
    l: float,
    area: float,
    I_y: float,
    I_z: float,
    J: float,
    shear_factor: float = 0.0,
) -> BarLimits:
    """Return between which stiffnesses a bar of any length is between rigid clamps.

    ``E A/l``, ``1/(l³/(12 E I) + l/(κ G A))``, ``G J/l`` and ``E I/l`` at least; at most the same
    of ``M = G (4 G − E)/(3 G − E)`` in place of E, κ = 1 and J = I_y + I_z.

    Parameters
    ----------
    E, G : float
        Young's and shear modulus of an isotropic material [Pa].
    l : float
        Length [m].
    area, I_y, I_z : float
        Area [m²] and second moments about the main axes of the section [m⁴].
    J : float
        Saint-Venant's torsion constant, or less [m⁴].
    shear_factor : float
        κ by the energy of shear stresses that balance those of bending and leave the sides free,
        5/6 of a rectangle, 27/32 of a circle; 0 where none are known [-].

    Returns
    -------
    limits : BarLimits
        Shape (6,) each.

    Notes
    -----
    Small motion. Stresses in balance with themselves that leave the sides free store no less energy
    under given forces than the true ones; motions that clamps allow store no less at given ends.
    M is the modulus of what may not narrow, infinite at ν = ½. CalculiX's solids of h/l 0.4 to 0.8,
    b/l 0.5 to 1.5 and ν = 0.3 and 0.45 have 1.02 to 1.9 of the least and 0.29 to 0.87 of the most
    in every direction.

    Examples
    --------
    >>> limits = bar_limits(E=1.0, G=0.5, l=2.0, area=1.0, I_y=1.0, I_z=1.0, J=1.0)
    >>> float(limits.least[0]), float(limits.most[0])
    (0.5, 0.5)

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, sections 84 and 90 (theorems of least work).

    """
    nu = E / (2.0 * G) - 1.0
    held = E * (1.0 - nu) / ((1.0 + nu) * (1.0 - 2.0 * nu)) if nu < 0.5 else np.inf

    def springs(modulus: float, kappa: float, twisted: float) -> Floats:
        sheared = l / (kappa * G * area) if kappa else np.inf
        bent = (1.0 / (l**3 / (12.0 * modulus * I) + sheared) for I in (I_z, I_y))
        return np.array(
            [modulus * area / l, *bent, G * twisted / l, modulus * I_y / l, modulus * I_z / l]
        )

    return BarLimits(springs(E, shear_factor, J), springs(held, 1.0, I_y + I_z))


CARDS = (
    Card(
        "bar-limits",
        bar_limits,
        {"E": 114e9, "G": 42.5e9, "l": 30e-3, "area": 1e-6, "I_y": 1e-13, "I_z": 1e-13, "J": 1e-13},
        (Range("ν", least=-1.0, most=0.5, why="an isotropic material"),),
    ),
)
