"""Buckling of a wide blade between rigid clamps against that of the beam of the same section."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.plate_factors import FlatShare, ratio

__all__ = ["BUCKLING_ERROR", "CARDS", "buckling_factor"]

Floats = NDArray[np.float64]

BUCKLING_ERROR = {
    "clamped-clamped": 3.5e-3,
    "clamped-pinned": 1e-3,
    "clamped-guided": 8e-4,
    "pinned-pinned": 1.5e-3,
    "clamped-free": 8e-4,
}
"""Largest error of the buckling factors against thin plates, ν ≤ 0.45 and any b/l [-]."""

# as in plate_factors: Ritz solutions of the clamped plate at 27 widths, six Poisson's ratios
_BUCKLED = {
    "clamped-clamped": FlatShare(0.79658, 42.15672, 9.11227, 9.10020, 0.0),
    "clamped-pinned": FlatShare(0.78387, 4.05133, 0.25375, 0.96081, 0.10750),
    "clamped-guided": FlatShare(1.70664, 2.62427, 13.97637, 0.12895, 2.43856),
    "pinned-pinned": FlatShare(0.06140, 0.80725, 1.35132, 0.02889, 0.63639),
    "clamped-free": FlatShare(0.87727, 0.25040, 2.74865, -0.04784, 0.87047),
}
_EDGE_BUCKLES = 0.32161
"""Between clamped ends the free edges of a wide blade buckle first: ρ → 1 − 0.32 ν²."""


def buckling_factor(
    *, b: ArrayLike, l: ArrayLike, ends: str, poisson_ratio: ArrayLike, h: ArrayLike = 0.0
) -> Floats:
    """Return the critical axial force of a wide blade across its thickness over Euler's.

    ``k = 1/(1 − ν² ρ)``, ρ a fraction of polynomials of b/l.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    ends : str
        What holds the bodies at the ends, as of ``euler_load``.
    poisson_ratio : array_like
        ν [-].
    h : array_like
        Thickness; 0 for a thin blade [m].

    Returns
    -------
    k : array
        From 1 (narrow) to nearly 1/(1 − ν²) (wide) [-].

    Notes
    -----
    Both ends stay straight across, the axial force is spread evenly, the long sides are free.
    Within 3.5e-3 of thin plates solved by Ritz's method between clamped ends, 1.5e-3 for all
    others, ν ≤ 0.45.

    Raises
    ------
    KeyError
        When the ends are none of those of ``euler_load``.

    Examples
    --------
    >>> blade = {"b": 0.5, "l": 1.0, "poisson_ratio": 0.3}
    >>> round(float(buckling_factor(ends="clamped-guided", **blade)), 3)
    1.063

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate under axial force, two sides free.

    """
    nu = np.asarray(poisson_ratio, dtype=np.float64)
    if ends == "clamped-clamped":
        nu = nu * np.sqrt(1.0 - _EDGE_BUCKLES * nu**2)
    return _BUCKLED[ends].factor(ratio(b, h, l), nu)


_BLADE = {"b": 10e-3, "l": 20e-3, "poisson_ratio": 0.3, "h": 0.2e-3}

CARDS = (
    Card(
        "plate-buckling",
        buckling_factor,
        {**_BLADE, "ends": "clamped-guided"},
        (Range("b/h", least=1.0, why="a plate is no thicker than wide"),),
    ),
)
