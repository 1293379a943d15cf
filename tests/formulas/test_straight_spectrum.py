"""Sums of densities, and any density as straight lines."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from spectra import lines

from flexcli.formulas.level_tolerance import level_deviation
from flexcli.formulas.spectrum import spectral_level
from flexcli.formulas.spectrum_integrals import rms
from flexcli.formulas.straight_spectrum import power_sum, straight_lines


@pytest.mark.slow
@given(lines(), lines())
def test_a_sum_is_the_sum_everywhere_and_its_mean_square_too(one, other):
    ends = min(one[0][0], other[0][0]), max(one[0][-1], other[0][-1])
    floor = (np.array(ends), np.full(2, 1e-6))  # no gap between the bands
    parts = [(*one, "log"), (*other, "log"), (*floor, "log")]
    f, g = power_sum(parts)
    between = np.sqrt(f[1:] * f[:-1])[np.diff(f) > 0.0]
    total = sum(spectral_level(between, *part[:2]) for part in parts)
    assert spectral_level(between, f, g) == pytest.approx(total, rel=2e-3)
    squares = sum(rms(*part[:2]) ** 2 for part in parts)
    assert rms(f, g) ** 2 == pytest.approx(squares, rel=2e-3)


def test_a_band_that_starts_inside_another_makes_a_step():
    f, g = power_sum([([10, 1000], [1.0, 1.0], "log"), ([100, 200], [3.0, 3.0], "log")])
    assert f.tolist() == [10.0, 100.0, 100.0, 200.0, 200.0, 1000.0]
    assert g == pytest.approx([1.0, 1.0, 4.0, 4.0, 1.0, 1.0], rel=1e-12)


def test_bands_with_a_gap_have_no_sum():
    with pytest.raises(ValueError, match="no profile covers 20 to 30 Hz"):
        power_sum([([10, 20], [1.0, 1.0], "log"), ([30, 40], [1.0, 1.0], "log")])


def test_lines_follow_a_resonance_within_the_tolerance():
    def level(f, _side):
        r = f / 100.0
        return 1.0 / ((1.0 - r**2) ** 2 + (r / 50.0) ** 2)

    f, g = straight_lines(level, [10.0, 100.0, 1000.0], tolerance=0.01)
    at = np.geomspace(10.0, 1000.0, 5001)
    assert spectral_level(at, f, g) == pytest.approx(level(at, ""), rel=0.02)
    assert f.size < 200


FLAT = ([20.0, 2000.0], [1.0, 1.0], "log")


@given(st.floats(-10.0, 10.0))
def test_a_shifted_profile_is_off_by_the_shift_over_all_of_the_band(db):
    factor = 10.0 ** (db / 10.0)
    found = level_deviation(([20.0, 2000.0], [factor, factor], "log"), FLAT, 2.0, 0.5)
    assert found.most == pytest.approx(factor, rel=1e-12)
    assert found.least == pytest.approx(factor, rel=1e-12)
    if abs(factor / 2.0 - 1.0) > 1e-6 and abs(factor * 2.0 - 1.0) > 1e-6:
        assert found.above == pytest.approx(1980.0 if factor > 2.0 else 0.0)
        assert found.below == pytest.approx(1980.0 if factor < 0.5 else 0.0)


def test_the_width_beyond_a_limit_ends_where_the_line_crosses_it():
    # from 1 at 20 Hz to 4 at 80 Hz: slope one, 2 at 40 Hz
    measured = ([20.0, 80.0, 2000.0], [1.0, 4.0, 1.0], "log")
    found = level_deviation(measured, ([20.0, 80.0], [1.0, 1.0], "log"), 2.0, 0.5)
    assert found.above == pytest.approx(40.0, rel=1e-9)
    assert (found.most, found.f_most) == (pytest.approx(4.0), 80.0)
    falling = ([20.0, 80.0], [4.0, 1.0], "log")
    found = level_deviation(falling, ([20.0, 80.0], [1.0, 1.0], "log"), 2.0, 0.5)
    assert found.above == pytest.approx(20.0, rel=1e-9)


def test_what_was_measured_at_many_frequencies_counts_up_to_the_last():
    measured = ([20.0, 50.0, 300.0, 2000.0], [1.0, 1.0, 0.8, 3.0], "log")
    found = level_deviation(measured, FLAT, 2.0, 0.5)
    assert (found.most, found.f_most) == (pytest.approx(3.0), 2000.0)
    assert (found.least, found.f_least) == (pytest.approx(0.8), 300.0)


def test_what_was_not_measured_is_below():
    found = level_deviation(([100.0, 2000.0], [1.0, 1.0], "log"), FLAT, 2.0, 0.5)
    assert found.least == 0.0
    assert found.below == pytest.approx(80.0)


@pytest.mark.parametrize("times", [1e-4, 1e-3, 1e-2, 1.0])
def test_steps_of_slow_bands_stand_where_those_of_fast_ones_do(times):
    # a pier that sways: steps less than 1 Hz apart
    cuts = np.array([3.0, 70.0, 130.0, 210.0, 650.0, 990.0]) * times
    whole = ([cuts[0], cuts[-1]], [1.0, 1.0], "log")
    f, g = power_sum([whole, *(([a, b], [3.0, 3.0], "log") for a, b in (cuts[1:3], cuts[3:5]))])
    assert f.tolist() == [cuts[0], *np.repeat(cuts[1:-1], 2), cuts[-1]]
    assert g == pytest.approx([1, 1, 4, 4, 1, 1, 4, 4, 1, 1], rel=1e-12)
