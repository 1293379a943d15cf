import doctest
from math import acos, inf, pi, sqrt

import numpy as np
import pytest
from hypothesis import assume, example, given
from hypothesis import strategies as st

from flexcli.numerics import first_crossing as module
from flexcli.numerics.exponential_sum import ExponentialSum
from flexcli.numerics.first_crossing import first_crossing, leaving_step, safe_step

NUMBERS = st.floats(-3.0, 3.0)
SIZES = st.floats(1e-3, 3.0)
ROUNDING = 1e-12
VALUE_ROUNDING = 4e-15
"""What the values of sums of two terms of size one, on a horizon of 40, are good for."""


@example(0.25, 0.0, 0.0, 5e-324, 2.0)  # products of the smallest numbers are zero
@example(1.0, 0.0, -5e-324, 0.0, 1.0)
@given(SIZES, NUMBERS, NUMBERS, st.floats(0.0, 10.0), st.floats(0.1, 10.0))
def test_a_safe_step_has_no_zero_of_the_worst_cubic(d, v, a, J, most):
    step = safe_step(d=d, v=v, a=a, J=J, most=most)
    assert 0.0 < step <= most
    h = np.linspace(0.0, step, 200)
    assert (d + h * (v + h * (a / 2 - h * J / 6)) >= -ROUNDING).all()


@given(SIZES, NUMBERS, st.floats(1e-3, 10.0))
def test_a_function_that_leaves_zero_is_asked_before_it_can_come_back(v, a, J):
    h = leaving_step(v, a, J)
    assert v + a * h / 2 - J * h * h / 6 == pytest.approx(0.0, abs=1e-9 * (v + abs(a) * h))


@pytest.mark.parametrize("a", [0.0, 5e-324, 1.0])
def test_a_function_that_leaves_zero_straight_never_comes_back(a):
    # the third derivative takes 1/J to bend it
    assert leaving_step(1.0, a, 5e-324) > 1e100
    assert leaving_step(1.0, a, 0.0) == inf


@pytest.mark.parametrize("J", [5e-324, 1e-310, 1e-200])
def test_a_step_that_nothing_bends_is_the_longest(J):
    assert safe_step(d=0.25, v=0.0, a=0.0, J=J, most=2.0) == 2.0


@example(1.0 - 1e-9)
@given(st.floats(-0.99, 0.999))
def test_the_first_crossing_of_a_cosine_is_its_arc_cosine(offset):
    distance = ExponentialSum([(1j, (1.0 + 0j,)), (0j, (complex(offset),))], 20.0)
    found, _ = first_crossing(distance, 20.0)
    # an error ε of the value moves the crossing by ε over the slope
    assert found == pytest.approx(acos(-offset), abs=10 * VALUE_ROUNDING / sqrt(1 - offset**2))


@pytest.mark.parametrize("depth", [1e-3, 1e-8, 1e-13])
def test_two_crossings_however_close_are_not_missed(depth):
    distance = ExponentialSum([(1j, (1.0 + 0j,)), (0j, (1.0 - depth + 0j,))], 40.0)
    found, count = first_crossing(distance, 40.0)
    slope = sqrt(2 * depth)
    assert found == pytest.approx(pi - slope, abs=VALUE_ROUNDING / slope + slope * depth)
    assert count < 40


@pytest.mark.parametrize("miss", [1e-3, 1e-8, 1e-13])
def test_a_near_miss_is_passed_and_costs_few_evaluations(miss):
    distance = ExponentialSum([(1j, (1.0 + 0j,)), (0j, (1.0 + miss + 0j,))], 6.0)
    found, count = first_crossing(distance, 6.0)
    assert found == inf
    assert count < 60


@pytest.mark.slow
@given(st.lists(st.tuples(SIZES, st.floats(0.1, 20.0), NUMBERS), min_size=1, max_size=4))
def test_no_sample_before_the_crossing_is_below_zero(parts):
    terms = [(complex(-0.1, w), (size * np.exp(1j * phase),)) for size, w, phase in parts]
    distance = ExponentialSum([*terms, (0j, (1.0 + 0j,))], 5.0)
    assume(distance(0.0) > 1e-3)
    found, _ = first_crossing(distance, 5.0)
    grid = np.linspace(0.0, min(found, 5.0), 2000)[:-1]
    assert min(map(distance, grid)) > -ROUNDING
    if found < inf:
        assert distance(found) == pytest.approx(0.0, abs=1e-9)


def test_a_start_at_zero_that_rises_is_no_crossing():
    distance = ExponentialSum([(1j, (-1j,))], 10.0)  # sin t
    assert first_crossing(distance, 10.0)[0] == pytest.approx(pi, abs=ROUNDING)


def test_a_start_at_zero_that_falls_is_a_crossing_now():
    distance = ExponentialSum([(1j, (1j,))], 10.0)  # −sin t
    assert first_crossing(distance, 10.0) == (0.0, 1)


def test_the_example_runs():
    assert doctest.testmod(module).failed == 0
