"""A body on one joint, together with the bodies that the joint itself is drawn of."""

from math import hypot

import numpy as np

from flexcli.mechanics.layout import Body, Layout, Point
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND, MOVING, Geometry, Sizes
from flexcli.parts.geometries.hinged import HingedPivot, HingedStage
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.linkage import LinkageGeometry
from flexcli.parts.geometries.single_blade import MomentBlade
from flexcli.parts.structure import OwnMotion, PlacedJoint, Structure, assemble, joined, turned

__all__ = [
    "carried",
    "has_limbs",
    "has_masses",
    "is_guided",
    "joint_layout",
]

PIECE = np.array([-1.0, 1.0])
"""Both ends of a piece of a profile."""

ROUNDING = 1e-9
"""Share of a blade's length that no piece covers, from which a part of it is rigid."""


def carried(
    geometry: Geometry,
    elastic: Elastic,
    sizes: Sizes,
    *,
    name: str = "payload",
    joint: str = "joint",
    mass: float = 0.0,
    inertia: float = 0.0,
    offset: float = 0.0,
    density: float = 0.0,
) -> Structure:
    """Return a rigid body fixed to the moving body of a joint, as a structure.

    Parameters
    ----------
    geometry : Geometry
        The joint; bodies that a layout draws with mass move as well.
    elastic : Elastic
        Of its blades.
    sizes : Sizes
        The joint's sizes.
    name, joint : str
        Of the body and of the joint, in the names of the outputs.
    mass, inertia : float
        Of the body [kg], about its centre of mass [kg·m²].
    offset : float
        Of its centre of mass beyond the joint's centre, along the blades [m].
    density : float
        Of the blades [kg/m³]; 0 leaves their mass out.

    Raises
    ------
    NotAvailable
        When the joint is not made of blades in a plane.

    """
    layout = joint_layout(geometry, elastic, sizes)
    moving = layout.body(MOVING)
    centre = _centre(geometry, moving)
    com = centre[0] + offset, centre[1]
    own = moving._replace(com=moving.com if moving.mass else com)
    both = joined(name, centre, [own, Body(name, centre, mass, inertia, com)])
    turn = -geometry.axes
    body = both._replace(point=turned(both.point, turn), com=turned(both.com, turn))
    stroke = turned((0.0, 1.0), turn)
    rotates = geometry.motion == "rotation"
    return assemble(
        [body],
        [PlacedJoint(joint, GROUND, name, (0.0, 0.0), turn)],
        layout,
        OwnMotion(name, (0.0, 0.0, 1.0), "rotation")
        if rotates
        else OwnMotion(name, (*stroke, 0.0), "travel"),
        density=density,
        held=[(name, 2)] if is_guided(geometry) else [],
    )


def joint_layout(geometry: Geometry, elastic: Elastic, sizes: Sizes) -> Layout:
    """Return the blades of a joint; the distance between those that guide plays no part."""
    if isinstance(geometry, LeafSpringStage) and geometry.spacing is None:
        geometry = geometry.model_copy(update={"spacing": float(sizes.l)})
    return geometry.layout(elastic, sizes)


def has_masses(geometry: Geometry, elastic: Elastic, sizes: Sizes) -> bool:
    """Return whether the joint draws bodies that have mass or inertia themselves."""
    if geometry.closed_forms:
        return False
    return any(body.mass or body.inertia for body in geometry.layout(elastic, sizes).bodies)


def has_limbs(geometry: Geometry, elastic: Elastic, sizes: Sizes) -> bool:
    """Return whether rigid parts between hinges move that have no stated mass."""
    if isinstance(geometry, HingedPivot | HingedStage | LinkageGeometry):
        return True
    for blade in joint_layout(geometry, elastic, sizes).blades:
        l = hypot(*np.subtract(blade.end, blade.start))
        ends = [np.ravel(piece.position(PIECE)) for piece in blade.profile.pieces(l)]
        if sum(float(end - start) for start, end in ends) < (1.0 - ROUNDING) * l:
            return True
    return False


def is_guided(geometry: Geometry) -> bool:
    """Return whether its blades, or what drives it, keep the body from turning."""
    x_y_phi = geometry.held(0.0)
    held = geometry.motion == "translation" and x_y_phi[2] is not None
    return held or isinstance(geometry, LeafSpringStage)


def _centre(geometry: Geometry, moving: Body) -> Point:
    """Return the joint's centre, where a payload has its centre of mass: it only turns there."""
    return (0.0, 0.0) if isinstance(geometry, MomentBlade) else moving.point
