"""The verb notch: a test's profile lowered where a force limit asks for it."""

from collections.abc import Iterator
from dataclasses import replace
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.asd import column, describe, made
from flexcli.engine.models import model_series
from flexcli.engine.response_spectra import structure_of_case
from flexcli.errors import SolveError
from flexcli.formulas.force_limit import force_limit, notch_factor
from flexcli.formulas.spectrum import Side, spectral_level
from flexcli.formulas.straight_spectrum import straight_lines
from flexcli.numerics.modes import natural_modes
from flexcli.parts.asd import AppliedASD, Axis, Vibration
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.response import apparent_mass, mode_qualities, sweep_points
from flexcli.parts.structure import Structure
from flexcli.results import Cost, Note, Result, Value
from flexcli.results.vibration import Spectrum

__all__ = ["ForceLimit", "notch"]

MODEL = "linear modes"
Floats = NDArray[np.float64]

DEEP_DB = 14.0
"""A notch from which a standard or a reviewer will ask why."""


class ForceLimit(NamedTuple):
    """A semi-empirical force limit: C, knee [Hz] and exponent of the roll-off, fixed mass [kg].

    The knee is the mode that moves most mass, where left out; the fixed mass is what stands on
    the shaker beside what the design moves.
    """

    C: float
    knee: float | None = None
    exponent: float = 2.0
    fixed_mass: float = 0.0


def notch(
    design: DesignSpec,
    sizes: Sizes,
    spec: str,
    limit: ForceLimit,
    case: str | None = None,
    axis: str | None = None,
) -> Result:
    """Return the profile of a case's vibration, lowered to a limit on the force at the base.

    Raises
    ------
    SolveError
        When the case, its vibration or its axis is not one alone.

    """
    started = perf_counter()
    name, vibration = _vibration(design, case)
    along = _axis(vibration, axis)
    ask = design.ask(design.scene(name), sizes, model_series(design)[0].joint_model)
    structure = structure_of_case(ask)
    applied = vibration.by_axis()[along]
    total = structure.moved[along] + limit.fixed_mass
    knee = _primary_frequency(structure, along) if limit.knee is None else limit.knee
    modes = natural_modes(structure.stiffness, structure.mass)
    resonances = modes.angular / (2.0 * np.pi)
    Q = mode_qualities(structure, vibration.q, vibration.axes, modes)

    def factor(f: Floats) -> Floats:
        mass = apparent_mass(structure, Q, along, f) + limit.fixed_mass
        return notch_factor(f, mass, limit.C, total, knee, limit.exponent)

    def level(f: Floats, side: Side) -> Floats:
        return _level(applied, f, side) * factor(f)

    corners = applied.frequency
    cuts = np.union1d(corners, _inside([knee], corners))
    dense = sweep_points((float(corners[0]), float(corners[-1])), resonances, Q)
    lowered = factor(dense) < 1.0
    edges = dense[np.flatnonzero(np.diff(lowered))] if lowered.any() else np.zeros(0)
    cuts = np.union1d(cuts, edges)
    f, g = straight_lines(level, np.union1d(cuts, _inside(resonances, corners)), tolerance=1e-2)
    profile = vibration.alone(along).profile
    title = f"{profile.name or name}, force limited, C = {limit.C:g}"
    note = (
        f"Notched for case {name} along {along}: C = {limit.C:g}, M0 = {total:.4g} kg, "
        f"f0 = {knee:.4g} Hz, n = {limit.exponent:g}, {vibration.q.told}."
    )
    new = made(title, note, f, g, [profile], "log-log")
    new = new.model_copy(update={"duration": applied.duration})
    found = describe("asd notch", spec, new)
    depth = 10.0 * np.log10(factor(dense))
    deepest = int(np.argmin(depth))
    force, held = (
        (np.abs(apparent_mass(structure, Q, along, dense) + limit.fixed_mass) ** 2) * spectrum
        for spectrum in (_level(applied, dense, "right"), level(dense, "right"))
    )
    values = {
        "mass": Value(total, "kg", "mass on the shaker"),
        "f_primary": Value(knee, "Hz", "frequency of the primary mode"),
        "db_deepest": Value(float(depth[deepest]), "dB", "deepest notch"),
        "f_deepest": Value(float(dense[deepest]), "Hz", "frequency of that"),
        "F_rms": Value(_rms(force, dense), "N", "rms force at the base without the notch", MODEL),
        "F_rms_notched": Value(_rms(held, dense), "N", "rms force at the base with it", MODEL),
    }
    bound = force_limit(dense, _level(applied, dense, "right"), limit.C, total, knee,
                        limit.exponent)  # fmt: skip
    columns = (
        ("frequency", "Hz", "", dense),
        ("force", "N^2/Hz", "density of the force at the base with the notch", held),
        ("limit", "N^2/Hz", "semi-empirical force limit", bound),
        ("without", "N^2/Hz", "density of the force without the notch", force),
    )
    of_force = tuple(column(*each) for each in columns)
    spectrum = Spectrum("force", f"force at the base along {along}", name, of_force)
    return replace(
        found,
        values={**values, **found.values},
        warnings=tuple(_notes(float(depth[deepest]))),
        spectra=(spectrum,),
        cost=Cost(perf_counter() - started, MODEL, None),
    )


