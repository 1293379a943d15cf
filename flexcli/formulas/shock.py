"""Greatest response of oscillators to a shock of their base: half-sine, step of velocity, spectrum.

The half-sine pulse is A sin(πt/τ) for 0 ≤ t ≤ τ. "Primary" is the greatest response while it
lasts, "residual" the greatest after it.
"""

from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card
from flexcli.formulas.spectrum import checked_profile, spectral_level

__all__ = [
    "CARDS",
    "half_sine_sums",
    "srs_level",
    "velocity_shock_acceleration",
]


Floats = NDArray[np.float64]

# Samples per period of the faster of pulse and oscillator, then zooms into the best bracket,
# each to 1/8 of the step: 1/48 period shrinks to 1e-8 of it, and a maximum is flat.
_SAMPLES = 48
_ZOOM_POINTS, _ZOOMS = 17, 8
# An oscillator of more periods in the pulse follows it.
_MOST_PERIODS = 200.0


def _relative_motion(phase: Floats, s: Floats, Q: Floats) -> tuple[Floats, Floats]:
    """ω²z/A and ωż/A at time `phase`·τ within the pulse: steady part and decaying part."""
    zeta = 0.5 / Q
    beta = 0.5 / s  # pulse frequency over natural frequency
    # z'' + 2ζω z' + ω² z = −A sin(Ωt) has the steady part −A·Im(H e^{iΩt})/ω²
    H = 1 / (1 - beta**2 + 2j * zeta * beta)
    turn = H * np.exp(1j * np.pi * phase)
    steady, steady_rate = -turn.imag, -beta * turn.real
    start, start_rate = H.imag, beta * H.real  # cancels the steady part at t = 0
    angle = 2 * np.pi * s * phase
    wander = np.sqrt(np.maximum(0.0, 1 - zeta**2))
    decay = np.exp(-zeta * angle)
    cosine = np.cos(wander * angle)
    sine = angle * np.sinc(wander * angle / np.pi)  # sin(ω_d t)·ω/ω_d, also for ω_d = 0
    z = steady + decay * (start * (cosine + zeta * sine) + start_rate * sine)
    rate = steady_rate + decay * (start_rate * (cosine - zeta * sine) - start * sine)
    return z, rate


def _residual_maximum(z: Floats, rate: Floats, Q: Floats) -> Floats:
    """Greatest ω²|z|/A of the free motion from (z, ż/ω) on: now, or at the next turning."""
    zeta = 0.5 / Q
    wander = np.sqrt(np.maximum(1 - zeta**2, 0.0))
    # ż(θ) ∝ ż (cos − ζ sin') − z sin', with sin' = sin(w θ)/w
    lean = z + zeta * rate
    turn = np.where(
        wander > 0,
        np.mod(np.arctan2(rate * wander, lean), np.pi) / np.where(wander > 0, wander, 1.0),
        np.where(rate * lean > 0, rate / np.where(lean == 0, 1.0, lean), 0.0),
    )
    sine = turn * np.sinc(wander * turn / np.pi)
    cosine = np.cos(wander * turn)
    later: Floats = np.exp(-zeta * turn) * (z * (cosine + zeta * sine) + rate * sine)
    greatest: Floats = np.maximum(np.abs(z), np.abs(later))
    return greatest


def _phases(s: float) -> Floats:
    """Moments within a pulse, as parts of it, between which nothing that turns s times is lost."""
    return np.linspace(0.0, 1.0, int(np.ceil(_SAMPLES * (s + 0.5))) + 1)


def _greatest(size: Callable[[Floats], Floats], phase: Floats) -> float:
    """Greatest size within the pulse, by sampling and zooming in."""
    best = 0.0
    for _ in range(_ZOOMS):
        sampled = size(phase)
        at = int(np.argmax(sampled))
        best = float(sampled[at])
        phase = np.linspace(phase[max(at - 1, 0)], phase[min(at + 1, phase.size - 1)], _ZOOM_POINTS)
    return best


