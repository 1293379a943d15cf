"""The response of the mechanism's own modes to a vibration or a shock of its base."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.modal_response import harmonic_gain, response_moments, squared_gain
from flexcli.formulas.spectrum import spectral_level
from flexcli.numerics.modes import Modes, natural_modes
from flexcli.parts.asd import AppliedASD, Axis, Vibration
from flexcli.parts.quality import Quality
from flexcli.parts.shock import Shock
from flexcli.parts.structure import Structure
from flexcli.results.vibration import ModeResult

__all__ = [
    "REACH",
    "Output",
    "OutputRows",
    "RandomResponse",
    "apparent_mass",
    "excited_modes",
    "mode_qualities",
    "participations",
    "random_outputs",
    "random_response",
    "response_density",
    "shock_peaks",
    "sine_peaks",
    "sweep_points",
    "transfer_functions",
]

Floats = NDArray[np.float64]

REACH = 10.0
"""Modes above so many times the band's end follow it without resonance: what is left out of
their response is (1/10)² = 1 % of it. They are lumped into one static term."""

CROWD = np.geomspace(0.02, 20.0, 60)
"""Half-bandwidths from a resonance at which a sweep is looked at: its top to 1e-4."""

PER_SWEEP = 2000
"""Frequencies of a sweep between two resonances."""

PARTICIPATES = 1e-9
"""Part of the moving mass below which the base does not excite a mode."""

UNSTATED = 0.02
"""Part of a stress up to which modes above the end of a shock's spectrum are taken as if it went
on: those inside blades, far above what tests state."""


@dataclass(frozen=True)
class Output:
    """One response in total: rms, rate of upward zero crossings, spectral moments."""

    rms: float
    crossing_rate: float
    moments: tuple[float, float, float, float]


@dataclass(frozen=True)
class RandomResponse:
    """Response to one case's vibration: modes and, per output, the total over modes and axes."""

    modes: tuple[ModeResult, ...]
    outputs: Mapping[str, Output]


class OutputRows:
    """The outputs of a structure as one stack of rows, and back to their names."""

    def __init__(self, structure: Structure) -> None:
        self.names = list(structure.outputs)
        blocks = [np.atleast_2d(rows) for rows in structure.outputs.values()]
        self.shapes = [(*rows.shape[:-1], 1)[:2] for rows in blocks]
        self.matrix = np.concatenate([rows.reshape(-1, rows.shape[-1]) for rows in blocks])
        self.ends = np.cumsum([places * parts for places, parts in self.shapes])[:-1]

    def by_name(self, stacked: Floats) -> Iterator[tuple[str, Floats]]:
        """Yield each output's part of an array whose last axis is the stack, by its places."""
        parts = np.split(stacked, self.ends, axis=-1)
        for name, shape, part in zip(self.names, self.shapes, parts, strict=True):
            yield name, part.reshape(*part.shape[:-1], *shape)


def random_response(structure: Structure, vibration: Vibration) -> RandomResponse:
    """Return the response of a structure to the vibration of a case.

    Every output has several places (blades, ends, faces); the worst stands for it. At each the
    components, of a vector or of an equivalent stress, add as squares. Modes that the band can't
    excite are lumped into one static term. Axes are independent and add by the root of the sum of
    squares.
    """
    modes = natural_modes(structure.stiffness, structure.mass)
    outputs = {name: _output(block) for name, block in _moments(structure, vibration, modes)}
    shares, alone = _each_mode(structure, vibration, modes)
    found = tuple(
        ModeResult(float(angular) / (2.0 * pi), float(share), bool(rms), rms)
        for angular, share, rms in zip(modes.angular, shares, alone, strict=True)
    )
    return RandomResponse(found, outputs)


def random_outputs(structure: Structure, vibration: Vibration) -> dict[str, Output]:
    """Return the totals of :func:`random_response` without the responses of single modes."""
    modes = natural_modes(structure.stiffness, structure.mass)
    return {name: _output(block) for name, block in _moments(structure, vibration, modes)}


