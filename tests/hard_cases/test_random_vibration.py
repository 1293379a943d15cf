"""Spectra at their corners: slope −1, steps, band ends, and every quality factor."""

from cmath import log as complex_log
from math import atan, pi, sqrt

import numpy as np
import pytest
from spectra import white_noise

from flexcli.formulas.envelope import envelope
from flexcli.formulas.miles import miles, miles_worst_case
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.response_spectrum import ResponseSpectrum
from flexcli.formulas.spectrum import clip_profile, spectral_level
from flexcli.formulas.spectrum_integrals import rms, spectral_moment

LOW, HIGH = 20.0, 2000.0

ROUNDING = 1e-14
"""A few roundings, each beside a logarithm of size five."""
PANELS = 1e-12
"""What Gauss rules on graded panels leave."""
CONDENSED = 1e-9
"""At Q = 1e6 the distance to the pole is known to 1e-10 of itself."""

QUALITIES = [0.5, 1 / sqrt(2), 1.0, 10.0, 1e3, 1e6]


def falling(slope):
    """Give a profile of level 1 at 20 Hz that falls by a log-log slope up to 2000 Hz."""
    return [LOW, HIGH], [1.0, (HIGH / LOW) ** slope]


@pytest.mark.parametrize("off", [-1e-9, -1e-12, 0.0, 1e-12, 1e-9])
def test_the_area_passes_slope_minus_one_without_a_hole(off, kept):
    """The power rule divides by m + 1: zero at −1, and digits gone on both sides of it."""
    run = np.log(HIGH / LOW)
    exact = LOW * run * (1 + off * run / 2)  # the next term is 1e-18
    # a level of 100^(−1 + off) is rounded to 1e-16, and so is the slope it stands for
    found = float(spectral_moment(*falling(-1 + off)))
    assert found == pytest.approx(exact, rel=ROUNDING)
    kept(found, exact)


@pytest.mark.parametrize(("off", "where"), [(-1e-9, LOW), (0.0, LOW), (1e-9, HIGH)])
def test_miles_worst_case_at_slope_minus_one_is_the_lowest_of_equal_frequencies(off, where):
    """f·G is constant there: rounding alone would choose the frequency that is reported."""
    worst = miles_worst_case(*falling(-1 + off), 100.0)
    assert worst.frequency == where
    assert float(worst.response) == pytest.approx(sqrt(pi / 2 * 100 * LOW), rel=1e-8)


@pytest.mark.parametrize("Q", QUALITIES)
def test_the_exact_response_is_smooth_through_slope_minus_one(Q, kept):
    """A formula with a special case at −1 jumps beside it."""
    found = [
        float(oscillator_response(*falling(-1 + off), 200.0, Q).absolute_acceleration)
        for off in (-1e-9, 0.0, 1e-9)
    ]
    assert found[0] == pytest.approx(found[2], rel=5e-9)
    assert found[1] == pytest.approx((found[0] + found[2]) / 2, rel=10 * PANELS)
    kept(found[1], (found[0] + found[2]) / 2)


def test_a_step_has_no_area_and_both_of_its_levels():
    """A step is a segment of no width: a slope of infinity times a length of zero."""
    f, g = [20.0, 100.0, 100.0, 500.0], [1.0, 1.0, 9.0, 9.0]
    assert rms(f, g) == pytest.approx(sqrt(80 + 9 * 400), rel=ROUNDING)
    sides = [float(spectral_level(100.0, f, g, side=side)) for side in ("left", "right", "upper")]
    assert sides == [1.0, 9.0, 9.0]


@pytest.mark.parametrize("Q", QUALITIES)
def test_the_two_halves_of_a_step_respond_as_the_whole(Q, kept):
    """An integration over a step, or a resonance on it, counts its edge twice or not at all."""
    f, g = [20.0, 100.0, 100.0, 500.0], [1.0, 1.0, 9.0, 9.0]
    whole = oscillator_response(f, g, 100.0, Q)
    halves = [
        oscillator_response(f[part], g[part], 100.0, Q) for part in (slice(0, 2), slice(2, 4))
    ]
    together = sqrt(sum(float(half.absolute_acceleration) ** 2 for half in halves))
    assert float(whole.absolute_acceleration) == pytest.approx(together, rel=PANELS)
    kept(whole.absolute_acceleration, together)


def test_a_step_is_the_limit_of_a_steep_line(kept):
    """A line over 1e-12 of its frequency has a slope of 1e12: powers of it overflow."""
    step = ([20.0, 100.0, 100.0, 500.0], [1.0, 1.0, 9.0, 9.0])
    steep = ([20.0, 100.0, 100.0 * (1 + 1e-12), 500.0], [1.0, 1.0, 9.0, 9.0])
    assert rms(*steep) == pytest.approx(rms(*step), rel=1e-12)
    found, exact = (
        float(oscillator_response(*profile, 100.0, 10.0).absolute_acceleration)
        for profile in (steep, step)
    )
    assert found == pytest.approx(exact, rel=1e-11)
    kept(found, exact)


