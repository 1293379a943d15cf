"""Response of a stage of one degree of freedom to its base's acceleration: T(ω) = X/((jω)² Γ)."""

from math import pi, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["natural_frequency", "transfer"]


def natural_frequency(k: float, m: float) -> float:
    """Return √(k/m)/2π [Hz]; 0 without stiffness.

    Examples
    --------
    >>> round(natural_frequency(864.0, 1.0), 2)
    4.68

    """
    return sqrt(k / m) / (2.0 * pi)


def transfer(
    f: ArrayLike, *, m: float, k: float, coupling: float, Q: float = np.inf
) -> NDArray[np.complex128]:
    """Return displacement over acceleration of the base, per frequency.

    T = τ/(m ω² − k − jωc) with c = √(k m)/Q, which is τ/k · 1/((ω/ω_0)² − 1) without damping.

    Parameters
    ----------
    f : array
        Frequency, [Hz].
    m, k : float
        Equivalent mass and stiffness, [kg], [N/m]; a stiffness of zero is a free mass.
    coupling : float
        τ, [kg].
    Q : float
        Quality factor; infinite without damping.

    Returns
    -------
    array of complex
        T, [s²], in the shape of ``f``; infinite at an undamped resonance.

    Notes
    -----
    Written over the common denominator, so that k = 0 needs no case of its own.

    Examples
    --------
    >>> static = transfer(0.0, m=1.0, k=864.0, coupling=1.0)
    >>> round(float(static.real) * 864.0, 6)
    -1.0

    References
    ----------
    Exercise 9 part I, question 5 (without damping).

    """
    omega = 2.0 * np.pi * np.asarray(f, dtype=np.float64)
    denominator = (m * omega**2 - k) - 1j * omega * (np.sqrt(k * m) / Q)
    with np.errstate(divide="ignore", invalid="ignore"):
        found = np.asarray(coupling / denominator, dtype=np.complex128)
    resonant = denominator == 0.0
    limit = complex(np.inf) if coupling else 0.0
    return np.where(resonant, limit, found).astype(np.complex128)
