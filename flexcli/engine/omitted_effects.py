"""What the model of a design leaves out, and what a reviewer must know beside the margins."""

from collections.abc import Iterator, Mapping
from math import isfinite

from flexcli.parts.design import DesignSpec
from flexcli.parts.effects import MODEL_EFFECTS, Setting
from flexcli.parts.geometries import Sizes
from flexcli.parts.material import STRENGTHS, WARM
from flexcli.parts.requirements import AS_PRINTED, JointModel
from flexcli.parts.scene import Scene
from flexcli.results import EffectRow, Note, QuantityKind, Value
from flexcli.units import show

__all__ = ["NOTABLE", "effects", "errors_of", "of_assembly", "reported", "setting", "warnings"]

NOTABLE = 0.05
"""An effect left out that may change a number by more than this is a warning, not only a row."""

ALIKE = 1e-9
"""Share by which a number differs from itself by rounding."""

NEAR = 30.0
"""Change of temperature [K] up to which no property of a metal is worth a word."""

MADE = 5e-6
"""Thickness [m] below which a blade is no longer machined, etched or cut from foil as a rule."""


def setting(design: DesignSpec, sizes: Sizes) -> Setting:
    """Return a design as effects are estimated on it."""
    scenes = tuple(design.scenes())
    asked = design.requirements
    return Setting(
        design.material, design.geometry, design.mechanism, sizes, scenes, design.stops,
        supports=bool(asked.support or asked.deflection) or any(s.across_by for s in scenes),
    )  # fmt: skip


def reported(design: DesignSpec, given: Setting) -> tuple[str, ...]:
    """Return which numbers of the joint a design reports, of those that effects change."""
    asked = design.requirements
    shift = design.geometry.closed_forms and any(s.moves for s in given.scenes)
    held = any(s.blade_force for s in given.scenes)
    hangs = asked.sag is not None or any(s.sags for s in given.scenes)
    has = {
        "stiffness": True,
        "stress": bool(asked.fatigue or asked.yielding),
        "shift": shift,
        "buckling": asked.buckling is not None and held,
        "sag": design.mechanism is not None and hangs,
        "frequency": design.mechanism is not None,
    }
    return tuple(name for name, there in has.items() if there)


def effects(
    design: DesignSpec, sizes: Sizes, joint_model: JointModel = AS_PRINTED
) -> tuple[EffectRow, ...]:
    """Return the effects that this design can have, and which of them the model leaves out.

    Those of a mechanism that is drawn in space are in its springs, or in the errors of its model.
    """
    if design.geometry.in_space:
        return ()
    given = setting(design, sizes)
    names = (*reported(design, given), QuantityKind.SUPPORT.value)
    carries = joint_model.carried(given)
    rows = []
    for effect in MODEL_EFFECTS:
        indicator = effect.indicator(given)
        if indicator is None:
            continue
        all_estimates = effect.estimates(given)
        estimates = {name: all_estimates[name] for name in names if name in all_estimates}
        most = max(estimates, key=lambda name: estimates[name], default="")
        reason = f"{indicator.text}; most in {most}" if most else indicator.text
        size = estimates.get(most, 0.0)
        carried = effect.name in carries
        asked = design.effects.get(effect.key, "auto")
        rows.append(
            EffectRow(effect.name, carried, indicator.value, size, reason, estimates, asked)
        )
    return tuple(rows)


def errors_of(
    design: DesignSpec,
    sizes: Sizes,
    joint_model: JointModel,
    values: Mapping[str, Value],
    *,
    at_rest: bool = False,
) -> dict[str, float]:
    """Return the estimated error of a model's values by kind, the largest of all cases.

    Stiffness and frequency are those ``at_rest``, or may be at a stroke. A kind whose error nobody
    can estimate is not there.
    """
    asks, found = design.asks(sizes, joint_model), dict[str, float]()
    for kind in dict.fromkeys(value.kind for value in values.values() if value.kind is not None):
        each = [joint_model.error(ask, kind) for ask in asks]
        known = [
            None if error is None else ask.doubted(error, kind, at_rest=at_rest, is_own=at_rest)
            for ask, error in zip(asks, each, strict=True)
        ]
        if None not in known:
            found[kind.value] = max((e.largest for e in known if e is not None), default=0.0)
    return found


def warnings(design: DesignSpec, sizes: Sizes, rows: tuple[EffectRow, ...]) -> tuple[Note, ...]:
    """Return what a reviewer must know beside the margins."""
    notes: list[Note] = []
    if design.mechanism is not None:
        notes.extend(design.mechanism.notes())
    placeholders = design.material.placeholders()
    if placeholders:
        text = f"placeholder values, not physical: material.{', material.'.join(placeholders)}"
        notes.append(Note("placeholder-material", text))
    notes.extend(_damped_by_material(design))
    if design.material.crystal is not None and design.requirements.yielding:
        text = "a crystal breaks before it yields: its strength is that of a surface and a size "
        text += "(Weibull), and a factor on it says nothing of how many break"
        notes.append(Note("brittle", text))
    if design.requirements.fatigue is not None:
        single = design.material.fatigue_amplitude
        if single is not None and single.stress_ratio is None:
            text = "the source of the fatigue amplitude states no stress ratio; read as R = −1"
            notes.append(Note("stress-ratio-unstated", text))
    for scene in design.scenes():
        if scene.temperature is not None:
            notes.extend(_of_temperature(design, sizes, scene))
    notes.extend(_outside_validity(design, sizes))
    notes.extend(_own_shape(design, sizes))
    notes.extend(
        Note("effect-left-out", f"{row.name}, left out, may change results {_by(row.estimate)}")
        for row in rows
        if row.estimate >= NOTABLE and not row.on
    )
    return tuple(notes)