def test_a_profile_that_ends_at_the_frequency_asked_has_its_level_there():
    """The last breakpoint has no segment to its right, the first none to its left."""
    f, g = [20.0, 2000.0], [0.3, 0.7]
    for side in ("left", "right", "upper"):
        assert spectral_level([20.0, 2000.0], f, g, side=side).tolist() == g
    assert spectral_level(np.nextafter([20.0, 2000.0], [0.0, 1e9]), f, g).tolist() == [0.0, 0.0]
    assert [part.tolist() for part in clip_profile(f, g, upper=20.0)] == [[20.0], [0.3]]
    worst = miles_worst_case(f, g, 10.0, lower=2000.0)
    assert (worst.frequency, worst.level) == (2000.0, 0.7)


def test_a_resonance_at_the_band_s_end_has_half_of_its_response():
    """Half of the resonance lies outside: an integration that misses the edge has all or none."""
    flat = ([20.0, 2000.0], [0.2, 0.2])
    half = float(oscillator_response(*flat, 2000.0, 1e6).pseudo_acceleration)
    # what the flanks add is a few times 1/Q
    assert half == pytest.approx(float(miles(2000.0, 1e6, 0.2)) / sqrt(2), rel=5e-6)


def flat_band_integral(start, end, Q):
    """∫ |H_z|² dr, by its poles r² = s² and their conjugates, s = √(1 − 1/(4Q²)) + i/(2Q)."""
    if Q == 0.5:
        low, high = (r / (2 * (1 + r**2)) + atan(r) / 2 for r in (start, end))
        return high - low
    s = complex(sqrt(1 - 1 / (4 * Q**2)), 1 / (2 * Q))
    # s ∓ r stay in the upper half plane, so that no branch is crossed
    turned = complex_log((s - end) / (s - start)) - complex_log((s + end) / (s + start))
    return (turned / (2 * s)).imag / (2 * s.real * s.imag)


@pytest.mark.parametrize("Q", QUALITIES)
@pytest.mark.parametrize("fn", [2.0, 20.0, 200.0, 2000.0, 2e4])
def test_every_quality_factor_gives_the_closed_form_of_a_flat_band(Q, fn, kept):
    """A resonance 1e-6 wide falls between the points of any fixed grid; none at all at Q = 1/2."""
    found = oscillator_response([LOW, HIGH], [0.2, 0.2], fn, Q).pseudo_acceleration
    exact = 0.2 * fn * flat_band_integral(LOW / fn, HIGH / fn, Q)
    assert float(found) ** 2 == pytest.approx(exact, rel=CONDENSED)
    kept(float(found) ** 2, exact)


@pytest.mark.parametrize("Q", QUALITIES)
def test_a_band_of_twelve_decades_is_white_noise(Q):
    """Millions of half-widths between a resonance and the band's ends: graded or lost."""
    band = ([1e-4, 1e8], [0.2, 0.2])
    found = oscillator_response(*band, 100.0, Q)
    white = white_noise(100.0, Q, 0.2)
    # what lies below the band's lower end is 1e-6 of f_n
    for name in ("pseudo_acceleration", "relative_displacement"):
        assert float(getattr(found, name)) == pytest.approx(white[name], rel=2e-6)


@pytest.mark.parametrize("Q", QUALITIES)
def test_the_worst_oscillator_of_a_profile_with_a_step_is_not_missed(Q):
    """The greatest response lies within 1/Q of an edge, where no even grid has a point."""
    f, g = [20.0, 100.0, 100.0, 2000.0], [0.01, 0.01, 0.16, 0.01]
    worst = ResponseSpectrum(np.array(f), np.array(g), Q).maximum()
    around = 100.0 * (1 + np.linspace(-5, 20, 251) / Q)
    asked = np.concatenate([around[around > 20.0], np.geomspace(20.0, 2000.0, 200)])
    seen = oscillator_response(f, g, asked[asked <= 2000.0], Q).absolute_acceleration.max()
    assert worst.response >= float(seen) * (1 - CONDENSED)


def test_an_envelope_of_touching_bands_has_one_step():
    """Bands that meet in one frequency leave no gap, and no point that stands three times."""
    f, g = envelope([([20, 100], [1, 1]), ([100, 500], [4, 4]), ([100, 200], [2, 2])])
    assert (f.tolist(), g.tolist()) == ([20, 100, 100, 500], [1, 1, 4, 4])
