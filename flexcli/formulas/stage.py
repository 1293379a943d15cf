"""Parallel leaf-spring stage: n equal parallel blades, clamped at both ends, that swing."""

from collections.abc import Sequence

import numpy as np

from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.section import second_moment
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "admissible_translation",
    "drive_rotation",
    "end_stress",
    "loaded_stiffness",
    "shortening",
    "translational_stiffness",
]


def translational_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, blades: int = 2
) -> Computed:
    """Return the stiffness of a parallel leaf-spring stage along its stroke.

    ``K = n 12EI/l³ = n E b h³/l³``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m]; broadcast.
    blades : int
        Number of blades.

    Returns
    -------
    K : Quantity
        Stiffness [N/m].

    Notes
    -----
    Stroke small against l; no axial load.

    Examples
    --------
    >>> round(translational_stiffness(E=200e9, h=300e-6, l=50e-3, b=10e-3), 6)
    864.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation;
    exercise 12 A.

    """
    return blades * E * b * h**3 / l**3


def end_stress(*, E: Quantity, h: Quantity, l: Quantity, x: Quantity) -> Computed:
    """Return the bending stress at the ends of a blade whose stage has moved by x.

    ``σ = 3 E h x/l²``, which the lecture writes as the admissible stroke σ l²/(3 E h).

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length of a blade [m].
    x : Quantity
        Travel [m].

    Returns
    -------
    stress : Quantity
        Bending stress at both ends [Pa].

    Examples
    --------
    >>> round(end_stress(E=200e9, h=300e-6, l=50e-3, x=1e-3) / 1e6, 6)
    72.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", admissible stroke.

    """
    return 3.0 * E * h * x / l**2


def shortening(*, l: Quantity, x: Quantity) -> Computed:
    """Return the parasitic motion of a stage towards its base, leading order.

    ``λ = 3x²/(5l)``.

    Parameters
    ----------
    l : Quantity
        Length of a blade [m].
    x : Quantity
        Travel [m], small against the length.

    Returns
    -------
    shortening : Quantity
        Motion towards the base [m].

    Examples
    --------
    >>> round(shortening(l=50e-3, x=5e-3) * 1e6, 6)
    300.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints" (λ ≈ 0.6 x²/L).

    """
    return 0.6 * x**2 / l


def admissible_translation(*, E: Quantity, h: Quantity, l: Quantity, stress: Quantity) -> Computed:
    """Return the travel at which the bending stress at the blades' ends reaches a given one.

    ``x = σ l²/(3 E h)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length of a blade [m].
    stress : Quantity
        Admissible stress σ [Pa].

    Returns
    -------
    x : Quantity
        Admissible travel to either side [m].

    Examples
    --------
    >>> round(admissible_translation(E=200e9, h=300e-6, l=50e-3, stress=72e6) * 1e3, 6)
    1.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", admissible stroke.

    """
    return stress * l**2 / (3.0 * E * h)


def drive_rotation(
    *,
    E: Quantity,
    h: Quantity,
    l: Quantity,
    b: Quantity,
    places: Sequence[Quantity],
    drive: Quantity,
    x: Quantity,
) -> Computed:
    """Return how far a stage turns when it is driven beside the middle of its blades.

    ``φ = K x (d − l/2) / (Σ EA y²/l + n EI/l)``: the force of the stroke has a moment about the
    middle of the blades, which their stretching at the distances y resists. It vanishes for a
    drive at half the height of the blades, and falls with the square of their spacing.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m].
    places : sequence of Quantity
        Places y of the blades across the stage, from its middle [m].
    drive : Quantity
        Height d of the drive along the blades, from their ends on the base [m].
    x : Quantity
        Travel [m].

    Returns
    -------
    phi : Quantity
        Rotation of the stage [rad].

    Notes
    -----
    First order in the travel. Without the stretching of the blades a stage would not turn at all.

    Examples
    --------
    >>> blade = {"E": 200e9, "h": 300e-6, "l": 50e-3, "b": 10e-3}
    >>> places = (-10e-3, 10e-3)
    >>> drive_rotation(**blade, places=places, drive=25e-3, x=1e-3)
    0.0
    >>> f"{drive_rotation(**blade, places=places, drive=50e-3, x=1e-3):.3g}"
    '9e-06'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", optimal driving point (in words);
    the formula from the beams' linear stiffness.

    """
    force = translational_stiffness(E=E, h=h, l=l, b=b, blades=len(places)) * x
    apart = sum(y**2 for y in places)
    holds = E * h * b * apart / l + len(places) * E * second_moment(b, h) / l
    return force * (drive - l / 2.0) / holds


