"""The random response by Miles' formula for one mode, and the range of its error."""

from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.miles import miles
from flexcli.formulas.oscillator import oscillator_response
from flexcli.formulas.spectrum import spectral_level
from flexcli.formulas.spectrum_integrals import rms
from flexcli.numerics.modes import natural_modes
from flexcli.parts.asd import AppliedASD, Vibration
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.response import (
    REACH,
    OutputRows,
    excited_modes,
    mode_qualities,
    participations,
)
from flexcli.parts.structure import MOTIONS, Structure

__all__ = ["MilesOutput", "miles_outputs"]

Floats = NDArray[np.float64]

STEPS = 5
"""Stiffnesses over a range at which a mode's exact response is evaluated, besides those that put it
onto a corner of the profile."""

TELLING = 0.01
"""Part of an output from which another mode counts by its exact response, not by a bound."""


class MilesOutput(NamedTuple):
    """The rms of one response by Miles' formula, and the range of that of all modes."""

    rms: float
    least: float
    most: float


def miles_outputs(
    structure: Structure, vibration: Vibration, stiffer: tuple[float, float]
) -> dict[str, MilesOutput]:
    """Return every output by Miles' formula for the mode that is strongest in it.

    Parameters
    ----------
    structure : Structure
        The structure.
    vibration : Vibration
        What shakes its base; axes add by the root of the sum of squares.
    stiffer : (float, float)
        Between which factors of its stiffness the true one lies.

    Returns
    -------
    dict of MilesOutput
        By name, each at its worst place. The range has the exact response of that mode in the
        band as it is (its ends, slopes and the damping), at every stiffness, and all that the
        other modes may add or take: the rms of a sum differs from that of one term by no more
        than those of the others, however they are correlated. Where the strongest mode lies
        outside the band Miles has nothing, which the range tells.

    Raises
    ------
    NotAvailable
        When along an axis the band excites no mode.

    """
    modes, rows = natural_modes(structure.stiffness, structure.mass), OutputRows(structure)
    qualities = mode_qualities(structure, vibration.q, vibration.axes, modes)
    squares: dict[str, Floats] = {}
    for axis, applied in vibration.by_axis().items():
        participation, share, static = participations(structure, modes, rows.matrix, axis)
        excited = excited_modes(modes, share, applied)
        angular, Q = modes.angular[excited], qualities[excited]
        if not angular.size:
            raise NotAvailable(f"has no response by Miles: along {axis} no mode is in reach")
        # of each mode, per pseudo-acceleration of its oscillator
        alone = -((rows.matrix @ modes.shapes) * participation)[:, excited] / angular**2
        each = {name: np.linalg.norm(b, axis=-1) for name, b in rows.by_name(alone.T)}
        rest = dict(rows.by_name(static - alone.sum(axis=1)))
        found = _oscillators(applied, angular / (2.0 * pi), Q, stiffer, list(each.values()))
        follows = rms(applied.frequency, applied.level, scale=applied.scale) / (1.0 - REACH**-2)
        for name, sizes in each.items():
            at = np.arange(sizes.shape[1])
            strongest = (sizes * found.most[:, None]).argmax(axis=0)
            one = sizes[strongest, at]
            others = sizes.T @ found.most - one * found.most[strongest]
            others += np.linalg.norm(rest[name], axis=-1) * follows
            by_miles = one * found.by_miles[strongest]
            least = np.maximum(one * found.least[strongest] - others, 0.0)
            most = one * found.most[strongest] + others
            if name in MOTIONS:  # the same stress is made by less of it in what is stiffer
                least, most = least / max(stiffer), most / min(stiffer)
            squares[name] = squares.get(name, 0.0) + np.stack([by_miles, least, most]) ** 2
    return {
        name: MilesOutput(*np.sqrt(square).max(axis=-1).tolist())
        for name, square in squares.items()
    }


class _Oscillators(NamedTuple):
    """Rms pseudo-acceleration of modes (m,): by Miles, and the range of the exact one."""

    by_miles: Floats
    least: Floats
    most: Floats


def _oscillators(
    applied: AppliedASD,
    natural: Floats,
    Q: Floats,
    stiffer: tuple[float, float],
    sizes: list[Floats],
) -> _Oscillators:
    """Return the responses of modes; exact for those that matter, sizes (m, places)."""
    f, g, scale = applied.frequency, applied.level, applied.scale
    by_miles = miles(natural, Q, spectral_level(natural, f, g, scale=scale))
    lowest, highest = natural * stiffer[0] ** 0.5, natural * stiffer[1] ** 0.5
    # all of the band at its highest level, and from zero to infinity
    most = miles(highest, Q, float(g.max()))
    above = lowest > f[-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        most = np.where(
            above, np.minimum(most, rms(f, g, scale=scale) / (1.0 - (f[-1] / lowest) ** 2)), most
        )
    tells = np.zeros(natural.size, dtype=np.bool_)
    for size in sizes:
        bound = size * most[:, None]
        tells |= (bound > TELLING * bound.max(axis=0)).any(axis=1)
    least, chosen = np.zeros(natural.size), np.flatnonzero(tells)
    points = [_looked_at(f, lowest[mode], highest[mode]) for mode in chosen]
    if not points:
        return _Oscillators(by_miles, least, most)
    each = np.repeat(Q[chosen], [at.size for at in points])
    exact = oscillator_response(f, g, np.concatenate(points), each, scale=scale).pseudo_acceleration
    ends = np.cumsum([at.size for at in points])[:-1]
    for mode, found in zip(chosen, np.split(exact, ends), strict=True):
        least[mode], most[mode] = found.min(), found.max()
    return _Oscillators(by_miles, least, most)


def _looked_at(f: Floats, lowest: float, highest: float) -> Floats:
    """Return natural frequencies over a range, those of corners f of a profile among them."""
    corners = f[(f > lowest) & (f < highest)]
    return np.union1d(np.linspace(lowest, highest, STEPS), corners)
