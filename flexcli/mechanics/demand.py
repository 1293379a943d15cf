"""Demand on a mechanism: motions held and forces applied, on the way from one to another.

Everything is scaled by a length and a force of each design. A share of the way λ in [0, 1] blends
the demand of the start (rest, or an earlier equilibrium with its reactions) into that prescribed.
"""

from collections.abc import Mapping, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Layout, Load, Number
from flexcli.mechanics.mesh import column, table

__all__ = ["Demand", "Force", "Held", "Spring", "forces_of", "held_of", "springs_of", "weights_of"]

Floats = NDArray[np.float64]

Held: TypeAlias = Mapping[str, tuple[Number | None, Number | None, Number | None]]
"""Motion (x [m], y [m], φ [rad]) of the reference point of bodies; None leaves it free."""


_FREE, _NO_AXIS = (None, None, None), (False, False, False)


class Force(NamedTuple):
    """A force on a body at an arm [unit length] from its reference point, arrays (designs or 1, …).

    Its size at λ is ``before + λ (after − before)`` times ``force`` and ``moment``.
    """

    body: int
    arm: Floats
    force: Floats
    moment: Floats
    follows: bool
    before: Floats
    after: Floats


class Spring(NamedTuple):
    """Springs from a body's point to the ground: arm (designs or 1, 2), stiffness (…, 3)."""

    body: int
    arm: Floats
    stiffness: Floats


class Demand(NamedTuple):
    """Coordinates held (3 body + 0, 1, 2), their values before and after (designs, held), forces.

    ``free`` are the other coordinates of the bodies. ``grown`` says that bodies and blades have
    their temperature from the start; else it comes on the way.
    """

    held: NDArray[np.intp]
    free: NDArray[np.intp]
    before: Floats
    after: Floats
    forces: tuple[Force, ...]
    springs: tuple[Spring, ...]
    grown: bool = False

    def warmth(self, share: Floats) -> Floats:
        """Return the share of the temperature that is there at shares λ of the way."""
        return np.ones_like(share) if self.grown else share


def _arm(layout: Layout, body: int, point: tuple[Number, Number], length: Floats) -> Floats:
    origin = layout.bodies[body].point
    x, y = (column(p) - column(o) for p, o in zip(point, origin, strict=True))
    return np.stack(np.broadcast_arrays(x, y), axis=-1) / length[:, None]


def forces_of(
    layout: Layout,
    loads: Sequence[Load],
    length: Floats,
    force: Floats,
    factor: Number = 1.0,
) -> tuple[Force, ...]:
    """Return loads times a factor in scaled form, from nothing at the start."""
    names = {body.name: i for i, body in enumerate(layout.bodies)}
    found = []
    for load in loads:
        if load.body not in names:
            raise KeyError(f"a load acts on {load.body!r}, which is no body of the layout")
        i = names[load.body]
        pair = np.stack(np.broadcast_arrays(*map(column, load.force)), axis=-1) / force[:, None]
        moment = column(load.moment) / (force * length)
        arm = _arm(layout, i, load.point, length)
        found.append(Force(i, arm, pair, moment, load.follows, np.zeros(1), column(factor)))
    return tuple(found)


def weights_of(layout: Layout) -> tuple[Load, ...]:
    """Return the weight of every body with mass, at its centre of mass."""
    a_x, a_y = layout.acceleration
    if all(isinstance(a, float) and a == 0.0 for a in (a_x, a_y)):
        return ()
    return tuple(
        Load(body.name, body.com, (body.mass * a_x, body.mass * a_y))
        for body in layout.bodies
        if np.any(np.asarray(body.mass) != 0.0)
    )


def springs_of(layout: Layout, length: Floats, force: Floats) -> tuple[Spring, ...]:
    """Return the supports in scaled form."""
    names = {body.name: i for i, body in enumerate(layout.bodies)}
    found = []
    for support in layout.supports:
        if support.body not in names:
            raise KeyError(f"a support holds {support.body!r}, which is no body of the layout")
        i = names[support.body]
        k_x, k_y, k_phi = map(column, support.stiffness)
        scaled = (k_x * length / force, k_y * length / force, k_phi / (force * length))
        stiffness = np.stack(np.broadcast_arrays(*scaled), axis=-1)
        found.append(Spring(i, _arm(layout, i, support.point, length), stiffness))
    return tuple(found)


def held_of(
    layout: Layout, held: Held, length: Floats
) -> tuple[NDArray[np.intp], NDArray[np.intp], Floats]:
    """Return the coordinates held, the free ones, and the scaled values of the held.

    What an ideal joint guides is held at rest, unless its motion is given.
    """
    names = [body.name for body in layout.bodies]
    for name in held:
        if name not in names:
            raise KeyError(f"held is {name!r}, which is no body of the layout")
    index, values = [], []
    for body, name in enumerate(names):
        guided = layout.guides.get(name, _NO_AXIS)
        for axis, asked in enumerate(held.get(name, _FREE)):
            value = 0.0 if asked is None and guided[axis] else asked
            if value is not None:
                index.append(3 * body + axis)
                values.append(value)
    free = np.array([i for i in range(3 * len(names)) if i not in index], dtype=np.intp)
    coordinates = np.array(index, dtype=np.intp)
    if not values:
        return coordinates, free, np.zeros((length.size, 0))
    unit = np.where(coordinates % 3 == 2, 1.0, length[:, None])
    return coordinates, free, table(values) / unit
