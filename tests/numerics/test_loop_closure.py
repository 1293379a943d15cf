"""Curves of solutions: known curves, their derivatives, folds and bifurcations they end at."""

import doctest

import numpy as np
import pytest

from flexcli.errors import SolveError
from flexcli.numerics import loop_closure as module
from flexcli.numerics.loop_closure import Curve, CurvePoints, follow, solve_at

ROUNDING = 1e-13
FOLD = 1e-10  # where a curve that turns back ends, and a decade
BIFURCATION = 1e-6  # where two curves cross rounding moves the points, and a decade


class Circle:
    """x² + y² = 1, driven by x."""

    def values(self, q):
        x, y = q[..., 0], q[..., 1]
        return np.stack([x**2 + y**2 - 1.0, x], axis=-1)

    def jacobian(self, q):
        rows = np.zeros((*q.shape, 2))
        rows[..., 0, :] = 2.0 * q
        rows[..., 1, 0] = 1.0
        return rows

    def bend(self, q, v):
        rows = np.zeros_like(v)
        rows[..., 0] = 2.0 * (v**2).sum(axis=-1)
        return rows


class Crossings:
    """y (y − x) = 0 for each of several y, driven by x: all the curves cross at x = 0."""

    def values(self, q):
        x, y = q[..., -1:], q[..., :-1]
        return np.concatenate([y * (y - x), x], axis=-1)

    def jacobian(self, q):
        x, y = q[..., -1:], q[..., :-1]
        rows = np.zeros((*q.shape, q.shape[-1]))
        for i in range(q.shape[-1] - 1):
            rows[..., i, i] = 2.0 * y[..., i] - x[..., 0]
            rows[..., i, -1] = -y[..., i]
        rows[..., -1, -1] = 1.0
        return rows

    def bend(self, q, v):
        x, y = v[..., -1:], v[..., :-1]
        return np.concatenate([2.0 * y * (y - x), 0.0 * x], axis=-1)


def test_docstring_examples_run():
    assert doctest.testmod(module).failed == 0


@pytest.mark.parametrize("side", [1.0, -1.0])
def test_follows_its_own_side_of_a_circle_with_exact_derivatives(side):
    curve = follow(Circle(), np.array([0.0, side]), start=0.0, low=-0.9, high=0.9)
    x = np.linspace(-0.9, 0.9, 41)
    found = solve_at(Circle(), curve, x)
    y = side * np.sqrt(1.0 - x**2)
    assert found.q[:, 1] == pytest.approx(y, abs=ROUNDING)
    assert found.first[:, 1] == pytest.approx(-x / y, rel=1e-12)
    assert found.second[:, 1] == pytest.approx(-1.0 / y**3, rel=1e-12)


def test_ends_equal_what_was_asked_exactly():
    curve = follow(Circle(), np.array([0.0, 1.0]), start=0.0, low=-0.7, high=0.3)
    assert (curve.parameters[0], curve.parameters[-1]) == (-0.7, 0.3)
    assert np.all(np.diff(curve.parameters) > 0.0)


def test_a_curve_that_turns_back_ends_where_it_does():
    curve = follow(Circle(), np.array([0.0, 1.0]), start=0.0, low=-5.0, high=5.0)
    assert curve.parameters[[0, -1]] == pytest.approx([-1.0, 1.0], abs=FOLD)


@pytest.mark.parametrize("copies", [1, 2, 3])
def test_no_step_jumps_over_a_crossing_of_curves(copies):
    # two copies: the determinant touches zero without a change of sign
    start = np.array([0.0] * copies + [-1.0])
    curve = follow(Crossings(), start, start=-1.0, low=-1.5, high=1.0)
    assert curve.parameters[-1] == pytest.approx(0.0, abs=BIFURCATION)
    assert curve.parameters[0] == -1.5
    assert np.all(curve.points.q[:, :-1] == 0.0)


def test_array_call_equals_element_wise_calls():
    curve = follow(Circle(), np.array([0.0, 1.0]), start=0.0, low=-0.9, high=0.9)
    x = np.linspace(-0.9, 0.9, 7)
    together = solve_at(Circle(), curve, x)
    for i, each in enumerate(x):
        alone = solve_at(Circle(), curve, np.array([each]))
        for one, all_of_them in zip(alone, together, strict=True):
            assert one[0] == pytest.approx(all_of_them[i], rel=1e-12, abs=1e-14)


def test_refuses_a_parameter_beyond_the_curve():
    curve = follow(Circle(), np.array([0.0, 1.0]), start=0.0, low=-0.5, high=0.5)
    with pytest.raises(ValueError, match=r"from -0\.5 to 0\.5 only"):
        solve_at(Circle(), curve, np.array([0.6]))


def test_a_step_does_not_leap_a_full_turn_to_where_all_looks_the_same():
    class Turning:
        """q + sin(q)/2 driven: the slope is the same in every turn."""

        def values(self, q):
            return q + 0.5 * np.sin(q)

        def jacobian(self, q):
            return (1.0 + 0.5 * np.cos(q))[..., None]

        def bend(self, q, v):
            return -0.5 * np.sin(q) * v**2

    curve = follow(Turning(), np.array([0.0]), start=0.0, low=0.0, high=4.0 * np.pi)
    assert np.diff(curve.points.q[:, 0]).max() <= 1.0
    assert curve.points.q[-1, 0] == pytest.approx(4.0 * np.pi, abs=ROUNDING)


def test_refuses_a_solution_on_another_curve():
    # from these points Newton's method settles, but on the other half of the circle
    ends = np.array([[-0.1, -0.05], [0.1, -0.05]])
    steep = np.array([[1.0, 20.0], [1.0, 20.0]])
    curve = Curve(np.array([-0.1, 0.1]), CurvePoints(ends, steep, np.zeros((2, 2))))
    with pytest.raises(SolveError, match="on the curve"):
        solve_at(Circle(), curve, np.array([0.05, -0.05]))


def test_says_so_when_newton_does_not_settle():
    no_solution = np.array([[0.0, 1.0], [2.0, 1.0]])
    flat = np.zeros((2, 2))
    curve = Curve(np.array([0.0, 2.0]), CurvePoints(no_solution, flat, flat))
    with pytest.raises(SolveError, match="did not settle"):
        solve_at(Circle(), curve, np.array([1.9]))
