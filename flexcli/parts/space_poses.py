"""Where small motion to second order takes the bodies of a joint, and how far off it is."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.exact.rotation import moved
from flexcli.mechanics.space.layout import SpaceLayout, SpaceRod, vector
from flexcli.mechanics.space.states import Acting, SpaceState, action, combined
from flexcli.numerics.interpolation import lagrange
from flexcli.parts.scene import Scene
from flexcli.parts.space_joint import SpaceJoint
from flexcli.parts.space_states import (
    KNOWN,
    SOFTENED,
    STIFFENS,
    THIRD,
    bent_by_gradient,
    spring_change,
    third_order,
)

__all__ = [
    "IN_PLANE",
    "Poses",
    "beside_drive",
    "is_flat",
    "origins",
    "poses",
    "rows_of",
    "shifted_by_stretch",
    "still",
    "turned",
]

Floats = NDArray[np.float64]

UNEVEN_STRETCH = 0.15
"""Of l θ², θ the largest rotation of a blade, how much more or less a blade of varying thickness
shortens than a cubic: a hinge in its middle 1/4 − 1/6, hinges at both ends, in S shape, 0.6 − 1/2
of the square of its chord's."""

UNEVEN_AXIAL = 3.0
"""How much more an axial force changes the bending of two hinges at the ends of a blade: by
N l/(2 k) of k each, where a blade that is uniform, k = 2 EI/l in series, has N l²/(12 EI)."""


HALF = 0.5
"""Share of a motion beside the drive by which later orders may change it, up to which they add up
as a geometric series does."""

IN_PLANE = 1e-9
"""Share of a motion that is rounding."""


class Poses(NamedTuple):
    """Shift and rotation vector of every body at some travels, and how far off they may be.

    ``motion`` (travels, bodies, 6) [m, rad] is that at :func:`origins`; ``shift``
    [m] and ``turn`` [rad] (travels, bodies) are in any direction, in the plane alone where the
    motion ``is_flat``. ``axial`` is by what share axial forces change how blades bend, ``warmth``
    the share of the layout's growth; ``is_known`` says that it is known how far off all is.
    """

    motion: Floats
    shift: Floats
    turn: Floats
    is_flat: bool
    axial: float = 0.0
    warmth: float = 0.0
    is_known: bool = True


def still(joint: SpaceJoint) -> Poses:
    """Return the pose at rest."""
    bodies = len(joint.layout.bodies)
    return Poses(np.zeros((1, bodies, 6)), np.zeros((1, bodies)), np.zeros((1, bodies)), True)


def origins(joint: SpaceJoint) -> Floats:
    """Return the points of the bodies by which their poses are told (bodies, 3) [m].

    Of a body that turns that about which it does, by small motion, of others their own.
    """
    layout, assembly = joint.layout, joint.assembly
    found, drive = np.array([body.point for body in layout.bodies]), layout.drive
    if drive.turns:
        unit = assembly.moved(travel=np.ones(1)).coordinates[:, 0]
        shift = (assembly.motion(drive.body, drive.point) @ unit)[:3]
        found[layout.index(drive.body)] = drive.point - np.cross(shift, drive.direction)
    return found


def is_flat(joint: SpaceJoint, motion: Floats) -> bool:
    """Return whether motions (…, bodies, 6) are in the plane of a joint that is its own mirror."""
    if not joint.is_mirrored or joint.layout.grows:
        return False
    length = max(member.l for member in joint.assembly.members)
    size = np.abs(motion) * np.repeat([1.0, length], 3)
    return bool(size[..., 2:5].max() <= IN_PLANE * size.max())


