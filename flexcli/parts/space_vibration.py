"""A mechanism in space as a vibrating structure, with variants within its uncertainty.

Stresses are von Mises': of a random response the root mean square is that of the normal stress
and of √3 times the shear together, at every place of a blade.
"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.rigid_motion import axes_about_z, motion_along
from flexcli.mechanics.layout import Body
from flexcli.mechanics.space.layout import SpaceBody, SpaceLayout, SpaceLoad
from flexcli.mechanics.space.linear import Moved, SpaceAssembly
from flexcli.mechanics.space.modes import own_blade_frequency
from flexcli.mechanics.space.states import BladeStress, SpaceState, Stresses, combined
from flexcli.mechanics.space.vibrating import vibrating
from flexcli.numerics.modes import natural_modes
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.own_motion import DENSEST
from flexcli.parts.space_joint import RIGID, SpaceJoint, on_pivots
from flexcli.parts.space_states import state_error
from flexcli.parts.structure import Structure, joined, largest_of
from flexcli.results import ErrorRange

__all__ = [
    "DIRECTIONS",
    "Likely",
    "likely_structures",
    "shape_error",
    "space_structure",
    "stated_tilt",
]

Floats = NDArray[np.float64]

DIRECTIONS = ("x", "y", "z", "theta_x", "theta_y", "theta_z")

GYRATIONS = (0.1, 0.0, 0.2, 0.35, 0.6, 1.0)
"""Radii of gyration about the in-plane axes for bodies drawn in the plane, over a blade's
length, or the body's own about z."""

TELLING = 1e-3
"""Share of the mass, or the stress, from which the shape of a mode counts in its error."""


def space_structure(assembly: SpaceAssembly, turn: float = 0.0) -> Structure:
    """Return a mechanism in space as a structure: outputs of its drive, of every blade.

    ``turn`` is the angle about z from the drawing's x to that of cases [rad].
    """
    found = vibrating(assembly)
    drive = assembly.layout.drive
    own = np.zeros(found.mass.shape[0])
    own[assembly.driven] = 1.0
    outputs: dict[str, Floats] = {}
    for blade in assembly.layout.blades:
        outputs[f"force {blade.name}"] = found.forces[blade.name][None]
        outputs[f"stress {blade.name}"] = found.stresses[blade.name]
    outputs["rotation" if drive.turns else "travel"] = own[None, :]
    axes = axes_about_z(turn)
    to_cases = motion_along(axes)
    pull = np.stack([found.pull[axis] for axis in "xyz"])
    return Structure(
        found.mass,
        found.stiffness,
        dict(zip("xyz", axes @ pull, strict=True)),
        dict.fromkeys("xyz", found.moved),
        outputs,
        own,
        {name: to_cases @ motion for name, motion in found.motions.items()},
        DIRECTIONS,
    )


class Likely(NamedTuple):
    """A structure, variants within its uncertainty, and the range of the factors on its springs.

    There are no variants where the uncertainty is unknown.
    """

    joint: SpaceJoint
    own: Structure
    others: tuple[Structure, ...] | None
    factors: tuple[float, float]


