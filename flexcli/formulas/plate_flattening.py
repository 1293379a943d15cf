"""Flattening with curvature: a curved wide blade keeps its section from curling, clamps or not."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.plate_factors import bound
from flexcli.formulas.quantity import Computed, Numbers

__all__ = [
    "CARDS",
    "energy_factor",
    "flat_width",
    "held_and_curved",
    "secant_factor",
    "tangent_factor",
]

Floats = NDArray[np.float64]

_SERIES = 0.3
"""Below this β the quotient loses digits, and two terms of its series are exact to 1e-6."""


def flat_width(*, b: Numbers, h: Numbers, curvature: Numbers, poisson_ratio: Numbers) -> Computed:
    """Return the width of a curved blade over the length on which its section can curl.

    ``β = b (3(1 − ν²) κ²/h²)^¼``: the root of Searle's b²κ/h times 1.3 or so.

    Parameters
    ----------
    b, h : Quantity
        Width and thickness [m].
    curvature : Quantity
        Curvature κ along the blade [1/m]; 2σ/(E h) from the bending stress.
    poisson_ratio : Quantity
        ν [-].

    Returns
    -------
    beta : Quantity
        Below 1 the section curls as a beam's, above 10 it stays flat as a plate's [-].

    Examples
    --------
    >>> round(float(flat_width(b=10e-3, h=0.1e-3, curvature=1.0, poisson_ratio=0.3)), 4)
    1.2854

    References
    ----------
    Searle (1908), Experimental Elasticity; Ashwell (1950), Journal of the Royal Aeronautical
    Society 54.

    """
    return b * np.sqrt(np.sqrt(3.0 * (1.0 - poisson_ratio**2)) * np.abs(curvature) / h)


def secant_factor(*, beta: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the moment of a curved wide blade over the beam's E I κ.

    ``M/(E I κ) = (1 − ν² (F + β F'/4))/(1 − ν²)``, ``F = (2/β)(cosh β − cos β)/(sinh β + sin β)``.

    Parameters
    ----------
    beta : array_like
        ``flat_width`` [-].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        1 for a narrow or little curved blade, 1/(1 − ν²) for a wide and much curved one [-].

    Notes
    -----
    Uniform bending far from clamps, which flatten the section besides.

    Examples
    --------
    >>> [round(float(secant_factor(beta=b, poisson_ratio=0.3)), 4) for b in (0.1, 2.0, 20.0)]
    [1.0, 1.0147, 1.0915]

    References
    ----------
    Ashwell (1950), Journal of the Royal Aeronautical Society 54; derived here as dU/dκ of the
    least energy U = ∫ D(κ² + 2νκw″ + w″²)/2 + Ehκ²w²/2 dy over the profile w of the section, its
    sides free.

    """
    return np.asarray(1.0 + bound(poisson_ratio) * _flat(beta)[1])


