"""Damage of a stationary Gaussian stress by every method.

Every method takes the moments m_n = ∫ f^n G df of the one-sided density of the stress, and a life
curve in stress AMPLITUDE a, N = C · a^(−k) or of several such lines, and gives the damage per
second.
"""

from collections.abc import Callable

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.curve_damage import curve_damage_rate, cycles_on_curve
from flexcli.formulas.dirlik import dirlik_damage_rate, dirlik_density, is_single_frequency
from flexcli.formulas.narrow_band import narrow_band_damage_rate, rayleigh_density
from flexcli.formulas.spectral_moments import Moments
from flexcli.formulas.steinberg import STEINBERG, steinberg_damage_rate
from flexcli.formulas.tovo_benasciutti import tovo_benasciutti_damage_rate, tovo_benasciutti_density
from flexcli.formulas.wirsching_light import wirsching_light_damage_rate

__all__ = ["CURVE_METHODS", "METHODS", "curve_damage_rates", "damage_rates"]

Floats = NDArray[np.float64]

METHODS: tuple[tuple[str, Callable[[Moments, ArrayLike, ArrayLike], Floats]], ...] = (
    ("narrow-band", narrow_band_damage_rate),
    ("steinberg", steinberg_damage_rate),
    ("wirsching-light", wirsching_light_damage_rate),
    ("dirlik", dirlik_damage_rate),
    ("tovo-benasciutti", tovo_benasciutti_damage_rate),
)
"""Name and function of each method for a single-slope life curve."""

CURVE_METHODS = tuple(name for name, _ in METHODS if name != "wirsching-light")
"""Methods for a life curve of several lines; Wirsching and Light's fit is for a single slope."""


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


def curve_damage_rates(
    moments: Moments, points: tuple[tuple[float, float], ...]
) -> dict[str, float]:
    """Give the damage rate on a life curve of several lines, by every method that allows one.

    Parameters
    ----------
    moments : Moments
        Scalar moments of the stress, [Pa² Hz^n].
    points : tuple of (float, float)
        The life curve, two points or more: cycles rising [-], AMPLITUDE falling [Pa].

    Returns
    -------
    dict
        Name of each of `CURVE_METHODS` → damage per second, [1/s].

    Raises
    ------
    ValueError
        When the curve does not fall.

    Examples
    --------
    >>> rates = curve_damage_rates(Moments(1.0, 100.0, 1e4, 1e8), ((1e2, 10.0), (1e6, 1.0)))
    >>> round(rates["narrow-band"], 12)
    0.0008
    """
    sigma = float(np.sqrt(moments.m0))
    crossings, peaks = float(moments.crossing_rate), float(moments.peak_rate)
    densities: tuple[tuple[str, float, Callable[[Floats], Floats]], ...] = (
        ("narrow-band", crossings, lambda a: rayleigh_density(a, sigma)),
        (
            "dirlik",
            peaks,
            # of a single frequency its parts merge into Rayleigh's
            (lambda a: rayleigh_density(a, sigma))
            if is_single_frequency(moments)
            else lambda a: dirlik_density(a, moments),
        ),
        ("tovo-benasciutti", peaks, lambda a: tovo_benasciutti_density(a, moments)),
    )
    found = {
        name: curve_damage_rate(density, rate, points, scale=sigma)
        for name, rate, density in densities
    }
    bands = sum(share / float(cycles_on_curve(level * sigma, points)) for level, share in STEINBERG)
    return {**found, "steinberg": crossings * bands}
