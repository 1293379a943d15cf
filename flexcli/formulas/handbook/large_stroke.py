"""Change of the driving force or moment of a joint at a large stroke or rotation.

Stiffness is judged at rest; these tell how far from there it holds.
"""

from math import pi

import numpy as np

from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.hinged_next_order import over_sine
from flexcli.formulas.pivot_next_order import LARGE_ROTATION, moment_change
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.stage_next_order import flexible_share
from flexcli.formulas.star_next_order import held_shares, tension

__all__ = [
    "CARDS",
    "hinged_pivot_moment_change",
    "hinged_stage_force_change",
    "pivot_stiffness_change",
    "stage_force_change",
    "stage_stiffness_change",
    "star_moment_change",
]


def hinged_stage_force_change(*, l: Quantity, x: Quantity) -> Computed:
    """Return the relative change that a large stroke makes to the force over the stroke.

    ``F/(K x) − 1 = ψ/(sin ψ cos ψ) − 1``, ``sin ψ = x/l``: (2/3)(x/l)² at first; the tangent
    stiffness changes by three times that.

    Parameters
    ----------
    l, x : Quantity
        Distance between the hinges of a limb and travel of the stage [m].

    Returns
    -------
    change : Quantity
        True over closed-form secant stiffness, less one [-].

    Notes
    -----
    Hinges that turn about their own centres.

    Examples
    --------
    >>> round(float(hinged_stage_force_change(l=1.0, x=0.1)), 5)
    0.00672

    References
    ----------
    Derivative of the energy n K_hinge ψ² of the springs.

    """
    psi = np.arcsin(x / l)
    return over_sine(psi) / np.cos(psi) - 1.0


def hinged_pivot_moment_change(
    *, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers
) -> Computed:
    """Return the relative change that a large rotation makes to the moment over the rotation.

    ``M/(Kθ) − 1 = θ² (γ² − 1)(3(γ² − 1) tan²α − 8γ²)/(24(1 + γ²))``, ``γ = 1 + 2δ``; the tangent
    stiffness changes by three times that.

    Parameters
    ----------
    l, p : Quantity
        Distance between the hinges of a limb and from the centre to the inner one [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the limbs [rad].

    Returns
    -------
    change : Quantity
        True over closed-form secant stiffness, less one [-].

    Notes
    -----
    Hinges that turn about their own centres. The next term is of order θ⁴.

    Examples
    --------
    >>> from math import pi
    >>> crossed = {"l": 1.0, "p": -0.5, "theta": 0.1, "half_angle": pi / 4}
    >>> round(float(8.0 * hinged_pivot_moment_change(**crossed)), 9)
    0.01

    References
    ----------
    Derived from the constant length of each limb, see the module.

    """
    gamma = 1.0 + 2.0 * p / l
    apart = gamma**2 - 1.0
    tangent = np.tan(half_angle)
    share = apart * (3.0 * apart * tangent**2 - 8.0 * gamma**2) / (24.0 * (1.0 + gamma**2))
    return theta**2 * share


def pivot_stiffness_change(
    *, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers
) -> Computed:
    """Return the relative change that a large rotation makes to the tangent stiffness.

    ``(dM/dθ)/K − 1``, three times that of the moment over the rotation.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    change : Quantity
        True over closed-form stiffness, less one [-].

    Examples
    --------
    >>> from math import pi
    >>> round(float(2.0 * pivot_stiffness_change(l=1.0, p=-0.5, theta=0.1, half_angle=pi / 4)), 9)
    0.01

    References
    ----------
    Derivative of :func:`moment_change` times the rotation.

    """
    return 3.0 * moment_change(l=l, p=p, theta=theta, half_angle=half_angle)


def stage_force_change(*, l: Quantity, x: Quantity, xi: Quantity = 1.0) -> Computed:
    """Return the relative change that a large stroke makes to the force over the stroke.

    ``F/(K x) − 1 = (x/l)² 9(140 − 315ξ + 273ξ² − 105ξ³ + 15ξ⁴)/(70 (3 − 3ξ + ξ²)³)``: 36/35
    (x/l)² of a blade that bends all along (ξ = 1), 2/3 (x/l)² of one between pivots (ξ → 0).

    Parameters
    ----------
    l, x : Quantity
        Length of the blade and travel of its tip [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l; 1 for a leaf spring and a cantilever [-].

    Returns
    -------
    change : Quantity
        True over closed-form secant stiffness, less one [-].

    Notes
    -----
    Next term of order (x/l)⁴; slender blades without axial load.

    Examples
    --------
    >>> round(35.0 * stage_force_change(l=1.0, x=0.1), 6)
    0.36

    References
    ----------
    Derived: θ = f θ₁ + f³ θ₃ with θ₁' = c ∫ds, θ₃' = −c ∫θ₁²/2 ds over the rest of the half blade,
    its end at ∫(θ − θ³/6) ds. For ξ = 1 the series of Bisshopp & Drucker (1945), Quarterly of
    Applied Mathematics 3.

    """
    share = 140.0 - xi * (315.0 - xi * (273.0 - xi * (105.0 - 15.0 * xi)))
    return (x / l) ** 2 * 9.0 * share / (70.0 * flexible_share(xi) ** 3)


