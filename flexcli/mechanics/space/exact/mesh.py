"""Blades and rods at their Gauss nodes: compliances, and the matrices that integrate along them."""

import functools
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.rotation import conjugate, moved, product
from flexcli.mechanics.space.exact.section import Section
from flexcli.numerics.collocation import gauss_nodes, integration_matrix

__all__ = ["Mesh", "mesh_of"]

Floats = NDArray[np.float64]

_DECAY = 0.04
"""Length in which warping decays, over a piece, below which its ends get pieces of their own."""

_LAYER = 8.0
"""Length of such an end over the decay."""


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
    runs: tuple[tuple[slice, ...], ...]
    half: Floats
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
    """A segment from a to b of a blade, in the flexible piece ``piece`` from p to q, or rigid."""

    a: float
    b: float
    piece: int | None
    p: float = 0.0
    q: float = 1.0


def mesh_of(sections: tuple[Section, ...], count: int) -> Mesh:
    """Return blades at ``count`` Gauss nodes on each of their segments."""
    found = [_segments(section) for section in sections]
    most = max(map(len, found))
    # blades with fewer segments end with some of no length, so that all have as many nodes
    filled = [row + [_Segment(1.0, 1.0, None)] * (most - len(row)) for row in found]
    u, weight = gauss_nodes(count)
    a, b = (np.array([[getattr(seg, e) for seg in row] for row in filled]) for e in "ab")
    half = np.repeat((b - a) / 2.0, count, axis=1)
    s = np.repeat((a + b) / 2.0, count, axis=1) + half * np.tile(u, most)
    J = _reference(count, most) * half[:, None, :]
    w = np.tile(weight, most) * half
    flexible = np.repeat([[g.piece is not None for g in row] for row in filled], count, axis=1)
    p, q = (
        np.repeat([[getattr(seg, e) for seg in row] for row in filled], count, axis=1) for e in "pq"
    )
    t = (s - p) / (q - p)
    numbers = {
        name: np.array([[getattr(section, name)] for section in sections]) for name in _NUMBERS
    }
    bend_z = numbers["bend_z"] + numbers["bend_z_edge"] * 12.0 * (t - 0.5) ** 2
    C = np.stack([numbers["axial"], numbers["shear_y"], numbers["shear_z"]], axis=-1)
    runs = tuple(_runs(row, count) for row in filled)
    hold, twist = _twist(numbers["warping"][:, 0], numbers["torsion"][:, 0], J, w, runs)
    return Mesh(
        sections=sections,
        per_segment=count,
        s=s,
        w=w,
        J=J,
        back=w[:, None, :] - J,
        C=C * flexible[..., None],
        flexible=flexible.astype(np.float64),
        spin=numbers["spin"] * flexible,
        bend_y=numbers["bend_y"] * flexible,
        clamped=np.where(flexible, 1.0 / bend_z - 1.0, 0.0),
        curl=numbers["curl"],
        nu=numbers["nu"],
        hold=hold,
        twist=twist,
        torsion=numbers["torsion"],
        polar=numbers["polar"],
        fibres=numbers["fibres"],
        warping=numbers["warping"],
        runs=runs,
        half=half,
        grown=np.zeros((len(sections), 1)),
    )


_NUMBERS = (
    "axial",
    "shear_y",
    "shear_z",
    "spin",
    "bend_y",
    "bend_z",
    "bend_z_edge",
    "curl",
    "nu",
    "torsion",
    "warping",
    "polar",
    "fibres",
)


def _segments(section: Section) -> list[_Segment]:
    """Return the segments of a blade: flexible pieces, their ends apart where warping decays."""
    found: list[_Segment] = []
    end = 0.0
    for i, (p, q) in enumerate(section.stretches):
        if p > end:
            found.append(_Segment(end, p, None))
        decay = np.sqrt(section.warping / section.torsion)
        cuts = [p, q]
        if 0.0 < decay < _DECAY * (q - p):
            layer = _LAYER * decay
            cuts = [p, p + layer, q - layer, q]
        found += [_Segment(a, b, i, p, q) for a, b in pairwise(cuts)]
        end = q
    return found


def _runs(segments: list[_Segment], count: int) -> tuple[slice, ...]:
    """Return the nodes of each flexible piece."""
    pieces = [g.piece for g in segments]
    return tuple(
        slice(pieces.index(i) * count, (pieces.index(i) + pieces.count(i)) * count)
        for i in dict.fromkeys(p for p in pieces if p is not None)
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
    warping: Floats, torsion: Floats, J: Floats, w: Floats, runs: tuple[tuple[slice, ...], ...]
) -> tuple[Floats, Floats]:
    """Return ``hold`` and ``twist`` of the mesh.

    With restrained warping ``EΓ τ'' = T − M_x`` and τ = 0 at the ends of a piece:
    ``EΓ τ + G (T − M_x) = 0``, G Green's function of −d²/ds².
    """
    hold, twist = np.ones(w.shape), np.zeros(J.shape)
    for i, (stiff, soft) in enumerate(zip(warping, torsion, strict=True)):
        for run in runs[i]:
            if stiff == 0.0:
                hold[i, run] = 0.0
                twist[i, run, run] = np.diag(np.full(run.stop - run.start, 1.0 / soft))
                continue
            J_run, w_run = J[i, run, run], w[i, run]
            long = np.sum(w_run)
            size = stiff + soft * long**2 / 10.0
            hold[i, run] = stiff / size
            straight = J_run @ np.ones(w_run.size) / long
            twist[i, run, run] = (straight[:, None] * (w_run @ J_run) - J_run @ J_run) / size
    return hold, twist
