"""Symmetric matrices that are not definite: solutions, and how many directions are negative."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["LARGE", "solved_and_counted"]

Floats = NDArray[np.float64]

LARGE = 300
"""Rows from which on one factorisation by LAPACK takes less than all eigenvalues, with its import:
a fifth of their time at 800."""

IMPORT = 4e8
"""Cubes of rows, all together, of whose eigenvalues take as long as LAPACK's import, a tenth of a
second: beyond, matrices of any size are factorised, which takes a fourth of the time."""


class _Spent:
    """What eigenvalues have taken in this process, in cubes of rows."""

    cubes = 0.0


def solved_and_counted(A: Floats, b: Floats, large: int = LARGE) -> tuple[Floats, int]:
    """Return x of ``A x = b`` and the number of negative eigenvalues of a symmetric matrix.

    By eigenvalues, of large or of many matrices by ``A = L D Lᵀ``, whose D has as many (Sylvester's
    law).

    Parameters
    ----------
    A : array, shape (n, n)
        Symmetric, not singular, its rows of order one.
    b : array, shape (n, m)
        Right-hand sides.
    large : int
        Rows from which on it is factorised in any case.

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
    if n < large and _Spent.cubes < IMPORT:
        _Spent.cubes += n**3
        return np.asarray(np.linalg.solve(A, b)), int(np.sum(np.linalg.eigvalsh(A) < 0.0))
    from scipy.linalg.lapack import dsytrf, dsytrf_lwork, dsytrs  # of large ones only

    if not np.isfinite(A).all():
        raise np.linalg.LinAlgError("a matrix that is not finite")
    room, _ = dsytrf_lwork(n, lower=1)
    factors, pivots, info = dsytrf(np.asfortranarray(A), lower=1, lwork=int(room))
    if info > 0:
        raise np.linalg.LinAlgError("singular matrix")
    x, _ = dsytrs(factors, pivots, b, lower=1)
    # pairs of rows that are taken together have one eigenvalue of either sign
    alone = pivots > 0
    negative = int(np.sum(np.diagonal(factors)[alone] < 0.0)) + int(np.sum(~alone)) // 2
    return np.asarray(x), negative