def likely_structures(
    mechanism: Mechanism | None,
    geometry: Geometry,
    material: Material,
    sizes: Sizes,
    steps: int,
    lock: str | None = None,
) -> Likely:
    """Return a mechanism as a structure in space, and variants over the errors of its springs.

    A material without a density may be as heavy as any, one without a Poisson's ratio has 0 or ½;
    a body that is drawn in its plane may have any unstated inertia about the axes in it, up to that
    of a radius of gyration as long as a blade, or its own about z, or as the distance between its
    pivots. A body that is locked is held in every direction.

    Raises
    ------
    NotAvailable
        When it has no masses, or is not made of blades alone that stand free.

    """
    density, either = material.density, material.elastic.likely
    several = mechanism is not None and mechanism.joints > 1
    turn, reach, spread = geometry.axes, 0.0, (0.0,) if geometry.in_space else GYRATIONS
    pivots = None
    if several:
        assert mechanism is not None
        pivots = [mechanism.out_of_plane(geometry.blades_layout(e, sizes), lock) for e in either]
        turn, reach = 0.0, pivots[0].reach
        spread = (0.0,) if pivots[0].is_stated else GYRATIONS
    elif not geometry.in_space:
        _refuse_guided(geometry, either[0], sizes)
        reach = max(geometry.length(sizes), _gyration(mechanism))
        spread = GYRATIONS if stated_tilt(mechanism, geometry) is None else (0.0,)

    def assembled(rho: float, gyration: float, ratio: int = 0) -> SpaceJoint:
        if pivots is not None:
            return SpaceJoint(on_pivots(pivots[ratio], rho, gyration * reach))
        layout = geometry.space_layout(either[ratio], sizes, rho)
        if geometry.in_space:
            return SpaceJoint(layout)
        return SpaceJoint(_loaded(layout, mechanism, geometry, gyration * reach))

    weight = 0.0 if density is None else density.value
    joint = assembled(weight, spread[0])
    if not any(body.mass for body in joint.layout.bodies):
        raise NotAvailable("has no body with a mass: give its bodies theirs")

    def structure(assembly: SpaceAssembly) -> Structure:
        found = space_structure(assembly, turn)
        return found.without_motion() if lock is not None else found

    own = structure(joint.assembly)
    if not joint.is_known_in_stress or (
        not geometry.in_space and geometry.has_limbs(material.elastic, sizes)
    ):
        return Likely(joint, own, None, (1.0, 1.0))
    low, high = 1.0 + joint.low, np.minimum(1.0 + joint.high, RIGID)
    shares = np.linspace(0.0, 1.0, steps)[:, None]
    others = [structure(joint.assembly.scaled(f)) for f in low ** (1.0 - shares) * high**shares]
    variants = [
        *([(DENSEST, spread[0], 0)] if density is None else []),
        *((weight, each, 0) for each in spread[1:]),
        *((weight, spread[0], ratio) for ratio in range(1, len(either))),
    ]
    for variant in variants:
        other = assembled(*variant).assembly
        others += [structure(other.scaled(f)) for f in (low, high)]
    known = high[high < RIGID]
    return Likely(joint, own, tuple(others), (float(low.min()), float(known.max(initial=1.0))))


def _gyration(mechanism: Mechanism | None) -> float:
    """Return the radius of gyration of a carried body about z [m], zero where it is not stated."""
    if mechanism is None or not mechanism.turning_inertia or not mechanism.hanging_mass():
        return 0.0
    return float((mechanism.turning_inertia / mechanism.hanging_mass()) ** 0.5)


def _refuse_guided(geometry: Geometry, elastic: Elastic, sizes: Sizes) -> None:
    """Raise :class:`NotAvailable` for bodies not freely on the blades of one joint."""
    if geometry.is_guided:
        raise NotAvailable("has a guide that is not defined out of its plane")
    if geometry.layout(elastic, sizes).guides:
        raise NotAvailable("has ideal guides, which are not defined out of their plane")


def stated_tilt(mechanism: Mechanism | None, geometry: Geometry) -> Floats | None:
    """Return the inertia of the one body that a joint carries about the axes in its plane [kg·m²].

    Along the axes of the layout; nothing where it is not stated, or the joint has bodies of its own
    that state none.
    """
    moments = None if mechanism is None else mechanism.tilting_inertia
    if moments is None or geometry.has_masses:
        return None
    c, s = np.cos(geometry.axes), np.sin(geometry.axes)
    turn = np.array([[c, -s], [s, c]])
    return np.asarray(turn @ np.diag(moments) @ turn.T)


def _loaded(
    layout: SpaceLayout, mechanism: Mechanism | None, geometry: Geometry, gyration: float
) -> SpaceLayout:
    """Return a joint from its plane with the body that it carries, and inertia about x and y.

    Every body has a radius of gyration [m] about the axes in the plane, where its inertia about
    them is not stated.
    """
    name = layout.drive.body
    stated = stated_tilt(mechanism, geometry)
    bodies = []
    for body in layout.bodies:
        mass, com, about_z = body.mass, body.com, body.inertia[2][2]
        if body.name == name and mechanism is not None:
            x, y = geometry.payload_point((body.point[0], body.point[1]))
            load = Body(
                name, (x, y), mechanism.hanging_mass(), mechanism.turning_inertia or 0.0,
                (x + mechanism.arm, y),
            )  # fmt: skip
            drawn = Body(name, body.point[:2], mass, about_z, com[:2] if mass else load.com)
            both = joined(name, body.point[:2], [drawn, load])
            mass, com, about_z = both.mass, (*both.com, 0.0), both.inertia
        tilt = np.eye(2) * mass * gyration**2
        if body.name == name and stated is not None:
            tilt = stated
        (xx, xy), (_, yy) = tilt.tolist()
        inertia = ((xx, xy, 0.0), (xy, yy, 0.0), (0.0, 0.0, about_z))
        bodies.append(SpaceBody(body.name, body.point, com, mass, inertia))
    return SpaceLayout(tuple(bodies), layout.blades, layout.drive, layout.springs)


