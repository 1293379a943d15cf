"""What one case asks of each joint: travel, force, what holds the blades' ends."""

from collections.abc import Iterable, Mapping
from enum import StrEnum
from math import copysign
from typing import NamedTuple

from flexcli.formulas.miles import miles_worst_case
from flexcli.parts.asd import RandomVibration
from flexcli.parts.case import Case
from flexcli.parts.geometries import Geometry, NotAvailable
from flexcli.parts.mechanisms import Mechanism, MechanismError
from flexcli.parts.shock import Shock
from flexcli.results import Value

__all__ = ["LoadKind", "Scene", "largest_travel", "scene_of"]


class LoadKind(StrEnum):
    """What a case can load a mechanism with, by its key in the spec."""

    STROKE = "stroke"
    LOAD = "load"
    WRENCH = "wrench"
    ACCELERATION = "acceleration"
    ASD = "asd"
    SHOCK = "shock"
    SINE = "sine"
    SWEEP = "sweep"


class Scene(NamedTuple):
    """One case in the joint's own terms.

    ``travel`` and ``mean_travel`` are rotations [rad] or translations [m] of the joint,
    ``middle`` is the mean travel with the sign of the stroke; ``force``
    is the largest force on a joint in its plane [N], ``axial_share`` the largest axial force in a
    blade per unit of it. ``forces`` are its parts, each with its direction from the joint's axis
    of symmetry [rad].
    """

    case: str
    travel: float
    mean_travel: float
    middle: float
    cycles: float | None
    force: float
    force_name: str
    axial_share: float
    ends: str | None
    ends_why: str
    acceleration: float
    axis: str
    vibration: RandomVibration | None
    shock: Shock | None
    lock: str | None
    wrench: tuple[float, ...] | None
    forces: tuple[tuple[float, float], ...]
    values: Mapping[str, Value]
    loads: frozenset[LoadKind] = frozenset()
    """What the case states; each has to be looked at by some requirement."""
    pushed_by: frozenset[LoadKind] = frozenset()
    """Those of them that are in ``force``."""

    @property
    def bends(self) -> bool:
        """Return whether the case moves the joint."""
        return self.travel > 0.0 or self.mean_travel > 0.0

    @property
    def driver(self) -> str:
        """Return what the stresses of the case grow with."""
        return " and ".join(["stroke"] * self.bends + ["force"] * (self.blade_force > 0.0))

    @property
    def blade_force(self) -> float:
        """Return the largest axial force in a blade [N]."""
        return self.force * self.axial_share


def largest_travel(scenes: Iterable[Scene]) -> float:
    """Return the largest travel of the joint in any case, from rest [rad or m]."""
    return max((scene.travel + scene.mean_travel for scene in scenes), default=0.0)


def scene_of(name: str, case: Case, mechanism: Mechanism | None, geometry: Geometry) -> Scene:
    """Return a case in the terms of each joint, or raise :class:`MechanismError`."""
    if case.lock is not None:
        if mechanism is None:
            raise MechanismError("lock", "there is no body to lock", "state ends: instead")
        mechanism.locked_forces(case.lock, 0.0)  # refuses a body that cannot be locked
    values: dict[str, Value] = {}
    travel, mean = _joint_travel(case, mechanism, geometry, values)
    forces = _forces(case, mechanism, values)
    force_name = max(forces, key=lambda key: forces[key]) if forces else ""
    force = forces.get(force_name, 0.0)
    ends, why = case.ends, "stated in the case" if case.ends else ""
    if ends is None and case.lock is not None:
        ends, why = "clamped-clamped", f"lock: {case.lock} keeps both ends from turning"
    steady = case.acceleration
    load = case.load.force if case.load is not None else 0.0
    acting = [(load, case.load.direction)] if case.load is not None and load else []
    if force > load:
        acting.append((force - load, getattr(mechanism, "bisector", 0.0)))
    return Scene(
        case=name,
        travel=travel,
        mean_travel=mean,
        middle=copysign(mean, case.stroke.middle) if case.stroke else 0.0,
        cycles=case.stroke.cycles if case.stroke else None,
        force=force,
        force_name=force_name,
        axial_share=_axial_share(case, mechanism, geometry, force),
        ends=ends,
        ends_why=why,
        acceleration=steady.level if steady else 0.0,
        axis=steady.axis if steady else "",
        vibration=case.asd,
        shock=case.shock,
        lock=case.lock,
        wrench=case.wrench.components if case.wrench else None,
        forces=tuple(acting),
        values=values,
        loads=frozenset(kind for kind in LoadKind if getattr(case, kind.value) is not None),
        pushed_by=_pushed_by(case),
    )


