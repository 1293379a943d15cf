"""The named numbers of a design by a model, each with its estimated error."""

from collections.abc import Iterable, Mapping
from math import sqrt

from flexcli.engine.admissible_stroke import admissible_stroke
from flexcli.engine.models import NamedModel
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import NotAvailable, Sizes
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements import AS_PRINTED, Ask, JointModel
from flexcli.parts.scene import Scene, largest_travel
from flexcli.results import QuantityKind, Value

__all__ = [
    "case_values",
    "stated_strength",
    "values",
    "with_errors",
    "with_whole",
]

STRENGTHS = ("admissible_stress", "fatigue_amplitude", "yield_strength")
"""What an admissible stroke is stated for: the first that the material gives."""


def values(
    design: DesignSpec, sizes: Sizes, joint_model: JointModel = AS_PRINTED
) -> dict[str, Value]:
    """Return the named numbers of a design by a model: sizes, cases, joint and mechanism."""
    geometry, material = design.geometry, design.material
    found = {
        name: Value(float(size), "m", geometry.label(name), model="given")
        for name, size in sizes._asdict().items()
    }
    asks = design.asks(sizes, joint_model)
    scenes = [ask.scene for ask in asks]
    found |= case_values(scenes)
    rest = design.ask(scenes[0].at_assembly(), sizes, joint_model)
    stiffness = float(joint_model.stiffness(rest))
    symbol = "k_pivot" if geometry.motion == "rotation" else "k_stage"
    found[symbol] = Value(
        stiffness,
        geometry.stiffness_unit,
        "stiffness of a joint",
        joint_model.name,
        geometry.source,
        kind=QuantityKind.STIFFNESS,
    )
    found["volume"] = Value(
        float(geometry.volume(sizes)), "m^3", "volume of what flexes in a joint",
        estimated_error=0.0,
    )  # fmt: skip
    found |= geometry.values(material.elastic, sizes, largest_travel(scenes))
    found |= _admissible(design, rest)
    for ask in asks:
        found |= _shift(ask, found)
    if design.mechanism is not None:
        found.update(design.mechanism.values(stiffness, geometry))
    found.update(_own_frequency(rest, found))
    for ask in asks:
        found.update(_sag(ask))
        found.update(_warm(ask))
    if design.actuator is not None:
        from flexcli.engine.drive_values import drive_values

        found.update(drive_values(design, sizes))
    return found


def _warm(ask: Ask) -> dict[str, Value]:
    """Return how far the temperature of a case alone moves the joint, where it stands there."""
    if ask.scene.temperature is None:
        return {}
    names = {"x": "motion along x", "y": "motion along y", "theta": "rotation"}
    model = "exact"
    try:
        if ask.geometry.in_space:
            from flexcli.parts.space_states import left_by_temperature

            moved, model = left_by_temperature(ask), "linear"
            names = {axis: f"motion along {axis}" for axis in "xyz"}
            names |= {f"theta_{axis}": f"rotation about {axis}" for axis in "xyz"}
        else:
            from flexcli.engine.joint_models.joint_states import at_temperature

            moved = at_temperature(ask)
    except NotAvailable:
        return {}
    return {
        f"{name}_{ask.scene.case}": Value(
            value, "rad" if "theta" in name else "m", f"{what} by the temperature alone", model
        )
        for (name, what), value in zip(names.items(), moved, strict=True)
    }


def _own_frequency(ask: Ask, found: Mapping[str, Value]) -> dict[str, Value]:
    """Return the natural frequency, of all that a layout draws with a mass, by the model."""
    factor = ask.joint_model.frequency_factor(ask)
    if not ask.geometry.has_masses:
        return _corrected_frequencies(found, factor, ask.joint_model.name)
    value = sqrt(ask.joint_model.frequency_squared(ask))
    source = "lowest mode of all bodies that the motion takes part in"
    return {
        "f_0": Value(
            value,
            "Hz",
            "natural frequency",
            ask.joint_model.name,
            source,
            kind=QuantityKind.FREQUENCY,
        )
    }


