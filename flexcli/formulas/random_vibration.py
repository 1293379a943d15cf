"""Single-degree-of-freedom response to random base acceleration: Miles and exact.

An oscillator of natural frequency f_n and quality factor Q = 1/(2ζ) stands on a base whose
acceleration has the one-sided density G(f) (see `flexcli.formulas.spectrum`). With r = f/f_n,

    |H_z|² = 1 / ((1 − r²)² + (r/Q)²)

carries base acceleration to pseudo-acceleration ω_n² z (spring force per mass; z is the
displacement relative to the base), and |H_a|² = (1 + (r/Q)²)|H_z|² carries it to absolute
acceleration (spring and damper force per mass).
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import Scale, checked_profile, clip_profile, gauss_rule

__all__ = [
    "MINIMUM_CYCLES",
    "MilesWorstCase",
    "OscillatorResponse",
    "davenport_peak_factor",
    "expected_exceedances",
    "miles",
    "miles_worst_case",
    "oscillator_response",
    "peak_factor",
    "peak_probability",
    "white_noise_response",
]

Floats = NDArray[np.float64]

# Below some ten cycles the asymptotic peak factors lose meaning (Davenport 1964).
MINIMUM_CYCLES = 10.0
_EULER_GAMMA = 0.5772156649015329

# On a slope of −1 every frequency is the worst; report the lowest within this.
_TIE = 1e-12

# Panels grow by this ratio away from the resonance. A panel [d, 4d] sees the poles (at
# distance ≤ d/8 from 0) at more than 1.6 half-widths from its centre, so 16 Gauss points
# leave (1.6 + √(1.6² − 1))^(−2·16) ≈ 4e-15, and this only in the outermost decades.
_GRADING = 4.0
_NODES = 16
# Log axes: ln r also has poles at ±iπ, and e^(s ln r) turns quickly on steep lines.
_WIDEST_PANEL = 1.4
_STEEPEST_PANEL = 10.0
# Rows (f_n, Q) handled at once: about this many panels, to stay within the cache.
_PANELS_AT_ONCE = 20_000


def _positive(**values: ArrayLike) -> list[Floats]:
    """Return the arrays, or name the one that has a value not positive and finite."""
    arrays = []
    for name, value in values.items():
        array = np.asarray(value, dtype=np.float64)
        if not (np.isfinite(array).all() and (array > 0).all()):
            raise ValueError(f"{name} must be positive and finite, got {array}")
        arrays.append(array)
    return arrays


def miles(f: ArrayLike, Q: ArrayLike, level: ArrayLike) -> Floats:
    """Give Miles' root-mean-square response.

    a_rms = sqrt(π/2 · f Q G(f))

    Parameters
    ----------
    f : array, any shape
        Natural frequency, [Hz].
    Q : array that broadcasts with `f`
        Quality factor 1/(2ζ), [-].
    level : array that broadcasts with `f`
        One-sided density of base acceleration at `f`, [x²/Hz].

    Returns
    -------
    array
        Root-mean-square pseudo-acceleration, [x].

    Raises
    ------
    ValueError
        When f or Q is not positive or a level is negative.

    Notes
    -----
    It is exact for the pseudo-acceleration ω_n² z under white noise from 0 to ∞, and for the
    absolute acceleration within the factor sqrt(1 + 1/Q²). It takes the density at resonance
    for the density everywhere: it is poor where the profile changes within some f_n/Q, and
    leaves out the base motion well below f_n, which is most of it when f_n lies above the band.

    Examples
    --------
    >>> round(float(miles(2000, 100, 0.2)), 2)
    250.66

    References
    ----------
    Miles 1954, J. Aeronautical Sciences 21(11), 753–762, DOI 10.2514/8.3199.
    """
    fn, q = _positive(f=f, Q=Q)
    density = np.asarray(level, dtype=np.float64)
    if not (density >= 0).all():
        raise ValueError(f"the level must not be negative, got {density}")
    response: Floats = np.sqrt(0.5 * np.pi * fn * q * density)
    return response


@dataclass(frozen=True, eq=False)
class MilesWorstCase:
    """The greatest Miles response of a profile: `response` [x] at `frequency` [Hz]."""

    response: Floats
    frequency: float
    level: float


def miles_worst_case(
    frequency: ArrayLike,
    level: ArrayLike,
    Q: ArrayLike,
    *,
    lower: float | None = None,
    upper: float | None = None,
    scale: Scale = "log",
) -> MilesWorstCase:
    """Give the exact maximum of Miles' response over all natural frequencies.

    max_f sqrt(π/2 · f Q G(f)). On a log-log segment f G(f) is a power of f, so the maximum is
    at a breakpoint, on either side of a step; on a linear one it is a parabola a f + b f²,
    with its top at −a/(2b) when that lies inside and b < 0.

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density, [Hz] and [x²/Hz].
    Q : array, any shape
        Quality factor, [-].
    lower, upper : float, optional
        Range of natural frequencies; that of the profile where left out, [Hz].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Returns
    -------
    MilesWorstCase
        Response of the shape of `Q` [x], the frequency [Hz] (the lowest of several) and the
        level there [x²/Hz]. The frequency does not depend on Q.

    Raises
    ------
    ValueError
        When the profile is not sound, has nothing in the range, or Q is not positive.

    Examples
    --------
    >>> worst = miles_worst_case([20, 2000], [0.2, 0.2], 100)
    >>> round(float(worst.response), 2), worst.frequency
    (250.66, 2000.0)
    """
    (q,) = _positive(Q=Q)
    f, g = clip_profile(frequency, level, lower=lower, upper=upper, scale=scale)
    if scale == "linear":
        # the top of f·(a + b f), written without dividing by the segment's width
        fall = g[:-1] - g[1:]
        falling = fall > 0
        top = np.divide(g[:-1] * f[1:] - g[1:] * f[:-1], 2 * fall, out=f[:-1].copy(), where=falling)
        inside = falling & (top > f[:-1]) & (top < f[1:])
        share = (top - f[:-1])[inside] / np.diff(f)[inside]
        f, g = (
            np.concatenate([f, top[inside]]),
            np.concatenate([g, g[:-1][inside] - share * fall[inside]]),
        )
        order = np.argsort(f, kind="stable")
        f, g = f[order], g[order]
    product = f * g
    worst = int(np.argmax(product >= product.max() * (1 - _TIE)))
    return MilesWorstCase(
        response=np.sqrt(0.5 * np.pi * q * product.max()),
        frequency=float(f[worst]),
        level=float(g[worst]),
    )


def _at_least_critical(Q: Floats) -> None:
    if not (Q >= 0.5).all():
        raise ValueError(f"Q must be at least 0.5 (critical damping), got {Q.min():g}")


@dataclass(frozen=True, eq=False)
class OscillatorResponse:
    """Root-mean-square response of oscillators, each array of the shape of (f_n, Q).

    Attributes
    ----------
    absolute_acceleration : array
        Of the mass, in an inertial frame, [x].
    pseudo_acceleration : array
        ω_n² z_rms: spring force per mass. This is what Miles approximates, [x].
    relative_displacement : array
        z_rms between mass and base, [x s²], in metres when x is m/s².
    relative_velocity : array
        ż_rms between mass and base, [x s].
    """

    absolute_acceleration: Floats
    pseudo_acceleration: Floats
    relative_displacement: Floats
    relative_velocity: Floats

    @property
    def crossing_frequency(self) -> Floats:
        """Mean rate at which z passes zero upwards, ż_rms/(2π z_rms) [Hz] (Rice 1945)."""
        rate: Floats = self.relative_velocity / (2 * np.pi * self.relative_displacement)
        return rate


def _log_distance(f: Floats, fn: Floats) -> Floats:
    """ln(f/f_n), with all digits also where f is near f_n."""
    away = (f - fn) / fn
    close = np.abs(away) < 0.5
    return np.where(close, np.log1p(np.where(close, away, 0.0)), np.log(f / fn))


@dataclass(frozen=True, eq=False)
class _Panels:
    """Flat list of Gauss panels: which row and segment, from `start`, `width` wide."""

    row: NDArray[np.intp]
    segment: NDArray[np.intp]
    start: Floats  # in y, the distance from resonance
    width: Floats
    share_start: Floats  # in the fraction of the segment, 0 to 1
    share_width: Floats


def _graded_panels(y: Floats, Q: Floats, slope: Floats | None) -> _Panels:
    """Cut each row's segments at 0 and ±4^k/(2Q); further on log axes, given the slopes.

    `y` has shape (rows, breakpoints), 0 at resonance, where the poles are 1/(2Q) off.
    """
    rows, points = y.shape
    pole = 0.5 / Q
    count = int(np.ceil(np.log(max(np.abs(y).max() / pole.min(), 1.0)) / np.log(_GRADING))) + 1
    ladder = pole[:, None] * _GRADING ** np.arange(count)
    edges = np.concatenate([y, -ladder, np.zeros((rows, 1)), ladder], axis=1)
    order = np.argsort(edges, axis=1, kind="stable")
    edges = np.take_along_axis(edges, order, axis=1)
    segment = np.cumsum(order < points, axis=1)[:, :-1] - 1
    width = np.diff(edges, axis=1)
    row, column = np.nonzero((segment >= 0) & (segment < points - 1) & (width > 0))
    segment = segment[row, column]
    start, width = edges[row, column], width[row, column]
    # the fraction of the segment is exact at its ends, however narrow it is
    origin = y[row, segment]
    span = y[row, segment + 1] - origin
    share = (start - origin) / span
    share_width = (edges[row, column + 1] - origin) / span - share
    panels = _Panels(row, segment, start, width, share, share_width)
    if slope is None:
        return panels
    steep = (np.abs(slope[segment]) + 3) * width / _STEEPEST_PANEL
    pieces = np.ceil(np.maximum(width / _WIDEST_PANEL, steep)).astype(np.intp)
    if (pieces == 1).all():
        return panels
    again = np.repeat(np.arange(pieces.size), pieces)
    piece = np.arange(again.size) - np.repeat(np.cumsum(pieces) - pieces, pieces)
    width, share_width = (width / pieces)[again], (share_width / pieces)[again]
    return _Panels(
        row[again],
        segment[again],
        start[again] + piece * width,
        width,
        share[again] + piece * share_width,
        share_width,
    )


def _response_integrals(
    f: Floats, g: Floats, fn: Floats, Q: Floats, scale: Scale
) -> tuple[Floats, Floats]:
    """∫ G |H_z|² df and ∫ G r² |H_z|² df for each row of (f_n, Q), shape (rows,)."""
    x, w = gauss_rule(_NODES)
    rise = np.log(g[1:] / g[:-1]) if scale == "log" else np.diff(g)
    if scale == "log":
        # y = ln r, in which |H_z|² = r⁻²/(4 sinh² y + 1/Q²)
        y = _log_distance(f, fn[:, None])
        span = np.log1p(np.diff(f) / f[:-1])
        slope = np.divide(rise, span, out=np.zeros_like(rise), where=span > 0)
        panels = _graded_panels(y, Q, slope)
    else:
        # y = r − 1, in which |H_z|² = 1/(y²(2 + y)² + (1 + y)²/Q²)
        y = (f - fn[:, None]) / fn[:, None]
        span = np.diff(f) / fn[:, None]
        panels = _graded_panels(y, Q, None)
    at = panels.start[:, None] + panels.width[:, None] * x
    share = panels.share_start[:, None] + panels.share_width[:, None] * x
    loss = (1 / Q[panels.row] ** 2)[:, None]
    climb = rise[panels.segment][:, None] * share
    if scale == "log":
        inverse = np.exp(-at)
        density = g[panels.segment][:, None] * np.exp(climb)
        kernel = inverse * density / (4 * np.sinh(at) ** 2 + loss)
        square = 1 / inverse**2
    else:
        density = g[panels.segment][:, None] + climb
        square = (1 + at) ** 2
        kernel = density / ((at * (2 + at)) ** 2 + square * loss)
    # panel widths add up to differences of rounded y; on a narrow segment the exact span
    # differs from that in its leading digits, beside the resonance the widths are exact
    rounded = np.diff(y, axis=1)
    stretch = np.divide(span, rounded, out=np.ones_like(rounded), where=rounded > 0)
    length = fn[panels.row] * panels.width * stretch[panels.row, panels.segment]
    still, moving = np.zeros(fn.size), np.zeros(fn.size)
    np.add.at(still, panels.row, length * (kernel @ w))
    np.add.at(moving, panels.row, length * ((kernel * square) @ w))
    return still, moving


def oscillator_response(
    frequency: ArrayLike,
    level: ArrayLike,
    fn: ArrayLike,
    Q: ArrayLike,
    *,
    scale: Scale = "log",
) -> OscillatorResponse:
    """Give the exact root-mean-square response to a profile (vibration response spectrum).

    a_rms² = ∫ G |H_a|² df,  (ω_n² z_rms)² = ∫ G |H_z|² df,  (ω_n ż_rms)² = ∫ G r² |H_z|² df
    over the band of the profile.

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density, [Hz] and [x²/Hz].
    fn : array, any shape
        Natural frequency, inside the band or not, [Hz].
    Q : array that broadcasts with `fn`
        Quality factor 1/(2ζ), at least 0.5, [-].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Returns
    -------
    OscillatorResponse
        Absolute acceleration, pseudo-acceleration [x], relative displacement [x s²] and
        velocity [x s], each of the broadcast shape.

    Raises
    ------
    ValueError
        When the profile is not sound, f_n is not positive, or Q is below 0.5 or infinite.

    Notes
    -----
    Sixteen Gauss points on panels graded towards the resonance; relative error below 1e-12
    for Q from 0.5 to 1e6, for segments wider than some 1e-6 of their frequency.

    Examples
    --------
    >>> exact = oscillator_response([20, 2000], [0.04, 0.04], 200, 10)
    >>> round(float(exact.absolute_acceleration), 3), round(float(miles(200, 10, 0.04)), 3)
    (11.23, 11.21)

    References
    ----------
    Crandall, Mark 1963, Random Vibration in Mechanical Systems, section 2.
    """
    f, g = checked_profile(frequency, level, scale=scale)
    natural, quality = np.broadcast_arrays(*_positive(fn=fn, Q=Q))
    _at_least_critical(quality)
    rows_fn, rows_Q = natural.ravel(), quality.ravel()
    chunk = max(1, _PANELS_AT_ONCE // (f.size + 60))
    still, moving = np.zeros(rows_fn.size), np.zeros(rows_fn.size)
    for first in range(0, rows_fn.size, chunk):
        part = slice(first, first + chunk)
        still[part], moving[part] = _response_integrals(f, g, rows_fn[part], rows_Q[part], scale)
    omega = 2 * np.pi * rows_fn
    return OscillatorResponse(
        absolute_acceleration=np.sqrt(still + moving / rows_Q**2).reshape(natural.shape),
        pseudo_acceleration=np.sqrt(still).reshape(natural.shape),
        relative_displacement=(np.sqrt(still) / omega**2).reshape(natural.shape),
        relative_velocity=(np.sqrt(moving) / omega).reshape(natural.shape),
    )


def white_noise_response(fn: ArrayLike, Q: ArrayLike, level: ArrayLike) -> OscillatorResponse:
    """Give the exact root-mean-square response to white noise from 0 to ∞ Hz.

    ω_n² z_rms = ω_n ż_rms = sqrt(π/2 · f_n Q G),  a_rms = sqrt(1 + 1/Q²) ω_n² z_rms

    Parameters
    ----------
    fn : array, any shape
        Natural frequency, [Hz].
    Q : array that broadcasts with `fn`
        Quality factor, any positive value, [-].
    level : array that broadcasts with `fn`
        One-sided density of base acceleration, [x²/Hz].

    Returns
    -------
    OscillatorResponse
        As `oscillator_response`.

    Raises
    ------
    ValueError
        When f_n or Q is not positive or the level is negative.

    Examples
    --------
    >>> round(float(white_noise_response(2000, 100, 0.2).absolute_acceleration), 2)
    250.68

    References
    ----------
    Crandall, Mark 1963, Random Vibration in Mechanical Systems, section 2.
    """
    pseudo = miles(fn, Q, level)
    omega = 2 * np.pi * np.asarray(fn, dtype=np.float64)
    return OscillatorResponse(
        absolute_acceleration=pseudo * np.hypot(1, 1 / np.asarray(Q, dtype=np.float64)),
        pseudo_acceleration=pseudo,
        relative_displacement=pseudo / omega**2,
        relative_velocity=pseudo / omega,
    )


def _more_than_one_cycle(f0: ArrayLike, T: ArrayLike) -> Floats:
    rate, time = _positive(f0=f0, T=T)
    cycles: Floats = rate * time
    if not (cycles > 1).all():
        raise ValueError(
            f"a peak factor needs more than one cycle, and about {MINIMUM_CYCLES:g} to mean "
            f"much: f0·T = {cycles.min():g}"
        )
    return cycles


def peak_factor(f0: ArrayLike, T: ArrayLike) -> Floats:
    """Give the most probable greatest peak of a narrow-band Gaussian signal over its rms.

    c = sqrt(2 ln(f_0 T)): the level crossed upwards once, on average, in the time T.

    Parameters
    ----------
    f0 : array, any shape
        Rate of upward zero crossings, the natural frequency for a lightly damped one, [Hz].
    T : array that broadcasts with `f0`
        Duration, [s].

    Returns
    -------
    array
        Peak over root mean square, [-].

    Raises
    ------
    ValueError
        When f_0 T is not above 1.

    Notes
    -----
    Asymptotic: use from f_0 T = `MINIMUM_CYCLES` on. 3σ is reached at f_0 T = e^4.5 = 90.

    Examples
    --------
    >>> round(float(peak_factor(200, 60)), 2)
    4.33

    References
    ----------
    Rice 1945, Bell System Technical Journal 24, 46–156; Davenport 1964, Proc. Institution of
    Civil Engineers 28, 187–196, DOI 10.1680/iicep.1964.10112.
    """
    factor: Floats = np.sqrt(2 * np.log(_more_than_one_cycle(f0, T)))
    return factor


def davenport_peak_factor(f0: ArrayLike, T: ArrayLike) -> Floats:
    """Give the mean greatest peak of a Gaussian signal over its rms.

    c + γ/c with c = sqrt(2 ln(f_0 T)) and Euler's γ = 0.5772.

    Parameters
    ----------
    f0 : array, any shape
        Rate of upward zero crossings, [Hz].
    T : array that broadcasts with `f0`
        Duration, [s].

    Returns
    -------
    array
        Mean peak over root mean square, [-].

    Raises
    ------
    ValueError
        When f_0 T is not above 1.

    Notes
    -----
    Asymptotic: use from f_0 T = `MINIMUM_CYCLES` on; it grows without bound as f_0 T → 1.

    Examples
    --------
    >>> round(float(davenport_peak_factor(200, 60)), 2)
    4.47

    References
    ----------
    Davenport 1964, Proc. Institution of Civil Engineers 28, 187–196, equation 14,
    DOI 10.1680/iicep.1964.10112.
    """
    c = peak_factor(f0, T)
    return c + _EULER_GAMMA / c


def expected_exceedances(k: ArrayLike, f0: ArrayLike, T: ArrayLike) -> Floats:
    """Count how often a Gaussian signal goes beyond ±k·rms, on average.

    n = 2 f_0 T exp(−k²/2), crossings of +k upwards and of −k downwards together.

    Parameters
    ----------
    k : array, any shape
        Level over root mean square, 3 for "3σ", [-].
    f0 : array that broadcasts with `k`
        Rate of upward zero crossings, [Hz].
    T : array that broadcasts with `k`
        Duration, [s].

    Returns
    -------
    array
        Mean number of excursions, [-].

    Raises
    ------
    ValueError
        When f_0 or T is not positive.

    Examples
    --------
    >>> round(float(expected_exceedances(3, 200, 60)))
    267

    References
    ----------
    Rice 1945, Bell System Technical Journal 24, 46–156.
    """
    rate, time = _positive(f0=f0, T=T)
    count: Floats = 2 * rate * time * np.exp(-0.5 * np.asarray(k, dtype=np.float64) ** 2)
    return count


def peak_probability(k: ArrayLike, f0: ArrayLike, T: ArrayLike) -> Floats:
    """Give the chance that a Gaussian signal goes beyond ±k·rms at least once.

    p = 1 − exp(−n), n the expected exceedances, taken as independent.

    Parameters
    ----------
    k : array, any shape
        Level over root mean square, [-].
    f0 : array that broadcasts with `k`
        Rate of upward zero crossings, [Hz].
    T : array that broadcasts with `k`
        Duration, [s].

    Returns
    -------
    array
        Probability, [-].

    Raises
    ------
    ValueError
        When f_0 or T is not positive.

    Notes
    -----
    Excursions of a lightly damped oscillator come in clumps, so this errs on the safe side.

    Examples
    --------
    >>> round(float(peak_probability(5, 200, 60)), 3)
    0.086
    """
    return -np.expm1(-expected_exceedances(k, f0, T))
