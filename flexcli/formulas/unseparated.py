"""Two crossed blades joined where they cross: two pivots of p = 0, one after the other."""

from math import pi, radians

from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.section import second_moment
from flexcli.numerics.rows import cos
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "unseparated_shift",
    "unseparated_stiffness",
    "unseparated_stresses",
]


def unseparated_stiffness(*, E: Quantity, h: Quantity, l: Quantity, b: Quantity) -> Computed:
    """Return the rotational stiffness of two crossed blades that are joined where they cross.

    ``K = 8EI/l`` wherever they cross: two pivots of p = 0 in series, of blades c l and (1 − c) l.
    The same blades separated and crossing at half their length have 2EI/l, a quarter of it.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length from end to end, and width of a blade [m].

    Returns
    -------
    K : Quantity
        Rotational stiffness [N·m/rad].

    Notes
    -----
    The body where the blades cross is taken as small and rigid; it turns by c θ.

    Examples
    --------
    >>> unseparated_stiffness(E=1.0, h=1.0, l=12.0, b=12.0)
    0.6666666666666666

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", unseparated cross spring pivot.

    """
    return 8.0 * E * second_moment(b, h) / l


def unseparated_stresses(
    *, E: Quantity, h: Quantity, l: Quantity, theta: Quantity
) -> tuple[Computed, Computed]:
    """Return the bending stress at the crossing and at the ends of joined crossed blades.

    ``σ_crossing = 2 E h θ/l``, ``σ_ends = E h θ/l``, wherever the blades cross: four times the
    ½ E h θ/l of the same blades separated and crossing at half their length.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length from end to end of a blade [m].
    theta : Quantity
        Rotation of the pivot [rad].

    Returns
    -------
    crossing, ends : Quantity
        Bending stress at this place [Pa].

    Examples
    --------
    >>> unseparated_stresses(E=1.0, h=1.0, l=10.0, theta=0.1)
    (0.02, 0.01)

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", unseparated cross spring pivot.

    """
    curvature = E * h * theta / l
    return 2.0 * curvature, curvature


def unseparated_shift(
    *, l: Quantity, crossing: float, theta: Quantity, half_angle: float
) -> Computed:
    """Return the shift of the centre of joined crossed blades along the bisector, leading order.

    ``PP' = (c³ + (1 − c)³) θ² l / (15 cos α)``: each side shifts like a pivot of p = 0, length
    c l and rotation c θ, and the two add.

    Parameters
    ----------
    l : Quantity
        Length of a blade from end to end [m].
    crossing : float
        Share c of that length on the side of the base [-].
    theta : Quantity
        Rotation [rad].
    half_angle : float
        Half the angle between the blades [rad].

    Returns
    -------
    shift : Quantity
        Shift along the bisector [m].

    Examples
    --------
    >>> round(60.0 * unseparated_shift(l=1.0, crossing=0.5, theta=1.0, half_angle=0.0), 12)
    1.0

    References
    ----------
    Twice :func:`flexcli.formulas.pivot.parasitic_shift`, with the length and rotation of a side.

    """
    sides = crossing**3 + (1.0 - crossing) ** 3
    return sides * l * (theta**2 / (15.0 * cos(half_angle)))


_BLADE = {"E": 114e9, "h": 637e-6, "l": 17.5e-3}

_STIFF_TURN = Range(
    "theta",
    most=radians(17.0),
    unit="rad",
    why="stiffness 1 % off at 17° (crossing 0.3) and 21° (0.5), 5 % at 40° and 48°; α = 45°",
)
_STRESS_TURN = Range(
    "theta",
    most=radians(9.0),
    unit="rad",
    why="true stress 1 % higher at 9° (crossing 0.3) and 13° (0.5), never 5 % up to 60°; α = 45°",
)
_SHIFT_TURN = Range(
    "theta",
    most=radians(16.5),
    unit="rad",
    why="shift 5 % off at 16.5° (crossing 0.3) and 23° (0.5), 1 % at 7.4° and 10.3°; α = 45°",
)

CARDS = (
    Card(
        "unseparated-stiffness",
        unseparated_stiffness,
        {**_BLADE, "b": 10e-3},
        (SLENDER, _STIFF_TURN),
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "unseparated-stress",
        unseparated_stresses,
        {**_BLADE, "theta": 0.0205},
        (SLENDER, _STRESS_TURN),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "unseparated-shift",
        unseparated_shift,
        {"l": 17.5e-3, "crossing": 0.5, "theta": 0.0205, "half_angle": pi / 4.0},
        (_SHIFT_TURN,),
        kind=QuantityKind.SHIFT,
    ),
)
