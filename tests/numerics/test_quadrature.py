"""Gauss–Legendre rules: exact for the polynomials they are made for."""

import doctest

import pytest

from flexcli.numerics import quadrature as module
from flexcli.numerics.quadrature import gauss_rule

ROUNDING = 1e-14  # a sum of at most twenty terms


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


@pytest.mark.parametrize("count", [1, 2, 5, 16, 20])
def test_is_exact_up_to_its_degree(count):
    x, w = gauss_rule(count)
    for power in range(2 * count):
        assert float(w @ x**power) == pytest.approx(1 / (power + 1), rel=10 * ROUNDING)


@pytest.mark.parametrize("count", [1, 2, 5])
def test_misses_the_next_degree_by_the_known_remainder(count):
    x, w = gauss_rule(count)
    assert abs(float(w @ x ** (2 * count)) - 1 / (2 * count + 1)) > 1e-8


def test_a_rule_has_nodes():
    with pytest.raises(ValueError, match="deg"):
        gauss_rule(0)