def _moments(
    structure: Structure, vibration: Vibration, modes: Modes
) -> Iterator[tuple[str, Floats]]:
    """Yield the spectral moments (4, places, components) of outputs, all modes and axes added."""
    rows = OutputRows(structure)
    qualities = mode_qualities(structure, vibration.q, vibration.axes, modes)
    total = np.zeros((4, rows.matrix.shape[0]))
    for axis, applied in vibration.by_axis().items():
        participation, share, static = participations(structure, modes, rows.matrix, axis)
        excited = excited_modes(modes, share, applied)
        per_mode = (-(rows.matrix @ modes.shapes) * participation)[:, excited]
        static_part = (per_mode / modes.angular[excited] ** 2).sum(axis=1)
        angular, Q = modes.angular[excited], qualities[excited]
        total += _response(applied, angular, Q, per_mode, static - static_part)
    yield from rows.by_name(total)


def _each_mode(
    structure: Structure, vibration: Vibration, modes: Modes
) -> tuple[Floats, list[dict[str, float]]]:
    """Return each mode's mass share and own rms responses, none where it is not excited."""
    rows = OutputRows(structure)
    qualities = mode_qualities(structure, vibration.q, vibration.axes, modes)
    squares = np.zeros((modes.angular.size, rows.matrix.shape[0]))
    shares, dynamic = np.zeros(modes.angular.size), np.zeros(modes.angular.size, dtype=bool)
    for axis, applied in vibration.by_axis().items():
        participation, share, _ = participations(structure, modes, rows.matrix, axis)
        excited = excited_modes(modes, share, applied)
        shares, dynamic = np.maximum(shares, share), dynamic | excited
        per_mode = -(rows.matrix @ modes.shapes) * participation
        for i in np.flatnonzero(excited):
            nothing = np.zeros(rows.matrix.shape[0])
            angular, Q = modes.angular[[i]], qualities[[i]]
            found = _response(applied, angular, Q, per_mode[:, [i]], nothing)
            squares[i] += found[0]
    alone = [
        {name: sqrt(_largest_square(block)) for name, block in rows.by_name(squares[i])}
        if dynamic[i]
        else {}
        for i in range(modes.angular.size)
    ]
    return shares, alone


def excited_modes(modes: Modes, share: Floats, applied: AppliedASD) -> NDArray[np.bool_]:
    """Return which modes may resonate: in reach of the band, and moved by the base."""
    reach = 2.0 * pi * REACH * float(applied.frequency[-1])
    return np.asarray((modes.angular < reach) & (share > PARTICIPATES))


def mode_qualities(
    structure: Structure, quality: Quality, axes: Iterable[str], modes: Modes
) -> Floats:
    """Return Q of every mode.

    They are counted as the base moves them along any of the axes, the lowest first.
    """
    found = np.full(modes.angular.size, quality.all)
    if quality.modes:
        moved = np.zeros(modes.angular.size, dtype=bool)
        for axis in axes:
            share = (modes.shapes.T @ structure.pull[axis]) ** 2 / structure.moved[axis]
            moved |= share > PARTICIPATES
        order = np.flatnonzero(moved)
        for number, q in quality.modes.items():
            found[order[number - 1 : number]] = q
    return found


def _response(
    applied: AppliedASD, angular: Floats, Q: Floats, per_mode: Floats, residual: Floats
) -> Floats:
    return response_moments(
        frequency=applied.frequency,
        level=applied.level,
        scale=applied.scale,
        angular=angular,
        Q=Q,
        coefficients=per_mode,
        residual=residual,
    )


def sine_peaks(
    structure: Structure,
    level: Callable[[Floats], Floats],
    quality: Quality,
    frequencies: tuple[float, ...],
    axis: str = "x",
) -> dict[str, float]:
    """Return the largest steady amplitude of every output under a sine of the base.

    Parameters
    ----------
    structure : Structure
        The structure.
    level : callable
        Amplitude of the base's acceleration [m/s²] at frequencies [Hz].
    quality : Quality
        Quality factors of the modes.
    frequencies : tuple of float
        Lowest and highest frequency [Hz], equal for one sine, and crossovers of the level.
    axis : str
        Axis of the base's motion.

    Returns
    -------
    dict of float
        Amplitudes: of a sweep the largest over its frequencies, each as if it had settled.

    """
    modes, rows = natural_modes(structure.stiffness, structure.mass), OutputRows(structure)
    Q = mode_qualities(structure, quality, (axis,), modes)
    ends = min(frequencies), max(frequencies)
    f = np.union1d(sweep_points(ends, modes.angular / (2.0 * pi), Q), frequencies)
    squares = squared_gain(f, modes.angular, Q, *_coefficients(structure, modes, rows.matrix, axis))
    squares *= level(f)[:, None] ** 2
    found = {}
    for name, block in rows.by_name(squares):
        # components that are not in phase stay below the root of the sum of their squares
        found[name] = sqrt(float((block @ np.ones(block.shape[-1])).max()))
    return found


