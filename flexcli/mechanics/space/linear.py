"""Small motion of a mechanism in space: bodies on six springs a blade, any of them driven.

Everything is kept as rows √k · deformation and solved by an orthogonal factor of these rows, so
that soft directions keep their digits beside stiff ones, from micrometres to metres. The moving
body's six coordinates are those of the drive, so that to hold the drive is to hold one of them.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.blade_spring import deformation_rows
from flexcli.formulas.rigid_motion import motion_along, motion_at
from flexcli.mechanics.space.layout import SpaceLayout, SpaceLoad, Vector, grown_ends
from flexcli.mechanics.space.springs import MemberSprings, springs_of
from flexcli.numerics.square_root import Singular, triangle

__all__ = ["Moved", "SpaceAssembly", "assemble"]

Floats = NDArray[np.float64]


class Moved(NamedTuple):
    """What loads, misfits or a travel do; one column for each of them.

    ``coordinates`` are those of :class:`SpaceAssembly`, ``deformations`` and ``forces`` the six
    of each blade at its elastic centre, by rows, ``drive`` what the drive bears [N or N·m].
    """

    coordinates: Floats
    deformations: Floats
    forces: Floats
    drive: Floats


@dataclass(frozen=True, eq=False)
class SpaceAssembly:
    """A mechanism in space, ready to be solved.

    ``rows`` are the deformations of all springs, six a blade and then those to the ground, per
    coordinate; ``stiffness`` that of each. ``to_body`` brings the moving body's coordinates,
    which start with the drive's own, to the motion of its point along the axes of the drawing.
    """

    layout: SpaceLayout
    members: tuple[MemberSprings, ...]
    rows: Floats
    stiffness: Floats
    to_body: Floats

    @property
    def size(self) -> int:
        """Return the number of coordinates, six a body."""
        return 6 * len(self.layout.bodies)

    @property
    def moving(self) -> slice:
        """Return where the coordinates of the moving body are."""
        first = 6 * self.layout.index(self.layout.drive.body)
        return slice(first, first + 6)

    @property
    def driven(self) -> int:
        """Return the coordinate that the drive moves."""
        first = 6 * self.layout.index(self.layout.drive.body)
        return first + (3 if self.layout.drive.turns else 0)

    @cached_property
    def _free(self) -> "_Factor":
        return _Factor(self, np.arange(self.size))

    @cached_property
    def _locked(self) -> "_Factor":
        return _Factor(self, np.delete(np.arange(self.size), self.driven))

    def scaled(self, factors: Floats) -> "SpaceAssembly":
        """Return the same mechanism with every spring times a factor of its own."""
        return SpaceAssembly(
            self.layout, self.members, self.rows, self.stiffness * factors, self.to_body
        )

    def moved(
        self,
        loads: Floats | None = None,
        *,
        misfits: Floats | None = None,
        travel: Floats | None = None,
    ) -> Moved:
        """Return what loads and misfits do, with the drive locked at a travel or free.

        Parameters
        ----------
        loads : array, shape (coordinates, columns), optional
            As :meth:`load` gives them [N, N·m].
        misfits : array, shape (rows, columns), optional
            Deformations that the springs have where nothing moves [m, rad].
        travel : array, shape (columns,), optional
            Where the drive holds the moving body [m or rad]; left out, it is free.

        Raises
        ------
        SolveError
            When something can move without resistance.

        """
        given = [x.shape[-1] for x in (loads, misfits, travel) if x is not None]
        columns = given[0]
        f = np.zeros((self.size, columns)) if loads is None else loads
        strained = np.zeros((len(self.rows), columns)) if misfits is None else misfits
        x = np.zeros((self.size, columns))
        if travel is not None:
            x[self.driven] = travel
            strained = strained + self.rows[:, [self.driven]] * travel
        factor = self._free if travel is None else self._locked
        x[factor.kept] = factor.solved(f[factor.kept], strained)
        deformations = strained + self.rows[:, factor.kept] @ x[factor.kept]
        forces = self.stiffness[:, None] * deformations
        drive = self.rows[:, self.driven] @ forces - f[self.driven]
        return Moved(x, deformations, forces, drive)

    def growth(self) -> Floats:
        """Return the deformations that a temperature gives the springs where nothing moves."""
        found = np.zeros(len(self.rows))
        for k, (blade, member) in enumerate(zip(self.layout.blades, self.members, strict=True)):
            first, second = grown_ends(self.layout, blade)
            end = deformation_rows(member.springs, np.array([member.l, 0.0, 0.0]))
            found[6 * k : 6 * k + 6] = end[:, :3] @ member.axes @ (second - first)
        return found

    def curl(self) -> Floats:
        """Return the deformations of springs of blades that a temperature bends, nothing moving.

        A free blade whose strain rises by g across itself is bent to the curvature −g.
        """
        found = np.zeros(len(self.rows))
        for k, (blade, member) in enumerate(zip(self.layout.blades, self.members, strict=True)):
            _, y, z = member.axes @ np.array(self.layout.blade_curl.get(blade.name, (0.0,) * 3))
            l = member.l
            seat = np.array([0.0, y * l**2 / 2.0, z * l**2 / 2.0, 0.0, -z * l, y * l])
            end = deformation_rows(member.springs, np.array([l, 0.0, 0.0]))
            found[6 * k : 6 * k + 6] = end @ seat
        return found

    def load(self, load: SpaceLoad) -> Floats:
        """Return a load on the coordinates, shape (coordinates,)."""
        found = np.zeros(self.size)
        wrench = np.concatenate([load.force, load.moment])
        at = 6 * self.layout.index(load.body)
        found[at : at + 6] = self.motion(load.body, load.point)[:, at : at + 6].T @ wrench
        return found

    def motion(self, body: str, point: Vector) -> Floats:
        """Return the motion of a point of a body, shape (6, coordinates), per coordinate."""
        index = self.layout.index(body)
        found = np.zeros((6, self.size))
        at = slice(6 * index, 6 * index + 6)
        found[:, at] = motion_at(np.subtract(point, self.layout.bodies[index].point))
        if body == self.layout.drive.body:
            found[:, at] = found[:, at] @ self.to_body
        return found

    def compliance(self, body: str, point: Vector, *, locked: bool) -> Floats:
        """Return the 6×6 compliance of a point of a body [m/N, 1/N, rad/(N·m)].

        All other bodies are free; ``locked`` says whether the drive holds its one motion.
        """
        factor = self._locked if locked else self._free
        root = factor.root @ self.motion(body, point)[:, factor.kept].T
        return np.asarray(root.T @ root)

    def compliance_root(self, *, locked: bool) -> Floats:
        """Return S with SᵀS the compliance of all coordinates, zero of one that is held."""
        factor = self._locked if locked else self._free
        root = np.zeros((len(factor.kept), self.size))
        root[:, factor.kept] = factor.root
        return root


class _Factor:
    """The orthogonal factor of the rows of the coordinates that are not held."""

    def __init__(self, assembly: SpaceAssembly, kept: NDArray[np.intp]) -> None:
        self.kept = kept
        self.weights = np.sqrt(assembly.stiffness)[:, None]
        try:
            found = triangle(self.weights * assembly.rows[:, kept])
        except Singular as error:
            raise SolveError(
                "no-stiffness",
                "a body can move without resistance",
                "hold every body by blades, rods or springs in all its six freedoms",
            ) from error
        self.Q, R, scale = found
        # of the transposed inverse, so that C = rootᵀ root
        self.root = np.linalg.inv(R).T / scale

    def solved(self, loads: Floats, strained: Floats) -> Floats:
        """Return the coordinates under loads and deformations that are there without them."""
        return np.asarray(self.root.T @ (self.root @ loads - self.Q.T @ (self.weights * strained)))


def assemble(
    layout: SpaceLayout, members: tuple[MemberSprings, ...] | None = None
) -> SpaceAssembly:
    """Return a mechanism ready to be solved, its blades by formulas where no springs are given."""
    drive = layout.drive
    if members is None:
        members = tuple(springs_of(member) for member in layout.blades)
    arm = np.subtract(layout.body(drive.body).point, drive.point)
    to_body = motion_at(arm) @ motion_along(_axes_from(drive.direction)).T
    names = [body.name for body in layout.bodies]
    count = 6 * len(members)
    rows = np.zeros((count + 6 * len(layout.springs), 6 * len(names)))
    stiffness = [member.springs.stiffness for member in members]
    for k, (blade, member) in enumerate(zip(layout.blades, members, strict=True)):
        turned = motion_along(member.axes)
        for name, side in ((blade.first, -1.0), (blade.second, 1.0)):
            if name in names:
                i = names.index(name)
                point = member.axes @ np.subtract(layout.bodies[i].point, blade.start)
                found = side * deformation_rows(member.springs, point) @ turned
                rows[6 * k : 6 * k + 6, 6 * i : 6 * i + 6] = found
    for k, spring in enumerate(layout.springs):
        i, at = names.index(spring.body), count + 6 * k
        arm = np.subtract(spring.point, layout.bodies[i].point)
        rows[at : at + 6, 6 * i : 6 * i + 6] = motion_at(arm)
        stiffness.append(np.asarray(spring.stiffness))
    i = 6 * names.index(drive.body)
    rows[:, i : i + 6] = rows[:, i : i + 6] @ to_body
    return SpaceAssembly(layout, members, rows, np.concatenate(stiffness), to_body)


def _axes_from(direction: Vector) -> Floats:
    """Return right-handed orthonormal rows of which the first is a direction."""
    x = np.asarray(direction, dtype=np.float64) / np.linalg.norm(direction)
    z = np.cross(x, np.eye(3)[int(np.argmin(np.abs(x)))])
    z = z / np.linalg.norm(z)
    return np.stack([x, np.cross(z, x), z])
