"""A layout as solids, in the plane or in space: each blade in bricks, its ends on rigid bodies."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.solid.bricks import Bricks, bricks
from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Body, Layout, Point
from flexcli.mechanics.mesh import single
from flexcli.mechanics.space.layout import Isotropic, SpaceBody, SpaceLayout, SpaceRod, SpaceStar
from flexcli.parts.elastic import NotAvailable

__all__ = ["SolidBody", "SolidModel", "Stretch", "solid_model", "solid_model_in_space"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]
Place: TypeAlias = tuple[float, float, float]

NONE = np.zeros(0, dtype=np.intp)
"""No nodes."""

IN_PLANE, OUT_OF_PLANE = (0, 1, 2, 5), (3, 4)
"""In Voigt's order: strains that are alike on both sides of the plane, and those that are not."""


ROUNDING = 1e-9
"""Of the stiffness along x: what couples the plane with what is beside it by less does not."""


class Stretch(NamedTuple):
    """A blade's bricks between two bodies, and where they stand: the middle of its start [m].

    ``axes`` has its own as rows, along it, across its thickness and across its width;
    ``first_node`` is the number of nodes before its own.
    """

    name: str
    bodies: tuple[str, str]
    bricks: Bricks
    start: Place
    axes: Floats
    first_node: int

    @property
    def places(self) -> Floats:
        """Return where its nodes are in the layout's axes [m]."""
        return np.asarray(np.array(self.start) + self.bricks.places @ self.axes)


class SolidBody(NamedTuple):
    """A rigid body: its point [m], the nodes tied to it, and point masses that stand for its own.

    ``masses`` are places [m] and masses [kg].
    """

    name: str
    point: Place
    nodes: Integers
    masses: tuple[tuple[Place, float], ...] = ()


@dataclass(frozen=True, eq=False)
class SolidModel:
    """The solids of one design, half of each where its middle plane is one of symmetry.

    ``bodies`` are those of the layout in their order; ``fixed`` are the nodes on the ground. Of a
    mechanism in space ``layout`` has the moduli alone.
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
    stretches: list[Stretch] = []
    count = 0
    for blade in layout.blades:
        start, end = _place(blade.start), _place(blade.end)
        l = float(np.hypot(end[0] - start[0], end[1] - start[1]))
        angle = float(np.arctan2(end[1] - start[1], end[0] - start[0]))
        groups = blade.profile.stretches(l)
        solid = bricks(groups, single(blade.b), fineness=fineness, is_half=is_half)
        c, n = np.cos(angle), np.sin(angle)
        axes = np.array([[c, n, 0.0], [-n, c, 0.0], [0.0, 0.0, 1.0]])
        at = (*start, single(blade.z))
        stretches.append(Stretch(blade.name, (blade.first, blade.second), solid, at, axes, count))
        count += solid.places.shape[0]
    bodies = [SolidBody(body.name, (*_place(body.point), 0.0), NONE, _in_plane(body))
              for body in layout.bodies]  # fmt: skip
    return _tied(layout, stretches, bodies, is_half=is_half, stiffness=stiffness)


def solid_model_in_space(layout: SpaceLayout, *, fineness: int = 1) -> SolidModel:
    """Return the solids of a mechanism in space at rest, blades and rods whole.

    ``fineness`` is that of :func:`solid_model`.

    Raises
    ------
    NotAvailable
        Where it has springs, or blades of several materials or of one that is stiffer one way.

    """
    if layout.springs:
        raise NotAvailable("is held by springs, which are no solid")
    (material, *others) = {blade.material for blade in layout.blades}
    if others or not isinstance(material, Isotropic):
        raise NotAvailable("has blades of several materials, or stiffer one way, in space")
    stretches: list[Stretch] = []
    count = 0
    for blade in layout.blades:
        l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
        if isinstance(blade, SpaceStar):
            raise NotAvailable("has strips that cross, of which no bricks are made")
        if isinstance(blade, SpaceRod):
            pieces = Constant(blade.d).stretches(l)
            solid = bricks(pieces, blade.d, fineness=fineness, is_round=True)
        else:
            solid = bricks(blade.profile.stretches(l), blade.b, fineness=fineness)
        ends = (blade.first, blade.second)
        stretches.append(Stretch(blade.name, ends, solid, blade.start, blade.axes, count))
        count += solid.places.shape[0]
    bodies = [SolidBody(body.name, body.point, NONE, _of_tensor(body)) for body in layout.bodies]
    return _tied(Layout((), (), material.E, material.G), stretches, bodies)


def _tied(
    layout: Layout,
    stretches: Sequence[Stretch],
    bodies: Sequence[SolidBody],
    *,
    is_half: bool = False,
    stiffness: Floats | None = None,
) -> SolidModel:
    """Return a model whose blades end on its bodies, or on the ground."""
    on: dict[str, list[Integers]] = {}
    for stretch in stretches:
        for body, side in zip(stretch.bodies, (0, -1), strict=True):
            on.setdefault(body, []).append(stretch.bricks.end(side) + stretch.first_node)
    whole = tuple(body._replace(nodes=np.concatenate(on.pop(body.name))) for body in bodies)
    fixed = np.concatenate([nodes for each in on.values() for nodes in each])
    count = sum(stretch.bricks.places.shape[0] for stretch in stretches)
    return SolidModel(layout, tuple(stretches), whole, fixed, is_half, count, stiffness)


def _in_plane(body: Body) -> tuple[tuple[Place, float], ...]:
    """Return point masses with the mass and the inertia of a body in its plane."""
    mass, (x, y) = single(body.mass), _place(body.com)
    if mass == 0.0:
        return ()
    arm = float(np.sqrt(single(body.inertia) / mass))
    if arm == 0.0:
        return (((x, y, 0.0), mass),)
    return ((x - arm, y, 0.0), mass / 2.0), ((x + arm, y, 0.0), mass / 2.0)


def _of_tensor(body: SpaceBody) -> tuple[tuple[Place, float], ...]:
    """Return six point masses with the mass and the inertia of a body, on its principal axes."""
    if body.mass == 0.0:
        return ()
    inertia, axes = np.linalg.eigh(np.array(body.inertia))
    squares = 3.0 * (inertia.sum() / 2.0 - inertia) / body.mass
    found = []
    for square, axis in zip(squares, axes.T, strict=True):
        for side in (-1.0, 1.0):
            x, y, z = np.array(body.com) + side * np.sqrt(max(0.0, square)) * axis
            found.append(((float(x), float(y), float(z)), body.mass / 6.0))
    return tuple(found)


def _place(point: Point) -> tuple[float, float]:
    return single(point[0]), single(point[1])
