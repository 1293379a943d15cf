"""Response and damage spectra of an environment, and environments of equal damage."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from importlib import import_module
from math import ceil, log2, log10
from time import perf_counter
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.asd import column, describe, made
from flexcli.errors import SolveError
from flexcli.formulas.damage_spectrum import (
    damage_spectrum,
    equal_damage_factor,
    extreme_spectrum,
)
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.record_spectrum import record_turns, shock_response_spectrum
from flexcli.parts.asd import ASDProfile
from flexcli.parts.record import Record
from flexcli.results import Cost, Note, Result, Status, Value
from flexcli.results.vibration import Spectrum
from flexcli.units import show

__all__ = ["Environment", "Grid", "equal_damage", "fatigue_damage", "shock_response"]

Floats = NDArray[np.float64]

PER_OCTAVE = 12
FINE = 48
"""Natural frequencies an octave at which damages are compared."""
FEW_SAMPLES = 10.0
"""Samples a period below which a record is no straight line between them (ISO 18431-4)."""
FOLLOWED = 3.0
"""Natural periods times Q that the free motion after a record is counted for."""
MOST = 5000
"""Natural frequencies of a spectrum."""
SEVERE_DB, SEVERE_PEAK = 3.0, 1.05
"""Level over that of equal damage [dB], and extreme response over those of service, from which a
test is called more severe."""


class Environment(NamedTuple):
    """A profile or a record by its name, and how long it lasts [s]; a record has its own time."""

    name: str
    source: ASDProfile | Record
    duration: float | None = None

    @property
    def seconds(self) -> float:
        """Return the time that it lasts, or raise SolveError where nobody says."""
        if isinstance(self.source, Record):
            return self.source.duration
        time = self.source.duration if self.duration is None else self.duration
        if time is None:
            text = f"nothing says how long {self.name} lasts"
            raise SolveError("no-duration", text, "add --duration '2 min', or duration: to it")
        return time


class Grid(NamedTuple):
    """Natural frequencies of a spectrum: its ends [Hz], the environment's where left out."""

    low: float | None = None
    high: float | None = None
    per_octave: int = PER_OCTAVE

    def frequencies(self, source: ASDProfile | Record) -> Floats:
        """Return the natural frequencies, or raise SolveError where they make no range."""
        if isinstance(source, Record):
            least, most = 5.0 / source.duration, 0.1 / source.step
        else:
            least, most = source.frequencies[0], source.frequencies[-1]
            least = least or most / 1000.0
        low = float(least if self.low is None else self.low)
        high = float(most if self.high is None else self.high)
        if not low < high:
            text = f"{low:.4g} to {high:.4g} Hz is no range of natural frequencies"
            raise SolveError("no-range", text, "give --from below --to")
        count = max(1, ceil(self.per_octave * log2(high / low) - 1e-9))
        if count > MOST:
            text = f"{count} natural frequencies are asked for, more than {MOST}"
            raise SolveError("too-many", text, "take fewer an octave")
        return np.geomspace(low, high, count + 1)


def shock_response(environment: Environment, Q: float, grid: Grid) -> Result:
    """Return the shock response spectrum of a record, or the extreme one of a random vibration."""
    started = perf_counter()
    source = environment.source
    f = grid.frequencies(source)
    columns = [column("frequency", "Hz", "natural frequency", f)]
    notes: tuple[Note, ...] = ()
    if isinstance(source, Record):
        up, down, pseudo = shock_response_spectrum(source.acceleration, source.step, f, Q)
        told = "largest absolute acceleration"
        columns += [
            column("srs", "m/s^2", f"{told} either way", np.maximum(up, down)),
            column("positive", "m/s^2", told, up),
            column("negative", "m/s^2", f"{told} the other way", down),
            column("pseudo", "m/s^2", "largest spring force per mass, ω² z", pseudo),
        ]
        name = f"shock response spectrum, Q = {Q:g}"
        notes = _sampling_notes(source, f)
        model = "exact between samples"
    else:
        g, scale, time = source.levels, source.scale, environment.seconds
        found = oscillator_response(source.frequencies, g, f, Q, scale=scale)
        extreme = _extreme(source, f, Q, time)
        columns += [
            column("extreme", "m/s^2", f"largest ω² z to expect in {show(time, 's')}", extreme),
            column("rms pseudo", "m/s^2", "rms of ω² z", found.pseudo_acceleration),
            column("rms absolute", "m/s^2", "rms acceleration", found.absolute_acceleration),
        ]
        name = f"extreme response spectrum, Q = {Q:g}, {show(time, 's')}"
        model = "quadrature (exact)"
    spectrum = Spectrum("srs", name, "", tuple(columns))
    return _result("asd srs", environment.name, spectrum, notes, started, model)


