"""Roots of square systems of rows in logarithms."""

import math

import numpy as np
import pytest

from flexcli.numerics.roots import roots

AS_PRINTED = 1e-12  # condition number 63 times a few roundings
E, SIGMA, S, THETA, P, F = 114e9, 500e6, 2.5, 0.0205, 2e-3, 640.84
STARTS = np.log([[3e-4, 1e-2, 1e-2], [1e-3, 5e-2, 2e-3], [1e-4, 1e-3, 0.1]])


def pivot(theta=THETA, factors=(1.0, 1.0, 1.0)):
    def rows(y):
        h, l, b = np.exp(y)
        used = (
            S * E * h * theta * (2 / l + 3 * P / l**2) / SIGMA,
            S * F * 3 * l**2 / (math.sqrt(2) * math.pi**2 * E * b * h**3),
            S * F / (math.sqrt(2) * SIGMA * h * b),
        )
        return np.array([np.log(c * row) for c, row in zip(factors, used, strict=True)])

    return rows


def test_the_fully_used_pivot_has_its_closed_form():
    (root,) = roots(pivot(), STARTS)
    slender = math.pi * math.sqrt(E / (3 * SIGMA))
    h = 9 * S * P * THETA / (math.pi**2 - 6 * S * slender * THETA)
    assert np.exp(root.y) == pytest.approx(
        [h, slender * h, F * S / (h * SIGMA * math.sqrt(2))], rel=AS_PRINTED
    )
    assert h == pytest.approx(637.1e-6, abs=0.05e-6)


def test_a_larger_stroke_has_no_fully_used_design():
    assert roots(pivot(1.2 * THETA), STARTS) == []


def test_the_inverse_jacobian_agrees_with_differences():
    (root,) = roots(pivot(), STARTS)
    for i in range(3):
        ends = []
        for sign in (1, -1):
            factors = np.ones(3)
            factors[i] = math.exp(sign * 1e-5)
            (moved,) = roots(pivot(factors=factors), [root.y])
            ends.append(moved.y)
        slope = (ends[0] - ends[1]) / 2e-5
        np.testing.assert_allclose(slope, -root.inverse[:, i], rtol=1e-6)


def test_all_roots_are_found():
    def rows(y):
        x, z = np.exp(y)
        return np.log(np.array([(x + z) / 3, x * z / 2]))

    found = sorted(np.exp(root.y).tolist() for root in roots(rows, np.array([[-1, 1], [1, -1.0]])))
    np.testing.assert_allclose(found, [(1, 2), (2, 1)], rtol=1e-13)


@pytest.mark.parametrize("closeness", [1e-3, 1e-6])
def test_an_ill_conditioned_system_loses_no_more_than_its_condition_number(closeness):
    exponents = np.array([[1.0, 1.0], [1.0, 1.0 + closeness]])
    at = np.log([2.0, 3.0])
    (root,) = roots(lambda y: exponents @ y - (exponents @ at)[:, None], [np.zeros(2)])
    # of the differences' slopes 1e-12 are rounding
    assert root.condition == pytest.approx(4 / closeness, rel=0.01)
    assert root.y == pytest.approx(at, rel=4 * root.condition * np.finfo(float).eps)


def test_off_the_domain_there_is_no_root():
    assert roots(lambda y: np.where(y > 0.0, np.nan, y + 1.0), [np.ones(1)]) == []
