"""A joint of blades that meet in one point as a linear spring in its plane.

Its deformation d = (x, y, φ) is the motion of the moving body, at the centre of the joint,
relative to the other body: x along the axis of symmetry, φ anticlockwise.
"""

from collections.abc import Sequence
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.section import second_moment

__all__ = ["blade_rows", "joint_stiffness", "stress_rows"]

Floats = NDArray[np.float64]


def blade_rows(*, l: float, p: float, angle: float) -> tuple[Floats, Floats, Floats]:
    """Return elongation, transverse motion and rotation of a blade's end per deformation.

    The end at p + l from the centre moves with the body: ``e = u·d``, ``w = n·d + (p + l) φ``.

    Parameters
    ----------
    l, p : float
        Length of the blade and distance from the centre to its inner end [m].
    angle : float
        Direction of the blade from the axis of symmetry [rad].

    Returns
    -------
    tuple of array, shape (3,)
        Rows that give e [m], w [m] and φ [rad] when multiplied with d.

    Examples
    --------
    >>> elongation, transverse, rotation = blade_rows(l=2.0, p=1.0, angle=0.0)
    >>> transverse.tolist()
    [-0.0, 1.0, 3.0]

    """
    elongation = np.array([cos(angle), sin(angle), 0.0])
    transverse = np.array([-sin(angle), cos(angle), p + l])
    return elongation, transverse, np.array([0.0, 0.0, 1.0])


def joint_stiffness(
    *, E: float, h: float, l: float, b: float, p: float, angles: Sequence[float]
) -> Floats:
    """Return the stiffness matrix of the joint in its plane.

    ``K = Σ EA/l e eᵀ + EI (12/l³ w wᵀ − 6/l² (w φᵀ + φ wᵀ) + 4/l φ φᵀ)`` over the blades.

    Parameters
    ----------
    E : float
        Young's modulus [Pa].
    h, l, b : float
        Thickness, length and width of a blade [m].
    p : float
        Distance from the centre to the inner ends [m].
    angles : sequence of float
        Directions of the blades from the axis of symmetry [rad].

    Returns
    -------
    array, shape (3, 3)
        Stiffness about the centre [N/m, N/rad, N·m/rad], symmetric.

    Notes
    -----
    Small deformation; shear left out. Its last entry is the rotational stiffness of
    :func:`flexcli.formulas.pivot.rotational_stiffness`.

    Examples
    --------
    >>> K = joint_stiffness(E=114e9, h=637e-6, l=17.5e-3, b=10e-3, p=2e-3, angles=(0.7, -0.7))
    >>> round(float(K[2, 2]), 2)
    15.51

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6.

    """
    bending, area = E * second_moment(b, h), h * b
    K = np.zeros((3, 3))
    for angle in angles:
        e, w, phi = blade_rows(l=l, p=p, angle=angle)
        mixed = np.outer(w, phi)
        K += E * area / l * np.outer(e, e)
        K += bending * (
            12.0 / l**3 * np.outer(w, w)
            - 6.0 / l**2 * (mixed + mixed.T)
            + 4.0 / l * np.outer(phi, phi)
        )
    return K


def stress_rows(
    *, E: float, h: float, l: float, p: float, angles: Sequence[float]
) -> tuple[Floats, Floats]:
    """Return axial stress of each blade and stress at each end and face, per deformation.

    ``σ = E e/l ± (h/2) M/I`` with ``M/EI = 2φ/l − 6w/l²`` at the inner and ``4φ/l − 6w/l²`` at
    the outer end.

    Parameters
    ----------
    E : float
        Young's modulus [Pa].
    h, l, p : float
        Thickness, length and distance from the centre to the inner end [m].
    angles : sequence of float
        Directions of the blades from the axis of symmetry [rad].

    Returns
    -------
    axial : array, shape (blades, 3)
        Rows of the axial stress [Pa per deformation].
    faces : array, shape (4 blades, 3)
        Rows of the stress at inner end, both faces, then outer end, both faces, blade by blade.

    Examples
    --------
    >>> axial, faces = stress_rows(E=1.0, h=1.0, l=1.0, p=0.0, angles=(0.0,))
    >>> faces[:, 2].tolist()
    [-2.0, 2.0, -1.0, 1.0]

    """
    axial, faces = [], []
    for angle in angles:
        e, w, phi = blade_rows(l=l, p=p, angle=angle)
        stretch = E / l * e
        axial.append(stretch)
        for slope in (2.0, 4.0):
            curvature = slope / l * phi - 6.0 / l**2 * w
            faces += [stretch + side * E * h / 2.0 * curvature for side in (1.0, -1.0)]
    return np.array(axial), np.array(faces)
