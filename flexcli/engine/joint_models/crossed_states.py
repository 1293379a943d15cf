"""Small motions of an unseparated cross in the states of a case, as a solid and as beams.

Both are told by the compliance of the body, and by what each arm bears under unit loads on it.
"""

from collections.abc import Sequence
from dataclasses import replace
from math import atan2, cos, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.joint_states import blades_of, of_case
from flexcli.errors import SolveError
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.linear import linear
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.solids.crossed_joint import crossed_aside, crossed_joint
from flexcli.mechanics.space.layout import SpaceBlade, SpaceLayout
from flexcli.mechanics.space.springs import MemberSprings, springs_of
from flexcli.numerics.rows import number, one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask
from flexcli.parts.space_joint import joint_in_space

__all__ = ["Arms", "CrossedSmall", "beams_of", "in_space", "small_states", "solid_of"]

Floats = NDArray[np.float64]

X, Y, TURN = range(3)


class CrossedSmall(NamedTuple):
    """A cross in small motion, along its bisector and about its centre [m, m, rad; N, N, N·m].

    ``compliance`` (3, 3) with ``off``, and what arms ``borne`` by unit loads (3, 2, 2, 3), as
    :meth:`flexcli.mechanics.solids.crossed.CrossedSolid.borne` has it, with ``unsure``. ``shift``
    is the range of the shift of second order in the rotation, towards the base [m/rad²].
    """

    compliance: Floats
    off: Floats
    borne: Floats
    unsure: Floats
    shift: tuple[float, float]

    @property
    def coupled(self) -> tuple[float, float]:
        """Return the motion along y over the rotation by a moment, and its error [m/rad]."""
        turn = self.compliance[TURN, TURN]
        return float(self.compliance[Y, TURN] / turn), float(self.off[Y, TURN] / turn)


def solid_of(ask: Ask) -> CrossedSmall:
    """Return the cross as a solid between rigid bodies.

    Raises
    ------
    NotAvailable
        Where there is no such solid.

    """
    one_alone()
    elastic, cross = ask.material.elastic, ask.geometry.solid_cross(ask.sizes)
    if elastic.nu is None:
        raise NotAvailable("has no solid without a Poisson's ratio")
    h, l, b = cross.h, cross.l, cross.b
    try:
        found = crossed_joint(h / l, b / l, cross.crossing, cross.half_angle, number(elastic.nu))
    except SolveError as failed:
        raise NotAvailable(f"has no solid: {failed}") from failed
    E = number(elastic.E)
    unit = np.array([1.0, 1.0, 1.0 / l])  # of a motion over that of l = 1, by loads of as much
    diagonal = found.diagonal.value / (E * l) * unit**2
    compliance, off = np.diag(diagonal), np.diag(found.diagonal.off / (E * l) * unit**2)
    turn, l_ = diagonal[TURN], found.coupled
    compliance[Y, TURN] = compliance[TURN, Y] = float(l_.value) * l * turn
    off[Y, TURN] = off[TURN, Y] = float(l_.off) * l * turn
    levers = np.array([1.0, 1.0, l])
    scale = levers / levers[:, None, None, None]
    least, most = found.shift
    return CrossedSmall(
        compliance, off, found.borne.value * scale, found.borne.off * scale, (least * l, most * l)
    )


def in_space(ask: Ask, small: CrossedSmall) -> tuple[SpaceLayout, tuple[MemberSprings, ...]]:
    """Return the cross as one member between its bodies, its springs where nothing is coupled.

    Of what is coupled the place of a spring may be off: its springs are unsure by as much.
    """
    cross, elastic = ask.geometry.solid_cross(ask.sizes), ask.material.elastic
    h, l, b, nu = cross.h, cross.l, cross.b, number(elastic.most_nu)
    try:
        aside = crossed_aside(h / l, b / l, cross.crossing, cross.half_angle, nu)
    except SolveError as failed:
        raise NotAvailable(f"has no solid: {failed}") from failed
    unit = np.array([1.0, 1.0 / l, 1.0 / l]) ** 2 / (number(elastic.E) * l)
    (zz, about_x, about_y), (off_z, off_x, off_y) = (each * unit for each in aside.diagonal)
    width, off_width = (float(each) * l for each in aside.coupled)
    xx, yy, turn = small.compliance.diagonal()
    off_xx, off_yy, off_turn = small.off.diagonal()
    coupled, off_coupled = small.coupled
    # at its own place a spring bears nothing of the moment
    C = np.array([xx, yy - coupled**2 * turn, zz - width**2 * about_y, about_x, about_y, turn])
    off = np.array([off_xx, off_yy, off_z, off_x, off_y, off_turn]) / C
    for moved, place, at, by in ((1, off_coupled, 5, turn), (2, off_width, 4, about_y)):
        share = place * (by / C[moved]) ** 0.5
        off[[moved, at]] += share + share**2
    if np.any(off >= 1.0):
        raise NotAvailable("has no solid: too few digits are left of one so slender")
    layout = joint_in_space(ask.geometry, ask.material, ask.sizes).layout
    first = layout.blades[0]
    assert isinstance(first, SpaceBlade)  # of the plane
    start, along = np.array(first.start), np.array(first.end) - np.array(first.start)
    angle = atan2(along[1], along[0]) - cross.half_angle
    ahead = np.array([cos(angle), sin(angle), 0.0])
    base, body = cross.crossing * l * cos(cross.half_angle), l * cos(cross.half_angle)
    centre = start + cross.crossing * along / np.linalg.norm(along) * l
    ends = centre - base * ahead, centre + (body - base) * ahead
    (x, y, z), (u, v, w) = (tuple(map(float, end)) for end in ends)
    whole = replace(
        first, name="joint", first=first.first, second=MOVING, start=(x, y, z), end=(u, v, w),
        crossed=(1.0, 1.0), shared=(0.0, 0.0),
    )  # fmt: skip
    member = springs_of(whole)
    springs = member.springs._replace(
        stiffness=1.0 / C,
        across_thickness=np.asarray(base - coupled),
        across_width=np.asarray(base + width),
    )
    error = off / (1.0 - off)
    member = MemberSprings(springs, -error, error, member.axes, member.l, member.constrains)
    bodies = tuple(each for each in layout.bodies if each.name == MOVING)
    return replace(layout, bodies=bodies, blades=(whole,)), (member,)


