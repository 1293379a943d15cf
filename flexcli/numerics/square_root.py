"""Quadratic forms K = AᵀA kept as their factor A, whose condition is the root of K's.

The factor of a sum of springs is a stack of rows, √k times the row that gives the spring's
deformation: nothing is added up, so that soft directions next to stiff ones keep their digits.
"""

import numpy as np
from numpy.typing import NDArray

__all__ = ["NO_RESISTANCE", "Singular", "triangle"]

Floats = NDArray[np.float64]

NO_RESISTANCE = 1e-13
"""Relative pivot of a column below which its coordinate has no stiffness but rounding."""


class Singular(ArithmeticError):
    """A form without stiffness along some combination of its coordinates."""


def triangle(A: Floats) -> tuple[Floats, Floats, Floats]:
    """Return Q, R and the scale of the columns with A = Q R diag(scale).

    Parameters
    ----------
    A : array, shape (rows, n)
        Factor of the form AᵀA.

    Returns
    -------
    Q, R : array, shape (rows, n) and (n, n)
        Orthonormal columns, upper triangle.
    scale : array, shape (n,)
        Length of each column of A.

    Raises
    ------
    Singular
        When the form has no resistance along some combination of coordinates.

    Examples
    --------
    >>> Q, R, scale = triangle(np.array([[3.0], [4.0]]))
    >>> float(scale[0]), round(abs(float(R[0, 0])), 12)
    (5.0, 1.0)

    References
    ----------
    Golub & Van Loan (2013), Matrix Computations, section 5.3; rows sorted by size as in
    Cox & Higham (1998), Stability of Householder QR for weighted least squares.

    """
    scale = np.sqrt(np.sum(A**2, axis=0))
    if A.shape[0] < A.shape[1] or not (scale > 0.0).all():
        raise Singular("a coordinate without any resistance")
    order = np.argsort(-np.abs(A / scale).max(axis=1))
    Q, R = np.linalg.qr((A / scale)[order])
    if not (np.abs(np.diagonal(R)) > NO_RESISTANCE).all():
        raise Singular("a combination of coordinates without resistance")
    back = np.empty_like(Q)
    back[order] = Q
    return back, R, scale
