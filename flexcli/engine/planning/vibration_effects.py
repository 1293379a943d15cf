"""What a vibration or a shock calls for besides its modes, estimated by case."""

from collections.abc import Iterator, Mapping
from contextlib import suppress

from flexcli.engine import omitted_effects
from flexcli.engine.models import model_series
from flexcli.engine.response_spectra import structure_of_case
from flexcli.engine.vibration_notes import axial_share
from flexcli.errors import SolveError
from flexcli.formulas.peaks import MINIMUM_CYCLES, peak_factor
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects.large_rotation import LargeRotation
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, RequirementError
from flexcli.parts.requirements.shaking import SHAKES, at_once
from flexcli.parts.response import random_outputs
from flexcli.parts.structure import MOTIONS, Structure
from flexcli.results import EffectRow

__all__ = ["vibration_effects"]

Peaks = Mapping[str, float]


def vibration_effects(design: DesignSpec, sizes: Sizes) -> Iterator[EffectRow]:
    """Yield what the response of each case that shakes the base leaves out, with its estimate.

    The response is that of small motion of the blades at rest, its peak sigma times the rms.
    """
    joint_model = model_series(design)[0].joint_model
    for name in design.cases:
        scene = design.scene(name)
        if not scene.loads & SHAKES:
            continue
        ask = design.ask(scene, sizes, joint_model)
        with suppress(SolveError, ValueError, RequirementError):  # said where it is judged
            structure = structure_of_case(ask)
            peaks = _largest_peaks(ask, structure)
            yield from _against_miles(ask, peaks)
            yield from _peak_factor(ask, structure)
            yield from _large_motion(design, sizes, ask, peaks)
            yield from _stiffened(ask, structure)


def _largest_peaks(ask: Ask, structure: Structure) -> Peaks:
    """Return the largest peaks of what shakes the base at once."""
    found = at_once(ask, lambda _scene, vibration, _rate: vibration.sigma)
    each = [shaking.peaks(structure) for shaking in found]
    return {name: max(peaks[name] for peaks in each) for name in each[0]}


def _row(ask: Ask, effect: str, indicator: float, estimates: Peaks, reason: str) -> EffectRow:
    (name, most), *_ = estimates.items()
    text = f"{reason}; {name} by up to {most:.2g} of it"
    return EffectRow(f"{effect}, {ask.scene.case}", False, indicator, most, text, estimates)


def _against_miles(ask: Ask, peaks: Peaks) -> Iterator[EffectRow]:
    """Yield how far Miles' worst case, by which blades are sized, is off the modes' force."""
    forces = [peak for name, peak in peaks.items() if name.startswith("force")]
    if ask.scene.vibration is None or not ask.scene.force or not forces or not max(forces):
        return
    ratio = ask.scene.force / max(forces)
    text = f"{ask.scene.force_name} by Miles is {ratio:.3g} times the force of the modes"
    yield _row(ask, "Miles for modes", ratio, {"response": abs(ratio - 1.0)}, text)


def _peak_factor(ask: Ask, structure: Structure) -> Iterator[EffectRow]:
    """Yield how far the peak to expect in the duration is beyond sigma times the rms."""
    vibration = ask.scene.vibration
    duration = vibration.lasts if vibration is not None else None
    if vibration is None or duration is None:
        return
    rates = [
        output.crossing_rate
        for name, output in random_outputs(structure, vibration).items()
        if name.startswith("stress")
    ]
    cycles = max(rates, default=0.0) * duration
    if cycles > MINIMUM_CYCLES:
        factor = float(peak_factor(cycles, 1.0))
        text = f"{factor:.3g} rms to expect in {cycles:.3g} cycles, {vibration.sigma:g} in the peak"
        estimate = max(factor / vibration.sigma - 1.0, 0.0)
        yield _row(ask, "duration in the peak", factor, {"response": estimate}, text)


def _large_motion(design: DesignSpec, sizes: Sizes, ask: Ask, peaks: Peaks) -> Iterator[EffectRow]:
    """Yield what the travel of the peak changes in the stress, as that of a stroke does."""
    mechanism = ask.mechanism
    ratio = mechanism.joint_travel_per_motion if mechanism is not None else 1.0
    travel = next((peaks[name] for name in MOTIONS if name in peaks), 0.0) * ratio
    if travel == 0.0:
        return
    scene = ask.scene.without_loads()._replace(travel=travel, mean_travel=0.0, middle=0.0)
    setting = omitted_effects.setting(design, sizes)._replace(scenes=(scene,))
    effect = LargeRotation()
    with suppress(NotAvailable):
        found = effect.indicator(setting)
        stress = effect.estimates(setting).get("stress")
        if found is not None and stress is not None:
            text = f"{found.text} at the peak, as a stroke of that size would"
            yield _row(ask, "large rotation", found.value, {"stress": stress}, text)


def _stiffened(ask: Ask, structure: Structure) -> Iterator[EffectRow]:
    """Yield what the axial force of the peak changes in the frequency: to first order ½ P/P_cr."""
    share = axial_share(ask, structure)
    if share is not None:
        text = f"axial force in a blade at {share:.2g} of the critical one, either way"
        yield _row(ask, "stress stiffening", share, {"frequency": 0.5 * share}, text)
