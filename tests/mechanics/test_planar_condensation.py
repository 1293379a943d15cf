from fractions import Fraction

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from planar_support import condensed, inverse

from flexcli.numerics.square_root import Singular


@given(seed=st.integers(0, 2**32 - 1), kept=st.integers(1, 5))
def test_condensed_form_is_the_schur_complement(seed, kept):
    A = np.random.default_rng(seed).normal(size=(9, 6))
    K, gone = A.T @ A, 6 - kept
    schur = K[gone:, gone:] - K[gone:, :gone] @ np.linalg.solve(K[:gone, :gone], K[:gone, gone:])
    R = condensed(A, kept)
    np.testing.assert_allclose(R.T @ R, schur, rtol=1e-7, atol=1e-9)
    np.testing.assert_allclose(inverse(R), np.linalg.inv(K)[gone:, gone:], rtol=1e-6, atol=1e-7)


@pytest.mark.parametrize("ratio", [1e-3, 1e-5, 1e-7])
def test_soft_direction_askew_beside_a_stiff_one_keeps_its_digits(ratio):
    # a stiff spring along (3, 4, 5), two soft ones beside it; K itself would be singular at 1e-8
    rows = [[3, 4, 5], [1, -2, 1], [2, 1, -3]]
    weights = [Fraction(1), Fraction(ratio), Fraction(ratio)]
    A = np.array([[float(w) * x for x in row] for w, row in zip(weights, rows, strict=True)])
    K = [
        [sum(w * w * r[i] * r[j] for w, r in zip(weights, rows, strict=True)) for j in range(3)]
        for i in range(3)
    ]
    det = K[0][0] * K[1][1] - K[0][1] ** 2
    last = (
        K[2][2]
        - (
            K[2][0] * (K[1][1] * K[0][2] - K[0][1] * K[1][2])
            + K[2][1] * (K[0][0] * K[1][2] - K[0][1] * K[0][2])
        )
        / det
    )
    R = condensed(A, kept=1)
    assert float(R[0, 0] ** 2) == pytest.approx(float(last), rel=1e-13)


def test_chain_of_springs_is_their_series():
    k = np.array([2.0, 3.0, 7.0])
    A = np.sqrt(k)[:, None] * np.array([[1.0, 0, 0], [-1, 1, 0], [0, -1, 1]])
    R = condensed(A, kept=1)
    assert float(R[0, 0] ** 2) == pytest.approx(1 / np.sum(1 / k), rel=1e-14)


def test_fewer_springs_than_coordinates_leave_a_free_one():
    R = condensed(np.array([[1.0, -1.0]]), kept=2)
    np.testing.assert_allclose(R.T @ R, [[1, -1], [-1, 1]], atol=1e-15)
    with pytest.raises(Singular):
        inverse(R)


@pytest.mark.parametrize("A", [[[0.0, 1.0]], [[1.0, 1.0, 1.0], [2.0, 2.0, 0.0]]])
def test_what_nothing_holds_is_refused(A):
    with pytest.raises(Singular):
        condensed(np.array(A), kept=1)


def test_form_without_any_spring_is_not_inverted():
    with pytest.raises(Singular):
        inverse(np.zeros((2, 2)))


def test_stack_is_condensed_one_by_one():
    A = np.random.default_rng(1).normal(size=(4, 7, 5)) * 10.0 ** np.arange(-3, 4)[:, None]
    R = condensed(A, kept=2)
    each = [condensed(one, kept=2) for one in A]
    np.testing.assert_allclose(
        R.swapaxes(-1, -2) @ R, [one.T @ one for one in each], rtol=1e-10, atol=1e-12
    )
