"""One load case on each joint: travel, forces, accelerations and end conditions."""

from collections.abc import Iterable, Mapping
from enum import StrEnum
from itertools import product
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple, TypeAlias

from flexcli.numerics.rows import atan2, copysign, cos, hypot, number, sin
from flexcli.parts.case import Case, components_along
from flexcli.parts.elastic import ANY
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries import Geometry, NotAvailable
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.parts.mechanisms import Mechanism, MechanismError
from flexcli.results import Value

if TYPE_CHECKING:
    from flexcli.parts.asd import Vibration
    from flexcli.parts.excitation import Sine, Sweep, Tone
    from flexcli.parts.quality import Quality
    from flexcli.parts.shock import Shock
    from flexcli.parts.temperature import Temperature

__all__ = ["IN_PLANE", "LoadKind", "Push", "Scene", "Wrench", "largest_travel", "scene_of"]


IN_PLANE = (0, 1, 5)
"""Components of a wrench in the joint's plane."""

ROUNDING = 1e-12
"""Relative size of a component below which it is rounding."""


WARM = "has no closed form for a temperature"
"""Why the closed forms do not cover a case with a temperature."""

STATED = "stated in the case"
"""Why a case has the ends that it states."""


class LoadKind(StrEnum):
    """Kinds of loads of a case, by their keys in the spec."""

    STROKE = "stroke"
    LOAD = "load"
    WRENCH = "wrench"
    ACCELERATION = "acceleration"
    ASD = "asd"
    SHOCK = "shock"
    SINE = "sine"
    SWEEP = "sweep"
    AXES = "axes"
    SINES = "sines"
    TEMPERATURE = "temperature"


Wrench: TypeAlias = tuple[float, float, float, float, float, float]
"""Forces along x, y, z [N] and moments about them [N·m] on the joint's moving body."""

NO_WRENCH: Wrench = (0.0, 0.0, 0.0, 0.0, 0.0, 0.0)


class Push(NamedTuple):
    """A force in the plane [N] and its direction from x of the joint's layout [rad]."""

    force: float
    direction: float


