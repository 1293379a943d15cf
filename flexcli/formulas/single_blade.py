"""One blade from a clamp to its tip: pushed, turned by a moment, or guided without turning."""

from flexcli.formulas.card import SLENDER, SMALL_ROTATION, Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.formulas.section import second_moment
from flexcli.results import QuantityKind

__all__ = [
    "FORCE_CARDS",
    "GUIDED_CARDS",
    "MOMENT_CARDS",
    "force_shape",
    "force_stiffness",
    "force_stress",
    "guided_shape",
    "guided_stiffness",
    "guided_stress",
    "moment_shape",
    "moment_stiffness",
    "moment_stress",
]


def force_stiffness(*, E: Quantity, h: Quantity, l: Quantity, b: Quantity) -> Computed:
    """Return the stiffness of a cantilever against a force across its tip.

    ``K = 3EI/l³``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width [m].

    Returns
    -------
    K : Quantity
        Stiffness [N/m].

    Examples
    --------
    >>> round(force_stiffness(E=200e9, h=300e-6, l=50e-3, b=10e-3), 6)
    108.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation.

    """
    return 3.0 * E * second_moment(b, h) / l**3


def force_shape(*, l: Quantity, x: Quantity, s: Quantity) -> Computed:
    """Return the deflection along a cantilever whose tip a force has moved.

    ``w(s) = x s²(3l − s)/(2l³)``.

    Parameters
    ----------
    l : Quantity
        Length [m].
    x : Quantity
        Travel of the tip [m].
    s : Quantity
        Place along the blade from the clamp [m], 0 to l.

    Returns
    -------
    w : Quantity
        Deflection [m].

    Examples
    --------
    >>> force_shape(l=2.0, x=1.0, s=2.0)
    1.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation.

    """
    return x * s**2 * (3.0 * l - s) / (2.0 * l**3)


def force_stress(*, E: Quantity, h: Quantity, l: Quantity, x: Quantity, s: Quantity) -> Computed:
    """Return the bending stress along a cantilever whose tip a force has moved.

    ``σ(s) = 3 E h x (l − s)/(2l³)``, largest at the clamp.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length [m].
    x : Quantity
        Travel of the tip [m].
    s : Quantity
        Place along the blade from the clamp [m], 0 to l.

    Returns
    -------
    stress : Quantity
        Bending stress at the faces [Pa].

    Examples
    --------
    >>> force_stress(E=2.0, h=1.0, l=3.0, x=1.0, s=0.0)
    0.3333333333333333

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", σ = 6M/(b h²).

    """
    return 1.5 * E * h * x * (1.0 - s / l) / l**2


def moment_stiffness(*, E: Quantity, h: Quantity, l: Quantity, b: Quantity) -> Computed:
    """Return the stiffness of a cantilever against a moment at its tip.

    ``K = EI/l``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width [m].

    Returns
    -------
    K : Quantity
        Rotational stiffness [N·m/rad].

    Examples
    --------
    >>> moment_stiffness(E=12.0, h=1.0, l=2.0, b=1.0)
    0.5

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation.

    """
    return E * second_moment(b, h) / l


def moment_shape(*, l: Quantity, theta: Quantity, s: Quantity) -> Computed:
    """Return the deflection along a cantilever whose tip a moment has turned.

    ``w(s) = θ s²/(2l)``.

    Parameters
    ----------
    l : Quantity
        Length [m].
    theta : Quantity
        Rotation of the tip [rad].
    s : Quantity
        Place along the blade from the clamp [m], 0 to l.

    Returns
    -------
    w : Quantity
        Deflection [m].

    Examples
    --------
    >>> moment_shape(l=2.0, theta=0.1, s=2.0)
    0.1

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation.

    """
    return theta * s**2 / (2.0 * l)


def moment_stress(*, E: Quantity, h: Quantity, l: Quantity, theta: Quantity) -> Computed:
    """Return the bending stress of a blade whose tip a moment has turned, the same all along.

    ``σ = E h θ/(2l)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length [m].
    theta : Quantity
        Rotation of the tip [rad].

    Returns
    -------
    stress : Quantity
        Bending stress at the faces [Pa].

    Notes
    -----
    Exact at any rotation: the blade bends into an arc of a circle.

    Examples
    --------
    >>> moment_stress(E=10.0, h=1.0, l=5.0, theta=0.1)
    0.1

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", σ = 6M/(b h²).

    """
    return E * h * theta / (2.0 * l)