def _vibration(design: DesignSpec, case: str | None) -> tuple[str, Vibration]:
    """Return the case that is named, or the only one with a random vibration, and its vibration."""
    vibrations = {name: loads.vibration for name, loads in design.cases.items()}
    found = {name: each for name, each in vibrations.items() if each is not None}
    if case is not None and case not in found:
        known = ", ".join(found) or "none has"
        text = f"case '{case}' has no random vibration"
        raise SolveError("no-vibration", text, f"cases that have: {known}")
    names = list(found) if case is None else [case]
    if len(names) != 1:
        text = "no case has a random vibration" if not names else "several cases vibrate"
        hint = f"name one by --case: {', '.join(names)}" if names else "add asd: to a case"
        raise SolveError("which-case", text, hint)
    return names[0], found[names[0]]


def _axis(vibration: Vibration, axis: str | None) -> Axis:
    """Return the axis that is named, or the only one along which the base is shaken."""
    if axis is None and len(vibration.axes) == 1:
        return vibration.axes[0]
    along = next((each for each in vibration.axes if each == axis), None)
    if along is None:
        text = f"the base is shaken along {' and '.join(vibration.axes)}"
        raise SolveError("which-axis", text, f"name one by --axis: {', '.join(vibration.axes)}")
    return along


def _primary_frequency(structure: Structure, axis: str) -> float:
    """Return the frequency of the mode that moves most mass along an axis [Hz]."""
    modes = natural_modes(structure.stiffness, structure.mass)
    share = (modes.shapes.T @ structure.pull[axis]) ** 2
    return float(modes.angular[int(np.argmax(share))] / (2.0 * np.pi))


def _level(applied: AppliedASD, f: Floats, side: Side) -> Floats:
    inside = np.clip(f, applied.frequency[0], applied.frequency[-1])
    return spectral_level(inside, applied.frequency, applied.level, scale=applied.scale, side=side)


def _inside(f: Floats | list[float], corners: Floats) -> Floats:
    at = np.asarray(f, dtype=np.float64)
    return np.asarray(at[(at > corners[0]) & (at < corners[-1])])


def _rms(density: Floats, f: Floats) -> float:
    """Return the rms of a density."""
    return float(np.sqrt(np.trapezoid(density, f)))


def _notes(depth: float) -> Iterator[Note]:
    if depth == 0.0:
        yield Note("no-notch", "the force stays below the limit: there is no notch")
    elif depth < -DEEP_DB:
        yield Note("deep-notch", f"the notch is {-depth:.1f} dB deep: show where C comes from")
