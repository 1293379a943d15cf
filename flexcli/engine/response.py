"""The verb response: what the mechanism's own modes make of a vibration or a shock."""

from collections.abc import Collection, Iterator, Mapping
from time import perf_counter
from typing import Literal, TypeAlias

from flexcli.engine.judge import judge, status_of
from flexcli.engine.models import model_series
from flexcli.engine.response_spectra import UNITS, densities, structure_of_case, transfers
from flexcli.engine.vibration_notes import vibration_notes
from flexcli.errors import SolveError
from flexcli.formulas.peaks import MINIMUM_CYCLES, peak_factor
from flexcli.parts.asd import Vibration
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements import Ask, RequirementError, Requirements
from flexcli.parts.requirements.response_range import pushed, uncertain_structure
from flexcli.parts.requirements.shaking import (
    RANDOM,
    SHAKES,
    at_once,
    random_at_once,
    shakings,
)
from flexcli.parts.response import REACH, Output, random_response
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.structure import Structure
from flexcli.parts.vibration_life import life_curve, life_under
from flexcli.results import Check, Cost, EffectRow, Note, Result, Value, Verdict
from flexcli.results.vibration import CaseResponse, OutputResult, Spectrum

__all__ = ["respond"]

MODEL = "linear modes"

SpectrumKind: TypeAlias = Literal["density", "transfer"]
"""What else may be wanted: densities of the responses, transfer functions to the bodies."""

DYNAMIC = ("dynamic_yield", "dynamic_buckling", "dynamic_life")
"""Requirements that the modes answer."""

TELLING = 1e-3
"""Share of the mass from which a mode that is not excited is told."""


def respond(
    design: DesignSpec, sizes: Sizes, spec: str, kinds: Collection[SpectrumKind] = ()
) -> Result:
    """Return modes and responses of every case in which the base is shaken.

    ``kinds`` are those of the spectra that are wanted besides.
    """
    started = perf_counter()
    spectra: list[Spectrum] = []
    responses: list[CaseResponse] = []
    values: dict[str, Value] = {}
    notes: list[Note] = []
    rows: list[EffectRow] = []
    models, planned = model_series(design), _planned(design, sizes)
    for name in design.cases:
        scene = design.scene(name)
        if not scene.loads & SHAKES:
            continue
        by = next((each for each in models if each.name == planned.get(name)), models[0])
        ask = design.ask(scene, sizes, by.joint_model)
        found = tuple(_responses(ask))
        for response in found:
            values |= _mode_values(response)
            if response.modes:
                notes += _against_miles(scene, response)
                notes += _without_life(ask, response)
                rows.append(_higher_modes(scene, response))
        responses += found
        notes += vibration_notes(ask)
        spectra += densities(ask) if "density" in kinds else ()
        spectra += transfers(ask) if "transfer" in kinds else ()
        values |= _worst_values(ask)
    if not responses:
        raise SolveError("no-vibration", "no case has a vibration or a shock", "add asd: to a case")
    judged = judge(_dynamic_only(design), sizes, models, formulas=False)
    checks = tuple(check for check in judged.checks if _is_of_response(check, design))
    return Result(
        command="asd response",
        spec=spec,
        status=status_of(checks),
        title=design.title,
        values=values,
        checks=checks,
        effects=tuple(rows),
        warnings=tuple(notes),
        cost=Cost(
            perf_counter() - started,
            MODEL,
            max((v.estimated_error for v in values.values() if v.estimated_error), default=None),
            by_model=judged.by_model,
        ),
        responses=tuple(responses),
        spectra=tuple(spectra),
    )


def _planned(design: DesignSpec, sizes: Sizes) -> dict[str, str]:
    """Return by case the joint's model that the accuracy of the spec calls for, if it asks any.

    Where Miles' formula will do, the cheapest has the modes.
    """
    if design.accuracy is None:
        return {}
    from flexcli.engine.planning.scene_models import MODES, scene_plans

    plans = scene_plans(design, sizes, design.accuracy)
    return {p.case: p.model.removeprefix(MODES) for p in plans if p.model.startswith(MODES)}


