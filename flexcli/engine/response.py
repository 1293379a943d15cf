"""The verb response: what the mechanism's own modes make of a vibration or a shock."""

from collections.abc import Iterator
from time import perf_counter

from flexcli.engine import assess
from flexcli.errors import SolveError
from flexcli.formulas.peaks import MINIMUM_CYCLES, peak_factor
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import NotAvailable, Sizes
from flexcli.parts.material import MissingProperty
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.response import REACH, Output, random_response, shock_peaks
from flexcli.parts.scene import Scene
from flexcli.parts.structure import Structure
from flexcli.parts.vibration_life import life_under
from flexcli.results import (
    CaseResponse,
    Cost,
    EffectRow,
    Note,
    OutputResult,
    Result,
    Status,
    Value,
)

__all__ = ["respond"]

MODEL = "linear modes"

UNITS = {"force": "N", "axial": "Pa", "stress": "Pa", "travel": "m"}
"""SI units of a structure's outputs, by the first word of their names."""


def respond(design: DesignSpec, sizes: Sizes, spec: str) -> Result:
    """Return modes and responses of every case with a vibration or a shock."""
    started = perf_counter()
    responses: list[CaseResponse] = []
    values: dict[str, Value] = {}
    notes: list[Note] = []
    rows: list[EffectRow] = []
    for name in design.cases:
        scene = design.scene(name)
        if scene.vibration is None and scene.shock is None:
            continue
        structure = _structure(design, sizes, scene)
        if scene.vibration is not None:
            response = _random(design, scene, structure)
            responses.append(response)
            values |= _worst_values(response)
            notes += _against_miles(scene, response)
            rows.append(_higher_modes(scene, response))
        if scene.shock is not None:
            responses.append(_shock(scene, structure))
    if not responses:
        raise SolveError("no-vibration", "no case has a vibration or a shock", "add asd: to a case")
    found = assess.checks(
        limit for limit in design.limits(sizes) if limit.requirement.startswith("dynamic")
    )
    passed = all(check.passed for check in found)
    return Result(
        command="asd response",
        spec=spec,
        status=Status.PASS if passed else Status.FAIL,
        title=design.title,
        values=values,
        checks=found,
        effects=tuple(rows),
        warnings=tuple(notes),
        cost=Cost(
            perf_counter() - started, MODEL, max((row.estimate for row in rows), default=None)
        ),
        responses=tuple(responses),
    )


def _structure(design: DesignSpec, sizes: Sizes, scene: Scene) -> Structure:
    where = f"case '{scene.case}'"
    if design.mechanism is None:
        raise SolveError("no-mass", f"{where}: nothing that vibrates has a mass", "add a mechanism")
    try:
        return design.mechanism.structure(
            design.geometry, design.material.elastic, sizes, scene.lock
        )
    except (MechanismError, NotAvailable) as error:
        hint = getattr(error, "hint", "") or "take another geometry or mechanism"
        raise SolveError("no-structure", f"{where}: {error}", hint) from error


def _random(design: DesignSpec, scene: Scene, structure: Structure) -> CaseResponse:
    vibration = scene.vibration
    assert vibration is not None  # the caller's case
    try:
        response = random_response(structure, vibration)
    except ValueError as error:
        raise SolveError("no-response", f"case '{scene.case}': {error}", "") from error
    duration = vibration.applied().duration
    outputs = tuple(
        _output(name, output, vibration.sigma, duration)
        for name, output in response.outputs.items()
    )
    lives = {}
    for name, output in response.outputs.items():
        if name.startswith("stress"):
            try:
                lives[name] = life_under(design.material, output.moments)
            except MissingProperty:
                break
    kind = f"random, Q = {vibration.q:g}, along {', '.join(vibration.axes)}"
    return CaseResponse(scene.case, kind, response.modes, outputs, lives, duration)


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


def _shock(scene: Scene, structure: Structure) -> CaseResponse:
    assert scene.shock is not None  # the caller's case
    try:
        peaks = shock_peaks(structure, scene.shock)
    except ValueError as error:
        hint = "extend the spectrum to the modes' frequencies"
        raise SolveError("no-response", f"case '{scene.case}': {error}", hint) from error
    outputs = tuple(
        OutputResult(name, UNITS[name.split()[0]], None, peak, None, None)
        for name, peak in peaks.items()
    )
    return CaseResponse(scene.case, f"shock, Q = {scene.shock.q:g}", (), outputs, {}, None)


def _worst_values(response: CaseResponse) -> dict[str, Value]:
    """Return the largest stress and force of a case, and its lowest excited frequency."""
    found = {}
    for word, label in (("stress", "stress at a blade's end"), ("force", "force on a joint")):
        rows = [row for row in response.outputs if row.name.startswith(word)]
        worst = max(rows, key=lambda row: row.peak)
        assert worst.rms is not None  # random
        where = f"{label}, {worst.name.split()[-1]}, {response.case}"
        found[f"{word}_rms_{response.case}"] = Value(worst.rms, worst.unit, f"rms {where}", MODEL)
        found[f"{word}_peak_{response.case}"] = Value(
            worst.peak, worst.unit, f"peak {where}", MODEL
        )
    for index, mode in enumerate(m for m in response.modes if m.dynamic):
        label = f"natural frequency, {response.case}"
        found[f"f_{index + 1}_{response.case}"] = Value(mode.frequency, "Hz", label, MODEL)
    return found


def _higher_modes(scene: Scene, response: CaseResponse) -> EffectRow:
    """Return the effect of the modes' resonance that was left out as the band can't excite it."""
    assert scene.vibration is not None  # a random response
    band_end = float(scene.vibration.applied().frequency[-1])
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
