"""Transfer functions against the source's closed form and the equation of motion itself."""

from math import pi

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.formulas.transfer import natural_frequency, transfer

masses, stiffnesses = st.floats(1e-3, 10.0), st.floats(1.0, 1e7)


@given(masses, stiffnesses, st.floats(-1.0, 1.0), st.floats(0.01, 0.9))
def test_undamped_is_the_source_s_form(m, k, tau, ratio):
    f0 = natural_frequency(k, m)
    T = transfer(ratio * f0, m=m, k=k, coupling=tau)
    assert T.imag == 0.0
    assert float(T.real) == pytest.approx(tau / k / (ratio**2 - 1.0), rel=1e-9, abs=1e-300)


@given(masses, stiffnesses, st.floats(0.6, 1e4), st.floats(0.1, 1e4))
def test_damped_solves_the_equation_of_motion(m, k, Q, f):
    s = 2j * pi * f
    T = complex(transfer(f, m=m, k=k, coupling=0.3, Q=Q))
    left = (m * s**2 + np.sqrt(k * m) / Q * s + k) * T * s**2 + 0.3 * s**2
    assert abs(left) < 1e-9 * abs(0.3 * s**2)


def test_at_resonance_damping_leaves_q_times_the_static_value_a_quarter_turn_behind():
    f0 = natural_frequency(864.0, 1.0)
    T = complex(transfer(f0, m=1.0, k=864.0, coupling=1.0, Q=100.0))
    assert abs(T) == pytest.approx(100.0 / 864.0, rel=1e-9)
    assert np.angle(T) == pytest.approx(pi / 2, abs=1e-9)


def test_an_undamped_resonance_is_infinite_and_a_balanced_stage_has_none():
    k = (2.0 * pi) ** 2  # so that m ω² − k is zero to the last digit at 1 Hz
    assert np.isinf(transfer(1.0, m=1.0, k=k, coupling=1.0).real)
    assert transfer(1.0, m=1.0, k=k, coupling=0.0) == 0.0


def test_without_stiffness_the_stage_stays_behind_by_its_share_of_the_motion():
    T = transfer([1.0, 10.0], m=2.0, k=0.0, coupling=1.0)
    assert np.real(T) == pytest.approx(0.5 / (2 * pi * np.array([1.0, 10.0])) ** 2)
