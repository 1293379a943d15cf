"""Pivots made of n equal blades whose centre lines meet in one point.

δ = p/l places that point: p is the distance from it to the near (inner) end of each blade, so
δ > 0 is a remote centre of compliance, δ = −½ the symmetric cross-spring pivot. All of it is for
small rotation of slender blades (h ≪ l, shear and axial extension left out); the rotations at
which the closed forms are 1 and 5 % off were measured with the exact solver by
``tests/benchmarks/closed_form_limits.py``, which prints other half-angles and kinds as well.
"""

from collections.abc import Callable
from math import pi, radians

import numpy as np

from flexcli.formulas.card import SLENDER, Card, Range, Table
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.section import second_moment
from flexcli.numerics.rows import atan2, cos, sin, sqrt
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "LIMITS",
    "SHIFT_LIMITS",
    "SHIFT_TURN",
    "STIFFNESS_LIMITS",
    "STIFF_TURN",
    "STRESS_LIMITS",
    "STRESS_TURN",
    "SYMMETRIC_CARDS",
    "WITTRICK",
    "admissible_rotation",
    "axial_share",
    "end_stresses",
    "out_of_plane_stiffness",
    "parasitic_shift",
    "rotational_stiffness",
    "stiffness_ratio",
    "stroke_ratio",
]


def rotational_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, p: Quantity, blades: int = 2
) -> Computed:
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
) -> tuple[Computed, Computed]:
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


def parasitic_shift(*, l: Quantity, p: Quantity, theta: Quantity, half_angle: float) -> Computed:
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
) -> Computed:
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


_NONE = 60.0
"""Printed where the closed form is not that far off up to 60°, the end of the measurement."""

LIMITS: dict[float, tuple[tuple[float, float], ...]] = {
    -1.0: ((10.4, 24.2), (6.52, _NONE), (_NONE, _NONE)),
    -0.75: ((10.1, 22.7), (2.40, 12.3), (13.9, 31.3)),
    -0.5: ((8.12, 18.4), (1.15, 5.83), (12.3, 27.9)),
    -0.25: ((10.1, 22.7), (2.40, 12.3), (9.39, 21.2)),
    0.0: ((10.4, 24.2), (6.52, _NONE), (6.64, 14.9)),
    0.25: ((4.89, 11.3), (17.0, 51.9), (5.50, 12.4)),
    0.5: ((3.37, 7.78), (7.51, 29.1), (4.61, 10.5)),
    1.0: ((2.13, 4.92), (1.88, 13.1), (3.47, 7.91)),
}
"""By δ at α = 45°: degrees at which (1 %, 5 %) of tangent stiffness, stress, shift are missed."""


def _limit(number: int, share: int) -> Callable[[float], float]:
    return lambda delta: radians(LIMITS[delta][number][share])


def _table(number: int) -> Table:
    columns = {
        "theta at 1 %": ("rad", _limit(number, 0)),
        "theta at 5 %": ("rad", _limit(number, 1)),
    }
    note = "α = 45°, slender blades, by the exact solver; 60° stands for no such angle up to there"
    return Table("delta", tuple(LIMITS), columns, note)


STIFFNESS_LIMITS, STRESS_LIMITS, SHIFT_LIMITS = (_table(number) for number in range(3))

STIFF_TURN = Range(
    "theta",
    most=radians(4.0),
    unit="rad",
    why="tangent stiffness within 5 % for δ from −1 to 1 and α from 30° to 60°; 10.6° for δ from "
    "−1 to 0, where it is within 1 % up to 4.7°",
)

STRESS_TURN = Range(
    "theta",
    most=radians(2.7),
    unit="rad",
    why="true stress at most 5 % higher for δ from −1 to 1 and α from 30° to 60° (worst for δ = 1 "
    "and for −½ at 60°); the excess grows with θ itself, on the unsafe side",
)

SHIFT_TURN = Range(
    "theta",
    most=radians(7.0),
    unit="rad",
    why="shift within 5 % for δ from −0.75 to 1 and α from 30° to 60° but near Wittrick's "
    "crossings, where the next order in θ rules",
)


WITTRICK = (sqrt(45.0) - 9.0) / 18.0
"""δ = −0.1273… at which the leading term of the parasitic shift vanishes: 9δ² + 9δ + 1 = 0."""