def guided_stiffness(*, E: Quantity, h: Quantity, l: Quantity, b: Quantity) -> Computed:
    """Return the stiffness of a blade whose tip moves across it without turning.

    ``K = 12EI/l³ = E b h³/l³``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness, length and width [m].

    Returns
    -------
    K : Quantity
        Stiffness [N/m].

    Examples
    --------
    >>> round(guided_stiffness(E=200e9, h=300e-6, l=50e-3, b=10e-3), 6)
    432.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", stiffness calculation.

    """
    return E * b * h**3 / l**3


def guided_shape(*, l: Quantity, x: Quantity, s: Quantity) -> Computed:
    """Return the deflection along a blade whose tip has moved without turning.

    ``w(s) = x s²(3l − 2s)/l³``.

    Parameters
    ----------
    l : Quantity
        Length [m].
    x : Quantity
        Travel of the tip [m].
    s : Quantity
        Place along the blade from the clamp [m], 0 to l.

    Returns
    -------
    w : Quantity
        Deflection [m].

    Examples
    --------
    >>> guided_shape(l=2.0, x=1.0, s=1.0)
    0.5

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", bending moment distribution.

    """
    return x * s**2 * (3.0 * l - 2.0 * s) / l**3


def guided_stress(*, E: Quantity, h: Quantity, l: Quantity, x: Quantity, s: Quantity) -> Computed:
    """Return the bending stress along a blade whose tip has moved without turning.

    ``σ(s) = 3 E h x (l − 2s)/l³``: equal and opposite at the two ends.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness and length [m].
    x : Quantity
        Travel of the tip [m].
    s : Quantity
        Place along the blade from the clamp [m], 0 to l.

    Returns
    -------
    stress : Quantity
        Bending stress at the faces [Pa].

    Examples
    --------
    >>> round(guided_stress(E=200e9, h=300e-6, l=50e-3, x=1e-3, s=0.0) / 1e6, 6)
    72.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", bending moment distribution.

    """
    return 3.0 * E * h * x * (1.0 - 2.0 * s / l) / l**2


_BLADE = {"E": 200e9, "h": 300e-6, "l": 50e-3}
_BENDS = (
    SLENDER,
    Range("x/l", most=0.125, why="tangent stiffness 1 % low at x/l = 0.057, 5 % at 0.125"),
)
_STRESSED = (
    SLENDER,
    Range("x/l", most=0.325, why="stress 1 % low at x/l = 0.15, 5 % at 0.325"),
)
_TURNS = (SLENDER,)

FORCE_CARDS = (
    Card(
        "cantilever-stiffness",
        force_stiffness,
        {**_BLADE, "b": 10e-3},
        _BENDS,
        kind=QuantityKind.STIFFNESS,
    ),
    Card("cantilever-shape", force_shape, {"l": 50e-3, "x": 1e-3, "s": 25e-3}, _BENDS),
    Card(
        "cantilever-stress",
        force_stress,
        {**_BLADE, "x": 1e-3, "s": 0.0},
        _STRESSED,
        kind=QuantityKind.STRESS,
    ),
)

MOMENT_CARDS = (
    Card(
        "moment-blade-stiffness",
        moment_stiffness,
        {**_BLADE, "b": 10e-3},
        _TURNS,
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "moment-blade-shape",
        moment_shape,
        {"l": 50e-3, "theta": 0.02, "s": 50e-3},
        (SLENDER, SMALL_ROTATION),
    ),
    Card(
        "moment-blade-stress",
        moment_stress,
        {**_BLADE, "theta": 0.02},
        _TURNS,
        kind=QuantityKind.STRESS,
    ),
)

GUIDED_CARDS = (
    Card(
        "guided-blade-stiffness",
        guided_stiffness,
        {**_BLADE, "b": 10e-3},
        _BENDS,
        kind=QuantityKind.STIFFNESS,
    ),
    Card("guided-blade-shape", guided_shape, {"l": 50e-3, "x": 1e-3, "s": 25e-3}, _BENDS),
    Card(
        "guided-blade-stress",
        guided_stress,
        {**_BLADE, "x": 1e-3, "s": 0.0},
        _STRESSED,
        kind=QuantityKind.STRESS,
    ),
)