def transfer_functions(
    structure: Structure, Q: float | Floats, axis: str, f: Floats
) -> dict[str, NDArray[np.complex128]]:
    """Return the acceleration of every body per acceleration of the base along an axis.

    Parameters
    ----------
    structure : Structure
        The structure.
    Q : float or array
        Quality factor of every mode, or of each.
    axis : str
        Axis of the base's motion.
    f : array, shape (n,)
        Frequencies [Hz].

    Returns
    -------
    dict of array, shape (n, directions)
        By body: absolute acceleration in the structure's directions, along [-] and about [rad/m].

    """
    modes = natural_modes(structure.stiffness, structure.mass)
    rows = np.concatenate([np.zeros((0, modes.shapes.shape[0])), *structure.bodies.values()])
    relative = _gain(structure, modes, rows, axis, Q, f)
    base = np.tile([float(axis == each) for each in structure.directions], len(structure.bodies))
    absolute = base - (2.0 * pi * f[:, None]) ** 2 * relative
    return dict(zip(structure.bodies, np.split(absolute, len(structure.bodies), -1), strict=True))


def apparent_mass(
    structure: Structure, Q: float | Floats, axis: str, f: Floats
) -> NDArray[np.complex128]:
    """Return force over acceleration at the base along an axis [kg], shape of f.

    At rest it is all the mass that the base moves, at a resonance some Q times that of the mode.
    """
    modes, pull = natural_modes(structure.stiffness, structure.mass), structure.pull[axis]
    gain = _gain(structure, modes, pull[None, :], axis, Q, f)[:, 0]
    return np.asarray(structure.moved[axis] - (2.0 * pi * f) ** 2 * gain)


def response_density(
    structure: Structure, vibration: Vibration
) -> tuple[Floats, dict[Axis, Floats], dict[str, Floats]]:
    """Return the spectral density of every output and of every body's acceleration.

    An output is told by its place of the largest rms, the components there added.

    Returns
    -------
    tuple
        Frequencies [Hz], twice where a profile steps; the density of the base along each axis
        [(m/s²)²/Hz]; by output its own, in the unit of the output squared per hertz.

    """
    densities, rows = vibration.by_axis(), OutputRows(structure)
    modes = natural_modes(structure.stiffness, structure.mass)
    Q = mode_qualities(structure, vibration.q, densities, modes)
    f, levels = _density_points(densities, modes.angular / (2.0 * pi), Q)
    squares = np.zeros((f.size, rows.matrix.shape[0]))
    found: dict[str, Floats] = {}
    for axis, level in levels.items():
        gain = _gain(structure, modes, rows.matrix, axis, Q, f)
        squares += np.abs(gain) ** 2 * level[:, None]
        for name, gains in transfer_functions(structure, Q, axis, f).items():
            for n, direction in enumerate(structure.directions):
                if direction.startswith("theta"):
                    continue
                key = f"acceleration {name} {direction}"
                before = found.get(key, np.zeros(f.size))
                found[key] = before + np.abs(gains[:, n]) ** 2 * level
    largest = dict(_worst_rows(structure, vibration, modes))
    for name, block in rows.by_name(squares):
        found[name] = block.sum(axis=-1)[:, largest[name]]
    return f, levels, found


def _worst_rows(
    structure: Structure, vibration: Vibration, modes: Modes
) -> Iterator[tuple[str, int]]:
    for name, block in _moments(structure, vibration, modes):
        yield name, int(np.argmax(block[0].sum(axis=-1)))


def _gain(
    structure: Structure, modes: Modes, rows: Floats, axis: str, Q: float | Floats, f: Floats
) -> NDArray[np.complex128]:
    """Return the complex amplitude of rows per acceleration of the base, by all modes."""
    return harmonic_gain(f, modes.angular, Q, *_coefficients(structure, modes, rows, axis))


def _coefficients(
    structure: Structure, modes: Modes, rows: Floats, axis: str
) -> tuple[Floats, Floats]:
    """Return what rows have of each mode and of none, per acceleration of the base."""
    participation, _, static = participations(structure, modes, rows, axis)
    per_mode = -(rows @ modes.shapes) * participation
    return per_mode, static - (per_mode / modes.angular**2).sum(axis=1)


