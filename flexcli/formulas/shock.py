"""Greatest response of an oscillator to a shock of its base: half-sine, step of velocity, spectrum.

The half-sine pulse is A sin(πt/τ) for 0 ≤ t ≤ τ. "Primary" is the greatest response while it
lasts, "residual" the greatest after it.
"""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card
from flexcli.formulas.spectrum import checked_profile, spectral_level

__all__ = [
    "CARDS",
    "PulseResponse",
    "half_sine_damped",
    "srs_level",
    "velocity_shock_acceleration",
]


Floats = NDArray[np.float64]

# Samples per period of the faster of pulse and oscillator, then zooms into the best bracket,
# each to 1/8 of the step: 1/48 period shrinks to 1e-8 of it, and a maximum is flat.
_SAMPLES = 48
_ZOOM_POINTS, _ZOOMS = 17, 8
# Beyond this many periods in the pulse it is quasi-static, and is refused.
_MOST_PERIODS = 200.0


@dataclass(frozen=True, eq=False)
class PulseResponse:
    """Greatest absolute values during (`primary`) and after (`residual`) a pulse, [m/s²]."""

    primary: Floats
    residual: Floats

    @property
    def maximax(self) -> Floats:
        """The greater of both [m/s²]."""
        return np.maximum(self.primary, self.residual)


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


def _signal(z: Floats, rate: Floats, Q: Floats, quantity: str) -> Floats:
    return -z - rate / Q if quantity == "absolute" else -z


def _residual_maximum(z: Floats, rate: Floats, Q: Floats, quantity: str) -> Floats:
    """Greatest |signal| of the free motion from (z, ż/ω) on: now, or at the next turning."""
    zeta = 0.5 / Q
    acceleration = -z - rate / Q
    value = _signal(z, rate, Q, quantity)
    # the signal itself obeys the free equation, so its slope and z's combine linearly
    slope = -rate - acceleration / Q if quantity == "absolute" else -rate
    wander = np.sqrt(np.maximum(1 - zeta**2, 0.0))
    # slope(θ) ∝ slope·(cos − ζ sin') − value·sin', with sin' = sin(w θ)/w
    lean = value + zeta * slope
    turn = np.where(
        wander > 0,
        np.mod(np.arctan2(slope * wander, lean), np.pi) / np.where(wander > 0, wander, 1.0),
        np.where(slope * lean > 0, slope / np.where(lean == 0, 1.0, lean), 0.0),
    )
    sine = turn * np.sinc(wander * turn / np.pi)
    cosine = np.cos(wander * turn)
    later: Floats = np.exp(-zeta * turn) * (value * (cosine + zeta * sine) + slope * sine)
    greatest: Floats = np.maximum(np.abs(value), np.abs(later))
    return greatest


def _one_primary(s: float, Q: float, quantity: str) -> float:
    """Greatest |signal|/A within the pulse, by sampling and zooming in."""
    s_, Q_ = np.asarray(s), np.asarray(Q)
    phase = np.linspace(0.0, 1.0, int(np.ceil(_SAMPLES * (s + 0.5))) + 1)
    best = 0.0
    for _ in range(_ZOOMS):
        size = np.abs(_signal(*_relative_motion(phase, s_, Q_), Q_, quantity))
        at = int(np.argmax(size))
        best = float(size[at])
        phase = np.linspace(phase[max(at - 1, 0)], phase[min(at + 1, phase.size - 1)], _ZOOM_POINTS)
    return best


def half_sine_damped(
    fn: ArrayLike,
    Q: ArrayLike,
    A: ArrayLike,
    tau: ArrayLike,
    *,
    quantity: Literal["absolute", "pseudo"] = "absolute",
) -> PulseResponse:
    """Give the response maxima of a damped oscillator to a half-sine base pulse.

    z'' + ω_n z'/Q + ω_n² z = −A sin(πt/τ), solved in closed form during and after the pulse;
    absolute acceleration −(ω_n z'/Q + ω_n² z), pseudo-acceleration ω_n² z.

    Parameters
    ----------
    fn : array, any shape
        Natural frequency, with f_n τ ≤ 200, [Hz].
    Q : array that broadcasts with `fn`
        Quality factor 1/(2ζ), at least 0.5, [-].
    A : array that broadcasts with `fn`
        Peak base acceleration, [m/s²].
    tau : array that broadcasts with `fn`
        Duration of the pulse, [s].
    quantity : "absolute" or "pseudo"
        Which acceleration.

    Returns
    -------
    PulseResponse
        Of that quantity, [m/s²].

    Raises
    ------
    ValueError
        When a value is not positive, Q is below 0.5, or f_n τ exceeds 200 (the response is
        quasi-static there: within 1 % of A).

    Notes
    -----
    The motion is exact; the primary maximum is found on 48 samples per period and refined to
    1e-12 relative. Near f_n τ = 1/2, steady and decaying parts cancel to about Q/1e16 of the
    result.

    Examples
    --------
    >>> response = half_sine_damped(800.0, 10.0, 1.0, 0.001)
    >>> round(float(response.maximax), 2)
    1.65

    References
    ----------
    Lalanne 2009, Mechanical Vibration and Shock Analysis, vol. 2, section 2.
    """
    if quantity not in ("absolute", "pseudo"):
        raise ValueError(f"quantity must be 'absolute' or 'pseudo', got {quantity!r}")
    natural, quality, peak, duration = np.broadcast_arrays(*positive(fn=fn, Q=Q, A=A, tau=tau))
    s = natural * duration
    if not (quality >= 0.5).all():
        raise ValueError(f"Q must be at least 0.5 (critical damping), got {quality.min():g}")
    if not (s <= _MOST_PERIODS).all():
        raise ValueError(
            f"f_n·τ = {s.max():g} exceeds {_MOST_PERIODS:g}: the response is quasi-static, A"
        )
    primary = np.vectorize(_one_primary, otypes=[np.float64])(s, quality, quantity)
    z, rate = _relative_motion(np.ones_like(s), s, quality)
    residual = _residual_maximum(z, rate, quality, quantity)
    return PulseResponse(primary=peak * primary, residual=peak * residual)


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