class Scene(NamedTuple):
    """One case in the joint's own terms.

    ``travel`` and ``mean_travel`` are rotations [rad] or translations [m] of the joint, ``middle``
    is the mean travel with the sign of the stroke; ``force`` is the largest force on a joint in its
    plane [N], ``axial_share`` the largest axial force in a blade per unit of it. ``forces`` are its
    parts, each with its direction from the x of the joint's layout [rad], without those that only
    drive the stroke.

    ``stated`` is the wrench of load and wrench on the joint, ``inertial`` that of each
    acceleration; both in the frame of the joint's layout, at the moving body's point. Each may act
    in either sense, independently of the others. ``accelerations`` are those on the masses of the
    layout's own bodies [m/s²], one for each ``inertial``.
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
    """Size of the steady acceleration [m/s²]."""
    axis: str
    """Axis that it acts along, nothing where it is not along one."""
    vibration: "Vibration | None"
    shock: "Shock | None"
    lock: str | None
    wrench: tuple[float, ...] | None
    forces: tuple[tuple[float, float], ...]
    values: Mapping[str, Value]
    sine: "Sine | None" = None
    sweep: "Sweep | None" = None
    sines: "tuple[Tone, ...]" = ()
    quality: "Quality | None" = None
    shaken_axes: frozenset[str] = frozenset()
    in_turn: bool = False
    """Whether the axes along which the base is shaken act one after another."""
    temperature: "Temperature | None" = None
    loads: frozenset[LoadKind] = frozenset()
    """Kinds of loads of the case; some requirement has to look at each."""
    pushed_by: frozenset[LoadKind] = frozenset()
    """Those that are fully included in the stresses of the joint's plane."""
    across_by: frozenset[LoadKind] = frozenset()
    """Those that also act out of the plane, on a joint whose blades are judged in space."""
    stated: Wrench = NO_WRENCH
    inertial: tuple[Wrench, ...] = ()
    accelerations: tuple[tuple[float, float, float], ...] = ()
    drive: int = 5
    """Component of a wrench that drives the stroke: the moment about z, or the force along y."""
    beyond: str = ""
    """Why the closed forms do not cover its loads, empty where they do."""
    in_space: bool = False
    """Whether the joint is drawn in space, where everything acts on it."""
    on_bodies: bool = False
    """Whether accelerations, along the axes of cases, act on all of a mechanism that is locked."""
    directed: bool = False
    """Whether the first of ``forces`` acts in its stated sense only, not either way."""
    has_plane: bool = True
    """Whether the joint has a plane in which forces act on it, as bars along an axis do not."""

    @property
    def vibrates_in_space(self) -> bool:
        """Return whether the response of its modes leaves the plane."""
        return self.in_space or "z" in self.shaken_axes

    @property
    def moves(self) -> bool:
        """Return whether the case has a stroke."""
        return bool(self.travel > 0.0 or self.mean_travel > 0.0)

    @property
    def hold(self) -> str:
        """Return what holds a mechanism in space where its loads may buckle it, in words."""
        if self.on_bodies:
            return f"{self.lock} locked"
        return "drive locked at its stroke" if self.moves else "drive free"

    @property
    def stroke_ends(self) -> tuple[float, float]:
        """Return the travels of both ends of the stroke, rest without one [m or rad]."""
        return self.middle + self.travel, self.middle - self.travel

    @property
    def sags(self) -> bool:
        """Return whether a steady acceleration along one axis makes the body sag along it."""
        return self.acceleration > 0.0 and bool(self.axis)

    @property
    def states_ends(self) -> bool:
        """Return whether the case itself says what holds the blades' ends."""
        return self.ends is not None and self.ends_why == STATED

    @property
    def keeps_turn(self) -> bool:
        """Return whether the ends or the lock of the case keep the body from turning."""
        if self.lock is not None and not self.states_ends:
            return True
        return self.ends is not None and ENDS[self.ends].turn

    @property
    def push(self) -> float:
        """Return the largest load along the stroke itself [N or N·m]."""
        if self.lock is not None:
            return 0.0
        return abs(self.stated[self.drive]) + sum(abs(each[self.drive]) for each in self.inertial)

    @property
    def bends(self) -> bool:
        """Return whether the case moves the joint."""
        return self.moves or self.push > 0.0

    @property
    def is_stressed(self) -> bool:
        """Return whether anything stresses the joint: a stroke, or loads in any direction."""
        return self.moves or bool(self.across_by) or self.is_loaded

    @property
    def is_loaded(self) -> bool:
        """Return whether anything in the joint's plane, or space, acts besides the stroke."""
        if self.temperature is not None:
            return True
        acts = range(6) if self.in_space else [i for i in IN_PLANE if i not in self.across]
        own = any(each[i] for each in self.accelerations for i in acts if i < 3)
        return own or any(each[i] for each in (self.stated, *self.inertial) for i in acts)

    @property
    def is_accelerated(self) -> bool:
        """Return whether an acceleration in the joint's plane acts on its blades."""
        planar = self.has_plane and not self.on_bodies
        return planar and any(x or y for x, y, _ in self.accelerations)

    @property
    def across(self) -> tuple[int, ...]:
        """Return the components of a wrench that act out of the joint's plane, if it has one."""
        return _across(has_plane=self.has_plane)

    def at_assembly(self) -> "Scene":
        """Return the same case without its temperature."""
        if self.temperature is None:
            return self
        return self._replace(
            temperature=None,
            loads=self.loads - {LoadKind.TEMPERATURE},
            beyond="" if self.beyond == WARM else self.beyond,
        )

    def without_loads(self) -> "Scene":
        """Return the same case with its stroke alone."""
        return self._replace(
            forces=(),
            force=0.0,
            stated=NO_WRENCH,
            inertial=(),
            accelerations=(),
            across_by=frozenset(),
            beyond="",
        )

    def pushes(self) -> tuple[Push, ...]:
        """Return the resultants of the forces for each combination of their senses."""
        found: list[Push] = []
        each: list[tuple[float, ...]] = [(1.0, -1.0)] * len(self.forces)
        if self.directed:
            each[0] = (1.0,)
        for signs in product(*each):
            x, y = (
                sum(s * f * trig(d) for s, (f, d) in zip(signs, self.forces, strict=True))
                for trig in (cos, sin)
            )
            size = hypot(x, y)
            if size > ROUNDING * self.force:
                found.append(Push(size, atan2(y, x)))
        return tuple(found)

    @property
    def driver(self) -> str:
        """Return the name of what the stresses of the case grow with."""
        return " and ".join(
            ["stroke"] * self.moves + ["force"] * bool(self.blade_force > 0.0 or self.push > 0.0)
        )

    @property
    def blade_force(self) -> float:
        """Return the largest axial force in a blade [N]."""
        return self.force * self.axial_share


