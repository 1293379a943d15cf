"""The blades of a layout at their Gauss nodes: compliances and integration matrices.

Everything of a blade is scaled: lengths by its length l, forces by EI/l², moments by EI/l, with
EI the mean flexural rigidity l/∫ds/EI(s), so that no number depends on units or on h/l.
"""

import functools
from collections.abc import Sequence
from typing import Any, NamedTuple, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Piece
from flexcli.mechanics.layout import Layout, Point
from flexcli.numerics.collocation import gauss_nodes, integration_matrix

__all__ = [
    "SHEAR_FACTOR",
    "Effects",
    "Mesh",
    "Segment",
    "across",
    "chosen",
    "column",
    "drawn",
    "meshes",
    "pick",
    "refined",
    "table",
]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Kind = TypeVar("Kind", np.float64, np.complex128)

SHEAR_FACTOR = 5.0 / 6.0
"""κ of a rectangular section, as in the closed forms (Przemieniecki 1968, section 5.6)."""

_FINE = 24
"""Gauss nodes a piece in the mean rigidity, which is a unit only."""

_ANY = np.zeros(1)
"""A place of a piece that is the same everywhere."""

_ENDS = np.array([-1.0, 1.0])
"""Both ends of a piece."""

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
    """Blades with the same pieces, at K nodes each; arrays (designs or 1, blades or 1, K or 1, …).

    ``l``, ``b`` and the least thickness ``thinnest`` in [m], ``EI`` in [N·m²] and ``flexible``,
    the mean of (thinnest/h)³, do not depend on the nodes. ``w`` are the weights ds, ``c`` the
    flexural compliance, ``axial`` and ``shear`` the other two, ``rho`` their difference. ``back``
    integrates from the nodes to the end; ``turn = J c`` and ``A = J c back``, with J that
    integrates from the start to the nodes, give the rotation made by the end moment and by the
    transverse force, ``end_turn`` and ``far_turn`` the same at the end of the blade.
    """

    blades: tuple[int, ...]
    segments: tuple[tuple[Segment, ...], ...]
    l: Floats
    EI: Floats
    b: Floats
    thinnest: Floats
    flexible: Floats
    w: Floats
    c: Floats
    axial: Floats
    shear: Floats
    rho: Floats
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
    return np.array(value, dtype=np.float64, ndmin=1)


def single(value: Any) -> float:
    """Return the number of a batch of one design."""
    return float(column(value)[0])


def pick(values: NDArray[Kind], rows: NDArray[np.intp]) -> NDArray[Kind]:
    """Return the designs ``rows`` of an array whose first axis is designs, or 1 for all alike."""
    return values if values.shape[0] == 1 else values[rows]


def across(values: NDArray[Kind]) -> NDArray[Kind]:
    """Return an array with its first axis, the designs, the last: loops run over designs."""
    if values.shape[0] == 1:
        return values.reshape(*values.shape[1:], 1)
    return np.ascontiguousarray(values.transpose(*range(1, values.ndim), 0))


def chosen(values: NDArray[Kind], rows: NDArray[np.intp]) -> NDArray[Kind]:
    """Return the designs ``rows`` of an array whose last axis is designs, or 1 for all alike."""
    return values if values.shape[-1] == 1 else values.take(rows, axis=-1)


def table(numbers: Sequence[Any]) -> Floats:
    """Return numbers, each a float or (designs,), side by side: (designs or 1, numbers)."""
    if all(isinstance(number, float) for number in numbers):
        return np.array([numbers], dtype=np.float64)
    columns = [column(number) for number in numbers]
    if len({each.size for each in columns}) > 1:
        columns = list(np.broadcast_arrays(*columns))
    return np.ascontiguousarray(np.array(columns).T)


def drawn(points: Sequence[Point]) -> Complexes:
    """Return points as x + iy, side by side: (designs or 1, points)."""
    if all(isinstance(x, float) and isinstance(y, float) for x, y in points):
        return np.array([[complex(x, y) for x, y in points]])
    return np.asarray(table([x for x, _ in points]) + 1j * table([y for _, y in points]))


def _lengths(layout: Layout) -> Floats:
    """Return the lengths of the blades (designs or 1, blades) [m]."""
    apart = drawn([blade.end for blade in layout.blades])
    apart = apart - drawn([blade.start for blade in layout.blades])
    return np.asarray(np.hypot(apart.real, apart.imag))


