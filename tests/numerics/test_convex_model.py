"""Posynomials that share value, gradient and curvature with an expansion, and the step."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.convex_model import best_step, posynomials
from flexcli.numerics.log_sum_exp import Expansion


def expansion(seed, rows, n, *, convex=True):
    rng = np.random.default_rng(seed)
    roots = rng.normal(size=(rows, n, n))
    H = roots @ np.swapaxes(roots, 1, 2) if convex else roots + np.swapaxes(roots, 1, 2)
    return Expansion(rng.normal(size=rows), rng.normal(size=(rows, n)), H)


@given(st.integers(0, 10_000), st.integers(1, 4))
def test_the_posynomials_touch_the_expansion_to_second_order(seed, n):
    at = expansion(seed, 3, n)
    found = posynomials(at).expand(np.zeros(n))
    assert found.values == pytest.approx(at.values, abs=1e-12)
    assert found.jacobian == pytest.approx(at.jacobian, abs=1e-10)
    for r, weights in enumerate(np.eye(3)):
        assert found.curvature(weights) == pytest.approx(at.curvatures[r], abs=1e-4)


@given(st.integers(0, 10_000))
def test_concave_parts_are_left_out(seed):
    at = expansion(seed, 1, 3, convex=False)
    bends, ways = np.linalg.eigh(at.curvatures[0])
    kept = (ways * np.maximum(bends, 0.0)) @ ways.T
    assert posynomials(at).expand(np.zeros(3)).curvature(np.ones(1)) == pytest.approx(
        kept, abs=1e-4
    )


def step_of(at, inequalities, half, penalty):
    model = posynomials(Expansion(*(part[: 1 + inequalities] for part in at)))
    box = np.full(at.jacobian.shape[1], half)
    return best_step(at, model, -box, box, penalty=penalty)


def test_the_step_is_that_of_a_quadratic_with_one_row_in_the_way():
    # minimise (y₁ + y₂)-like slopes against y₁ ≥ −0.1: the row holds, the box ends the rest
    at = Expansion(np.array([0.0, -0.1]), np.array([[1.0, 1.0], [-1.0, 0.0]]), np.zeros((2, 2, 2)))
    found = step_of(at, 1, 0.5, 100.0)
    assert found.step == pytest.approx([-0.1, -0.5], abs=1e-8)
    assert found.multipliers == pytest.approx([1.0], abs=1e-6)
    assert found.fall == pytest.approx(0.6, abs=1e-8)


def test_a_row_out_of_reach_keeps_the_violation_that_the_box_leaves():
    at = Expansion(np.array([0.0, 2.0]), np.array([[0.0], [1.0]]), np.zeros((2, 1, 1)))
    found = step_of(at, 1, 0.5, np.inf)
    assert found.violation == pytest.approx(1.5, abs=1e-8)
    assert found.multipliers == pytest.approx([1.0], abs=1e-6)


def test_an_equality_is_met_from_either_side():
    for value in (0.3, -0.3):
        at = Expansion(np.array([0.0, value]), np.array([[0.1], [1.0]]), np.zeros((2, 1, 1)))
        found = step_of(at, 0, 1.0, 100.0)
        assert found.step == pytest.approx([-value], abs=1e-8)
