"""Parallel stage on necked-down blades: two hinges of length l_c at the ends of a rigid middle.

ξ = 2 l_c/l is the share of a blade that bends: ξ = 1 is the leaf spring of
:mod:`flexcli.formulas.stage`, ξ → 0 a rigid link between two pivots. Only the hinges shear and
stretch; with ξ = 1 this is the leaf spring of :mod:`flexcli.formulas.thick_blades`.
"""

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "compliance_share",
    "compression_stiffness",
    "end_stress",
    "shear_in_shift",
    "shear_parameter",
    "shortening",
    "stretch_in_shift",
    "translational_stiffness",
]


def compliance_share(xi: Quantity) -> Computed:
    """Return the share of the leaf spring's bending compliance that its two hinges keep.

    ``g = 1 − (1 − ξ)³ = ξ (3 − 3ξ + ξ²)``, of hinge and leaf spring equally thick.

    Parameters
    ----------
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    g : Quantity
        Share of the compliance [-], 1 for ξ = 1.

    Notes
    -----
    0 < ξ ≤ 1. The factored form keeps the digits that 1 − (1 − ξ)³ loses for short hinges.

    Examples
    --------
    >>> round(compliance_share(0.2), 6)
    0.488

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", necked down flexures (ξ); the
    integral of the moment F (l/2 − s) over the hinges.

    """
    return xi * (3.0 - 3.0 * xi + xi**2)


def translational_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, xi: Quantity, blades: int = 2
) -> Computed:
    """Return the stiffness of a stage on n necked-down blades along its stroke.

    ``K = n E b h³ / (l³ (1 − (1 − ξ)³))``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness of a hinge, length of the whole blade and width [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-]; a number, since a sum divides.
    blades : int
        Number of blades.

    Returns
    -------
    K : Quantity
        Stiffness [N/m].

    Notes
    -----
    0 < ξ ≤ 1, stroke small against l, no axial load, hinge l_c several times longer than thick.

    Examples
    --------
    >>> round(translational_stiffness(E=200e9, h=300e-6, l=50e-3, b=10e-3, xi=1.0), 6)
    864.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", natural stiffness.

    """
    return blades * E * b * h**3 / l**3 / compliance_share(xi)


def end_stress(*, E: Quantity, h: Quantity, l: Quantity, x: Quantity, xi: Quantity) -> Computed:
    """Return the bending stress at the ends of a blade whose stage has moved by x.

    ``σ = 6M/(b h²) = 3 E h x / (l² (1 − (1 − ξ)³))`` with ``M = F l/2``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l : Quantity
        Thickness of a hinge and length of the whole blade [m].
    x : Quantity
        Stroke [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-]; a number, since a sum divides.

    Returns
    -------
    sigma : Quantity
        Stress [Pa].

    Notes
    -----
    0 < ξ ≤ 1, stroke small against l; without the stress concentration where hinge meets middle
    or body.

    Examples
    --------
    >>> round(end_stress(E=200e9, h=300e-6, l=50e-3, x=1e-3, xi=1.0) / 1e6, 6)
    72.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", M = F l/2.

    """
    return 3.0 * E * h * x / l**2 / compliance_share(xi)


def compression_stiffness(
    *, E: Quantity, h: Quantity, l: Quantity, b: Quantity, xi: Quantity, blades: int = 2
) -> Computed:
    """Return the stiffness of a stage on n necked-down blades along the blades.

    ``K_t = n E b h / (2 l_c) = n E b h / (ξ l)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h, l, b : Quantity
        Thickness of a hinge, length of the whole blade and width [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].
    blades : int
        Number of blades.

    Returns
    -------
    K_t : Quantity
        Stiffness in tension and compression [N/m].

    Notes
    -----
    At zero stroke: over a stroke x the blades also give way by bending.

    Examples
    --------
    >>> f"{compression_stiffness(E=200e9, h=300e-6, l=50e-3, b=10e-3, xi=0.2):.3g}"
    '1.2e+08'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", transverse stiffness.

    """
    return blades * E * b * h / (xi * l)


def shortening(*, l: Quantity, x: Quantity, xi: Quantity) -> Computed:
    """Return the parasitic motion of the stage towards its base.

    ``λ = (x²/l) (4.5 − 7.5ξ + 4.5ξ² − 0.9ξ³) / (3 − 3ξ + ξ²)²``: from x²/(2l) of a rigid link
    between pivots (ξ → 0) to 3x²/(5l) of the leaf spring (ξ = 1).

    Parameters
    ----------
    l, x : Quantity
        Length of the whole blade and stroke [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-]; a number, since a sum divides.

    Returns
    -------
    lambda : Quantity
        Parasitic motion [m].

    Notes
    -----
    0 < ξ ≤ 1, x small against l. It is half the integral of the squared slope along the blade.

    Examples
    --------
    >>> round(shortening(l=50e-3, x=5e-3, xi=1.0) * 1e6, 6)
    300.0

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints" (λ ≈ 0.6 x²/L for ξ = 1).

    """
    slope = 4.5 - 7.5 * xi + 4.5 * xi**2 - 0.9 * xi**3
    return x**2 / l * slope / (3.0 - 3.0 * xi + xi**2) ** 2


