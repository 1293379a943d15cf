"""What the errors of springs make of a number, blades of the same shape having the same error."""

from collections.abc import Callable, Sequence
from itertools import product

import numpy as np

from flexcli.mechanics.space.layout import SpaceRod
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.parts.space_joint import SpaceJoint
from flexcli.results import ErrorRange

__all__ = ["changed_by_springs"]

MANY = 6
"""Kinds of springs in a joint up to which each is varied alone."""


def changed_by_springs(
    joint: SpaceJoint, springs: Sequence[int], size: Callable[[SpaceAssembly], float]
) -> ErrorRange | None:
    """Return the relative error of a number of a joint by that of some of its blades' springs.

    Blades of the same shape have the same error; each kind of their ``springs`` is at its lower or
    upper limit beside the others. None where that is unknown, or blades are of many shapes.
    """
    alike = dict[tuple[object, ...], list[int]]()
    for k, blade in enumerate(joint.layout.blades):
        if isinstance(blade, SpaceRod):
            return None
        shape = (*vars(blade.profile).values(), blade.b, joint.assembly.members[k].l)
        for spring in springs:
            alike.setdefault((spring, *shape), []).append(6 * k + spring)
    rows = list(alike.values())
    if not rows or len(rows) > MANY or not np.isfinite(joint.high[np.concatenate(rows)]).all():
        return None
    found, rest = list[float](), size(joint.assembly)
    for ends in product((joint.low, joint.high), repeat=len(rows)):
        factors = np.ones(len(joint.assembly.stiffness))
        for own, end in zip(rows, ends, strict=True):
            factors[own] += end[own]
        found.append(size(joint.assembly.scaled(factors)) / rest - 1.0)
    return ErrorRange(min(0.0, *found), max(0.0, *found))
