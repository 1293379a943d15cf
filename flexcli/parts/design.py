"""A design: material, geometry, mechanism, cases and requirements, joined and consistent."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any, Literal

from pydantic import Field, model_validator

from flexcli.formulas.random_vibration import miles_worst_case
from flexcli.parts.base import Part, spec_error
from flexcli.parts.case import Case
from flexcli.parts.geometries import AnyGeometry, Blade, NotAvailable
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import AnyMechanism, MechanismError
from flexcli.parts.requirements import Ask, Limit, RequirementError, Requirements
from flexcli.parts.scene import Scene
from flexcli.parts.sizing import SizeOptions
from flexcli.results import Value

__all__ = ["DesignSpec", "Problem"]

CASE_KEYS = tuple(Case.model_fields)


@dataclass(frozen=True)
class Problem:
    """Something that does not fit between parts that are sound each: where, what, what else."""

    path: tuple[str | int, ...]
    text: str
    hint: str


class DesignSpec(Part):
    """The design file."""

    flexure: Literal[1]
    title: str = ""
    material: Material
    geometry: AnyGeometry
    mechanism: AnyMechanism | None = None
    cases: dict[str, Case] = Field(min_length=1)
    requirements: Requirements
    size: SizeOptions = SizeOptions()

    @model_validator(mode="before")
    @classmethod
    def _single_case(cls, data: Any) -> Any:
        """Take a single case from the top level."""
        if not isinstance(data, dict):
            return data
        loose = [key for key in data if key in CASE_KEYS]
        if not loose:
            return data
        if "cases" in data:
            raise spec_error(
                f"'{loose[0]}' stands beside 'cases'", "move it into a case", at=(loose[0],)
            )
        rest = {key: value for key, value in data.items() if key not in CASE_KEYS}
        return {**rest, "cases": {"design": {key: data[key] for key in loose}}}

    @model_validator(mode="after")
    def _joints_fit(self) -> "DesignSpec":
        wanted = self.mechanism.joint_motion if self.mechanism else None
        if wanted is not None and wanted != self.geometry.motion:
            raise spec_error(
                f"this mechanism turns on pivots; a {self.geometry.kind} does not turn",
                "take a pivot, e.g. kind: rcc",
                at=("geometry", "kind"),
            )
        return self

    def fixed_blade(self) -> Blade | None:
        """Return the blade when h, l and b are all fixed, else nothing."""
        h, l, b = (extent.fixed for extent in self.geometry.extents.values())
        return None if h is None or l is None or b is None else Blade(h, l, b)

    def scene(self, name: str) -> Scene:
        """Return one case in the terms of each joint, or raise :class:`MechanismError`."""
        case, mechanism, geometry = self.cases[name], self.mechanism, self.geometry
        values: dict[str, Value] = {}
        travel = mean = 0.0
        cycles = None
        if case.stroke is not None:
            cycles = case.stroke.cycles
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
            unit = "rad" if geometry.motion == "rotation" else "m"
            symbol = "theta_stroke" if unit == "rad" else "x_stroke"
            values[symbol] = Value(travel, unit, "stroke of each joint (amplitude)")
        forces = self._forces(case, values)
        force_name = max(forces, key=lambda key: forces[key]) if forces else ""
        force = forces.get(force_name, 0.0)
        direction = case.load.direction if case.load else getattr(mechanism, "bisector", 0.0)
        try:
            share = geometry.axial_share(direction) if force else 0.0
        except NotAvailable as error:
            raise MechanismError("load", f"a {geometry.kind} {error}", "") from error
        ends, why = case.ends, "stated in the case"
        if ends is None and case.lock is not None and mechanism is not None:
            ends, why = "clamped-clamped", f"lock: {case.lock} keeps both ends from turning"
        steady = case.acceleration
        return Scene(
            case=name,
            travel=travel,
            mean_travel=mean,
            cycles=cycles,
            force=force,
            force_name=force_name,
            axial_share=share,
            ends=ends,
            ends_why=why if ends else "",
            acceleration=steady.level if steady else 0.0,
            axis=steady.axis if steady else "",
            values=values,
        )

    def _forces(self, case: Case, values: dict[str, Value]) -> dict[str, float]:
        """Return the forces on the joints of a case, adding what was found on the way."""
        forces: dict[str, float] = {}
        if case.load is not None:
            forces["F"] = case.load.force
        level, prefix = 0.0, ""
        if case.acceleration is not None and (case.lock or case.acceleration.axis == "y"):
            level, prefix = case.acceleration.level, "F_steady"
        if case.asd is not None:
            if self.mechanism is None:
                raise MechanismError(
                    "asd", "a vibration needs masses that it shakes", "add a mechanism"
                )
            asd = case.asd
            profile = asd.profile
            worst = miles_worst_case(
                profile.frequencies, profile.levels, asd.q, scale=profile.scale
            )
            rms = float(worst.response)
            values["f_worst"] = Value(worst.frequency, "Hz", "frequency of the worst case")
            values["g_rms_worst"] = Value(
                rms, "m/s^2", f"worst rms acceleration, Q = {asd.q:g}",
                source="Miles, √(π/2 f Q ASD), over all frequencies",
            )  # fmt: skip
            level += asd.sigma * rms
            prefix = f"F_{asd.sigma:g}sigma"
        if level == 0.0:
            return forces
        if self.mechanism is None:
            raise MechanismError(
                "acceleration", "an acceleration needs a mass that it acts on", "add a mechanism"
            )
        for suffix, (force, label) in self.mechanism.body_forces(level).items():
            values[f"{prefix}{suffix}"] = Value(force, "N", label)
        if case.lock is None:
            loads = {"F": self.mechanism.free_force(level)}
        else:
            loads = self.mechanism.locked_forces(case.lock, level)
        for name, force in loads.items():
            values[name] = Value(force, "N", "force on a pivot" if len(loads) > 1 else "force")
            forces[name] = forces.get(name, 0.0) + force
        return forces

    def limits(self, blade: Blade) -> list[Limit]:
        """Return every limit of every requirement in every case, on floats or signomials."""
        return [limit for _, found in self._limits_by_path(blade) for limit in found]

    def _limits_by_path(
        self, blade: Blade
    ) -> Iterator[tuple[tuple[str | int, ...], Iterator[Limit]]]:
        scenes = [self.scene(name) for name in self.cases]
        for path, requirement in self.requirements.each():
            relevant = [s for s in scenes if requirement.applies(s)]
            for scene in relevant if requirement.per_case else scenes[:1]:
                ask = Ask(self.material, self.geometry, self.mechanism, blade, scene)
                yield path, requirement.limits(ask)

    def problems(self) -> list[Problem]:
        """Return what does not fit between parts that are sound each, all in one pass."""
        found = []
        for name in self.cases:
            try:
                self.scene(name)
            except MechanismError as error:
                found.append(Problem(("cases", name, error.at), str(error), error.hint))
        if found:
            return found
        probe = Blade(*(extent.fixed or 1e-3 for extent in self.geometry.extents.values()))
        for path, requirement in self.requirements.each():
            found.extend(self._requirement_problems(("requirements", *path), requirement, probe))
        return found

    def _requirement_problems(
        self, path: tuple[str | int, ...], requirement: Any, probe: Blade
    ) -> Iterator[Problem]:
        for index, name in enumerate(getattr(requirement, "cases", None) or ()):
            if name not in self.cases:
                known = ", ".join(self.cases)
                yield Problem(
                    (*path, "cases", index), f"there is no case '{name}'", f"cases are: {known}"
                )
        scenes = [self.scene(name) for name in self.cases]
        relevant = [s for s in scenes if requirement.applies(s)]
        if not relevant:
            yield Problem(
                path,
                f"no case has what '{requirement.label}' is about",
                "add a case that loads it, or take the requirement out",
            )
        for scene in relevant if requirement.per_case else relevant[:1]:
            try:
                list(
                    requirement.limits(
                        Ask(self.material, self.geometry, self.mechanism, probe, scene)
                    )
                )
            except RequirementError as error:
                yield Problem(path, str(error), error.hint)
