"""An undamped oscillator whose base changes velocity at once."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive

__all__ = ["velocity_shock_acceleration", "velocity_shock_deflection"]

Floats = NDArray[np.float64]


def _speed(V: ArrayLike) -> Floats:
    speed = np.asarray(V, dtype=np.float64)
    if not (np.isfinite(speed).all() and (speed >= 0).all()):
        raise ValueError(f"V must be finite and not negative, got {speed}")
    return speed


def velocity_shock_acceleration(V: ArrayLike, fn: ArrayLike) -> Floats:
    """Give the acceleration an undamped oscillator passes on when its base changes velocity.

    a = V · 2π f_n; in units of gravity, G_t = V (2π f_n)/g.

    Parameters
    ----------
    V : array, any shape
        Sudden change of velocity, [m/s].
    fn : array that broadcasts with `V`
        Natural frequency, [Hz].

    Returns
    -------
    array
        Peak acceleration, [m/s²].

    Raises
    ------
    ValueError
        When V is negative or f_n not positive.

    Notes
    -----
    Exact for a change much faster than 1/f_n (pulse shorter than about 0.1/f_n), and linear:
    the stop does not leave contact. Damping lowers it.

    Examples
    --------
    >>> round(float(velocity_shock_acceleration(1.0, 100.0)), 1)
    628.3

    References
    ----------
    Monti 2014, MSc thesis (MIT), section 3.1.3 "Hard Stop", first displayed equation.
    """
    return _speed(V) * 2 * np.pi * positive(fn=fn)[0]


def velocity_shock_deflection(V: ArrayLike, fn: ArrayLike) -> Floats:
    """Give the deflection of an undamped oscillator when its base changes velocity.

    Δd = V/(2π f_n)

    Parameters
    ----------
    V : array, any shape
        Sudden change of velocity, [m/s].
    fn : array that broadcasts with `V`
        Natural frequency, [Hz].

    Returns
    -------
    array
        Peak deflection, [m].

    Raises
    ------
    ValueError
        When V is negative or f_n not positive.

    Examples
    --------
    >>> round(float(velocity_shock_deflection(1.0, 100.0)), 7)
    0.0015915

    References
    ----------
    Monti 2014, MSc thesis (MIT), section 3.1.3 "Hard Stop", second displayed equation.
    """
    return _speed(V) / (2 * np.pi * positive(fn=fn)[0])
