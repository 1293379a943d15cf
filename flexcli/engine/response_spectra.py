"""Spectra of a design's response: densities of what a vibration does, transfer functions."""

from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.asd import column
from flexcli.errors import SolveError
from flexcli.numerics.modes import natural_modes
from flexcli.parts.requirements import Ask, RequirementError
from flexcli.parts.requirements.response_range import uncertain_structure
from flexcli.parts.requirements.shaking import quality_of
from flexcli.parts.response import (
    mode_qualities,
    response_density,
    sweep_points,
    transfer_functions,
)
from flexcli.parts.structure import Structure
from flexcli.results.vibration import Spectrum

__all__ = ["UNITS", "densities", "structure_of_case", "transfers"]

Floats = NDArray[np.float64]

UNITS = {
    "force": "N",
    "axial": "Pa",
    "stress": "Pa",
    "travel": "m",
    "rotation": "rad",
    "acceleration": "(m/s^2)",
}
"""SI units of a structure's outputs, by the first word of their names."""


def structure_of_case(ask: Ask) -> Structure:
    """Return the mechanism of a case by the model that is asked, or raise SolveError."""
    try:
        return uncertain_structure(ask, ()).structure
    except RequirementError as error:
        hint = error.hint or "take another geometry or mechanism"
        raise SolveError("no-structure", f"case '{ask.scene.case}': {error}", hint) from error


def densities(ask: Ask) -> Iterator[Spectrum]:
    """Yield the spectral densities of the outputs under the random vibration of a case."""
    vibration = ask.scene.vibration
    if vibration is None:
        return
    f, levels, found = response_density(structure_of_case(ask), vibration)
    columns = [column("frequency", "Hz", "", f)]
    for name, density in found.items():
        unit = f"{UNITS[name.split()[0]]}^2/Hz"
        columns.append(column(name, unit, "", density))
    distinct = len({id(each) for each in vibration.by_axis().values()}) > 1
    for axis, level in levels.items() if distinct else [("", next(iter(levels.values())))]:
        label = f"acceleration of the base, along {axis or 'each axis'}"
        columns.append(column(f"base {axis}".strip(), "(m/s^2)^2/Hz", label, level))
    name = f"response densities, along {', '.join(vibration.axes)}"
    yield Spectrum("density", name, ask.scene.case, tuple(columns))


def transfers(ask: Ask) -> Iterator[Spectrum]:
    """Yield the transfer functions from the base to every body, along each axis that is shaken."""
    scene, structure = ask.scene, structure_of_case(ask)
    axes: dict[str, tuple[str, float | Floats, tuple[float, float]]] = {}
    modes = natural_modes(structure.stiffness, structure.mass)
    resonances = modes.angular / (2.0 * np.pi)
    vibration = scene.vibration
    if vibration is not None:
        Q = mode_qualities(structure, vibration.q, vibration.axes, modes)
        axes |= dict.fromkeys(vibration.axes, (vibration.q.told, Q, vibration.band))
    around = float(resonances[0]) / 10.0, 10.0 * float(resonances[0])
    if scene.shock is not None:
        axes.setdefault(scene.shock.axis, (f"Q = {scene.shock.q:g}", scene.shock.q, around))
    for sine in (scene.sine, scene.sweep, *scene.sines):
        if sine is not None and sine.axis not in axes:
            quality = quality_of(ask.mechanism, scene)
            Q = mode_qualities(structure, quality, (sine.axis,), modes)
            axes[sine.axis] = quality.told, Q, around
    for axis, (told, each, band) in axes.items():
        f = sweep_points(band, resonances, each)
        columns = [column("frequency", "Hz", "", f)]
        for body, gains in transfer_functions(structure, each, axis, f).items():
            for direction, gain in zip(structure.directions, gains.T, strict=True):
                unit = "rad/m" if direction.startswith("theta") else ""
                name = f"{body} {direction}"
                label = "over the base's"
                columns.append(column(name, unit, label, np.abs(gain)))
                columns.append(column(f"{name} phase", "rad", "", np.angle(gain)))
        name = f"transfer functions, base along {axis}, {told}"
        yield Spectrum("transfer", name, f"{scene.case}, along {axis}", tuple(columns))
