"""A body on one joint, together with the bodies that the joint itself is drawn of."""

from flexcli.mechanics.layout import Body, Layout
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND, MOVING, Geometry, Sizes
from flexcli.parts.structure import OwnMotion, PlacedJoint, Structure, assemble, joined, turned

__all__ = [
    "body_on",
    "carried",
    "is_guided",
]


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
    thick: bool = False,
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
    thick : bool
        Whether blades shear and their sections have rotary inertia.

    Raises
    ------
    NotAvailable
        When the joint is not made of blades in a plane.

    """
    layout = geometry.blades_layout(elastic, sizes)
    both = body_on(geometry, layout, name, mass=mass, inertia=inertia, offset=offset)
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
        thick=thick,
        held=[(name, 2)] if is_guided(geometry) else [],
    )


def body_on(
    geometry: Geometry, layout: Layout, name: str, *, mass: float, inertia: float, offset: float
) -> Body:
    """Return a body with the moving body of a joint that it is fixed to, in the joint's axes."""
    moving = layout.body(MOVING)
    centre = geometry.payload_point(moving.point)
    com = centre[0] + offset, centre[1]
    own = moving._replace(com=moving.com if moving.mass else com)
    return joined(name, centre, [own, Body(name, centre, mass, inertia, com)])


def is_guided(geometry: Geometry) -> bool:
    """Return whether its blades, or what drives it, keep the body from turning."""
    return geometry.is_guided or geometry.keeps_level
