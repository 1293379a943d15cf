"""Symmetric matrices that are not definite: solutions, and how many directions are negative."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["LARGE", "solved_and_counted"]

Floats = NDArray[np.float64]

LARGE = 200
"""Rows from which on one factorisation by LAPACK takes less than all eigenvalues: a third of their
time at 250, a fifth at 800. Its import takes a tenth of a second, which fewer rows hardly save."""


def solved_and_counted(A: Floats, b: Floats, large: int = LARGE) -> tuple[Floats, int]:
    """Return x of ``A x = b`` and the number of negative eigenvalues of a symmetric matrix.

    By eigenvalues, of large matrices by ``A = L D Lᵀ``, whose D has as many (Sylvester's law).

    Parameters
    ----------
    A : array, shape (n, n)
        Symmetric, not singular, its rows of order one.
    b : array, shape (n, m)
        Right-hand sides.
    large : int
        Rows from which on it is factorised.

    Returns
    -------
    x : array, shape (n, m)
        Solutions.
    negative : int
        How many eigenvalues are below 0.

    Raises
    ------
    numpy.linalg.LinAlgError
        When A is singular or not finite.

    Examples
    --------
    >>> x, negative = solved_and_counted(np.diag([2.0, -4.0]), np.ones((2, 1)))
    >>> x.ravel().tolist(), negative
    ([0.5, -0.25], 1)

    References
    ----------
    Bunch & Kaufman (1977), Some stable methods for calculating inertia and solving symmetric
    linear systems.

    """
    n = A.shape[0]
    if n < large:
        return np.asarray(np.linalg.solve(A, b)), int(np.sum(np.linalg.eigvalsh(A) < 0.0))
    from scipy.linalg.lapack import dsytrf, dsytrf_lwork, dsytrs  # of large ones only

    if not np.isfinite(A).all():
        raise np.linalg.LinAlgError("a matrix that is not finite")
    room, _ = dsytrf_lwork(n, lower=1)
    factors, pivots, info = dsytrf(A.T, lower=1, lwork=int(room))
    if info > 0:
        raise np.linalg.LinAlgError("singular matrix")
    x, _ = dsytrs(factors, pivots, b, lower=1)
    # pairs of rows that are taken together have one eigenvalue of either sign
    alone = pivots > 0
    negative = int(np.sum(np.diagonal(factors)[alone] < 0.0)) + int(np.sum(~alone)) // 2
    return np.asarray(x), negative
