"""Support compliance of a planar layout at rest, by a route that the package does not take.

The blades are linear beams in space between rigid bodies; every other body of the layout is free
and unloaded. Blades are kept as rows √k · deformation, and the other bodies are condensed on
these rows, so that a thin blade's soft directions keep their digits beside its stiff ones.
"""

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.errors import SolveError
from flexcli.formulas.blade_spring import SHEAR_FACTOR, Warping
from flexcli.formulas.rigid_motion import motion_along
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.spring_rows import Place, spring_rows
from flexcli.numerics.square_root import NO_RESISTANCE, Singular

Floats = NDArray[np.float64]
AXES = ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
"""Those of the layout."""


def support_compliance(
    layout: Layout,
    body: str,
    point: Place,
    axes: ArrayLike = AXES,
    *,
    shear_factor: float = SHEAR_FACTOR,
    warping: Warping = "free",
) -> Floats:
    """Return the compliance of a body at a point, all other bodies free.

    Parameters
    ----------
    layout : Layout
        The mechanism in its plane z = 0, in the pose in which nothing is strained.
    body : str
        The body that is moved.
    point : tuple of float or array, shape (designs,)
        Where its motion is stated (x, y, z) [m].
    axes : array_like, shape (..., 3, 3)
        Directions in which it is stated, orthonormal rows [-].
    shear_factor : float
        κ of the blades' section in shear, ∞ for Euler's blades without shear [-].
    warping : {"free", "restrained"}
        Whether the ends of the blades may warp in torsion.

    Returns
    -------
    C : array, shape (..., 6, 6)
        Compliance to (F_x, F_y, F_z, M_x, M_y, M_z) [m/N, 1/N, rad/(N·m)], symmetric positive
        definite.

    Notes
    -----
    Small motion from rest; loads and gravity of the layout play no part. It is found without the
    stiffness: where thin blades stand askew to the axes, the products in that have lost digits
    that are here.

    Raises
    ------
    SolveError
        When the layout has no shear modulus, or a body has a freedom without any spring.
    ValueError
        When no body has that name, or the axes are not orthonormal.

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6 and chapter 9.

    """
    R = _factor(layout, body, point, axes, shear_factor=shear_factor, warping=warping)
    try:
        return inverse(R)
    except Singular as error:
        raise SolveError(
            "no-stiffness", f"{body} can move without resistance", "hold it by a blade or a spring"
        ) from error


def _factor(
    layout: Layout,
    body: str,
    point: Place,
    axes: ArrayLike,
    *,
    shear_factor: float,
    warping: Warping,
) -> Floats:
    """Return R with K = RᵀR: rows of all springs, the other bodies condensed."""
    places: dict[str, Place] = {b.name: (*b.point, 0.0) for b in layout.bodies if b.name != body}
    if len(places) == len(layout.bodies):
        raise ValueError(f"no body is named {body}")
    if layout.G is None:
        raise SolveError(
            "no-shear-modulus",
            "blades in torsion and shear need the shear modulus of their material",
            "state the shear modulus or Poisson's ratio",
        )
    places[body] = point
    turned = motion_along(axes).swapaxes(-1, -2)
    rows = [np.zeros((0, 6 * len(places)))]
    for ends in spring_rows(layout, places, shear_factor=shear_factor, warping=warping):
        per_body = [ends.get(name, np.zeros((6, 6))) for name in places]
        per_body[-1] = per_body[-1] @ turned
        rows.append(np.concatenate(_alike(per_body), axis=-1))
    try:
        return condensed(np.concatenate(_alike(rows), axis=-2), kept=6)
    except Singular as error:
        raise SolveError(
            "no-stiffness",
            f"a body besides {body} can move without resistance",
            "hold every body by a blade or a spring",
        ) from error


def _alike(matrices: list[Floats]) -> list[Floats]:
    """Return matrices with the batch shape of all of them."""
    batch = np.broadcast_shapes(*(matrix.shape[:-2] for matrix in matrices))
    return [np.broadcast_to(matrix, (*batch, *matrix.shape[-2:])) for matrix in matrices]


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
