"""A random acceleration of the base in time, of a given spectral density."""

from math import ceil
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.spectrum import spectral_level

__all__ = ["RandomSamples", "random_samples"]

Floats = NDArray[np.float64]


class RandomSamples(NamedTuple):
    """Samples [m/s²] and the step between them [s], joined by straight lines."""

    values: Floats
    step: float


def random_samples(
    f: ArrayLike,
    asd: ArrayLike,
    *,
    duration: float,
    generator: np.random.Generator,
    oversampling: float = 8.0,
) -> RandomSamples:
    """Return a Gaussian acceleration whose spectral density is a given profile.

    A sum of sines ``√(2 G Δf) cos(2πft + φ)``, one per Δf = 1/duration, random phases. Straight
    lines between samples weaken a sine by ``sinc²(f/f_s)``; that is made good, so the density of
    the joined signal is the profile's, up to its end.

    Parameters
    ----------
    f, asd : array_like, shape (points,)
        Corners of the profile [Hz] and [(m/s²)²/Hz], straight lines in logarithms.
    duration : float
        Length [s].
    generator : numpy.random.Generator
        The source of the phases.
    oversampling : float
        Samples per period of the profile's last frequency.

    Returns
    -------
    RandomSamples
        Samples and step.

    Notes
    -----
    The lines also carry images of the profile about the sampling frequency f_s, (f/(f_s − f))²
    as strong as a line at f: with 8 samples per period below 2.1 % of the amplitude, all beyond
    seven times the profile's end. The joined signal's density within the profile is the profile's
    whatever the seed: sizes are not drawn, only phases.

    Raises
    ------
    ValueError
        When there are fewer than 4 samples per period.

    References
    ----------
    Shinozuka & Deodatis (1991), Applied Mechanics Reviews 44, equation (37).

    """
    if oversampling < 4.0:
        raise ValueError(f"oversampling must be at least 4, got {oversampling:g}")
    corners = np.asarray(f, dtype=np.float64)
    count = ceil(duration * oversampling * float(corners[-1]))
    step = duration / count
    lines = np.arange(count // 2 + 1) / duration
    inside = (lines >= corners[0]) & (lines <= corners[-1])
    level = np.zeros(lines.size)
    level[inside] = spectral_level(lines[inside], corners, np.asarray(asd, dtype=np.float64))
    size = np.sqrt(2.0 * level / duration) / np.sinc(lines * step) ** 2
    phases = generator.uniform(0.0, 2.0 * np.pi, lines.size)
    values = np.fft.irfft(0.5 * count * size * np.exp(1j * phases), count)
    return RandomSamples(np.append(values, values[0]), step)