def admissible_rotation(
    *, E: float, h: Quantity, l: Quantity, p: Quantity, stress: float
) -> Computed:
    """Return the rotation at which the larger of the two end stresses reaches a given one.

    ``θ = σ l / (E h max(|2 + 3δ|, |1 + 3δ|))``. Both ends count: the course's formula takes the
    inner one, which is the larger for δ > −½ only.

    Parameters
    ----------
    E : float
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length of a blade [m]; floats or arrays.
    p : Quantity
        Distance from the centre to the inner ends [m], negative when the blades cross.
    stress : float
        Admissible stress σ [Pa].

    Returns
    -------
    theta : Quantity
        Admissible rotation [rad].

    Examples
    --------
    >>> theta = admissible_rotation(E=1.0, h=1.0, l=50.0, p=-25.0, stress=4e-3)
    >>> round(float(theta), 6)
    0.4

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", generalised cross-spring pivot
    (inner end).

    """
    inner, outer = end_stresses(E=E, h=h, l=l, p=p, theta=1.0)
    return stress / np.maximum(np.abs(inner), np.abs(outer))


def stiffness_ratio(delta: Quantity) -> Computed:
    """Return the stiffness of a cross-spring pivot over that of the symmetric one.

    ``4 (3δ² + 3δ + 1)``, for the same blades: 2.667 at Wittrick's crossing, where the course
    prints about 3.3.

    Parameters
    ----------
    delta : Quantity
        δ = p/l [-].

    Returns
    -------
    ratio : Quantity
        Ratio of stiffness, 1 at δ = −½ [-].

    Examples
    --------
    >>> round(stiffness_ratio(WITTRICK), 4)
    2.6667

    References
    ----------
    From the stiffness in Henein & Thalmann, lecture "Dimensioning of flexure joints".

    """
    return 4.0 * (3.0 * delta * (delta + 1.0) + 1.0)


def stroke_ratio(delta: Quantity) -> Computed:
    """Return the admissible rotation of a cross-spring pivot over that of the symmetric one.

    ``½ / max(|2 + 3δ|, |1 + 3δ|)``, for the same blades and stress: 1/3.236 at Wittrick's
    crossing, where the course prints 1/3.2.

    Parameters
    ----------
    delta : Quantity
        δ = p/l [-].

    Returns
    -------
    ratio : Quantity
        Ratio of admissible rotations, 1 at δ = −½ [-].

    Examples
    --------
    >>> round(float(1.0 / stroke_ratio(WITTRICK)), 4)
    3.2361

    References
    ----------
    From the stress in Henein & Thalmann, lecture "Dimensioning of flexure joints".

    """
    return 0.5 / np.maximum(np.abs(2.0 + 3.0 * delta), np.abs(1.0 + 3.0 * delta))


_DELTA = Table(
    variable="delta",
    values=tuple(sorted((WITTRICK, -1.0 - WITTRICK, *(n / 10.0 for n in range(-15, 11))))),
    columns={
        "K l/(E I)": ("", lambda delta: 8.0 * (3.0 * delta * (delta + 1.0) + 1.0)),
        "theta_max": (
            "rad",
            lambda delta: admissible_rotation(E=1.0, h=1.0, l=50.0, p=50.0 * delta, stress=4e-3),
        ),
        "shift/l": (
            "",
            lambda delta: parasitic_shift(l=1.0, p=delta, theta=pi / 12.0, half_angle=pi / 4.0),
        ),
        "stiffness ratio": ("", stiffness_ratio),
        "stroke ratio": ("", stroke_ratio),
    },
    note="σ/E = 0.4 %, l/h = 50; shift at 15° with α = 45°; ratios to δ = −½. Where the shift's "
    "leading term vanishes (δ = −0.1273, −0.8727) the next order in θ rules",
)


CARDS: tuple[Card, ...] = (
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
)

ALONG_CARDS: tuple[Card, ...] = (
    Card(
        "stiffness-along-the-axis",
        out_of_plane_stiffness,
        {"E": 116e9, "h": 250e-6, "l": 80e-3, "b": 30e-3, "blades": 3},
        (Range("b/l", most=0.2, why="shear across the width takes more than a tenth"),),
        kind=QuantityKind.SAG,
    ),
)


SYMMETRIC_CARDS: tuple[Card, ...] = (
    Card(
        "pivot-stroke",
        admissible_rotation,
        {"E": 114e9, "h": 637e-6, "l": 17.5e-3, "p": 2e-3, "stress": 200e6},
        (SLENDER, STRESS_TURN),
        {"delta": _DELTA},
        kind=QuantityKind.STRESS,
    ),
    Card("stiffness-over-symmetric", stiffness_ratio, {"delta": WITTRICK}),
    Card("stroke-over-symmetric", stroke_ratio, {"delta": WITTRICK}),
)
