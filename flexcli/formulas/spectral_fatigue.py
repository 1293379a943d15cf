"""Fatigue damage rate of a stationary Gaussian stress from its spectral density.

Stress is an AMPLITUDE everywhere, never a range: half of peak to valley. A life curve is
N = C · a^(−k) in that amplitude a, or straight log-log lines through (cycles, amplitude).
Damage follows Palmgren and Miner: one cycle of amplitude a does 1/N(a).

Every method takes the moments m_n = ∫ f^n G df of the one-sided stress density and gives
the damage per second.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import lgamma

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import Scale, spectral_moment
from flexcli.numerics.quadrature import gauss_rule

__all__ = [
    "METHODS",
    "Moments",
    "Spread",
    "curve_damage_rate",
    "damage_rates",
    "dirlik_damage_rate",
    "dirlik_density",
    "goodman_factor",
    "life",
    "narrow_band_damage_rate",
    "rayleigh_density",
    "spectral_moments",
    "spread",
    "steinberg_damage_rate",
    "tovo_benasciutti_damage_rate",
    "tovo_benasciutti_density",
    "wirsching_light_damage_rate",
]

Floats = NDArray[np.float64]

# Rounding in the moments may put a bandwidth parameter this far above its bound of one.
_BANDWIDTH_SLACK = 1e-9
# Steinberg's shares of the time at 1σ, 2σ and 3σ, as printed by him.
_STEINBERG = ((1, 0.683), (2, 0.271), (3, 0.0433))
# Amplitudes from 1e-6 to 60 scales, panels growing by half: a^k p(a) is then smooth on each.
_SMALLEST, _GREATEST, _GROWTH, _NODES = 1e-6, 60.0, 1.5, 16


@dataclass(frozen=True, eq=False)
class Moments:
    """Moments m_n = ∫ f^n G df of a one-sided stress density, [Pa² Hz^n].

    Attributes
    ----------
    m0, m1, m2, m4 : arrays that broadcast
        sqrt(m0) is the root-mean-square stress.
    """

    m0: Floats
    m1: Floats
    m2: Floats
    m4: Floats

    def __post_init__(self) -> None:
        for name in ("m0", "m1", "m2", "m4"):
            value = np.asarray(getattr(self, name), dtype=np.float64)
            if not (np.isfinite(value).all() and (value > 0).all()):
                raise ValueError(f"{name} must be positive and finite, got {value}")
            object.__setattr__(self, name, value)
        alpha1_squared = self.m1**2 / (self.m0 * self.m2)
        alpha2_squared = self.m2**2 / (self.m0 * self.m4)
        limit = 1 + _BANDWIDTH_SLACK
        if not ((alpha2_squared <= limit * alpha1_squared) & (alpha1_squared <= limit)).all():
            raise ValueError("no spectrum has these moments: m1² ≤ m0·m2 and m2³ ≤ m1²·m4")

    @property
    def crossing_rate(self) -> Floats:
        """Upward zero crossings per second, ν_0 = sqrt(m_2/m_0) [Hz] (Rice 1945)."""
        return np.sqrt(self.m2 / self.m0)

    @property
    def peak_rate(self) -> Floats:
        """Peaks per second, ν_p = sqrt(m_4/m_2) [Hz]."""
        return np.sqrt(self.m4 / self.m2)

    @property
    def alpha1(self) -> Floats:
        """Bandwidth parameter m_1/sqrt(m_0 m_2), 1 for a single frequency [-]."""
        return np.minimum(1.0, self.m1 / np.sqrt(self.m0 * self.m2))

    @property
    def alpha2(self) -> Floats:
        """Irregularity factor m_2/sqrt(m_0 m_4) = ν_0/ν_p, 1 for a single frequency [-]."""
        return np.minimum(1.0, self.m2 / np.sqrt(self.m0 * self.m4))

    def scaled(self, factor: ArrayLike) -> "Moments":
        """Return the moments of the stress times `factor` (mean-stress correction, margin)."""
        square = np.asarray(factor, dtype=np.float64) ** 2
        return Moments(self.m0 * square, self.m1 * square, self.m2 * square, self.m4 * square)


def spectral_moments(frequency: ArrayLike, level: ArrayLike, *, scale: Scale = "log") -> Moments:
    """Give the four moments of a stress density given by breakpoints.

    m_n = ∫ f^n G df, n = 0, 1, 2, 4

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        One-sided stress density, [Hz] and [Pa²/Hz].
    scale : "log" or "linear"
        Axes in which it is straight between breakpoints.

    Returns
    -------
    Moments
        [Pa² Hz^n].

    Raises
    ------
    ValueError
        When the profile is not sound or has no area.

    Examples
    --------
    >>> round(float(spectral_moments([100, 200], [1e12, 1e12]).crossing_rate), 1)
    152.8
    """
    m0, m1, m2, m4 = spectral_moment(frequency, level, [0, 1, 2, 4], scale=scale)
    return Moments(m0, m1, m2, m4)


def _basquin(k: ArrayLike, C: ArrayLike) -> tuple[Floats, Floats]:
    exponent = np.asarray(k, dtype=np.float64)
    constant = np.asarray(C, dtype=np.float64)
    if not (np.isfinite(exponent).all() and (exponent > 0).all()):
        raise ValueError(f"the exponent k must be positive and finite, got {exponent}")
    if not (np.isfinite(constant).all() and (constant > 0).all()):
        raise ValueError(f"the constant C must be positive and finite, got {constant}")
    return exponent, constant


def _gamma(x: Floats) -> Floats:
    log_gamma: Floats = np.vectorize(lgamma, otypes=[np.float64])(x)
    return np.exp(log_gamma)


def narrow_band_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate when each zero crossing is a cycle with a Rayleigh amplitude.

    d = ν_0/C · (sqrt(2 m_0))^k · Γ(1 + k/2)

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve N = C a^(−k), [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    array
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Notes
    -----
    Exact for a single mode of high Q; an upper bound of rainflow damage for any bandwidth.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(narrow_band_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Bendat 1964, Probability Functions for Random Responses, NASA CR-33; Rychlik 1993,
    Probabilistic Engineering Mechanics 8, 1–4 (the bound).
    """
    exponent, constant = _basquin(k, C)
    rate: Floats = (
        moments.crossing_rate
        / constant
        * (2 * moments.m0) ** (exponent / 2)
        * _gamma(1 + exponent / 2)
    )
    return rate


