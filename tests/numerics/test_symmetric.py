"""Solutions and negative directions of symmetric matrices that are not definite."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from flexcli.numerics.symmetric import solved_and_counted


@given(n=st.integers(1, 40), seed=st.integers(0, 2**32 - 1), hollow=st.booleans())
def test_a_factorisation_counts_and_solves_as_eigenvalues_do(n, seed, hollow):
    rng = np.random.default_rng(seed)
    A = rng.normal(size=(n, n))
    A = A + A.T + np.diag(rng.choice([-1.0, 1.0], n))
    if hollow:  # of constraints: nothing on the diagonal, so that rows are taken in pairs
        A[: n // 2, : n // 2] = 0.0
    eigenvalues = np.linalg.eigvalsh(A)
    if np.abs(eigenvalues).min() < 1e-6:
        return
    b = rng.normal(size=(n, 3))
    for large in (1, n + 1):
        x, negative = solved_and_counted(A, b, large)
        assert negative == np.sum(eigenvalues < 0.0)
        assert A @ x == pytest.approx(b, abs=1e-8)


@pytest.mark.parametrize("large", [1, 9])
@pytest.mark.parametrize("number", [0.0, np.nan])
def test_a_matrix_that_is_singular_or_not_finite_is_said_to_be(large, number):
    with pytest.raises(np.linalg.LinAlgError):
        solved_and_counted(np.full((3, 3), number), np.ones((3, 1)), large)
