"""How far loads move a joint in space, and what they and other strains change of that.

Small motion is by the springs, whose errors are those of :mod:`flexcli.formulas.clamped_blade`.
What it leaves out is told by its second order; where that is not small beside the first it is
unknown.
"""

from collections.abc import Iterator, Sequence
from itertools import product
from math import inf
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.plate_flattening import flat_width, secant_factor
from flexcli.formulas.profile import Constant
from flexcli.formulas.rigid_motion import axes_about_z, motion_along
from flexcli.mechanics.layout import Load
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.mechanics.space.layout import SpaceRod
from flexcli.mechanics.space.states import (
    Acting,
    SpaceState,
    action,
    combined,
)
from flexcli.numerics.collocation import gauss_nodes
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements.ask import Ask, Told
from flexcli.parts.scene import IN_PLANE, Scene
from flexcli.parts.space_joint import SpaceJoint, joint_in_space, joint_of
from flexcli.parts.space_states import (
    KNOWN,
    TURNS,
    UNEVEN,
    acting_groups,
    acting_together,
    third_order,
)
from flexcli.results import ErrorRange

__all__ = [
    "BentBeside",
    "bent_beside",
    "beside_wrench",
    "beyond_first_order",
    "beyond_linear_sag",
    "changed_beside",
    "either_way",
    "sag",
    "senses_beside",
    "shares_beside",
]

Floats = NDArray[np.float64]

LATER = 1.05
"""How much larger the orders beyond the first may be than if each were as much of the one before as
the second is of the first: exact beams of three blades under a force across them had 1.01."""

ROUNDING = 1e-9
"""Share of a wrench by which a load beside it is none."""

GIVES_WAY = 8.0
"""Times (φ b/h)², of a blade turned by φ: what it gives way along its width more, 3 E/G."""

COUPLES = 0.75
"""Times φ l/h: the stress that a force along a bent blade has by bending over that along it, 0.6 as
an S, 0.75 as an arc that it bends with a free end."""

TWISTED = 2.0
"""Times φ b/h: the shear √3 of what a force along the width of a bent blade twists it, over its
bending: √3 b/(2 h) of where the force is off over l, and as much again for how it is held."""

SHORTENS = 0.03
"""Times (φ l/h)²: what it gives way along itself more, 12/700 as an S, up to 12/525 as an arc."""

TWIST = 3
"""Spring of a blade that is its twist."""

NODES = 24
"""Gauss nodes along a piece of a blade."""

WHOLE = np.linspace(-1.0, 1.0, 9)[None]
"""Places along a piece of a blade."""


def beside_wrench(ask: Ask) -> list[Acting]:
    """Return what acts on a joint beside the wrench of a case: its load, and accelerations."""
    joint, scene = joint_of(ask), ask.scene
    along = motion_along(axes_about_z(ask.geometry.axes))
    wrench = along.T @ np.array(scene.wrench or np.zeros(6))
    rest = np.array(scene.stated) - wrench
    stated = np.where(np.abs(rest) > ROUNDING * np.abs(wrench).max(initial=0.0), rest, 0.0)
    return acting_groups(joint, scene._replace(stated=tuple(stated.tolist())))


def senses_beside(scene: Scene, groups: Sequence[Acting]) -> Iterator[tuple[float, ...]]:
    """Yield the senses in which groups of loads act at once: a directed load in its own alone."""
    own = ((1.0,) if scene.directed and not g.acceleration.any() else (1.0, -1.0) for g in groups)
    return product(*own)


def either_way(scene: Scene) -> Scene:
    """Return a case whose stated loads have the senses that they have together.

    A wrench acts either way, and so does a directed load beside it in one with it.
    """
    return scene._replace(directed=scene.has_one_sense)


def changed_beside(
    joint: SpaceJoint,
    scene: Scene,
    beside: Sequence[Acting] = (),
    *,
    locked: bool = False,
    driven: bool = False,
) -> ErrorRange | None:
    """Return by what share of itself what strains a joint changes a compliance at most.

    That is a temperature, and loads ``beside`` those that are asked about. Their forces make any
    stiffness of straight blades and bodies as much less as the share that they are of those which
    turn them aside, and as much more as they are of these reversed: the largest changes of the
    stiffness of bodies that move anywhere. How far they twist blades counts besides, by its square,
    as these bend in part across their width then; and how far they turn them, as bent blades give
    way along their width by twisting, and along themselves by bending: but for a motion along the
    drive that a load along it causes, ``driven``. The drive is ``locked`` or free.

    Returns
    -------
    range : ErrorRange or None
        Nothing where it is not small.

    """
    softer, stiffer = shares_beside(joint, scene, beside, locked=locked, driven=driven)
    if max(softer, stiffer) > KNOWN:
        return None
    return ErrorRange(1.0 / (1.0 + stiffer) - 1.0, 1.0 / (1.0 - softer) - 1.0)


