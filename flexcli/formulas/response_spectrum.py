"""The vibration response spectrum's greatest value in the band, and Miles against it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.miles import miles
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.spectrum import Scale, checked_profile, segment_slopes, spectral_level
from flexcli.numerics.maximum import greatest

__all__ = ["MilesShortfall", "ResponseMaximum", "miles_shortfall", "response_maximum"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

# The response is an integral over f of G/|f − pole|², so as a function of f_n it is singular
# only at complex f_n some f_b/(2Q) off a breakpoint f_b: steps grow with the distance from one.
_NEAREST = 0.125
_GROWTH = 1.5
_WIDEST = np.log(2.0) / 8
_STEEPEST = 0.5


@dataclass(frozen=True)
class ResponseMaximum:
    """The greatest rms absolute acceleration [x] and its natural frequency [Hz]."""

    response: float
    frequency: float


@dataclass(frozen=True)
class MilesShortfall:
    """How far the exact response exceeds Miles at most: ratio − 1 [-], where [Hz]."""

    excess: float
    frequency: float


def _graded(start: float, end: float, slope: float, Q: float) -> Floats:
    """Points from one breakpoint to the next, dense (in ln f) at both as 1/Q asks."""
    length = float(np.log1p((end - start) / start))
    nearest = _NEAREST / Q
    count = int(np.ceil(np.log(max(0.5 * length / nearest, 1.0)) / np.log(_GROWTH)))
    ladder = nearest * _GROWTH ** np.arange(count)
    ladder = ladder[ladder < 0.5 * length]
    even = max(2, int(np.ceil(length * max(1.0 / _WIDEST, abs(slope) / _STEEPEST))))
    steps = np.concatenate([ladder, length - ladder, np.linspace(0.0, length, even + 1)])
    inner = start * np.exp(np.unique(steps)[1:-1])
    return np.concatenate([[start], inner[(inner > start) & (inner < end)], [end]])


def _grid(f: Floats, g: Floats, Q: float, scale: Scale) -> tuple[Floats, Integers]:
    """Points of every segment of positive width, and the segment of each."""
    slopes = segment_slopes(f, g) if scale == "log" else np.zeros(f.size - 1)
    segments = np.flatnonzero(np.diff(f) > 0)
    points = [_graded(f[i], f[i + 1], slopes[i], Q) for i in segments]
    segment = np.repeat(segments, [each.size for each in points])
    return np.concatenate(points), segment.astype(np.intp)


def response_maximum(
    frequency: ArrayLike, level: ArrayLike, Q: float, *, scale: Scale = "log"
) -> ResponseMaximum:
    """Find the greatest exact response over the natural frequencies of the band.

    max a_rms(f_n) for f_1 ≤ f_n ≤ f_2, with a_rms of `oscillator_response`: bracketed on a grid
    that holds every breakpoint and is graded towards it as f_b/Q, then narrowed.

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density of positive frequencies, [Hz] and [x²/Hz].
    Q : float
        Quality factor, at least 0.5, [-].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Returns
    -------
    ResponseMaximum
        Root-mean-square absolute acceleration [x], and its natural frequency [Hz].

    Raises
    ------
    ValueError
        When the profile is not sound or Q is below 0.5.

    Notes
    -----
    The value is found to 1e-10; the frequency, where the maximum is flat, to some 1e-5 of the
    width of the peak.

    Examples
    --------
    >>> most = response_maximum([20, 2000], [0.2005, 0.2005], 100)
    >>> round(most.response, 1), round(most.frequency)
    (241.9, 1923)
    """
    f, g = checked_profile(frequency, level, scale=scale)
    points = np.unique(_grid(f, g, Q, scale)[0])

    def response(fn: Floats, _: Integers) -> Floats:
        return oscillator_response(f, g, fn, Q, scale=scale).absolute_acceleration

    value, place, _ = greatest(response, points, np.zeros(points.size, dtype=np.intp))
    return ResponseMaximum(value, place)


def miles_shortfall(
    frequency: ArrayLike, level: ArrayLike, Q: float, *, scale: Scale = "log"
) -> MilesShortfall:
    """Find where in the band Miles is farthest below the exact response.

    max a_rms(f_n)/sqrt(π/2 · f_n Q G(f_n)) − 1; at a step, against both of its levels.

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density of positive frequencies and levels, [Hz] and [x²/Hz].
    Q : float
        Quality factor, at least 0.5, [-].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Returns
    -------
    MilesShortfall
        Excess of the exact absolute acceleration over Miles, negative where Miles is safe
        everywhere [-], and the natural frequency [Hz].

    Raises
    ------
    ValueError
        When the profile is not sound or Q is below 0.5.

    Examples
    --------
    >>> low = miles_shortfall([20, 100, 100, 2000], [0.01, 0.01, 0.16, 0.16], 50)
    >>> round(low.excess, 2), round(low.frequency, 3)
    (1.87, 100.0)
    """
    f, g = checked_profile(frequency, level, scale=scale)

    def excess(fn: Floats, segment: Integers) -> Floats:
        side_right = spectral_level(fn, f, g, scale=scale, side="right")
        side_left = spectral_level(fn, f, g, scale=scale, side="left")
        here = np.where(fn == f[segment + 1], side_left, side_right)
        exact = oscillator_response(f, g, fn, Q, scale=scale).absolute_acceleration
        return exact / miles(fn, Q, here)

    value, place, _ = greatest(excess, *_grid(f, g, Q, scale))
    return MilesShortfall(value - 1.0, place)