def half_sine_sums(
    coefficients: Sequence[Floats], fn: ArrayLike, Q: float, A: float, tau: float
) -> list[float]:
    """Give the greatest sums of the motions of oscillators whose base has a half-sine pulse.

    max over places and time of |Σ c_i ω_i² z_i(t)|, with z'' + ω z'/Q + ω² z = −A sin(πt/τ), solved
    in closed form. Within the pulse the motions are added at each moment; after it, where each goes
    on at its own frequency, their peaks are, which they reach or stay below.

    Parameters
    ----------
    coefficients : sequence of array, each of shape (places, components, n)
        Share of each oscillator's pseudo-acceleration in each sum; the components at a place are
        those of a vector.
    fn : array, shape (n,)
        Natural frequencies [Hz].
    Q : float
        Quality factor of all, at least 0.5, [-].
    A : float
        Peak base acceleration [m/s²].
    tau : float
        Duration of the pulse [s].

    Returns
    -------
    list of float
        The greatest size of each, [m/s²] times the coefficients' unit.

    Raises
    ------
    ValueError
        When a value is not positive, or Q is below 0.5 (critical damping).

    Notes
    -----
    The motion is exact; an oscillator of f_n τ > 200 follows the pulse, within 1 % of A. The worst
    place is told by 48 samples a period, its maximum within the pulse refined to 1e-12 relative.
    Near f_n τ = 1/2, steady and decaying parts cancel to about Q/1e16 of the result.

    Examples
    --------
    >>> shares = np.array([[[0.5, 0.5]]])
    >>> (slow_pulse,) = half_sine_sums([shares], [300.0, 700.0], 10.0, 1.0, 0.1)
    >>> round(slow_pulse, 2)
    1.0

    References
    ----------
    Lalanne 2009, Mechanical Vibration and Shock Analysis, vol. 2, section 2.
    """
    natural, quality, peak, duration = positive(fn=fn, Q=Q, A=A, tau=tau)
    if not quality >= 0.5:
        raise ValueError(f"Q must be at least 0.5 (critical damping), got {quality:g}")
    s = natural * duration
    moves = s <= _MOST_PERIODS
    turns = np.where(moves, s, 1.0)[:, None]

    def motion(phase: Floats) -> tuple[Floats, Floats]:
        z, rate = _relative_motion(phase, turns, quality)
        return np.where(moves[:, None], z, -np.sin(np.pi * phase)), rate

    phase = _phases(float(turns.max()))
    within, rates = motion(phase)
    after = _residual_maximum(within[:, -1], rates[:, -1], quality) * moves
    found = []
    for c in coefficients:
        squares = ((c.reshape(-1, c.shape[-1]) @ within) ** 2).reshape(*c.shape[:2], -1).sum(axis=1)
        place, at = np.unravel_index(int(np.argmax(squares)), squares.shape)

        def size(t: Floats, worst: Floats = c[place]) -> Floats:
            return np.asarray(np.linalg.norm(worst @ motion(t)[0], axis=0))

        primary = _greatest(size, phase[max(at - 1, 0) : at + 2])
        residual = float(np.linalg.norm(np.abs(c) @ after, axis=-1).max())
        found.append(float(peak) * max(primary, residual))
    return found


def _speed(V: ArrayLike) -> Floats:
    speed = np.asarray(V, dtype=np.float64)
    if not (np.isfinite(speed).all() and (speed >= 0).all()):
        raise ValueError(f"V must be finite and not negative, got {speed}")
    return speed


def velocity_shock_acceleration(V: ArrayLike, fn: ArrayLike) -> Floats:
    """Give the acceleration an undamped oscillator passes on when its base changes velocity.

    ``a = 2π f_n V``; in units of gravity ``G_t = a/g``. It deflects by ``V/(2π f_n)``, and on a
    blade V is less below the tip by ``φ(x/L)``, the bent shape.

    Parameters
    ----------
    V : array, any shape
        Sudden change of velocity [m/s].
    fn : array that broadcasts with `V`
        Natural frequency [Hz].

    Returns
    -------
    array
        Peak acceleration [m/s²].

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


def srs_level(fn: ArrayLike, frequency: ArrayLike, level: ArrayLike) -> Floats:
    """Interpolate a shock response spectrum given by a table, in log-log axes.

    S(f) = S_1 (f/f_1)^m, m = ln(S_2/S_1)/ln(f_2/f_1)

    Parameters
    ----------
    fn : array, any shape
        Natural frequency, [Hz].
    frequency : array, shape (n,)
        Breakpoints, non-decreasing, [Hz].
    level : array, shape (n,)
        Peak acceleration of an oscillator of that frequency, [m/s²].

    Returns
    -------
    array
        Peak acceleration; at a step the greater, [m/s²].

    Raises
    ------
    ValueError
        When the table is not sound, or `fn` lies outside it: a shock response spectrum is not
        zero there, it is unknown.

    Examples
    --------
    >>> round(float(srs_level(1000.0, [100, 10000], [20.0, 2000.0])), 9)
    200.0
    """
    f, s = checked_profile(frequency, level)
    (asked,) = positive(fn=fn)
    if asked.size and not (asked.min() >= f[0] and asked.max() <= f[-1]):
        raise ValueError(
            f"the table spans {f[0]:g} to {f[-1]:g} Hz, asked {asked.min():g} to {asked.max():g} Hz"
        )
    return spectral_level(asked, f, s, side="upper")


CARDS: tuple[Card, ...] = (
    Card("velocity-shock", velocity_shock_acceleration, {"V": 1.0, "fn": 100.0}),
)
