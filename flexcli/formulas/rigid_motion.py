"""Small motion of a rigid body in space, seen from another point or along other axes.

A motion is d = (x, y, z, θ_x, θ_y, θ_z) of the point of the body at which it is stated [m, rad];
the load that does work on it is (F_x, F_y, F_z, M_x, M_y, M_z) [N, N·m].
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = [
    "axes_about_z",
    "motion_along",
    "motion_at",
]

Floats = NDArray[np.float64]


def motion_at(offset: ArrayLike) -> Floats:
    """Return the matrix that gives the motion of another point of the same rigid body.

    ``u' = u + θ × r``, ``θ' = θ``.

    Parameters
    ----------
    offset : array_like, shape (..., 3)
        Vector r from the point of the motion to the other point [m].

    Returns
    -------
    X : array, shape (..., 6, 6)
        d' = X d; its transpose brings a load back, f = Xᵀ f' [-, m].

    Examples
    --------
    >>> (motion_at([2.0, 0.0, 0.0]) @ [0, 0, 0, 0, 0, 0.1]).tolist()
    [0.0, 0.2, 0.0, 0.0, 0.0, 0.1]

    References
    ----------
    Murray, Li & Sastry (1994), A Mathematical Introduction to Robotic Manipulation, chapter 2.

    """
    r = np.asarray(offset, dtype=np.float64)
    X = np.empty((*r.shape[:-1], 6, 6))
    X[...] = np.eye(6)
    for row, turn, along in ((0, 4, 2), (1, 5, 0), (2, 3, 1)):
        X[..., row, turn] = r[..., along]
        # the mirror image of the row: (θ × r) has each pair of axes twice, with opposite signs
        X[..., along, turn] = -r[..., row]
    return X


def motion_along(axes: ArrayLike) -> Floats:
    """Return the matrix that gives the same motion along other axes.

    Parameters
    ----------
    axes : array_like, shape (..., 3, 3)
        The new axes as orthonormal rows, in the old ones [-].

    Returns
    -------
    R : array, shape (..., 6, 6)
        d' = R d, orthogonal [-].

    Raises
    ------
    ValueError
        When the rows are not orthonormal, or make a left-handed frame.

    Examples
    --------
    >>> (motion_along([[0, 1, 0], [-1, 0, 0], [0, 0, 1]]) @ [1, 0, 0, 0, 0, 2]).tolist()
    [0.0, -1.0, 0.0, 0.0, 0.0, 2.0]

    """
    rows = np.asarray(axes, dtype=np.float64)
    product = rows @ rows.swapaxes(-1, -2)
    is_orthonormal = bool((np.abs(product - np.eye(3)) <= 1e-9).all())
    if not is_orthonormal or (np.linalg.det(rows) < 0).any():
        raise ValueError("axes must be three orthonormal rows of a right-handed frame")
    R = np.zeros((*rows.shape[:-2], 6, 6))
    R[..., :3, :3] = R[..., 3:, 3:] = rows
    return R


def axes_about_z(angle: ArrayLike) -> Floats:
    """Return the axes turned by an angle about z, as rows.

    Parameters
    ----------
    angle : array_like
        Angle from x towards y [rad].

    Returns
    -------
    axes : array, shape (..., 3, 3)
        Orthonormal rows [-].

    Examples
    --------
    >>> axes_about_z(0.0).tolist()
    [[1.0, 0.0, 0.0], [-0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]

    """
    c, s = np.cos(angle), np.sin(angle)
    axes = np.zeros((*np.shape(angle), 3, 3))
    axes[..., 0, 0], axes[..., 0, 1] = c, s
    axes[..., 1, 0], axes[..., 1, 1] = -s, c
    axes[..., 2, 2] = 1.0
    return axes
