"""Damage of a stationary Gaussian stress by every method: rates, their spread, the life they leave.

Every method takes the moments m_n = ∫ f^n G df of the one-sided density of the stress, and a life
curve N = C · a^(−k) in stress AMPLITUDE a, and gives the damage per second.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.dirlik import dirlik_damage_rate
from flexcli.formulas.narrow_band import narrow_band_damage_rate
from flexcli.formulas.spectral_moments import Moments
from flexcli.formulas.steinberg import steinberg_damage_rate
from flexcli.formulas.tovo_benasciutti import tovo_benasciutti_damage_rate
from flexcli.formulas.wirsching_light import wirsching_light_damage_rate

__all__ = ["METHODS", "Spread", "damage_rates", "life", "spread"]

Floats = NDArray[np.float64]

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