def largest_travel(scenes: Iterable[Scene]) -> float:
    """Return the largest travel of the joint in any case, from rest [rad or m]."""
    return max((scene.travel + scene.mean_travel for scene in scenes), default=0.0)


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
    found = _inertial(case, mechanism, geometry, values)
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
        values |= _force_values(force, found, stated)
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
        across_by=_across_by(case, geometry, lasting, found),
        on_bodies=found.on_bodies,
        directed=_is_more(stated, drive) and (case.load is None or case.load.is_directed),
        has_plane=geometry.has_plane,
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


def _across(*, has_plane: bool) -> tuple[int, ...]:
    return (2, 3, 4) if has_plane else (0, 1, 2, 3, 4)


def _across_by(
    case: Case, geometry: Geometry, wrenches: tuple[Wrench, ...], inertial: "_Inertial"
) -> frozenset[LoadKind]:
    """Return the loads out of the plane of a joint that stands free on blades alone."""
    if inertial.on_bodies:
        return frozenset({LoadKind.ACCELERATION})
    found, across = set(), _across(has_plane=geometry.has_plane)
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
        across = _across(has_plane=geometry.has_plane)
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
    found = list(NO_WRENCH if case.wrench is None else _turned(case.wrench.components, geometry))
    if case.load is not None:
        angle = case.load.direction + geometry.symmetry_axis
        found[0] += case.load.force * cos(angle)
        found[1] += case.load.force * sin(angle)
    return _clean(found)


def _turned(wrench: tuple[float, ...], geometry: Geometry) -> list[float]:
    """Return a wrench along the axes of cases in the frame of the layout."""
    c, s = cos(geometry.axes), sin(geometry.axes)
    return [
        value for x, y, z in (wrench[:3], wrench[3:]) for value in (c * x - s * y, s * x + c * y, z)
    ]


def _clean(wrench: Iterable[float]) -> Wrench:
    """Return a wrench with components set to zero that are rounding beside the others."""
    values = list(wrench)
    for first in (0, 3):
        size = hypot(*values[first : first + 3])
        for i in range(first, first + 3):
            if abs(values[i]) <= ROUNDING * size:
                values[i] = 0.0
    x, y, z, m_x, m_y, m_z = values
    return x, y, z, m_x, m_y, m_z


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


class _Inertial(NamedTuple):
    """Wrenches of accelerations on a joint, in its frame, and accelerations of its bodies [m/s²].

    ``name`` is that of the force at the most loaded joint, ``forces`` are those at all of them.
    """

    name: str = ""
    forces: Mapping[str, float] = MappingProxyType({})
    wrenches: tuple[Wrench, ...] = ()
    accelerations: tuple[tuple[float, float, float], ...] = ()
    kinds: frozenset[LoadKind] = frozenset()
    on_bodies: bool = False


