"""A layout as solids: each blade in bricks, its ends on rigid bodies."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.solid.bricks import Bricks, bricks
from flexcli.mechanics.layout import Body, Layout, Number, Point
from flexcli.mechanics.mesh import column
from flexcli.parts.elastic import NotAvailable

__all__ = ["SolidBody", "SolidModel", "Stretch", "solid_model"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


IN_PLANE, OUT_OF_PLANE = (0, 1, 2, 5), (3, 4)
"""In Voigt's order: strains that are alike on both sides of the plane, and those that are not."""


ROUNDING = 1e-9
"""Of the stiffness along x: what couples the plane with what is beside it by less does not."""


class Stretch(NamedTuple):
    """A blade's bricks between two bodies, and where they stand: its start [m], direction [rad].

    ``first_node`` is the number of nodes before its own; ``z`` the height of its middle [m].
    """

    name: str
    bodies: tuple[str, str]
    bricks: Bricks
    start: tuple[float, float]
    angle: float
    z: float
    first_node: int

    @property
    def places(self) -> Floats:
        """Return where its nodes are in the layout's axes [m]."""
        s, t, z = self.bricks.places.T
        c, n = np.cos(self.angle), np.sin(self.angle)
        x, y = self.start
        return np.stack([x + c * s - n * t, y + n * s + c * t, self.z + z], axis=-1)


class SolidBody(NamedTuple):
    """A rigid body: its point [m], the nodes tied to it, its mass [kg] and where that is."""

    name: str
    point: tuple[float, float]
    nodes: Integers
    mass: float = 0.0
    inertia: float = 0.0
    com: tuple[float, float] = (0.0, 0.0)


@dataclass(frozen=True, eq=False)
class SolidModel:
    """The solids of one design, half of each where its middle plane is one of symmetry.

    ``bodies`` are those of the layout in their order; ``fixed`` are the nodes on the ground.
    ``stiffness`` (6, 6) is that of a material that is stiffer one way, in the layout's axes [Pa].
    """

    layout: Layout
    stretches: tuple[Stretch, ...]
    bodies: tuple[SolidBody, ...]
    fixed: Integers
    is_half: bool
    nodes: int
    stiffness: Floats | None = None

    @property
    def share(self) -> float:
        """Return which share of forces and masses the model bears [-]."""
        return 0.5 if self.is_half else 1.0

    @property
    def elements(self) -> int:
        """Return the number of bricks."""
        return sum(stretch.bricks.elements.shape[0] for stretch in self.stretches)

    @property
    def volume(self) -> float:
        """Return the volume of all that flexes, whole [m³]."""
        return sum(stretch.bricks.volume for stretch in self.stretches)


def solid_model(
    layout: Layout, *, fineness: int = 1, is_half: bool = False, stiffness: Floats | None = None
) -> SolidModel:
    """Return the solids of a layout of one design.

    Parameters
    ----------
    layout : Layout
        Bodies and blades.
    fineness : int
        Elements along each edge of one of the coarsest mesh.
    is_half : bool
        Model one side of each blade's middle plane, for what moves in the plane, unless the
        material is no mirror image of itself in it.
    stiffness : array, optional
        Of a material that is stiffer one way, shape (6, 6), in the layout's axes [Pa].

    Raises
    ------
    NotAvailable
        Where it has springs, which are no solids, or no shear modulus.

    """
    if layout.supports:
        raise NotAvailable("is held by springs, which are no solid")
    if layout.G is None:
        raise NotAvailable("needs material.poisson_ratio for a solid")
    if stiffness is not None:
        out_of_plane = np.abs(stiffness[np.ix_(IN_PLANE, OUT_OF_PLANE)]).max()
        is_half = is_half and bool(out_of_plane <= ROUNDING * stiffness[0, 0])
    known = {body.name for body in layout.bodies}
    tied: dict[str, list[Integers]] = {body.name: [] for body in layout.bodies}
    fixed: list[Integers] = []
    stretches: list[Stretch] = []
    count = 0
    for blade in layout.blades:
        start, end = _place(blade.start), _place(blade.end)
        l = float(np.hypot(end[0] - start[0], end[1] - start[1]))
        angle = float(np.arctan2(end[1] - start[1], end[0] - start[0]))
        groups = blade.profile.stretches(l)
        solid = bricks(groups, _one(blade.b), fineness=fineness, is_half=is_half)
        ends = (blade.first, blade.second)
        stretches.append(Stretch(blade.name, ends, solid, start, angle, _one(blade.z), count))
        for body, side in zip(ends, (0, -1), strict=True):
            nodes = solid.end(side) + count
            if body in known:
                tied[body].append(nodes)
            else:
                fixed.append(nodes)
        count += solid.places.shape[0]
    bodies = [_body(body) for body in layout.bodies]
    whole = tuple(body._replace(nodes=np.concatenate(tied[body.name])) for body in bodies)
    return SolidModel(
        layout, tuple(stretches), whole, np.concatenate(fixed), is_half, count, stiffness
    )


def _body(body: Body) -> SolidBody:
    none = np.zeros(0, dtype=np.intp)
    return SolidBody(
        body.name, _place(body.point), none, _one(body.mass), _one(body.inertia), _place(body.com)
    )


def _place(point: Point) -> tuple[float, float]:
    return _one(point[0]), _one(point[1])


def _one(number: Number) -> float:
    return float(column(number)[0])
