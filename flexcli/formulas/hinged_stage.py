"""Parallel stage on rigid limbs with a hinge at each end, notched or necked down."""

from math import pi

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.results import QuantityKind

__all__ = ["CARDS", "admissible_stroke", "law_stroke", "translational_stiffness"]


def translational_stiffness(*, K: Quantity, l: Quantity, c: Quantity, limbs: int = 2) -> Computed:
    """Return the stiffness along its stroke of a stage on n limbs with two equal hinges each.

    ``K_x = 2 n K / (l² + 4c²)``.

    Parameters
    ----------
    K : Quantity
        Rotational stiffness of a hinge [N·m/rad].
    l : Quantity
        Distance between the centres of a limb's hinges [m].
    c : Quantity
        Reach of a hinge's bending about its centre [m],
        ``notch_compliance.bending_reach``; 0 for a pin. A number, since a
        sum divides.
    limbs : int
        Number of limbs; two for a stage with four hinges.

    Returns
    -------
    K_x : Quantity
        Stiffness [N/m].

    Notes
    -----
    Stroke small against l, no axial load; exact for beams of any symmetric profile, l_c/√12
    for c giving the necked-down stage.

    Examples
    --------
    >>> f"{translational_stiffness(K=0.2356106, l=50e-3, c=358.5e-6):.2f}"
    '376.90'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", parallel stage with
    right-circular hinges; force F l/2 at the hinge centres, ∫M²/(EI) over both hinges.

    """
    return 2.0 * limbs * K / (l**2 + 4.0 * c**2)


def admissible_stroke(*, gamma: Quantity, l: Quantity, c: Quantity) -> Computed:
    """Return the stroke at which the hinges of a stage bear their admissible moment.

    ``f = γ l (1 + 4c²/l²)``, γ the rotation of a hinge under that moment alone.

    Parameters
    ----------
    gamma : Quantity
        Admissible rotation of a hinge [rad], ``notch.admissible_rotation``.
    l : Quantity
        Distance between the centres of a limb's hinges [m].
    c : Quantity
        Reach of a hinge's bending about its centre [m]; 0 for a pin.

    Returns
    -------
    f : Quantity
        Admissible stroke [m].

    Notes
    -----
    Small rotation. As the moment falls along the limb, the stress of a circular notch peaks
    e r/(2l) beside its throat, higher by the share e r/(2l²), which is left out.

    Examples
    --------
    >>> f"{admissible_stroke(gamma=0.05659055, l=50e-3, c=0.0) * 1e3:.3f}"
    '2.830'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", example: "theoretical exact
    value" 2.83 mm.

    """
    return gamma * l * (1.0 + 4.0 * (c / l) ** 2)


def law_stroke(*, E: Quantity, sigma: Quantity, e: Quantity, r: Quantity, l: Quantity) -> Computed:
    """Return the admissible stroke of a stage on right-circular notches, by the scaling law.

    ``f ≈ 3π σ √r l / (4 E √e)``: half the thickness e gives √2 the stroke.

    Parameters
    ----------
    E, sigma : Quantity
        Young's modulus and admissible stress [Pa].
    e, r : Quantity
        Thickness of the throat and radius of the notches [m].
    l : Quantity
        Distance between the centres of a limb's hinges [m].

    Returns
    -------
    f : Quantity
        Admissible stroke [m].

    Notes
    -----
    e/r → 0: too long a stroke by e/(8r), 0.3 % at e/r = 0.025. Nominal stress.

    Examples
    --------
    >>> f"{law_stroke(E=210e9, sigma=800e6, e=100e-6, r=4e-3, l=50e-3) * 1e3:.2f}"
    '2.84'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", example: simplified formula.

    """
    return 3.0 * pi / 4.0 * sigma * l / E * (r / e) ** 0.5


_STROKE = Range("x/l", -0.1, 0.1, "small deflection")
_BEAM = Range("e/r", 0.0, 0.2, "r > 5e: law within 2.6 %, stress concentration below 4 %")
_LIMB = {"l": 50e-3, "c": 358.5e-6}

CARDS: tuple[Card, ...] = (
    Card(
        "hinged-stage",
        translational_stiffness,
        {"K": 0.23561, **_LIMB},
        (_STROKE,),
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "hinged-stage-stroke",
        admissible_stroke,
        {"gamma": 0.05659, **_LIMB},
        (_STROKE,),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "hinged-stage-stroke-law",
        law_stroke,
        {"E": 210e9, "sigma": 800e6, "e": 100e-6, "r": 4e-3, "l": 50e-3},
        (_BEAM, _STROKE),
    ),
)
