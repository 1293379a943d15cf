"""The inertial loads of a case on each joint, by steady accelerations, vibrations and shocks."""

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from flexcli.numerics.rows import cos, hypot, number, sin
from flexcli.parts.case import Case
from flexcli.parts.geometries import Geometry
from flexcli.parts.mechanisms import Mechanism, MechanismError
from flexcli.parts.scene import (
    NO_WRENCH,
    ROUNDING,
    LoadKind,
    Wrench,
    axes_off_plane,
    components_along,
)
from flexcli.results import Value

__all__ = ["InertialLoads", "force_values", "in_layout", "inertial_loads", "without_rounding"]


BESIDE = (
    "a locked mechanism accelerated off x is judged under no force or wrench in the same case: "
    "state each in a case of its own"
)


class InertialLoads(NamedTuple):
    """Wrenches of accelerations on a joint, in its frame, and accelerations of its bodies [m/s²].

    ``name`` is that of the force at the most loaded joint, ``forces`` are those at all of them.
    """

    name: str = ""
    forces: Mapping[str, float] = MappingProxyType({})
    wrenches: tuple[Wrench, ...] = ()
    accelerations: tuple[tuple[float, float, float], ...] = ()
    kinds: frozenset[LoadKind] = frozenset()
    on_bodies: bool = False
    unjudged: str = ""
    """Why no model has an answer to all loads of the case, empty where one may."""


def inertial_loads(
    case: Case, mechanism: Mechanism | None, geometry: Geometry, values: dict[str, Value]
) -> InertialLoads:
    """Return the wrenches of a case's accelerations, and add their values to those given.

    A steady acceleration acts in any direction; one of a vibration or a shock loads the joints
    quasi-statically where it does not drive the motion itself.
    """
    found = _accelerations(case, mechanism, geometry, values)
    if not found:
        return InertialLoads()
    kinds = frozenset(each.kind for each in found if not each.vector[2]) - _shaken_across(case)
    if case.lock is not None and any(any(each.vector[1:]) for each in found):
        return _on_bodies(case, found)
    if case.lock is not None:
        return _locked(case.lock, mechanism, found, kinds, values)
    wrenches, fields = [], []
    for each in found:
        direction = [a / each.level for a in each.vector]
        field = in_layout((*direction, 0.0, 0.0, 0.0), geometry)[:3]
        if each.kind is not LoadKind.ACCELERATION and geometry.motion == "translation":
            field[1] = 0.0  # what drives the motion is the response's
        in_plane, across, arm = 0.0, 0.0, 0.0
        if mechanism is not None:
            in_plane, arm = mechanism.free_force(each.level), mechanism.arm
            across = mechanism.hanging_mass() * each.level if field[2] else 0.0
        x, y, z = in_plane * field[0], in_plane * field[1], across * field[2]
        wrenches.append(without_rounding((x, y, z, 0.0, -arm * z, arm * y)))
        a_x, a_y, a_z, *_ = without_rounding((*(each.level * c for c in field), 0.0, 0.0, 0.0))
        fields.append((a_x, a_y, a_z))
    name = found[-1].name if mechanism is not None else ""
    return InertialLoads(name, {}, tuple(wrenches), tuple(fields), kinds)


def _on_bodies(case: Case, found: list["_Accelerated"]) -> InertialLoads:
    """Return accelerations of a locked mechanism in any direction, which act on its bodies."""
    beside = case.load is not None or case.wrench is not None
    return InertialLoads(
        wrenches=(NO_WRENCH,) * len(found),
        accelerations=tuple((x, y, z) for x, y, z in (each.vector for each in found)),
        on_bodies=True,
        unjudged=BESIDE if beside else "",
    )


def _locked(
    lock: str,
    mechanism: Mechanism | None,
    found: list["_Accelerated"],
    kinds: frozenset[LoadKind],
    values: dict[str, Value],
) -> InertialLoads:
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
    wrench = without_rounding((forces[name] * c, forces[name] * s, 0.0, 0.0, 0.0, 0.0))
    return InertialLoads(name, forces, (wrench,), ((level * c, level * s, 0.0),), kinds)


def force_values(force: float, found: InertialLoads, stated: Wrench) -> dict[str, Value]:
    """Return the forces on the joints of a mechanism, what is stated added to each."""
    beside = hypot(*stated[:2])
    forces = {name: size + beside for name, size in found.forces.items()} or {"F": force}
    label = "force on a pivot" if len(forces) > 1 else "force on the joint"
    return {name: Value(size, "N", label) for name, size in forces.items()}


def _shaken_across(case: Case) -> frozenset[LoadKind]:
    """Return the vibrations of a case that shake it out of its plane, too, or locked off x."""
    along = {
        LoadKind.ASD: case.asd.axes if case.asd is not None else (),
        LoadKind.AXES: case.axes.each if case.axes is not None else (),
        LoadKind.SHOCK: (case.shock.axis,) if case.shock is not None else (),
    }
    off = axes_off_plane(case.lock)
    return frozenset(kind for kind, axes in along.items() if off & {*axes})


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
        return axes
    stage = mechanism is not None and mechanism.joints > 1
    drives = stage or (vibrates and geometry.motion == "translation")
    return tuple(
        axis for axis in axes if not (drives and axis == "x") and not (stage and axis == "z")
    )


def in_layout(wrench: tuple[float, ...], geometry: Geometry) -> list[float]:
    """Return a wrench along the axes of cases in the frame of the layout."""
    c, s = cos(geometry.axes), sin(geometry.axes)
    return [
        value for x, y, z in (wrench[:3], wrench[3:]) for value in (c * x - s * y, s * x + c * y, z)
    ]


def without_rounding(wrench: Iterable[float]) -> Wrench:
    """Return a wrench with components set to zero that are rounding beside the others."""
    values = list(wrench)
    for first in (0, 3):
        size = hypot(*values[first : first + 3])
        for i in range(first, first + 3):
            if abs(values[i]) <= ROUNDING * size:
                values[i] = 0.0
    x, y, z, m_x, m_y, m_z = values
    return x, y, z, m_x, m_y, m_z
