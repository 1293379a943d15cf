"""Beams that shells set out from: the path from rest is theirs, its end a shell's first guess.

A shell that is bent far in one step has first to forget how far that stretched it; beams in mixed
form know the way in few steps.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.shell.shells import Shells, shells_of
from flexcli.mechanics.space.exact.beams import Beams, beams_of
from flexcli.mechanics.space.exact.members import FIRST_GUESS, Members
from flexcli.mechanics.space.exact.rotation import matrix_of, moved
from flexcli.mechanics.space.layout import BeamEffects, SpaceLayout
from flexcli.numerics.collocation import refining_matrix

__all__ = ["SHELL_LEVELS", "shells_from_beams"]

Floats = NDArray[np.float64]

SHELL_LEVELS = (FIRST_GUESS, 12, 16, 20, 24)
"""Modes along a blade, level by level, half as many across it; at the first it is a beam.

With fewer than 8 modes a shell locks."""

_NODES = 12
"""Gauss nodes of the beams."""

_E_X = np.array([1.0, 0.0, 0.0])


@dataclass(frozen=True, eq=False)
class FirstGuess(Beams):
    """Beams that are shells at every level but the first."""

    layout: SpaceLayout
    effects: BeamEffects

    level = FIRST_GUESS

    def at_level(self, level: int) -> Members:
        """Return the blades as shells."""
        return shells_of(self.layout, self.effects, level)

    def finer(self, fine: Any, z: Floats) -> Floats:
        """Return rows of z as shells whose sections are straight lines across the beams."""
        if not isinstance(fine, Shells):
            return super().finer(fine, z)
        return np.array([self._as_shells(fine, row) for row in z])

    def _as_shells(self, fine: Shells, z: Floats) -> Floats:
        mesh, nodes = self.mesh, self.nodes(z)
        found = fine.rest()
        shells, rods = fine.parts(found)
        strips = fine.clamped.strips
        at = fine.clamped.split(shells)
        ends = mesh.kinematics(nodes[..., :4], np.zeros_like(nodes[..., :3]))[1]
        ahead = moved(nodes[..., :4], _E_X) + _E_X
        for k, i in enumerate(fine.blades):
            at.turn[k] = ends[i] / np.linalg.norm(ends[i])
            at.end[k] = mesh.w[i] @ ahead[i]
            used = mesh.w[i] > 0.0
            centre = (mesh.J[i] @ ahead[i])[used]
            across = strips.width[k] / 2.0 * matrix_of(nodes[i, used, :4])[..., 2]
            along = strips.basis.at(mesh.s[i, used], np.zeros(1))[0][0]
            held = fine.clamped.vectors(shells)[k]
            for j, line in enumerate((centre, across)):
                off = line - along.T @ held[:, j]
                at.inside[k, :, j] = np.linalg.lstsq(along[-at.inside.shape[1] :].T, off)[0]
        if fine.rods is not None:
            # a rod is of one segment
            count = mesh.per_segment
            matrix = refining_matrix(count, fine.rods.level)
            rods[:] = (matrix @ nodes[fine.beams, :count]).ravel()
        return found


def shells_from_beams(layout: SpaceLayout, effects: BeamEffects, level: int) -> Members:
    """Return blades as shells, at the first level as beams (``MembersOf``).

    Raises
    ------
    SolveError
        When there is no blade, or its thickness varies.

    """
    if level != FIRST_GUESS:
        return shells_of(layout, effects, level)
    return FirstGuess(beams_of(layout, effects, _NODES).mesh, layout, effects)
