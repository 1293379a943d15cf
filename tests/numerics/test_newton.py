import numpy as np
import pytest

from flexcli.errors import Outcome
from flexcli.numerics.continuation import march
from flexcli.numerics.newton import newton


def length(_, step):
    return np.max(np.abs(step), axis=1)


def square_root(targets):
    """Newton's step for x² = target; no real root for a negative one."""

    def step(x, rows):
        return -(x**2 - targets[rows, None]) / (2.0 * x)

    return step


def test_each_design_ends_by_itself():
    targets = np.array([2.0, -1.0, 9.0, 5.0])
    start = np.array([[1.0], [0.7], [2.9], [0.0]])
    found = newton(square_root(targets), length, start, tolerance=1e-14)
    assert found.x[[0, 2], 0] == pytest.approx([np.sqrt(2.0), 3.0], rel=1e-15)
    assert found.end[0] is found.end[2] is Outcome.CONVERGED
    assert found.end[1] is Outcome.STALLED
    assert found.end[3] is Outcome.SINGULAR
    assert found.iterations[2] < found.iterations[0]


@pytest.mark.parametrize("trust", [np.inf, 0.3])
def test_a_design_ends_alone_as_beside_others(trust):
    targets = np.array([2.0, -1.0, 9.0, 5.0, 4.0, 1e30])
    start = np.array([[1.0], [0.7], [2.9], [0.0], [2.0], [1.0]])
    how = {"tolerance": 1e-12, "trust": trust, "most": 12}
    scale = np.linspace(0.0, 1.0, 6)
    together = newton(square_root(targets), length, start, scale=scale, **how)
    for i in range(targets.size):
        own = slice(i, i + 1)
        alone = newton(square_root(targets[own]), length, start[own], scale=scale[own], **how)
        for mine, theirs in zip(alone, together, strict=True):
            assert np.array_equal(mine, theirs[own])


def test_convergence_is_quadratic():
    sizes = []

    def step(x, rows):
        s = square_root(np.array([2.0]))(x, rows)
        sizes.append(abs(float(s[0, 0])))
        return s

    newton(step, length, np.array([[3.0]]), tolerance=1e-15)
    order = np.polyfit(np.log(sizes[1:-1]), np.log(sizes[2:]), 1)[0]
    assert order == pytest.approx(2.0, abs=0.1)


def test_a_second_step_beyond_trust_is_far():
    found = newton(
        square_root(np.array([2.0])), length, np.array([[0.3]]), tolerance=1e-12, trust=0.1
    )
    assert found.end[0] is Outcome.OFF_PATH


def test_a_tiny_solution_is_found_to_the_same_digits():
    found = newton(square_root(np.array([4e-18])), length, np.array([[2.1e-9]]), tolerance=1e-13)
    assert found.x[0, 0] == pytest.approx(2e-9, rel=1e-13)


def cubic(x, load):
    """x − x³/3 = load turns at x = 1, load = 2/3."""
    return x - x**3 / 3.0 - load[:, None]


def test_a_march_stops_at_the_limit_point_and_goes_on_elsewhere():
    ends = np.array([0.5, 1.0])

    def step(x, share, rows):
        return -cubic(x, share * ends[rows]) / (1.0 - x**2)

    def correct(x, share, rows):
        return newton(
            lambda y, of: step(y, share[of], rows[of]),
            length,
            x,
            tolerance=1e-13,
            trust=0.3,
        )

    def kind(x, share, rows):
        return (x[:, 0] > 1.0).astype(np.intp)

    found = march(correct, step, length, kind, np.zeros((2, 1)))
    assert found.reached[0] == 1.0
    assert found.x[0, 0] - found.x[0, 0] ** 3 / 3.0 == pytest.approx(0.5, rel=1e-13)
    assert found.reached[1] == pytest.approx(2.0 / 3.0, abs=1e-3)
    assert found.x[1, 0] < 1.0
