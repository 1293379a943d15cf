"""Pivots made of n equal blades whose centre lines meet in one point.

δ = p/l places that point: p is the distance from it to the near (inner) end of each blade, so
δ > 0 is a remote centre of compliance, δ = −½ the symmetric cross-spring pivot. All of it is for
small rotation of slender blades (h ≪ l, shear and axial extension left out).
"""

from math import atan2, cos, pi, sin

from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.pivot_limits import (
    SHIFT_LIMITS,
    SHIFT_TURN,
    STIFF_TURN,
    STIFFNESS_LIMITS,
    STRESS_LIMITS,
    STRESS_TURN,
)
from flexcli.formulas.quantity import Quantity
from flexcli.formulas.section import second_moment
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "axial_share",
    "end_stresses",
    "out_of_plane_stiffness",
    "parasitic_shift",
    "rotational_stiffness",
]


def rotational_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, p: Quantity, blades: int = 2
) -> Quantity:
    """Return the rotational stiffness of n blades whose centre lines meet in one point.

    ``K = n 4EI/l (1 + 3δ + 3δ²)`` with ``I = b h³/12`` and ``δ = p/l``: for two blades
    ``8EI/l (3δ² + 3δ + 1)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m]; broadcast.
    p : Quantity
        Distance from the centre to the inner ends [m], negative when the blades cross.
    blades : int
        Number of blades.

    Returns
    -------
    K : Quantity
        Rotational stiffness [N·m/rad], positive for every p.

    Notes
    -----
    Small rotation; h/l below about 1/10.

    Examples
    --------
    >>> round(rotational_stiffness(E=114e9, h=637e-6, l=17.5e-3, b=10e-3, p=2e-3), 2)
    15.51

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", generalised cross-spring pivot;
    Zhao & Bi (2010), Mechanism and Machine Theory 45.

    """
    return blades * 4.0 * E * second_moment(b, h) / l * (1.0 + 3.0 * p / l + 3.0 * (p / l) ** 2)


def end_stresses(
    *, E: Quantity, h: Quantity, l: Quantity, p: Quantity, theta: Quantity
) -> tuple[Quantity, Quantity]:
    """Return the bending stress at the inner and at the outer end of each blade, with its sign.

    ``σ_inner = E h θ/l (2 + 3δ)``, ``σ_outer = E h θ/l (1 + 3δ)``. The larger magnitude decides:
    the inner end for δ > −½, the outer end below. The course's one-ended formula (inner end)
    turns negative below δ = −⅔.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m], negative when the blades cross.
    theta : Quantity
        Rotation of the pivot [rad].

    Returns
    -------
    inner, outer : Quantity
        Stress at this end [Pa].

    Notes
    -----
    Small rotation. From the end moments 4EIφ/l − 6EIw/l² and 2EIφ/l − 6EIw/l² of a beam whose
    far end turns by φ = θ and moves by w = θ (l + p).

    Examples
    --------
    >>> inner, outer = end_stresses(E=114e9, h=637e-6, l=17.5e-3, p=2e-3, theta=0.0205)
    >>> round(inner / 1e6, 1), round(outer / 1e6, 1)
    (199.3, 114.2)

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints" (inner end); exercise 9 part II,
    equation (1).

    """
    curvature = E * h * theta / l
    return curvature * (2.0 + 3.0 * p / l), curvature * (1.0 + 3.0 * p / l)


def parasitic_shift(*, l: Quantity, p: Quantity, theta: Quantity, half_angle: float) -> Quantity:
    """Return the shift of the centre of a pivot of two blades, leading order in θ, with its sign.

    ``PP' = (9δ² + 9δ + 1) θ² l / (15 cos α)``. The bracket vanishes at Wittrick's crossing
    (δ = −0.1273 and −0.8727), where the next order in θ rules.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : float
        Half the angle between the blades [rad], 0 < α < π/2.

    Returns
    -------
    shift : Quantity
        Shift along the bisector [m].

    Examples
    --------
    >>> f"{parasitic_shift(l=1.0, p=0.0, theta=0.1, half_angle=0.0):.6f}"
    '0.000667'

    References
    ----------
    Zhao & Bi (2010), Mechanism and Machine Theory 45(10); the course's lecture.

    """
    delta = p / l
    return (9.0 * delta**2 + 9.0 * delta + 1.0) * l * (theta**2 / (15.0 * cos(half_angle)))


