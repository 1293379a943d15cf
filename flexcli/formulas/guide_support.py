"""Stiffness of a leaf-spring guide across its motion, over the stroke."""

from typing import NamedTuple

import numpy as np

from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.quantity import Computed, Numbers
from flexcli.formulas.section import second_moment
from flexcli.formulas.torsion_section import torsion_constant, warping

__all__ = ["CARDS", "Stiffening", "lateral_stiffness", "twist_share", "twist_stiffening"]


def twist_share(*, held: Numbers) -> Computed:
    """Return the twist that a lateral force costs a blade bent to an S, ends kept from warping.

    ``c = 1/28 + 6/(5p²) − (4 + 96/p²)((1/(8p) + 3/p³) coth(p/2) − 3/(4p²) − 6/p⁴)``: the force F
    in the middle of the blade twists its section ξ = s/l by the torque ``4 F x (ξ − ½)³``, and its
    rate of twist τ follows ``τ − l²τ''/p² = torque/GJ`` with τ = 0 at both ends.

    Parameters
    ----------
    held : Quantity
        p, the length over that in which warping decays, ``l √(GJ (1 − s)/(E'Γ))`` [-].

    Returns
    -------
    share : Quantity
        Compliance over x² l/(GJ): 1/28 where ends may warp, p → ∞ [-].

    Notes
    -----
    Below p = 1 (b > 4 l) the terms cancel: four digits are left at p = 0.1.

    Examples
    --------
    >>> round(1.0 / float(twist_share(held=1e4)), 1), round(1.0 / float(twist_share(held=8.0)), 1)
    (28.0, 114.5)

    References
    ----------
    Own derivation.

    """
    p = held
    tail = (1.0 / (8.0 * p) + 3.0 / p**3) / np.tanh(p / 2.0) - 3.0 / (4.0 * p**2) - 6.0 / p**4
    return 1.0 / 28.0 + 1.2 / p**2 - (4.0 + 96.0 / p**2) * tail


def lateral_stiffness(
    *,
    h: Numbers,
    b: Numbers,
    l: Numbers,
    x: Numbers,
    youngs_modulus: float,
    shear_modulus: float,
    blades: int,
) -> Computed:
    """Return the stiffness of a leaf-spring guide along the width of its blades, at a stroke.

    ``k = n/(l³/(12 E I) + 6 l/(5 G A) + x² l (c (1 − s)/(GJ) + 1/(28 G I_p)))``, I of bending in
    the plane of a blade, J and Γ of its torsion, ``s = J/I_p``, c as ``twist_share``.

    Parameters
    ----------
    h, b, l : Quantity
        Thickness, width and length of a blade [m].
    x : Quantity
        Travel of the stage, along the thickness of the blades [m].
    youngs_modulus, shear_modulus : float
        E and G, ν = E/2G − 1 [Pa].
    blades : int
        n, of equal blades.

    Returns
    -------
    stiffness : Quantity
        At the middle of the blades, the drive locked, the stage free to move besides [N/m].

    Notes
    -----
    There a lateral force turns the stage about no axis, for a blade bent to an S is itself when
    turned by half a turn about its middle. Clamps are rigid and keep blades from warping
    (Benscoter's torsion, E' = E/(1 − ν²)); plates, and the flattening of the curved section, are
    left out: exact beams in space that have them are between 1 % less and 22 % more stiff over
    x/l to 0.2, b/l 0.1 to 0.8, b/h 20 to 200 at ν = 0.3; those that leave them out too are
    within 1 %.

    Examples
    --------
    >>> guide = {"h": 0.5e-3, "b": 50e-3, "l": 0.1, "blades": 2}
    >>> steel = {"youngs_modulus": 190e9, "shear_modulus": 73e9}
    >>> [round(float(lateral_stiffness(**guide, **steel, x=x)) / 1e6, 2) for x in (0.0, 20e-3)]
    [13.34, 0.79]

    References
    ----------
    Own derivation. The same subject: Nijenhuis, Meijaard, Mariappan, Herder, Brouwer and Awtar
    (2017), An Analytical Formulation for the Lateral Support Stiffness of a Spatial Flexure Strip.

    """
    E, G = youngs_modulus, shear_modulus
    nu = E / (2.0 * G) - 1.0
    J, polar = torsion_constant(h, b), second_moment(b, h) + second_moment(h, b)
    apart, held = _held(E=E, G=G, poisson_ratio=nu, h=h, b=b, l=l)
    bent = l**3 / (12.0 * E * second_moment(h, b)) + 1.2 * l / (G * b * h)
    twisted = apart * twist_share(held=held) / (G * J) + 1.0 / (28.0 * G * polar)
    return blades / (bent + x**2 * l * twisted)