def stage_stiffness_change(*, l: Quantity, x: Quantity, xi: Quantity = 1.0) -> Computed:
    """Return the relative change that a large stroke makes to the tangent stiffness.

    ``(dF/dx)/K − 1``, three times that of the force over the stroke.

    Parameters
    ----------
    l, x : Quantity
        Length of the blade and travel of its tip [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        True over closed-form stiffness, less one [-].

    Examples
    --------
    >>> round(35.0 * stage_stiffness_change(l=1.0, x=0.1), 6)
    1.08

    References
    ----------
    Derivative of :func:`force_change` times the stroke.

    """
    return 3.0 * stage_force_change(l=l, x=x, xi=xi)


def star_moment_change(
    *, h: Quantity, l: Quantity, p: Quantity, theta: Quantity, angles: tuple[float, ...]
) -> Computed:
    """Return the relative change that the tension makes to the moment over the rotation.

    ``M/(Kθ) − 1 = Σ (k_s + 3γ² k_a + n (γ² − 1)/4)/(N(1 + 3γ²)) − 1`` over N blades, the
    stability functions of ``loaded_pivot`` at the tension of the rotation: for blades evenly
    around the centre ``24 c² (θ l/h)²/(1 + 3γ²)`` at first, where the tangent stiffness changes by
    three times that.

    Parameters
    ----------
    h, l : Quantity
        Thickness and length of a blade [m].
    p : Quantity
        Distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    angles : tuple of float
        Direction of each blade [rad].

    Returns
    -------
    change : Quantity
        True over closed-form secant stiffness, less one [-].

    Notes
    -----
    Blades that sum to no direction (Σe = 0), three or more; large once θ is near h/l.

    Examples
    --------
    >>> from math import pi
    >>> star = (0.0, 2 * pi / 3, 4 * pi / 3)
    >>> round(float(star_moment_change(h=0.01, l=1.0, p=0.0, theta=0.01, angles=star)), 4)
    0.0259

    References
    ----------
    Moment at the tension; derived as ``loaded_pivot.loaded_stiffness``.

    """
    gamma = 1.0 + 2.0 * p / l
    total = 0.0
    for share in held_shares(angles):
        n = tension(h=h, l=l, p=p, theta=theta, share=share)
        total = total + uniform_bending(n) + 3.0 * gamma**2 * s_bending(n)
        total = total + n * (gamma**2 - 1.0) / 4.0
    return total / (len(angles) * (1.0 + 3.0 * gamma**2)) - 1.0


_HINGED_STAGE = {"l": 50e-3, "x": 5e-3}
_REACH = Range("x/l", -1.0, 1.0, "a limb reaches no further")
_HINGED_PIVOT = {"l": 20e-3, "p": 5e-3, "theta": 0.1, "half_angle": 0.7}
_TURN = Range("theta", -0.35, 0.35, "the change is the next term only", "rad")
_PIVOT = {"l": 17.5e-3, "p": 2e-3, "theta": 0.1, "half_angle": 0.7}
_BLADE = {"l": 50e-3, "x": 5e-3, "xi": 1.0}
_STROKE = Range("x/l", -0.35, 0.35, "the change is the next term only")
_EVEN = {"angles": (0.0, 2.0 * pi / 3.0, 4.0 * pi / 3.0)}
_SMALL = Range("n", -5.0, 30.0, "the shortening of the blade is of second order in n")
_STAR = {"h": 250e-6, "l": 80e-3, "p": 0.0, "theta": 0.003}

CARDS: tuple[Card, ...] = (
    Card("hinged-stage-force-at-large-stroke", hinged_stage_force_change, _HINGED_STAGE, (_REACH,)),
    Card(
        "hinged-pivot-moment-at-large-rotation", hinged_pivot_moment_change, _HINGED_PIVOT, (_TURN,)
    ),
    Card("pivot-stiffness-at-large-rotation", pivot_stiffness_change, _PIVOT, LARGE_ROTATION),
    Card("stage-force-at-large-stroke", stage_force_change, _BLADE, (_STROKE,)),
    Card("stage-stiffness-at-large-stroke", stage_stiffness_change, _BLADE, (_STROKE,)),
    Card(
        "star-moment-at-large-rotation", star_moment_change, {**_STAR, **_EVEN}, (SLENDER, _SMALL)
    ),
)
