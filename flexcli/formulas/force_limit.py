"""The semi-empirical force limit of a vibration test, and the notch in its profile."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card

__all__ = ["force_limit", "notch_factor"]

Floats = NDArray[np.float64]


def force_limit(
    f: ArrayLike, level: ArrayLike, C: float, M0: float, f0: float, n: float = 2.0
) -> Floats:
    """Give the semi-empirical limit on the force between shaker and test item.

    S_FF = C² M_0² S_AA below f_0, C² M_0² S_AA (f/f_0)^(−n) above

    Parameters
    ----------
    f : array, any shape
        Frequency, [Hz].
    level : array that broadcasts with `f`
        Acceleration density S_AA of the test, [(m/s²)²/Hz].
    C : float
        Constant of the interface, by data of similar ones, [-].
    M0 : float
        Total mass of the test item, [kg].
    f0 : float
        Frequency of its primary mode, [Hz].
    n : float
        Exponent of the roll-off above it, [-].

    Returns
    -------
    array
        Density of the force limit, [N²/Hz].

    Examples
    --------
    >>> force_limit([50.0, 200.0], 0.1, 1.5, 2.0, 100.0).round(4).tolist()
    [0.9, 0.225]

    References
    ----------
    NASA-HDBK-7004C 2012, Force Limited Vibration Testing, semi-empirical method.
    """
    at, density = np.asarray(f, dtype=np.float64), np.asarray(level, dtype=np.float64)
    constant, mass, knee, exponent = (float(x) for x in positive(C=C, M0=M0, f0=f0, n=n))
    limit: Floats = (constant * mass) ** 2 * density * np.minimum(1.0, (at / knee) ** -exponent)
    return limit


def notch_factor(
    f: ArrayLike, apparent_mass: ArrayLike, C: float, M0: float, f0: float, n: float = 2.0
) -> Floats:
    """Give the factor by which a force limit lowers the acceleration density of a test.

    S'_AA/S_AA = min(1, S_FF/(|M|² S_AA)) = min(1, C² M_0² min(1, (f/f_0)^(−n))/|M|²)

    Parameters
    ----------
    f : array, any shape
        Frequency, [Hz].
    apparent_mass : array that broadcasts with `f`
        Force over acceleration at the base of the test item, complex or its size, [kg].
    C, M0, f0, n : float
        As of the force limit: constant [-], total mass [kg], primary mode [Hz], exponent [-].

    Returns
    -------
    array
        Factor on the density, at most 1, [-].

    Examples
    --------
    >>> round(float(notch_factor(100.0, -20.0j, 1.5, 2.0, 100.0)), 4)
    0.0225

    References
    ----------
    NASA-HDBK-7004C 2012, Force Limited Vibration Testing, semi-empirical method.
    """
    limit = force_limit(f, 1.0, C, M0, f0, n)
    factor: Floats = np.minimum(1.0, limit / np.abs(np.asarray(apparent_mass)) ** 2)
    return factor


CARDS = (
    Card(
        "force-limit",
        force_limit,
        {"f": 200.0, "level": 0.1, "C": 1.5, "M0": 2.0, "f0": 100.0, "n": 2.0},
    ),
)
