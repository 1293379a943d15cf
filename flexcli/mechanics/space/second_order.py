"""What a small motion leaves out in space: shortening, turned levers, twist beside bending.

The energy of the springs is expanded one order beyond the linear model: each blade is bent and
twisted as the linear solution says, but between ends that move as finite rotations move them.
"""

from typing import NamedTuple

import numpy as np
from numpy.polynomial import Polynomial
from numpy.typing import NDArray

from flexcli.formulas.blade_spring import deformation_rows
from flexcli.formulas.profile import Constant
from flexcli.formulas.rigid_motion import motion_along, motion_at
from flexcli.mechanics.space.layout import (
    MissedSeat,
    SpaceLoad,
    SpaceRod,
    SpaceStar,
    grown_ends,
)
from flexcli.mechanics.space.linear import Moved, SpaceAssembly
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["SecondOrder", "second_order", "stiffened_by_loads"]

Floats = NDArray[np.float64]

NODES, WEIGHTS = gauss_rule(6)
"""On the whole blade: exact for products of cubics and their slopes."""

PLACES = np.linspace(0.0, 1.0, 9)
"""Along a blade, where its inner moments are looked at."""

TWISTS = (Polynomial([0.0, 1.0, -1.0]), Polynomial([0.0, 1.0, -3.0, 2.0]))
BENDS = (Polynomial([0.0, 0.0, 1.0, -2.0, 1.0]), Polynomial([0.0, 0.0, 1.0, -4.0, 5.0, -2.0]))
"""Shapes of a blade, over its length, that its ends do not feel: with them it buckles alone."""

TWIST, TWIST_RATE = (np.array([f.deriv(n)(NODES) for f in TWISTS]).T for n in (0, 1))
BEND_SLOPE, BEND_RATE = (np.array([f.deriv(n)(NODES) for f in BENDS]).T for n in (1, 2))

INNER = 2 * len(TWISTS) + len(BENDS)
ROW, COLUMN = np.triu_indices(12 + INNER)
PAIRS = (np.eye(12 + INNER)[ROW] + np.eye(12 + INNER)[COLUMN]).T
"""Every two motions of the ends and inner shapes of a blade together: of these its curvature is."""
STRAIGHT = np.column_stack([np.ones_like(PLACES), PLACES])
NOT_STRAIGHT = np.eye(PLACES.size) - STRAIGHT @ np.linalg.pinv(STRAIGHT)
"""What takes from values at the places the straight line that is nearest to them."""
INNER_STIFFNESS = np.array(
    [(WEIGHTS[:, None] * f**2).sum(0) for f in (TWIST_RATE, BEND_RATE, BEND_RATE)]
)
"""Energy of the shapes of twist, of bending about y and about z, over GJ/l and EI/l."""


class SecondOrder(NamedTuple):
    """What one order more adds to a linear state: to its coordinates and forces.

    ``buckling`` is the share of the forces of the state over those under which its bodies, or
    blades between ends that stand still, turn aside as straight beams do [-]. ``inside`` are the
    moments about x, y, z of each blade (blades, 3, places) that its ends do not feel: what its own
    deflection makes of their forces. ``rotation`` is the largest angle between the two ends of a
    blade, or of its chord against either [rad]; ``axial`` the largest axial force of either order
    over EI/l² of its blade [-]; ``arms`` the largest stress of bending of a star over the least
    that makes its arms buckle, beside its axial force [-].
    """

    coordinates: Floats
    forces: Floats
    inside: Floats
    rotation: float
    axial: float
    buckling: float
    arms: float = 0.0


