"""A linkage as it is drawn at rest: flexures, pins and ideal stages between its links."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.drawn_layout import Turn, drawn_blade, drawn_bodies, numbers, place_of, turning
from flexcli.mechanics.layout import Blade, Layout
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.parts.geometries.linkage import LinkageGeometry, LinkageJoint
from flexcli.parts.requirements import Ask
from flexcli.results.drawing import XY, Drawing, DrawnBody, DrawnCut, DrawnGuide

__all__ = ["as_in_spec", "linkage_drawing"]

Floats = NDArray[np.float64]

BESIDE = 0.3
"""Distance of an ideal stage from the joints of its link, over what all joints span, if unsaid."""


def as_in_spec(geometry: LinkageGeometry) -> Turn:
    """Return what takes places of a linkage's layout to where the spec has them."""
    pose = np.array(geometry.pose)
    return lambda places: places @ pose


def linkage_drawing(
    geometry: LinkageGeometry,
    ask: Ask,
    given: tuple[tuple[str, float], ...],
    notes: tuple[str, ...],
    cut: DrawnCut | None,
) -> Drawing:
    """Return a linkage of a case at rest, where the spec has it."""
    layout, as_is = geometry.as_written(ask.material.elastic, ask.sizes), turning(0.0)
    bodies = {body.name: body for body in drawn_bodies(layout, as_is, MOVING)}
    for name in (GROUND, *geometry.rigid.moving):
        point = geometry.joints[geometry.input].at
        bodies.setdefault(name, DrawnBody(name, (), (), (), point, is_ground=name == GROUND))
    for joint in geometry.joints.values():
        if joint.flexure is None and joint.along is None:
            for link in joint.links:
                name = GROUND if link == geometry.ground else link
                way = (0.0, -1.0) if link == geometry.ground else (0.0, 0.0)
                bodies[name] = _with_clamp(bodies[name], joint.at, way)
    guides = []
    for name, joint in geometry.joints.items():
        if joint.along is not None:
            way = np.array(joint.along) / np.hypot(*joint.along)
            at = _place(geometry, joint, way, bodies)
            on_ground = geometry.ground in joint.links
            ideal = joint.flexure is None
            guides.append(DrawnGuide(name, at, place_of(way), ideal, on_ground))
            if ideal:
                link = _moving_link(geometry, joint)
                for side in (1.0, -1.0):
                    bodies[link] = _with_clamp(bodies[link], at, place_of(side * way))
    if any(guide.is_ideal for guide in guides):
        notes = (*notes, "an ideal stage is drawn as a block between rails, beside its link")
    pivots = [(name, joint.at) for name, joint in geometry.joints.items() if joint.along is None]
    return Drawing(
        kind=geometry.name,
        motion=geometry.motion,
        blades=tuple(drawn_blade(blade, as_is) for blade in layout.blades),
        bodies=tuple(body for body in bodies.values() if body.clamps),
        sizes=given,
        centre=geometry.joints[geometry.input].at,
        case=ask.scene.case,
        unit=geometry.travel_unit,
        pivots=tuple(pivots),
        joint_size=max((_span(joint) for joint in _by_joint(layout, geometry)), default=None),
        guides=tuple(guides),
        notes=notes,
        cut=cut,
    )


def _by_joint(layout: Layout, geometry: LinkageGeometry) -> Iterator[list[Blade]]:
    """Yield the blades of each flexure."""
    for name, _ in geometry.flexures():
        yield [blade for blade in layout.blades if blade.name.startswith(f"{name} ")]


def _span(blades: Sequence[Blade]) -> float:
    """Return the larger side of what blades span [m]."""
    ends = np.array([numbers(end) for blade in blades for end in (blade.start, blade.end)])
    return float(np.ptp(ends, axis=0).max())


def _with_clamp(body: DrawnBody, at: XY, way: XY) -> DrawnBody:
    """Return a body that reaches to a place besides."""
    return replace(
        body, clamps=(*body.clamps, at), ways=(*body.ways, way), depths=(*body.depths, 0.0)
    )


def _place(
    geometry: LinkageGeometry, joint: LinkageJoint, way: Floats, bodies: dict[str, DrawnBody]
) -> XY:
    """Return where a stage is drawn: as stated, else beside its link, where its clamps are."""
    link = _moving_link(geometry, joint)
    own = list(_joints(geometry, link))
    if joint.flexure is not None or "at" in joint.model_fields_set or not own:
        return joint.at
    every = np.array([each.at for each in geometry.joints.values()])
    middle = np.mean(own, axis=0)
    away = [float((np.array(clamp) - middle) @ way) for clamp in bodies[link].clamps]
    side = sum(away) or float((middle - np.mean(every, axis=0)) @ way)
    reach = max(abs(each) for each in (0.0, *away))
    far = reach + BESIDE * float(np.ptp(every, axis=0).max())
    return place_of(middle + (far if side >= 0.0 else -far) * way)


def _moving_link(geometry: LinkageGeometry, joint: LinkageJoint) -> str:
    """Return the link of a joint that is not the ground, the first of two."""
    return next(link for link in joint.links if link != geometry.ground)


def _joints(geometry: LinkageGeometry, link: str) -> Iterator[XY]:
    """Yield where the pivots and the flexures of a link are."""
    for joint in geometry.joints.values():
        if link in joint.links and (joint.along is None or joint.flexure is not None):
            yield joint.at
