"""The envelope: the greatest of its profiles everywhere, crossings exact."""

import numpy as np
import pytest
from hypothesis import given, settings
from spectra import lines

from flexcli.formulas.envelope import envelope
from flexcli.formulas.spectrum import spectral_level

ROUNDING = 1e-13  # some hundred operations in double precision


@pytest.mark.parametrize("scale", ["log", "linear"])
@given(first=lines(), second=lines(), third=lines())
@settings(deadline=None, max_examples=40)
def test_envelope_is_the_greatest_of_its_lines(scale, first, second, third):
    wide = (np.array([1e-2, 1e12]), np.array([1e-6, 1e-6]))  # so that no gap opens
    some = [first, second, third, wide]
    f, g = envelope(some, scale=scale)
    asked = np.unique(np.concatenate([f, f[:-1] + 0.37 * np.diff(f)]))
    for side in ("left", "right"):
        highest = np.max(
            [spectral_level(asked, *profile, scale=scale, side=side) for profile in some], axis=0
        )
        found = spectral_level(asked, f, g, scale=scale, side=side)
        # at a profile's outer edge the edge belongs to it, from either side
        outer = np.isin(asked, [x for profile in some for x in (profile[0][0], profile[0][-1])])
        # a crossing is right to 1e-16 of its frequency, on a line that may fall over 1e-4 of it
        np.testing.assert_allclose(
            found[~outer], highest[~outer], rtol=1e-9, atol=1e-11 * highest.max()
        )


def test_envelope_finds_the_crossing_exactly():
    f, g = envelope([([10, 1000], [1, 1]), ([10, 1000], [0.01, 100])])
    np.testing.assert_allclose(f, [10, 100, 1000], rtol=ROUNDING)
    np.testing.assert_allclose(g, [1, 1, 100], rtol=ROUNDING)


def test_envelope_of_one_profile_is_itself_with_its_steps():
    f, g = envelope([([10, 100, 100, 1000], [1, 1, 4, 4])])
    assert (f.tolist(), g.tolist()) == ([10, 100, 100, 1000], [1, 1, 4, 4])


def test_envelope_with_a_gap_is_refused_on_log_axes_and_zero_on_linear_ones():
    bands = [([10, 20], [1, 1]), ([30, 40], [1, 1])]
    with pytest.raises(ValueError, match="covers 20 to 30 Hz"):
        envelope(bands)
    f, g = envelope(bands, scale="linear")
    assert (f.tolist(), g.tolist()) == ([10, 20, 20, 30, 30, 40], [1, 1, 0, 0, 1, 1])


def test_no_profile_has_no_envelope():
    with pytest.raises(ValueError, match="at least one"):
        envelope([])
