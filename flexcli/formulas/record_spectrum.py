"""Response of oscillators to a recorded base acceleration: its turning points and maxima.

The record is a straight line between samples; there the motion is a closed form. With the pole
s = ω_n (−ζ + i √(1 − ζ²)) and q' = s q − a, the displacement relative to the base is Im(q)/ω_d and
the absolute acceleration Im(s² q)/ω_d.
"""

from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive

__all__ = ["SAMPLES", "record_turns", "shock_response_spectrum"]

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]

SAMPLES = 16
"""Points a natural period at which the motion is looked at; a cubic between them finds its turns
to (2π/16)⁴/384 = 6e-5 of the amplitude."""

_REST = 1.5
_SERIES = 14
_SMALL = 0.5

Signal = Literal["absolute", "relative"]


def _phi(x: complex) -> tuple[complex, complex]:
    """(eˣ − 1)/x and (eˣ − 1 − x)/x²; a series where they cancel."""
    if abs(x) > _SMALL:
        first = np.expm1(x) / x
        return complex(first), complex((first - 1.0) / x)
    term, second = 0.5 + 0j, 0.5 + 0j
    for k in range(3, 3 + _SERIES):
        term *= x / k
        second += term
    return 1.0 + x * second, second


def _states(a: Floats, dt: float, s: complex, count: int) -> tuple[Complex, Floats]:
    """Return the state q at `count` points a sample, and the acceleration of the base there."""
    from scipy.signal import lfilter

    first, second = _phi(s * dt)
    early, late = -dt * (first - second), -dt * second
    at_samples: Complex = lfilter(
        [late, early], [1.0, -np.exp(s * dt)], a.astype(np.complex128), zi=np.array([-late * a[0]])
    )[0]
    if count == 1:
        return at_samples, a
    q, base = np.empty((a.size, count), complex), np.empty((a.size, count))
    rise = np.append(np.diff(a), 0.0)
    for j in range(count):
        tau = dt * j / count
        first, second = _phi(s * tau)
        base[:, j] = a + rise * j / count
        q[:, j] = np.exp(s * tau) * at_samples - tau * (a * first + rise * (j / count) * second)
    last = (a.size - 1) * count + 1
    return q.ravel()[:last], base.ravel()[:last]


def record_turns(
    acceleration: ArrayLike,
    dt: float,
    fn: float,
    Q: float,
    *,
    signal: Signal = "absolute",
    rest: float = _REST,
) -> Floats:
    """Give the turning points of an oscillator's response to a recorded base acceleration.

    z'' + ω_n z'/Q + ω_n² z = −a(t), at rest before; a absolute = −(ω_n z'/Q + ω_n² z)

    Parameters
    ----------
    acceleration : array, shape (n,)
        Base acceleration at equal steps, two samples or more, [m/s²].
    dt : float
        Time between samples, [s].
    fn : float
        Natural frequency, [Hz].
    Q : float
        Quality factor 1/(2ζ), above 0.5, [-].
    signal : "absolute" or "relative"
        Absolute acceleration [m/s²], or displacement relative to the base [m].
    rest : float
        Natural periods that the free motion is followed after the record, [-].

    Returns
    -------
    array, shape (m,)
        Values at the turns in their order, from rest on, [m/s² or m].

    Raises
    ------
    ValueError
        When the record has fewer than two samples or is not finite, or Q is not above 0.5.

    Notes
    -----
    Exact between samples for a record that is straight there; turns to 6e-5 of the amplitude. A
    real signal is no straight line: sample it ten times as fast as its highest frequency.

    Examples
    --------
    >>> held = record_turns([0.0, *[1.0] * 1000], 0.001, 10.0, 1e6)
    >>> round(float(held.max()), 3)
    2.0

    References
    ----------
    Lalanne 2009, Mechanical Vibration and Shock Analysis, vol. 2, section 2.
    """
    return _Motion(acceleration, dt, fn, Q, rest).turns(signal)


