"""A design: material, geometry, mechanism, cases and requirements, joined and consistent."""

from collections.abc import Iterator, Sequence
from contextlib import suppress
from math import atan2, hypot
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, TypeAlias

from pydantic import (
    Field,
    GetJsonSchemaHandler,
    PrivateAttr,
    model_validator,
)
from pydantic_core import CoreSchema

from flexcli.errors import SolveError
from flexcli.parts.base import Part, QuantityOf, spec_error
from flexcli.parts.case import Case
from flexcli.parts.default_quality import with_default_quality
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import EFFECTS, SCENE_EFFECTS
from flexcli.parts.geometries import BEAM_EFFECTS, AnyGeometry, Geometry, NotAvailable, Sizes
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import AnyMechanism, MechanismError
from flexcli.parts.named import Named
from flexcli.parts.requirements import (
    AS_PRINTED,
    Ask,
    JointModel,
    Limit,
    Requirement,
    RequirementError,
    Requirements,
    are_at_rest,
)
from flexcli.parts.requirements.stand_in import STAND_IN
from flexcli.parts.scene import Scene
from flexcli.parts.scene_of_case import scene_of
from flexcli.results import EXACT

if TYPE_CHECKING:
    from flexcli.mechanics.layout import Layout
    from flexcli.mechanics.space.layout import SpaceLayout
    from flexcli.parts.actuator import Actuator
    from flexcli.parts.balancing import BalanceOptions
    from flexcli.parts.manufacturing import Manufacturing
    from flexcli.parts.sizing import SizeOptions
    from flexcli.parts.stops import Stops
    from flexcli.parts.study import Study
    from flexcli.parts.tolerances import Robust, Tolerance
    from flexcli.parts.trade_off import MovingBound
else:
    Actuator = Annotated[Any, Named("flexcli.parts.actuator:Actuator")]
    BalanceOptions = Annotated[Any, Named("flexcli.parts.balancing:BalanceOptions")]
    Manufacturing = Annotated[Any, Named("flexcli.parts.manufacturing:Manufacturing")]
    SizeOptions = Annotated[Any, Named("flexcli.parts.sizing:SizeOptions")]
    Stops = Annotated[Any, Named("flexcli.parts.stops:Stops")]
    Study = Annotated[Any, Named("flexcli.parts.study:Study")]
    Tolerance = Annotated[Any, Named("flexcli.parts.tolerances:Tolerance")]
    Robust = Annotated[Any, Named("flexcli.parts.tolerances:Robust")]

__all__ = ["DesignSpec", "ModelName", "Problem"]

IN_PLANE = 1e-6
"""Slope of a blade against its wafer below which it lies in it."""

CASE_KEYS = tuple(Case.model_fields)
EffectKey: TypeAlias = Literal[tuple(effect.key for effect in EFFECTS)]  # type: ignore[valid-type]
Wish: TypeAlias = Literal["auto", "on", "off"]
ModelName: TypeAlias = Literal["source", "closed-form", "linear", "exact", "shell", "solid"]


class Problem(NamedTuple):
    """A conflict between parts that are valid by themselves: path, text, hint."""

    path: tuple[str | int, ...]
    text: str
    hint: str


class FreeParameter(Part):
    """A parameter of a drawing that a sizing chooses."""

    free: tuple[str | float, str | float]
    """The least and the most that it may be, e.g. ``[20 mm, 60 mm]``."""


