import numpy as np
import pytest

from flexcli.numerics.arc_length import follow
from flexcli.numerics.collocation import (
    gauss_nodes,
    integration_matrix,
    integration_to,
    interpolation_matrix,
    slope_matrix,
)
from flexcli.numerics.stack import solve_stack


@pytest.mark.parametrize("count", [1, 2, 5, 12, 40])
def test_integration_is_exact_for_polynomials(count):
    u, _ = gauss_nodes(count)
    power = count - 1
    exact = (u ** (power + 1) - (-1.0) ** (power + 1)) / (power + 1)
    assert integration_matrix(count) @ u**power == pytest.approx(exact, abs=1e-14)


def test_integration_is_symplectic():
    """w_i J_ij + w_j J_ji = w_i w_j: what keeps a tangent stiffness symmetric."""
    _, w = gauss_nodes(9)
    J = integration_matrix(9)
    assert w[:, None] * J + (w[:, None] * J).T == pytest.approx(np.outer(w, w), abs=1e-15)


def test_end_values_of_an_equation_have_order_twice_the_nodes():
    """y' = λ y over a step: order 2·count in λ."""
    count = 3
    steps = np.array([0.1, 0.05, 0.025])
    J, (_, w) = integration_matrix(count), gauss_nodes(count)
    errors = []
    for lam in steps:
        y = np.linalg.solve(np.eye(count) - lam * J, np.ones(count))
        errors.append(abs(1.0 + lam * w @ y - np.exp(2.0 * lam)))
    order = np.polyfit(np.log(steps), np.log(errors), 1)[0]
    assert order == pytest.approx(2 * count + 1, abs=0.15)


def test_interpolation_and_integration_agree_at_any_point():
    points = np.linspace(-1.0, 1.0, 7)
    u, _ = gauss_nodes(14)
    assert interpolation_matrix(14, points) @ np.exp(u) == pytest.approx(np.exp(points), rel=1e-11)
    exact = np.exp(points) - np.exp(-1.0)
    assert integration_to(14, points) @ np.exp(u) == pytest.approx(exact, abs=1e-13)
    assert slope_matrix(14, points) @ np.exp(u) == pytest.approx(np.exp(points), rel=1e-10)


@pytest.mark.parametrize("count", [1, 2, 5, 12, 40])
def test_slopes_are_those_of_the_polynomial_through_the_nodes(count):
    u, _ = gauss_nodes(count)
    points = np.linspace(-1.0, 1.0, 5)
    exact = (count - 1) * points ** max(count - 2, 0)
    assert slope_matrix(count, points) @ u ** (count - 1) == pytest.approx(
        exact, rel=1e-10, abs=1e-9
    )


def test_a_singular_matrix_of_a_stack_stays_alone():
    A = np.stack([np.eye(2), np.zeros((2, 2)), 2.0 * np.eye(2)])
    x = solve_stack(A, np.ones((3, 2, 1)))[..., 0]
    assert x[[0, 2]].tolist() == [[1.0, 1.0], [0.5, 0.5]]
    assert np.isnan(x[1]).all()


def test_arc_length_goes_round_a_circle():
    """x² + λ² = 1 from (0, −1) towards larger λ past the fold at λ = 1."""

    def steps(x, parameter):
        # x + 1 for x: the path leaves (x, λ) = (−1, 0), λ rises, turns at 1 and comes back to 0
        return -(x**2 + parameter**2 - 1.0) / (2.0 * x), -parameter / x

    points = follow(
        steps,
        (np.array([-1.0]), 0.0),
        np.ones(1),
        stride=0.1,
        longest=0.2,
        goal=lambda x, _: bool(x[0] > 0.9),
        kind=lambda x, _: int(x[0] > 0.0),
        tolerance=1e-12,
        most=100,
    )
    assert points[-1].x[0] > 0.9
    assert max(p.parameter for p in points) == pytest.approx(1.0, abs=0.02)
    for p in points:
        assert p.x[0] ** 2 + p.parameter**2 == pytest.approx(1.0, abs=1e-11)