def _corrected_frequencies(
    found: Mapping[str, Value], factor: float, model: str
) -> dict[str, Value]:
    """Return the frequencies of one freedom, that before balancing with as much mass added."""
    changed = {
        name: found[name]._replace(value=found[name].value * factor, model=model)
        for name in ("f_0", "f_final")
        if name in found
    }
    if "f_init" in found:
        before, after = (found[f"m_eq_{when}"].value for when in ("init", "final"))
        added = after * (factor**-2 - 1.0)
        value = found["f_init"].value * sqrt(before / (before + added))
        changed["f_init"] = found["f_init"]._replace(value=value, model=model)
    return changed


def with_whole(values: Mapping[str, Value], whole: Mapping[str, Value]) -> dict[str, Value]:
    """Return values with errors that reach to those of the design that nothing is left out of."""

    def error(name: str, value: Value) -> float | None:
        other = whole.get(name)
        if value.estimated_error is None or other is None or other.estimated_error is None:
            return None
        if value.value == other.value:
            return max(value.estimated_error, other.estimated_error)
        if value.value == 0.0:
            return None
        ratio = other.value / value.value
        return max(value.estimated_error, abs(ratio - 1.0) + abs(ratio) * other.estimated_error)

    return {n: v._replace(estimated_error=error(n, v)) for n, v in values.items()}


def with_errors(values: Mapping[str, Value], errors: Mapping[str, float]) -> dict[str, Value]:
    """Return values with their estimated errors, from those of the quantities they are of."""

    def error(value: Value) -> float | None:
        if value.model == "given":
            return 0.0
        return errors.get(value.kind) if value.kind is not None else value.estimated_error

    return {name: v._replace(estimated_error=error(v)) for name, v in values.items()}


def case_values(scenes: Iterable[Scene]) -> dict[str, Value]:
    """Return what the cases ask of each joint; names that differ between cases end in theirs."""
    found: dict[str, Value] = {}
    for scene in scenes:
        for key, value in scene.values.items():
            is_new = key not in found or found[key] == value
            found[key if is_new else f"{key}_{scene.case}"] = value
    return found


def stated_strength(material: Material) -> tuple[str, float] | None:
    """Return what an admissible stroke is stated for, with its name, where the material has it."""
    name = next((name for name in STRENGTHS if getattr(material, name) is not None), None)
    return (name, material.strength(name)) if name is not None else None


def _admissible(design: DesignSpec, ask: Ask) -> dict[str, Value]:
    """Return the travel at which the stress reaches the strength that the material states."""
    geometry, stated = design.geometry, stated_strength(design.material)
    if stated is None or not geometry.is_linear:
        return {}
    name, strength = stated
    if ask.joint_model.name == "shell":  # it is sought over many strokes: beams are fast
        ask = ask._replace(joint_model=NamedModel(design, "exact").joint_model)
    found = admissible_stroke(ask, strength)
    if found is None:
        return {}
    text = f"stroke at which the stress reaches the {name.replace('_', ' ')}"
    return {
        f"{geometry.travel_symbol}_adm": Value(
            found.travel,
            geometry.travel_unit,
            text,
            ask.joint_model.name,
            estimated_error=found.error,
        )
    }


def _shift(ask: Ask, known: Mapping[str, Value]) -> dict[str, Value]:
    """Return the parasitic shift at the end of a case's stroke, where the model has it."""
    if not ask.scene.moves:
        return {}
    try:
        shift = float(ask.joint_model.parasitic_shift(ask))
    except NotAvailable:
        return {}
    name = "shift" if "shift" not in known else f"shift_{ask.scene.case}"
    label = "parasitic shift at full stroke, positive towards the base"
    if ask.geometry.in_space:
        label = "how far it leaves its path at full stroke"
    return {
        name: Value(
            shift, "m", label, ask.joint_model.name, ask.geometry.source, kind=QuantityKind.SHIFT
        )
    }


def _sag(ask: Ask) -> dict[str, Value]:
    """Return sag and stiffness along a steady acceleration, where the model has them."""
    scene = ask.scene
    if not scene.sags:
        return {}
    try:
        stiffness = float(ask.joint_model.sag_stiffness(ask))
        sag = float(ask.joint_model.sag(ask))
    except (NotAvailable, MechanismError):
        return {}
    source, axis, model = ask.geometry.source, scene.axis, ask.joint_model.name
    return {
        f"k_{axis}": Value(
            stiffness, "N/m", f"stiffness along {axis}", model, source, kind=QuantityKind.SAG
        ),
        f"sag_{axis}": Value(
            sag, "m", f"sag along {axis}", model, "m a / K", kind=QuantityKind.SAG
        ),
    }
