"""A joint's beams on roots that give way: between what its stiffness and its stress lie."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Blade, Layout
from flexcli.parts.geometries.base import MOVING, Held

__all__ = ["Rooted", "RootedFrame"]

Floats = NDArray[np.float64]

PLACES = np.linspace(-1.0, 1.0, 9)
"""Places on every piece of a blade where its stress is looked at: what changes of it is smooth."""

SINGULAR = 1e-12
"""Share of the stiffest motion of bodies, each in its own unit, below which one is free."""


class Rooted(NamedTuple):
    """A blade's compliance at its end, and between which those of its roots lie, at E = 1.

    ``beam`` (3, 3) is per force along, across and moment there [1/m]. ``at`` (roots, 3, 3) are
    the moment, the force across and along at each root per these, ``least`` and ``most``
    (roots, 3, 3) the compliances of the root in that order.
    """

    beam: Floats
    at: Floats
    least: Floats
    most: Floats

    def softened(self, roots: Floats) -> Floats:
        """Return the compliance of the blade on roots of these compliances (roots, 3, 3)."""
        return np.asarray(self.beam + np.einsum("rji,rjk,rkl->il", self.at, roots, self.at))


class RootedFrame:
    """Small motions of rigid bodies on blades whose roots give way, one motion prescribed."""

    def __init__(self, layout: Layout, held: Held, blades: Sequence[Rooted]) -> None:
        self.layout, self.blades = layout, tuple(blades)
        count = 3 * len(layout.bodies)
        self.rows = np.stack([_strained(layout, blade, count) for blade in layout.blades])
        first = 3 * layout.index(MOVING)
        given = {first + i: float(motion) for i, motion in enumerate(held) if motion is not None}
        for name, kept in layout.guides.items():
            own = 3 * layout.index(name)
            given |= {own + i: given.get(own + i, 0.0) for i in range(3) if kept[i]}
        self.free = np.array([i for i in range(count) if i not in given], dtype=np.intp)
        self.motion = np.zeros(count)
        self.motion[list(given)] = list(given.values())
        self.supported = _supported(layout, count) / float(layout.E)

    def stiffness(self) -> tuple[float, float] | None:
        """Return the least and the greatest stiffness of the motion over that of rigid roots.

        What stiffens a part stiffens the whole. None where something moves freely.
        """
        each = (
            [blade.beam for blade in self.blades],
            [blade.softened(blade.most) for blade in self.blades],
            [blade.softened(blade.least) for blade in self.blades],
        )
        found = [_Solved(self, compliances) for compliances in each]
        if any(one.is_loose for one in found):
            return None
        rigid, low, high = (one.drive for one in found)
        return (low / rigid, high / rigid) if rigid > 0.0 else None

    def stress(self) -> tuple[float, float] | None:
        """Return the least and the greatest largest stress of the motion over that of rigid roots.

        Roots are anything between their limits, each by itself. With their means M and half their
        range D, by Neumann's series of the forces ``f = (1 + S Δ)⁻¹ f₀``, |Δ| ≤ D: a stress a·f is
        off by the sum over the roots of |√D S a| |√D f₀|, and by their norms times ρ/(1 − ρ),
        ρ the norm of √D S √D. None where something moves freely, or ρ is 1 or more.
        """
        rigid = _Solved(self, [blade.beam for blade in self.blades])
        mean = _Solved(
            self, [blade.softened((blade.least + blade.most) / 2.0) for blade in self.blades]
        )
        if rigid.is_loose or mean.is_loose:
            return None
        per_force = _stress_rows(self.layout)
        half = [_roots_of((blade.most - blade.least) / 2.0) for blade in self.blades]
        # √D at each root per force at the end of its blade (roots, 3, 3), and of all of them
        each = [root @ blade.at for root, blade in zip(half, self.blades, strict=True)]
        count = len(self.blades)
        at = np.zeros((sum(map(len, each)), 3, 3 * count))
        row = 0
        for i, own in enumerate(each):
            at[row : row + len(own), :, 3 * i : 3 * i + 3] = own
            row += len(own)
        flat = at.reshape(-1, 3 * count)
        rho = float(np.linalg.norm(flat @ mean.forces_of_strains @ flat.T, 2)) if len(flat) else 0.0
        if not rho < 1.0:
            return None
        felt = np.linalg.norm(at @ mean.forces, axis=-1)  # (roots,)
        answer = np.linalg.norm(at @ mean.forces_of_strains @ per_force.T, axis=1)  # (roots, n)
        stress = np.abs(per_force @ mean.forces)
        beyond = np.linalg.norm(felt) * np.linalg.norm(answer, axis=0) * rho / (1.0 - rho)
        off = felt @ answer + beyond
        largest = float(np.max(np.abs(per_force @ rigid.forces)))
        if largest == 0.0:
            return None
        return float(np.max(stress - off)) / largest, float(np.max(stress + off)) / largest


class _Solved:
    """The frame in its motion, its blades of given compliances (3, 3) at E = 1."""

    def __init__(self, frame: RootedFrame, compliances: Sequence[Floats]) -> None:
        k, rows, free = np.linalg.inv(np.stack(compliances)), frame.rows, frame.free
        K = np.einsum("bji,bjk,bkl->il", rows, k, rows) + frame.supported
        loose, moved = K[np.ix_(free, free)], frame.motion.copy()
        scale = np.sqrt(np.diag(loose))
        self.is_loose = bool(np.any(scale <= 0.0))
        if self.is_loose:
            return
        even = loose / np.outer(scale, scale)
        values = np.linalg.eigvalsh(even)
        self.is_loose = bool(len(values) and values[0] <= SINGULAR * values[-1])
        if self.is_loose:
            return
        soft = np.linalg.inv(even) / np.outer(scale, scale)
        moved[free] = -soft @ (K @ moved)[free]
        self.drive = float(moved @ K @ moved)
        self.forces = np.einsum("bij,bjk,k->bi", k, rows, moved).ravel()
        count = len(k)
        pulled = np.einsum("bij,bjk->bik", k, rows[:, :, free]).reshape(3 * count, -1)
        alone = np.zeros((3 * count, 3 * count))
        for i, own in enumerate(k):
            alone[3 * i : 3 * i + 3, 3 * i : 3 * i + 3] = own
        # what forces initial strains leave once free bodies have given way
        self.forces_of_strains = alone - pulled @ soft @ pulled.T


def _strained(layout: Layout, blade: Blade, count: int) -> Floats:
    """Return how motions of the bodies strain a blade at its end: along, across, turned."""
    start, end = (np.array(place, dtype=np.float64) for place in (blade.start, blade.end))
    x, y = (end - start) / np.hypot(*(end - start))
    turned = np.array([[x, y, 0.0], [-y, x, 0.0], [0.0, 0.0, 1.0]])
    found = np.zeros((3, count))
    names = [body.name for body in layout.bodies]
    for name, sense in ((blade.first, -1.0), (blade.second, 1.0)):
        if name in names:
            arm = end - np.array(layout.body(name).point, dtype=np.float64)
            moved = np.array([[1.0, 0.0, -arm[1]], [0.0, 1.0, arm[0]], [0.0, 0.0, 1.0]])
            own = 3 * layout.index(name)
            found[:, own : own + 3] += sense * turned @ moved
    return found


def _supported(layout: Layout, count: int) -> Floats:
    """Return the stiffness of the springs to the ground (count, count) [N/m, N, N·m]."""
    found = np.zeros((count, count))
    for support in layout.supports:
        arm = np.subtract(support.point, layout.body(support.body).point).astype(np.float64)
        moved = np.array([[1.0, 0.0, -arm[1]], [0.0, 1.0, arm[0]], [0.0, 0.0, 1.0]])
        own = 3 * layout.index(support.body)
        k = np.diag(np.array(support.stiffness, dtype=np.float64))
        found[own : own + 3, own : own + 3] += moved.T @ k @ moved
    return found


def _stress_rows(layout: Layout) -> Floats:
    """Return the stress at both faces along all blades per force at their ends (places, forces)."""
    found = []
    for i, blade in enumerate(layout.blades):
        l, b = float(blade.length), float(blade.b)
        bends, pulls = map(float, blade.peak)
        for piece in blade.profile.pieces(l):
            s, h = np.broadcast_arrays(*map(np.ravel, (piece.position(PLACES),
                                                       piece.thickness(PLACES))))  # fmt: skip
            bent, pulled = 6.0 * bends / (b * h**2), pulls / (b * h)
            for face in (1.0, -1.0):
                rows = np.zeros((len(s), 3 * len(layout.blades)))
                rows[:, 3 * i : 3 * i + 3] = np.column_stack([face * pulled, bent * (l - s), bent])
                found.append(rows)
    return np.concatenate(found)


def _roots_of(matrices: Floats) -> Floats:
    """Return the symmetric square roots of matrices; what of one is negative is rounding."""
    values, axes = np.linalg.eigh(matrices)
    return np.asarray(np.einsum("rij,rj,rkj->rik", axes, np.sqrt(np.maximum(values, 0.0)), axes))