def energy_factor(*, beta: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the bending energy of a curved wide blade over the beam's E I κ²/2.

    ``2U/(E I κ²) = (1 − ν² F)/(1 − ν²)``, F as in ``secant_factor``.

    Parameters
    ----------
    beta : array_like
        ``flat_width`` [-].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        At most that of the moment, for the factor of the energy rises with κ [-].

    Notes
    -----
    Uniform bending far from clamps, which only add to the energy: it is a lower bound beside them,
    of their energy and so of the moment.

    Examples
    --------
    >>> round(float(energy_factor(beta=2.0, poisson_ratio=0.3)), 4)
    1.0078

    References
    ----------
    Derived here: U of ``secant_factor`` at its least.

    """
    return np.asarray(1.0 + bound(poisson_ratio) * _flat(beta)[0])


def tangent_factor(*, beta: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the bending stiffness of a wide blade about a curved state over the beam's EI.

    ``dM/dκ / (E I)`` of ``secant_factor``.

    Parameters
    ----------
    beta : array_like
        ``flat_width`` [-].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        Above the secant's at moderate curvature [-].

    Examples
    --------
    >>> round(float(tangent_factor(beta=2.0, poisson_ratio=0.3)), 4)
    1.0393

    References
    ----------
    Derived here, from ``secant_factor``.

    """
    return np.asarray(1.0 + bound(poisson_ratio) * _flat(beta)[2])


def held_and_curved(*, held: ArrayLike, curved: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return the factor of a blade that its clamps and its curvature flatten together.

    ``1 − ρ = (1 − ρ_held)(1 − ρ_curved)``, ``k = 1/(1 − ν² ρ)``.

    Parameters
    ----------
    held : array_like
        Factor by the clamps alone [-].
    curved : array_like
        Factor by the curvature alone [-].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        At least either, at most 1/(1 − ν²) [-].

    Notes
    -----
    In energy the larger of both is a lower bound, 1/(1 − ν²) an upper one; between them this is
    an interpolation.

    Examples
    --------
    >>> round(float(held_and_curved(held=1.04, curved=1.0, poisson_ratio=0.3)), 6)
    1.04

    References
    ----------
    Derived here: both constraints taken as independent.

    """
    nu2 = np.asarray(poisson_ratio, dtype=np.float64) ** 2
    safe = np.where(nu2 > 0.0, nu2, 1.0)
    left = (1.0 - (1.0 - 1.0 / np.asarray(held)) / safe) * (
        1.0 - (1.0 - 1.0 / np.asarray(curved)) / safe
    )
    return np.asarray(1.0 / (1.0 - nu2 * (1.0 - np.clip(left, 0.0, 1.0))))


def _flat(beta: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Return the shares kept flat: 1 − F, 1 − F − βF'/4, 1 − F − ⅞βF' − β²F″/8.

    They are those of energy, moment and tangent.
    """
    x = np.asarray(beta, dtype=np.float64)
    small = x < _SERIES
    safe = np.where(small, 1.0, x)
    # all over e^β, which would overflow
    fading = np.exp(-safe)
    sine, cosine = 2.0 * fading * np.sin(safe), 2.0 * fading * np.cos(safe)
    plus, minus = 1.0 + fading**2, 1.0 - fading**2
    top, bottom = plus - cosine, minus + sine  # cosh − cos, sinh + sin
    rate = (minus + sine) / bottom - top * (plus + cosine) / bottom**2  # of top/bottom
    # second derivative of q = top/bottom, q' = 1 − q s with s = (cosh + cos)/(sinh + sin)
    q, s = top / bottom, (plus + cosine) / bottom
    s_rate = (minus - sine) / bottom - s**2
    q_2 = -rate * s - q * s_rate
    F = 2.0 * q / safe
    F_1 = 2.0 * (rate - q / safe) / safe
    F_2 = 2.0 * (q_2 - 2.0 * rate / safe + 2.0 * q / safe**2) / safe
    secant = 1.0 - F - safe * F_1 / 4.0
    tangent = 1.0 - F - 0.875 * safe * F_1 - safe**2 * F_2 / 8.0
    # F = 1 − β⁴/180 + β⁸/22680 − O(β¹²)
    first = np.minimum(x, 1.0) ** 4
    energy = np.where(small, first / 180.0 - first**2 / 22680.0, 1.0 - F)
    secant = np.where(small, first / 90.0 - first**2 / 7560.0, secant)
    return energy, secant, np.where(small, first / 30.0 - first**2 / 1512.0, tangent)


_CHART = Table(
    "beta",
    (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 20.0, 50.0),
    {
        "secant": ("", lambda beta: float(secant_factor(beta=beta, poisson_ratio=0.3))),
        "tangent": ("", lambda beta: float(tangent_factor(beta=beta, poisson_ratio=0.3))),
    },
    "ν = 0.3",
)
_LONG = Range("b/l", most=0.2, why="clamps keep a shorter blade flat across its width")

CARDS = (
    Card(
        "plate-flat-width",
        flat_width,
        {"b": 10e-3, "h": 0.1e-3, "curvature": 1.0, "poisson_ratio": 0.3},
        (_LONG,),
    ),
    Card(
        "plate-flattening",
        secant_factor,
        {"beta": 2.0, "poisson_ratio": 0.3},
        (_LONG,),
        {"beta": _CHART},
    ),
    Card(
        "plate-flattening-tangent",
        tangent_factor,
        {"beta": 2.0, "poisson_ratio": 0.3},
        (_LONG,),
    ),
)
