"""What a vibration or a shock calls for besides its modes, estimated by case."""

from collections.abc import Iterator, Mapping
from contextlib import suppress
from math import hypot, inf, isfinite, log, pi

import numpy as np
from numpy.typing import NDArray

from flexcli.engine import omitted_effects
from flexcli.engine.models import model_series
from flexcli.engine.response_spectra import structure_of_case
from flexcli.errors import SolveError
from flexcli.formulas.peaks import MINIMUM_CYCLES, peak_factor
from flexcli.formulas.sweep_build_up import sweep_build_up
from flexcli.numerics.modes import natural_modes
from flexcli.parts.design import DesignSpec
from flexcli.parts.effects.large_rotation import LargeRotation
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, RequirementError
from flexcli.parts.requirements.pushed_by_peaks import axial_share
from flexcli.parts.requirements.response_range import uncertain_structure
from flexcli.parts.requirements.shaking import SHAKES, at_once, quality_of
from flexcli.parts.response import random_outputs
from flexcli.parts.space_vibration import likely_structures
from flexcli.parts.structure import MOTIONS, Structure, largest_of
from flexcli.results import EffectRow

__all__ = ["against_miles", "largest_peaks", "vibration_effects"]

Floats = NDArray[np.float64]

Peaks = Mapping[str, float]

NOTHING = 1e-8
"""Share of a number from which on an effect is told to change it."""

MOST_MODES = 12
"""Lowest modes that are looked at by themselves."""

HALF = 0.5
"""Share of its energy from which a mode is one of the inside of blades."""

TELLING = 0.01
"""Share of the stress from which a mode is counted."""


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
            peaks = largest_peaks(ask, structure)
            yield from against_miles(ask, peaks)
            yield from _peak_factor(ask, structure)
            yield from _large_motion(design, sizes, ask, peaks)
            yield from _stiffened(ask, structure)
            yield from _higher_modes(ask, structure, peaks)
            yield from _blade_mass(ask, peaks)
            yield from _sweeping(ask, structure)
            yield from _out_of_plane(ask, peaks)


def largest_peaks(ask: Ask, structure: Structure) -> Peaks:
    """Return the largest peaks of what shakes the base at once."""
    found = at_once(ask, lambda _scene, vibration, _rate: vibration.sigma)
    each = [shaking.peaks(structure) for shaking in found]
    return {name: max(peaks[name] for peaks in each) for name in each[0]}


def _row(
    ask: Ask, effect: str, indicator: float, estimates: Peaks, reason: str, *, on: bool = False
) -> EffectRow:
    (name, most), *_ = estimates.items()
    told = "by an unknown amount"
    if isfinite(most):
        told = f"by up to {most:.2g} of it" if most > NOTHING else "not at all"
    text = f"{reason}; {name} {told}"
    return EffectRow(f"{effect}, {ask.scene.case}", on, indicator, most, text, estimates)


def against_miles(ask: Ask, peaks: Peaks) -> Iterator[EffectRow]:
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
    if ask.scene.vibrates_in_space:
        yield from _second_order(ask)
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


def _second_order(ask: Ask) -> Iterator[EffectRow]:
    """Yield what the motion of the peak changes in the stress of a mechanism in space."""
    error = uncertain_structure(ask, ()).shape_error(lambda s: largest_peaks(ask, s), 1.0)
    estimate = inf if error is None else error.largest
    text = "second order of the modes at their peaks, and what their springs may be off by"
    yield _row(ask, "large rotation", estimate, {"stress": estimate}, text)


def _stiffened(ask: Ask, structure: Structure) -> Iterator[EffectRow]:
    """Yield what the axial force of the peak changes in the frequency: to first order ½ P/P_cr."""
    share = axial_share(ask, structure, lambda each: largest_peaks(ask, each))
    if share is not None:
        text = f"axial force in a blade at {share:.2g} of the critical one, either way"
        yield _row(ask, "stress stiffening", share, {"frequency": 0.5 * share}, text)