class Stiffening(NamedTuple):
    """How many times as stiff a blade is in torsion, its ends kept flat [-]."""

    twisted: Computed
    """By a torque at its ends."""
    bent: Computed
    """Bent to an S, by the torque of a force across it."""


def twist_stiffening(
    *, E: Numbers, G: Numbers, poisson_ratio: Numbers, h: Numbers, b: Numbers, l: Numbers
) -> Stiffening:
    """Return by what factor clamps that keep its ends from warping stiffen a blade's torsion.

    ``1/(s + (1 − s)(1 − 2 tanh(p/2)/p))`` by a torque at its ends, ``1/(28 c (1 − s) + s)`` bent
    to an S, with s = J/I_p, c and p as ``twist_share``.

    Parameters
    ----------
    E, G, poisson_ratio : Quantity
        Young's and shear modulus [Pa] and ν [-].
    h, b, l : Quantity
        Thickness, width and length [m].

    Returns
    -------
    twisted, bent : Quantity
        Stiffness over that of a blade whose ends may warp [-].

    Notes
    -----
    Small twist, sections that do not curl. Other distributions of a torque that changes sign along
    the blade are held up less than that of the S, which sits at the clamps.

    Examples
    --------
    >>> blade = {"h": 0.5e-3, "b": 50e-3, "l": 0.1}
    >>> found = twist_stiffening(E=190e9, G=73e9, poisson_ratio=0.3, **blade)
    >>> round(float(found.twisted), 2), round(float(found.bent), 2)
    (1.32, 3.99)

    References
    ----------
    Own derivation, of Benscoter's torsion.

    """
    apart, p = _held(E=E, G=G, poisson_ratio=poisson_ratio, h=h, b=b, l=l)
    fades = 1.0 - 2.0 * np.tanh(p / 2.0) / p
    return Stiffening(
        1.0 / (1.0 - apart + apart * fades),
        1.0 / (1.0 - apart + 28.0 * apart * twist_share(held=p)),
    )


def _held(
    *, E: Numbers, G: Numbers, poisson_ratio: Numbers, h: Numbers, b: Numbers, l: Numbers
) -> tuple[Computed, Computed]:
    """Return 1 − J/I_p and p, the length over that in which warping decays [-]."""
    J, polar = torsion_constant(h, b), second_moment(b, h) + second_moment(h, b)
    apart = 1.0 - J / polar
    modulus = E / (1.0 - poisson_ratio**2)
    return apart, l * np.sqrt(G * J * apart / (modulus * warping(h, b).constant))


_GUIDE = {"h": 0.5e-3, "b": 50e-3, "l": 0.1, "x": 20e-3, "blades": 2}

CARDS: tuple[Card, ...] = (
    Card("lateral-twist-share", twist_share, {"held": 8.0}),
    Card(
        "guide-lateral-stiffness",
        lateral_stiffness,
        {**_GUIDE, "youngs_modulus": 190e9, "shear_modulus": 73e9},
        (
            SLENDER,
            Range("b/l", least=0.1, most=0.8, why="others were not compared"),
            Range("x/l", most=0.2, why="longer strokes were not compared"),
        ),
    ),
)
