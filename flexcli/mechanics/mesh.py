"""The blades of a layout at their Gauss nodes: compliances and integration matrices.

Everything of a blade is scaled: lengths by its length l, forces by EI/l², moments by EI/l, with
EI the mean flexural rigidity l/∫ds/EI(s), so that no number depends on units or on h/l.
"""

from collections.abc import Sequence
from itertools import pairwise
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Piece
from flexcli.mechanics.layout import Blade, Layout
from flexcli.numerics.collocation import gauss_nodes, integration_matrix

__all__ = ["SHEAR_FACTOR", "Effects", "Mesh", "Segment", "column", "meshes", "pick"]

Floats = NDArray[np.float64]

SHEAR_FACTOR = 5.0 / 6.0
"""κ of a rectangular section, as in the closed forms (Przemieniecki 1968, section 5.6)."""

_FINE = 24
"""Gauss nodes a piece in the mean rigidity, which is a unit only."""

_GAP = 1e-12
"""Share of the length between two flexible pieces above which a rigid piece lies there."""


class Effects(NamedTuple):
    """What deforms a blade besides bending: axial extension, shear."""

    extension: bool = True
    shear: bool = True


class Segment(NamedTuple):
    """A stretch of a blade: its flexible piece (None: rigid), first node, number of nodes."""

    piece: Piece | None
    first: int
    nodes: int


class Mesh(NamedTuple):
    """Blades with the same pieces, at K nodes each; arrays (designs or 1, blades or 1, ...).

    ``w`` are the weights ds, ``c`` the flexural compliance, ``axial`` and ``shear`` the other
    two, ``rho`` their difference, ``h`` the thickness [m] (0: rigid). ``J`` integrates from the
    start to the nodes and ``back`` from the nodes to the end; ``turn = J c`` and ``A = J c back``
    give the rotation made by the end moment and by the transverse force, ``end_turn`` and
    ``far_turn`` the same at the end of the blade.
    """

    blades: tuple[int, ...]
    segments: tuple[tuple[Segment, ...], ...]
    l: Floats
    EI: Floats
    b: Floats
    h: Floats
    w: Floats
    c: Floats
    axial: Floats
    shear: Floats
    rho: Floats
    J: Floats
    back: Floats
    turn: Floats
    A: Floats
    end_turn: Floats
    far_turn: Floats

    @property
    def nodes(self) -> int:
        """Return the number of nodes of each blade."""
        return int(self.w.shape[-1])


def column(value: Any) -> Floats:
    """Return a float or (designs,) array as (1,) or (designs,)."""
    return np.atleast_1d(np.asarray(value, dtype=np.float64))


def pick(values: Floats, rows: NDArray[np.intp]) -> Floats:
    """Return the designs ``rows`` of an array whose first axis is designs, or 1 for all alike."""
    return values if values.shape[0] == 1 else values[rows]


def meshes(layout: Layout, effects: Effects, nodes: int) -> tuple[Mesh, ...]:
    """Return the blades at ``nodes`` Gauss nodes a piece, those with equal pieces together."""
    rows = [_one(i, blade, layout, effects, nodes) for i, blade in enumerate(layout.blades)]
    kinds: dict[tuple[int, ...], list[Mesh]] = {}
    for row in rows:
        kinds.setdefault(tuple(s.nodes for s in row.segments[0]), []).append(row)
    return tuple(_joined(alike) for alike in kinds.values())


