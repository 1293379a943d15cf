"""Two crossed blades of one piece between rigid bodies, as solids drawn out along their width.

The joint is its own mirror image about its bisector, so half of it is solved, with motions that are
even or odd about it: an arm towards the body, one towards the base and half of the rhombus between.
"""

from collections.abc import Sequence
from math import ceil, cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.solids.condensed import Elimination, Part, joined, without
from flexcli.mechanics.solids.extruded import Face, Law, Width, over_face
from flexcli.mechanics.solids.lagrange import places_along

__all__ = ["Crossed", "CrossedMesh", "CrossedSolid", "Second", "graded"]

Floats = NDArray[np.float64]
Numbers = NDArray[np.intp]
Flags = NDArray[np.bool_]

X, Y, TURN, GROWTH = range(4)
"""Motions of the end of an arm: along x and y, about the centre, and away from it as it grows."""

ALONG_Z, ABOUT_X, ABOUT_Y = range(3)
"""The same out of the plane."""

RIGID = 3
"""Those of a rigid body."""

EVEN, ODD = 1.0, -1.0
"""Of motions that are their own mirror images, or less them."""

STAGE, BASE = 0, 1
"""The arms of half the joint."""


class Crossed(NamedTuple):
    """Blades of a thickness and a length from end to end, crossing at a share of it [m].

    ``half_angle`` is that from the bisector, the x axis, to a blade [rad].
    """

    h: float
    l: float
    crossing: float
    half_angle: float

    @property
    def reaches(self) -> tuple[float, float]:
        """Return the lengths of the arms towards the body and towards the base [m]."""
        return (1.0 - self.crossing) * self.l, self.crossing * self.l


class CrossedMesh(NamedTuple):
    """Elements of an order; the first at a corner over the thickness, and what each grows by.

    ``longest`` is the longest across, and ``long`` the longest along an arm, over the thickness.
    """

    order: int
    first: float
    grows: float
    longest: float
    long: float


class Second(NamedTuple):
    """Shift along the bisector of second order in the rotation, towards the base [m/rad²].

    It is that of a material whose stress is linear in Green's strain, or in Hencky's.
    """

    green: float
    hencky: float


class _Cell(NamedTuple):
    """An element: in the plane, the numbers of its nodes, and its share in half the joint.

    Nodes ``beyond`` the bisector stand for their mirror images, whose numbers they have; ``on`` are
    those on it.
    """

    face: Face
    nodes: Numbers
    beyond: Flags
    on: Flags
    share: float = 1.0


