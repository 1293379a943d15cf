"""How an axial force changes the bending stiffness of a clamped blade: stability functions.

n = N l²/(EI) is the tension in units of the blade; −π² and below is beyond Euler's load for
pinned ends, where the functions still hold until the blade's own end conditions buckle.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["s_bending", "uniform_bending"]

_SERIES = 1e-3
"""|n| below which the series, whose next term is n⁴, is more exact than the quotient."""


def uniform_bending(n: ArrayLike) -> NDArray[np.float64]:
    """Return the stiffness against opposite rotations of the ends over that without tension.

    ``(√n/2)/tanh(√n/2)``, with tan for compression.

    Examples
    --------
    >>> round(float(uniform_bending(12e-3)), 6)
    1.001

    """
    x = np.asarray(n, dtype=np.float64)
    series = 1.0 + x / 12.0 - x**2 / 720.0 + x**3 / 30240.0
    small = np.abs(x) < _SERIES
    return np.where(small, series, 1.0 / _tanh_over(np.where(small, 1.0, x)))


def s_bending(n: ArrayLike) -> NDArray[np.float64]:
    """Return the stiffness against equal rotations of the ends over that without tension.

    ``(n/12) τ/(1 − τ)``, ``τ = tanh(√n/2)/(√n/2)``, with tan for compression.

    Examples
    --------
    >>> round(float(s_bending(60e-3)), 5)
    1.001

    """
    x = np.asarray(n, dtype=np.float64)
    series = 1.0 + x / 60.0 - x**2 / 8400.0 + x**3 / 756000.0
    small = np.abs(x) < _SERIES
    safe = np.where(small, 1.0, x)
    tau = _tanh_over(safe)
    return np.where(small, series, safe / 12.0 * tau / (1.0 - tau))


def _tanh_over(n: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return tanh(√n/2)/(√n/2), n ≠ 0."""
    half = np.sqrt(np.abs(n)) / 2.0
    return np.asarray(np.where(n > 0.0, np.tanh(half), np.tan(half)) / half)
