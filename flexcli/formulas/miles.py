"""Miles' response of an oscillator to random base acceleration, and its worst case."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range
from flexcli.formulas.spectrum import Scale, clip_profile

__all__ = ["CARDS", "MilesWorstCase", "miles", "miles_worst_case"]

Floats = NDArray[np.float64]

# On a slope of −1 every frequency is the worst; report the lowest within this.
_TIE = 1e-12


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
    a_rms : array
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
    fn, q = positive(f=f, Q=Q)
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
    (q,) = positive(Q=Q)
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


CARDS = (
    Card(
        "miles",
        miles,
        {"f": 2000.0, "Q": 100.0, "level": 0.2},
        (Range("Q", least=10.0, why="a broad resonance sees more of the profile than one level"),),
    ),
)