def _damped_by_material(design: DesignSpec) -> Iterator[Note]:
    """Yield the cases whose modes are damped by the material alone."""
    given = design.material.loss_factor
    if given is None:
        return
    for name, case in design.cases.items():
        if case.q is not None and abs(case.q.all * given.value - 1.0) < ALIKE:
            text = f"case '{name}' states no Q: {case.q.all:.4g} is that of the material's loss "
            text += "factor alone; clamps, air and what is mounted damp besides, by measurement"
            yield Note("material-damping", text)


def _of_temperature(design: DesignSpec, sizes: Sizes, scene: Scene) -> Iterator[Note]:
    """Yield which properties of the material are not those of a case's temperatures."""
    layout = design.drawn(sizes)
    temperature, known = scene.temperature, design.material.over_temperature
    if layout is None or temperature is None:
        return
    geometry = design.geometry
    asked = temperature.temperatures(layout, geometry.axes, geometry.body_materials)
    hottest = max(asked)
    most = max(abs(T - temperature.assembly) for T in asked)
    if known is not None and (beyond := known.continued(asked)):
        text = f"case '{scene.case}' reaches {hottest:.4g} K, beyond the points of the material: "
        text += f"{', '.join(beyond)}; taken by thermal_expansion, and as it is there"
        yield Note("beyond-points", text)
    yield from _held_across(design, sizes, scene)
    missing = of_assembly(design, sizes, scene)
    if missing:
        told = {"elongation": "thermal_expansion is one number"}
        parts = "; ".join(told.get(name, f"{name} is that at assembly") for name in missing)
        text = f"case '{scene.case}' is {most:.3g} K from assembly: {parts}"
        text += "; what that may change is in the errors"
        if hottest - temperature.assembly > WARM:
            text += f", and no strength that is not given is known {WARM:.0f} K above assembly"
        yield Note("at-assembly", f"{text}; material.over_temperature would give more")


def of_assembly(design: DesignSpec, sizes: Sizes, scene: Scene) -> tuple[str, ...]:
    """Return the properties known at assembly alone, in a case far enough from there to matter."""
    layout, temperature = design.drawn(sizes), scene.temperature
    if layout is None or temperature is None:
        return ()
    geometry, known = design.geometry, design.material.over_temperature
    asked = temperature.temperatures(layout, geometry.axes, geometry.body_materials)
    if max(abs(T - temperature.assembly) for T in asked) <= NEAR:
        return ()
    strengths = (name for name in STRENGTHS if getattr(design.material, name) is not None)
    given = known.given if known is not None else frozenset()
    each = ("elongation", "youngs_modulus", *strengths)
    return tuple(name for name in each if name not in given)


def _held_across(design: DesignSpec, sizes: Sizes, scene: Scene) -> Iterator[Note]:
    """Yield how far clamps stress blades that they keep from growing across, where nobody asks."""
    from flexcli.parts.held_at_clamps import held_at_clamps

    material, temperature = design.material, scene.temperature
    if temperature is None or design.requirements.yielding:
        return
    held = held_at_clamps(temperature, design.geometry, material, sizes)
    stress = 0.0 if held is None else held.middle
    strengths = [
        given.value for given in (material.yield_strength, material.tensile_strength) if given
    ]
    if stress > NOTABLE * min(strengths, default=0.0):
        text = f"case '{scene.case}': clamps keep blades from growing across, by some "
        text += f"{show(stress, 'Pa', 3)} there, which yield would judge and nothing here does"
        yield Note("held-across", text)


def _by(estimate: float) -> str:
    return f"by {estimate:.0%}" if isfinite(estimate) else "by an unknown amount"


def _outside_validity(design: DesignSpec, sizes: Sizes) -> Iterator[Note]:
    """Yield where the design leaves the range in which its closed forms hold."""
    travel = setting(design, sizes).largest_travel
    for limits, at in design.geometry.outside_validity(sizes, travel):
        of = f" of its {limits.kind}" if limits.kind else ""
        text = f"{limits.quantity} = {show(at, limits.unit)} is outside {limits.spoken}{of}"
        yield Note("outside-validity", f"{text}: {limits.why}")


def _own_shape(design: DesignSpec, sizes: Sizes) -> Iterator[Note]:
    """Yield what is odd about the shape itself: sections, thicknesses, blades that meet."""
    for name, h, b in design.geometry.sections(sizes):
        of = f" of {name}" if name else ""
        if h < MADE:
            text = f"a thickness{of} of {show(h, 'm')} is below what is commonly made"
            yield Note("thin", f"{text} ({show(MADE, 'm')})")
        if b < h:
            text = f"the width{of}, {show(b, 'm')}, is less than the thickness, {show(h, 'm')}"
            yield Note("narrow", f"{text}: it bends across the other side more easily")
    for which, room in design.geometry.clearances(sizes):
        if room < 0.0:
            text = f"{which} overlap by {show(-room, 'm')} where they stand in one plane"
            yield Note("blades-meet", text)