class DesignSpec(Part):
    """The design file."""

    flexure: Literal[1]
    """Version of the format, e.g. ``1``."""
    title: str = ""
    """Title that reports print, e.g. ``Focus stage, take-off``."""
    material: Material
    """Material of what flexes: inline, the name of a shipped one, or a path, e.g. ``ti-6al-4v``."""
    geometry: AnyGeometry
    """The joint or stage and its sizes, given or free: inline, the name of a shipped one, or a
    path,
    e.g. ``{kind: rcc, p: 2 mm, half_angle: 45 deg, h: free, l: free, b: 10 mm}``.
    """
    parameters: dict[str, str | float | FreeParameter] = Field({})
    """Numbers by names of your own, of which sums and products stand for sizes of a drawing; one
    that is free between two, as ``{free: [20 mm, 60 mm]}``, is chosen by size,
    e.g. ``parameters: {l: 20 mm}, geometry: {kind: layout, bodies: {tip: {at: [l, 0 mm]}},
    blades: {only: {between: [ground, tip], from: [0 mm, 0 mm], to: [l, 0 mm], h: l/100, b: 5 mm}},
    moving: tip, motion: {translation: 90 deg}}``.
    """
    mechanism: AnyMechanism | None = None
    """Bodies that the joints carry, e.g. ``{kind: payload, mass: 20 g, inertia: 5e-6 kg*m^2}``."""
    actuator: Actuator | None = None
    """What drives the stroke, whose force at the stroke ``drive`` judges,
    e.g. ``{blocking_force: 5.5 N, free_stroke: 85 um, drives: both-ways}``.
    """
    cases: dict[str, Case] = Field(min_length=1)
    """What the flexure lives through, by names of your own; a single case may stand at the top
    level,
    e.g. ``{operation: {stroke: {rotation: 1 deg, cycles: 1e6}}}``.
    """
    requirements: Requirements
    """What is asked of the design; nothing is implied, e.g. ``{fatigue: 2.5, yield: 1.5}``."""
    size: SizeOptions | None = None
    """How 'flexure size' chooses the free sizes,
    e.g. ``{objective: balanced, round: {h: 1 um, l: 0.5 mm}}``.
    """
    balance: BalanceOptions | None = None
    """What 'flexure balance' reports of the mechanism,
    e.g. ``{frequencies: [1 Hz, 10 Hz, 100 Hz]}``.
    """
    stops: Stops | None = None
    """End stops along a blade with a tip mass,
    e.g. ``{height: 10 mm, gap: 0.2 mm, bending: 1.5, simulation: {modes: 3}}``.
    """
    manufacturing: Manufacturing | None = None
    """What the process can make: a design beyond it fails,
    e.g. ``{process: wire-edm, least_thickness: 60 um, least_radius: 0.15 mm}``.
    """
    study: Study | None = None
    """What 'flexure sweep' varies, and what it does at each point,
    e.g. ``{vary: {geometry.p: {from: 1 mm, to: 3 mm, points: 5}}, each: check}``.
    """
    tolerances: dict[str, Tolerance] = Field({})
    """By how much sizes, properties and other numbers of the spec differ from part to part,
    e.g. ``{h: 5 um, youngs_modulus: 2 %}``.
    """
    robust: Robust | None = None
    """What shall pass of all parts within the tolerances: a share, or the worst case,
    e.g. ``{parts: 99.7 %}``.
    """
    accuracy: Annotated[float, QuantityOf("ratio", above=0.0, below=1.0)] | None = None
    """Error that every reported number may have; effects are on where it needs them,
    e.g. ``1 %``.
    """
    effects: dict[EffectKey, Wish] = Field({})
    """Effects that are asked for or left out of the values, though not of their errors; auto where
    nothing is said, e.g. ``{shear: on, gravity: off}``.
    """
    model: ModelName | None = None
    """Model that judges all checks; left out, each is judged by the cheapest that decides,
    e.g. ``exact``.
    """

    _felt: tuple[Geometry, Geometry] | None = PrivateAttr(None)

    @model_validator(mode="before")
    @classmethod
    def _single_case(cls, data: Any) -> Any:
        """Take a single case from the top level; what is asked of a design at rest needs none."""
        if not isinstance(data, dict) or "cases" in data:
            return data
        loose = [key for key in data if key in CASE_KEYS]
        if not loose and are_at_rest(data.get("requirements")):
            return {**data, "cases": {"design": Case.at_rest()}}
        if not loose:
            return data
        rest = {key: value for key, value in data.items() if key not in CASE_KEYS}
        return {**rest, "cases": {"design": {key: data[key] for key in loose}}}

    @model_validator(mode="before")
    @classmethod
    def _material_damps(cls, data: Any) -> Any:
        """Give cases that vibrate without a stated Q that of the mechanism or the material."""
        return with_default_quality(data)

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        properties, required = whole["properties"], whole["required"]
        (cases,) = properties["cases"].get("allOf", [properties["cases"]])
        case = handler.resolve_ref_schema(cases["additionalProperties"])["properties"]
        single = {"anyOf": [{"required": [key]} for key in case]} if "cases" in required else True
        return {
            **whole,
            "properties": properties | case,
            "required": [key for key in required if key != "cases"],
            "if": {"required": ["cases"]},
            "then": {"properties": dict.fromkeys(case, False)},
            "else": single,
        }

    @model_validator(mode="after")
    def _joints_fit(self) -> "DesignSpec":
        kind = self.mechanism.joint_kind if self.mechanism else None
        if kind is not None and kind != self.geometry.name:
            raise spec_error(
                f"a tip mass sits on a {kind}, not on a {self.geometry.name}",
                f"take kind: {kind}, or another mechanism",
                at=("geometry", "kind"),
            )
        if self.mechanism is not None and self.geometry.in_space:
            raise spec_error(
                f"a {self.geometry.name} carries no mechanism",
                "give its bodies their masses, and take this out",
                at=("mechanism",),
            )
        wanted = self.mechanism.joint_motion if self.mechanism else None
        if wanted is not None and wanted != self.geometry.motion:
            raise spec_error(
                f"this mechanism turns on pivots; a {self.geometry.name} does not turn",
                "take a pivot, e.g. kind: rcc",
                at=("geometry", "kind"),
            )
        return self

    @model_validator(mode="after")
    def _material_is_oriented(self) -> "DesignSpec":
        """Orient the material along the blades, where its stiffness depends on the direction."""
        if self.material.is_directed:
            self.__dict__["material"] = self.material.oriented(self.blade_angles())
        return self

    def blade_angles(self) -> tuple[float, ...]:
        """Return the angles of the blades in the plane from x as drawn [rad]."""
        layout = self.drawn(self.geometry.probe())
        if layout is None:
            return (0.0,)
        found = []
        for blade in layout.blades:
            x, y, *z = (float(e) - float(s) for s, e in zip(blade.start, blade.end, strict=True))
            if z and abs(z[0]) > IN_PLANE * hypot(x, y):
                raise spec_error(
                    f"{blade.name} leaves the plane of the wafer or sheet",
                    "draw it in x and y, or give it a material without an orientation",
                    at=("material",),
                )
            found.append(atan2(y, x) - self.geometry.drawn_turn)
        return tuple(found)

    @model_validator(mode="after")
    def _actuator_fits(self) -> "DesignSpec":
        if self.actuator is not None:
            self.actuator.refuse_misfit(self.geometry, self.mechanism)
        return self

    @model_validator(mode="after")
    def _stops_fit(self) -> "DesignSpec":
        if self.stops is not None:
            self.stops.refuse_misfit(self.material, self.geometry, self.mechanism)
            for name, case in self.cases.items():
                if case.temperature is not None and case.shaken_axes:
                    raise spec_error(
                        "a vibration between stops is judged at assembly, not at a temperature",
                        "give the temperature a case of its own",
                        at=("cases", name, "temperature"),
                    )
        return self

    @model_validator(mode="after")
    def _tolerances_fit(self) -> "DesignSpec":
        if self.tolerances or self.robust is not None:
            from flexcli.parts.tolerances import refuse_misfit

            refuse_misfit(self)
        return self

    @model_validator(mode="after")
    def _sizing_fits(self) -> "DesignSpec":
        if self.size is not None:
            from flexcli.parts.trade_off import refuse_misfit

            refuse_misfit(self, self.size)
        return self

    @property
    def sizing(self) -> "SizeOptions":
        """Return how its free sizes are chosen: as it says, or as is usual."""
        if self.size is not None:
            return self.size
        from flexcli.parts.sizing import SizeOptions

        return SizeOptions.model_construct()

    @property
    def pursued(self) -> "MovingBound | None":
        """Return the requirement that a sizing makes the most of, where its objective names one."""
        if self.size is None:
            return None
        from flexcli.parts.trade_off import pursued_bound

        return pursued_bound(self, self.size)

    @model_validator(mode="after")
    def _scene_effects_are_there(self) -> "DesignSpec":
        for effect in SCENE_EFFECTS:
            wish = self.effects.get(effect.key, "auto")
            if wish == "on" or (wish == "off" and not effect.excludes):
                raise spec_error(
                    f"'{effect.key}' is on exactly where the design states it",
                    "leave it out here, and change what the cases or the mechanism state",
                    at=("effects", effect.key),
                )
        return self

    def redrawn(self, sizes: Sizes) -> tuple["DesignSpec", Sizes]:
        """Return the design drawn at given values of its free parameters, and its sizes.

        Raises
        ------
        NotAvailable
            Where it cannot be drawn.

        """
        geometry, own = self.geometry.drawn(sizes)
        if geometry is self.geometry:
            return self, sizes
        return self.model_copy(update={"geometry": geometry}), own

    def fixed_sizes(self) -> Sizes | None:
        """Return the sizes when all are fixed, else nothing."""
        return None if self.geometry.free else self.geometry.sized({})

    def scene(self, name: str) -> Scene:
        """Return one case in the terms of each joint, or raise :class:`MechanismError`."""
        case, out = self.cases[name], self.switched_off(name)
        if out:
            case = case.model_copy(update={key: None for _, key in out})
        return scene_of(name, case, self.mechanism, self.geometry.in_the_middle())

    def scenes(self) -> list[Scene]:
        """Return every case in the terms of each joint."""
        return [self.scene(name) for name in self.cases]

    def switched_off(self, case: str) -> list[tuple[str, str]]:
        """Return the effects that the spec switches off, each with the load that it removes."""
        if not self.effects:
            return []
        return [
            (e.key, key)
            for e in SCENE_EFFECTS
            if self.is_off(e.name)
            for key in e.excludes
            if getattr(self.cases[case], key) is not None
        ]

    def is_off(self, effect: EffectName) -> bool:
        """Return whether the spec switches an effect off."""
        return bool(self.effects.get(effect.key) == "off")

    def drawn(self, sizes: Sizes) -> "Layout | SpaceLayout | None":
        """Return where the blades and bodies of a joint are; nothing where it has no blades."""
        elastic = self.material.elastic
        try:
            geometry, own = self.geometry.drawn(sizes)
            if geometry.in_space:
                return geometry.space_layout(elastic, own)
            return geometry.layout(elastic, own)
        except NotAvailable:
            return None

    def ask(self, scene: Scene, sizes: Sizes, joint_model: JointModel) -> Ask:
        """Return what a requirement of one case is judged by: design, case, material, model.

        The sources' formulas are of a plane: their body stays upright.

        Raises
        ------
        SolveError
            When the material says nothing of that temperature.

        """
        drawn, own = self.geometry.drawn(sizes)
        geometry = self._as_felt(drawn)
        material, temperature = self.material, scene.temperature
        if temperature is not None:
            try:
                layout = self.drawn(sizes)
                if layout is not None:
                    material = temperature.of_blades(material, layout, geometry.axes)
            except NotAvailable as error:
                raise SolveError("outside-material", str(error), "give it there too") from error
        if joint_model.name == "source":
            scene = scene._replace(tilts=False)
        return Ask(material, geometry, self.mechanism, own, scene, joint_model, self.actuator)

    @property
    def omitted(self) -> frozenset[EffectName]:
        """Return the effects that the spec leaves out of blades in space."""
        return frozenset(name for name in BEAM_EFFECTS if self.is_off(name))

    @property
    def whole(self) -> "DesignSpec":
        """Return the design with all effects of blades in space, omitted ones too."""
        keys = {name.key for name in self.omitted}
        if not keys:
            return self
        kept = {key: wish for key, wish in self.effects.items() if key not in keys}
        return self.model_copy(update={"effects": kept})

    def _as_felt(self, geometry: Geometry) -> Geometry:
        """Return a geometry without the omitted effects, the same object for the same geometry."""
        if not self.omitted:
            return geometry
        if self._felt is None or self._felt[0] is not geometry:
            self._felt = geometry, geometry.omitting(self.omitted)
        return self._felt[1]

    def asks(self, sizes: Sizes, joint_model: JointModel) -> list[Ask]:
        """Return the design, model and case for every case."""
        return [self.ask(scene, sizes, joint_model) for scene in self.scenes()]

    def limits(self, sizes: Sizes, joint_model: JointModel = AS_PRINTED) -> list[Limit]:
        """Return every limit of every requirement in every case, on floats, by a model."""
        return list(self._limits(sizes, joint_model, closed_form=False))

    def closed_limits(self, sizes: Sizes) -> list[Limit]:
        """Return the limits that are formulas, on floats, arrays or signomials."""
        return list(self._limits(sizes, AS_PRINTED, closed_form=True))

    def _limits(
        self, sizes: Sizes, joint_model: JointModel, *, closed_form: bool
    ) -> Iterator[Limit]:
        yield from self.own_limits(sizes)
        for requirement, scene in self.questions(self.scenes()):
            if closed_form and not (self.geometry.closed_forms or requirement.of_the_drawing):
                continue
            ask = self.ask(scene, sizes, joint_model)
            if not closed_form:
                yield from requirement.judged(ask)
            elif requirement.closed_form:
                with suppress(NotAvailable):  # other models judge what has no formula
                    yield from requirement.limits(ask)

    def questions(self, scenes: Sequence[Scene]) -> Iterator[tuple[Requirement, Scene]]:
        """Yield every requirement with each case that it applies to; once where it is of no case.

        Of the latter those that a temperature changes are repeated for each temperature.
        """
        for _, requirement in self.requirements.each():
            relevant = [scene for scene in scenes if requirement.applies(scene)]
            if not requirement.is_of_a_case:
                warm = [scene for scene in scenes if scene.temperature is not None]
                relevant = [scenes[0].at_assembly(), *(warm if requirement.is_warmed else ())]
            for scene in relevant:
                yield requirement, scene

    def own_limits(self, sizes: Sizes) -> Iterator[Limit]:
        """Yield the limits of mechanism, process and the joint's shape, whatever is required."""
        yield from self.coupling_limits()
        geometry, drawn = self.geometry.drawn(sizes)
        if self.manufacturing is not None:
            yield from self.manufacturing.limits(geometry, drawn)
        for text, small, large in geometry.fits(drawn):
            shape = "the joint's own shape"
            yield Limit(
                "geometry", "", text, small, large, "m", shape, error=EXACT, path=("geometry",)
            )

    def coupling_limits(self) -> Iterator[Limit]:
        """Yield the limit of a mechanism on its coupling to the base."""
        limit = self.mechanism.coupling_limit() if self.mechanism else None
        if limit is not None:
            yield Limit(
                "coupling",
                "",
                "coupling to the base's acceleration",
                *limit,
                "kg",
                "force balance: |τ| over that without balancing masses",
                variant="max",
                error=EXACT,
                path=("mechanism", "coupling"),
            )

    def problems(self) -> list[Problem]:
        """Return the conflicts between parts that are valid by themselves, all in one pass."""
        found: list[Problem] = []
        scenes = []
        for name in self.cases:
            try:
                scenes.append(self.scene(name))
            except MechanismError as error:
                found.append(Problem(("cases", name, error.at), str(error), error.hint))
            found.extend(self._temperature_problems(name))
        probe = self.geometry.probe()
        for path, requirement in self.requirements.each():
            found.extend(
                self._requirement_problems(("requirements", *path), requirement, probe, scenes)
            )
        return found

    def _temperature_problems(self, name: str) -> Iterator[Problem]:
        """Yield the properties that the material lacks at the temperature of a case."""
        temperature, path = self.cases[name].temperature, ("cases", name, "temperature")
        if temperature is None:
            return
        if not self.material.expands:
            hint = "give it, e.g. 8.6e-6 1/K"
            yield Problem(path, "the material has no thermal_expansion", hint)
        layout = self.drawn(self.geometry.probe())
        if layout is None:
            return
        axes, others = self.geometry.axes, self.geometry.body_materials
        for body, material in others.items():
            if not material.expands and body not in temperature.expansion:
                hint = "give it one, or temperature.expansion of the body"
                yield Problem(path, f"the material of {body} has no thermal_expansion", hint)
        bodies = temperature.changes(layout, axes).bodies
        asked = [(self.material, temperature.temperatures(layout, axes, others))]
        asked += [(m, (temperature.assembly + bodies[body],)) for body, m in others.items()]
        for material, reached in asked:
            known = material.over_temperature
            if known is not None and (beyond := known.refused(reached)):
                text = f"the material is not given from {min(reached):g} to {max(reached):g} K"
                yield Problem(path, text, f"it has {', '.join(beyond)} over temperature")

    def _hint_to_load(self) -> str:
        """Return what would give a requirement something to judge."""
        several = self.mechanism is not None and self.mechanism.joints > 1
        if several and any(case.acceleration and not case.lock for case in self.cases.values()):
            return "an acceleration of it is judged with lock:, or where it is a space-layout"
        return "add a case that loads it, or take the requirement out"

    def _requirement_problems(
        self, path: tuple[str | int, ...], requirement: Any, probe: Sizes, scenes: list[Scene]
    ) -> Iterator[Problem]:
        named = getattr(requirement, "cases", None) or ()
        unknown = [index for index, name in enumerate(named) if name not in self.cases]
        for index in unknown:
            yield Problem(
                (*path, "cases", index),
                f"there is no case '{named[index]}'",
                f"cases are: {', '.join(self.cases)}",
            )
        relevant = [s for s in scenes if requirement.applies(s)]
        if not relevant and not unknown and len(scenes) == len(self.cases):
            yield Problem(
                path,
                f"no case has what '{requirement.label}' is about",
                self._hint_to_load(),
            )
        asked = relevant if requirement.is_of_a_case else [s.at_assembly() for s in relevant[:1]]
        for scene in asked:
            try:
                # whatever its temperature makes of the material
                geometry, sizes = self.geometry.drawn(probe)
                ask = Ask(
                    self.material, geometry, self.mechanism, sizes, scene, STAND_IN, self.actuator
                )
                list(requirement.judged(ask))
            except RequirementError as error:
                yield Problem(path, str(error), error.hint)
