"""Whether loads in the plane of a joint may buckle it out of it, by a cheap bound from below."""

from collections.abc import Iterator
from dataclasses import replace
from math import inf

import numpy as np

from flexcli.engine.joint_models.holds import FREE, hold_of
from flexcli.mechanics.lateral_bound import lateral_bound
from flexcli.mechanics.layout import Layout, Load
from flexcli.numerics.rows import Number, number
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask
from flexcli.parts.scene import IN_PLANE

__all__ = ["is_held_by_blades", "lateral_factor"]

SOFTEST = 3.0
"""E/G of an isotropic material that keeps its volume, which none exceeds."""

APART = 0.5
"""Share of its own that a joint bears whose blades stand at different heights, at least: forces at
their heights turn the body aside from the first on."""


def lateral_factor(ask: Ask, *, as_stated: bool) -> Number:
    """Return a factor on a case's loads up to which a joint surely stays in its plane [-].

    A temperature counts among the loads. Nothing but its blades holds it there. Where a guide, ends
    or a lock are taken to hold the body it is that of blades which a temperature pushes between
    bodies that stay, infinite without one; and infinite where there is no layout to look at. It is
    zero where only a look in space tells. Without a shear modulus it is that of the softest. Loads
    act in either sense, ``as_stated`` in the stated one where they have one.
    """
    scene, is_free = ask.scene, is_held_by_blades(ask)
    if not scene.has_plane or scene.in_space or scene.across_by:
        return inf
    if not is_free and (scene.temperature is None or scene.on_bodies):
        return inf
    try:
        layout = ask.geometry.plane_layout(ask.material.elastic, ask.sizes)
    except NotAvailable:
        return inf
    if scene.temperature is not None:
        layout = scene.temperature.warmed(layout, ask.material, ask.geometry.axes)
    if layout.G is None:
        layout = replace(layout, G=layout.E / SOFTEST)
    if layout.supports:
        return 0.0
    groups = list(_groups(ask, layout))
    if not groups and scene.temperature is None:
        return inf
    is_stated = as_stated and scene.directed and any(scene.stated[i] for i in IN_PLANE)
    driven = 3 * layout.index(MOVING)
    driven += 2 if ask.geometry.motion == "rotation" else 1
    travels = scene.stroke_ends if scene.moves else ()
    try:
        found = lateral_bound(
            layout, groups, directed=is_stated, driven=driven, travels=travels, tips=is_free
        )
    except np.linalg.LinAlgError:
        return 0.0
    least = number(found) if len(found) > 1 else float(found[0])
    first = layout.blades[0].z
    apart = any(np.any(np.asarray(blade.z) != np.asarray(first)) for blade in layout.blades)
    return APART * least if apart else least


def is_held_by_blades(ask: Ask) -> bool:
    """Return whether nothing but its blades holds a body in its plane.

    What a guide, ends or a lock hold is held in its plane as well; a mechanism that is locked bears
    accelerations in space.
    """
    scene = ask.scene
    apart = scene.lock is not None or scene.on_bodies
    return not (ask.geometry.is_guided or apart) and hold_of(scene) == FREE


def _groups(ask: Ask, layout: Layout) -> Iterator[list[Load]]:
    """Yield what acts at once in the plane: stated loads, and each of the accelerations."""
    scene, moving = ask.scene, layout.body(MOVING)
    fields = ((0.0, 0.0, 0.0), *scene.accelerations)
    for wrench, field in zip((scene.stated, *scene.inertial), fields, strict=True):
        loads = []
        if any(wrench[i] for i in IN_PLANE):
            loads.append(Load(moving.name, moving.point, (wrench[0], wrench[1]), wrench[5]))
        if field[0] or field[1]:
            loads += list(_weights(ask, layout, field[0], field[1]))
        if loads:
            yield loads


def _weights(ask: Ask, layout: Layout, along_x: Number, along_y: Number) -> Iterator[Load]:
    """Yield what weighs under an acceleration: bodies, and each blade as a whole at its ends."""
    given = ask.material.density
    density = 0.0 if given is None else given.value
    weighing = [(body.name, body.com, body.mass) for body in layout.bodies]
    moving = {body.name for body in layout.bodies}
    for blade in layout.blades:
        mass = density * blade.b * blade.length * blade.least_thickness
        weighing += [
            (name, at, mass)
            for name, at in ((blade.first, blade.start), (blade.second, blade.end))
            if name in moving
        ]
    for name, at, mass in weighing:
        yield Load(name, at, (mass * along_x, mass * along_y))
