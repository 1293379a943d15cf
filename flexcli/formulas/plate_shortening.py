"""How much more a wide blade between rigid clamps shortens as it bends than the beam of it."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.plate_factors import bound, cantilever_factor, pure_bending_factor

__all__ = ["cantilever_shift_factor", "pure_shortening_factor", "s_shortening_factor"]

Floats = NDArray[np.float64]


def pure_shortening_factor(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return how much more a blade in pure bending shortens than the beam.

    ``½∫w'² dx``, mean over the width, over θ² l/24.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        At most 1.02 for ν = 0.3 [-].

    Notes
    -----
    Within 2e-3 of thin plates solved by Ritz's method, ν ≤ ½.

    Examples
    --------
    >>> round(float(pure_shortening_factor(b=0.5, l=1.0, poisson_ratio=0.3)), 3)
    1.019

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    shape = 1.29865 * x * (1.0 + 1.07399 * x)
    shape = shape / (1.0 + 3.59535 * x + 3.00137 * x**2 + 12.30435 * x**3)
    return np.asarray(1.0 + bound(poisson_ratio) * shape)


def s_shortening_factor(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return how much more a guided blade shortens than the beam.

    ``½∫w'² dx``, mean over the width, over 3x²/(5l).

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        At most 1.006 for ν = 0.3 [-].

    Notes
    -----
    Within 5e-4 of thin plates solved by Ritz's method, ν ≤ ½.

    Examples
    --------
    >>> round(float(s_shortening_factor(b=0.2, l=1.0, poisson_ratio=0.3)), 4)
    1.0052

    References
    ----------
    Derived here: Ritz's method on the Kirchhoff plate.

    """
    x = np.asarray(b, dtype=np.float64) / np.asarray(l, dtype=np.float64)
    shape = 0.64587 * x * (1.0 + 2.46988 * x)
    shape = shape / (1.0 + 7.34251 * x + 11.01224 * x**2 + 92.09705 * x**3)
    return np.asarray(1.0 + bound(poisson_ratio) * shape)


def cantilever_shift_factor(*, b: ArrayLike, l: ArrayLike, poisson_ratio: ArrayLike) -> Floats:
    """Return how much more the tip of a cantilever moves towards the clamp than the beam's.

    ``(τ²/24 + τ²/8 + τ(1 − τ/2)/2 + ⅗(1 − τ/2)²)/⅗``, the first and the last times the factors of
    pure bending and of the S shape, at the tip's rotation ``τ = θ l/x``.

    Parameters
    ----------
    b, l : array_like
        Width and length [m].
    poisson_ratio : array_like
        ν [-].

    Returns
    -------
    factor : array
        Over 3x²/(5l) at the same travel [-].

    Examples
    --------
    >>> float(cantilever_shift_factor(b=0.2, l=1.0, poisson_ratio=0.0))
    1.0

    References
    ----------
    Derived here, from the factors of the two shapes.

    """
    blade = {"b": b, "l": l, "poisson_ratio": poisson_ratio}
    turn = 1.5 * cantilever_factor(**blade) / pure_bending_factor(**blade)
    sheared = 1.0 - turn / 2.0
    path = turn**2 / 24.0 * pure_shortening_factor(**blade) + turn**2 / 8.0
    path = path + turn * sheared / 2.0 + 0.6 * sheared**2 * s_shortening_factor(**blade)
    return np.asarray(path / 0.6)
