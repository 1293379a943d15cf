"""Bodies and blades of a joint in space on their way, by the poses of the bodies."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import NeckedDown
from flexcli.formulas.rigid_motion import axes_about_z
from flexcli.mechanics.space.bent_lines import Ends, bent_line
from flexcli.mechanics.space.inertia import blade_masses
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod
from flexcli.mechanics.space.swept_box import Edges, Sweep, edges_of
from flexcli.parts.geometries.base import Geometry
from flexcli.parts.space_joint import SpaceJoint
from flexcli.parts.space_poses import Poses, origins, turned

__all__ = ["Outline", "own_sags"]

Floats = NDArray[np.float64]

OWN_SAG = 1.0 / 100.0
"""How far a blade between fixed ends sags by what it weighs, over m a l²/(EI/l): 1/384 where it is
uniform, 1/96 of a hinge in its middle."""

TURNED = 0.15
"""Of l, how far a blade goes aside of its chord by the turn of an end: 4/27 where it is uniform."""

BETWEEN = 0.5
"""Of what one end is off more than the other, how far a line is from going evenly from one to the
other: a thin hinge in its middle takes all of it."""


class Outline:
    """What of a joint is drawn, along the axes of cases."""

    def __init__(self, joint: SpaceJoint, geometry: Geometry) -> None:
        self.joint, self.layout = joint, joint.layout
        self.axes = axes_about_z(geometry.axes)
        self.corners = geometry.outlines
        self.origins = origins(joint)
        self.names = [body.name for body in self.layout.bodies]

    @property
    def bare(self) -> tuple[str, ...]:
        """Return the parts that have no outline."""
        bodies = [name for name in self.names if name not in self.corners]
        thick = [
            f"the thick middle of {blade.name}"
            for blade in self.layout.blades
            if isinstance(blade, SpaceBlade) and isinstance(blade.profile, NeckedDown)
        ]
        return (*bodies, *thick)

    def sweep(
        self,
        poses: Poses,
        *,
        sags: Floats | float = 0.0,
        lines: Sequence[Edges] | None = None,
        share: Floats | float = 0.0,
    ) -> Sweep:
        """Return the corners of bodies and the edges of blades, and how far off they may be.

        Parameters
        ----------
        poses : Poses
            Of the bodies.
        sags : array, optional
            How far each blade sags between its ends (blades,) [m].
        lines : sequence of Edges, optional
            The lines of the blades, where more is known of them than the poses.
        share : float or array, optional
            Of how far they are from their chords, how far these lines are off [-].

        """
        found = []
        for name, corners in self.corners.items():
            points, off = self._placed(poses, name, corners)
            found.append(Sweep(points @ self.axes.T, _along_axes(poses, off)))
        sags = np.broadcast_to(sags, (len(self.layout.blades),))
        for k, blade in enumerate(self.layout.blades):
            own = None if lines is None else lines[k]
            found.append(self._blade(poses, blade, float(sags[k]), own, share))
        points, off = (
            np.concatenate([getattr(each, part) for each in found], axis=-2)
            for part in ("points", "off")
        )
        return Sweep(points, off, poses.is_known)

    def _placed(self, poses: Poses, name: str, points: Floats) -> tuple[Floats, Floats]:
        """Return where points of a body (n, 3) are (travels, n, 3), and how far off (travels, n).

        The ground does not move, but grows about the origin.
        """
        grown = 1.0 + poses.warmth * self.layout.body_growth.get(name, 0.0)
        if name not in self.names:
            found = np.broadcast_to(grown * points, (len(poses.motion), *points.shape))
            return found, np.zeros(found.shape[:2])
        i = self.names.index(name)
        arms = grown * (points - self.origins[i])
        shift, phi = np.split(poses.motion[:, i, None], 2, axis=-1)
        placed = turned(phi, arms) + shift + self.origins[i]
        long = np.linalg.norm(arms, axis=-1)
        return placed, poses.shift[:, i, None] + poses.turn[:, i, None] * long

    def _blade(
        self,
        poses: Poses,
        blade: SpaceBlade | SpaceRod,
        sag: float,
        edges: Edges | None,
        share: Floats | float,
    ) -> Sweep:
        """Return the edges of a blade, its line that of small motion if it is not given."""
        at, offs, frames = [], [], []
        unsure = np.zeros((len(poses.motion), 1))
        for name, seat in ((blade.first, blade.start), (blade.second, blade.end)):
            placed, off = self._placed(poses, name, np.array([seat], dtype=np.float64))
            at.append(placed[:, 0])
            offs.append(off)
            phi = np.zeros((len(poses.motion), 1, 3))
            if name in self.names:
                i = self.names.index(name)
                phi = poses.motion[:, i, None, 3:]
                unsure = unsure + poses.turn[:, i, None]
            frames.append(turned(phi, blade.axes))
        if edges is None:
            edges, off = bent_line(blade, Ends(*at, *frames), poses.axial)
        else:
            from_start = edges.line - at[0][:, None]
            chord = (at[1] - at[0])[:, None]
            chord = chord / np.linalg.norm(chord, axis=-1, keepdims=True)
            off = share * np.linalg.norm(np.cross(from_start, chord), axis=-1)
        l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
        s = np.linalg.norm(edges.line - edges.line[..., :1, :], axis=-1)
        s = s / s[..., -1:]
        curl = float(np.linalg.norm(self.layout.blade_curl.get(blade.name, (0.0,) * 3)))
        aside = np.full(unsure.shape, sag + poses.warmth * curl * l**2 / 8.0)
        aside = aside + BETWEEN * np.abs(offs[1] - offs[0]) + TURNED * l * unsure
        wide = blade.d if isinstance(blade, SpaceRod) else blade.b
        off = off + (1.0 - s) * offs[0] + s * offs[1] + 4.0 * s * (1.0 - s) * aside
        off = _along_axes(poses, off + unsure * wide / 2.0)
        grown = poses.warmth * self.layout.blade_growth.get(blade.name, 0.0)
        found = edges_of(blade, edges, self.axes, grown)
        more = np.concatenate([off] * (found.points.shape[-2] // off.shape[-2]), axis=-2)
        return found._replace(off=found.off + more)


def own_sags(joint: SpaceJoint, acceleration: Floats) -> Floats:
    """Return how far blades sag between their ends by what they weigh (blades,) [m]."""
    size = float(np.linalg.norm(acceleration))
    soft = [float(member.springs.stiffness[4:].min()) for member in joint.assembly.members]
    lengths = np.array([member.l for member in joint.assembly.members])
    sags = OWN_SAG * blade_masses(joint.assembly) * size * lengths**2 / np.array(soft)
    return np.asarray(sags)


def _along_axes(poses: Poses, off: Floats) -> Floats:
    """Return how far off points are along each axis, of how far they are in any direction."""
    return np.asarray(off[..., None] * np.array([1.0, 1.0, 0.0 if poses.is_flat else 1.0]))
