"""Levels and slopes of spectral densities in decibels of power."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "db_per_octave_from_slope",
    "levels_from_slopes",
    "scale_level",
    "slope_from_db_per_octave",
]

Floats = NDArray[np.float64]


def scale_level(level: ArrayLike, db: ArrayLike) -> Floats:
    """Scale a density by decibels of power.

    G' = G · 10^(dB/10): +3 dB is a factor 1.995 on the density, 1.413 on the rms.

    Parameters
    ----------
    level : array, any shape
        Density, [x²/Hz].
    db : array that broadcasts with `level`
        Gain, [dB].

    Returns
    -------
    array
        Density, [x²/Hz].

    Examples
    --------
    >>> round(float(scale_level(0.04, 3)), 5)
    0.07981
    """
    scaled: Floats = np.asarray(level, np.float64) * 10 ** (np.asarray(db, np.float64) / 10)
    return scaled


def slope_from_db_per_octave(db_per_octave: ArrayLike) -> Floats:
    """Turn a slope in decibels per octave into a log-log exponent.

    m = (dB/octave)/(10 log10 2), since 10 log10(2^m) dB is one octave's rise.

    Parameters
    ----------
    db_per_octave : array, any shape
        Slope, [dB/octave].

    Returns
    -------
    array
        Exponent m of G ∝ f^m, [-].

    Examples
    --------
    >>> round(float(slope_from_db_per_octave(6)), 4)
    1.9932
    """
    slope: Floats = np.asarray(db_per_octave, dtype=np.float64) / (10 * np.log10(2))
    return slope


def db_per_octave_from_slope(slope: ArrayLike) -> Floats:
    """Turn a log-log exponent into decibels per octave.

    dB/octave = 10 log10(2) · m

    Parameters
    ----------
    slope : array, any shape
        Exponent m of G ∝ f^m, [-].

    Returns
    -------
    array
        Slope, [dB/octave].

    Examples
    --------
    >>> round(float(db_per_octave_from_slope(-1)), 4)
    -3.0103
    """
    db: Floats = np.asarray(slope, dtype=np.float64) * (10 * np.log10(2))
    return db


def levels_from_slopes(
    frequency: ArrayLike,
    db_per_octave: ArrayLike,
    *,
    known_index: int,
    known_level: float,
) -> Floats:
    """Give the levels at the edges of segments specified in dB per octave.

    G_{i+1} = G_i (f_{i+1}/f_i)^{m_i}, from the one known level outwards.

    Parameters
    ----------
    frequency : array, shape (n,)
        Edges of the segments, strictly increasing, [Hz].
    db_per_octave : array, shape (n − 1,)
        Slope of each segment, 0 for a plateau, [dB/octave].
    known_index : int
        Edge at which the level is known.
    known_level : float
        Level there, [x²/Hz].

    Returns
    -------
    array, shape (n,)
        Levels, [x²/Hz].

    Raises
    ------
    ValueError
        When lengths do not fit, edges do not rise, the index is not an edge, or the level is
        not positive.

    Examples
    --------
    >>> levels_from_slopes([20, 50, 800, 2000], [6, 0, -6], known_index=1,
    ...                    known_level=0.16).round(3).tolist()
    [0.026, 0.16, 0.16, 0.026]

    References
    ----------
    NASA GSFC-STD-7000A (GEVS) 2013, table 2.4-3.
    """
    f = np.asarray(frequency, dtype=np.float64)
    m = slope_from_db_per_octave(db_per_octave)
    if f.ndim != 1 or m.shape != (f.size - 1,):
        raise ValueError(
            f"{f.size} edges bound {f.size - 1} segments, got slopes of shape {m.shape}"
        )
    if not (np.isfinite(f).all() and f[0] > 0 and (np.diff(f) > 0).all()):
        raise ValueError("edges must be finite, positive and strictly increasing")
    if not np.isfinite(m).all():
        raise ValueError("slopes must be finite; write a step as two profiles' edges")
    if not 0 <= known_index < f.size:
        raise ValueError(f"known_index must lie in 0 to {f.size - 1}, got {known_index}")
    if not (np.isfinite(known_level) and known_level > 0):
        raise ValueError(f"the known level must be positive, got {known_level}")
    rise = np.concatenate([[0.0], np.cumsum(m * np.log(f[1:] / f[:-1]))])
    levels: Floats = known_level * np.exp(rise - rise[known_index])
    return levels