def shares_beside(
    joint: SpaceJoint,
    scene: Scene,
    beside: Sequence[Acting] = (),
    *,
    locked: bool = False,
    driven: bool = False,
) -> tuple[float, float]:
    """Return the largest shares by which what strains a joint softens and stiffens it.

    As :func:`changed_beside` tells; one of 1 of softening buckles straight blades and bodies.
    """
    times, softer, stiffer = 1.0 if joint.is_uniform else UNEVEN, 0.0, 0.0
    if not (joint.layout.grows or beside):
        return softer, stiffer
    for both in acting_together(joint, beside, senses_beside(scene, beside), locked=locked):
        after, reversed_ = (combined([both], [sense]).following() for sense in (1.0, -1.0))
        given_way = 0.0 if driven else _given_way(joint, after.rotation)
        turned = max(TURNS * float(np.abs(both.bent[:, TWIST]).max()) ** 2, given_way)
        softer = max(softer, times * after.buckling + turned)
        stiffer = max(stiffer, times * reversed_.buckling + turned)
    return softer, stiffer


class BentBeside(NamedTuple):
    """What blades that stand bent give way more along them and their width, and are stressed more.

    ``softer`` is a share of a compliance, ``stressed`` of the stress of a force along them [-].
    """

    softer: float
    stressed: float


def bent_beside(
    joint: SpaceJoint,
    scene: Scene,
    more: float = 0.0,
    *,
    in_plane: bool = False,
    across: bool = False,
) -> BentBeside:
    """Return what bends the blades of a joint changes of small motion: stroke and static loads.

    ``more`` is a travel besides, in either sense [m or rad]; ``in_plane`` nothing gives way along
    the width of blades, and ``across`` forces act along that alone. As if each blade were turned
    by as much as the most turned one, and as slender as the most slender where it bends.
    """
    rest = Acting(0.0, np.zeros(6), joint.layout.body(joint.layout.drive.body).point, np.zeros(3))

    def moved(travel: float) -> SpaceState:
        return action(joint.assembly, rest._replace(travel=travel))

    groups, turn = acting_groups(joint, scene), 0.0
    loads = [action(joint.assembly, each) for each in groups]
    for travel in scene.stroke_ends if scene.moves else (0.0,):
        for signs in senses_beside(scene, groups):
            both = combined([moved(float(travel)), *loads], [1.0, *signs])
            turn = max(turn, both.following().rotation)
    turn += moved(more).following().rotation if more else 0.0
    slender = (
        share * l / (h if in_plane else min(h, b))
        for share, (h, b, l) in zip(_bending_shares(joint), _sections(joint), strict=True)
    )
    bowed = turn * max(slender)
    softer = SHORTENS * bowed**2 if in_plane else _given_way(joint, turn)
    if across:
        wide = max(max(b / h, h / b) for h, b, _ in _sections(joint))
        return BentBeside(softer, TWISTED * turn * wide)
    return BentBeside(softer, COUPLES * bowed)


def _given_way(joint: SpaceJoint, turn: float) -> float:
    """Return by what share more blades that are turned give way along their width and length."""
    return max(
        max(GIVES_WAY * (max(b / h, h / b) * turn) ** 2, SHORTENS * (l / min(h, b) * turn) ** 2)
        for h, b, l in _sections(joint)
    )


def _bending_shares(joint: SpaceJoint) -> Iterator[float]:
    """Yield which share of its length each blade bends over, as if it were as thin throughout."""
    nodes, weights = gauss_nodes(NODES)
    for blade, member in zip(joint.layout.blades, joint.assembly.members, strict=True):
        if isinstance(blade, SpaceRod):
            yield 1.0
            continue
        pieces = blade.profile.pieces(member.l)
        each = [(np.ravel(p.thickness(nodes)), np.ravel(p.slope(nodes))) for p in pieces]
        thin = min(float(h.min()) for h, _ in each)
        yield sum(float(np.sum(weights * ds * (thin / h) ** 3)) for h, ds in each) / member.l