def second_order(
    assembly: SpaceAssembly,
    found: Moved,
    loads: tuple[SpaceLoad, ...],
    *,
    locked: bool,
    warmth: float = 0.0,
    missed: MissedSeat | None = None,
) -> SecondOrder:
    """Return what the second order adds to a linear state (of one column).

    ``K d_2 = −∇V_3(d_1)`` with the cubic energy ``V_3 = Σ s·e_2(d)`` of the springs' forces s and
    second-order deformations e_2, and of the loads.

    Parameters
    ----------
    assembly : SpaceAssembly
        The mechanism.
    found : Moved
        The linear state.
    loads : tuple of SpaceLoad
        The loads that it is under; forces and moments keep their directions.
    locked : bool
        Whether the drive holds its one motion.
    warmth : float
        Share of the layout's growth that the state has [-].
    missed : MissedSeat, optional
        What seat is off in the state.

    Returns
    -------
    SecondOrder
        Changes of second order.

    Notes
    -----
    Of blades of constant thickness. Leading terms: a share e of the linear result is followed by
    terms of e², and by those of the square of the rotation. The bodies turn by rotation vectors.

    """
    blades = _blades(assembly, found, warmth, missed)
    softening = _Softening(assembly, blades, loads)
    misfits = np.zeros((len(assembly.rows), 1))
    gradient = np.zeros(assembly.size)
    for k, blade in enumerate(blades):
        misfits[6 * k : 6 * k + 6, 0] = blade.value
        for end, i in enumerate(blade.bodies):
            if i is not None:
                gradient[6 * i : 6 * i + 6] += blade.gradient[6 * end : 6 * end + 6]
    for load in loads:
        i = assembly.layout.index(load.body)
        arm = np.subtract(load.point, _point(assembly, i))
        # work of ½ θ × (θ × a) by the force; spin is θ' + ½ θ × θ'
        force, moment = np.asarray(load.force), np.asarray(load.moment)
        theta = _of_body(assembly, found.coordinates[:, 0], i)[3:]
        turned = np.cross(np.cross(arm, theta), force) + np.cross(arm, np.cross(force, theta))
        gradient[6 * i + 3 : 6 * i + 6] -= (turned - np.cross(theta, moment)) / 2.0
    at = assembly.moving
    gradient[at] = _turn(assembly).T @ gradient[at]
    travel = np.zeros(1) if locked else None
    added = assembly.moved(-gradient[:, None], misfits=misfits, travel=travel)
    axial, arms = 0.0, 0.0
    for k, member in enumerate(assembly.members):
        bent = float(member.springs.stiffness[4:].min())  # EI/l
        N = abs(found.forces[6 * k, 0]) + abs(added.forces[6 * k, 0])
        axial = max(axial, float(N) * member.l / bent)
        star = assembly.layout.blades[k]
        if isinstance(star, SpaceStar):
            own = found.forces[6 * k : 6 * k + 6, 0]
            arms = max(arms, star.arms_bent_by(member.l, own))
    return SecondOrder(
        added.coordinates[:, 0],
        added.forces[:, 0],
        np.array([blade.inside() for blade in blades]),
        max(blade.rotation for blade in blades),
        axial,
        softening.share(locked=locked),
        arms,
    )


def stiffened_by_loads(
    assembly: SpaceAssembly, found: Moved, loads: tuple[SpaceLoad, ...], along: Floats
) -> float:
    """Return what the forces of a linear state add to the stiffness along a motion.

    To first order in the forces: ``dᵀ K_g d`` with the geometric stiffness K_g of blades and loads,
    of the coordinates d that the motion has without them [N/m or N·m/rad].
    """
    softening = _Softening(assembly, _blades(assembly, found), loads)
    matrix = softening.of_coordinates()[: assembly.size, : assembly.size]
    return float(along @ matrix @ along)