def shape_error(
    joint: SpaceJoint,
    structure: Structure,
    axes: Iterable[str],
    peaks: Callable[[Structure], Mapping[str, float]],
    reached: float,
) -> ErrorRange | None:
    """Return the error of the peak stress of a response by the finite size of its motion.

    Parameters
    ----------
    joint : SpaceJoint
        The mechanism.
    structure : Structure
        The same as a structure.
    axes : iterable of str
        Axes along which the base moves.
    peaks : callable
        Peaks of every output of a structure.
    reached : float
        Share of the peaks at which it is asked.

    Returns
    -------
    ErrorRange or None
        Of the largest stress; unknown where it is large.

    Notes
    -----
    By the second order of each mode at its own peak, as much of the whole as its share of the
    stress, and of all of them at once where their stresses meet, as large as the response's. A
    blade of varying thickness has no second order; its stress stays that of small motion where
    no blade inside vibrates with the mode.

    """
    assembly = joint.assembly
    whole = reached * largest_of(peaks(structure), "stress")
    if whole == 0.0:
        return ErrorRange(0.0, 0.0)
    modes = natural_modes(structure.stiffness, structure.mass)
    states, sizes = [], []
    for n, omega in enumerate(modes.angular):
        one = structure.in_mode(float(omega), modes.shapes[:, n])
        size = reached * largest_of(peaks(one), "stress") if _is_moved(one, axes) else 0.0
        if size < TELLING * whole:
            continue
        if not joint.is_uniform and omega > own_blade_frequency(assembly):
            return None
        states.append(_as_state(assembly, float(omega), modes.shapes[: assembly.size, n]))
        sizes.append(size)
    stresses = Stresses(assembly)
    each = [stresses.of(state.moved.forces[:, 0], state.weights) for state in states]
    low = high = 0.0
    for state, size in zip(states, sizes, strict=True):
        error = state_error(joint, state, size)
        if error is None:
            return None
        low, high = low + error.low * size / whole, high + error.high * size / whole
    shares = _meeting(each, sizes)
    error = state_error(joint, combined(states, shares), whole)
    if error is None:
        return None
    return ErrorRange(min(low, error.low), max(high, error.high))


def _is_moved(structure: Structure, axes: Iterable[str]) -> bool:
    return any(structure.pull[axis][0] ** 2 > TELLING * structure.moved[axis] for axis in axes)


def _as_state(assembly: SpaceAssembly, omega: float, shape: Floats) -> SpaceState:
    """Return the shape of a mode as a state under the inertia of its bodies."""
    deformations = assembly.rows @ shape[:, None]
    forces = assembly.stiffness[:, None] * deformations
    moved = Moved(shape[:, None], deformations, forces, np.zeros(1))
    loads = []
    for body in assembly.layout.bodies:
        along = omega**2 * body.mass * (assembly.motion(body.name, body.com)[:3] @ shape)
        loads.append(SpaceLoad(body.name, body.com, (along[0], along[1], along[2])))
    return SpaceState(
        assembly, moved, np.zeros((len(assembly.members), 3)), tuple(loads), locked=False
    )


def _meeting(each: Sequence[Sequence[BladeStress]], sizes: Sequence[float]) -> list[float]:
    """Return factors on states with which their normal stresses add up at the largest."""
    normal = np.array([np.concatenate([blade.normal for blade in of]) for of in each])
    largest = np.array([np.abs(one).max() or 1.0 for one in normal])
    scaled = normal * (np.array(sizes) / largest)[:, None]
    place = int(np.argmax(np.abs(scaled).sum(axis=0)))
    signs = np.where(scaled[:, place] < 0.0, -1.0, 1.0)
    return [float(share) for share in signs * np.array(sizes) / largest]