def axial_share(angles: tuple[float, ...], direction: float) -> tuple[float, ...]:
    """Return the axial force in each blade for a unit force on the pivot in its plane.

    ``N_i = u_iᵀ (Σ u uᵀ)⁻¹ f``: blades of equal axial stiffness share the force; for two blades
    at ±α this is equilibrium alone, ``N = (cos φ/cos α ± sin φ/sin α)/2``.

    Parameters
    ----------
    angles : tuple of float
        Direction of each blade from the bisector [rad].
    direction : float
        Direction of the force from the bisector [rad].

    Returns
    -------
    shares : tuple of float
        Axial force of each blade over the force on the pivot [-].

    Raises
    ------
    ValueError
        When all blades are parallel, so that no axial force balances the load.

    Examples
    --------
    >>> from math import pi
    >>> [round(n, 4) for n in axial_share((pi / 4, -pi / 4), 0.0)]
    [0.7071, 0.7071]

    References
    ----------
    Least strain energy of a statically indeterminate truss, e.g. Przemieniecki (1968), Theory of
    Matrix Structural Analysis.

    """
    # Σ u uᵀ has its axes along half the argument of Σ exp(2iα); sums of squares about them keep
    # the digits of a small half-angle, which n/2 ± |Σ exp(2iα)|/2 would lose
    real = sum(cos(2.0 * a) for a in angles)
    imaginary = sum(sin(2.0 * a) for a in angles)
    axis = atan2(imaginary, real) / 2.0
    strong, weak = sum(cos(a - axis) ** 2 for a in angles), sum(sin(a - axis) ** 2 for a in angles)
    if weak < 1e-12 * strong:
        raise ValueError("parallel blades cannot balance a force across them by axial force")
    along, across = cos(direction - axis) / strong, sin(direction - axis) / weak
    return tuple(along * cos(a - axis) + across * sin(a - axis) for a in angles)


def out_of_plane_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, blades: int
) -> Quantity:
    """Return the stiffness along the pivot's axis of n blades, both ends kept from turning.

    ``K_z = n E h b³ / l³``: each blade bends across its width between a fixed end and a body
    that moves along the axis without tilting, as three or more blades around the axis make it.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m].
    blades : int
        Number of blades.

    Returns
    -------
    K_z : Quantity
        Stiffness along the axis [N/m].

    Notes
    -----
    Shear is left out; it lowers K_z by about (6/5)(b/l)² 2(1+ν)/(1 + that), which is a tenth at
    b/l = 0.2.

    Examples
    --------
    >>> f"{out_of_plane_stiffness(E=116e9, h=250e-6, l=80e-3, b=30e-3, blades=3):.3g}"
    '4.59e+06'

    References
    ----------
    Exercise 12 B, equation (3).

    """
    return blades * E * h * b**3 / l**3


_BLADE = {"E": 114e9, "h": 637e-6, "l": 17.5e-3, "p": 2e-3}

CARDS = (
    Card(
        "pivot-stiffness",
        rotational_stiffness,
        {**_BLADE, "b": 10e-3, "blades": 2},
        (SLENDER, STIFF_TURN),
        {"stiffness-limits": STIFFNESS_LIMITS},
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "pivot-stress",
        end_stresses,
        {**_BLADE, "theta": 0.0205},
        (SLENDER, STRESS_TURN),
        {"stress-limits": STRESS_LIMITS},
        kind=QuantityKind.STRESS,
    ),
    Card(
        "pivot-shift",
        parasitic_shift,
        {"l": 17.5e-3, "p": 2e-3, "theta": 0.0205, "half_angle": pi / 4.0},
        (SHIFT_TURN,),
        {"shift-limits": SHIFT_LIMITS},
        kind=QuantityKind.SHIFT,
    ),
    Card("blade-shares", axial_share, {"angles": (pi / 4.0, -pi / 4.0), "direction": 0.0}),
    Card(
        "stiffness-along-the-axis",
        out_of_plane_stiffness,
        {"E": 116e9, "h": 250e-6, "l": 80e-3, "b": 30e-3, "blades": 3},
        (Range("b/l", most=0.2, why="shear across the width takes more than a tenth"),),
    ),
)