def _dynamic_only(design: DesignSpec) -> DesignSpec:
    """Return the design with those of its requirements that the modes answer."""
    asked = design.requirements
    kept = {name: getattr(asked, name) for name in DYNAMIC if getattr(asked, name) is not None}
    return design.model_copy(update={"requirements": Requirements.model_construct(**kept)})


def _is_of_response(check: Check, design: DesignSpec) -> bool:
    """Return whether a check is of the modes, or of what shakes them and nothing looks at."""
    if check.verdict is not Verdict.NOT_JUDGED:
        return check.name.startswith("dynamic")
    kind, scene = LoadKind(check.name), design.scene(check.case)
    looked_at = {
        load
        for _, requirement in design.requirements.each()
        if requirement.applies(scene)
        for load in requirement.looks_at(scene)
    }
    return kind in SHAKES and kind not in looked_at


def _responses(ask: Ask) -> Iterator[CaseResponse]:
    """Yield what the modes make of each excitation of a case."""
    structure, scene = structure_of_case(ask), ask.scene
    try:
        for vibration in random_at_once(scene):
            yield _random(ask, structure, vibration)
        for shaking in shakings(ask, _by_sigma):
            if shaking.kind not in RANDOM:
                peaks = shaking.peaks(structure)
                yield CaseResponse(scene.case, shaking.source, (), _peaks(peaks), {}, None)
    except (ValueError, RequirementError) as error:
        hint = getattr(error, "hint", "") or "extend the spectrum to the modes' frequencies"
        raise SolveError("no-response", f"case '{scene.case}': {error}", hint) from error


def _by_sigma(_scene: Scene, vibration: Vibration, _rate: float) -> float:
    return vibration.sigma


def _peaks(peaks: Mapping[str, float]) -> tuple[OutputResult, ...]:
    return tuple(
        OutputResult(name, UNITS[name.split()[0]], None, peak, None, None)
        for name, peak in peaks.items()
    )


def _random(ask: Ask, structure: Structure, vibration: Vibration) -> CaseResponse:
    response = random_response(structure, vibration)
    duration = vibration.lasts
    outputs = tuple(
        _output(name, output, vibration.sigma, duration)
        for name, output in response.outputs.items()
    )
    lives = {}
    if _lacks_for_life(ask) is None and not ask.scene.loads & SHAKES - RANDOM:
        lives = {
            name: life_under(ask.material, output.moments)
            for name, output in response.outputs.items()
            if name.startswith("stress")
        }
    kind = f"random, {vibration.q.told}, along {', '.join(vibration.axes)}"
    if len(vibration.axes) > 1:
        kind += " at once, added as squares"
    told = tuple(m for m in response.modes if m.dynamic or m.mass_share > TELLING)
    return CaseResponse(ask.scene.case, kind, told, outputs, lives, duration)


def _lacks_for_life(ask: Ask) -> MissingProperty | None:
    """Return what the material lacks for a life, or nothing."""
    try:
        life_curve(ask.material)
    except MissingProperty as missing:
        return missing
    return None


def _without_life(ask: Ask, response: CaseResponse) -> Iterator[Note]:
    """Yield why no life is given, where the material's curve is missing."""
    if beside := sorted(ask.scene.loads & SHAKES - RANDOM):
        text = f"case '{response.case}': no life under the random part alone is given: a"
        yield Note("no-life", f"{text} {' and a '.join(beside)} acts with it; ask for dynamic-life")
    missing = _lacks_for_life(ask)
    if missing is not None:
        text = f"case '{response.case}': no life is given: {missing}; give material.{missing.field}"
        yield Note("no-life", text)


