"""Differences in logarithms against analytic derivatives."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.log_stencil import differences
from flexcli.numerics.log_sum_exp import pack
from flexcli.numerics.signomial import variables

X, Y, Z = variables("x", "y", "z")
ROWS = pack([X * Y + 2 * Z**3 + 1, X**2 / Z + Y, 3 * X**-4 * Y**2.5], ("x", "y", "z"))
POINTS = st.lists(st.floats(-2.0, 2.0), min_size=3, max_size=3).map(np.array)


def rows(y):
    return np.array([ROWS.values(point) for point in y.T]).T


@given(POINTS)
def test_values_gradients_and_curvatures_are_the_analytic_ones(y):
    found, exact = differences(rows, y), ROWS.expand(y)
    assert found.values == pytest.approx(exact.values, abs=1e-14)
    assert found.jacobian == pytest.approx(exact.jacobian, abs=1e-9)
    for r, weights in enumerate(np.eye(3)):
        assert found.curvatures[r] == pytest.approx(exact.curvature(weights), abs=1e-6)


def test_all_points_are_asked_for_in_one_call():
    asked = []

    def counted(y):
        asked.append(y.shape)
        return rows(y)

    differences(counted, np.zeros(3))
    assert asked == [(3, 25)]


def test_an_expansion_off_the_domain_says_that_it_is_none():
    assert differences(rows, np.zeros(3)).is_finite
    assert not differences(lambda y: np.where(y > 1e-3, np.nan, y), np.zeros(3)).is_finite