class _Softening:
    """What forces at rest make softer: second derivatives of the energy at constant forces.

    In the coordinates of the bodies, along the axes of the drawing, and in the inner shapes of the
    blades of constant thickness.
    """

    def __init__(
        self, assembly: SpaceAssembly, blades: list["_Quadratic"], loads: tuple[SpaceLoad, ...]
    ) -> None:
        self.assembly, self.bodies = assembly, assembly.size
        size = self.bodies + INNER * len(blades)
        self.matrix = np.zeros((size, size))
        self.root = np.zeros(size - self.bodies)
        for k, blade in enumerate(blades):
            self._add(blade, k)
        for load in loads:
            i = assembly.layout.index(load.body)
            arm = np.subtract(load.point, _point(assembly, i))
            self._turn(i, arm, np.asarray(load.force))

    def _add(self, blade: "_Quadratic", k: int) -> None:
        """Add what the springs' forces of a blade do."""
        inner = self.bodies + INNER * k
        at = [
            np.arange(6 * i, 6 * i + 6) if i is not None else np.full(6, -1) for i in blade.bodies
        ]
        where = np.concatenate([*at, np.arange(inner, inner + INNER)])
        if not blade.is_uniform:
            where[12:] = -1
        kept = where >= 0
        self.matrix[np.ix_(where[kept], where[kept])] += blade.curvature[np.ix_(kept, kept)]
        stiffness = self.assembly.members[k].springs.stiffness[3:, None] * INNER_STIFFNESS
        self.root[INNER * k : INNER * (k + 1)] = 1.0 / np.sqrt(stiffness.ravel())

    def _turn(self, i: int, arm: Floats, force: Floats) -> None:
        """Add what a force that keeps its direction does on a lever that turns with a body."""
        turns, lever = slice(6 * i + 3, 6 * i + 6), np.outer(arm, force)
        self.matrix[turns, turns] += (arm @ force) * np.eye(3) - (lever + lever.T) / 2.0

    def share(self, *, locked: bool) -> float:
        """Return the share of the forces at which a direction loses its stiffness."""
        root = _block_diagonal(self.assembly.compliance_root(locked=locked), np.diag(self.root))
        return max(float(np.linalg.eigvalsh(-root @ self.of_coordinates() @ root.T)[-1]), 0.0)

    def of_coordinates(self) -> Floats:
        """Return the matrix in the coordinates of the assembly, the inner shapes after them."""
        at, turned = self.assembly.moving, _turn(self.assembly)
        found = self.matrix.copy()
        found[at] = turned.T @ found[at]
        found[:, at] = found[:, at] @ turned
        return found


def _cross_matrix(a: Floats) -> Floats:
    """Return the matrix that takes b to a × b."""
    return np.cross(a, np.eye(3), axisb=0, axisc=0)


def _point(assembly: SpaceAssembly, body: int) -> Floats:
    """Return the point of a body whose motion its coordinates are: that of the drive."""
    drive = assembly.layout.drive
    bodies = assembly.layout.bodies
    return np.asarray(drive.point if bodies[body].name == drive.body else bodies[body].point)


def _turn(assembly: SpaceAssembly) -> Floats:
    """Return the matrix from the moving body's coordinates to its motion along the drawing."""
    found = np.zeros((6, 6))
    found[:3, :3] = found[3:, 3:] = assembly.to_body[:3, :3]
    return found


def _of_body(assembly: SpaceAssembly, q: Floats, body: int) -> Floats:
    """Return the motion of a body's point along the axes of the drawing."""
    own = q[6 * body : 6 * body + 6]
    moving = 6 * body == assembly.moving.start
    return np.asarray(_turn(assembly) @ own if moving else own)


def _blades(
    assembly: SpaceAssembly,
    found: Moved,
    warmth: float = 0.0,
    missed: MissedSeat | None = None,
) -> list["_Quadratic"]:
    """Return the blades in a linear state, of one column."""
    q = found.coordinates[:, 0]
    motions = [_of_body(assembly, q, i) for i in range(len(assembly.layout.bodies))]
    forces = found.forces[: 6 * len(assembly.members), 0].reshape(-1, 6)  # springs follow
    offsets: list[Floats | None] = [None] * len(forces)
    if missed is not None:
        offsets[missed.blade] = missed.offset
    return [
        _Quadratic(assembly, k, motions, own, warmth, off)
        for k, (own, off) in enumerate(zip(forces, offsets, strict=True))
    ]


