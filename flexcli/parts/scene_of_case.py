"""A load case in the terms of each joint: stroke, stated loads, accelerations, end conditions."""

from collections.abc import Mapping
from typing import TYPE_CHECKING

from flexcli.numerics.rows import atan2, copysign, cos, hypot, sin
from flexcli.parts.case import Case
from flexcli.parts.elastic import ANY
from flexcli.parts.ends import FREE
from flexcli.parts.geometries import Geometry, NotAvailable
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.parts.inertial_loads import (
    InertialLoads,
    force_values,
    in_layout,
    inertial_loads,
    without_rounding,
)
from flexcli.parts.mechanisms import Mechanism, MechanismError
from flexcli.parts.scene import (
    NO_WRENCH,
    ROUNDING,
    STATED,
    WARM,
    LoadKind,
    Scene,
    Wrench,
    components_across,
)
from flexcli.results import Value

if TYPE_CHECKING:
    from flexcli.parts.temperature import Temperature

__all__ = ["scene_of"]


def scene_of(name: str, case: Case, mechanism: Mechanism | None, geometry: Geometry) -> Scene:
    """Return a case in the terms of each joint, or raise :class:`MechanismError`."""
    if geometry.in_space:
        _refuse_in_space(case)
    if case.lock is not None:
        if mechanism is None:
            raise MechanismError("lock", "there is no body to lock", "state ends: instead")
        mechanism.locked_forces(case.lock, 0.0)  # refuses a body that cannot be locked
    values: dict[str, Value] = {}
    travel, mean = _joint_travel(case, mechanism, geometry, values)
    stated = _stated(case, geometry)
    found = inertial_loads(case, mechanism, geometry, values)
    drive = 5 if geometry.motion == "rotation" else 1
    lasting = (stated, *found.wrenches)
    planar = lasting if geometry.has_plane else ()
    forces = tuple(
        (hypot(*each[:2]), atan2(each[1], each[0])) for each in planar if _is_more(each, drive)
    )
    force = sum(size for size, _ in forces)
    ends, why = case.ends, STATED if case.ends else ""
    if ends is None and case.lock is not None:
        ends, why = "clamped-clamped", f"lock: {case.lock} keeps both ends from turning"
    steady = case.acceleration
    beyond, share = _closed_share(case, geometry, forces, lasting)
    if case.temperature is not None:
        _refuse_unknown_bodies(case.temperature, mechanism, geometry)
        beyond = WARM
    if force > 0.0 and mechanism is not None and found.name:
        values |= force_values(force, found, stated)
    across_by = _across_by(case, geometry, lasting, found)
    alone = mechanism is None or mechanism.joints == 1
    is_held = ends not in (None, FREE) or case.lock is not None or not alone or found.on_bodies
    quiet = case.quiet() if case.vibrates else None
    return Scene(
        case=name,
        travel=travel,
        mean_travel=mean,
        middle=copysign(mean, case.stroke.middle) if case.stroke else 0.0,
        cycles=case.stroke.cycles if case.stroke else None,
        force=force,
        force_name=found.name or ("F" if force else ""),
        axial_share=share,
        ends=ends,
        ends_why=why,
        acceleration=steady.size if steady else 0.0,
        axis=steady.only_axis if steady else "",
        vibration=case.vibration,
        shock=case.shock,
        sine=case.sine,
        sweep=case.sweep,
        sines=case.sines,
        quality=case.q,
        shaken_axes=case.shaken_axes,
        in_turn=case.combine == "in-turn",
        temperature=_called(case.temperature, geometry),
        lock=case.lock,
        wrench=case.wrench.components if case.wrench else None,
        forces=forces,
        values=values,
        loads=_loads(case),
        pushed_by=_pushed_by(case, found.kinds, geometry),
        stated=stated,
        inertial=found.wrenches,
        accelerations=found.accelerations,
        drive=drive,
        beyond=beyond,
        in_space=geometry.in_space,
        may_bow_aside=not (geometry.told_across_width or geometry.in_space or geometry.is_guided),
        across_by=across_by,
        tilts=not is_held and _may_tilt(case, geometry, lasting),
        on_bodies=found.on_bodies,
        unjudged=found.unjudged,
        directed=_is_more(stated, drive) and (case.load is None or case.load.is_directed),
        has_plane=geometry.has_plane,
        standing=None if quiet is None else scene_of(name, quiet, mechanism, geometry),
    )