def _higher_modes(ask: Ask, structure: Structure, peaks: Peaks) -> Iterator[EffectRow]:
    """Yield what all modes but the strongest are of the stress; the response has them all."""
    modes, whole = natural_modes(structure.stiffness, structure.mass), largest_of(peaks, "stress")
    alone = [
        largest_of(largest_peaks(ask, structure.in_mode(float(omega), shape)), "stress")
        for omega, shape in zip(modes.angular[:MOST_MODES], modes.shapes.T, strict=False)
    ]
    if not whole or not alone:
        return
    strongest = max(range(len(alone)), key=lambda n: alone[n])
    telling = sum(size > TELLING * whole for size in alone)
    text = f"{telling} modes make more than {TELLING:.0%} of the stress, most that at "
    text += f"{modes.angular[strongest] / (2.0 * pi):.4g} Hz: without the others"
    estimate = abs(1.0 - alone[strongest] / whole)
    yield _row(ask, "higher modes", telling, {"stress": estimate}, text, on=True)
    if ask.material.density is None:
        return
    own = structure_of_case(_light(ask)).mass.shape[0]
    inner = [n for n in range(len(alone)) if _inside(structure, modes.shapes[:, n], own) > HALF]
    if inner:
        size = hypot(*(alone[n] for n in inner)) / whole
        first = float(modes.angular[inner[0]]) / (2.0 * pi)
        text = f"{len(inner)} of the {len(alone)} lowest modes move a blade inside more than its "
        text += f"ends, from {first:.4g} Hz on"
        yield _row(ask, "blade modes", first, {"stress": size}, text, on=True)


def _inside(structure: Structure, shape: Floats, bodies: int) -> float:
    """Return the share of a mode's kinetic energy inside blades, beyond that of their ends [-].

    ``shape`` is of unit modal mass; the coordinates of the ``bodies`` come first.
    """
    inner = shape[bodies:]
    return float(inner @ structure.mass[bodies:, bodies:] @ inner)


def _light(ask: Ask) -> Ask:
    """Return the same with blades of no mass."""
    return ask._replace(material=ask.material.model_copy(update={"density": None}))


def _blade_mass(ask: Ask, peaks: Peaks) -> Iterator[EffectRow]:
    """Yield what the blades' mass, and what they do inside, changes in the stress."""
    if ask.material.density is None or not (whole := largest_of(peaks, "stress")):
        return
    light = _light(ask)
    without = largest_of(largest_peaks(light, structure_of_case(light)), "stress")
    text = f"massless blades have {without / whole:.4g} times the stress"
    yield _row(
        ask, "blade mass", without / whole, {"stress": abs(without / whole - 1.0)}, text, on=True
    )


def _sweeping(ask: Ask, structure: Structure) -> Iterator[EffectRow]:
    """Yield how far the strongest resonance builds up in the time that a sweep takes through it."""
    sweep = ask.scene.sweep
    if sweep is None:
        return
    modes = natural_modes(structure.stiffness, structure.mass)
    share = (modes.shapes.T @ structure.pull[sweep.axis]) ** 2
    low, high = sweep.band
    f = modes.angular / (2.0 * pi)
    inside = (f > low) & (f < high)
    if not inside.any():
        return
    own = float(f[inside][int(np.argmax(share[inside]))])
    Q = quality_of(ask.mechanism, ask.scene).largest
    speed = sweep.rate.speed if sweep.rate.is_linear else sweep.rate.speed * own * log(2.0)
    reached = sweep_build_up(Q, own, speed)
    text = f"the mode at {own:.4g} Hz builds up to {reached:.4g} of its steady motion"
    yield _row(ask, "steady for transient", reached, {"response": 1.0 / reached - 1.0}, text)


def _out_of_plane(ask: Ask, peaks: Peaks) -> Iterator[EffectRow]:
    """Yield what the first axis' random vibration would do along z, where no case has it there."""
    vibration, whole = ask.scene.vibration, largest_of(peaks, "stress")
    if vibration is None or ask.scene.vibrates_in_space or not whole:
        return
    first = vibration.alone(vibration.axes[0])
    try:
        lock = ask.scene.lock
        found = likely_structures(ask.mechanism, ask.geometry, ask.material, ask.sizes, 0, lock).own
    except NotAvailable:
        return
    along_z = first.model_copy(update={"axis": "z"})
    sizes = {name: out.rms for name, out in random_outputs(found, along_z).items()}
    ratio = vibration.sigma * largest_of(sizes, "stress") / whole
    text = f"the base does not move along z; shaken so, {ratio:.3g} times the stress"
    yield _row(ask, "out-of-plane motion", ratio, {"stress": ratio}, text)