def _density_points(
    densities: Mapping[Axis, AppliedASD], resonances: Floats, Q: Floats
) -> tuple[Floats, dict[Axis, Floats]]:
    """Return frequencies that show every resonance and corner, and each axis' level there.

    Outside its own band a level is zero.
    """
    each = [applied.frequency for applied in densities.values()]
    corners = np.unique(np.concatenate(each))
    inner = sweep_points((float(corners[0]), float(corners[-1])), resonances, Q)
    steps = [f[1:][np.diff(f) == 0.0] for f in each]
    ends = [f[[0, -1]] for f in each]
    # a frequency stands twice where any axis steps, or starts or ends within another's band
    inside = [end[(end > corners[0]) & (end < corners[-1])] for end in ends]
    twice = np.unique(np.concatenate([*steps, *inside]))
    f = np.sort(np.concatenate([np.union1d(inner, corners), twice]))
    after = np.concatenate([[False], np.diff(f) == 0.0])
    levels: dict[Axis, Floats] = {}
    for axis, applied in densities.items():
        left, right = (
            spectral_level(f, applied.frequency, applied.level, scale=applied.scale, side=side)
            for side in ("left", "right")
        )
        low, high = applied.frequency[[0, -1]]
        left[(f == low) & (low > corners[0])] = 0.0
        right[(f == high) & (high < corners[-1])] = 0.0
        levels[axis] = np.where(after, right, left)
    return f, levels


def sweep_points(frequencies: tuple[float, float], resonances: Floats, Q: float | Floats) -> Floats:
    """Return frequencies [Hz] that include every resonance, dense there by its bandwidth."""
    low, high = sorted(frequencies)
    if low == high:
        return np.array([low])
    width = 0.5 / np.broadcast_to(Q, resonances.shape)
    crowd = np.concatenate([-CROWD[::-1], [0.0], CROWD])
    around = (resonances[:, None] * (1.0 + width[:, None] * crowd)).ravel()
    regular = np.geomspace(low, high, PER_SWEEP)
    inside = around[(around > low) & (around < high)]
    return np.unique(np.concatenate([regular, inside]))


def shock_peaks(structure: Structure, shock: Shock) -> dict[str, float]:
    """Return the peak of every output under a shock.

    Modes are added as `Shock.peaks` says.

    Raises ValueError where a spectrum does not reach a mode that has a part in a peak.
    """
    modes, rows = natural_modes(structure.stiffness, structure.mass), OutputRows(structure)
    participation, share, _ = participations(structure, modes, rows.matrix, shock.axis)
    excited = np.flatnonzero(share > PARTICIPATES)
    angular = modes.angular[excited]
    fn = angular / (2.0 * pi)
    per_mode = (rows.matrix @ modes.shapes[:, excited]) * participation[excited] / angular**2
    each = {name: np.moveaxis(block, 0, -1) for name, block in rows.by_name(per_mode.T)}
    if not excited.size:
        return dict.fromkeys(each, 0.0)
    beyond = shock.unstated(fn)
    peaks = dict(zip(each, shock.peaks(list(each.values()), fn), strict=True))
    if beyond.any():
        stresses = [name for name in peaks if "stress" in name]
        largest = max((peaks[name] for name in stresses), default=0.0)
        for name in stresses:
            (part,) = shock.peaks([each[name][..., beyond]], fn[beyond])
            if peaks[name] > PARTICIPATES * largest and part > UNSTATED * peaks[name]:
                raise ValueError(
                    f"the spectrum ends at {shock.srs[-1].frequency:g} Hz, and modes beyond, from "
                    f"{fn[beyond].min():.5g} Hz on, have a part in the {name}"
                )
    return peaks


def participations(
    structure: Structure, modes: Modes, rows: Floats, axis: str
) -> tuple[Floats, Floats, Floats]:
    """Return participation and mass share of each mode, and the static response of each row."""
    force = structure.pull[axis]
    participation = modes.shapes.T @ force
    static = -rows @ np.linalg.solve(structure.stiffness, force)
    return participation, participation**2 / structure.moved[axis], static


def _largest_square(squares: Floats) -> float:
    """Return the largest sum of the squares of the components at a place."""
    return float(squares.sum(axis=-1).max())


def _output(moments: Floats) -> Output:
    by_place = moments.sum(axis=-1)
    m0, m1, m2, m4 = (float(m) for m in by_place[:, int(np.argmax(by_place[0]))])
    return Output(sqrt(m0), sqrt(m2 / m0) if m0 > 0.0 else 0.0, (m0, m1, m2, m4))
