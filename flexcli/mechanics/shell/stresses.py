"""Stress on both faces of blades as shells, and of the rods beside them.

``σ = E/(1 − ν²) law (E ± κ h/2)``. Clamps keep a section from narrowing: the stress there is
higher than a beam's. In the corners of clamps and long sides it has no bound, which no nominal
stress has: places near both are left out.
"""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.shell.element import derivatives
from flexcli.mechanics.shell.shells import Shells
from flexcli.mechanics.shell.strain import strains
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.stresses import BladeStress, beam_stresses
from flexcli.mechanics.space.layout import SpaceBlade

__all__ = ["CORNER", "FaceStress", "rod_stresses", "shell_stresses", "twisted_corners"]

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
        return _mises(self.along, self.across, self.shear)


def shell_stresses(state: SpaceEquilibrium, corner: float = CORNER) -> tuple[FaceStress, ...]:
    """Return the stresses of all blades of an equilibrium of shells, their corners left out.

    Those are as large as a share ``corner`` of the shorter of length and width.
    """
    return tuple(each.outside(corner) for each in _all_over(state))


def twisted_corners(state: SpaceEquilibrium, corner: float = CORNER) -> float:
    """Return the largest stress of von Mises in corners of what is nominal there [Pa].

    A twisted blade that may not warp at its clamps is stressed along at its edges as nominally as
    it is by bending, in opposite ways on both faces and both edges: that part counts up to a
    thickness from the clamps and long sides, with what else there is where the corner ends; so does
    the stress along that has its moment ∫σ y z dA and is spread as y z, which beams have.
    """
    return max((each.twisted_corners(corner) for each in _all_over(state)), default=0.0)


class _Faces(NamedTuple):
    """Stresses ``sigma`` (2, along, across, 3) on both faces of a blade at all places looked at.

    ``s`` (along,) [m] is from its start, ``z`` (across,) from its middle, ``size`` are its length,
    width and thickness [m].
    """

    name: str
    s: Floats
    z: Floats
    sigma: Floats
    size: tuple[float, float, float]

    def beside(self, corner: float) -> NDArray[np.bool_]:
        """Return which places (along, across) are not in corners."""
        l, b, h = self.size
        near = max(h, corner * min(l, b))
        clamps, sides = np.minimum(self.s, l - self.s), b / 2.0 - np.abs(self.z)
        return np.asarray((clamps >= near)[:, None] | (sides >= near))

    def outside(self, corner: float) -> FaceStress:
        """Return the stresses outside of corners."""
        kept = self.beside(corner)
        s, z = (each[kept] for each in np.meshgrid(self.s, self.z, indexing="ij"))
        return FaceStress(self.name, s, z, *np.moveaxis(self.sigma[:, kept], -1, 0))

    def twisted_corners(self, corner: float) -> float:
        """Return the largest stress in corners: of twist there, of all else where they end."""
        odd = (self.sigma[0] - self.sigma[1]) / 2.0
        signs = np.array([-1.0, -1.0, 1.0])  # shear is alike at both edges, what is along is not
        of_twist = (odd + signs * odd[:, ::-1]) / 2.0
        twist = np.stack([of_twist, -of_twist])
        beside = self.beside(corner)
        # along each line from clamp to clamp, the places where its corners end
        first = np.argmax(beside, axis=0)
        last = self.s.size - 1 - np.argmax(beside[::-1], axis=0)
        rows = np.clip(np.arange(self.s.size)[:, None], first, last)
        rest = np.take_along_axis(self.sigma - twist, rows[None, ..., None], axis=1)
        spread = np.zeros_like(twist)
        spread[..., 0] = self._as_beam(twist[..., 0])
        each = (twist, self.beside(0.0) & ~beside), (spread, ~beside)
        found = (_mises(*np.moveaxis((rest + part)[:, inside], -1, 0)) for part, inside in each)
        return max(float(np.max(stress, initial=0.0)) for stress in found)

    def _as_beam(self, twist: Floats) -> Floats:
        """Return stresses of twist (2, along, across) spread as z, their moments the same."""
        z = self.z / np.max(np.abs(self.z))
        waves = np.polynomial.legendre.legvander(z, len(z) - 1)
        weights = np.linalg.solve(waves.T, 2.0 * np.eye(len(z))[0])
        return np.asarray(np.multiply.outer(1.5 * twist @ (weights * z), z))


def _mises(along: Floats, across: Floats, shear: Floats) -> Floats:
    return np.asarray(np.sqrt(along**2 - along * across + across**2 + 3.0 * shear**2))


def _all_over(state: SpaceEquilibrium) -> Iterator[_Faces]:
    """Yield the stresses of each blade of an equilibrium of shells."""
    shells, inside = _shells(state)
    clamped = shells.clamped
    s, t = ((_towards_rim(n) + low) / (1.0 + low) for n, low in ((_ALONG, 1.0), (_ACROSS, 0.0)))
    along, across = clamped.strips.basis.at(s, t)
    g = derivatives(clamped.strips, along, across, clamped.vectors(shells.parts(inside)[0]))
    found = strains(g, clamped.strips.grown)
    for k, i in enumerate(shells.blades):
        blade, l = state.layout.blades[i], shells.lengths[i]
        assert isinstance(blade, SpaceBlade)
        h = l / np.sqrt(clamped.strips.slender[k])
        nu = clamped.strips.nu[k]
        stiff = blade.material.E / (1.0 - nu**2) * clamped.strips.law[k]
        stretch, bend = (e[k].reshape(s.size, t.size, 3) for e in (found.stretch, found.bend))
        sigma = np.stack([(stretch + side * h / (2.0 * l) * bend) @ stiff for side in (1.0, -1.0)])
        yield _Faces(blade.name, s * l, t * blade.b / 2.0, sigma, (float(l), blade.b, float(h)))


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
    assembly = part.assembly.on_the_way(part.demand, part.share)
    if not isinstance(assembly.members, Shells):
        raise TypeError("the blades of this equilibrium are no shells")
    return assembly.members, assembly.at(state.part.x).inside


def _towards_rim(count: int) -> Floats:
    """Return places in [−1, 1], both ends among them, denser towards them."""
    return np.asarray(-np.cos(np.linspace(0.0, np.pi, count)))