def _sections(joint: SpaceJoint) -> Iterator[tuple[float, float, float]]:
    """Yield the least thickness, the width and the length of each blade."""
    for blade, member in zip(joint.layout.blades, joint.assembly.members, strict=True):
        if isinstance(blade, SpaceRod):
            yield blade.d, blade.d, member.l
            continue
        pieces = blade.profile.pieces(member.l)
        yield min(float(np.min(p.thickness(WHOLE))) for p in pieces), blade.b, member.l


def sag(joint: SpaceJoint, scene: Scene) -> Told:
    """Return the sag of the moving body's point along a steady acceleration [m].

    What a temperature and stated loads strain is in its error.
    """
    beside = acting_groups(joint, scene._replace(inertial=(), accelerations=()))
    body = joint.layout.body(joint.layout.drive.body)
    along = np.array([float(axis == scene.axis) for axis in "xyz"])
    acting = Acting(0.0, np.zeros(6), body.point, scene.acceleration * along)
    state = action(joint.assembly, acting)
    row = along @ joint.assembly.motion(body.name, body.point)[:3]
    found = float(row @ state.moved.coordinates[:, 0])
    if found == 0.0:
        return Told(found, None)
    # a body that hangs may stand as well: an acceleration acts either way
    more = max(_second_share(each, row) for each in (state, combined([state], [-1.0])))
    if more > KNOWN:
        return Told(found, None)
    answer = joint.assembly.moved(row[:, None]).deformations[:, 0]
    error, heat = (
        joint.form(answer, state.moved.deformations[:, 0]).error,
        changed_beside(joint, either_way(scene), beside),
    )
    if error is None or heat is None:
        return Told(found, None)
    return Told(found, error + heat + ErrorRange(-more, more))


def beyond_first_order(ask: Ask, moved: Floats, sought: Floats, load: Floats) -> float | None:
    """Return the relative change of a deflection at rest beyond first order.

    Parameters
    ----------
    ask : Ask
        The joint, without a stroke.
    moved, load : array
        Motion (6,) [m, rad] of the moving body's point to first order, and the wrench there (6,)
        [N, N·m], along the axes of cases.
    sought : array
        Row (6,) that takes the motion to the deflection.

    Returns
    -------
    share : float or None
        Nothing where it is not small, so that no order tells it.

    Notes
    -----
    The second order where it is known, of blades of constant thickness; else 1/(1 − s) of the
    share s of the wrench at which straight blades buckle in the plane, whichever way it acts, or
    half as much again as that second order, as what loads in other directions move along it is of
    its kind; and the square of the rotation of the body, or of the chord of its blades, and, beside
    a guide, of the share of loads out of the plane that turns its blades aside. Besides, what
    curvature keeps flat of even blades, stiffer by up to 1/(1 − ν²).

    """
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    first = float(sought @ moved)
    if first == 0.0:
        return None
    along = motion_along(axes_about_z(ask.geometry.axes))
    body = joint.layout.body(joint.layout.drive.body)
    state = action(joint.assembly, Acting(0.0, along.T @ load, body.point, np.zeros(3)))
    share = 0.0
    if not ask.geometry.is_guided and not joint.layout.springs:
        row = sought @ along @ joint.assembly.motion(body.name, body.point)
        either = (state, combined([state], [-1.0]))  # a wrench acts either way
        share = max(_second_share(each, row) for each in either)
    if not joint.is_uniform or ask.geometry.is_guided or joint.layout.springs:
        try:
            share = max(UNEVEN * share, _share_of_buckling(ask, load))
        except NotAvailable:  # not in a plane
            return None
        least = min(member.l for member in joint.assembly.members)
        chord = float(np.linalg.norm(moved[:3])) / least
        share += TURNS * max(float(moved[3:] @ moved[3:]), chord**2)
    if ask.geometry.is_guided:
        across = np.where(np.isin(np.arange(6), IN_PLANE), 0.0, load)
        aside = action(joint.assembly, Acting(0.0, along.T @ across, body.point, np.zeros(3)))
        # of a strip that a force along its width nearly turns aside; a guide lets it bear more
        share += aside.following().buckling ** 2
    more = _amplified(share)
    return None if more is None else more + _flattened(state)


