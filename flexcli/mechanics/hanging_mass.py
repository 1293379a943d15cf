"""The mass that a body of a layout seems to carry when everything hangs in an acceleration."""

from math import hypot

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.blade_spring import SHEAR_FACTOR, Warping
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.spring_rows import Place, spring_rows
from flexcli.numerics.collocation import gauss_nodes

__all__ = ["blade_masses", "hanging_mass"]

Floats = NDArray[np.float64]

_NODES = 24
"""Gauss nodes on a piece of a blade for its volume."""


def hanging_mass(
    layout: Layout,
    body: str,
    direction: tuple[float, float, float],
    density: float,
    *,
    is_guided: bool,
    warping: Warping,
) -> float:
    """Return the mass which, alone at a body's point, makes the sag that all masses make.

    ``m = Σ C_b m_i / C_bb`` with the compliance C along the axis from every mass to the point.

    Parameters
    ----------
    layout : Layout
        The mechanism in its plane; its bodies have masses.
    body : str
        The body whose point sags.
    direction : tuple of float
        Of the acceleration and of the sag that is meant, a unit vector.
    density : float
        Of the blades [kg/m³]; 0 leaves their mass out.
    is_guided : bool
        Whether the body cannot turn in the plane.
    warping : {"free", "restrained"}
        Whether the ends of the blades may warp in torsion.

    Returns
    -------
    float
        Effective mass [kg].

    Raises
    ------
    SolveError
        When the layout has no shear modulus, or a body hangs on nothing.

    Notes
    -----
    Small motion from rest. A blade's weight acts as on a uniform beam: half at each end with the
    moments of a beam clamped at both.

    """
    if layout.G is None:
        raise SolveError(
            "no-shear-modulus",
            "blades in torsion and shear need the shear modulus of their material",
            "state the shear modulus or Poisson's ratio",
        )
    places: dict[str, Place] = {b.name: (*b.point, 0.0) for b in layout.bodies}
    at = {name: 6 * index for index, name in enumerate(places)}
    K = np.zeros((6 * len(places), 6 * len(places)))
    for ends in spring_rows(layout, places, shear_factor=SHEAR_FACTOR, warping=warping):
        for one, rows in ends.items():
            for other, columns in ends.items():
                here = np.s_[at[one] : at[one] + 6, at[other] : at[other] + 6]
                K[here] += rows.T @ columns
    pull, unit = np.zeros(K.shape[0]), np.array(direction)

    def add(name: str, place: Place, force: Floats, moment: Floats) -> None:
        arm = np.array(place) - np.array(places[name])
        first = at[name]
        pull[first : first + 3] += force
        pull[first + 3 : first + 6] += np.cross(arm, force) + moment

    for part in layout.bodies:
        add(part.name, (*part.com, 0.0), part.mass * unit, np.zeros(3))
    for blade, mass in zip(layout.blades, blade_masses(layout, density), strict=True):
        along = np.array([*blade.end, 0.0]) - np.array([*blade.start, 0.0])
        moment = mass / 12.0 * np.cross(along, unit)
        for name, end, sign in ((blade.first, blade.start, 1.0), (blade.second, blade.end, -1.0)):
            if name in at:
                add(name, (*end, blade.z), mass / 2.0 * unit, sign * moment)
    own = np.zeros_like(pull)
    own[at[body] : at[body] + 3] = unit
    free = np.ones(K.shape[0], dtype=bool)
    free[at[body] + 5] = not is_guided
    K, pull, own = K[np.ix_(free, free)], pull[free], own[free]
    diagonal = np.diagonal(K)
    if not (diagonal > 0.0).all():
        raise SolveError("no-stiffness", "a body hangs on nothing", "hold it by a blade")
    scale = 1.0 / np.sqrt(diagonal)
    found = np.linalg.solve(
        K * np.outer(scale, scale), np.stack([pull, own], axis=-1) * scale[:, None]
    )
    sag, compliance = (own * scale) @ found
    return float(sag / compliance)


def blade_masses(layout: Layout, density: float) -> list[float]:
    """Return the mass of the flexible parts of every blade [kg]."""
    u, weight = gauss_nodes(_NODES)
    found = []
    for blade in layout.blades:
        l = hypot(blade.end[0] - blade.start[0], blade.end[1] - blade.start[1])
        volume = sum(
            float(np.sum(np.ravel(piece.thickness(u) * piece.slope(u)) * weight)) * blade.b
            for piece in blade.profile.pieces(l)
        )
        found.append(density * volume)
    return found