def steinberg_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate of Steinberg's three bands: 68.3 % at 1σ, 27.1 % at 2σ, 4.33 % at 3σ.

    d = ν_0/C · σ^k · (0.683 + 0.271 · 2^k + 0.0433 · 3^k)

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve, [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    array
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Notes
    -----
    A three-point stand-in for the Rayleigh amplitude, with shares that sum to 0.9974. Over the
    narrow-band value it is 1.07 at k = 3, 1.03 at k = 6, 0.92 at k = 8; for steep curves it is
    UNSAFE, since amplitudes above 3σ are missing: 0.74 at k = 10, 0.25 at k = 15.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(steinberg_damage_rate(m, 4, 1e6)), 6)
    0.000853

    References
    ----------
    Steinberg 2000, Vibration Analysis for Electronic Equipment, 3rd ed., section 9.
    """
    exponent, constant = _basquin(k, C)
    bands: Floats = np.sum(
        [share * np.power(float(sigma), exponent) for sigma, share in _STEINBERG], axis=0
    )
    rate: Floats = moments.crossing_rate / constant * moments.m0 ** (exponent / 2) * bands
    return rate


def wirsching_light_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the narrow-band damage rate times Wirsching and Light's rainflow factor.

    λ = a + (1 − a)(1 − ε)^b, ε = sqrt(1 − α_2²), a = 0.926 − 0.033 k, b = 1.587 k − 2.323

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve, [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    array
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Notes
    -----
    Fitted for 3 ≤ k ≤ 6 and four shapes of spectrum. ε → 0 slowly: at 1 − α_2 = 1e-4 it is
    already 0.014.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(wirsching_light_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Wirsching, Light 1980, J. Structural Division ASCE 106(7), 1593–1607,
    DOI 10.1061/JSDEAG.0005477.
    """
    exponent, _ = _basquin(k, C)
    a = 0.926 - 0.033 * exponent
    b = 1.587 * exponent - 2.323
    width = np.sqrt((1 - moments.alpha2) * (1 + moments.alpha2))
    factor = a + (1 - a) * (1 - width) ** b
    return factor * narrow_band_damage_rate(moments, k, C)


@dataclass(frozen=True, eq=False)
class _Dirlik:
    """Weights and scales of Dirlik's density, with `excess` = D_2 (1 − R)."""

    D1: Floats
    Q: Floats
    R: Floats
    excess: Floats


