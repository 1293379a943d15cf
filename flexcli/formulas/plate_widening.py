"""Plate widening: between beam and plate, by how far a wide blade stays flat across its width."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "bound", "flat_width", "rigidity_change"]

_SERIES = 0.02
"""β below which 1 − β⁴/180 is exact to 1e-14 and the quotient is not."""


def flat_width(*, b: Quantity, h: Quantity, curvature: Quantity, poisson_ratio: float) -> Quantity:
    """Return the width of a curved blade over the length on which its section can curl.

    ``β = b (3(1 − ν²) κ²/h²)^¼``: the root of Searle's b²κ/h times 1.3 or so.

    Parameters
    ----------
    b, h : Quantity
        Width and thickness [m].
    curvature : Quantity
        Curvature κ along the blade [1/m]; 2σ/(E h) from the bending stress.
    poisson_ratio : float
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


def rigidity_change(*, beta: ArrayLike, poisson_ratio: float) -> NDArray[np.float64]:
    """Return the relative change of bending energy and stiffness of a wide blade against a beam.

    ``(1 − ν² F)/(1 − ν²) − 1``, ``F = (2/β)(cosh β − cos β)/(sinh β + sin β)``: 0 for a narrow
    blade (F = 1), ν²/(1 − ν²) for a wide one (F → 2/β).

    Parameters
    ----------
    beta : array_like
        ``flat_width`` [-].
    poisson_ratio : float
        ν [-].

    Returns
    -------
    change : array
        Secant bending rigidity over EI, less one [-].

    Notes
    -----
    Uniform bending of a blade much longer than wide; clamps keep a shorter one flat, so that
    ``bound`` holds for b ≳ l/2 at any curvature, and the stiffness at rest lies between both.

    Examples
    --------
    >>> [round(float(rigidity_change(beta=b, poisson_ratio=0.3)), 4) for b in (0.1, 2.0, 20.0)]
    [0.0, 0.0078, 0.089]

    References
    ----------
    Ashwell (1950), Journal of the Royal Aeronautical Society 54; derived here as the minimum of
    ∫ D(κ² + 2νκw″ + w″²)/2 + Ehκ²w²/2 dy over the profile w of the section, its sides free.

    """
    x = np.asarray(beta, dtype=np.float64)
    small = x < _SERIES
    safe = np.where(small, 1.0, x)
    decay = np.exp(-safe)
    curl = (1.0 + decay**2 - 2.0 * decay * np.cos(safe)) * 2.0 / safe
    curl = curl / (1.0 - decay**2 + 2.0 * decay * np.sin(safe))
    flat = np.where(small, x**4 / 180.0, 1.0 - curl)
    return np.asarray(bound(poisson_ratio) * flat)


def bound(poisson_ratio: float) -> float:
    """Return the most that plate widening changes a stiffness.

    ``ν²/(1 − ν²)``.

    Parameters
    ----------
    poisson_ratio : float
        ν [-].

    Returns
    -------
    change : float
        Plate over beam stiffness, less one [-].

    Examples
    --------
    >>> round(bound(0.3), 4)
    0.0989

    References
    ----------
    Timoshenko & Woinowsky-Krieger (1959), Theory of Plates and Shells, section 2.

    """
    return poisson_ratio**2 / (1.0 - poisson_ratio**2)


_CHART = Table(
    "beta",
    (0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0, 20.0, 50.0),
    {"change": ("", lambda beta: float(rigidity_change(beta=beta, poisson_ratio=0.3)))},
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
        "plate-widening",
        rigidity_change,
        {"beta": 2.0, "poisson_ratio": 0.3},
        (_LONG,),
        {"beta": _CHART},
    ),
    Card("plate-widening-bound", bound, {"poisson_ratio": 0.3}),
)