class _Quadratic:
    """The second-order deformation of a blade's springs, and its energy at their forces.

    ``value`` are the deformations (6,), ``gradient`` the derivative of their energy in the motions
    of the two bodies (12,), ``curvature`` its second derivatives, the inner shapes after them.
    """

    def __init__(
        self,
        assembly: SpaceAssembly,
        k: int,
        motions: list[Floats],
        forces: Floats,
        warmth: float,
        offset: Floats | None,
    ) -> None:
        blade, member = assembly.layout.blades[k], assembly.members[k]
        names = [body.name for body in assembly.layout.bodies]
        self.l, self.forces = member.l, forces
        self.is_uniform = isinstance(blade, SpaceRod) or isinstance(blade.profile, Constant)
        if isinstance(blade, SpaceRod):
            self.gyration = 2.0 * blade.bent / blade.area
        else:
            h = float(blade.profile.h) if isinstance(blade.profile, Constant) else 0.0
            self.gyration = (blade.b**2 + h**2) / 12.0
        self.bodies: list[int | None] = []
        self.arms: list[Floats] = []
        d = np.zeros(12)
        turn = motion_along(member.axes)
        place = np.zeros((12, 12))
        for end, (name, point) in enumerate(
            ((blade.first, blade.start), (blade.second, blade.end))
        ):
            i = names.index(name) if name in names else None
            self.bodies.append(i)
            at = slice(6 * end, 6 * end + 6)
            arm = np.subtract(point, _point(assembly, i)) if i is not None else np.zeros(3)
            self.arms.append((member.axes @ arm)[:, None])
            place[at, at] = turn @ motion_at(arm)
            if i is not None:
                d[at] = place[at, at] @ motions[i]
        if warmth:
            for first, seat in zip((0, 6), grown_ends(assembly.layout, blade), strict=True):
                d[first : first + 3] += warmth * (member.axes @ seat)
        self.to_springs = deformation_rows(member.springs, np.array([self.l, 0.0, 0.0]))
        carried = np.zeros((6, 12))
        if offset is not None:
            # a body that turns by θ turns an offset u, φ of a seat on it: θ × u, ½ θ × φ
            off = turn @ offset
            carried[:3, 9:] = -_cross_matrix(off[:3])
            carried[3:, 9:] = -_cross_matrix(off[3:]) / 2.0
            of_body, d[6:] = d.copy(), d[6:] + off
        else:
            of_body = d
        carried = self.to_springs @ carried
        self.value = self._of(d[:, None])[:, 0] + carried @ of_body
        curved = self._curvature()
        self.gradient = place.T @ (curved[:12, :12] @ d + carried.T @ forces)
        to_bodies = _block_diagonal(place, np.eye(INNER))
        self.curvature = to_bodies.T @ curved @ to_bodies
        along = _cross(d[3:6], np.array([self.l, 0.0, 0.0]))
        self.local = np.concatenate([d[6:9] - d[:3] - along, d[9:12] - d[3:6]])
        chord = (d[7:9] - d[1:3]) / self.l
        against = [np.array([chord[0] - t[2], chord[1] + t[1]]) for t in (d[3:6], d[9:12])]
        each = [d[9:12] - d[3:6], *against]
        self.rotation = max(float(np.linalg.norm(angle)) for angle in each)

    def _curvature(self) -> Floats:
        """Return the second derivatives of ``Σ s·e_2`` at the forces s in the ends' motions.

        After these twelve come the inner shapes.
        """
        two, found = self.forces @ self._of(PAIRS[:12], PAIRS[12:]), np.zeros((12 + INNER,) * 2)
        found[ROW, COLUMN] = two
        one = np.diagonal(found) / 4.0
        found[ROW, COLUMN] = found[COLUMN, ROW] = two - one[ROW] - one[COLUMN]
        return found

    def inside(self) -> Floats:
        """Return the moments along the blade that its ends do not feel (3, places) [N·m].

        ``ΔM = (r_end − r) × n − θ × M``, without its mean, and in bending without what is linear
        along the blade: those are in the springs' forces.
        """
        forces = self.forces
        l, n = self.l, forces[:3, None]
        xi = PLACES
        first, turned = self.local[:3], self.local[3:]
        rise, sink = 3.0 * xi**2 - 2.0 * xi**3, (xi**3 - xi**2) * l
        rise_, sink_ = (6.0 * xi - 6.0 * xi**2) / l, 3.0 * xi**2 - 2.0 * xi
        r = np.stack(
            [first[0] * xi, rise * first[1] + sink * turned[2], rise * first[2] - sink * turned[1]]
        )
        theta = np.stack(
            [
                xi * turned[0],
                -(rise_ * first[2] - sink_ * turned[1]),
                rise_ * first[1] + sink_ * turned[2],
            ]
        )
        arm = (0.5 - xi) * l
        M = np.stack(
            [forces[3] + 0.0 * xi, forces[4] - forces[2] * arm, forces[5] + forces[1] * arm]
        )
        found = _cross(r[:, -1:] - r, n) - _cross(theta, M)
        found[0] -= found[0].mean()
        found[1:] = found[1:] @ NOT_STRAIGHT
        return found

    def _of(self, d: Floats, inner: Floats | None = None) -> Floats:
        """Return the second-order deformations (6, columns) of ends' motions (12, columns).

        ``inner`` (6, columns) are shares of the inner shapes: twist [rad], and bending about y and
        about z over the length.
        """
        l = self.l
        u_i, t_i, u_j, t_j = (d[3 * n : 3 * n + 3] for n in range(4))
        along = np.array([[l], [0.0], [0.0]])
        apart = u_j - u_i
        first = apart - _cross(t_i, along)
        turned = t_j - t_i
        # what finite rotations of the bodies add, in the frame of the blade's start
        shift = (
            _cross(t_j, _cross(t_j, self.arms[1])) - _cross(t_i, _cross(t_i, self.arms[0]))
        ) / 2.0
        shift = shift - _cross(t_i, apart) + _cross(t_i, _cross(t_i, along)) / 2.0
        turn = -_cross(t_i, t_j) / 2.0
        # the blade's own rotations (6 nodes) as the linear solution bends it
        xi = NODES[:, None]
        rise, sink = (6.0 * xi - 6.0 * xi**2) / l, 3.0 * xi**2 - 2.0 * xi
        rise_, sink_ = (6.0 - 12.0 * xi) / l**2, (6.0 * xi - 2.0) / l
        theta = _rows(
            xi * turned[0],
            -(rise * first[2] - sink * turned[1]),
            rise * first[1] + sink * turned[2],
        )
        rate = _rows(
            np.ones_like(xi) * turned[0] / l,
            -(rise_ * first[2] - sink_ * turned[1]),
            rise_ * first[1] + sink_ * turned[2],
        )
        w = (WEIGHTS * l)[:, None]
        if inner is not None:
            twist, about_y, about_z = inner[:2], inner[2:4], inner[4:]
            theta += _rows(TWIST @ twist, -BEND_SLOPE @ about_y, BEND_SLOPE @ about_z)
            rate += _rows(TWIST_RATE @ twist, -BEND_RATE @ about_y, BEND_RATE @ about_z) / l
        spin = _cross(theta, rate) / 2.0
        # ∫₀ˡ∫₀ˢ f = ∫ (l − s) f
        twice = (l * (1.0 - xi)) * w * spin
        turn = turn - (w * spin).sum(axis=1)
        stretch = (w * (theta[1] ** 2 + theta[2] ** 2)).sum(axis=0) / 2.0
        stretch = stretch + self.gyration * (w * rate[0] ** 2).sum(axis=0) / 2.0
        across = -twice[2].sum(axis=0) - (w * theta[0] * theta[1]).sum(axis=0) / 2.0
        aside = twice[1].sum(axis=0) - (w * theta[0] * theta[2]).sum(axis=0) / 2.0
        shift = shift + _rows(stretch, across, aside)
        return np.asarray(self.to_springs @ np.concatenate([shift, turn]))


def _cross(a: Floats, b: Floats) -> Floats:
    # np.cross spends most of its time on its axes, and this is called for every blade and step
    (a_x, a_y, a_z), (b_x, b_y, b_z) = a, b
    return _rows(a_y * b_z - a_z * b_y, a_z * b_x - a_x * b_z, a_x * b_y - a_y * b_x)


def _rows(x: Floats, y: Floats, z: Floats) -> Floats:
    """Return three components of one shape as an array; np.stack looks at them for longer."""
    found = np.empty((3, *x.shape))
    found[0], found[1], found[2] = x, y, z
    return found


def _block_diagonal(one: Floats, other: Floats) -> Floats:
    """Return a matrix of two blocks (without scipy, whose import takes as long as many checks)."""
    rows, columns = one.shape
    found = np.zeros((rows + other.shape[0], columns + other.shape[1]))
    found[:rows, :columns], found[rows:, columns:] = one, other
    return found
