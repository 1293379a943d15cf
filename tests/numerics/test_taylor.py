"""Truncated Taylor series against series that everybody knows, and identities."""

from math import cos as number_cos
from math import factorial, isclose
from math import sin as number_sin

import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.taylor import Taylor, cos, lifted, sin

points = st.floats(-3.0, 3.0)


@given(points)
def test_sine_and_cosine_have_their_derivatives(at):
    q = Taylor.variable(at, 6)
    cycle = [number_sin(at), number_cos(at), -number_sin(at), -number_cos(at)]
    for k in range(7):
        assert isclose(sin(q).coefficients[k] * factorial(k), cycle[k % 4], abs_tol=1e-14)
        assert isclose(cos(q).coefficients[k] * factorial(k), cycle[(k + 1) % 4], abs_tol=1e-14)


@given(points, st.floats(-2.0, 2.0))
def test_sine_squared_and_cosine_squared_add_to_one(at, scale):
    angle = Taylor.variable(at, 5) * scale
    one = sin(angle) * sin(angle) + cos(angle) * cos(angle)
    assert one.coefficients == pytest.approx((1.0, 0.0, 0.0, 0.0, 0.0, 0.0), abs=1e-12)


def test_a_quotient_is_the_geometric_series():
    q = Taylor.variable(0.0, 4)
    assert (lifted(1.0, 4) / (1.0 - q)).coefficients == (1.0, 1.0, 1.0, 1.0, 1.0)


@given(points.filter(lambda x: abs(x) > 0.1))
def test_a_quotient_times_its_divisor_is_the_dividend(at):
    q = Taylor.variable(at, 5)
    back = (sin(q) / q) * q
    assert back.coefficients == pytest.approx(sin(q).coefficients, abs=1e-9)


def test_the_derivative_of_a_cube():
    q = Taylor.variable(2.0, 3)
    cube = q * q * q
    assert cube.coefficients == (8.0, 12.0, 6.0, 1.0)
    assert cube.derivative().coefficients == (12.0, 12.0, 3.0)


def test_an_operation_keeps_as_many_orders_as_both_know():
    short, long = Taylor.variable(1.0, 1), Taylor.variable(1.0, 4)
    assert (short * long).order == (short + long).order == (long / short).order == 1
