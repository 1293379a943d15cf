"""The bent centre line of a blade in equilibrium, and the stress along it."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.element import turned
from flexcli.mechanics.mesh import SHEAR_FACTOR, Segment, column, pick
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.section_forces import along_piece, applied, flexible_pieces, section_forces
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.numerics.collocation import gauss_nodes, integration_to

__all__ = ["ROUNDING", "CentreLine", "centre_line"]

Floats = NDArray[np.float64]

_NODES = 24
"""Gauss nodes on a piece for the way along it: rounding for every profile."""


POINTS = 17
"""Places on each flexible piece, its ends among them."""

ROUNDING = 1e-9
"""Of the length: a piece that ends so near an end of the blade ends there."""


class CentreLine(NamedTuple):
    """Places along a blade (designs, points): arc at rest s [m], place (.., 2) [m], stress [Pa].

    ``stress`` is the larger of both faces' magnitudes, zero on rigid stretches, ``h`` the
    thickness [m], zero there too.
    """

    s: Floats
    place: Floats
    stress: Floats
    h: Floats


def centre_line(state: Equilibrium, blade: str) -> CentreLine:
    """Return where the axis of a blade lies, at ``POINTS`` places on each flexible piece.

    ``r(s) = r(0) + ∫ ((1 + ε) t + γ n) ds`` from the moved start, with t the direction of the
    section's normal and n across it; ε and γ of the section forces, where the state has them.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.
    blade : str
        Name of the blade.

    Returns
    -------
    CentreLine
        From the start of the blade to its end, rigid stretches by their two ends.

    """
    index = [b.name for b in state.layout.blades].index(blade)
    drawn = state.layout.blades[index]
    start = np.stack(np.broadcast_arrays(*(column(c) for c in drawn.start)), axis=-1)
    end = np.stack(np.broadcast_arrays(*(column(c) for c in drawn.end)), axis=-1)
    way = np.broadcast_to(end - start, (state.designs, 2))
    frame = np.zeros(state.designs)
    origin = np.broadcast_to(start, (state.designs, 2))
    if drawn.first in [body.name for body in state.layout.bodies]:
        frame = state.motions[:, state.layout.index(drawn.first), 2]
        origin = origin + point_motion(state, drawn.first, drawn.start)
    angle = np.arctan2(way[:, 1], way[:, 0])
    length = np.hypot(way[:, 0], way[:, 1])
    whole = [_of_part(state, part, index, length[part.rows]) for part in state.parts]
    local = state.scatter([np.moveaxis(np.stack(each), 0, 1) for each in whole])
    s, x, y, stress, h = np.moveaxis(local, 1, 0)
    bent = np.stack([x, y], axis=-1)
    turn = np.broadcast_to((angle + frame)[:, None], x.shape)
    place = origin[:, None, :] + bent + turned(bent, turn)[1]
    return CentreLine(s, place, stress, h)


def _of_part(state: Equilibrium, part: Part, blade: int, length: Floats) -> tuple[Floats, ...]:
    """Return s, x, y in the frame of the start, stress and h (designs of the part, places)."""
    rows = part.rows.size
    u = np.linspace(-1.0, 1.0, POINTS)[None]
    at = np.zeros((rows, 3))  # s, x, y reached
    found: list[Floats] = []
    turn = np.zeros(rows)
    for segment in flexible_pieces(part, blade):
        piece = _piece(state, part, blade, segment, u)
        s, psi = piece[:, 0], piece[:, 5]
        if not found and not _is_there(s[:, 0], 0.0, length):  # a rigid start
            found.append(np.zeros((rows, 5, 1)))
        at = _straight_to(at, s[:, 0], psi[:, 0])
        piece[:, 1] += at[:, 1, None]
        piece[:, 2] += at[:, 2, None]
        found.append(piece[:, :5])
        at, turn = np.stack([s[:, -1], piece[:, 1, -1], piece[:, 2, -1]], axis=-1), psi[:, -1]
    if not _is_there(at[:, 0], length, length):  # a rigid end
        last = np.zeros((rows, 5, 1))
        last[:, :3, 0] = _straight_to(at, length, turn)
        found.append(last)
    return tuple(np.moveaxis(np.concatenate(found, axis=-1), 1, 0))


def _is_there(s: Floats, place: Floats | float, length: Floats) -> bool:
    return bool(np.all(np.abs(s - place) <= ROUNDING * length))


def _straight_to(at: Floats, s: Floats, psi: Floats) -> Floats:
    """Return where a rigid stretch ends that goes on to s in the direction ψ."""
    step = s - at[:, 0]
    return np.stack([s, at[:, 1] + step * np.cos(psi), at[:, 2] + step * np.sin(psi)], axis=-1)


def _piece(state: Equilibrium, part: Part, blade: int, segment: Segment, u: Floats) -> Floats:
    """Return s, x, y from the piece's start, stress, h and ψ at u (designs, 6, points)."""
    assert segment.piece is not None  # a flexible one
    to = integration_to(_NODES, u)
    rates = _rates(state, part, blade, segment, gauss_nodes(_NODES)[0][None])
    x, y = (applied(to, rate) for rate in rates)
    section = section_forces(state, part, blade, segment, u)
    bends, pulls = (pick(column(k), part.rows)[:, None] for k in state.layout.blades[blade].peak)
    bending = bends * 6.0 * section.M / (section.b * section.h**2)
    stress = np.abs(bending) + np.abs(pulls * section.N / (section.b * section.h))
    return np.stack([section.s, x, y, stress, section.h, section.psi], axis=1)


def _rates(
    state: Equilibrium, part: Part, blade: int, segment: Segment, u: Floats
) -> tuple[Floats, Floats]:
    """Return dx/du and dy/du of the bent axis [m]."""
    section, layout = section_forces(state, part, blade, segment, u), state.layout
    area = section.b * section.h * pick(column(layout.blades[blade].stiffer), part.rows)[:, None]
    epsilon = gamma = np.zeros(u.shape)
    if state.effects.extension:
        epsilon = section.N / (pick(column(layout.E), part.rows)[:, None] * area)
    if state.effects.shear and layout.G is not None:
        gamma = section.Q / (SHEAR_FACTOR * pick(column(layout.G), part.rows)[:, None] * area)
    assert segment.piece is not None  # a flexible one
    slope = along_piece(segment.piece.slope, state, part, u)
    cos, sin = np.cos(section.psi), np.sin(section.psi)
    return (
        slope * ((1.0 + epsilon) * cos - gamma * sin),
        slope * ((1.0 + epsilon) * sin + gamma * cos),
    )