def _dirlik(moments: Moments) -> _Dirlik:
    # D_2 (1 − R) = 1 − γ − D_1 + D_1² by their definitions, so that the printed
    # Q = 1.25 (γ − D_3 − D_2 R)/D_1 is 1.25 D_1 exactly, without 0/0 as γ → 1.
    gamma = moments.alpha2
    mean_ratio = np.maximum(moments.alpha1, gamma) * gamma  # x_m = m_1/m_0 · sqrt(m_2/m_4)
    D1 = 2 * (mean_ratio - gamma**2) / (1 + gamma**2)
    excess = 1 - gamma - D1 + D1**2
    gone = np.abs(excess) < 1e-15
    # for a single frequency R → 1 and D_2, D_3 are one Rayleigh part
    R = np.where(gone, 1.0, (gamma - mean_ratio - D1**2) / np.where(gone, 1.0, excess))
    return _Dirlik(D1, 1.25 * D1, R, excess)


def dirlik_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate from Dirlik's fit to rainflow amplitudes.

    d = ν_p/C · m_0^(k/2) [D_1 Q^k Γ(1 + k) + 2^(k/2) Γ(1 + k/2)(D_2 |R|^k + D_3)]

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve, [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    array
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Notes
    -----
    Dirlik's variable is Z = range/(2 sqrt(m_0)) = amplitude/sqrt(m_0), see `dirlik_density`.
    With a life curve in range the factor (2 sqrt(m_0))^k stands instead of m_0^(k/2); mixing
    the two is an error of 2^k in life. Evaluated as
    D_2 |R|^k + D_3 = 1 − D_1 − D_2(1 − R) · (|R|^k − 1)/(R − 1), regular for a single frequency.

    Against rainflow counts of generated records (tests/benchmarks/spectral_fatigue.py) it gives
    0.92 to 1.0 of the damage for one band, but 0.67 for two bands far apart or a falling
    spectrum with a steep curve (k = 8): keep a factor on life, and mind the spread of methods.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(dirlik_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Dirlik 1985, Application of Computers in Fatigue Analysis, PhD thesis, University of
    Warwick.
    """
    exponent, constant = _basquin(k, C)
    fit = _dirlik(moments)
    step = fit.R - 1
    near = np.abs(step) < 1e-3
    # |R|^k − 1 without cancellation where R is near 1; the limit of the quotient is k
    power = np.where(
        near,
        np.expm1(exponent * np.log1p(np.where(near, step, 0.0))),
        np.abs(fit.R) ** exponent - 1,
    )
    quotient = np.where(step == 0, exponent, power / np.where(step == 0, 1.0, step))
    rayleigh = 1 - fit.D1 - fit.excess * quotient
    body = fit.D1 * fit.Q**exponent * _gamma(1 + exponent) + 2 ** (exponent / 2) * rayleigh * (
        _gamma(1 + exponent / 2)
    )
    rate: Floats = moments.peak_rate / constant * moments.m0 ** (exponent / 2) * body
    return rate


def _tovo_benasciutti_weight(moments: Moments) -> Floats:
    """Weight b of level-crossing counting; the quotient is bounded, any value does at α_2 = 1."""
    a1, a2 = moments.alpha1, moments.alpha2
    gap = 1 - a2
    quotient = np.where(gap > 0, np.maximum(a1 - a2, 0.0) / np.where(gap > 0, gap, 1.0), 1.0)
    # 1 + α_1 α_2 − α_1 − α_2 = (1 − α_1)(1 − α_2) takes one (1 − α_2) out of the printed form
    weight: Floats = quotient * (1.112 * (1 - a1) * np.exp(2.11 * a2) + quotient)
    return weight


def tovo_benasciutti_damage_rate(moments: Moments, k: ArrayLike, C: ArrayLike) -> Floats:
    """Give the damage rate between level-crossing and range counting, after Tovo and Benasciutti.

    d = [b + (1 − b) α_2^(k−1)] d_NB,
    b = (α_1 − α_2)[1.112 (1 + α_1 α_2 − α_1 − α_2) e^(2.11 α_2) + α_1 − α_2]/(α_2 − 1)²

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve, [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    array
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Notes
    -----
    With the approximate b of 2005. Against the rainflow counts named at `dirlik_damage_rate`:
    0.82 to 1.0 for one band, 0.67 to 1.02 for two bands far apart.

    Examples
    --------
    >>> m = Moments(1.0, 100.0, 1e4, 1e8)
    >>> round(float(tovo_benasciutti_damage_rate(m, 4, 1e6)), 12)
    0.0008

    References
    ----------
    Benasciutti, Tovo 2005, Int. J. Fatigue 27(8), 867–877,
    DOI 10.1016/j.ijfatigue.2004.10.007.
    """
    exponent, _ = _basquin(k, C)
    b = _tovo_benasciutti_weight(moments)
    factor = 1 - (1 - b) * (1 - moments.alpha2 ** (exponent - 1))
    return factor * narrow_band_damage_rate(moments, k, C)


def rayleigh_density(amplitude: ArrayLike, sigma: ArrayLike) -> Floats:
    """Give the density of the amplitude of a narrow-band Gaussian stress.

    p(a) = a/σ² · exp(−a²/(2σ²))

    Parameters
    ----------
    amplitude : array, any shape
        Stress AMPLITUDE, [Pa].
    sigma : array that broadcasts with `amplitude`
        Root mean square, [Pa].

    Returns
    -------
    array
        Density, [1/Pa]; with cycles at the rate ν_0.

    Examples
    --------
    >>> round(float(rayleigh_density(1.0, 1.0)), 4)
    0.6065
    """
    width = np.asarray(sigma, dtype=np.float64)
    z = np.asarray(amplitude, dtype=np.float64) / width
    density: Floats = z * np.exp(-0.5 * z**2) / width
    return density


def dirlik_density(amplitude: ArrayLike, moments: Moments) -> Floats:
    """Give Dirlik's density of rainflow amplitude.

    p(a) = [D_1/Q e^(−Z/Q) + D_2 Z/R² e^(−Z²/(2R²)) + D_3 Z e^(−Z²/2)]/sqrt(m_0),
    Z = a/sqrt(m_0)

    Parameters
    ----------
    amplitude : array, any shape
        Stress AMPLITUDE, [Pa].
    moments : Moments
        Scalar moments of the stress, 0 < α_2 < 1, [Pa² Hz^n].

    Returns
    -------
    array
        Density, [1/Pa]; with cycles at the rate of peaks ν_p.

    Raises
    ------
    ValueError
        For a single frequency (α_2 = 1), where the parts of the fit merge: use
        `rayleigh_density`.

    Notes
    -----
    Each part integrates to its weight over 0 < a < ∞ and D_1 + D_2 + D_3 = 1, so p is a
    density in a when Z = a/sqrt(m_0). As α_2 → 1, D_1 → 0 and R → 1 and p → Z e^(−Z²/2)/sqrt(m_0),
    the Rayleigh density of the amplitude (not the range) of a narrow-band stress.

    Examples
    --------
    >>> m = spectral_moments([10, 100], [1.0, 1.0])
    >>> a = np.linspace(0, 100, 200001)
    >>> round(float(np.sum(dirlik_density(a, m)) * 100 / 200000), 3)
    1.0

    References
    ----------
    Dirlik 1985, Application of Computers in Fatigue Analysis, PhD thesis, University of
    Warwick.
    """
    fit = _dirlik(moments)
    if not (np.abs(fit.R - 1) > 0).all() or not (fit.D1 > 0).all():
        raise ValueError("a single frequency has no Dirlik density: use rayleigh_density")
    sigma = np.sqrt(moments.m0)
    z = np.asarray(amplitude, dtype=np.float64) / sigma
    D2 = fit.excess / (1 - fit.R)
    exponential = fit.D1 / fit.Q * np.exp(-z / fit.Q)
    narrow = D2 * z / fit.R**2 * np.exp(-0.5 * (z / fit.R) ** 2)
    wide = (1 - fit.D1 - D2) * z * np.exp(-0.5 * z**2)
    density: Floats = (exponential + narrow + wide) / sigma
    return density


def tovo_benasciutti_density(amplitude: ArrayLike, moments: Moments) -> Floats:
    """Give Tovo and Benasciutti's density of rainflow amplitude, for amplitudes above zero.

    p(a) = b α_2 p_R(a; σ) + (1 − b) p_R(a; α_2 σ), p_R Rayleigh's density

    Parameters
    ----------
    amplitude : array, any shape
        Stress AMPLITUDE, [Pa].
    moments : Moments
        Scalar moments of the stress, [Pa² Hz^n].

    Returns
    -------
    array
        Density, [1/Pa]; with cycles at the rate of peaks ν_p. Its area is 1 − b (1 − α_2): the
        rest are level-crossing cycles of amplitude zero, which do no damage.

    Examples
    --------
    >>> m = spectral_moments([10, 100], [1.0, 1.0])
    >>> bool(tovo_benasciutti_density(5.0, m) > 0)
    True

    References
    ----------
    Benasciutti, Tovo 2005, Int. J. Fatigue 27(8), 867–877,
    DOI 10.1016/j.ijfatigue.2004.10.007.
    """
    b = _tovo_benasciutti_weight(moments)
    sigma = np.sqrt(moments.m0)
    whole = rayleigh_density(amplitude, sigma)
    small = rayleigh_density(amplitude, moments.alpha2 * sigma)
    return b * moments.alpha2 * whole + (1 - b) * small


def curve_damage_rate(
    density: Callable[[Floats], Floats],
    cycle_rate: float,
    points: tuple[tuple[float, float], ...],
    *,
    scale: float,
    endurance: float = 0.0,
) -> float:
    """Give the damage rate of any amplitude density on a life curve of straight log-log lines.

    d = ν ∫ p(a)/N(a) da, from the endurance amplitude to ∞

    Parameters
    ----------
    density : callable
        p(a) of the stress AMPLITUDE, array [Pa] → array [1/Pa].
    cycle_rate : float
        Cycles per second ν to which the density belongs: ν_0 for Rayleigh, ν_p for Dirlik and
        Tovo–Benasciutti, [Hz].
    points : tuple of (float, float)
        The life curve, two points or more: cycles rising [-], AMPLITUDE falling [Pa]. The
        first and last lines go on beyond their points.
    scale : float
        Size of the amplitudes, such as the root mean square, [Pa].
    endurance : float
        Amplitude up to which cycles do no damage, none by default, [Pa].

    Returns
    -------
    float
        Damage per second, [1/s].

    Raises
    ------
    ValueError
        When the curve does not fall, or the rate or the scale is not positive.

    Notes
    -----
    Integrated from 1e-6 to 60 scales on Gauss panels that end at the points of the curve:
    relative error about 1e-12 for the densities of this module and slopes k from 1 to 30. The
    first line extended upwards gives no static limit: check yield apart.

    Examples
    --------
    >>> d = curve_damage_rate(lambda a: rayleigh_density(a, 1.0), 100.0,
    ...                       ((1e2, 10.0), (1e6, 1.0)), scale=1.0)
    >>> round(d, 12)
    0.0008
    """
    if not (np.isfinite(cycle_rate) and cycle_rate > 0 and np.isfinite(scale) and scale > 0):
        raise ValueError(f"rate and scale must be positive, got {cycle_rate} and {scale}")
    curve = np.array(points, dtype=np.float64)
    if curve.ndim != 2 or curve.shape[0] < 2 or not (np.isfinite(curve).all() and curve.min() > 0):
        raise ValueError("a life curve needs two points or more, positive and finite")
    log_n, log_a = np.log(curve.T)
    if not ((np.diff(log_n) > 0).all() and (np.diff(log_a) < 0).all()):
        raise ValueError("along a life curve, cycles rise and amplitude falls")
    corners = curve[1:-1, 1]
    low, high = scale * _SMALLEST, scale * _GREATEST
    count = int(np.ceil(np.log(high / low) / np.log(_GROWTH))) + 1
    edges = np.concatenate([np.geomspace(low, high, count), corners, [endurance]])
    edges = np.unique(np.clip(edges, max(low, endurance), max(high, endurance)))
    x, w = gauss_rule(_NODES)
    amplitude = edges[:-1, None] + np.diff(edges)[:, None] * x
    # the line of each amplitude; the outer two are extended
    line = (corners[:, None, None] > amplitude).sum(axis=0)
    slope = np.diff(log_n) / np.diff(log_a)
    log_life = log_n[line] + slope[line] * (np.log(amplitude) - log_a[line])
    damage = (density(amplitude) * np.exp(-log_life)) @ w
    return float(cycle_rate * (damage @ np.diff(edges)))


def goodman_factor(mean: ArrayLike, tensile_strength: ArrayLike) -> Floats:
    """Give the factor on a stress amplitude that stands for a mean stress (Goodman).

    a_0 = a/(1 − σ_m/R_m)

    Parameters
    ----------
    mean : array, any shape
        Mean stress σ_m, [Pa].
    tensile_strength : array that broadcasts with `mean`
        R_m, [Pa].

    Returns
    -------
    array
        Factor, at least 1, [-]; give it to `Moments.scaled`.

    Raises
    ------
    ValueError
        When R_m is not positive or the mean reaches it.

    Notes
    -----
    Compression (σ_m < 0) earns nothing: the factor is 1.

    Examples
    --------
    >>> goodman_factor([300e6, -300e6], 900e6).round(12).tolist()
    [1.5, 1.0]

    References
    ----------
    Dowling 2013, Mechanical Behavior of Materials, 4th ed., section 9.7.
    """
    strength = np.asarray(tensile_strength, dtype=np.float64)
    tension = np.maximum(np.asarray(mean, dtype=np.float64), 0.0)
    if not (strength > 0).all():
        raise ValueError(f"the tensile strength must be positive, got {strength}")
    if not (tension < strength).all():
        raise ValueError(f"the mean stress {tension} reaches the tensile strength {strength}")
    factor: Floats = 1 / (1 - tension / strength)
    return factor


def life(damage_rate: ArrayLike, *, critical_damage: float = 1.0) -> Floats:
    """Give the time to failure.

    T = D_c/d

    Parameters
    ----------
    damage_rate : array, any shape
        Damage per second, [1/s].
    critical_damage : float
        Sum of damage at failure, 1 after Miner, [-].

    Returns
    -------
    array
        Life, [s]; inf without damage.

    Raises
    ------
    ValueError
        When a rate is negative or the critical damage is not positive.

    Examples
    --------
    >>> float(life(0.0005))
    2000.0
    """
    rate = np.asarray(damage_rate, dtype=np.float64)
    if not ((rate >= 0).all() and critical_damage > 0):
        raise ValueError("damage rates must not be negative, critical damage must be positive")
    return np.divide(critical_damage, rate, out=np.full_like(rate, np.inf), where=rate > 0)


METHODS: tuple[tuple[str, Callable[[Moments, ArrayLike, ArrayLike], Floats]], ...] = (
    ("narrow-band", narrow_band_damage_rate),
    ("steinberg", steinberg_damage_rate),
    ("wirsching-light", wirsching_light_damage_rate),
    ("dirlik", dirlik_damage_rate),
    ("tovo-benasciutti", tovo_benasciutti_damage_rate),
)
"""Name and function of each method for a single-slope life curve."""


def damage_rates(moments: Moments, k: ArrayLike, C: ArrayLike) -> dict[str, Floats]:
    """Give the damage rate by every method of `METHODS`.

    Parameters
    ----------
    moments : Moments
        Of the stress, [Pa² Hz^n].
    k : array
        Exponent of the life curve, [-].
    C : array
        Its constant for stress AMPLITUDE, [Pa^k].

    Returns
    -------
    dict
        Name of the method → damage per second, [1/s].

    Raises
    ------
    ValueError
        When k or C is not positive.

    Examples
    --------
    >>> sorted(damage_rates(Moments(1.0, 100.0, 1e4, 1e8), 4, 1e6))
    ['dirlik', 'narrow-band', 'steinberg', 'tovo-benasciutti', 'wirsching-light']
    """
    return {name: method(moments, k, C) for name, method in METHODS}


@dataclass(frozen=True)
class Spread:
    """How far methods disagree: least and greatest value, whose they are, and their ratio."""

    least: float
    greatest: float
    least_name: str
    greatest_name: str

    @property
    def ratio(self) -> float:
        """Greatest over least, inf when the least is zero [-]."""
        return self.greatest / self.least if self.least > 0 else float("inf")


def spread(values: Mapping[str, ArrayLike]) -> Spread:
    """Compare one scalar result of several methods.

    Parameters
    ----------
    values : mapping
        Name of the method → value, in one unit.

    Returns
    -------
    Spread
        Least and greatest, with names and ratio.

    Raises
    ------
    ValueError
        When there is no value.

    Examples
    --------
    >>> spread({"a": 2.0, "b": 3.0}).ratio
    1.5
    """
    if not values:
        raise ValueError("a spread needs at least one value")
    numbers = {name: float(np.asarray(value)) for name, value in values.items()}
    least, greatest = min(numbers, key=numbers.__getitem__), max(numbers, key=numbers.__getitem__)
    return Spread(numbers[least], numbers[greatest], least, greatest)