def fatigue_damage(environment: Environment, Q: float, exponent: float, grid: Grid) -> Result:
    """Return the fatigue damage spectrum of a record or of a random vibration."""
    started = perf_counter()
    source = environment.source
    f = grid.frequencies(source)
    damage = _damage(environment, f, Q, exponent)
    label = f"Σ amplitude^{exponent:g} of the displacement z relative to the base"
    columns = (
        column("frequency", "Hz", "natural frequency", f),
        column("damage", f"m^{exponent:g}", label, damage),
    )
    name = f"fatigue damage spectrum, Q = {Q:g}, b = {exponent:g}"
    notes = _sampling_notes(source, f) if isinstance(source, Record) else ()
    model = "rainflow" if isinstance(source, Record) else "narrow-band, exact rms"
    spectrum = Spectrum("fds", name, "", columns)
    return _result("asd fds", environment.name, spectrum, notes, started, model)


def equal_damage(
    environments: Sequence[Environment],
    shape: Environment | None,
    duration: float,
    Q: float,
    exponent: float,
    grid: Grid,
) -> Result:
    """Return a profile of a shape and a duration that does the damage of environments.

    Its level is the least that does no less at any natural frequency; of one environment in its
    own shape that is (T/T')^(2/b) times the level, whatever the frequency.

    Raises
    ------
    SolveError
        When an environment has no duration, or no shape is given for a record.

    """
    started = perf_counter()
    first = environments[0].source
    target = shape.source if shape is not None else first
    if not isinstance(target, ASDProfile):
        raise SolveError("no-shape", "a record has no shape to scale", "add --to PROFILE")
    fine = grid._replace(per_octave=max(grid.per_octave, FINE))
    f = np.union1d(fine.frequencies(target), _inside(target.frequencies, grid))
    wanted = np.sum([_damage(each, f, Q, exponent) for each in environments], axis=0)
    name = shape.name if shape is not None else environments[0].name
    own = _damage(Environment(name, target, duration), f, Q, exponent)
    factors = equal_damage_factor(own, wanted, exponent)
    at = int(np.argmax(factors))
    factor = float(factors[at])
    names = ", ".join(each.name for each in environments)
    title = f"{name}, {10.0 * log10(factor):+.3g} dB, of the damage of {names}"
    note = f"b = {exponent:g}, Q = {Q:g}; {show(duration, 's')} of it do the damage of {names}."
    scaled = made(title, note, target.frequencies, factor * target.levels, [target])
    scaled = scaled.model_copy(update={"duration": duration})
    found = describe("asd equal-damage", names, scaled)
    excess = 10.0 * log10(factor / float(factors.min()))
    peaks = _peaks(environments, scaled, f, Q, duration)
    own_values = {
        "db": Value(10.0 * log10(factor), "dB", f"added to the level of {name}"),
        "factor": Value(factor, "", f"on the level of {name}"),
        "f_governing": Value(float(f[at]), "Hz", "natural frequency at which the damage is equal"),
        "db_excess": Value(excess, "dB", "most that it is above equal damage elsewhere"),
    }
    if peaks is not None:
        own_values["peak_ratio"] = Value(
            peaks, "", "its extreme response over theirs, the largest over all frequencies"
        )
    columns = (
        column("frequency", "Hz", "natural frequency", f),
        column("damage", f"m^{exponent:g}", f"of {names}", wanted),
        column("damage of the new", f"m^{exponent:g}", title, own * factor ** (exponent / 2.0)),
    )
    spectrum = Spectrum("fds", f"fatigue damage, Q = {Q:g}, b = {exponent:g}", "", columns)
    return replace(
        found,
        values={**own_values, **found.values},
        warnings=tuple(_severity_notes(excess, peaks)),
        spectra=(spectrum,),
        cost=Cost(perf_counter() - started, "narrow-band, exact rms", None),
    )


