"""A random acceleration of the base in time, of a given spectral density."""

from math import ceil

import numpy as np
from numpy.typing import ArrayLike

from flexcli.formulas.spectrum import spectral_level
from flexcli.numerics.signal_pieces import Samples

__all__ = ["random_samples", "with_sine"]


def random_samples(
    f: ArrayLike,
    asd: ArrayLike,
    *,
    duration: float,
    generator: np.random.Generator,
    oversampling: float = 8.0,
) -> Samples:
    """Return a Gaussian acceleration whose spectral density is a given profile.

    A sum of ``√(G Δf) (x cos 2πft + y sin 2πft)``, one per Δf = 1/duration, x and y standard
    normal: sizes by Rayleigh's law, any phase. Straight lines between samples weaken a sine by
    ``sinc²(f/f_s)``; that is made good, so the density of the joined signal is the profile's, up
    to its end.

    Parameters
    ----------
    f, asd : array_like, shape (points,)
        Corners of the profile [Hz] and [(m/s²)²/Hz], straight lines in logarithms.
    duration : float
        Length [s].
    generator : numpy.random.Generator
        The source of sizes and phases.
    oversampling : float
        Samples per period of the profile's last frequency.

    Returns
    -------
    Samples
        Samples and step.

    Notes
    -----
    The lines also carry images of the profile about the sampling frequency f_s, (f/(f_s − f))²
    as strong as a line at f: with 8 samples per period below 2.1 % of the amplitude, all beyond
    seven times the profile's end. Sines of the profile's own size, random in phase alone, would
    give every stretch the same mean square: too little scatter from one to the next, and a signal
    that is Gaussian only in the limit of many lines within a resonance.

    Raises
    ------
    ValueError
        When there are fewer than 4 samples per period.

    References
    ----------
    Rice (1944), Bell System Technical Journal 23, section 2.8, the first of its two forms.

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
    size = np.sqrt(level / duration) / np.sinc(lines * step) ** 2
    drawn = generator.standard_normal((2, lines.size))
    values = np.fft.irfft(0.5 * count * size * (drawn[0] - 1j * drawn[1]), count)
    return Samples(np.append(values, values[0]), step)


def with_sine(samples: Samples, amplitude: float, f: float, phase: float) -> Samples:
    """Return samples with a sine on them, made good for the straight lines between.

    Parameters
    ----------
    samples : Samples
        The signal.
    amplitude : float
        Of the sine, in the signal's unit.
    f : float
        Its frequency [Hz], some 8 samples a period or more.
    phase : float
        Its phase at the start [rad].

    Returns
    -------
    Samples
        The sum.

    """
    times = samples.step * np.arange(samples.values.size)
    size = amplitude / np.sinc(f * samples.step) ** 2
    return Samples(samples.values + size * np.sin(2.0 * np.pi * f * times + phase), samples.step)
