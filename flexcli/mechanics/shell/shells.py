"""Blades as thin shells between bodies, rods beside them as beams."""

from collections.abc import Callable
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant
from flexcli.formulas.section import second_moment
from flexcli.mechanics.shell.basis import basis_of
from flexcli.mechanics.shell.clamped import Clamped, Ends
from flexcli.mechanics.shell.element import Strips
from flexcli.mechanics.space.exact.beams import Beams, beams_of
from flexcli.mechanics.space.exact.members import EndMotions, Variation
from flexcli.mechanics.space.exact.mesh import mesh_of
from flexcli.mechanics.space.exact.rotation import matrix_of, skew, spun
from flexcli.mechanics.space.exact.second_variation import swing
from flexcli.mechanics.space.layout import BeamEffects, SpaceBlade, SpaceLayout, SpaceRod
from flexcli.numerics.stack import solve_stack

__all__ = ["Shells", "shells_of"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


class Shells(NamedTuple):
    """Blades as shells and rods as beams (``Members``); z is that of the shells, then of the rods.

    ``blades`` and ``beams`` are their places in the layout.
    """

    clamped: Clamped
    blades: Integers
    rods: Beams | None
    beams: Integers
    bending: Floats
    lengths: Floats
    level: int

    @property
    def stretch(self) -> float:
        """Return the stretch of the stiffest under a force of EI/l²."""
        most = 1.0 / (12.0 * float(np.max(self.clamped.strips.slender)))
        return most if self.rods is None else min(most, self.rods.stretch)

    def rest(self) -> Floats:
        """Return flat blades and straight rods."""
        return self._joined(self.clamped.rest(), lambda beams: beams.rest())

    def parts(self, z: Floats) -> tuple[Floats, Floats]:
        """Return the unknowns of the shells (shells, unknowns) and of the rods."""
        count = self.blades.size * (self.clamped.inside + 7)
        return z[:count].reshape(self.blades.size, -1), z[count:]

    def unit(self, z: Floats) -> Floats:
        """Return z with all quaternions of unit length."""
        shells, rods = self.parts(z)
        found = shells.copy()
        found[:, -4:] /= np.linalg.norm(found[:, -4:], axis=-1, keepdims=True)
        return self._joined(found, lambda beams: beams.unit(rods))

    def weight(self) -> Floats:
        """Return the weights of the ends of shells and of a mean of rods."""
        shells = np.zeros((self.blades.size, self.clamped.inside + 7))
        shells[:, -7:-4], shells[:, -4:] = 1.0 / self.blades.size, 4.0 / self.blades.size
        return self._joined(shells, lambda beams: beams.weight())

    def condense(self, z: Floats, f: Floats) -> EndMotions:
        """Return end motions from end forces."""
        shells, rods = self.parts(z)
        own = f[self.blades]
        at = self.clamped.about(shells)
        followed = _followed(at)
        through = np.swapaxes(at.mixed, -1, -2)
        stiff = at.outer - through @ followed[..., 1:]
        # a moment that keeps its axes, over what works on the rotation vector
        stiff[:, 3:, 3:] -= skew(own[:, 3:]) / 2.0
        off = own - at.force + (through @ followed[..., :1])[..., 0]
        right = np.concatenate([off[..., None], np.broadcast_to(np.eye(6), stiff.shape)], axis=-1)
        scale = 1.0 / np.sqrt(np.abs(np.diagonal(at.outer, axis1=-2, axis2=-1)))[..., None]
        scaled = stiff * scale * np.swapaxes(scale, -1, -2)
        ends = scale * solve_stack(scaled, scale * right)
        free = ends[..., 0]
        split = self.clamped.split(shells)
        spin, F = spun(split.turn, free[:, 3:]), ends[..., 1:]
        turn = split.turn + spin
        inside = -followed[..., 0] - (followed[..., 1:] @ free[..., None])[..., 0]
        other = None if self.rods is None else self.rods.condense(rods, f[self.beams])

        def follow(forces: Floats) -> Floats:
            moved = (F @ forces[self.blades][..., None])[..., 0]
            bent = -(followed[..., 1:] @ moved[..., None])[..., 0]
            change = np.concatenate([bent, moved[:, :3], spun(split.turn, moved[:, 3:])], axis=-1)
            if other is None:
                return change.ravel()
            return np.concatenate([change.ravel(), other.follow(forces[self.beams])])

        change = np.concatenate([inside, free[:, :3], spin], axis=-1).ravel()
        motion = split.end + free[:, :3] - np.array([1.0, 0.0, 0.0])
        turn /= np.linalg.norm(turn, axis=-1, keepdims=True)
        if other is None:
            return EndMotions(motion, turn, F, change, follow)
        return EndMotions(
            motion=self._ordered(motion, other.motion),
            turn=self._ordered(turn, other.turn),
            F=self._ordered(F, other.F),
            free=np.concatenate([change, other.free]),
            follow=follow,
        )

    def variation(self, z: Floats, f: Floats) -> Variation:
        """Return the second variation, all inside eliminated.

        With W the energy of a blade, N and μ the force and moment at its end, along the axes of
        its start and of its end Q, θ the turn of the start and δr the shift of the end along those
        of the start, ω the turn of the end along its own:
        ``δ²W − 2 δN·(δr + θ × r) − 2 N·(θ × δr) − N·(θ × (θ × r)) − 2 δμ·(Qᵀθ + ω) − μ·(Qᵀθ × ω)``.
        """
        shells, rods = self.parts(z)
        at, split = self.clamped.about(shells), self.clamped.split(shells)
        B = self.blades.size
        own, Q = f[self.blades], matrix_of(split.turn)
        Q_t = np.swapaxes(Q, -1, -2)
        N, moment = own[:, :3], (Q_t @ own[:, 3:, None])[..., 0]
        turned = np.zeros((B, 6, 6))
        turned[:, :3, :3], turned[:, 3:, 3:] = np.eye(3), Q
        mixed = at.mixed @ turned
        outer = np.swapaxes(turned, -1, -2) @ at.outer @ turned
        followed = _followed(at._replace(mixed=mixed))[..., 1:]
        stiff = outer - np.swapaxes(mixed, -1, -2) @ followed
        # columns: δN, δμ, θ
        C, by_end = np.zeros((B, 9, 9)), np.zeros((B, 6, 9))
        C[:, :3, 6:], C[:, 3:6, 6:] = skew(split.end), -Q_t
        C[:, 6:, :6] = np.swapaxes(C[:, :6, 6:], -1, -2)
        C[:, 6:, 6:] = -np.array([swing(*pair) for pair in zip(N, split.end, strict=True)])
        by_end[:, :3, :3] = by_end[:, 3:, 3:6] = -np.eye(3)
        by_end[:, :3, 6:] = -skew(N)
        by_end[:, 3:, 6:] = np.swapaxes(Q @ skew(moment), -1, -2) / 2.0
        matrix = C - np.swapaxes(by_end, -1, -2) @ np.linalg.solve(stiff, by_end)
        unstable = _negative(at.inner) + _negative(stiff)
        if self.rods is None:
            return Variation(matrix, unstable)
        other = self.rods.variation(rods, f[self.beams])
        return Variation(self._ordered(matrix, other.matrix), unstable + other.unstable)

    def grown(self, strains: Floats) -> "Shells":
        """Return them with free strains along them; a clamp grows across with its blade."""
        free = strains[self.blades, 0]
        strips = self.clamped.strips._replace(grown=free + free**2 / 2.0)
        rods = (
            None
            if self.rods is None
            else replace(self.rods, mesh=self.rods.mesh._replace(grown=strains[self.beams]))
        )
        return self._replace(clamped=Clamped(strips), rods=rods)

    def at_level(self, level: int) -> "Shells":
        """Return them with another number of modes."""
        basis = basis_of(level)
        clamped = Clamped(self.clamped.strips._replace(basis=basis))
        rods = None if self.rods is None else Beams(mesh_of(self.rods.mesh.sections, level))
        return self._replace(clamped=clamped, rods=rods, level=level)

    def finer(self, fine: "Shells", z: Floats) -> Floats:
        """Return rows of z with finer functions, whose share is nothing."""
        count = self.blades.size * (self.clamped.inside + 7)
        rows = z[:, :count].reshape(-1, self.clamped.inside + 7)
        filled = np.zeros((rows.shape[0], fine.clamped.inside + 7))
        was, becomes = self.clamped.split(rows), fine.clamped.split(filled)
        n = min(self.clamped.strips.basis.across, fine.clamped.strips.basis.across)
        m = min(was.inside.shape[1], becomes.inside.shape[1])
        becomes.slopes[..., :n] = was.slopes[..., :n]
        becomes.inside[:, :m, :n] = was.inside[:, :m, :n]
        becomes.end[:], becomes.turn[:] = was.end, was.turn
        parts = [filled.reshape(z.shape[0], -1)]
        if self.rods is not None and fine.rods is not None:
            parts.append(self.rods.finer(fine.rods, z[:, count:]))
        return np.concatenate(parts, axis=1)

    def _joined(self, shells: Floats, of_rods: Callable[[Beams], Floats]) -> Floats:
        if self.rods is None:
            return shells.ravel()
        return np.concatenate([shells.ravel(), of_rods(self.rods)])

    def _ordered(self, shells: Floats, rods: Floats) -> Floats:
        """Return rows of shells and of rods in the order of the layout."""
        found = np.empty((self.bending.size, *shells.shape[1:]))
        found[self.blades], found[self.beams] = shells, rods
        return found


def shells_of(layout: SpaceLayout, effects: BeamEffects, level: int) -> Shells:
    """Return the blades of a layout as shells, its rods as beams (``MembersOf``).

    Raises
    ------
    SolveError
        When there is no blade, or its thickness varies.

    """
    is_rod = np.array([isinstance(each, SpaceRod) for each in layout.blades])
    blades = [each for each in layout.blades if isinstance(each, SpaceBlade)]
    rods = tuple(each for each in layout.blades if isinstance(each, SpaceRod))
    if not blades:
        text = "a mechanism of rods alone has nothing that is a shell"
        raise SolveError("no-shell", text, "take model exact: rods are beams")
    l = np.array([np.linalg.norm(np.subtract(each.end, each.start)) for each in layout.blades])
    h = np.array([_thickness(each) for each in blades])
    b, long = np.array([each.b for each in blades]), l[~is_rod]
    nu = np.array([each.material.nu for each in blades])
    beams = None
    if rods:
        beams = beams_of(replace(layout, blades=rods), effects, level)
    EI = np.empty(l.size)
    EI[~is_rod] = [
        each.material.E * second_moment(each.b, t) for each, t in zip(blades, h, strict=True)
    ]
    if beams is not None:
        EI[is_rod] = beams.bending
    return Shells(
        clamped=Clamped(Strips(basis_of(level), b / long, (long / h) ** 2, nu, np.zeros(nu.size))),
        blades=np.flatnonzero(~is_rod),
        rods=beams,
        beams=np.flatnonzero(is_rod),
        bending=EI,
        lengths=l,
        level=level,
    )


def _thickness(blade: SpaceBlade) -> float:
    if blade.warps:
        text = f"{blade.name}: its clamps let it warp"
        raise SolveError("warping-ends", text, "clamps of shells keep ends flat; take model exact")
    if isinstance(blade.profile, Constant):
        return float(blade.profile.h)
    raise SolveError(
        "varying-thickness",
        f"{blade.name}: the thickness varies along it",
        "shells are of constant thickness; take model exact or linear",
    )


def _followed(at: Ends) -> Floats:
    """Return ``K⁻¹ (load, mixed)`` of what is inside (strips, n, 7)."""
    scale = 1.0 / np.sqrt(np.abs(np.diagonal(at.inner, axis1=-2, axis2=-1)))[..., None]
    K = at.inner * scale * np.swapaxes(scale, -1, -2)
    right = np.concatenate([at.load[..., None], at.mixed], axis=-1)
    return np.asarray(scale * solve_stack(K, scale * right))


def _negative(K: Floats) -> int:
    """Return how many eigenvalues of a stack of symmetric matrices are negative."""
    scale = 1.0 / np.sqrt(np.abs(np.diagonal(K, axis1=-2, axis2=-1)))[..., None]
    K = K * scale * np.swapaxes(scale, -1, -2)
    try:
        np.linalg.cholesky(K)
    except np.linalg.LinAlgError:
        return int(np.sum(np.linalg.eigvalsh(K) < 0.0))
    return 0
