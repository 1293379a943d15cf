"""Size of necked-down hinges: thickness for a stroke, and the shortest that can be machined.

The chart compares designs of equal stroke, stress, length and width over ξ: a shorter hinge must
be thinner; it is stockier, softer along the stroke and stiffer along the blade. At equal stroke a
shorter hinge is better in all but its thickness (and, in the end, its critical load), so the least
machinable thickness and its tolerance set ξ.
"""

from typing import NamedTuple

import numpy as np

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.necked_buckling import guided_critical_load, locked_critical_load
from flexcli.formulas.necked_stage import (
    compliance_share,
    compression_stiffness,
    translational_stiffness,
)
from flexcli.formulas.quantity import Computed, Numbers, Quantity

__all__ = [
    "CARDS",
    "Hinge",
    "aspect_ratio",
    "hinge_ratio",
    "hinge_thickness",
    "shortest_hinge",
    "stiffness_spread",
    "thickness_for_spread",
]


def hinge_thickness(
    *, E: Quantity, sigma: Quantity, l: Quantity, x: Quantity, xi: Quantity
) -> Computed:
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
) -> Computed:
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


class Hinge(NamedTuple):
    """Share ξ of the blade that bends [-] and nominal thickness h [m] of its hinges."""

    xi: Computed
    h: Computed


def hinge_ratio(*, E: Quantity, sigma: Quantity, l: Quantity, x: Quantity, h: Quantity) -> Computed:
    """Return the share ξ at which hinges of a given thickness just bear the stroke.

    ``ξ = 1 − (1 − 3 E h x/(σ l²))^(1/3)``, the inverse of
    ``necked_size.hinge_thickness``.

    Parameters
    ----------
    E, sigma : Quantity
        Young's modulus and admissible stress [Pa].
    l, x, h : Quantity
        Length of the whole blade, stroke and thickness of a hinge [m]; numbers only.

    Returns
    -------
    xi : Quantity
        Least share of the blade's length that must bend [-].

    Notes
    -----
    Longer hinges of that thickness bear more than the stroke, shorter ones less.

    Raises
    ------
    ValueError
        When even the full blade (ξ = 1) of that thickness does not bear the stroke.

    Examples
    --------
    >>> f"{hinge_ratio(E=200e9, sigma=400e6, l=50e-3, x=2e-3, h=100e-6):.5f}"
    '0.04172'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", hinge length optimisation.

    """
    share = np.asarray(3.0 * E * h * x / (sigma * l**2), dtype=np.float64)
    if not ((share > 0.0) & (share <= 1.0)).all():
        raise ValueError(
            "no hinge of this thickness bears the stroke: 3 E h x/(σ l²) must lie above 0 and "
            f"at most at 1, got {share}; take a thinner hinge or a longer blade"
        )
    with np.errstate(divide="ignore"):  # the full blade: log 0 = −∞ gives ξ = 1
        return -np.expm1(np.log1p(-share) / 3.0)


def stiffness_spread(*, h: Quantity, tolerance: Quantity) -> tuple[Computed, Computed]:
    """Return stiffness of the thinnest and the thickest hinge over that of the nominal one.

    ``K/K_nominal = (1 ∓ Δ/h)³``; the stress at a given stroke goes with (1 ∓ Δ/h).

    Parameters
    ----------
    h, tolerance : Quantity
        Nominal thickness and the most Δ by which it is missed, either way [m].

    Returns
    -------
    thinnest, thickest : Quantity
        Stiffness over the nominal one [-].

    Notes
    -----
    Δ < h; all hinges miss by the same.

    Examples
    --------
    >>> [round(k, 4) for k in stiffness_spread(h=100e-6, tolerance=5e-6)]
    [0.8574, 1.1576]

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", sensitivity to manufacturing
    tolerances; K ∝ h³.

    """
    return (1.0 - tolerance / h) ** 3, (1.0 + tolerance / h) ** 3


