"""The blades and supports of a layout as rows √k · deformation, per small motion of its bodies."""

from collections.abc import Iterator
from typing import TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.blade_spring import Warping, blade_springs, deformation_rows
from flexcli.formulas.rigid_motion import axes_about_z, motion_along, motion_at
from flexcli.mechanics.layout import Blade, Layout, Number, Support

__all__ = ["Place", "spring_rows"]

Floats = NDArray[np.float64]
Place: TypeAlias = tuple[Number, Number, Number]
"""Coordinates (x, y, z) [m]."""


def spring_rows(
    layout: Layout, places: dict[str, Place], *, shear_factor: float, warping: Warping
) -> Iterator[dict[str, Floats]]:
    """Yield the rows √k · deformation of each blade and support.

    Parameters
    ----------
    layout : Layout
        The mechanism.
    places : dict
        Point of each body at which its motion is stated (x, y, z) [m]; other bodies are fixed.
    shear_factor : float
        κ of the blades' section in shear [-].
    warping : {"free", "restrained"}
        Whether the ends of the blades may warp in torsion.

    Yields
    ------
    dict of array, shape (..., springs, 6)
        For each moving body on the blade or support, its rows A: K = AᵀA.

    """
    for blade in layout.blades:
        yield _blade_rows(layout, blade, places, shear_factor=shear_factor, warping=warping)
    for support in layout.supports:
        if support.body in places:
            yield {support.body: _support_rows(support, places[support.body])}


def _blade_rows(
    layout: Layout,
    blade: Blade,
    places: dict[str, Place],
    *,
    shear_factor: float,
    warping: Warping,
) -> dict[str, Floats]:
    """Return the rows of a blade for its two bodies; the ground has none."""
    start = _vector((*blade.start, blade.z))
    along = _vector((*blade.end, blade.z)) - start
    l = np.hypot(along[..., 0], along[..., 1])
    axes = axes_about_z(np.arctan2(along[..., 1], along[..., 0]))
    springs = blade_springs(
        profile=blade.profile,
        l=l,
        b=blade.b,
        E=layout.E * blade.stiffer,
        G=None if layout.G is None else layout.G * blade.stiffer,
        shear_factor=shear_factor,
        warping=warping,
    )
    roots = np.sqrt(springs.stiffness)[..., np.newaxis]
    rows = {}
    for name, side in ((blade.first, -1.0), (blade.second, 1.0)):
        if name in places:
            point = (axes @ (_vector(places[name]) - start)[..., np.newaxis])[..., 0]
            rows[name] = side * roots * deformation_rows(springs, point) @ motion_along(axes)
    return rows


def _support_rows(support: Support, place: Place) -> Floats:
    """Return the rows of springs from the ground: along x, along y, about z."""
    at = motion_at(_vector((*support.point, 0.0)) - _vector(place))
    roots = np.sqrt(_vector(support.stiffness))[..., np.newaxis]
    return np.asarray(roots * at[..., (0, 1, 5), :])


def _vector(coordinates: Place) -> Floats:
    """Return three numbers or arrays as vectors on a trailing axis."""
    numbers = [np.asarray(coordinate, dtype=np.float64) for coordinate in coordinates]
    return np.stack(np.broadcast_arrays(*numbers), axis=-1)
