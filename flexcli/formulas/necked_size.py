"""Thickness and aspect ratio of necked-down hinges for a given stroke and outer size.

The chart compares designs of equal stroke, stress, length and width over ξ: a shorter hinge must
be thinner; it is stockier, softer along the stroke and stiffer along the blade.
"""

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.necked_buckling import guided_critical_load, locked_critical_load
from flexcli.formulas.necked_stage import (
    compliance_share,
    compression_stiffness,
    translational_stiffness,
)
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "aspect_ratio", "hinge_thickness"]


def hinge_thickness(
    *, E: Quantity, sigma: Quantity, l: Quantity, x: Quantity, xi: Quantity
) -> Quantity:
    """Return the thickness at which the hinges reach the admissible stress at the stroke.

    ``h = σ l² (1 − (1 − ξ)³) / (3 E x)``.

    Parameters
    ----------
    E, sigma : Quantity
        Young's modulus and admissible stress [Pa].
    l, x : Quantity
        Length of the whole blade and stroke [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-].

    Returns
    -------
    h : Quantity
        Greatest admissible thickness [m].

    Notes
    -----
    0 < ξ ≤ 1, stroke small against l, stress concentration in σ.

    Examples
    --------
    >>> f"{hinge_thickness(E=200e9, sigma=400e6, l=50e-3, x=2e-3, xi=0.2) * 1e6:.2f}"
    '406.67'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", thickness of the hinges.

    """
    return sigma * l**2 / (3.0 * E * x) * compliance_share(xi)


def aspect_ratio(
    *, E: Quantity, sigma: Quantity, l: Quantity, x: Quantity, xi: Quantity
) -> Quantity:
    """Return how many times longer than thick the hinges are that just bear the stroke.

    ``l_c/h = 3 E x / (2 σ l (3 − 3ξ + ξ²))``.

    Parameters
    ----------
    E, sigma : Quantity
        Young's modulus and admissible stress [Pa].
    l, x : Quantity
        Length of the whole blade and stroke [m].
    xi : Quantity
        Share of the blade's length that bends, 2 l_c/l [-]; a number, since a sum divides.

    Returns
    -------
    ratio : Quantity
        l_c/h [-], a third of the leaf spring's as ξ → 0.

    Notes
    -----
    0 < ξ ≤ 1. Below about 5 the hinge is too stubby for beam theory.

    Examples
    --------
    >>> f"{aspect_ratio(E=200e9, sigma=400e6, l=50e-3, x=2e-3, xi=0.2):.3f}"
    '12.295'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", aspect ratio of the hinges.

    """
    return 1.5 * E * x / (sigma * l) / (3.0 - 3.0 * xi + xi**2)


def _thickness(xi: float) -> float:
    """Return the hinge thickness over the leaf spring's, at equal stroke and outer size."""
    return float(hinge_thickness(E=1.0, sigma=3.0, l=1.0, x=1.0, xi=xi))


def _hinge(xi: float) -> dict[str, float]:
    return {"E": 1.0, "h": _thickness(xi), "l": 1.0, "b": 1.0, "xi": xi}


_LEAF = _hinge(1.0)
_CHART = Table(
    "xi",
    (0.01, 0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0),
    {
        "thickness": ("", _thickness),
        "aspect ratio": ("", lambda xi: xi / _thickness(xi)),
        "stiffness": ("", lambda xi: float(translational_stiffness(**_hinge(xi), blades=1))),
        "compression": ("", lambda xi: float(compression_stiffness(**_hinge(xi), blades=1))),
        "critical load, guided": (
            "",
            lambda xi: float(guided_critical_load(**_hinge(xi)) / guided_critical_load(**_LEAF)),
        ),
        "critical load, locked": (
            "",
            lambda xi: float(locked_critical_load(**_hinge(xi)) / locked_critical_load(**_LEAF)),
        ),
    },
    "each over its value at ξ = 1, at equal stroke, stress, length and width",
)
_SHARE = Range("xi", 0.0, 1.0, "two hinges make up at most the whole blade")
_SLENDER = Range("l_c/h", 5.0, why="a stubby hinge is no beam, and its roots give way as well")
_STROKE = Range("x/l", -0.1, 0.1, "small deflection")
_GIVEN = {"E": 200e9, "sigma": 400e6, "l": 50e-3, "x": 2e-3, "xi": 0.2}

CARDS: tuple[Card, ...] = (
    Card("necked-down-hinge", hinge_thickness, _GIVEN, (_SHARE, _STROKE), {"xi": _CHART}),
    Card("necked-down-hinge-aspect", aspect_ratio, _GIVEN, (_SHARE, _SLENDER)),
)
