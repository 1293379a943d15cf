"""Stacks of linear systems: eliminated together they have the answers that each has alone."""

import numpy as np
import pytest

from flexcli.numerics.stack import solve_across, solve_stack


@pytest.mark.parametrize("n", [1, 5, 20])
def test_systems_side_by_side_have_the_answers_of_each_alone(n):
    rng = np.random.default_rng(n)
    A, b = rng.normal(size=(2, n, n, 600)) / n, rng.normal(size=(2, n, 3, 600))
    A += 2.0 * np.eye(n)[:, :, None]
    alone = solve_stack(A.transpose(0, 3, 1, 2), b.transpose(0, 3, 1, 2))
    # the condition of these is below 100
    found = solve_across(np.concatenate([A, b], axis=2)).transpose(0, 3, 1, 2)
    assert found == pytest.approx(alone, rel=1e-12, abs=1e-13)


def test_a_system_without_a_first_pivot_is_solved_and_a_singular_one_spoils_no_other():
    A = np.stack([np.eye(2), [[0.0, 1.0], [1.0, 0.0]], np.ones((2, 2))], axis=-1)[None]
    b = np.stack([[[3.0], [4.0]]] * 3, axis=-1)[None]
    x = solve_across(np.concatenate([A, b], axis=2))[0, :, 0]
    assert x[:, 0].tolist() == [3.0, 4.0]
    assert x[:, 1].tolist() == [4.0, 3.0]
    assert np.isnan(x[:, 2]).all()


@pytest.mark.parametrize("pivot", [2e-3, 2e-2, 0.2])
def test_a_first_pivot_that_nearly_vanishes_takes_no_digits(pivot):
    """Without an exchange of rows the residual is 1/pivot of rounding, as the numbers grow so."""
    A = np.stack([[[p, 1.0], [1.0, 1.0 + 1.0 / 3.0]] for p in pivot * np.linspace(1.0, 3.0, 600)])
    b = np.broadcast_to([[1.0 / 7.0], [1.0]], (600, 2, 1))
    system = np.concatenate([A, b], axis=2).transpose(1, 2, 0)[None]
    x = solve_across(system)[0].transpose(2, 0, 1)
    assert np.max(np.abs(A @ x - b)) < 4.0 * np.finfo(float).eps