def meshes(layout: Layout, effects: Effects, nodes: int) -> tuple[Mesh, ...]:
    """Return the blades at ``nodes`` Gauss nodes a piece, those with equal pieces together."""
    kinds: dict[tuple[int, ...], list[int]] = {}
    l, pieces, rigidities = _lengths(layout), [], []
    for i, blade in enumerate(layout.blades):
        along = l[:, i]
        pieces.append(_segments(blade.profile.pieces(along[:, None]), along, nodes))
        rigidities.append(_rigidity(pieces[i], along))
        kinds.setdefault(tuple(s.nodes for s in pieces[i]), []).append(i)
    thinnest, flexible = (table([each[k] for each in rigidities]) for k in (0, 1))
    b = table([blade.b for blade in layout.blades])
    stiffer = table([blade.stiffer for blade in layout.blades])
    EI = column(layout.E)[:, None] * stiffer * b * thinnest**3 / 12.0 / flexible
    units = np.broadcast_arrays(l, EI, b, thinnest, flexible)
    return tuple(
        _at_nodes(
            tuple(alike),
            tuple(pieces[i] for i in alike),
            [_collapsed(each[:, alike], (0,)) for each in units],
            layout,
            effects,
        )
        for alike in kinds.values()
    )


def refined(mesh: Mesh, layout: Layout, effects: Effects, nodes: int) -> Mesh:
    """Return the same blades at another number of Gauss nodes a piece."""
    segments = []
    for pieces in mesh.segments:
        first, found = 0, []
        for piece, _, _ in pieces:
            count = 1 if piece is None else nodes
            found.append(Segment(piece, first, count))
            first += count
        segments.append(tuple(found))
    units = (mesh.l, mesh.EI, mesh.b, mesh.thinnest, mesh.flexible)
    return _at_nodes(mesh.blades, tuple(segments), units, layout, effects)


class _Integrals(NamedTuple):
    """What of a mesh hangs on ds/du and the flexural compliance alone; names as there."""

    w: Floats
    c: Floats
    back: Floats
    turn: Floats
    A: Floats
    end_turn: Floats
    far_turn: Floats


def _integrals(pattern: tuple[tuple[int, bool], ...], ds: Floats, c: Floats) -> _Integrals:
    J_u, w_u = _reference(pattern)
    w = w_u * ds
    J = J_u * ds[..., None, :]
    back = w[..., None, :] - J
    J_c = J * c[..., None, :]
    return _Integrals(
        w=w,
        c=c,
        back=back,
        turn=J_c.sum(axis=-1),
        A=np.moveaxis(across(J_c @ back), -1, 0),
        end_turn=np.sum(w * c, axis=-1),
        far_turn=((w * c)[..., None, :] @ back)[..., 0, :],
    )


@functools.cache
def _integrals_of_uniform(nodes: int) -> _Integrals:
    """Return those of blades of one thickness: shared, do not write."""
    one = np.ones((1, 1, 1))
    return _integrals(((nodes, False),), 0.5 * one, one)


def _at_nodes(
    blades: tuple[int, ...],
    segments: tuple[tuple[Segment, ...], ...],
    units: Sequence[Floats],
    layout: Layout,
    effects: Effects,
) -> Mesh:
    l, EI, b, thinnest, flexible = units
    # EI/(EA l²) and EI/(κGA l²)
    axial = (thinnest**2 / (12.0 * flexible * l**2))[..., None]
    if all(_is_uniform(pieces) for pieces in segments):
        found = _integrals_of_uniform(segments[0][0].nodes)
    else:
        each = [
            _thickness(pieces, l[:, min(i, l.shape[1] - 1)]) for i, pieces in enumerate(segments)
        ]
        h, slope = (_agreed([pair[i] for pair in each], (0, 1)) for i in (0, 1))
        rigid = h == 0.0
        per_h = np.where(rigid, 0.0, thinnest[..., None] / np.where(rigid, 1.0, h))
        ds = _collapsed(slope / l[..., None])
        c = _collapsed(per_h**3 / flexible[..., None])
        axial = axial * per_h
        pattern = tuple((s.nodes, s.piece is None) for s in segments[0])
        found = _integrals(pattern, ds, c)
    shear = _collapsed(axial * _shear_softness(layout, effects))
    axial = _collapsed(axial * effects.extension)
    return Mesh(
        blades=blades,
        segments=segments,
        l=l,
        EI=EI,
        b=b,
        thinnest=thinnest,
        flexible=flexible,
        axial=axial,
        shear=shear,
        rho=_collapsed(axial - shear),
        **found._asdict(),
    )


def _is_uniform(segments: tuple[Segment, ...]) -> bool:
    """Return whether a blade is known to have the same thickness all along."""
    piece = segments[0].piece
    return len(segments) == 1 and piece is not None and piece.is_uniform