def _output(name: str, output: Output, sigma: float, duration: float | None) -> OutputResult:
    expected = None
    if duration is not None and output.crossing_rate * duration > MINIMUM_CYCLES:
        expected = output.rms * float(peak_factor(output.crossing_rate, duration))
    return OutputResult(
        name=name,
        unit=UNITS[name.split()[0]],
        rms=output.rms,
        peak=sigma * output.rms,
        expected_peak=expected,
        crossing_rate=output.crossing_rate,
    )


def _mode_values(response: CaseResponse) -> dict[str, Value]:
    """Return the natural frequencies that a case excites."""
    label = f"natural frequency, {response.case}"
    excited = [mode for mode in response.modes if mode.dynamic]
    return {
        f"f_{index}_{response.case}": Value(mode.frequency, "Hz", label, MODEL)
        for index, mode in enumerate(excited, 1)
    }


def _worst_values(ask: Ask) -> dict[str, Value]:
    """Return the largest stress and force of a case, each with what its peak may be off by."""
    found: dict[str, Value] = {}
    case, each = ask.scene.case, list(shakings(ask, _by_sigma))
    for shaking in (*each, *(at_once(ask, _by_sigma) if len(each) > 1 else ())):
        own = uncertain_structure(ask, shaking.changes_at)
        beside = pushed(ask, own, shaking.peaks, shaking.changes_at)
        over = beside.of(shaking.peaks)
        for word, label in (("stress", "stress at a blade's end"), ("force", "force on a joint")):
            at = max((n for n in over if n.startswith(word)), key=lambda name: over[name][0])
            peak, error = over[at]
            where, unit = f"{label}, {at.split()[-1]}, {case}", UNITS[word]
            known = error.largest if error is not None and beside.is_bounded else None
            one = {f"{word}_peak_{case}": Value(peak, unit, f"peak {where}", MODEL, "", known)}
            if shaking.kind in RANDOM:
                assert ask.scene.vibration is not None  # it is random
                rms = peak / ask.scene.vibration.sigma
                name = f"{word}_rms_{case}"
                one = {name: Value(rms, unit, f"rms {where}", MODEL, "", known), **one}
            found |= {name: value for name, value in one.items() if _is_larger(found, name, value)}
    return found


def _is_larger(found: Mapping[str, Value], name: str, value: Value) -> bool:
    return name not in found or value.value > found[name].value


def _higher_modes(scene: Scene, response: CaseResponse) -> EffectRow:
    """Return the effect of the modes' resonance that was left out as the band can't excite it."""
    assert scene.vibration is not None  # a random response
    band_end = scene.vibration.band[1]
    lowest = min((m.frequency for m in response.modes if not m.dynamic), default=None)
    excited = sum(mode.dynamic for mode in response.modes)
    if lowest is None:
        return EffectRow("higher modes", True, 0.0, 0.0, f"all {excited} modes are excited")
    ratio = band_end / lowest
    moved = lowest > REACH * band_end
    estimate = ratio**2 if moved else 0.0
    why = f"lowest at {ratio:.2g} of it" if moved else "the base does not move them"
    text = f"{excited} of {len(response.modes)} modes are excited by the band; the others: {why}"
    return EffectRow("higher modes", False, ratio, estimate, text)


def _against_miles(scene: Scene, response: CaseResponse) -> Iterator[Note]:
    """Compare the worst case over all frequencies with the real modes' force."""
    peaks = [row.peak for row in response.outputs if row.name.startswith("force")]
    if not scene.force or not peaks:
        return
    ratio = max(peaks) / scene.force
    if ratio > 1.0:
        text = (
            f"case '{scene.case}': the modes load a joint {ratio - 1.0:.0%} more than Miles' worst "
            f"case {scene.force_name}; size for the larger"
        )
        yield Note("miles-unsafe", text)
    else:
        text = (
            f"case '{scene.case}': Miles' worst case {scene.force_name} is "
            f"{1.0 / ratio:.2g} times the force of the modes"
        )
        yield Note("miles-conservative", text)