def beams_of(ask: Ask, effects: Effects) -> CrossedSmall:
    """Return the cross as four beams that meet in a point, but for its shift."""
    layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
    one, none = np.eye(3), np.zeros((3, 3))
    unit = Load(MOVING, (0.0, 0.0), (one[0], one[1]), one[2])
    found = linear(layout, {}, loads=[unit], effects=blades_of(layout, effects))
    borne = np.zeros((3, 2, 2, 3))
    for index, blade in enumerate(layout.blades):
        fx, fy, moment = found.end_forces[:, index].T
        x, y = (float(end) for end in blade.end)
        about = moment + x * fy - y * fx
        # the outer end of an arm towards the base is its start, and bears what its end does not
        sense = 1.0 if index % 2 else -1.0
        outer = blade.end if index % 2 else blade.start
        c, s = np.asarray(outer, dtype=np.float64).ravel() / np.hypot(*outer)
        at = index // 2, 0 if index % 2 else 1
        force = np.stack([fx * c + fy * s, fy * c - fx * s, about], axis=-1)
        borne[:, *at] = sense * force
    C = found.motions[:, layout.index(MOVING)]
    return CrossedSmall((C + C.T) / 2.0, none, borne, np.zeros_like(borne), (0.0, 0.0))


class Arms(NamedTuple):
    """What arms bear in each state (states, 2, 2, 3), and what may be off of it.

    ``swing_unsure`` (pairs, 2, 2, 3) is what may be off of half of what changes between the states
    of a pair, both ends of a stroke.
    """

    borne: Floats
    unsure: Floats
    swing_unsure: Floats


class _Moved(NamedTuple):
    """Motions of the bodies (states, bodies, 3), and the wrench on the moving one about the centre.

    The wrench (states, 3) is along the bisector and across it; ``spread`` (3, 3) times its parts is
    what it may be off by.
    """

    motions: Floats
    wrench: Floats
    spread: Floats


def small_states(ask: Ask, cross: CrossedSmall) -> Arms:
    """Return what arms bear in the states of a case by small motion, of loads on the body alone."""

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> _Moved:
        return _moved(ask, cross, layout, held, loads)

    found = of_case(ask, solver)

    def unsure(wrench: Floats) -> Floats:
        parts = np.abs(wrench)
        own = np.einsum("nk,kabc->nabc", parts, cross.unsure)
        spread = np.einsum("nk,kabc->nabc", parts @ found.spread, np.abs(cross.borne))
        return np.asarray(own + spread)

    wrench = found.wrench
    swings = (wrench[::2] - wrench[1::2]) / 2.0 if ask.scene.moves else np.zeros_like(wrench)
    borne = np.einsum("nk,kabc->nabc", wrench, cross.borne)
    return Arms(borne, unsure(wrench), unsure(swings))


def _moved(
    ask: Ask, cross: CrossedSmall, layout: Layout, held: Held, loads: Sequence[Load]
) -> _Moved:
    """Return a small motion of a cross that is turned as a layout is, held and loaded so."""
    start, end = (np.ravel(each) for each in (layout.blades[0].start, layout.blades[0].end))
    angle = atan2(*(end - start)[::-1]) - ask.geometry.solid_cross(ask.sizes).half_angle
    c, s = cos(angle), sin(angle)
    turn = np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])
    C, off = turn @ cross.compliance @ turn.T, np.abs(turn) @ cross.off @ np.abs(turn.T)
    acting = [load for load in loads if load.body == MOVING]
    given = {axis: each for axis, each in enumerate(held[MOVING]) if each is not None}
    parts = [part for load in acting for part in (*load.force, load.moment)]
    shapes = (np.shape(each) for each in (*given.values(), *parts, np.zeros(1)))
    states = np.broadcast_shapes(*shapes)
    wrench, spread = np.zeros((*states, 3)), np.zeros((3, 3))
    for load in acting:
        (x, y), (fx, fy) = load.point, load.force
        for axis, part in enumerate((fx, fy, load.moment + x * fy - y * fx)):
            wrench[:, axis] += part
    if given:
        at, free = np.array(list(given)), np.setdiff1d(np.arange(3), list(given))
        motion = np.stack([np.broadcast_to(each, states) for each in given.values()], axis=-1)
        K = np.linalg.inv(C[np.ix_(at, at)])
        # what loads the body along what is held is borne by what holds it
        wrench[:, at] = (motion - wrench[:, free] @ C[np.ix_(free, at)]) @ K
        spread[:, at] = off[:, at] @ np.abs(K)
    motions = np.zeros((*states, len(layout.bodies), 3))
    motions[:, layout.index(MOVING)] = wrench @ C
    return _Moved(motions, wrench @ turn, np.abs(turn.T) @ spread @ np.abs(turn))
