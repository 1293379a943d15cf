"""What to know of a vibration's response besides its numbers: modes beside the band, travel."""

from collections.abc import Iterator

import numpy as np

from flexcli.engine.response_spectra import structure_of_case
from flexcli.numerics.modes import natural_modes
from flexcli.parts.asd import RandomVibration, Vibration
from flexcli.parts.geometries import NotAvailable
from flexcli.parts.quality import Quality
from flexcli.parts.requirements import Ask, RequirementError
from flexcli.parts.requirements.pushed_by_peaks import axial_share, pushed_share
from flexcli.parts.requirements.response_range import pushed, uncertain_structure
from flexcli.parts.requirements.shaking import at_once
from flexcli.parts.response import mode_qualities, random_outputs
from flexcli.parts.scene import Scene
from flexcli.parts.space_states import KNOWN
from flexcli.parts.structure import MOTIONS, Structure
from flexcli.results import Note
from flexcli.units import show

__all__ = ["vibration_notes"]

NEAR = 0.25
"""Change of a stiffness within which a mode beside the band is told."""
GROWS = 1.1
"""Growth of an output from which such a mode is told."""
SHARE = 0.05
"""Share of the mass that it moves, at least."""
LARGE_ROTATION = np.radians(10.0)
LARGE_FORCE = 0.2
"""Axial force over the critical one from which the same is told: 10 % of a frequency."""
LARGE_STROKE = 0.1
"""Travel over the length of a blade, or rotation, from which the modes' linearity is told."""


def vibration_notes(ask: Ask) -> Iterator[Note]:
    """Yield warnings about the response of a case whose base is shaken."""
    scene, structure = ask.scene, structure_of_case(ask)
    if scene.vibration is not None:
        yield from _missing_modes(scene, structure, scene.vibration)
        for axis in scene.vibration.axes:
            alone = scene.vibration.alone(axis)
            yield from dict.fromkeys(_beside_the_band(scene, structure, alone))
    yield from _large_travel(ask, structure)
    yield from _large_axial_force(ask, structure)
    yield from _bent_by_stroke(ask)


def _missing_modes(scene: Scene, structure: Structure, vibration: Vibration) -> Iterator[Note]:
    """Yield which modes have a Q of their own and are not there."""
    modes = natural_modes(structure.stiffness, structure.mass)
    marked = Quality.model_construct(
        all=1.0, modes=dict.fromkeys(range(1, modes.angular.size + 1), 2.0)
    )
    axes = vibration.axes
    count = int((mode_qualities(structure, marked, axes, modes) == 2.0).sum())
    for number in sorted(vibration.q.modes):
        if number > count:
            text = f"case '{scene.case}': q names mode {number}, and the base moves {count} modes"
            yield Note("no-such-mode", text)


def _beside_the_band(
    scene: Scene, structure: Structure, vibration: RandomVibration
) -> Iterator[Note]:
    """Yield modes just outside the band, and what happens when they are in it."""
    applied = vibration.applied()
    low, high = float(applied.frequency[0]), float(applied.frequency[-1])
    modes = natural_modes(structure.stiffness, structure.mass)
    own = random_outputs(structure, vibration)
    qualities = mode_qualities(structure, vibration.q, vibration.axes, modes)
    for n, (frequency, Q) in enumerate(zip(modes.angular / (2.0 * np.pi), qualities, strict=True)):
        share = max(
            float(modes.shapes[:, n] @ structure.pull[axis]) ** 2 / structure.moved[axis]
            for axis in vibration.axes
        )
        if low <= frequency <= high or share < SHARE:
            continue
        edge, place = (high, "above the end") if frequency > high else (low, "below the start")
        # a bandwidth inside, where the whole resonance is in the band
        inside = edge * (1.0 - 1.0 / Q) if frequency > high else edge * (1.0 + 1.0 / Q)
        change = (inside / frequency) ** 2 - 1.0
        if abs(change) > NEAR:
            continue
        moved = random_outputs(structure.stiffened(1.0 + change), vibration)
        growth = {
            name: moved[name].rms / output.rms for name, output in own.items() if output.rms > 0.0
        }
        forces = [name for name in growth if name.startswith("force")] or list(growth)
        most = max(forces, key=lambda name: growth[name])
        if growth[most] < GROWS:
            continue
        sizes = [vibration.sigma * found[most].rms for found in (own, moved)]
        unit = "N" if most.startswith("force") else "Pa"
        before, after = (show(size, unit) for size in sizes)
        word = "less" if change < 0.0 else "more"
        text = (
            f"case '{scene.case}': a mode at {frequency:.5g} Hz lies "
            f"{abs(frequency / edge - 1.0):.1%} {place} of the band, {edge:g} Hz; with "
            f"{abs(change):.1%} {word} stiffness it is inside, and {vibration.sigma:g}σ of {most} "
            f"goes from {before} to {after}"
        )
        yield Note("mode-beside-band", text)