def _loads(case: Case) -> frozenset[LoadKind]:
    """Return the kinds of loads of a case, without an acceleration of zero size."""
    steady = case.acceleration
    given = {kind for kind in LoadKind if getattr(case, kind.value)}
    return frozenset(given - {LoadKind.ACCELERATION} if steady and not steady.size else given)


def _refuse_in_space(case: Case) -> None:
    """Refuse loads that no model in space covers."""
    if case.load is not None:
        raise MechanismError("load", "a load is one in a plane", "write it as a wrench: {x: 10 N}")


def _is_more(wrench: Wrench, drive: int) -> bool:
    """Return whether a wrench has a force in the plane beside the one that drives the stroke."""
    x, y = wrench[0], 0.0 if drive == 1 else wrench[1]
    return hypot(x, y) > ROUNDING * hypot(*wrench[:2])


def _across_by(
    case: Case, geometry: Geometry, wrenches: tuple[Wrench, ...], inertial: InertialLoads
) -> frozenset[LoadKind]:
    """Return the loads out of the plane of a joint that stands free on blades alone."""
    if inertial.on_bodies:
        return frozenset({LoadKind.ACCELERATION})
    found, across = set(), components_across(has_plane=geometry.has_plane)
    if case.wrench is not None and any(case.wrench.components[i] for i in across):
        found.add(LoadKind.WRENCH)
    if case.load is not None and not geometry.has_plane:
        found.add(LoadKind.LOAD)
    steady = case.acceleration
    if steady is not None and (steady.vector[2] != 0.0 or not geometry.has_plane):
        acts = any(each[i] for each in wrenches[1:] for i in across) or geometry.own_mass > 0.0
        found |= {LoadKind.ACCELERATION} if acts else set()
    # beside a stroke a guide would have a part in what both do to each other
    guided = geometry.is_guided and case.stroke is not None
    if not found or geometry.in_space or guided or case.lock is not None:
        return frozenset()
    return frozenset(found) if _stands_free(geometry) else frozenset()


def _may_tilt(case: Case, geometry: Geometry, wrenches: tuple[Wrench, ...]) -> bool:
    """Return whether what acts in the plane of a joint may tilt its body out of it."""
    loaded = any(map(any, wrenches)) or bool(case.shaken_axes) or case.temperature is not None
    return geometry.may_tilt(loaded=loaded) and not geometry.is_guided


def _stands_free(geometry: Geometry) -> bool:
    """Return whether a joint has a layout in space, and no body on ideal joints of its plane."""
    try:
        geometry.space_layout(ANY, geometry.probe())
    except NotAvailable:
        return False
    try:
        return not geometry.layout(ANY, geometry.probe()).guides
    except NotAvailable:  # bars along an axis have no plane
        return True


def _pushed_by(
    case: Case, inertial: frozenset[LoadKind], geometry: Geometry
) -> frozenset[LoadKind]:
    """Return the loads of a case that the stresses of the joint include completely."""
    found = set(inertial) if geometry.has_plane else set()
    if geometry.in_space:
        given = {
            LoadKind.WRENCH: case.wrench,
            LoadKind.ACCELERATION: case.acceleration,
            LoadKind.TEMPERATURE: case.temperature,
        }
        return frozenset(found | {kind for kind, load in given.items() if load is not None})
    if case.load is not None and geometry.has_plane:
        found.add(LoadKind.LOAD)
    if case.wrench is not None:
        across = components_across(has_plane=geometry.has_plane)
        found |= set() if any(case.wrench.components[i] for i in across) else {LoadKind.WRENCH}
    if case.temperature is not None:
        found.add(LoadKind.TEMPERATURE)
    return frozenset(found)


