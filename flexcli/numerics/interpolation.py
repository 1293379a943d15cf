"""The polynomial through known values."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["lagrange"]

Floats = NDArray[np.float64]


def lagrange(known: Floats, at: Floats) -> Floats:
    """Return the matrix that takes values at known places to those of their polynomial.

    Parameters
    ----------
    known, at : array
        Places that differ from each other, and places to interpolate to.

    Returns
    -------
    array, shape (at, known)
        ``L_ij = Π_{k≠j} (a_i − x_k)/(x_j − x_k)`` [-].

    Examples
    --------
    >>> x = np.array([0.0, 0.5, 1.0])
    >>> bool(np.allclose(lagrange(x, np.array([2.0, 0.5])) @ x**2, [4.0, 0.25]))
    True

    """
    apart = known[:, None] - known[None, :] + np.eye(len(known))
    to = np.broadcast_to(at[:, None, None] - known[None, None, :], (len(at), *apart.shape)).copy()
    j = np.arange(len(known))
    to[:, j, j] = 1.0
    return np.asarray(np.prod(to / apart, axis=-1))