class _Motion:
    """The motion of one oscillator during a record and after it."""

    def __init__(self, acceleration: ArrayLike, dt: float, fn: float, Q: float, rest: float):
        a = np.asarray(acceleration, dtype=np.float64)
        if a.ndim != 1 or a.size < 2 or not np.isfinite(a).all():
            raise ValueError("a record has two samples or more, all of them finite")
        (natural, step) = (float(each) for each in positive(fn=fn, dt=dt))
        if not Q > 0.5:
            raise ValueError(f"Q must be above 0.5 (critical damping), got {Q:g}")
        zeta = 0.5 / Q
        self.s = 2.0 * np.pi * natural * complex(-zeta, np.sqrt(1.0 - zeta**2))
        free = np.zeros(int(np.ceil(rest / (natural * step))) + 1)
        count = max(1, int(np.ceil(SAMPLES * natural * step)))
        self.q, self.base = _states(np.concatenate([a, free]), step, self.s, count)
        self.h = step / count

    def turns(self, signal: Signal) -> Floats:
        """Return the turns of absolute acceleration or of relative displacement."""
        s = self.s
        weight = s**2 / s.imag if signal == "absolute" else 1.0 / s.imag + 0j
        turned = weight * self.q
        slope = (s * turned).imag - weight.imag * self.base
        return _turns(turned.imag, slope, self.h)


def _turns(value: Floats, slope: Floats, h: float) -> Floats:
    """Values at the turns of the cubics through values and slopes, beside first and last value."""
    at = np.flatnonzero(slope[:-1] * slope[1:] < 0.0)
    y0, y1 = value[at], value[at + 1]
    m0, m1 = h * slope[at], h * slope[at + 1]
    # y0 + m0 t + c t² + d t³ on 0 to 1; its slope m0 + 2 c t + 3 d t² changes sign once
    c, d = 3.0 * (y1 - y0) - 2.0 * m0 - m1, 2.0 * (y0 - y1) + m0 + m1
    root = np.sqrt(np.maximum(c**2 - 3.0 * d * m0, 0.0))
    lower = c + np.where(c >= 0.0, root, -root)
    first = np.divide(-m0, lower, out=np.full_like(c, 0.5), where=lower != 0.0)
    other = np.divide(-lower, 3.0 * d, out=np.full_like(c, 0.5), where=d != 0.0)
    t = np.where((first >= 0.0) & (first <= 1.0), first, np.clip(other, 0.0, 1.0))
    turned = y0 + t * (m0 + t * (c + t * d))
    return np.concatenate([value[:1], turned, value[-1:]])


def shock_response_spectrum(
    acceleration: ArrayLike, dt: float, fn: ArrayLike, Q: float
) -> tuple[Floats, Floats, Floats]:
    """Give the shock response spectrum of a recorded base acceleration.

    S(f_n) = max |a absolute(t)|, during the record and after it

    Parameters
    ----------
    acceleration : array, shape (n,)
        Base acceleration at equal steps, [m/s²].
    dt : float
        Time between samples, [s].
    fn : array, shape (m,)
        Natural frequencies, [Hz].
    Q : float
        Quality factor, above 0.5, [-].

    Returns
    -------
    positive, negative : arrays, shape (m,)
        Greatest and least absolute acceleration, the latter as a size, [m/s²].
    pseudo : array, shape (m,)
        Greatest ω_n² |z|, the spring force per mass, [m/s²].

    Notes
    -----
    Of the motion that `record_turns` follows.

    Examples
    --------
    >>> t = np.linspace(0.0, 0.011, 1001)
    >>> pulse = 1.0 * np.sin(np.pi * t / 0.011)
    >>> up, down, spring = shock_response_spectrum(pulse, t[1], [0.8 / 0.011], 1e6)
    >>> round(float(up[0]), 3)
    1.768

    References
    ----------
    Lalanne 2009, Mechanical Vibration and Shock Analysis, vol. 2, section 2.
    """
    found = []
    for each in np.atleast_1d(np.asarray(fn, dtype=np.float64)).tolist():
        motion = _Motion(acceleration, dt, each, Q, _REST)
        turns, relative = motion.turns("absolute"), motion.turns("relative")
        spring = (2.0 * np.pi * each) ** 2 * np.abs(relative).max()
        found.append((max(turns.max(), 0.0), max(-turns.min(), 0.0), spring))
    up, down, pseudo = np.array(found).T
    return up, down, pseudo
