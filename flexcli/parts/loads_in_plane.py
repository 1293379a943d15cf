"""What acts in the plane of a joint in its case: senses, loads on its bodies, and accelerations."""

from itertools import product
from math import cos, sin

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Layout, Load, Number
from flexcli.mechanics.own_weight import weights_on_bodies
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.scene import IN_PLANE, Scene

__all__ = ["accelerated", "loads_in_plane", "senses_in_plane"]

Floats = NDArray[np.float64]


def senses_in_plane(scene: Scene, *, as_stated: bool = False) -> Floats:
    """Return the signs (combinations, groups) of what is stated and of each acceleration.

    A load that states its direction has no other; a wrench acts either way, but ``as_stated`` in
    what it buckles.
    """
    fields = ((0.0, 0.0, 0.0), *scene.accelerations)
    acts = [
        any(wrench[i] for i in IN_PLANE) or any(field[:2])
        for wrench, field in zip((scene.stated, *scene.inertial), fields, strict=True)
    ]
    acts[0] = acts[0] and not (scene.directed if as_stated else scene.has_one_sense)
    return np.array(list(product(*((1.0, -1.0) if on else (1.0,) for on in acts))))


def loads_in_plane(
    scene: Scene, layout: Layout, density: Number, signs: Floats, angle: float
) -> list[Load]:
    """Return the loads in the plane with their signs (states, groups), turned by an angle [rad].

    ``density`` is that of the blades [kg/m³].
    """
    centre, (c, s) = layout.body(MOVING).point, (cos(angle), sin(angle))
    found = []
    for group, wrench in enumerate((scene.stated, *scene.inertial)):
        if any(wrench[i] for i in IN_PLANE):
            x, y, sign = wrench[0], wrench[1], signs[:, group]
            force = (sign * (c * x - s * y), sign * (s * x + c * y))
            found.append(Load(MOVING, centre, force, sign * wrench[5]))
    if not scene.is_accelerated:
        return found
    field = accelerated(scene, signs, angle)
    found += [
        Load(body.name, body.com, (body.mass * field[0], body.mass * field[1]))
        for body in layout.bodies
        if body.mass
    ]
    return found + (weights_on_bodies(layout, density, *field) if np.any(density) else [])


def accelerated(scene: Scene, signs: Floats, angle: float) -> tuple[Floats, Floats]:
    """Return what acts on all mass with its signs (states, groups), turned by an angle [m/s²]."""
    c, s = cos(angle), sin(angle)
    each = [(x, y) for x, y, _ in scene.accelerations]
    x, y = (sum(signs[:, k] * field[i] for k, field in enumerate(each, 1)) for i in (0, 1))
    return np.asarray(c * x - s * y), np.asarray(s * x + c * y)