def _refuse_unknown_bodies(
    temperature: "Temperature", mechanism: Mechanism | None, geometry: Geometry
) -> None:
    """Raise :class:`MechanismError` for temperatures of bodies that the joint does not have."""
    if mechanism is not None and mechanism.joints > 1:
        text = "a temperature is judged on a joint, not on a mechanism of several"
        raise MechanismError("temperature", text, "draw the mechanism as a layout")
    if temperature.gradient.z and not geometry.in_space:
        text = f"a {geometry.name} is judged in its plane, where no temperature rises along z"
        raise MechanismError("temperature", text, "draw it as a space-layout")
    drawn = geometry.space_layout if geometry.in_space else geometry.layout
    try:
        layout = drawn(ANY, geometry.probe())
    except NotAvailable:
        return  # no model says anything of it, which its checks tell
    called = {MOVING: geometry.moving_name}
    known = [GROUND, *(called.get(body.name, body.name) for body in layout.bodies)]
    for name in sorted(temperature.names.difference(known)):
        text = f"a {geometry.name} has no body '{name}'"
        raise MechanismError("temperature", text, f"it has {', '.join(known)}")


def _called(temperature: "Temperature | None", geometry: Geometry) -> "Temperature | None":
    """Return a temperature with the bodies named as in the joint's layout."""
    name = geometry.moving_name
    if temperature is None or name not in temperature.names or geometry.in_space:
        return temperature

    def renamed(each: Mapping[str, float]) -> dict[str, float]:
        return {MOVING if key == name else key: value for key, value in each.items()}

    changed = {key: renamed(getattr(temperature, key)) for key in ("bodies", "expansion")}
    return temperature.model_copy(update=changed)


def _stated(case: Case, geometry: Geometry) -> Wrench:
    """Return load and wrench of a case as one wrench, in the frame of the joint's layout."""
    found = list(NO_WRENCH if case.wrench is None else in_layout(case.wrench.components, geometry))
    if case.load is not None:
        angle = case.load.direction + geometry.symmetry_axis
        found[0] += case.load.force * cos(angle)
        found[1] += case.load.force * sin(angle)
    return without_rounding(found)


def _closed_share(
    case: Case,
    geometry: Geometry,
    forces: tuple[tuple[float, float], ...],
    wrenches: tuple[Wrench, ...],
) -> tuple[str, float]:
    """Return why closed forms do not cover the loads, and the largest axial force over the force.

    Forces in different directions add as if they were largest in the same blade.
    """
    force = sum(size for size, _ in forces)
    beyond = ""
    if geometry.motion == "translation" and any(each[5] for each in wrenches):
        beyond = "has no closed form for a moment on a stage"
    if force == 0.0:
        return beyond, 0.0
    try:
        carried = sum(
            size * geometry.axial_share(angle - geometry.symmetry_axis) for size, angle in forces
        )
        return beyond, carried / force
    except NotAvailable as error:
        try:
            geometry.layout(ANY, geometry.probe())
        except NotAvailable:
            at = "load" if case.load else "wrench" if case.wrench else "acceleration"
            at = "asd" if case.asd and not case.load else at
            at = "axes" if case.axes and not case.load else at
            hint = "give the load another direction, or take another geometry"
            raise MechanismError(at, f"a {geometry.name} {error}", hint) from error
        return str(error), 1.0


def _joint_travel(
    case: Case, mechanism: Mechanism | None, geometry: Geometry, values: dict[str, Value]
) -> tuple[float, float]:
    """Return amplitude and mean of each joint's travel."""
    if case.stroke is None:
        return 0.0, 0.0
    if mechanism is not None:
        travel, mean = mechanism.joint_travel(case.stroke, geometry)
    elif case.stroke.motion == geometry.motion:
        travel, mean = case.stroke.amplitude, case.stroke.mean
    else:
        raise MechanismError(
            "stroke",
            f"the motion of this joint is a {geometry.motion}",
            f"give {geometry.motion}:, or a mechanism that turns one into the other",
        )
    symbol, unit = geometry.travel_symbol, geometry.travel_unit
    values[f"{symbol}_stroke"] = Value(
        travel, unit, "stroke of each joint (amplitude)", estimated_error=0.0
    )
    if mean:
        values[f"{symbol}_mean"] = Value(
            mean, unit, "middle of the stroke from rest", estimated_error=0.0
        )
    return travel, mean