def _inertial(
    case: Case, mechanism: Mechanism | None, geometry: Geometry, values: dict[str, Value]
) -> _Inertial:
    """Return the wrenches of a case's accelerations, and add their values to those given.

    A steady acceleration acts in any direction; one of a vibration or a shock loads the joints
    quasi-statically where it does not drive the motion itself.
    """
    found = _accelerations(case, mechanism, geometry, values)
    if not found:
        return _Inertial()
    kinds = frozenset(each.kind for each in found if not each.vector[2]) - _shaken_across(case)
    if case.lock is not None and any(any(each.vector[1:]) for each in found):
        return _on_bodies(case, found)
    if case.lock is not None:
        return _locked(case.lock, mechanism, found, kinds, values)
    wrenches, fields = [], []
    for each in found:
        direction = [a / each.level for a in each.vector]
        field = _turned((*direction, 0.0, 0.0, 0.0), geometry)[:3]
        if each.kind is not LoadKind.ACCELERATION and geometry.motion == "translation":
            field[1] = 0.0  # what drives the motion is the response's
        in_plane, across, arm = 0.0, 0.0, 0.0
        if mechanism is not None:
            in_plane, arm = mechanism.free_force(each.level), mechanism.arm
            across = mechanism.hanging_mass() * each.level if field[2] else 0.0
        x, y, z = in_plane * field[0], in_plane * field[1], across * field[2]
        wrenches.append(_clean((x, y, z, 0.0, -arm * z, arm * y)))
        a_x, a_y, a_z, *_ = _clean((*(each.level * c for c in field), 0.0, 0.0, 0.0))
        fields.append((a_x, a_y, a_z))
    name = found[-1].name if mechanism is not None else ""
    return _Inertial(name, {}, tuple(wrenches), tuple(fields), kinds)


def _on_bodies(case: Case, found: list["_Accelerated"]) -> _Inertial:
    """Return an acceleration of a locked mechanism in any direction, which acts on its bodies."""
    beside = len(found) > 1 or case.load is not None or case.wrench is not None
    if beside:
        text = "a locked mechanism accelerated off x bears no other load in the same case"
        raise MechanismError("acceleration", text, "state each in a case of its own")
    x, y, z = found[0].vector
    return _Inertial(wrenches=(NO_WRENCH,), accelerations=((x, y, z),), on_bodies=True)


def _locked(
    lock: str,
    mechanism: Mechanism | None,
    found: list["_Accelerated"],
    kinds: frozenset[LoadKind],
    values: dict[str, Value],
) -> _Inertial:
    """Return the forces along x at the joints of a mechanism of which a body is locked."""
    assert mechanism is not None  # it has the body that is locked
    level, prefix = sum(each.level for each in found), found[-1].name
    for suffix, (force, label) in mechanism.body_forces(level).items():
        values[f"{prefix}{suffix}"] = Value(force, "N", label)
    forces = mechanism.locked_forces(lock, level)
    name = max(forces, key=lambda key: forces[key])
    # the stroke's axis, seen from the pivots' own
    angle = -number(getattr(mechanism, "bisector", 0.0))
    c, s = cos(angle), sin(angle)
    wrench = _clean((forces[name] * c, forces[name] * s, 0.0, 0.0, 0.0, 0.0))
    return _Inertial(name, forces, (wrench,), ((level * c, level * s, 0.0),), kinds)


def _force_values(force: float, found: _Inertial, stated: Wrench) -> dict[str, Value]:
    """Return the forces on the joints of a mechanism, what is stated added to each."""
    beside = hypot(*stated[:2])
    forces = {name: size + beside for name, size in found.forces.items()} or {"F": force}
    label = "force on a pivot" if len(forces) > 1 else "force on the joint"
    return {name: Value(size, "N", label) for name, size in forces.items()}


def _shaken_across(case: Case) -> frozenset[LoadKind]:
    """Return the vibrations of a case that shake it out of its plane, too."""
    along = {
        LoadKind.ASD: case.asd.axes if case.asd is not None else (),
        LoadKind.AXES: case.axes.each if case.axes is not None else (),
        LoadKind.SHOCK: (case.shock.axis,) if case.shock is not None else (),
    }
    return frozenset(kind for kind, axes in along.items() if "z" in axes)


