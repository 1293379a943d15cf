"""The continued logarithm of a utilisation: exact near one, a number everywhere."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.log_utilisation import JOINT, log_utilisation

POSITIVE = st.floats(1e-6, 1e6)


@given(POSITIVE, st.floats(JOINT, 1e6))
def test_it_is_the_logarithm_wherever_a_limit_is_near(capacity, used):
    assert log_utilisation(used * capacity, capacity) == pytest.approx(np.log(used), abs=1e-12)


@given(st.floats(-1e6, 1e6), st.floats(-1e6, 1e6))
def test_it_is_at_most_zero_exactly_where_the_demand_is_met(demand, capacity):
    met = demand <= max(capacity, 0.0)
    assert (log_utilisation(demand, capacity) <= 0.0) == met


def test_value_and_slope_do_not_jump_where_the_logarithm_is_continued():
    step = 1e-7
    low, at, high = log_utilisation([JOINT - step, JOINT, JOINT + step], 1.0)
    assert (at - low) / step == pytest.approx((high - at) / step, rel=1e-5)


@given(st.floats(-1e6, 1e6), st.floats(1e-6, 1e6))
def test_it_grows_with_the_demand(demand, more):
    assert log_utilisation(demand + more, 1.0) >= log_utilisation(demand, 1.0)


def test_what_has_no_capacity_is_worse_than_any_that_has_and_the_more_the_less():
    values = log_utilisation(1.0, [1e-300, -1.0, -2.0])
    assert (np.diff(values) > 0.0).all()


def test_what_is_no_number_stays_so():
    assert np.isnan(log_utilisation([np.nan, 1.0], [1.0, np.nan])).all()


def test_arrays_give_what_their_elements_give():
    demand, capacity = np.array([[2.0], [-1.0]]), np.array([1.0, 3.0, -1.0])
    found = log_utilisation(demand, capacity)
    assert found.shape == (2, 3)
    assert found.tolist() == [
        [float(log_utilisation(d, c)) for c in capacity] for d in demand[:, 0]
    ]