def _one(index: int, blade: Blade, layout: Layout, effects: Effects, nodes: int) -> Mesh:
    dx, dy = (column(e - s) for s, e in zip(blade.start, blade.end, strict=True))
    l = np.hypot(dx, dy)
    segments = _segments(blade.profile.pieces(l[:, None]), l, nodes)
    total = segments[-1].first + segments[-1].nodes
    u, _ = gauss_nodes(nodes)
    h, slope = [], []
    J_u, w_u = np.zeros((total, total)), np.zeros(total)
    at_end = np.array([-1.0, 1.0])
    end = np.zeros((1, 1))
    for segment in segments:
        here = slice(segment.first, segment.first + segment.nodes)
        w_u[here] = gauss_nodes(segment.nodes)[1]
        J_u[here, here] = integration_matrix(segment.nodes)
        J_u[here.stop :, here] = w_u[here]
        if segment.piece is None:
            following = [s.piece for s in segments if s.first >= here.stop and s.piece is not None]
            start = following[0].position(at_end)[..., :1] if following else l[:, None]
            h.append(np.zeros_like(end))
            slope.append((start - end) / 2.0)
            end = start
        else:
            h.append(np.atleast_2d(segment.piece.thickness(u)))
            slope.append(np.atleast_2d(segment.piece.slope(u)))
            end = np.atleast_2d(segment.piece.position(at_end))[:, 1:]
    designs = max(np.broadcast_shapes(l.shape, *[a.shape[:1] for a in (*h, *slope)]))
    thickness = _side_by_side(h, designs)
    ds = _side_by_side(slope, designs) / l[:, None]
    rigid = thickness == 0.0
    thinnest, flexible = _rigidity([s.piece for s in segments if s.piece is not None], l)
    per_h = np.where(rigid, 0.0, thinnest / np.where(rigid, 1.0, thickness))
    w = w_u * ds
    c = per_h**3 / flexible
    if effects.shear and layout.G is None:
        raise SolveError(
            "no-shear-modulus",
            "the layout has no shear modulus",
            "give the material a poisson_ratio, or leave shear out",
        )
    b, E = column(blade.b), column(layout.E)
    G = column(np.inf if layout.G is None else layout.G)
    EI = (E * b)[:, None] * thinnest**3 / 12.0 / flexible
    # EI/(EA l²) and EI/(κGA l²)
    axial = thinnest**2 / (12.0 * flexible * l[:, None] ** 2) * per_h
    shear = axial * (E / (SHEAR_FACTOR * G))[:, None]
    axial, shear = axial * effects.extension, shear * effects.shear
    J = J_u * ds[:, None, :]
    back = w[:, None, :] - J
    J_c = J * c[:, None, :]
    arrays = {
        "l": l,
        "EI": EI[:, 0],
        "b": b,
        "h": thickness,
        "w": w,
        "c": c,
        "axial": axial,
        "shear": shear,
        "rho": axial - shear,
        "J": J,
        "back": back,
        "turn": J_c.sum(axis=-1),
        "A": J_c @ back,
        "end_turn": np.sum(w * c, axis=-1),
        "far_turn": ((w * c)[:, None, :] @ back)[:, 0],
    }
    return Mesh((index,), (segments,), **{name: a[:, None] for name, a in arrays.items()})


def _segments(pieces: Sequence[Piece], l: Floats, nodes: int) -> tuple[Segment, ...]:
    """Return the pieces in order with a rigid segment of one node in every gap."""
    ends = [np.atleast_2d(p.position(np.array([-1.0, 1.0]))) for p in pieces]
    stops = [np.zeros((1, 2)), *ends, np.repeat(l[:, None], 2, axis=1)]
    found: list[Segment] = []
    first = 0
    for piece, (before, after) in zip([*pieces, None], pairwise(stops), strict=True):
        if np.any(after[:, 0] - before[:, 1] > _GAP * l):
            found.append(Segment(None, first, 1))
            first += 1
        if piece is not None:
            found.append(Segment(piece, first, nodes))
            first += nodes
    return tuple(found)


def _rigidity(pieces: Sequence[Piece], l: Floats) -> tuple[Floats, Floats]:
    """Return the least thickness h_0 and ``∫ (h_0/h)³ ds/l``, (designs, 1), at any number of nodes.

    Always by the same rule: the units of an assembly must not change when it is refined.
    """
    u, weight = gauss_nodes(_FINE)
    h = [np.atleast_2d(piece.thickness(u)) for piece in pieces]
    thinnest = np.min(np.stack([np.min(a, axis=1) for a in np.broadcast_arrays(*h)]), axis=0)
    flexible = sum(
        (np.atleast_2d(piece.slope(u)) / l[:, None] * (thinnest[:, None] / a) ** 3) @ weight
        for piece, a in zip(pieces, h, strict=True)
    )
    return thinnest[:, None], np.asarray(flexible)[:, None]


def _side_by_side(parts: Sequence[Floats], designs: int) -> Floats:
    return np.concatenate([np.broadcast_to(p, (designs, p.shape[1])) for p in parts], axis=1)


_OF_NODES = Mesh._fields[Mesh._fields.index("w") :]


def _joined(alike: Sequence[Mesh]) -> Mesh:
    """Return one mesh of all blades with equal segments; an axis on which all agree gets 1."""

    def together(name: str) -> Floats:
        parts = [getattr(mesh, name) for mesh in alike]
        designs = max(p.shape[0] for p in parts)
        joined = np.concatenate(
            [np.broadcast_to(p, (designs, *p.shape[1:])) for p in parts], axis=1
        )
        for axis in (0, 1) if name in _OF_NODES else (0,):
            first = joined[:1] if axis == 0 else joined[:, :1]
            if joined.shape[axis] > 1 and np.array_equal(
                joined, np.broadcast_to(first, joined.shape)
            ):
                joined = first
        return np.ascontiguousarray(joined)

    blades = tuple(mesh.blades[0] for mesh in alike)
    segments = tuple(mesh.segments[0] for mesh in alike)
    return Mesh(blades, segments, **{name: together(name) for name in Mesh._fields[2:]})
