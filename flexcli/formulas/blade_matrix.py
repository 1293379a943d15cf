"""A blade's 6×6 stiffness and compliance about a point, from its six springs.

All is along the blade's own axes: x from start to end, y across the thickness, z across the width.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.blade_spring import BladeSprings
from flexcli.formulas.rigid_motion import motion_at

__all__ = ["blade_compliance", "blade_stiffness", "deformation_rows"]

Floats = NDArray[np.float64]


def deformation_rows(springs: BladeSprings, point: ArrayLike) -> Floats:
    """Return the deformation of the six springs per motion of the body at the blade's end.

    Parameters
    ----------
    springs : BladeSprings
        The springs.
    point : array_like, shape (..., 3)
        Where the motion of the body is stated, from the blade's start along its axes [m].

    Returns
    -------
    B : array, shape (..., 6, 6)
        Deformation = B d; K = Bᵀ diag(k) B [-, m].

    Examples
    --------
    >>> at = BladeSprings(np.ones(6), np.array(0.5), np.array(0.5))
    >>> (deformation_rows(at, (1.0, 0.0, 0.0)) @ [0, 0, 0, 0, 0, 1.0]).tolist()
    [0.0, -0.5, 0.0, 0.0, 0.0, 1.0]

    """
    start = -np.asarray(point, dtype=np.float64)
    forward = np.array([1.0, 0.0, 0.0])
    rows = motion_at(start + springs.across_thickness[..., np.newaxis] * forward)
    width = motion_at(start + springs.across_width[..., np.newaxis] * forward)
    rows[..., 2, :] = width[..., 2, :]
    return rows


def blade_stiffness(springs: BladeSprings, point: ArrayLike) -> Floats:
    """Return the stiffness of a blade, its start fixed, about a point of the body at its end.

    ``K = Bᵀ diag(k) B``.

    Parameters
    ----------
    springs : BladeSprings
        The blade.
    point : array_like, shape (..., 3)
        The point, from the blade's start along its axes; (l, 0, 0) is its end [m].

    Returns
    -------
    K : array, shape (..., 6, 6)
        Stiffness against (x, y, z, θ_x, θ_y, θ_z) along the blade's axes [N/m, N, N·m/rad].

    Notes
    -----
    Small deformation about the straight, unloaded blade.

    Examples
    --------
    >>> k = np.array([1.0, 16.0, 16.0, 4.0, 4.0, 4.0])
    >>> K = blade_stiffness(BladeSprings(k, np.array(0.5), np.array(0.5)), (1.0, 0.0, 0.0))
    >>> K[1, [1, 5]].tolist(), float(K[5, 5])
    ([16.0, -8.0], 8.0)

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    root = np.sqrt(springs.stiffness)[..., np.newaxis] * deformation_rows(springs, point)
    return np.asarray(root.swapaxes(-1, -2) @ root)


def blade_compliance(springs: BladeSprings, point: ArrayLike) -> Floats:
    """Return the compliance of a blade, its start fixed, at a point of the body at its end.

    ``C = B⁻¹ diag(1/k) B⁻ᵀ``, where B⁻¹ is known in closed form.

    Parameters
    ----------
    springs : BladeSprings
        The blade.
    point : array_like, shape (..., 3)
        The point, from the blade's start along its axes; (l, 0, 0) is its end [m].

    Returns
    -------
    C : array, shape (..., 6, 6)
        Compliance to (F_x, F_y, F_z, M_x, M_y, M_z) along the blade's axes
        [m/N, 1/N, rad/(N·m)].

    Notes
    -----
    Small deformation about the straight, unloaded blade.

    Examples
    --------
    >>> k = np.array([1.0, 12.0, 12.0, 1.0, 1.0, 1.0])
    >>> C = blade_compliance(BladeSprings(k, np.array(0.5), np.array(0.5)), (1.0, 0.0, 0.0))
    >>> round(float(C[1, 1]), 6), float(C[1, 5])
    (0.333333, 0.5)

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    # B = 1 + N with N from rotations to shifts alone, so that N² = 0 and B⁻¹ = 1 − N
    back = 2.0 * np.eye(6) - deformation_rows(springs, point)
    root = back / np.sqrt(springs.stiffness)[..., np.newaxis, :]
    return np.asarray(root @ root.swapaxes(-1, -2))