def loaded_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, axial: Quantity, blades: int = 2
) -> Computed:
    """Return the stiffness of a leaf-spring stage whose blades carry an axial force.

    ``K = P/(2 tan(κl/2)/κ − l)`` with ``κ² = P/(n E I)`` for a compression P, and the same with
    tanh for a tension: K falls to zero at Euler's load n π²EI/l² of the guided ends.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width of a blade [m]; floats or arrays.
    axial : Quantity
        Compression of all blades together [N], negative for a tension.
    blades : int
        Number of blades.

    Returns
    -------
    K : Quantity
        Stiffness [N/m], negative beyond the critical load.

    Notes
    -----
    Travel small against the length; the force keeps its direction. Near no
    force the series ``K₀ (1 − 6u/5 − 3u²/175 − …)``, u = (κl)²/12, keeps the digits.

    Examples
    --------
    >>> blade = {"E": 200e9, "h": 300e-6, "l": 50e-3, "b": 10e-3}
    >>> round(float(loaded_stiffness(**blade, axial=0.0)), 6)
    864.0

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 1.11 (beam-columns).

    """
    bending = E * second_moment(b, h)
    square = np.asarray(axial) * l**2 / (blades * bending)
    half = np.sqrt(np.abs(square)) / 2.0
    small = half < 0.05
    safe = np.where(small, 1.0, half)
    ratio = np.where(square > 0.0, np.tan(safe), np.tanh(safe)) / safe
    with np.errstate(divide="ignore"):
        exact = square / 12.0 / np.where(small, 1.0, ratio - 1.0)
    u = square / 12.0
    series = 1.0 - u * (6.0 / 5.0 + u * (3.0 / 175.0 + u * 2.0 / 875.0))
    unloaded = translational_stiffness(E=E, h=h, l=l, b=b, blades=blades)
    return unloaded * np.where(small, series, exact)


_BLADE = {"E": 200e9, "h": 300e-6, "l": 50e-3}

_STIFF_STROKE = Range(
    "x/l", most=0.125, why="tangent stiffness 1 % low at x/l = 0.057, 5 % at 0.125"
)
_STRESS_STROKE = Range("x/l", most=0.325, why="stress 1 % low at x/l = 0.15, 5 % at 0.325")
_SHIFT_STROKE = Range("x/l", most=0.365, why="shift 1 % low at x/l = 0.17, 5 % at 0.365")

CARDS = (
    Card(
        "stage-stiffness",
        translational_stiffness,
        {**_BLADE, "b": 10e-3, "blades": 2},
        (SLENDER, _STIFF_STROKE),
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "stage-stress",
        end_stress,
        {**_BLADE, "x": 1e-3},
        (SLENDER, _STRESS_STROKE),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "stage-stroke",
        admissible_translation,
        {**_BLADE, "stress": 72e6},
        (SLENDER, _STRESS_STROKE),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "stage-shift",
        shortening,
        {"l": 50e-3, "x": 5e-3},
        (_SHIFT_STROKE,),
        kind=QuantityKind.SHIFT,
    ),
    Card(
        "stage-drive",
        drive_rotation,
        {**_BLADE, "b": 10e-3, "places": (-10e-3, 10e-3), "drive": 50e-3, "x": 1e-3},
        (SLENDER, _STIFF_STROKE),
    ),
    Card(
        "stage-under-load",
        loaded_stiffness,
        {**_BLADE, "b": 10e-3, "axial": 20.0, "blades": 2},
        (SLENDER, _STIFF_STROKE),
    ),
)