def _flattened(state: SpaceState) -> float:
    """Return by what share curvature keeps sections flat at most, which stiffens wide blades.

    As the moment at the largest curvature of each even blade does, by strips that nothing else
    keeps flat (:mod:`flexcli.formulas.plate_flattening`). Without a guide it bends by more.
    """
    most = 0.0
    for k, (blade, member) in enumerate(
        zip(state.assembly.layout.blades, state.assembly.members, strict=True)
    ):
        if isinstance(blade, SpaceRod) or not isinstance(blade.profile, Constant):
            continue
        force = np.abs(state.moved.forces[6 * k : 6 * k + 6, 0])
        curvature = (force[5] + force[1] * member.l / 2.0) / (
            member.springs.stiffness[5] * member.l
        )
        nu = blade.material.nu
        beta = flat_width(
            b=blade.b, h=float(blade.profile.h), curvature=float(curvature), poisson_ratio=nu
        )
        most = max(most, float(secant_factor(beta=beta, poisson_ratio=nu)) - 1.0)
    return most


def beyond_linear_sag(ask: Ask) -> float | None:
    """Return the relative change of the sag of a joint beyond its linear value.

    Returns
    -------
    share : float or None
        Nothing where it is not small, or where what the body weighs nearly buckles its blades or
        turns it over: the acceleration acts either way.

    """
    scene = ask.scene
    try:
        joint = joint_in_space(ask.geometry, ask.material, ask.sizes)
    except NotAvailable:  # no shear modulus, or no blades
        return None
    body = joint.layout.body(joint.layout.drive.body)
    along = motion_along(axes_about_z(ask.geometry.axes))
    row = along["xyz".index(scene.axis)] @ joint.assembly.motion(body.name, body.point)
    still = scene._replace(stated=(0.0,) * 6)
    groups = [action(joint.assembly, each) for each in acting_groups(joint, still)]
    states = [combined([state], [sense]) for state in groups for sense in (1.0, -1.0)]
    if joint.is_uniform and not ask.geometry.is_guided:
        return _amplified(max((_second_share(state, row) for state in states), default=0.0))
    load = sum((np.array(wrench) for wrench in scene.inertial), np.zeros(6))
    try:
        share = _share_of_buckling(ask, load)
    except NotAvailable:  # not in a plane
        return None
    for state in [] if ask.geometry.is_guided else states:
        after = state.following()
        share = max(share, after.buckling) + TURNS * after.rotation**2
    return _amplified(share)


def _second_share(state: SpaceState, row: Floats) -> float:
    """Return the second and further orders of a motion, over its first order.

    What moves across it in second order, as a blade that a torque turns does under a force along
    its width, comes back to it in third: the force along the motion does twice the energy of that
    more work at most.
    """
    after, first = state.following(), float(row @ state.moved.coordinates[:, 0])
    if first == 0.0:
        return 0.0
    strained = state.assembly.rows @ after.coordinates
    energy = float(state.assembly.stiffness @ strained**2)
    loads = state.assembly.rows.T @ state.moved.forces[:, 0]
    along = abs(float(row @ loads) * first) / float(row @ row)
    work = along or float(loads @ state.moved.coordinates[:, 0])
    back = 2.0 * energy / work if work > 0.0 else inf
    return third_order(after) + abs(float(row @ after.coordinates) / first) + back


def _amplified(share: float) -> float | None:
    """Return s/(1 − s), the sum of all orders where the second is s times the first, with room."""
    return LATER * share / (1.0 - share) if share <= KNOWN else None


def _share_of_buckling(ask: Ask, load: Floats) -> float:
    """Return a wrench over that at which straight blades buckle, in either sense [-].

    Blades narrower than thick are taken to buckle across their width.
    """
    layout = ask.geometry.plane_layout(ask.material.elastic, ask.sizes)
    x, y, _ = motion_along(axes_about_z(-ask.geometry.axes))[:3, :3] @ load[:3]
    held = {MOVING: (None, None, 0.0 if ask.geometry.is_guided else None)}
    point, least = layout.body(MOVING).point, inf
    for sign in (1.0, -1.0):
        push = Load(MOVING, point, (sign * float(x), sign * float(y)), sign * float(load[5]))
        try:
            least = min(least, linear_critical(layout, held, [push]).factor)
        except SolveError:
            continue
    narrow = max((h / b for _, h, b in ask.geometry.sections(ask.sizes)), default=1.0)
    return max(1.0, float(narrow) ** 2) / least
