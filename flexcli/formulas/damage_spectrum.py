"""Fatigue damage of oscillators over their natural frequency, and environments of equal damage.

Stress is K times the displacement z relative to the base, a cycle of AMPLITUDE z does K^b z^b/C;
spectra here are for K = C = 1: they compare environments, whatever the structure.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.peaks import peak_factor
from flexcli.formulas.spectrum import Scale
from flexcli.numerics.gamma import gamma

__all__ = ["damage_spectrum", "equal_damage_factor", "extreme_spectrum"]

Floats = NDArray[np.float64]


def damage_spectrum(
    frequency: ArrayLike,
    level: ArrayLike,
    fn: ArrayLike,
    Q: float,
    T: float,
    b: float,
    *,
    scale: Scale = "log",
) -> Floats:
    """Give the fatigue damage spectrum of a random vibration.

    D(f_n) = n_0 T (√2 z_rms)^b Γ(1 + b/2), n_0 = ż_rms/(2π z_rms)

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density, [Hz] and [(m/s²)²/Hz].
    fn : array, any shape
        Natural frequency, [Hz].
    Q : float
        Quality factor, at least 0.5, [-].
    T : float
        Duration, [s].
    b : float
        Exponent of the life curve N ∝ a^(−b), [-].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Returns
    -------
    array
        Damage for K = C = 1, [m^b].

    Notes
    -----
    Narrow-band: exact for a high Q, an upper bound of rainflow damage for any. z_rms and the rate
    of zero crossings n_0 are exact over the band. For a flat density G this is
    f_n T (Q G/(2 (2π f_n)³))^(b/2) Γ(1 + b/2).

    Examples
    --------
    >>> D = damage_spectrum([1.0, 1e5], [2.0, 2.0], 100.0, 50.0, 60.0, 4.0)
    >>> flat = 100.0 * 60.0 * (50.0 * 2.0 / (2.0 * (2.0 * np.pi * 100.0) ** 3)) ** 2 * 2.0
    >>> round(float(D) / flat, 2)
    1.0

    References
    ----------
    Lalanne 2009, Mechanical Vibration and Shock Analysis, vol. 5, section 4.
    """
    exponent, duration = (float(each) for each in positive(b=b, T=T))
    found = oscillator_response(frequency, level, fn, Q, scale=scale)
    z, rate = found.relative_displacement, found.relative_velocity
    crossings = rate / (2.0 * np.pi * z)
    damage: Floats = (
        crossings
        * duration
        * (np.sqrt(2.0) * z) ** exponent
        * gamma(np.asarray(1.0 + 0.5 * exponent))
    )
    return damage


def extreme_spectrum(
    frequency: ArrayLike,
    level: ArrayLike,
    fn: ArrayLike,
    Q: float,
    T: float,
    *,
    scale: Scale = "log",
) -> Floats:
    """Give the extreme response spectrum of a random vibration.

    R(f_n) = ω_n² z_rms √(2 ln(n_0 T)), n_0 = ż_rms/(2π z_rms)

    Parameters
    ----------
    frequency, level : arrays, shape (n,)
        Base acceleration density, [Hz] and [(m/s²)²/Hz].
    fn : array, any shape
        Natural frequency, [Hz].
    Q : float
        Quality factor, at least 0.5, [-].
    T : float
        Duration, with n_0 T above 1, [s].
    scale : "log" or "linear"
        Axes in which the profile is straight.

    Returns
    -------
    array
        Most probable greatest ω_n² z in the time, [m/s²].

    Raises
    ------
    ValueError
        When an oscillator has not more than one cycle in the time.

    Examples
    --------
    >>> flat = extreme_spectrum([1.0, 1e5], [2.0, 2.0], 100.0, 50.0, 60.0)
    >>> round(float(flat / np.sqrt(np.pi / 2 * 100 * 50 * 2.0 * 2 * np.log(6000))), 2)
    1.0

    References
    ----------
    Lalanne 2009, Mechanical Vibration and Shock Analysis, vol. 5, section 2.
    """
    found = oscillator_response(frequency, level, fn, Q, scale=scale)
    crossings = found.relative_velocity / (2.0 * np.pi * found.relative_displacement)
    spectrum: Floats = found.pseudo_acceleration * peak_factor(crossings, T)
    return spectrum


def equal_damage_factor(damage: ArrayLike, other: ArrayLike, b: float) -> Floats:
    """Give the factor on the density of one environment that makes its damage that of another.

    G'/G = (D_other/D)^(2/b); for one shape of two durations (T_other/T)^(2/b)

    Parameters
    ----------
    damage : array, any shape
        Damage of the environment that is to be raised, [x].
    other : array that broadcasts with `damage`
        Damage that it shall do, [x].
    b : float
        Exponent of the life curve N ∝ a^(−b), [-].

    Returns
    -------
    array
        Factor on the density, [-].

    Notes
    -----
    Exact wherever damage grows with the b-th power of the level: every spectral method on a life
    curve of one slope.

    Examples
    --------
    >>> round(float(equal_damage_factor(120.0, 3600.0, 8.0)), 4)
    2.3403

    References
    ----------
    MIL-STD-810H 2019, method 514.8, annex on test duration (exponent of fatigue).
    """
    given, wanted, exponent = positive(damage=damage, other=other, b=b)
    factor: Floats = (wanted / given) ** (2.0 / exponent)
    return factor


_FLAT = {"frequency": [20.0, 2000.0], "level": [2.0, 2.0], "fn": 100.0, "Q": 50.0, "T": 60.0}

CARDS = (
    Card("fatigue-damage-spectrum", damage_spectrum, {**_FLAT, "b": 4.0}),
    Card("extreme-response-spectrum", extreme_spectrum, _FLAT),
    Card("equal-damage", equal_damage_factor, {"damage": 120.0, "other": 3600.0, "b": 8.0}),
)
