"""Torsion bars as rotary joints: stiffness, shear stress, admissible rotation, arrangements."""

from math import sqrt

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "admissible_twist",
    "offset_bars_stiffness",
    "shear_stress",
    "torsional_stiffness",
]


def torsional_stiffness(*, G: Quantity, J: Quantity, l: Quantity, bars: int = 1) -> Computed:
    """Return the stiffness of torsion bars on one axis, free to warp, each from body to ground.

    ``K = n G J/l``: one bar, or two in line that hold the body between them.

    Parameters
    ----------
    G : Quantity
        Shear modulus [Pa].
    J : Quantity
        Torsion constant of the section [m⁴].
    l : Quantity
        Length of a bar [m].
    bars : int
        Number n of bars.

    Returns
    -------
    K : Quantity
        Rotational stiffness [N·m/rad].

    Notes
    -----
    Small twist per length, h φ' ≪ 1, and no axial force. Clamped ends that keep the section from
    warping stiffen it: see restrained-torsion.

    Examples
    --------
    >>> round(torsional_stiffness(G=80e9, J=1e-12, l=20e-3, bars=2), 9)
    8.0

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, chapter 10; Henein & Thalmann, lecture
    "Dimensioning of flexure joints", which names torsion bars without a formula.

    """
    return bars * G * J / l


def shear_stress(
    *, G: Quantity, h: Quantity, l: Quantity, theta: Quantity, factor: Quantity = 1.0
) -> Computed:
    """Return the largest shear stress of a torsion bar, at the middle of its broad sides.

    ``τ = k G h θ/l``; for a circle h is the diameter and k = ½.

    Parameters
    ----------
    G : Quantity
        Shear modulus [Pa].
    h, l : Quantity
        Thin side of the section and length [m].
    theta : Quantity
        Twist [rad].
    factor : Quantity
        Shear factor k of the section; 1 for a thin strip [-].

    Returns
    -------
    τ : Quantity
        Shear stress; the equivalent stress of von Mises is √3 τ [Pa].

    Notes
    -----
    Free warping; the clamped ends of a strip carry normal stress as well.

    Examples
    --------
    >>> round(shear_stress(G=80e9, h=0.5e-3, l=20e-3, theta=0.1) / 1e6, 6)
    200.0

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109.

    """
    return factor * G * h * theta / l


def admissible_twist(
    *, G: Quantity, h: Quantity, l: Quantity, sigma: Quantity, factor: Quantity = 1.0
) -> Computed:
    """Return the twist at which von Mises' equivalent stress of a torsion bar is admissible.

    ``θ = σ l/(√3 k G h)``.

    Parameters
    ----------
    G : Quantity
        Shear modulus [Pa].
    h, l : Quantity
        Thin side of the section and length [m].
    sigma : Quantity
        Admissible equivalent stress [Pa].
    factor : Quantity
        Shear factor k of the section; 1 for a thin strip, ½ for a circle of diameter h [-].

    Returns
    -------
    θ : Quantity
        Admissible twist [rad].

    Notes
    -----
    Free warping, no stress concentration at the roots.

    Examples
    --------
    >>> round(admissible_twist(G=80e9, h=0.5e-3, l=20e-3, sigma=400e6), 6)
    0.11547

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109, with √3 τ = σ.

    """
    return sigma * l / (sqrt(3.0) * factor * G * h)


def offset_bars_stiffness(
    *, E: Quantity, G: Quantity, I: Quantity, J: Quantity, l: Quantity, r: Quantity, bars: int
) -> Computed:
    """Return the stiffness of separate bars that stand around the axis of rotation, parallel to it.

    ``K = n (G J/l + 12 E I r²/l³)``: each bar twists by θ and is swung sideways by r θ.

    Parameters
    ----------
    E, G : Quantity
        Young's and shear modulus [Pa].
    I : Quantity
        Second moment of a section for bending around the axis, b h³/12 where b is radial [m⁴].
    J : Quantity
        Torsion constant of a section [m⁴].
    l : Quantity
        Length of a bar [m].
    r : Quantity
        Distance of the bars from the axis [m].
    bars : int
        Number n of bars.

    Returns
    -------
    K : Quantity
        Rotational stiffness [N·m/rad].

    Notes
    -----
    Small rotation, slender bars, free warping. The body turns about the axis alone, as bars
    spread evenly around it make it.

    Examples
    --------
    >>> K = offset_bars_stiffness(E=200e9, G=80e9, I=1e-13, J=4e-13, l=20e-3, r=5e-3, bars=4)
    >>> round(K, 9)
    9.4

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    return bars * (G * J / l + 12.0 * E * I * r**2 / l**3)


THIN_TWIST = Range("h θ/l", most=0.1, why="twist per length beyond this stretches the fibres")

CARDS: tuple[Card, ...] = (
    Card(
        name="torsion-bar-stiffness",
        function=torsional_stiffness,
        example={"G": 42.5e9, "J": 2e-13, "l": 20e-3, "bars": 2},
    ),
    Card(
        name="torsion-bar-stress",
        function=shear_stress,
        example={"G": 42.5e9, "h": 0.5e-3, "l": 20e-3, "theta": 0.1},
        validity=(THIN_TWIST,),
        kind=QuantityKind.STRESS,
    ),
    Card(
        name="torsion-bar-admissible-twist",
        function=admissible_twist,
        example={"G": 42.5e9, "h": 0.5e-3, "l": 20e-3, "sigma": 400e6},
        validity=(THIN_TWIST,),
        kind=QuantityKind.STRESS,
    ),
)

OFFSET_CARDS: tuple[Card, ...] = (
    Card(
        name="torsion-bars-around-an-axis",
        function=offset_bars_stiffness,
        example={
            "E": 114e9,
            "G": 42.5e9,
            "I": 5.2e-14,
            "J": 2e-13,
            "l": 2e-2,
            "r": 5e-3,
            "bars": 4,
        },
        validity=(Range("h/l", most=0.1, why="shear left out"),),
    ),
)
