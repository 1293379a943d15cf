"""RCC and cross pivots of rigid limbs with a hinge at each end, aimed at one centre.

δ = p/l places the centre: p is the distance from it to the inner hinge of each limb, l that
between the hinges; δ ≥ 0 is a remote centre of compliance, δ = −½ the symmetric cross pivot.
"""

import numpy as np

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.numerics.rows import cos
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "admissible_rotation",
    "hinge_rotations",
    "parasitic_shift",
    "rotational_stiffness",
]


def hinge_rotations(*, l: Quantity, p: Quantity, theta: Quantity) -> tuple[Computed, Computed]:
    """Return the rotation of the inner and of the outer hinge of each limb of a turned pivot.

    ``φ_inner = (1 + δ) θ``, ``φ_outer = −δ θ``: the limb itself turns by (1 + δ) θ when its inner
    hinge is on the fixed body, by −δ θ when it is on the moving one.

    Parameters
    ----------
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m], p
        negative when the limbs cross.
    theta : Quantity
        Rotation of the pivot [rad].

    Returns
    -------
    inner, outer : Quantity
        Rotation of the hinges [rad]; their sum is θ.

    Notes
    -----
    Small rotation, hinges short against the limb.

    Examples
    --------
    >>> [round(phi, 3) for phi in hinge_rotations(l=20e-3, p=-10e-3, theta=0.1)]
    [0.05, 0.05]

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", cross pivot and RCC pivot with
    necked-down hinges; velocity pole of a symmetric four-bar linkage.

    """
    return theta * (1.0 + p / l), theta * (-p / l)


def rotational_stiffness(
    *, K: Quantity, l: Quantity, p: Quantity, c: Quantity, limbs: int = 2
) -> Computed:
    """Return the rotational stiffness of n limbs with two equal hinges each, about their centre.

    ``K_θ = n K (l² + 2 l p + 2p² + 2c²) / (l² + 4c²)``: ``n K (1 + 2δ + 2δ²)`` for pins with
    springs (c = 0).

    Parameters
    ----------
    K : Quantity
        Rotational stiffness of a hinge [N·m/rad].
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m], p
        negative when the limbs cross.
    c : Quantity
        Reach of a hinge's bending about its centre [m],
        ``notch_compliance.bending_reach``; 0 for a pin. A number, like l
        then, since a sum divides.
    limbs : int
        Number of limbs.

    Returns
    -------
    K_theta : Quantity
        Rotational stiffness [N·m/rad].

    Notes
    -----
    Small rotation, no load on the pivot; exact for hinges of any symmetric profile. Symmetric
    in δ ↔ −1 − δ, least for the cross pivot: n K/2.

    Examples
    --------
    >>> rotational_stiffness(K=0.2, l=20e-3, p=-10e-3, c=0.0)
    0.2

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", cross pivot and RCC pivot with
    necked-down hinges; energy of both hinges at the rotations of ``hinge_rotations``.

    """
    return limbs * K * (l**2 + 2.0 * l * p + 2.0 * p**2 + 2.0 * c**2) / (l**2 + 4.0 * c**2)


def admissible_rotation(*, gamma: Quantity, l: Quantity, p: Quantity) -> Computed:
    """Return the rotation of the pivot at which its more strained hinges reach their limit.

    ``θ = γ / max(|1 + δ|, |δ|)``.

    Parameters
    ----------
    gamma : Quantity
        Admissible rotation of a hinge [rad].
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m], p
        negative when the limbs cross; numbers only.

    Returns
    -------
    theta : Quantity
        Admissible rotation of the pivot [rad].

    Notes
    -----
    Small rotation, hinges short against the limb. Where limbs cross (−1 < δ < 0) the pivot turns
    by more than γ, at most by 2γ for δ = −½; with a remote centre by no more than γ, by γ/2 for
    p = l: the "> γ" and "≈ γ/2" of the lecture's comparison.

    Examples
    --------
    >>> [float(admissible_rotation(gamma=0.1, l=1.0, p=p)) for p in (-0.5, 0.0, 1.0)]
    [0.2, 0.1, 0.05]

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", comparison of RCC and cross
    pivots.

    """
    return gamma / np.maximum(np.abs(1.0 + p / l), np.abs(p / l))


def parasitic_shift(*, l: Quantity, p: Quantity, theta: Quantity, half_angle: float) -> Computed:
    """Return the shift of the centre of a pivot of two limbs, leading order in θ, with its sign.

    ``PP' = δ (1 + δ) θ² l / (2 cos α)``, positive the way blades shift a remote centre.

    Parameters
    ----------
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m].
    theta : Quantity
        Rotation [rad].
    half_angle : float
        Half the angle between the limbs [rad], 0 < α < π/2.

    Returns
    -------
    shift : Quantity
        Shift along the bisector [m]; the sign as in
        ``pivot.parasitic_shift``.

    Notes
    -----
    Small rotation; hinges that turn about their own centres. Vanishes at δ = 0 and −1, where
    the limbs have a hinge in the centre of the pivot itself.

    Examples
    --------
    >>> f"{parasitic_shift(l=1.0, p=-0.5, theta=0.1, half_angle=0.0):.6f}"
    '-0.001250'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", comparison of RCC and cross
    pivots; constant length l of each limb to second order in θ.

    """
    delta = p / l
    return delta * (1.0 + delta) * l * (theta**2 / (2.0 * cos(half_angle)))


_CHART = Table(
    "delta",
    (-1.5, -1.25, -1.0, -0.873, -0.75, -0.5, -0.25, -0.127, 0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0),
    {
        "stiffness/K": ("", lambda d: rotational_stiffness(K=1.0, l=1.0, p=d, c=0.0)),
        "rotation/gamma": ("", lambda d: float(admissible_rotation(gamma=1.0, l=1.0, p=d))),
        "shift cos α/(l θ²)": (
            "",
            lambda d: parasitic_shift(l=1.0, p=d, theta=1.0, half_angle=0.0),
        ),
    },
    "two limbs with pins and springs: K and γ of one hinge",
)
_TURN = Range("theta", -0.2, 0.2, "small rotation", "rad")
_SHORT = Range("c/l", 0.0, 0.05, "hinges short against the limb")
_LIMB = {"l": 20e-3, "p": 5e-3}

CARDS: tuple[Card, ...] = (
    Card("hinged-pivot-rotations", hinge_rotations, {**_LIMB, "theta": 0.05}, (_TURN, _SHORT)),
    Card(
        "hinged-pivot",
        rotational_stiffness,
        {**_LIMB, "K": 0.2356, "c": 358.5e-6},
        (_TURN,),
        {"delta": _CHART},
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "hinged-pivot-rotation",
        admissible_rotation,
        {**_LIMB, "gamma": 0.05},
        (_TURN, _SHORT),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "hinged-pivot-shift",
        parasitic_shift,
        {**_LIMB, "theta": 0.05, "half_angle": 0.7},
        (_TURN, _SHORT),
        kind=QuantityKind.SHIFT,
    ),
)