class _Accelerated(NamedTuple):
    """An acceleration that loads the joints, along x, y and z [m/s²], and the name of its force."""

    kind: LoadKind
    vector: tuple[float, ...]
    name: str

    @property
    def level(self) -> float:
        """Return its size [m/s²]."""
        return hypot(*self.vector)


def _accelerations(
    case: Case, mechanism: Mechanism | None, geometry: Geometry, values: dict[str, Value]
) -> list[_Accelerated]:
    """Return each acceleration that loads the joints."""
    found: list[_Accelerated] = []
    steady, vibration, shock = case.acceleration, case.vibration, case.shock
    kind = LoadKind.ASD if case.axes is None else LoadKind.AXES
    for key, given in ((kind.value, vibration), ("shock", shock)):
        massless = mechanism is None and geometry.own_mass == 0.0
        if given is not None and massless:
            raise MechanismError(key, "a base that moves needs masses on it", "add a mechanism")

    def load(kind: LoadKind, vector: Iterable[float], name: str) -> None:
        given = dict(zip("xyz", vector, strict=True))
        axes = tuple(axis for axis, a in given.items() if a != 0.0)
        along = _loading(case, kind, axes, mechanism, geometry)
        if along:
            kept = tuple(a if axis in along else 0.0 for axis, a in given.items())
            found.append(_Accelerated(kind, kept, name))

    if steady is not None:
        if mechanism is None and geometry.own_mass == 0.0:
            raise MechanismError(
                "acceleration", "an acceleration needs a mass that it acts on", "add a mechanism"
            )
        load(LoadKind.ACCELERATION, steady.vector, "F_steady")
    if geometry.in_space:
        return found  # the response of its modes is all that is known
    if vibration is not None:
        worst_rms = 0.0
        for axis, applied in vibration.by_axis().items():
            worst = applied.worst_case(vibration.q.largest)
            rms = number(worst.response)
            peak = vibration.sigma * rms
            load(kind, components_along(axis, peak), f"F_{vibration.sigma:g}sigma")
            if rms <= worst_rms:
                continue
            worst_rms = rms
            along = f" along {axis}" if case.axes is not None else ""
            values["f_worst"] = Value(worst.frequency, "Hz", "frequency of the worst case")
            values["g_rms_worst"] = Value(
                rms,
                "m/s^2",
                f"worst rms acceleration{along}, {vibration.q.told}, profile {applied.text}",
                source="Miles, √(π/2 f Q ASD), over all frequencies",
            )
    if shock is not None and _loading(case, LoadKind.SHOCK, (shock.axis,), mechanism, geometry):
        worst_shock = shock.worst_acceleration()
        if worst_shock is not None:
            load(LoadKind.SHOCK, components_along(shock.axis, worst_shock), "F_shock")
    return found


def _loading(
    case: Case,
    kind: LoadKind,
    axes: tuple[str, ...],
    mechanism: Mechanism | None,
    geometry: Geometry,
) -> tuple[str, ...]:
    """Return the axes along which an acceleration loads the joints by itself."""
    vibrates = kind is not LoadKind.ACCELERATION
    if vibrates:
        axes = tuple(axis for axis in axes if axis != "z")  # the modes' response has that
    if case.lock is not None:
        across = [axis for axis in axes if axis != "x"]
        if across and vibrates:
            raise MechanismError(
                kind.value,
                f"no closed form for a locked mechanism accelerated along {across[0]}",
                "take axis: x, or its size as a steady acceleration:, which is judged in space",
            )
        return axes
    stage = mechanism is not None and mechanism.joints > 1
    drives = stage or (vibrates and geometry.motion == "translation")
    return tuple(
        axis for axis in axes if not (drives and axis == "x") and not (stage and axis == "z")
    )
