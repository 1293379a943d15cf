"""Stress on both faces of blades as shells, and of the rods beside them.

``σ = E/(1 − ν²) law (E ± κ h/2)``. Clamps keep a section from narrowing: the stress there is
higher than a beam's. In the corners of clamps and long sides it has no bound, which no nominal
stress has: places near both are left out.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.shell.element import derivatives
from flexcli.mechanics.shell.shells import Shells
from flexcli.mechanics.shell.strain import strains
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.stresses import BladeStress, beam_stresses
from flexcli.mechanics.space.layout import SpaceBlade

__all__ = ["CORNER", "FaceStress", "rod_stresses", "shell_stresses"]

Floats = NDArray[np.float64]

_ALONG, _ACROSS = 33, 17
"""Places looked at along and across a blade, denser towards its rim."""

CORNER = 0.1
"""How near to a clamp and a long side a place is in their corner, over the shorter of length and
width, and not less than h. The stress beside it is about the nominal one of a wide blade (b = 0.5
to 1.5 l, bent and pulled in its plane), that of places h away is 1.4 to 1.6 times as large."""


class FaceStress(NamedTuple):
    """Stress on the faces of a blade at places s along and z across it [m] from start and middle.

    ``along``, ``across`` and ``shear`` (2, places) [Pa]: on the face towards the blade's y, then on
    the other.
    """

    name: str
    s: Floats
    z: Floats
    along: Floats
    across: Floats
    shear: Floats

    @property
    def equivalent(self) -> Floats:
        """Return von Mises' stress (2, places) [Pa]."""
        sums = self.along**2 - self.along * self.across + self.across**2
        return np.asarray(np.sqrt(sums + 3.0 * self.shear**2))


def shell_stresses(state: SpaceEquilibrium, corner: float = CORNER) -> tuple[FaceStress, ...]:
    """Return the stresses of all blades of an equilibrium of shells, their corners left out.

    Those are as large as a share ``corner`` of the shorter of length and width.
    """
    shells, inside = _shells(state)
    clamped = shells.clamped
    s, t = ((_towards_rim(n) + low) / (1.0 + low) for n, low in ((_ALONG, 1.0), (_ACROSS, 0.0)))
    along, across = clamped.strips.basis.at(s, t)
    g = derivatives(clamped.strips, along, across, clamped.vectors(shells.parts(inside)[0]))
    found = strains(g, clamped.strips.grown)
    place = [each.ravel() for each in np.meshgrid(s, t, indexing="ij")]
    faces = []
    for k, i in enumerate(shells.blades):
        blade, l = state.layout.blades[i], shells.lengths[i]
        assert isinstance(blade, SpaceBlade)
        h = l / np.sqrt(clamped.strips.slender[k])
        nu = clamped.strips.nu[k]
        stiff = blade.material.E / (1.0 - nu**2) * clamped.strips.law[k]
        where, z = place[0] * l, place[1] * blade.b / 2.0
        near = max(h, corner * min(l, blade.b))
        kept = (np.minimum(where, l - where) >= near) | (blade.b / 2.0 - np.abs(z) >= near)
        stretch, bend = (e[k].reshape(-1, 3)[kept] for e in (found.stretch, found.bend))
        sigma = np.stack([(stretch + side * h / (2.0 * l) * bend) @ stiff for side in (1.0, -1.0)])
        faces.append(
            FaceStress(
                blade.name, where[kept], z[kept], sigma[..., 0], sigma[..., 1], sigma[..., 2]
            )
        )
    return tuple(faces)


def rod_stresses(state: SpaceEquilibrium) -> tuple[BladeStress, ...]:
    """Return the stresses of all rods of an equilibrium of shells."""
    shells, inside = _shells(state)
    if shells.rods is None:
        return ()
    return beam_stresses(
        shells.rods,
        shells.parts(inside)[1],
        state.own_forces[shells.beams],
        [state.layout.blades[i] for i in shells.beams],
        state.effects,
    )


def _shells(state: SpaceEquilibrium) -> tuple[Shells, Floats]:
    part = state.part
    assembly = part.assembly.warmed(part.demand.warmth(part.share))
    if not isinstance(assembly.members, Shells):
        raise TypeError("the blades of this equilibrium are no shells")
    return assembly.members, assembly.at(state.part.x).inside


def _towards_rim(count: int) -> Floats:
    """Return places in [−1, 1], both ends among them, denser towards them."""
    return np.asarray(-np.cos(np.linspace(0.0, np.pi, count)))
