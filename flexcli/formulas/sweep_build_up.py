"""How far a resonance builds up while a sine sweeps through it."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["sweep_build_up"]

POINTS = 4001
"""Places of the sweep at which the envelope is looked at: its top to 1e-6."""


def sweep_build_up(Q: float, f: float, speed: float) -> float:
    """Return the greatest amplitude of a mode that is swept through, over its steady one [-].

    ``y(τ) = ∫_0^∞ exp(−(1 − iδτ) s − iδ s²/2) ds`` with ``δ = (2/π) Q² ḟ/f²`` and τ in units of
    the decay time Q/(π f): the complex envelope where the frequency goes evenly.

    Parameters
    ----------
    Q : float
        Quality factor, well above 1 [-].
    f : float
        Natural frequency [Hz].
    speed : float
        How fast the frequency goes there [Hz/s].

    Returns
    -------
    float
        1 for a slow sweep, less for a fast one.

    Notes
    -----
    Of a lightly damped mode by itself, the sweep's speed that at the resonance: an octave rate r
    [oct/s] is r f ln 2. The integral is the Faddeeva function of a complex argument.

    Examples
    --------
    >>> round(sweep_build_up(50.0, 100.0, 1e-3), 4)
    1.0
    >>> sweep_build_up(500.0, 100.0, 50.0) < 0.5
    True

    References
    ----------
    Lewis (1932), Vibration during acceleration through a critical speed, Transactions of the
    ASME 54.

    """
    from scipy.special import wofz  # seldom wanted, and slow to import

    delta = 2.0 / np.pi * Q**2 * speed / f**2
    root = np.sqrt(0.5j * delta)
    detuned: NDArray[np.float64] = np.linspace(-2.0, 4.0 + 4.0 * np.sqrt(delta), POINTS)
    envelope = np.sqrt(np.pi) / (2.0 * root) * wofz(1j * (1.0 - 1j * detuned) / (2.0 * root))
    return float(np.abs(envelope).max())
