"""Blades and rods as geometrically exact beams between bodies."""

from dataclasses import dataclass, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.blade import along, condense
from flexcli.mechanics.space.exact.members import EndMotions, Members, Variation
from flexcli.mechanics.space.exact.mesh import Mesh, mesh_of
from flexcli.mechanics.space.exact.second_variation import beam_variation
from flexcli.mechanics.space.exact.section import section_of
from flexcli.mechanics.space.layout import BeamEffects, SpaceLayout
from flexcli.numerics.collocation import refining_matrix

__all__ = ["Beams", "beams_of"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Beams:
    """Beams (``Members``); inside them are quaternions and twist rates at the nodes."""

    mesh: Mesh

    @property
    def level(self) -> int:
        """Return the Gauss nodes on a piece."""
        return self.mesh.per_segment

    @property
    def bending(self) -> Floats:
        """Return E I of bending across the thickness [N·m²]."""
        return np.array([section.EI for section in self.mesh.sections])

    @property
    def lengths(self) -> Floats:
        """Return the lengths [m]."""
        return np.array([section.l for section in self.mesh.sections])

    @property
    def stretch(self) -> float:
        """Return the least stretch or shear under a force of EI/l²."""
        return float(np.min(self.mesh.C))

    def nodes(self, z: Floats) -> Floats:
        """Return quaternions and twist rates at the nodes (blades, nodes, 5)."""
        return z.reshape(self.mesh.blades, -1, 5)

    def rest(self) -> Floats:
        """Return straight, untwisted beams."""
        z = np.zeros(5 * self.mesh.blades * self.mesh.nodes)
        self.nodes(z)[..., 0] = 1.0
        return z

    def unit(self, z: Floats) -> Floats:
        """Return z with all quaternions of unit length."""
        found = z.copy()
        turns = self.nodes(found)[..., :4]
        turns /= np.sqrt(np.sum(turns**2, axis=-1, keepdims=True))
        return found

    def weight(self) -> Floats:
        """Return the weights of a mean of the rotations."""
        weight = np.zeros(5 * self.mesh.blades * self.mesh.nodes)
        self.nodes(weight)[..., :4] = 4.0 / (self.mesh.blades * self.mesh.nodes)
        return weight

    def condense(self, z: Floats, f: Floats) -> EndMotions:
        """Return end motions from end forces."""
        found = condense(self.mesh, self.nodes(z), f)
        return EndMotions(
            found.motion,
            found.turn,
            found.F,
            found.free.ravel(),
            lambda forces: (found.follow @ forces[:, None, :, None]).ravel(),
        )

    def variation(self, z: Floats, f: Floats) -> Variation:
        """Return the second variation, sections eliminated."""
        felt = along(self.mesh, self.nodes(z), f)
        found = [beam_variation(self.mesh, i, felt) for i in range(self.mesh.blades)]
        matrix = np.array([each.matrix for each in found]).reshape(-1, 9, 9)
        return Variation(matrix, sum(each.unstable for each in found))

    def grown(self, strains: Floats) -> Members:
        """Return them with free strains along them."""
        return replace(self, mesh=self.mesh._replace(grown=strains))

    def at_level(self, level: int) -> Members:
        """Return them at another number of nodes."""
        return Beams(mesh_of(self.mesh.sections, level))

    def finer(self, fine: Any, z: Floats) -> Floats:
        """Return rows of z interpolated to finer nodes."""
        count = self.mesh.per_segment
        matrix = refining_matrix(count, fine.mesh.per_segment)
        return np.asarray((matrix @ z.reshape(-1, count, 5)).reshape(z.shape[0], -1))


def beams_of(layout: SpaceLayout, effects: BeamEffects, level: int) -> Beams:
    """Return the blades of a layout as beams (``MembersOf``)."""
    return Beams(mesh_of(tuple(section_of(blade, effects) for blade in layout.blades), level))