_SHARE = Range("xi", 0.0, 1.0, "two hinges make up at most the whole blade")
_SLENDER = Range("l_c/h", 5.0, why="a stubby hinge is no beam, and its roots give way as well")
_STROKE = Range("x/l", -0.1, 0.1, "small deflection")
_BLADE = {"E": 200e9, "h": 100e-6, "l": 50e-3, "xi": 0.2}


def shear_parameter(*, Phi: Quantity, xi: Quantity) -> Computed:
    """Return the shear of the hinges over their bending, as Timoshenko's Φ is of a whole blade.

    ``Φ' = Φ/(3 − 3ξ + ξ²)``: the stage is softer by the factor 1/(1 + Φ').

    Parameters
    ----------
    Phi : Quantity
        Timoshenko's 12EI/(κGA l²) of the hinge's section and the whole length [-].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    Phi' : Quantity
        Compliance by shear over that by bending [-].

    Examples
    --------
    >>> shear_parameter(Phi=0.03, xi=1.0)
    0.03

    References
    ----------
    Compliances F ξ l/(κGA) and F l³ ξ (3 − 3ξ + ξ²)/(12EI) in series.

    """
    return Phi / (3.0 - 3.0 * xi + xi**2)


def shear_in_shift(*, Phi: Quantity, xi: Quantity) -> Computed:
    """Return the relative change that shear makes to the motion towards the base.

    ``(1 + Φ' (3 − ξ) D/(2S))/(1 + Φ')² − 1`` with ``D = 3 − 3ξ + ξ²`` and
    ``S = 4.5 − 7.5ξ + 4.5ξ² − 0.9ξ³``: the hinges turn less and shear instead.

    Parameters
    ----------
    Phi : Quantity
        Φ' of :func:`shear_parameter` [-].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        Motion with shear over that without, less one [-].

    Examples
    --------
    >>> from flexcli.formulas.thick_blades import shear_factor
    >>> round(shear_in_shift(Phi=0.1, xi=1.0) - shear_factor(0.1) + 1.0, 12)
    0.0

    References
    ----------
    Shortening ∫(θ²/2 + gθ) ds, the shear angle g of the hinges alone; their ∫θ ds is
    ``x (3ξ − ξ²)/(2D)``.

    """
    D, S = _sums(xi)
    return (1.0 + Phi * (3.0 - xi) * D / (2.0 * S)) / (1.0 + Phi) ** 2 - 1.0


def stretch_in_shift(*, h: Quantity, l: Quantity, xi: Quantity) -> Computed:
    """Return the relative change that stretching makes to the motion towards the base.

    ``−(h/l)² (3 − ξ)/(2S)`` with ``S = 4.5 − 7.5ξ + 4.5ξ² − 0.9ξ³``.

    Parameters
    ----------
    h, l : Quantity
        Thickness of a hinge and length of the whole blade [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    change : Quantity
        Motion with stretching over that without, less one [-].

    Examples
    --------
    >>> round(stretch_in_shift(h=0.06, l=1.0, xi=1.0), 6)
    -0.006

    References
    ----------
    ``−F ∫θ ds/(EA)`` over the hinges.

    """
    _, S = _sums(xi)
    return -((h / l) ** 2) * (3.0 - xi) / (2.0 * S)


def _sums(xi: Quantity) -> tuple[Computed, Computed]:
    return 3.0 - 3.0 * xi + xi**2, 4.5 - 7.5 * xi + 4.5 * xi**2 - 0.9 * xi**3


CARDS: tuple[Card, ...] = (
    Card(
        "necked-down-stage",
        translational_stiffness,
        {**_BLADE, "b": 10e-3},
        (_SHARE, _SLENDER, _STROKE),
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        "necked-down-stage-stress",
        end_stress,
        {**_BLADE, "x": 1e-3},
        (_SHARE, _STROKE),
        kind=QuantityKind.STRESS,
    ),
    Card(
        "necked-down-stage-compression",
        compression_stiffness,
        {**_BLADE, "b": 10e-3},
        (_SHARE, _SLENDER),
    ),
    Card(
        "necked-down-stage-shortening",
        shortening,
        {"l": 50e-3, "x": 1e-3, "xi": 0.2},
        (_SHARE, _STROKE),
        kind=QuantityKind.SHIFT,
    ),
    Card("shear-of-necked-hinges", shear_parameter, {"Phi": 0.03, "xi": 0.3}, (_SHARE,)),
    Card("shear-in-necked-shift", shear_in_shift, {"Phi": 0.03, "xi": 0.3}, (_SHARE,)),
    Card(
        "stretching-in-necked-shift",
        stretch_in_shift,
        {"h": 1e-3, "l": 20e-3, "xi": 0.3},
        (_SHARE,),
    ),
)
