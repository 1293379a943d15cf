"""Quadratic forms K = AᵀA kept as their factor A, whose condition is the root of K's.

The factor of a sum of springs is a stack of rows, √k times the row that gives the spring's
deformation: nothing is added up, so that soft directions next to stiff ones keep their digits.
"""

import numpy as np
from numpy.typing import NDArray

__all__ = ["Singular", "condensed", "inverse", "triangle"]

Floats = NDArray[np.float64]

NO_RESISTANCE = 1e-13
"""Relative pivot of a column below which its coordinate has no stiffness but rounding."""


class Singular(ArithmeticError):
    """A form without stiffness along some combination of its coordinates."""


def condensed(A: Floats, kept: int) -> Floats:
    """Return the factor of AᵀA with all but its last coordinates minimised over.

    ``K = K_kk − K_ki K_ii⁻¹ K_ik`` is the lower right block of R in A = QR, squared.

    Parameters
    ----------
    A : array, shape (..., rows, n)
        Factor; the coordinates to be kept come last.
    kept : int
        How many are kept.

    Returns
    -------
    R : array, shape (..., kept, kept)
        Upper triangular factor of the condensed form.

    Raises
    ------
    Singular
        When the form has no resistance along the other coordinates, so that no minimum is unique.

    Examples
    --------
    >>> R = condensed(np.array([[1.0, 0.0], [-1.0, 1.0]]), kept=1)
    >>> round(float(R[0, 0] ** 2), 12)
    0.5

    References
    ----------
    Golub & Van Loan (2013), Matrix Computations, section 5.3; rows sorted by size as in
    Cox & Higham (1998), Stability of Householder QR for weighted least squares.

    """
    n = A.shape[-1]
    scale = np.sqrt(np.sum(A**2, axis=-2, keepdims=True))
    if not (scale[..., : n - kept] > 0.0).all():
        raise Singular("a coordinate without any resistance")
    scaled = A / np.where(scale > 0.0, scale, 1.0)
    order = np.argsort(-np.abs(scaled).max(axis=-1), axis=-1)
    rows = np.take_along_axis(scaled, order[..., np.newaxis], axis=-2)
    missing = max(n - rows.shape[-2], 0)
    rows = np.pad(rows, [(0, 0)] * (rows.ndim - 2) + [(0, missing), (0, 0)])
    R = np.asarray(np.linalg.qr(rows, mode="r"))
    _require_pivots(R[..., : n - kept, : n - kept])
    return np.asarray(R[..., n - kept :, n - kept :] * scale[..., n - kept :])


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
    As of :func:`condensed`.

    """
    scale = np.sqrt(np.sum(A**2, axis=0))
    if A.shape[0] < A.shape[1] or not (scale > 0.0).all():
        raise Singular("a coordinate without any resistance")
    order = np.argsort(-np.abs(A / scale).max(axis=1))
    Q, R = np.linalg.qr((A / scale)[order])
    _require_pivots(R)
    back = np.empty_like(Q)
    back[order] = Q
    return back, R, scale


def inverse(R: Floats) -> Floats:
    """Return the inverse of the form RᵀR.

    Parameters
    ----------
    R : array, shape (..., n, n)
        Upper triangular factor.

    Returns
    -------
    C : array, shape (..., n, n)
        (RᵀR)⁻¹, symmetric.

    Raises
    ------
    Singular
        When the form has no resistance along some combination of coordinates.

    Examples
    --------
    >>> inverse(np.array([[2.0]])).tolist()
    [[0.25]]

    """
    scale = np.sqrt(np.sum(R**2, axis=-2, keepdims=True))
    if not (scale > 0.0).all():
        raise Singular("a coordinate without any resistance")
    _require_pivots(R / scale)
    root = np.linalg.inv(R / scale) / scale.swapaxes(-1, -2)
    return np.asarray(root @ root.swapaxes(-1, -2))


def _require_pivots(R: Floats) -> None:
    """Refuse a triangle with a negligible pivot in a column of unit length."""
    if not (np.abs(np.diagonal(R, axis1=-2, axis2=-1)) > NO_RESISTANCE).all():
        raise Singular("a combination of coordinates without resistance")