def _shear_softness(layout: Layout, effects: Effects) -> Floats:
    """Return E/(κG), zero when blades do not shear (designs or 1, 1, 1)."""
    if not effects.shear:
        return np.zeros((1, 1, 1))
    if layout.G is None:
        raise SolveError(
            "no-shear-modulus",
            "the layout has no shear modulus",
            "give the material a poisson_ratio, or leave shear out",
        )
    return np.asarray(column(layout.E) / (SHEAR_FACTOR * column(layout.G)))[:, None, None]


@functools.cache
def _reference(pattern: tuple[tuple[int, bool], ...]) -> tuple[Floats, Floats]:
    """Return the matrix that integrates over u from the start, and the weights of the nodes."""
    total = sum(count for count, _ in pattern)
    J, w, first = np.zeros((total, total)), np.zeros(total), 0
    for count, _ in pattern:
        here = slice(first, first + count)
        w[here] = gauss_nodes(count)[1]
        J[here, here] = integration_matrix(count)
        J[here.stop :, here] = w[here]
        first = here.stop
    return J, w


def _thickness(segments: tuple[Segment, ...], l: Floats) -> tuple[Floats, Floats]:
    """Return thickness [m] (0: rigid) and ds/du [m] at the nodes of a blade, (designs or 1, K).

    One number stands for all nodes of a blade that is the same all along.
    """
    end = np.zeros((1, 1))
    h, slope = [], []
    for i, segment in enumerate(segments):
        if segment.piece is None:
            following = [s.piece for s in segments[i:] if s.piece is not None]
            start = following[0].position(_ENDS)[..., :1] if following else l[:, None]
            h.append(np.zeros_like(end))
            slope.append((start - end) / 2.0)
            end = start
        else:
            is_alike = segment.piece.is_uniform and len(segments) == 1
            u = _ANY if is_alike else gauss_nodes(segment.nodes)[0]
            h.append(np.atleast_2d(segment.piece.thickness(u)))
            slope.append(np.atleast_2d(segment.piece.slope(u)))
            if segment is not segments[-1]:
                end = np.atleast_2d(segment.piece.position(_ENDS))[:, 1:]
    designs = max(a.shape[0] for a in (*h, *slope))
    return _side_by_side(h, designs), _side_by_side(slope, designs)


def _segments(pieces: Sequence[Piece], l: Floats, nodes: int) -> tuple[Segment, ...]:
    """Return the pieces in order with a rigid segment of one node in every gap."""
    found: list[Segment] = []
    first, before = 0, np.zeros(1)
    for piece in (*pieces, None):
        ends = l[:, None] if piece is None else np.atleast_2d(piece.position(_ENDS))
        if (ends[:, 0] - before > _GAP * l).any():
            found.append(Segment(None, first, 1))
            first += 1
        if piece is not None:
            found.append(Segment(piece, first, nodes))
            first += nodes
        before = ends[:, -1]
    return tuple(found)


def _rigidity(segments: tuple[Segment, ...], l: Floats) -> tuple[Floats, Floats]:
    """Return the least thickness h_0 and ``∫ (h_0/h)³ ds/l``, (designs,), at any number of nodes.

    Always by the same rule: the units of an assembly must not change when it is refined.
    """
    pieces = [segment.piece for segment in segments if segment.piece is not None]
    if _is_uniform(segments):
        return np.atleast_2d(pieces[0].thickness(_ANY))[:, 0], np.ones(1)
    rules = [(_ANY, np.array([2.0])) if p.is_uniform else gauss_nodes(_FINE) for p in pieces]
    h = [np.atleast_2d(piece.thickness(u)) for piece, (u, _) in zip(pieces, rules, strict=True)]
    thinnest = functools.reduce(np.minimum, [np.min(a, axis=1) for a in h])
    flexible = sum(
        (np.atleast_2d(piece.slope(u)) / l[:, None] * (thinnest[:, None] / a) ** 3) @ weight
        for piece, a, (u, weight) in zip(pieces, h, rules, strict=True)
    )
    return thinnest, np.asarray(flexible)


def _side_by_side(parts: Sequence[Floats], designs: int) -> Floats:
    if designs > 1:
        parts = [np.broadcast_to(p, (designs, p.shape[1])) for p in parts]
    return np.concatenate(parts, axis=1)


def _agreed(alike: Sequence[Floats], axes: tuple[int, ...]) -> Floats:
    """Return one array of all blades, the second axis, from those of each."""
    return _collapsed(np.stack(np.broadcast_arrays(*alike), axis=1), axes)


def _collapsed(values: Floats, axes: tuple[int, ...] = (0, 1)) -> Floats:
    """Return an array in which an axis on which all agree has length 1."""
    for axis in axes:
        if values.shape[axis] > 1:
            first = values[:1] if axis == 0 else values[:, :1]
            if (values == first).all():
                values = first
    return np.ascontiguousarray(values)