def _pushed_by(case: Case) -> frozenset[LoadKind]:
    """Return the loads of a case that its force on the joints is made of."""
    found = {LoadKind.LOAD} if case.load is not None else set()
    steady, asd, shock = case.acceleration, case.asd, case.shock
    for kind, axes in (
        (LoadKind.ACCELERATION, (steady.axis,) if steady is not None else ()),
        (LoadKind.ASD, asd.axes if asd is not None else ()),
        (LoadKind.SHOCK, (shock.axis,) if shock is not None else ()),
    ):
        if axes and _loads_joints(case, kind.value, axes):
            found.add(kind)
    return frozenset(found)


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
    values[f"{symbol}_stroke"] = Value(travel, unit, "stroke of each joint (amplitude)")
    if mean:
        values[f"{symbol}_mean"] = Value(mean, unit, "middle of the stroke from rest")
    return travel, mean


def _axial_share(
    case: Case, mechanism: Mechanism | None, geometry: Geometry, force: float
) -> float:
    """Return the axial force of the most loaded blade over the force on the joint.

    A load and an inertial force in other directions add as if they were largest in the same
    blade.
    """
    if force == 0.0:
        return 0.0
    load = case.load.force if case.load is not None else 0.0
    bisector = getattr(mechanism, "bisector", 0.0)
    try:
        carried = geometry.axial_share(case.load.direction) * load if case.load else 0.0
        inertial = force - load
        if inertial > 0.0:
            carried += geometry.axial_share(bisector) * inertial
    except NotAvailable as error:
        at = "load" if case.load else "asd" if case.asd else "acceleration"
        hint = "give the load another direction, or take another geometry"
        kind = getattr(geometry, "kind", "geometry")
        raise MechanismError(at, f"a {kind} {error}", hint) from error
    return carried / force


def _forces(case: Case, mechanism: Mechanism | None, values: dict[str, Value]) -> dict[str, float]:
    """Return the forces on the joints of a case [N], adding what was found on the way.

    An acceleration of the base loads the joints quasi-statically where it does not drive the
    motion itself: along x when a lock holds the bodies, along y always.
    """
    load = case.load.force if case.load is not None else 0.0
    forces = {"F": load} if load > 0.0 else {}
    level, prefix = 0.0, ""
    for found, name in _accelerations(case, mechanism, values):
        level, prefix = level + found, name
    if level == 0.0 or mechanism is None:
        return forces
    for suffix, (force, label) in mechanism.body_forces(level).items():
        values[f"{prefix}{suffix}"] = Value(force, "N", label)
    if case.lock is None:
        loads = {"F": mechanism.free_force(level)}
    else:
        loads = mechanism.locked_forces(case.lock, level)
    forces = {name: load + force for name, force in loads.items()}
    label = "force on a pivot" if len(loads) > 1 else "force on the joint"
    values.update({name: Value(force, "N", label) for name, force in forces.items()})
    return forces


def _accelerations(
    case: Case, mechanism: Mechanism | None, values: dict[str, Value]
) -> list[tuple[float, str]]:
    """Return each acceleration that loads the joints [m/s²], with the name of its force."""
    found: list[tuple[float, str]] = []
    steady, asd, shock = case.acceleration, case.asd, case.shock
    for key, given in (("acceleration", steady), ("asd", asd), ("shock", shock)):
        if given is not None and key != "acceleration" and mechanism is None:
            raise MechanismError(key, "a base that moves needs masses on it", "add a mechanism")
    if steady is not None and _loads_joints(case, "acceleration", (steady.axis,)):
        if mechanism is None:
            raise MechanismError(
                "acceleration", "an acceleration needs a mass that it acts on", "add a mechanism"
            )
        found.append((steady.level, "F_steady"))
    if asd is not None:
        applied = asd.applied()
        worst = miles_worst_case(applied.frequency, applied.level, asd.q, scale=applied.scale)
        rms = float(worst.response)
        values["f_worst"] = Value(worst.frequency, "Hz", "frequency of the worst case")
        values["g_rms_worst"] = Value(
            rms,
            "m/s^2",
            f"worst rms acceleration, Q = {asd.q:g}, profile {applied.text}",
            source="Miles, √(π/2 f Q ASD), over all frequencies",
        )
        if _loads_joints(case, "asd", asd.axes):
            found.append((asd.sigma * rms, f"F_{asd.sigma:g}sigma"))
    if shock is not None and _loads_joints(case, "shock", (shock.axis,)):
        worst_shock = shock.worst_acceleration()
        if worst_shock is not None:
            found.append((worst_shock, "F_shock"))
    return found


def _loads_joints(case: Case, key: str, axes: tuple[str, ...]) -> bool:
    """Return whether an acceleration loads the joints instead of driving their motion."""
    if case.lock is None:
        return "y" in axes
    across = [axis for axis in axes if axis != "x"]
    if across:
        raise MechanismError(
            key,
            f"no closed form for a locked mechanism accelerated along {across[0]}",
            "take axis: x, or leave the lock out",
        )
    return True