def _large_travel(ask: Ask, structure: Structure) -> Iterator[Note]:
    """Yield that the own motion is large for linear modes."""
    for shaking in at_once(ask, _by_sigma):
        try:
            peaks = shaking.peaks(structure)
        except ValueError:
            return  # said where the response is judged
        travel = next((peaks[name] for name in MOTIONS if name in peaks), 0.0)
        mechanism = ask.mechanism
        travel *= mechanism.joint_travel_per_motion if mechanism is not None else 1.0
        turns = ask.geometry.motion == "rotation"
        try:
            ratio = travel if turns else travel / ask.geometry.length(ask.sizes)
        except NotAvailable:
            return
        if ratio > (LARGE_ROTATION if turns else LARGE_STROKE):
            part = "" if turns else f", {ratio:.0%} of a blade's length"
            shown = show(travel, ask.geometry.travel_unit)
            text = (
                f"case '{ask.scene.case}': the peak takes the joint {shown} far{part}: "
                f"the modes are those of small motion, and no model here has the change "
                "of stiffness on the way"
            )
            yield Note("large-travel", text)


def _by_sigma(_scene: Scene, vibration: Vibration, _rate: float) -> float:
    return vibration.sigma


def _bent_by_stroke(ask: Ask) -> Iterator[Note]:
    """Yield that no model has the modes of blades that the stroke of the case bends.

    Or that the peaks push them too far where it takes them on its way.
    """
    standing = ask.scene.standing
    if standing is None or not standing.moves:
        return
    try:
        for shaking in at_once(ask, _by_sigma):
            found = uncertain_structure(ask, shaking.changes_at)
            share, on_way = (
                pushed_share(ask, found.structure, shaking.peaks, others)
                for others in ((), found.on_way)
            )
            found = pushed(ask, found, shaking.peaks, shaking.changes_at)
            if found.is_bounded or share is None or share > KNOWN:
                continue
            if on_way is not None and on_way > KNOWN:
                text = (
                    f"case '{ask.scene.case}': on the way to an end of its stroke the peaks push "
                    f"blades by {on_way:.2g} of what buckles the joint: from {KNOWN:g} of it on "
                    "no response passes; give the vibration a case of its own, at the place where "
                    "it acts"
                )
                yield Note("axial-force-in-modes", text)
            else:
                text = (
                    f"case '{ask.scene.case}': its stroke bends blades that shake there, and no "
                    "model here has their modes: no response passes; give the vibration a case of "
                    "its own where it does not act at the stroke"
                )
                yield Note("stroke-in-modes", text)
            return
    except (NotAvailable, RequirementError, ValueError):
        return  # said where the response is judged


def _large_axial_force(ask: Ask, structure: Structure) -> Iterator[Note]:
    """Yield that the axial force of the peak changes the stiffness on the way."""
    try:
        each = [axial_share(ask, structure, shaking.peaks) for shaking in at_once(ask, _by_sigma)]
    except (RequirementError, ValueError):
        return  # said where the response is judged
    share = max((share for share in each if share is not None), default=0.0)
    if share > LARGE_FORCE:
        ask_for = "ask for dynamic-buckling"
        if ask.geometry.in_space:
            ask_for = (
                "that force is of a blade between guided ends, and no buckling under a vibration "
                "is computed in space: give its peak as acceleration: in a case of its own, and "
                "ask for buckling"
            )
        text = (
            f"case '{ask.scene.case}': the peak puts {share:.2g} of the critical force into a "
            "blade: it softens and stiffens on the way, which the modes do not have, and from "
            f"{KNOWN:g} of it on no response passes; {ask_for}"
        )
        yield Note("axial-force-in-modes", text)
