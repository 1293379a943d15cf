"""The greatest exact response and Miles' shortfall: dense scans, limits, steps, units."""

import doctest

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.optimize import minimize_scalar
from spectra import GEVS, profiles

from flexcli.formulas import response_spectrum as module
from flexcli.formulas.miles import miles, miles_worst_case
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.response_spectrum import miles_shortfall, response_maximum
from flexcli.formulas.spectrum import spectral_level

PROMISED = 1e-8  # what the value is good for
STEP = ([20, 100, 100, 2000], [0.01, 0.01, 0.16, 0.16])


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


@pytest.mark.parametrize("Q", [0.5, 5.0, 100.0, 1e4])
@pytest.mark.parametrize("profile", [GEVS, STEP, ([20, 2000], [0.04, 0.0004])])
def test_the_maximum_agrees_with_a_scalar_minimiser(profile, Q):
    most = response_maximum(*profile, Q)

    def response(fn):
        return float(oscillator_response(*profile, fn, Q).absolute_acceleration)

    reach = 0.3 / Q
    low = max(most.frequency * (1 - reach), profile[0][0])
    high = min(most.frequency * (1 + reach), profile[0][-1])
    other = minimize_scalar(
        lambda fn: -response(fn), bounds=(low, high), method="bounded", options={"xatol": 1e-7}
    )
    assert most.response == pytest.approx(response(most.frequency), rel=PROMISED)
    assert most.response >= -other.fun * (1 - PROMISED)


@given(profile=profiles(), Q=st.sampled_from([0.5, 3.0, 30.0, 1000.0]), data=st.data())
@settings(max_examples=40)
def test_no_natural_frequency_of_the_band_responds_more(profile, Q, data):
    f, g = profile
    most = response_maximum(f, g, Q)
    near = f[data.draw(st.integers(0, f.size - 1))]
    scan = np.concatenate([
        f[0] * (f[-1] / f[0]) ** np.linspace(0, 1, 60),
        near * (1 + np.linspace(-3, 3, 61) / Q),
    ])  # fmt: skip
    scan = scan[(scan >= f[0]) & (scan <= f[-1])]
    responses = oscillator_response(f, g, scan, Q).absolute_acceleration
    assert responses.max() <= most.response * (1 + PROMISED)


@given(profile=profiles(), Q=st.sampled_from([0.5, 3.0, 30.0, 1000.0]))
@settings(max_examples=40)
def test_no_natural_frequency_of_the_band_exceeds_miles_more(profile, Q):
    f, g = profile
    low = miles_shortfall(f, g, Q)
    scan = f[0] * (f[-1] / f[0]) ** np.linspace(0, 1, 120)
    scan = scan[(scan >= f[0]) & (scan <= f[-1])]
    exact = oscillator_response(f, g, scan, Q).absolute_acceleration
    for side in ("left", "right"):
        ratio = exact / miles(scan, Q, spectral_level(scan, f, g, side=side))
        inside = (scan > f[0]) & (scan < f[-1])
        assert (ratio[inside] - 1).max() <= low.excess + PROMISED * (1 + low.excess)


def test_below_a_step_miles_misses_half_of_the_resonance_above():
    # at the step of a lightly damped oscillator half the resonance sees either level
    low = miles_shortfall(*STEP, 1e5)
    assert low.frequency == pytest.approx(100, rel=1e-4)
    assert (1 + low.excess) ** 2 == pytest.approx((0.01 + 0.16) / 2 / 0.01, rel=1e-3)


@pytest.mark.parametrize("Q", [100.0, 1e3, 1e4])
def test_the_maximum_tends_to_miles_worst_case_as_q_grows(Q):
    most, worst = response_maximum(*GEVS, Q), miles_worst_case(*GEVS, Q)
    # the resonance is some 1/Q wide, and the level falls on one side of it only
    assert most.response == pytest.approx(float(worst.response), rel=3 / Q)
    assert most.frequency == pytest.approx(worst.frequency, rel=1 / Q)


@given(profile=profiles(), unit=st.floats(1e-3, 1e3))
@settings(max_examples=20)
def test_units_scale_out(profile, unit):
    f, g = profile
    base, louder = response_maximum(f, g, 20.0), response_maximum(f, g * unit**2, 20.0)
    assert louder.response == pytest.approx(unit * base.response, rel=PROMISED)
    assert miles_shortfall(f, g * unit**2, 20.0).excess == pytest.approx(
        miles_shortfall(f, g, 20.0).excess, abs=PROMISED * 10
    )


def test_linear_lines_serve_too():
    f, g = [20.0, 1000.0, 2000.0], [0.1, 1.0, 0.1]
    most = response_maximum(f, g, 50.0, scale="linear")
    scan = np.linspace(20, 2000, 4000)
    dense = oscillator_response(f, g, scan, 50.0, scale="linear").absolute_acceleration
    assert dense.max() <= most.response * (1 + PROMISED)
    assert most.response == pytest.approx(dense.max(), rel=1e-5)  # the scan's own coarseness


def test_an_overdamped_oscillator_is_refused():
    with pytest.raises(ValueError, match=r"at least 0\.5"):
        response_maximum(*GEVS, 0.4)