class CrossedSolid:
    """The solid of a joint on a mesh: its stiffness, what each arm bears, its shift.

    Parameters
    ----------
    sizes : Crossed
        The joint in its plane.
    law : Law
        What it is made of.
    width : Width
        Functions over the width.
    mesh : CrossedMesh
        The mesh in the plane.

    """

    def __init__(self, sizes: Crossed, law: Law, width: Width, mesh: CrossedMesh) -> None:
        self.sizes, self.law, self.width, self.mesh = sizes, law, width, mesh
        self._products = width.products()
        self._lines = 2.0 * graded(1.0, mesh.first, mesh.grows, mesh.longest) - 1.0
        self._row = (len(self._lines) - 1) * mesh.order + 1
        self._cuts = [
            graded(reach / sizes.h, mesh.first, mesh.grows, mesh.long) * sizes.h / reach
            for reach in sizes.reaches
        ]
        rows = [(len(cuts) - 1) * mesh.order for cuts in self._cuts]
        self._starts = np.cumsum([self._row**2, *(count * self._row for count in rows)])
        self._rigid = int(self._starts[-1]) * width.each
        self._cells = list[_Cell]()
        self._shared = list[Elimination]()
        self._arms = [self._arm(arm) for arm in (STAGE, BASE)]
        self._upper, self._diagonal = self._rhombus()
        self._parities = {parity: self._solved(parity) for parity in (EVEN, ODD)}

    @property
    def stiffness(self) -> Floats:
        """Return that of the body along x, y and about the centre (3, 3) [N/m, N, N·m/rad]."""
        found = np.zeros((RIGID, RIGID))
        found[X, X] = 2.0 * self._parities[EVEN].K[X, X]
        both = np.ix_((Y, TURN), (Y, TURN))
        found[both] = 2.0 * self._parities[ODD].K[both]
        return found

    @property
    def stiffness_aside(self) -> Floats:
        """Return that of the body along z, about x and about y (3, 3) [N/m, N, N·m/rad].

        It is of functions over the width that are odd in its plane.
        """
        found = np.zeros((RIGID, RIGID))
        found[ABOUT_X, ABOUT_X] = 2.0 * self._parities[ODD].K[ABOUT_X, ABOUT_X]
        both = np.ix_((ALONG_Z, ABOUT_Y), (ALONG_Z, ABOUT_Y))
        found[both] = 2.0 * self._parities[EVEN].K[both]
        return found

    def borne(self, motion: Sequence[float]) -> Floats:
        """Return what arms bear as the body moves (2, 2, 3): N, V [N] and M about the centre [N·m].

        First those of the blade at +α, then at −α; of each the arm towards the body, then the one
        towards the base. Each is what acts on its outer end, V to the left of the way outwards.
        """
        moved = np.asarray(motion, dtype=np.float64)
        even, odd = (
            (self._parities[parity].K[:, :RIGID] @ (moved * of)).reshape(2, -1)[:, :RIGID]
            for parity, of in ((EVEN, (1.0, 0.0, 0.0)), (ODD, (0.0, 1.0, 1.0)))
        )
        upper, lower = even + odd, (even - odd) * [1.0, -1.0, -1.0]
        c, s = cos(self.sizes.half_angle), sin(self.sizes.half_angle)
        # the upper arms are that of +α towards the body and that of −α towards the base
        found = np.zeros((2, 2, RIGID))
        for blade, arm, force, y in (
            (0, STAGE, upper, s), (1, BASE, upper, s), (1, STAGE, lower, -s), (0, BASE, lower, -s),
        ):  # fmt: skip
            fx, fy, moment = force[arm]
            x = c if arm == STAGE else -c
            found[blade, arm] = fx * x + fy * y, fy * x - fx * y, moment
        return found

    def second(self) -> Second:
        """Return the shift of second order in the rotation.

        By the work of a unit force on the strains of second order that the linear rotation makes,
        and by how the body's own rotation moves its clamps.
        """
        K = self.stiffness
        turned = np.array([0.0, -K[Y, TURN] / K[Y, Y], 1.0])
        pushed = np.array([1.0 / K[X, X], 0.0, 0.0])
        fields = self._motions(EVEN, pushed), self._motions(ODD, turned)
        green = less = 0.0
        for cell in self._cells:
            force, turn = (
                cell.face.gradient(self.width, self._of_nodes(cell, u, parity))
                for u, parity in zip(fields, (EVEN, ODD), strict=True)
            )
            own, given = self._stress(force), self._stress(turn)
            of_force, of_turn = ((each + np.swapaxes(each, -1, -2)) / 2.0 for each in (force, turn))
            weights = 2.0 * cell.share * cell.face.weights[:, None] * self.width.weights
            squares = np.swapaxes(turn, -1, -2) @ turn, np.swapaxes(turn, -1, -2) @ force
            green += _work(own, squares[0], weights) / 2.0 + _work(given, squares[1], weights)
            less += _work(own, of_turn @ of_turn, weights)
            less += 2.0 * _work(given, of_turn @ of_force, weights)
        # as the body turns by θ, places on it move by −θ² r/2
        green -= float(self._parities[EVEN].K[GROWTH, X] * pushed[X])
        return Second(green, green - less)

    def _arm(self, arm: int) -> Part:
        """Return an arm by the motions of its root and of its end."""
        found = list[Part]()
        order, cuts = self.mesh.order, self._cuts[arm]
        for k in range(len(cuts) - 2, -1, -1):
            rows = k * order + np.arange(order + 1)
            for i in range(len(self._lines) - 1):
                along = i * order + np.arange(order + 1)
                nodes = self._arm_nodes(arm, rows[:, None], along)
                (s, s_), (p, p_) = cuts[k : k + 2], self._lines[i : i + 2]
                corners = [self._place(arm, *at) for at in ((p, s), (p, s_), (p_, s_), (p_, s))]
                none = np.zeros(nodes.size, dtype=bool)
                cell = _cell(np.array(corners), nodes, none, none, order)
                self._cells.append(cell)
                own = self._clamped(arm, self._part(cell, EVEN))
                found.append(self._without_inner(own, cell, self._shared))
            root = self._motions_of(self._arm_nodes(arm, np.array(k * order), self._across))
            found = [self._reduced(joined(found), [root, self._end(arm)], self._shared)]
        return found[0]

    def _rhombus(self) -> tuple[dict[tuple[int, int], Part], dict[int, _Cell]]:
        """Return the elements beyond the bisector by row and column, and those on it by row."""
        count, order, lines = len(self._lines) - 1, self.mesh.order, self._lines
        upper, diagonal = dict[tuple[int, int], Part](), dict[int, _Cell]()
        last = self._row - 1
        for i in range(count):
            for j in range(count - 1 - i, count):
                row, column = np.meshgrid(
                    i * order + np.arange(order + 1), j * order + np.arange(order + 1),
                    indexing="ij",
                )  # fmt: skip
                beyond = row + column < last
                mirrored = (last - column) * self._row + last - row
                nodes = np.where(beyond, mirrored, row * self._row + column)
                (p, p_), (q, q_) = lines[i : i + 2], lines[j : j + 2]
                corners = [self._corner(*at) for at in ((p, q), (p_, q), (p_, q_), (p, q_))]
                on = row + column == last
                cell = _cell(np.array(corners), nodes, beyond, on, order)
                if i + j == count - 1:
                    diagonal[i] = cell = cell._replace(share=0.5)
                else:
                    own = self._part(cell, EVEN)
                    upper[i, j] = self._without_inner(own, cell, self._shared)
                self._cells.append(cell)
        return upper, diagonal

    def _solved(self, parity: float) -> "_Solved":
        """Return half the joint, its motions even or odd about the bisector."""
        count, order, gone = len(self._lines) - 1, self.mesh.order, list[Elimination]()
        last, found = self._row - 1, list[Part]()
        sides = self._across * self._row + last, last * self._row + self._across
        for i in range(count):
            found.append(self._on_bisector(self._diagonal[i], parity))
            found += [self._upper[i, j] for j in range(count - i, count)]
            line = (i + 1) * order * self._row + self._across
            kept = [self._motions_of(nodes) for nodes in (line, *sides)]
            found = [self._reduced(joined(found), kept, gone)]
        whole = joined([*found, *self._arms])
        ends = [self._end(arm) for arm in (STAGE, BASE)]
        rest = self._reduced(whole, ends, gone)
        return _Solved(rest.K, tuple(gone[::-1]) + tuple(self._shared[::-1]))

    def _on_bisector(self, cell: _Cell, parity: float) -> Part:
        """Return an element that the bisector halves by the motions beyond it and on it."""
        part = self._part(cell, parity)
        each, plane = self.width.each, self.width.plane.shape[1]
        is_y = np.zeros(each, dtype=bool)
        is_y[plane : 2 * plane] = True
        on = self._motions_of(cell.nodes[cell.on]).reshape(-1, each)
        none = on[:, is_y if parity == EVEN else ~is_y]
        at = np.flatnonzero(~np.isin(part.motions, none))
        return Part(part.motions[at], part.K[np.ix_(at, at)])

    def _part(self, cell: _Cell, parity: float) -> Part:
        """Return an element by the motions of its nodes, where some stand for others."""
        K = cell.share * cell.face.stiffness(self.law, self.width, self._products)
        motions = self._motions_of(cell.nodes)
        if cell.share == 1.0:
            return Part(motions, K)
        signs = self._signs(cell, parity).ravel()
        found, at = np.unique(motions, return_inverse=True)
        to = np.zeros((motions.size, found.size))
        to[np.arange(motions.size), at] = signs
        return Part(found, to.T @ K @ to)

    def _signs(self, cell: _Cell, parity: float) -> Floats:
        """Return by how much motions of an element's nodes are those that it has the numbers of."""
        plane = self.width.plane.shape[1]
        found = np.ones((cell.nodes.size, self.width.each))
        found[cell.beyond] = parity
        found[cell.beyond, plane : 2 * plane] = -parity
        return found

    def _clamped(self, arm: int, part: Part) -> Part:
        """Return an element of which nodes at the end of its arm move with that."""
        node, kind = np.divmod(part.motions, self.width.each)
        last = self._starts[arm + 1] - self._row
        is_end = (node >= last) & (node < last + self._row)
        if not is_end.any():
            return part
        free, held = np.flatnonzero(~is_end), np.flatnonzero(is_end)
        by = self._with_end(arm, node[held] - last, kind[held])
        across = part.K[np.ix_(free, held)] @ by
        K = np.block(
            [
                [part.K[np.ix_(free, free)], across],
                [across.T, by.T @ part.K[np.ix_(held, held)] @ by],
            ]
        )
        return Part(np.concatenate([part.motions[free], self._end(arm)]), K)

    def _with_end(self, arm: int, row: Numbers, kind: Numbers) -> Floats:
        """Return how nodes of an end move with it, along x, y or z (motions, 4)."""
        width, plane = self.width, self.width.plane.shape[1]
        x, y = self._end_places(arm)[row].T
        found = np.zeros((row.size, GROWTH + 1))
        of_x, of_y, of_z = kind < plane, (kind >= plane) & (kind < 2 * plane), kind >= 2 * plane
        if width.is_aside:
            found[of_z, ALONG_Z] = 1.0
            found[of_z, ABOUT_X], found[of_z, ABOUT_Y] = y[of_z], -x[of_z]
            found[of_y, ABOUT_X] = -width.z[kind[of_y] - plane]
            found[of_x, ABOUT_Y] = width.z[kind[of_x]]
            return found
        found[of_x, X] = found[of_y, Y] = 1.0
        found[of_x, TURN], found[of_y, TURN] = -y[of_x], x[of_y]
        found[of_x, GROWTH], found[of_y, GROWTH] = x[of_x], y[of_y]
        return found

    def _motions(self, parity: float, body: Floats) -> Floats:
        """Return all motions as the body moves."""
        u = np.zeros(self._rigid + 2 * (GROWTH + 1))
        u[self._rigid : self._rigid + RIGID] = body
        for each in self._parities[parity].gone:
            each.recover(u)
        row, kind = np.divmod(np.arange(self._row * self.width.each), self.width.each)
        start = (self._starts[STAGE + 1] - self._row) * self.width.each
        u[start : start + row.size] = self._with_end(STAGE, row, kind)[:, :RIGID] @ body
        return u

    def _of_nodes(self, cell: _Cell, u: Floats, parity: float) -> Floats:
        """Return the motions of an element's nodes (nodes, each)."""
        own = u[self._motions_of(cell.nodes)].reshape(cell.nodes.size, -1)
        return own * self._signs(cell, parity)

    def _stress(self, gradient: Floats) -> Floats:
        """Return the stress of gradients of motions [Pa]."""
        strain = (gradient + np.swapaxes(gradient, -1, -2)) / 2.0
        volume = self.law.lame * np.trace(strain, axis1=-2, axis2=-1)
        return np.asarray(2.0 * self.law.mu * strain + volume[..., None, None] * np.eye(3))

    def _without_inner(self, part: Part, cell: _Cell, gone: list[Elimination]) -> Part:
        """Return an element without what only it has."""
        side = self.mesh.order + 1
        inner = self._motions_of(cell.nodes.reshape(side, side)[1:-1, 1:-1].ravel())
        rest, eliminated = without(part, inner)
        gone.append(eliminated)
        return rest

    def _reduced(self, part: Part, kept: list[Numbers], gone: list[Elimination]) -> Part:
        """Return a part by these of its motions."""
        rest, eliminated = without(part, np.setdiff1d(part.motions, np.concatenate(kept)))
        gone.append(eliminated)
        return rest

    @property
    def _across(self) -> Numbers:
        return np.arange(self._row)

    def _motions_of(self, nodes: Numbers) -> Numbers:
        """Return the numbers of all motions of nodes."""
        each = self.width.each
        return np.asarray((each * np.ravel(nodes)[:, None] + np.arange(each)).ravel())

    def _end(self, arm: int) -> Numbers:
        """Return the numbers of the motions of an end."""
        return self._rigid + (GROWTH + 1) * arm + np.arange(GROWTH + 1)

    def _arm_nodes(self, arm: int, along: Numbers, across: Numbers) -> Numbers:
        """Return the numbers of nodes of an arm; those of its root are the rhombus's."""
        last = self._row - 1
        root = across * self._row + last if arm == STAGE else last * self._row + across
        beyond = self._starts[arm] + (along - 1) * self._row + across
        return np.where(along == 0, root, beyond)

    def _corner(self, p: float, q: float) -> Floats:
        """Return the place p h/2 to the left of the blade at +α, and q h/2 of that at −α."""
        c, s = cos(self.sizes.half_angle), sin(self.sizes.half_angle)
        return self.sizes.h / 4.0 * np.array([(q - p) / s, (p + q) / c])

    def _place(self, arm: int, p: float, s: float) -> Floats:
        """Return a place in an arm: p h/2 off its middle, a share s of the way to its end."""
        root = self._corner(p, 1.0) if arm == STAGE else self._corner(1.0, p)
        return (1.0 - s) * root + s * self._end_place(arm, p)

    def _end_place(self, arm: int, p: float) -> Floats:
        """Return a place of an end."""
        c, s = cos(self.sizes.half_angle), sin(self.sizes.half_angle)
        along, across = ((c, s), (-s, c)) if arm == STAGE else ((-c, s), (s, c))
        reach = self.sizes.reaches[arm]
        return reach * np.array(along) + p * self.sizes.h / 2.0 * np.array(across)

    def _end_places(self, arm: int) -> Floats:
        """Return the places of the nodes of an end (nodes, 2)."""
        lines = places_along(self._lines, self.mesh.order)
        return np.array([self._end_place(arm, p) for p in lines])