def poses(joint: SpaceJoint, scene: Scene, travels: Floats, loads: SpaceState | None) -> Poses:
    """Return the poses at even travels, the drive locked there, or free without a stroke.

    Parameters
    ----------
    joint : SpaceJoint
        The joint, as its temperature has grown it where ``loads`` are warm.
    scene : Scene
        The case.
    travels : array, shape (travels,)
        From where the loads leave the drive; an odd number, or one without a stroke.
    loads : SpaceState, optional
        The state under loads and temperature.

    Notes
    -----
    The second order is quadratic in the travel. The springs' errors move a point by no more than
    the root of its compliance, times twice their own share of the root of the energy.

    """
    layout, own = joint.layout, joint.layout.index(joint.layout.drive.body)
    unit = _unit(joint) if scene.moves else None
    knots = travels[:: max((len(travels) - 1) // 2, 1)]
    states = []
    for travel in knots:
        parts = [(unit, float(travel)), (loads, 1.0)]
        each = [(state, share) for state, share in parts if state is not None]
        states.append(combined([state for state, _ in each], [share for _, share in each]))
    after = [state.following() for state in states]
    onto, to = lagrange(knots, travels), origins(joint)
    one, two = (
        np.tensordot(onto, np.array([rows_of(joint) @ each for each in columns]), axes=1)
        for columns in ([s.moved.coordinates[:, 0] for s in states], [a.coordinates for a in after])
    )
    # the coordinates are those of the drive's point, about which the origin turns
    arm, phi = to[own] - layout.drive.point, one[:, own, 3:] + two[:, own, 3:]
    two[:, own, :3] += turned(phi, arm) - arm - np.cross(phi, arm)
    motion, warmth = one + two, 0.0 if loads is None else loads.warmth
    for k, body in enumerate(layout.bodies):
        grown = warmth * layout.body_growth.get(body.name, 0.0)
        motion[:, k, :3] += grown * (to[k] - body.point)
    found = Poses(
        motion, np.zeros(motion.shape[:2]), np.zeros(motion.shape[:2]), is_flat(joint, motion),
        max(a.axial for a in after) / STIFFENS * (1.0 if joint.is_uniform else UNEVEN_AXIAL),
        warmth,
    )  # fmt: skip
    changes = [(state, spring_change(joint, state)) for state in (unit, loads) if state is not None]
    springs, buckling = max(share for _, share in changes), max(a.buckling for a in after)
    third = max(map(third_order, after))
    third += 0.0 if joint.is_uniform else found.axial * (1.0 - 1.0 / UNEVEN_AXIAL)
    if springs > KNOWN or third > HALF or buckling > SOFTENED or not joint.is_known:
        return found._replace(is_known=False)
    third /= 1.0 - third
    further = third * np.abs(beside_drive(layout, one, travels))
    further = further + (third + springs + buckling / (1.0 - buckling)) * np.abs(two)
    for state, share in changes:
        root = joint.assembly.compliance_root(locked=state is unit)
        reach = np.linalg.norm(rows_of(joint) @ root.T, axis=-1)  # (bodies, 6)
        energy = float(state.moved.forces[:, 0] @ state.moved.deformations[:, 0])
        size = np.abs(travels) if state is unit else np.ones(len(travels))
        further = further + share * np.sqrt(max(energy, 0.0)) * size[:, None, None] * reach
    most, rotation = float(np.abs(travels).max()), max(a.rotation for a in after)
    grows = (np.abs(travels) / most if loads is None else np.ones(len(travels)))[:, None]
    if not joint.is_uniform:
        stretch = [
            0.0 if isinstance(blade, SpaceRod) or isinstance(blade.profile, Constant) else member.l
            for blade, member in zip(layout.blades, joint.assembly.members, strict=True)
        ]
        shortened = UNEVEN_STRETCH * rotation**2 * np.array(stretch)
        further = further + grows[..., None] ** 2 * shifted_by_stretch(joint, scene, shortened)
    length, floor = max(m.l for m in joint.assembly.members), THIRD * rotation**3 * grows**3
    shift = np.linalg.norm(further[..., :3], axis=-1) + length * floor
    turn = np.linalg.norm(further[..., 3:], axis=-1) + floor
    if loads is None:
        if found.is_flat and layout.drive.turns:
            turn[:, own] = 0.0  # it is held
        return found._replace(shift=shift, turn=turn)
    bent = bent_by_gradient(joint, scene)[1]
    shift, turn = shift + np.linalg.norm(bent[:3]), turn + np.linalg.norm(bent[3:])
    return found._replace(shift=shift, turn=turn)


def beside_drive(layout: SpaceLayout, motion: Floats, travels: Floats) -> Floats:
    """Return motions of bodies (travels, bodies, 6) without that in which the drive holds one."""
    found, own = motion.copy(), layout.index(layout.drive.body)
    driven = slice(3, 6) if layout.drive.turns else slice(0, 3)
    found[:, own, driven] -= travels[:, None] * np.asarray(layout.drive.direction)
    return found


def shifted_by_stretch(joint: SpaceJoint, scene: Scene, stretch: Floats) -> Floats:
    """Return how far stretches of blades (blades,) move bodies at most (bodies, 6) [m, rad].

    That of every blade counts in either sense, the drive locked at a stroke.
    """
    misfits = np.zeros((len(joint.assembly.rows), len(stretch)))
    misfits[6 * np.arange(len(stretch)), np.arange(len(stretch))] = stretch
    travel = np.zeros(len(stretch)) if scene.moves else None
    gone = joint.assembly.moved(misfits=misfits, travel=travel).coordinates
    return np.asarray(np.abs(rows_of(joint) @ gone).sum(axis=-1))


def rows_of(joint: SpaceJoint) -> Floats:
    """Return the motions of the bodies at their origins per coordinate (bodies, 6, coordinates)."""
    each = zip(joint.layout.bodies, map(vector, origins(joint)), strict=True)
    return np.array([joint.assembly.motion(body.name, point) for body, point in each])


def turned(phi: Floats, points: Floats) -> Floats:
    """Return points (…, 3) turned by rotation vectors (…, 3) that broadcast against them."""
    half = np.linalg.norm(phi, axis=-1, keepdims=True) / 2.0
    q = np.concatenate([np.cos(half), phi / 2.0 * np.sinc(half / np.pi)], axis=-1)
    return np.asarray(points + moved(q, points))


def _unit(joint: SpaceJoint) -> SpaceState:
    """Return the state at a travel of one."""
    point = joint.layout.body(joint.layout.drive.body).point
    return action(joint.assembly, Acting(1.0, np.zeros(6), point, np.zeros(3)))
