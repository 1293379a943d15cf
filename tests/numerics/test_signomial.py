"""Signomials carry formulas unchanged."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.ratios import Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, variables

ROUNDING = 1e-13  # a few dozen roundings of sums and products of order one
E = 114e9


def stiffness(E, h, l, b, p):
    return 8 * E * b * h**3 / 12 / l * (1 + 3 * (p / l) + 3 * (p / l) ** 2)


positive = st.floats(0.1, 10.0)


def test_a_formula_runs_unchanged_over_floats_arrays_and_signomials():
    h, l, b, p = variables("h", "l", "b", "p")
    formula = stiffness(E, h, l, b, p)
    point = {"h": 6e-4, "l": 0.0174, "b": 3.6e-3, "p": 2e-3}
    assert formula.at(**point) == pytest.approx(stiffness(E, **point), rel=ROUNDING)
    grid = {**point, "h": np.linspace(1e-4, 1e-3, 5)[:, None], "l": np.linspace(0.01, 0.02, 3)}
    assert formula.at(**grid).shape == (5, 3)
    np.testing.assert_allclose(formula.at(**grid), stiffness(E, **grid), rtol=ROUNDING)
    assert formula.is_posynomial
    assert not formula.is_monomial
    fixed = stiffness(E, h, l, b, -2e-3)
    assert fixed.negative_part().is_monomial
    assert fixed.at(**point) == pytest.approx(stiffness(E, **{**point, "p": -2e-3}), rel=ROUNDING)


@given(positive, positive, st.floats(-3, 3), st.floats(-3, 3))
def test_arithmetic_commutes_with_evaluation(x0, y0, a, c):
    x, y = variables("x", "y")
    for combine in (
        lambda x, y: (a * x + y) * (c - x * y),
        lambda x, y: (x - a) ** 3 / (2 * x * y**0.5),
        lambda x, y: a - (c + x) / y + x**-1.5,
        lambda x, y: -((x + y) ** 0) + 1 / x,
    ):
        value, size = combine(x0, y0), combine(x, y)
        assert size.at(x=x0, y=y0) == pytest.approx(value, rel=1e-9, abs=1e-9)


def test_numpy_operands_on_the_left_defer():
    (x,) = variables("x")
    for left in (np.float64(2.0), np.int64(2), np.array(2.0)):
        assert isinstance(left * x, Signomial)
        assert isinstance(left - x, Signomial)
        assert isinstance(left / x, Signomial)
    with pytest.raises(TypeError):
        np.ones(3) * x


def test_terms_that_cancel_vanish_and_tiny_ones_stay():
    x, y = variables("x", "y")
    assert (x - x).is_zero
    assert (0.1 * x + 0.2 * x - 0.3 * x).is_zero
    assert (x ** (1 / 3) * x ** (2 / 3) - x).is_zero
    assert (x + 1e-30 * y).coefficients.size == 2
    assert repr(x - x) == "0"
    assert repr(2 * x**2 / y - x) == "2*x^2/y - 1*x"


def test_parts_add_up():
    x, y = variables("x", "y")
    s = 3 * x * y - 2 * y**2 + 1
    assert (s.positive_part() - s.negative_part() - s).is_zero
    assert s.positive_part().is_posynomial


def test_operations_outside_the_ring_say_so():
    x, y = variables("x", "y")
    for wrong in (
        lambda: x / (x + y),
        lambda: (x + y) ** -1,
        lambda: (x + y) ** 0.5,
        lambda: (-1 * x) ** 0.5,
        lambda: x / 0.0,
        lambda: x * math.inf,
    ):
        with pytest.raises(ArithmeticError):
            wrong()
    with pytest.raises(KeyError, match="no value for 'y'"):
        (x + y).at(x=1.0)
    with pytest.raises(ValueError, match="assignment destination is read-only"):
        x.coefficients[0] = 2.0


def test_signs_alone_settle_some_rows():
    x, y = variables("x", "y")
    assert at_most("a", x - x - 1, y) == Settled("a", holds=True)
    assert at_most("a", x, 0.0 - y) == Settled("a", holds=False)
    assert at_most("a", 2, 3) == Settled("a", holds=True)
    assert at_most("a", 3 * x, 2 * x) == Settled("a", holds=False)
    row = at_most("a", x - y, 1)
    assert isinstance(row, Ratio)
    assert not row.is_convex
    assert at_most("a", x + y, 3 * x + 2 * y - 1).numerator.at(x=1, y=1) == pytest.approx(3)
    assert at_most("merged", y, 3 * x + y / 2).is_convex
    with pytest.raises(ValueError, match="not a posynomial"):
        Ratio("a", x - y, x)