def thickness_for_spread(*, tolerance: Quantity, spread: float) -> Computed:
    """Return the least thickness whose stiffness a tolerance raises by no more than a share.

    ``h = Δ / ((1 + s)^(1/3) − 1)``, about 3Δ/s.

    Parameters
    ----------
    tolerance : Quantity
        The most by which the thickness is missed [m].
    spread : float
        Allowed rise s of the stiffness over the nominal one [-].

    Returns
    -------
    h : Quantity
        Least nominal thickness [m].

    Notes
    -----
    A hinge too thin by Δ is softer by less than s, so the rise decides.

    Examples
    --------
    >>> f"{thickness_for_spread(tolerance=5e-6, spread=0.1) * 1e6:.2f}"
    '154.89'

    References
    ----------
    Inverse of ``stiffness_spread``.

    """
    return tolerance / float(np.expm1(np.log1p(spread) / 3.0))


def shortest_hinge(
    *,
    E: Numbers,
    sigma: Numbers,
    l: Numbers,
    x: Numbers,
    machinable: Numbers,
    tolerance: Numbers,
    spread: float,
) -> Hinge:
    """Return the shortest hinges that can be machined and bear the stroke within tolerance.

    ``h = max(h_min, Δ/((1 + s)^(1/3) − 1))``, then ξ such that a hinge of h + Δ just bears the
    stroke: ``ξ = 1 − (1 − 3 E (h + Δ) x/(σ l²))^(1/3)``.

    Parameters
    ----------
    E, sigma : Quantity
        Young's modulus and admissible stress [Pa].
    l, x : Quantity
        Length of the whole blade and stroke [m]; numbers only.
    machinable, tolerance : Quantity
        Least nominal thickness h_min that can be made and the most Δ by which it is missed [m].
    spread : float
        Allowed rise s of the stiffness over the nominal one [-].

    Returns
    -------
    xi : Quantity
        Share of the blade's length that bends [-].
    h : Quantity
        Nominal thickness of the hinges [m].

    Notes
    -----
    At equal stroke, stiffness along the stroke, aspect ratio and compression all favour short
    hinges. The critical load does not: of a stage free along its stroke it falls with ξ, of a
    locked one it is greatest at ξ = (6 − √15)/7 = 0.304 (chart of
    ``necked_size.hinge_thickness``).

    Raises
    ------
    ValueError
        When even the full blade of that thickness does not bear the stroke.

    Examples
    --------
    >>> xi, h = shortest_hinge(
    ...     E=200e9, sigma=400e6, l=50e-3, x=2e-3, machinable=100e-6, tolerance=5e-6, spread=0.1
    ... )
    >>> f"{xi:.5f} {h * 1e6:.2f}"
    '0.06855 154.89'

    References
    ----------
    Henein & Thalmann, lecture "Dimensioning of flexure joints", conclusion of the hinge length
    optimisation.

    """
    h = np.maximum(machinable, thickness_for_spread(tolerance=tolerance, spread=spread))
    return Hinge(hinge_ratio(E=E, sigma=sigma, l=l, x=x, h=h + tolerance), h)


_CHOICE = {"E": 200e9, "sigma": 400e6, "l": 50e-3, "x": 2e-3}
_HINGE = {"machinable": 100e-6, "tolerance": 5e-6, "spread": 0.1}


CARDS: tuple[Card, ...] = (
    Card("necked-down-hinge", hinge_thickness, _GIVEN, (_SHARE, _STROKE), {"xi": _CHART}),
    Card("necked-down-hinge-aspect", aspect_ratio, _GIVEN, (_SHARE, _SLENDER)),
    Card("necked-down-hinge-ratio", hinge_ratio, {**_CHOICE, "h": 100e-6}, (_SLENDER, _STROKE)),
    Card("necked-down-hinge-spread", stiffness_spread, {"h": 100e-6, "tolerance": 5e-6}),
    Card(
        "necked-down-hinge-least-thickness",
        thickness_for_spread,
        {"tolerance": 5e-6, "spread": 0.1},
    ),
    Card("necked-down-hinge-choice", shortest_hinge, {**_CHOICE, **_HINGE}, (_SLENDER, _STROKE)),
)