def _severity_notes(excess: float, peaks: float | None) -> Iterator[Note]:
    """Yield where a test of equal damage is more severe than service."""
    if excess > SEVERE_DB:
        text = f"another shape: the level is up to {excess:.1f} dB above equal damage elsewhere"
        yield Note("overtest", text)
    if peaks is not None and peaks > SEVERE_PEAK:
        text = f"its extreme response is up to {peaks:.2f} times theirs: what breaks or yields at "
        yield Note("higher-peaks", f"{text}once, or hits a stop, sees more than in service")


def _peaks(
    environments: Sequence[Environment], new: ASDProfile, f: Floats, Q: float, duration: float
) -> float | None:
    """Return the largest ratio of the new extreme response to the old, where both are random."""
    old = []
    for each in environments:
        if isinstance(each.source, Record):
            return None
        old.append(_extreme(each.source, f, Q, each.seconds))
    return float(np.max(_extreme(new, f, Q, duration) / np.max(old, axis=0)))


def _extreme(source: ASDProfile, f: Floats, Q: float, time: float) -> Floats:
    try:
        return extreme_spectrum(source.frequencies, source.levels, f, Q, time, scale=source.scale)
    except ValueError as error:
        raise SolveError("few-cycles", str(error), "give a longer duration") from error


def _damage(environment: Environment, f: Floats, Q: float, exponent: float) -> Floats:
    source = environment.source
    if isinstance(source, Record):
        return _rainflow_damage(source, f, Q, exponent)
    return damage_spectrum(
        source.frequencies, source.levels, f, Q, environment.seconds, exponent, scale=source.scale
    )


def _rainflow_damage(record: Record, f: Floats, Q: float, exponent: float) -> Floats:
    """Return the rainflow damage of a record at each natural frequency, half cycles as halves."""
    try:
        extract = import_module("rainflow").extract_cycles
    except ImportError as error:
        hint = "pip install 'flexcli[vibration]'"
        text = "counting the cycles of a record needs the extra 'vibration'"
        raise SolveError("no-rainflow", text, hint) from error
    damage = []
    for each in f.tolist():
        turns = record_turns(
            record.acceleration, record.step, each, Q, signal="relative", rest=FOLLOWED * Q
        )
        cycles = np.array([(size, count) for size, _, count, *_ in extract(turns)])
        damage.append(float(((0.5 * cycles[:, 0]) ** exponent) @ cycles[:, 1]))
    return np.array(damage)


def _inside(f: Floats, grid: Grid) -> Floats:
    low, high = (f[0] if grid.low is None else grid.low, f[-1] if grid.high is None else grid.high)
    return f[(f >= low) & (f <= high) & (f > 0.0)]


def _sampling_notes(record: Record, f: Floats) -> tuple[Note, ...]:
    """Return a warning where a record has too few samples in a natural period."""
    most = 1.0 / (FEW_SAMPLES * record.step)
    if f[-1] <= most * (1.0 + 1e-9):
        return ()
    text = f"above {most:.4g} Hz the record has fewer than {FEW_SAMPLES:g} samples a period"
    return (Note("coarse-record", f"{text}: between them it is taken as straight"),)


def _result(
    command: str, spec: str, spectrum: Spectrum, notes: tuple[Note, ...], started: float, model: str
) -> Result:
    over, main, *_ = spectrum.columns
    most = max(range(len(main.values)), key=lambda i: main.values[i])
    values = {
        f"{spectrum.kind}_max": Value(main.values[most], main.unit, f"greatest: {main.label}"),
        "f_max": Value(over.values[most], "Hz", "natural frequency of that"),
    }
    cost = Cost(perf_counter() - started, model, None)
    return Result(command, spec, Status.PASS, values=values, warnings=notes, cost=cost,
                  spectra=(spectrum,))  # fmt: skip
