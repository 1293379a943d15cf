"""The loads of a case as dead loads on the bodies of a joint in space."""

from collections.abc import Iterable, Iterator, Sequence

import numpy as np

from flexcli.mechanics.space.inertia import blade_masses
from flexcli.mechanics.space.layout import SpaceLoad, vector
from flexcli.mechanics.space.states import Acting
from flexcli.parts.space_joint import SpaceJoint

__all__ = ["loads_of", "signed"]


def loads_of(joint: SpaceJoint, acting: Acting) -> list[SpaceLoad]:
    """Return a wrench on the moving body and an acceleration as loads.

    The mass of a blade weighs by halves on the bodies at its ends.
    """
    layout, found = joint.layout, list[SpaceLoad]()
    if np.any(acting.wrench):
        force, moment = vector(acting.wrench[:3]), vector(acting.wrench[3:])
        found.append(SpaceLoad(layout.drive.body, acting.point, force, moment))
    if np.any(acting.acceleration):
        moving = {body.name for body in layout.bodies}
        weighing = [(body.name, body.com, body.mass) for body in layout.bodies]
        for blade, mass in zip(layout.blades, blade_masses(joint.assembly), strict=True):
            ends = ((blade.first, blade.start), (blade.second, blade.end))
            weighing += [(name, at, float(mass) / 2.0) for name, at in ends if name in moving]
        found += [
            SpaceLoad(name, at, vector(mass * acting.acceleration))
            for name, at, mass in weighing
            if mass > 0.0
        ]
    return found


def signed(groups: Iterable[Sequence[SpaceLoad]], signs: Iterable[float]) -> Iterator[SpaceLoad]:
    """Yield groups of loads, each in its sense."""
    for sign, group in zip(signs, groups, strict=True):
        for load in group:
            yield load.times(sign)
