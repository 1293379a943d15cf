"""One blade as a geometrically exact beam (Reissner): end motion and flexibility from its forces.

The blade lies in the frame of its start, x along it at rest. The force (n_x, n_y) is constant
along it (nothing loads it between its ends) and m is the moment at its end; with the rotation ψ(s)
of the section, ``N = n_x cos ψ + n_y sin ψ`` and ``Q = n_y cos ψ − n_x sin ψ``,

    ψ' = c M,  M(s) = m + ∫_s^1 f,  f = Q (1 + ρ N),  ρ = 1/EA − 1/κGA,
    x' = (1 + N/EA) cos ψ − (Q/κGA) sin ψ,  y' = (1 + N/EA) sin ψ + (Q/κGA) cos ψ.

All is scaled as in :mod:`flexcli.mechanics.mesh`. The compliances 1/EA and 1/κGA stand on top of no
fraction bar, so that they may vanish: slender and inextensible blades lose no digits.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.mesh import Mesh, across, chosen, pick
from flexcli.numerics.stack import solve_across

__all__ = [
    "Condensed",
    "Local",
    "Sections",
    "condense",
    "local",
    "paired",
    "section_forces",
    "turning",
]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]
Integers = NDArray[np.intp]


def paired(x: Floats, y: Floats) -> Complexes:
    """Return x + iy."""
    found = np.empty(x.shape, dtype=np.complex128)
    found.real, found.imag = x, y
    return found


def turning(phi: Floats) -> Complexes:
    """Return ``exp(iφ) − 1`` in full relative precision: how far a unit vector moves by turning."""
    half = 0.5 * phi
    at = np.empty(half.shape, dtype=np.complex128)
    np.cos(half, out=at.real)
    np.sin(half, out=at.imag)
    return np.asarray(2.0j * at.imag * at)


class Local(NamedTuple):
    """What the sections feel at the nodes: N, Q, f, ∂f/∂ψ.

    As x + iy: ``pull`` is ∂f/∂(n_x, n_y), ``moved`` how far the direction of the section has moved,
    ``rate`` (x' − 1, y').
    """

    N: Floats
    Q: Floats
    f: Floats
    f_psi: Floats
    pull: Complexes
    moved: Complexes
    rate: Complexes


class Sections(NamedTuple):
    """What a blade's condensing takes of a mesh, (blades or 1, K or 1, …, designs or 1).

    ``stretch`` and ``slide`` are the flexibilities by axial force and shear of a straight blade.
    """

    w: Floats
    A: Floats
    turn: Floats
    far_turn: Floats
    end_turn: Floats
    axial: Floats
    shear: Floats
    rho: Floats
    stretch: Floats
    slide: Floats

    @classmethod
    def of(cls, mesh: Mesh) -> "Sections":
        """Return those of a mesh, its designs the last axis."""
        return cls(
            across(mesh.w),
            across(mesh.A),
            across(mesh.turn),
            across(mesh.far_turn),
            across(mesh.end_turn),
            across(mesh.axial),
            across(mesh.shear),
            across(mesh.rho),
            across((mesh.w * mesh.axial).sum(axis=-1)),
            across((mesh.w * mesh.shear).sum(axis=-1)),
        )

    def chosen(self, rows: Integers) -> "Sections":
        """Return those of the designs ``rows``."""
        return Sections(*(chosen(values, rows) for values in self))


class Condensed(NamedTuple):
    """A blade after its rotations ψ are eliminated from the linearised equations.

    ``end`` (blades, 3, 4, designs) has (x − 1, y, ψ) of the end once ψ has followed, and its
    derivative by (n_x, n_y, m), symmetric; ψ changes by ``free + follow δ(n_x, n_y, m)``.
    """

    end: Floats
    free: Floats
    follow: Floats


def local(mesh: Mesh, rows: Integers, psi: Floats, n: Complexes) -> Local:
    """Return forces and motion rates of the sections at the nodes, (designs, blades, K).

    ``n`` are the forces n_x + i n_y in the frame of the start, (designs, blades).
    """
    axial, shear, rho = (pick(a, rows) for a in (mesh.axial, mesh.shear, mesh.rho))
    return _local(axial, shear, rho, psi, n[..., None])


def _local(axial: Floats, shear: Floats, rho: Floats, psi: Floats, n: Complexes) -> Local:
    """Return forces and motion rates of sections under the force n_x + i n_y."""
    moved = turning(psi)
    turned = 1.0 + moved
    force = n * turned.conj()
    N, Q = force.real, force.imag
    soft, strain = np.empty_like(force), np.empty_like(force)
    slide = np.multiply(rho, Q, out=soft.real)
    stretch = np.add(1.0, rho * N, out=soft.imag)
    np.multiply(axial, N, out=strain.real)
    np.multiply(shear, Q, out=strain.imag)
    return Local(
        N=N,
        Q=Q,
        f=Q * stretch,
        f_psi=slide * Q - stretch * N,
        pull=soft * turned,
        moved=moved,
        rate=moved + strain * turned,
    )


def condense(at: Sections, psi: Floats, n: Complexes, m: Floats) -> Condensed:
    """Return the blades' end motions and flexibilities about rotations psi and forces.

    Parameters
    ----------
    at : Sections
        The blades.
    psi : array, shape (blades, K, designs)
        Rotations at the nodes [rad].
    n : array, shape (blades, designs)
        Forces n_x + i n_y [EI/l²] in the frame of the start.
    m : array, shape (blades, designs)
        Moments at the end [EI/l].

    Returns
    -------
    Condensed
        End motions, flexibilities and how the rotations follow.

    """
    here = _local(at.axial, at.shear, at.rho, psi, n[:, None])
    blades, K, designs = psi.shape
    made, effect = np.empty((2, blades, K, 3, designs))
    made[:, :, 0], made[:, :, 1], made[:, :, 2] = here.f, here.pull.real, here.pull.imag
    # (1 − A f_ψ) δψ = right-hand sides
    system = np.empty((blades, K, K + 4, designs))
    right = system[:, :, K:]
    right[:, :, :3] = np.einsum("bikn,bkjn->bijn", at.A, made)
    right[:, :, 0] += at.turn * m[:, None] - psi
    right[:, :, 3] = at.turn
    if here.f_psi.any():
        matrix = system[:, :, :K]
        np.multiply(at.A, -here.f_psi[:, None], out=matrix)
        system.reshape(blades, K * (K + 4), designs)[:, :: K + 5] += 1.0
        right = solve_across(system)
    np.multiply(at.w[:, :, None], made[:, :, 1:], out=effect[:, :, :2])
    np.multiply(at.far_turn, here.f_psi, out=effect[:, :, 2])
    end = np.einsum("bkin,bkjn->bijn", effect, right)
    # what the forces do with the rotations held
    sin = here.moved.imag
    held = np.empty((blades, K, 4, designs))
    bent = at.rho * sin
    np.multiply(bent, sin, out=held[:, :, 0])
    np.multiply(bent, 1.0 + here.moved.real, out=held[:, :, 1])
    held[:, :, 2], held[:, :, 3] = here.rate.real, here.rate.imag
    total = np.einsum("bkn,bkjn->bjn", at.w, held)
    more = np.zeros((blades, 3, 4, designs))
    more[:, :2, 0] = total[:, 2:]
    more[:, 0, 1], more[:, 1, 2] = at.stretch - total[:, 0], at.slide + total[:, 0]
    more[:, 0, 2] = more[:, 1, 1] = total[:, 1]
    more[:, 2, :3] = np.einsum("bkn,bkjn->bjn", at.far_turn, made)
    more[:, 2, 0] += at.end_turn * m
    more[:, 2, 3] = at.end_turn
    end += more
    return Condensed(end, right[:, :, 0], right[:, :, 1:])


def section_forces(
    mesh: Mesh, rows: Integers, psi: Floats, q: Floats
) -> tuple[Floats, Floats, Floats]:
    """Return N, Q [EI/l²] and M [EI/l] with the ends' M first and last, (designs, blades, K + 2).

    N and Q at the start belong to ψ = 0; those at the end to the rotation of the end.
    """
    at = local(mesh, rows, psi, paired(q[..., 0], q[..., 1]))
    w, back, end_turn, far_turn = (
        pick(a, rows) for a in (mesh.w, mesh.back, mesh.end_turn, mesh.far_turn)
    )
    m = q[..., 2, None]
    inner = m + np.sum(back * at.f[..., None, :], axis=-1)
    start = m + np.sum(w * at.f, axis=-1, keepdims=True)
    end = end_turn[..., None] * m + np.sum(far_turn * at.f, axis=-1, keepdims=True)
    M = np.concatenate([start, inner, m], axis=-1)
    all_psi = np.concatenate([np.zeros_like(m), psi, end], axis=-1)
    n_x, n_y = q[..., 0, None], q[..., 1, None]
    cos, sin = np.cos(all_psi), np.sin(all_psi)
    return n_x * cos + n_y * sin, n_y * cos - n_x * sin, M
