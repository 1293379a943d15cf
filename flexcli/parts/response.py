"""The response of the mechanism's own modes to a vibration or a shock of its base."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import pi, sqrt

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.modal_response import response_moments
from flexcli.numerics.modes import Modes, natural_modes
from flexcli.parts.asd import RandomVibration
from flexcli.parts.shock import Shock
from flexcli.parts.structure import Structure
from flexcli.results import ModeResult

__all__ = ["REACH", "Output", "RandomResponse", "random_response", "shock_peaks"]

Floats = NDArray[np.float64]

REACH = 10.0
"""Modes above so many times the band's end follow it without resonance: what is left out of
their response is (1/10)² = 1 % of it. They are lumped into one static term."""

PARTICIPATES = 1e-9
"""Share of the moving mass below which the base does not move a mode at all."""


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


class _Rows:
    """The outputs of a structure as one stack of rows, and back to their names."""

    def __init__(self, structure: Structure) -> None:
        self.names = list(structure.outputs)
        self.matrix = np.concatenate([structure.outputs[name] for name in self.names])
        self.ends = np.cumsum([structure.outputs[name].shape[0] for name in self.names])[:-1]

    def by_name(self, stacked: Floats) -> Iterator[tuple[str, Floats]]:
        """Yield each output's part of an array whose last axis is the stack."""
        yield from zip(self.names, np.split(stacked, self.ends, axis=-1), strict=True)


def random_response(structure: Structure, vibration: RandomVibration) -> RandomResponse:
    """Return the response of a structure to the vibration of a case.

    Every output has several rows (blades, ends, faces, components); the worst row stands for it,
    except a force, whose components add as vectors. Modes that the band can't excite are lumped
    into one static term. Axes are independent and add by the root of the sum of squares.
    """
    applied = vibration.applied()
    modes, rows = natural_modes(structure.stiffness, structure.mass), _Rows(structure)
    total = np.zeros((4, rows.matrix.shape[0]))
    alone = np.zeros((modes.angular.size, rows.matrix.shape[0]))
    shares, dynamic = np.zeros(modes.angular.size), np.zeros(modes.angular.size, dtype=bool)
    in_reach = modes.angular < 2.0 * pi * REACH * float(applied.frequency[-1])
    for axis in vibration.axes:
        participation, share, static = _excitation(structure, modes, rows.matrix, axis)
        excited = in_reach & (share > PARTICIPATES)
        shares, dynamic = np.maximum(shares, share), dynamic | excited
        per_mode = -(rows.matrix @ modes.shapes) * participation

        def moments(
            chosen: NDArray[np.intp], residual: Floats, per_mode: Floats = per_mode
        ) -> Floats:
            return response_moments(
                frequency=applied.frequency,
                level=applied.level,
                scale=applied.scale,
                angular=modes.angular[chosen],
                Q=vibration.q,
                coefficients=per_mode[:, chosen],
                residual=residual,
            )

        static_part = (per_mode[:, excited] / modes.angular[excited] ** 2).sum(axis=1)
        total += moments(np.flatnonzero(excited), static - static_part)
        for index in np.flatnonzero(excited):
            alone[index] += moments(np.array([index]), np.zeros(static.size))[0]
    outputs = {name: _output(name, block) for name, block in rows.by_name(total)}
    found = tuple(
        ModeResult(
            float(modes.angular[i]) / (2.0 * pi),
            float(shares[i]),
            bool(dynamic[i]),
            {n: sqrt(_mean_square(n, block)) for n, block in rows.by_name(alone[i])}
            if dynamic[i]
            else {},
        )
        for i in range(modes.angular.size)
    )
    return RandomResponse(found, outputs)


def shock_peaks(structure: Structure, shock: Shock) -> dict[str, float]:
    """Return the peak of every output under a shock.

    Each mode's peak from the response spectrum of the shock; modes add by the root of the sum of
    squares, because their peaks come at different times.

    Raises ValueError where a spectrum does not reach a mode's frequency.
    """
    modes, rows = natural_modes(structure.stiffness, structure.mass), _Rows(structure)
    participation, share, _ = _excitation(structure, modes, rows.matrix, shock.axis)
    excited = np.flatnonzero(share > PARTICIPATES)
    peaks = shock.pseudo_acceleration(modes.angular[excited] / (2.0 * pi))
    amplitudes = (rows.matrix @ modes.shapes[:, excited]) * participation[excited]
    squares = ((amplitudes * peaks / modes.angular[excited] ** 2) ** 2).sum(axis=1)
    return {name: sqrt(_mean_square(name, block)) for name, block in rows.by_name(squares)}


def _excitation(
    structure: Structure, modes: Modes, rows: Floats, axis: str
) -> tuple[Floats, Floats, Floats]:
    """Return participation and mass share of each mode, and the static response of each row."""
    force = structure.pull[axis]
    participation = modes.shapes.T @ force
    static = -rows @ np.linalg.solve(structure.stiffness, force)
    return participation, participation**2 / structure.moved[axis], static


def _mean_square(name: str, squares: Floats) -> float:
    return float(squares.sum() if name.startswith("force") else squares.max())


def _output(name: str, moments: Floats) -> Output:
    worst = moments[:, int(np.argmax(moments[0]))]
    chosen = moments.sum(axis=1) if name.startswith("force") else worst
    m0, m1, m2, m4 = (float(m) for m in chosen)
    return Output(sqrt(m0), sqrt(m2 / m0) if m0 > 0.0 else 0.0, (m0, m1, m2, m4))
