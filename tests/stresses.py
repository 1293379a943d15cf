"""Stress spectra for tests of fatigue: four shapes, random ones, and what they must keep."""

from hypothesis import strategies as st

from flexcli.formulas.spectral_moments import Moments
from flexcli.formulas.spectrum_integrals import spectral_moment

ROUNDING = 1e-11  # gamma functions and powers up to 20

SPECTRA = {
    "flat": ([10, 300], [1.0, 1.0]),
    "low-pass": ([0.1, 100], [1.0, 1.0]),
    "two modes": ([10, 12, 12, 90, 90, 100], [10.0, 10.0, 1e-6, 1e-6, 1.0, 1.0]),
    "falling": ([5, 500], [1.0, 1e-4]),
}


def spectral_moments(frequency, level):
    """Return the moments of a stress density that is straight between points in log-log axes."""
    return Moments(*spectral_moment(frequency, level, [0, 1, 2, 4], scale="log"))


def times(factor, moments):
    """Return the moments of a stress that is so many times as large."""
    return Moments(*(factor**2 * m for m in (moments.m0, moments.m1, moments.m2, moments.m4)))


spectra = st.builds(
    lambda ratio, rise: spectral_moments([10.0, 10.0 * ratio], [1.0, rise]),
    st.floats(1.5, 100),
    st.floats(1e-4, 10),
)
