"""Fitted polynomials against polynomials, and their bounds against their values."""

import numpy as np
import pytest

from flexcli.numerics.polynomial_fit import polynomial_fit, terms

RNG = np.random.default_rng(1)


def cubic(u):
    x, y = u.T
    return np.stack([1.0 + x - 2.0 * x * y + y**3, x**2 * y - y], axis=1)


def test_a_polynomial_of_the_degree_is_found_again_with_its_slopes():
    u = RNG.uniform(-1.0, 1.0, (3 * terms(2, 3), 2))
    found = polynomial_fit(u, cubic(u), 3)
    other = RNG.uniform(-1.0, 1.0, (50, 2))
    assert found.at(other) == pytest.approx(cubic(other), abs=1e-12)
    x, y = other.T
    slope = found.slope(1).at(other)
    assert slope[:, 0] == pytest.approx(-2.0 * x + 3.0 * y**2, abs=1e-11)
    assert slope[:, 1] == pytest.approx(x**2 - 1.0, abs=1e-11)


@pytest.mark.parametrize("degree", [1, 2, 3, 4])
def test_the_error_falls_with_one_power_more_than_the_degree(degree):
    widths, errors = np.array([0.4, 0.2, 0.1]), []
    u, other = RNG.uniform(-1.0, 1.0, (80, 2)), RNG.uniform(-1.0, 1.0, (200, 2))

    def smooth(p):
        return np.exp(p[:, :1] + 0.5 * p[:, 1:])

    for width in widths:
        fit = polynomial_fit(u, smooth(width * u), degree)
        errors.append(np.abs(fit.at(other) - smooth(width * other)).max())
    order = np.polyfit(np.log(widths), np.log(errors), 1)[0]
    assert order == pytest.approx(degree + 1, abs=0.3)


def test_no_value_in_a_box_is_beyond_the_bounds():
    u = RNG.uniform(-1.0, 1.0, (60, 2))
    found = polynomial_fit(u, cubic(u), 3)
    low, high = np.array([-0.5, 0.2]), np.array([0.3, 0.9])
    least, most = found.bounds(low, high)
    values = cubic(RNG.uniform(low, high, (2000, 2)))
    assert (least <= values.min(axis=0)).all()
    assert (most >= values.max(axis=0)).all()
    lowest, highest = found.bounds(low, low)  # a point
    assert lowest == pytest.approx(cubic(low[None, :])[0], abs=1e-12)
    assert highest == pytest.approx(lowest, abs=1e-12)