class _Solved(NamedTuple):
    """Half the joint by the motions of both ends (8, 8), and what is gone of it, the last first."""

    K: Floats
    gone: tuple[Elimination, ...]


def graded(total: float, first: float, grows: float, longest: float) -> Floats:
    """Return where elements end that grow from both ends of a length on."""
    sizes, left = list[float](), total
    while first < longest and left > 2.0 * first * (1.0 + 1.0 / grows):
        sizes.append(first)
        left -= 2.0 * first
        first *= grows
    inner = max(1, ceil(left / longest - 1e-9))
    cuts = np.cumsum([0.0, *sizes, *[left / inner] * inner, *sizes[::-1]])
    return np.asarray(cuts * (total / cuts[-1]))


def _cell(corners: Floats, nodes: Numbers, beyond: Flags, on: Flags, order: int) -> _Cell:
    """Return an element, counterclockwise whichever way its corners go round."""
    x, y = corners.T
    side = order + 1
    nodes, beyond, on = nodes.reshape(side, side), *(x.reshape(side, side) for x in (beyond, on))
    if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 0.0:
        corners, nodes, beyond, on = corners[[0, 3, 2, 1]], nodes.T, beyond.T, on.T
    return _Cell(over_face(corners, order), nodes.ravel(), beyond.ravel(), on.ravel())


def _work(stress: Floats, strain: Floats, weights: Floats) -> float:
    """Return what stresses do on strains (points, points, 3, 3) [J]."""
    return float(np.einsum("ghij,ghij,gh->", stress, strain, weights))
