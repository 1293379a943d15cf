"""Blades and rods at their Gauss nodes: compliances, and the matrices that integrate along them."""

import functools
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Piece
from flexcli.mechanics.space.exact.rotation import conjugate, moved, product
from flexcli.mechanics.space.exact.section import Compliances, Section
from flexcli.numerics.collocation import gauss_nodes, integration_matrix

__all__ = ["Mesh", "mesh_of"]

Floats = NDArray[np.float64]

_DECAY = 0.04
"""Length in which warping decays, over a piece, below which its ends get pieces of their own."""

_LAYER = 8.0
"""Length of such an end over the decay."""

_GAP = 1e-9
"""Share of the length between two flexible stretches above which it is rigid there."""

_ENDS = np.array([-1.0, 1.0])

_REMEMBERED = 16
"""Meshes that are kept: those of a layout at all levels, for its states share them."""


class Mesh(NamedTuple):
    """All blades at the nodes of equally many segments; arrays (blades, K), matrices (…, K, K).

    ``w`` are the weights ds, ``J`` integrates from the start to the nodes, ``back`` from the nodes
    to the end. ``C`` (blades, K, 3) are the compliances of stretch and shear, ``spin`` and
    ``bend_y`` those about x and y, zero where rigid (``flexible`` 0); ``clamped`` and ``curl`` are
    what :func:`flexcli.mechanics.space.exact.section_law.curled` takes. The twist rate τ obeys
    ``hold τ + twist (T − M_x) = 0`` at the nodes, with T the torque without that of warping.
    ``grown`` (blades, 1) is the free strain along them that a temperature gives.
    """

    sections: tuple[Section, ...]
    per_segment: int
    s: Floats
    w: Floats
    J: Floats
    back: Floats
    C: Floats
    flexible: Floats
    spin: Floats
    bend_y: Floats
    clamped: Floats
    curl: Floats
    nu: Floats
    hold: Floats
    twist: Floats
    torsion: Floats
    polar: Floats
    fibres: Floats
    warping: Floats
    apart: Floats
    runs: tuple[tuple[slice, ...], ...]
    half: Floats
    h: Floats
    grown: Floats

    def kinematics(self, q: Floats, kappa: Floats) -> tuple[Floats, Floats]:
        """Return ``R (κ − κ(q)) ds/du`` at the nodes (blades, K, 3), and the ends' quaternions.

        κ(q) is the curvature of the quaternions at the nodes as polynomials on each segment.
        """
        count = self.per_segment
        D, weight = _derivative(count), gauss_nodes(count)[1]
        start = np.broadcast_to([1.0, 0.0, 0.0, 0.0], (self.blades, 4))
        rates = []
        for k in range(self.nodes // count):
            rates.append(D @ (q[:, k * count : (k + 1) * count] - start[:, None]))
            start = start + weight @ rates[k]
        turned = product(np.concatenate(rates, axis=1), conjugate(q))[..., 1:]
        wanted = kappa + moved(q, kappa)
        return wanted * self.half[..., None] - 2.0 * turned, start

    @property
    def along(self) -> Floats:
        """Return the matrix that integrates from the start over u, in which segments have 2."""
        return _reference(self.per_segment, self.nodes // self.per_segment)

    @property
    def across(self) -> Floats:
        """Return the weights over u."""
        return np.tile(gauss_nodes(self.per_segment)[1], self.nodes // self.per_segment)

    @property
    def nodes(self) -> int:
        """Return the number of nodes of each blade."""
        return int(self.w.shape[-1])

    @property
    def blades(self) -> int:
        """Return the number of blades."""
        return len(self.sections)


class _Segment(NamedTuple):
    """The part of a piece between two places u of it, in a flexible stretch from p to q.

    Without a piece it is rigid, from p to q.
    """

    p: float
    q: float
    stretch: int | None = None
    piece: Piece | None = None
    u: tuple[float, float] = (-1.0, 1.0)


@functools.lru_cache(maxsize=_REMEMBERED)
def mesh_of(sections: tuple[Section, ...], count: int) -> Mesh:
    """Return blades at ``count`` Gauss nodes on each of their segments; shared, not writable."""
    found = [_segments(section) for section in sections]
    most = max(map(len, found))
    # blades with fewer segments end with some of no length, so that all have as many nodes
    filled = [row + [_Segment(1.0, 1.0)] * (most - len(row)) for row in found]
    at = [_places(section, row, count) for section, row in zip(sections, filled, strict=True)]
    s, half, h = np.array(at).swapaxes(0, 1)
    J = _reference(count, most) * half[:, None, :]
    w = np.tile(gauss_nodes(count)[1], most) * half
    flexible = h > 0.0
    known = np.array([_constants(section, row) for section, row in zip(sections, h, strict=True)])
    felt = Compliances(*np.moveaxis(known, 1, 0))
    p, q = (
        np.repeat([[getattr(seg, e) for seg in row] for row in filled], count, axis=1) for e in "pq"
    )
    t = (s - p) / np.where(q > p, q - p, 1.0)
    bend_z = felt.bend_z + felt.bend_z_edge * 12.0 * (t - 0.5) ** 2
    runs = tuple(_runs(row, count) for row in filled)
    hold, twist = _twist(felt, J, w, runs)
    mesh = Mesh(
        sections=sections,
        per_segment=count,
        s=s,
        w=w,
        J=J,
        back=w[:, None, :] - J,
        C=np.stack([felt.axial, felt.shear_y, felt.shear_z], axis=-1),
        flexible=flexible.astype(np.float64),
        spin=felt.spin,
        bend_y=felt.bend_y,
        clamped=np.where(flexible, 1.0 / np.where(flexible, bend_z, 1.0) - 1.0, 0.0),
        curl=felt.curl,
        nu=np.array([[section.nu] for section in sections]),
        hold=hold,
        twist=twist,
        torsion=felt.torsion,
        polar=felt.polar,
        fibres=felt.fibres,
        warping=felt.warping,
        apart=felt.apart,
        runs=runs,
        half=half,
        h=h,
        grown=np.zeros((len(sections), 1)),
    )
    for each in mesh:
        if isinstance(each, np.ndarray):
            each.setflags(write=False)
    return mesh


def _places(section: Section, segments: list[_Segment], count: int) -> Floats:
    """Return places, ds/du over the length and thickness [m] of the nodes; none where rigid."""
    v = gauss_nodes(count)[0]
    found = []
    for p, q, _, piece, (low, high) in segments:
        if piece is None:
            found.append([(p + q) / 2.0 + (q - p) / 2.0 * v, 0.0 * v + (q - p) / 2.0, 0.0 * v])
            continue
        u = (low + high) / 2.0 + (high - low) / 2.0 * v
        slope = piece.slope(u) * (high - low) / 2.0 / section.l
        found.append([piece.position(u) / section.l, slope, piece.thickness(u)])
    return np.concatenate(found, axis=1)


def _constants(section: Section, h: Floats) -> Floats:
    """Return the compliances at nodes by their thickness, all zero where they are rigid."""
    found = np.zeros((len(Compliances._fields), h.size))
    flexible = h > 0.0
    each, which = np.unique(h[flexible], return_inverse=True)
    found[:, flexible] = np.stack(section.at(each))[:, which]
    return found


def _segments(section: Section) -> list[_Segment]:
    """Return the segments of a blade: flexible pieces, their ends apart where warping decays."""
    found: list[_Segment] = []
    end = 0.0
    for i, pieces in enumerate(section.stretches):
        p, q = (
            float(piece.position(np.array([u]))[0]) / section.l
            for piece, u in ((pieces[0], -1.0), (pieces[-1], 1.0))
        )
        if p > end + _GAP:
            found.append(_Segment(end, p))
        for piece in pieces:
            cuts = [-1.0, 1.0]
            layer = _layer(section, piece)
            if layer:
                cuts = [-1.0, layer - 1.0, 1.0 - layer, 1.0]
            found += [_Segment(p, q, i, piece, pair) for pair in pairwise(cuts)]
        end = q
    if end < 1.0 - _GAP:
        found.append(_Segment(end, 1.0))
    return found


def _layer(section: Section, piece: Piece) -> float:
    """Return the part of a piece of constant thickness, of 2, in which warping decays, if short."""
    first, last = piece.thickness(_ENDS)
    if first != last:
        return 0.0
    at = section.at(np.array([first]))
    decay = float(np.sqrt(at.warping / at.torsion)[0] / at.apart[0])
    long = float(np.ptp(piece.position(_ENDS))) / section.l
    return 2.0 * _LAYER * decay / long if 0.0 < decay < _DECAY * long else 0.0


def _runs(segments: list[_Segment], count: int) -> tuple[slice, ...]:
    """Return the nodes of each flexible stretch."""
    each = [g.stretch for g in segments]
    return tuple(
        slice(each.index(i) * count, (each.index(i) + each.count(i)) * count)
        for i in dict.fromkeys(k for k in each if k is not None)
    )


@functools.cache
def _reference(count: int, segments: int) -> Floats:
    """Return the matrix that integrates over segments of length 2 from the start; do not write."""
    weight = gauss_nodes(count)[1]
    within = np.kron(np.eye(segments), integration_matrix(count))
    before = np.kron(np.tri(segments, k=-1), np.ones((count, 1)) * weight)
    return np.asarray(within + before)


@functools.cache
def _derivative(count: int) -> Floats:
    """Return the matrix from values less that at −1 to derivatives; shared, do not write."""
    return np.asarray(np.linalg.inv(integration_matrix(count)))


def _twist(
    felt: Compliances, J: Floats, w: Floats, runs: tuple[tuple[slice, ...], ...]
) -> tuple[Floats, Floats]:
    """Return ``hold`` and ``twist`` of the mesh.

    With restrained warping ``(EΓ (τ/a)')' = a (T − M_x)`` and τ = 0 at the ends of a stretch:
    ``τ + a G a (T − M_x) = 0``, G Green's function of −(EΓ d/ds)'.
    """
    hold, twist = np.ones(w.shape), np.zeros(J.shape)
    for i, own in enumerate(runs):
        for run in own:
            w_run, stiff, soft = w[i, run], felt.warping[i, run], felt.torsion[i, run]
            if stiff[0] == 0.0:
                hold[i, run] = 0.0
                twist[i, run, run] = np.diag(1.0 / soft)
                continue
            a, J_run, long = felt.apart[i, run], J[i, run, run], np.sum(w_run)
            mean, warped = long / (w_run @ (1.0 / soft)), long / (w_run @ (a**2 / stiff))
            size = 1.0 + mean / warped * long**2 / 10.0
            hold[i, run] = 1.0 / size
            J_soft, w_soft = J_run / stiff, w_run / stiff
            straight = np.sum(J_soft, axis=1) / np.sum(w_soft)
            green = straight[:, None] * (w_soft @ J_run) - J_soft @ J_run
            twist[i, run, run] = a[:, None] * green * a / size
    return hold, twist
