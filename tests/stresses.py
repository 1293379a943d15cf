"""Stress spectra for tests of fatigue: four shapes, random ones, and what they must keep."""

from hypothesis import strategies as st

from flexcli.formulas.spectral_moments import spectral_moments

ROUNDING = 1e-11  # gamma functions and powers up to 20

SPECTRA = {
    "flat": ([10, 300], [1.0, 1.0]),
    "low-pass": ([0.1, 100], [1.0, 1.0]),
    "two modes": ([10, 12, 12, 90, 90, 100], [10.0, 10.0, 1e-6, 1e-6, 1.0, 1.0]),
    "falling": ([5, 500], [1.0, 1e-4]),
}

spectra = st.builds(
    lambda ratio, rise: spectral_moments([10.0, 10.0 * ratio], [1.0, rise]),
    st.floats(1.5, 100),
    st.floats(1e-4, 10),
)
