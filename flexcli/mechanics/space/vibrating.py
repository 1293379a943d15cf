"""A mechanism in space as matrices for small vibration: bodies, blades and their inner modes."""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant, Profile
from flexcli.mechanics.heavy_blade import HeavyBlade, heavy_blade
from flexcli.mechanics.space.inertia import end_motions, mass_matrix
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.springs import MemberSprings
from flexcli.mechanics.space.stresses import StressRows, stress_rows

__all__ = ["SpaceVibration", "vibrating"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class SpaceVibration:
    """Mass, stiffness and base excitation of the coordinates; rows of each blade by name.

    Coordinates are those of the assembly relative to the base, then inner modes of the blades.
    ``pull`` is the inertial force per acceleration of the base along x, y, z, ``moved`` all the
    mass that it moves [kg]. ``motions`` (6, n) are those of each body's point along the axes of
    the drawing, ``forces`` (3, n) of each blade along it and across [N], ``stresses``
    (places, 2, n) the normal stress and √3 times the shear at the places of each blade [Pa].
    """

    mass: Floats
    stiffness: Floats
    pull: Mapping[str, Floats]
    moved: float
    motions: Mapping[str, Floats]
    forces: Mapping[str, Floats]
    stresses: Mapping[str, Floats]


def vibrating(assembly: SpaceAssembly) -> SpaceVibration:
    """Return the matrices of a mechanism at rest, its drive free.

    Notes
    -----
    Small vibration about rest, without load in the blades. Inside, a blade of constant thickness
    has its lowest modes of bending across the thickness (a rod in both directions) as a beam
    between held ends; what blades do inside along themselves and across their width, and those
    of varying thickness, follows their ends.

    References
    ----------
    Craig & Bampton (1968), AIAA Journal 6(7).

    """
    layout, size = assembly.layout, assembly.size
    members = list(zip(layout.blades, assembly.members, strict=True))
    inner = [list(_inner(member, found)) for member, found in members]
    count = sum(part.modes for parts in inner for part in parts)
    whole = size + 6 + count
    K, M = np.zeros((whole, whole)), np.zeros((whole, whole))
    K[:size, :size] = assembly.rows.T @ (assembly.stiffness[:, None] * assembly.rows)
    M[: size + 6, : size + 6] = mass_matrix(assembly)
    forces, stresses = {}, {}
    at = size + 6
    for k, ((member, found), parts) in enumerate(zip(members, inner, strict=True)):
        rows = slice(6 * k, 6 * k + 6)
        springs = np.zeros((6, whole))
        springs[:, :size] = assembly.stiffness[rows, None] * assembly.rows[rows]
        at_places = stress_rows(member, found)
        normal = at_places.normal[:, :6] @ springs
        shear = at_places.shear[:, :6] @ springs
        ends = end_motions(assembly, member, found)
        for part in parts:
            here = slice(at, at + part.modes)
            M[here, : size + 6] = part.coupling(ends)
            M[: size + 6, here] = M[here, : size + 6].T
            M[here, here] = part.beam.mass[6:, 6:]
            K[here, here] = part.beam.stiffness[6:, 6:]
            normal[:, here] = part.stress(at_places)
            at += part.modes
        forces[member.name] = springs[:3]
        stresses[member.name] = np.stack([normal, np.sqrt(3.0) * shear], axis=1)
    free = np.delete(np.arange(whole), np.arange(size, size + 6))
    pulls = {axis: M @ _rigid(assembly, axis, whole) for axis in "xyz"}
    total = float(_rigid(assembly, "x", whole) @ pulls["x"])
    motions = {}
    for body in layout.bodies:
        motion = np.zeros((6, whole))
        motion[:, :size] = assembly.motion(body.name, body.point)
        motions[body.name] = motion[:, free]
    return SpaceVibration(
        mass=M[np.ix_(free, free)],
        stiffness=K[np.ix_(free, free)],
        pull={axis: force[free] for axis, force in pulls.items()},
        moved=total,
        motions=motions,
        forces={name: found[:, free] for name, found in forces.items()},
        stresses={name: found[:, :, free] for name, found in stresses.items()},
    )


class _Inner(NamedTuple):
    """Inner modes of a blade in one plane of bending.

    ``ends`` are the six of its twelve end motions in that plane, with their ``signs``; ``bending``
    (2, modes) the stress of the modes at one face of its start and end [Pa], ``across`` the
    direction of the bending, 0 the thickness and 1 the width.
    """

    beam: HeavyBlade
    ends: list[int]
    signs: Floats
    bending: Floats
    across: int

    @property
    def modes(self) -> int:
        """Return how many there are."""
        return int(self.beam.mass.shape[0] - 6)

    def coupling(self, motions: Floats) -> Floats:
        """Return their mass with the coordinates, by the motions of the ends (12, n)."""
        return np.asarray(self.beam.mass[6:, :6] @ (self.signs[:, None] * motions[self.ends]))

    def stress(self, rows: StressRows) -> Floats:
        """Return the normal stress at the places of a blade per mode, that at its two ends."""
        found = np.zeros((len(rows.positions), self.modes))
        for end, position in enumerate((0.0, 1.0)):
            here = rows.positions == position
            found[here] = -rows.offsets[here, self.across, None] * self.bending[end]
        return found


def _inner(member: SpaceBlade | SpaceRod, found: MemberSprings) -> Iterator[_Inner]:
    """Yield the inner modes of a blade across its thickness, of a rod in both directions."""
    E, density = member.material.E, member.material.density
    if not density:
        return
    across: tuple[int, ...] = (0,)
    profile: Profile
    if isinstance(member, SpaceRod):
        # a rectangle of the same area and second moment as its section
        h = sqrt(12.0 * member.bent / member.area)
        b, outer, across = member.area / h, member.d / h, (0, 1)
        profile = Constant(h)
    elif isinstance(member.profile, Constant):
        profile, b, outer = member.profile, member.b, member.peak[0]
    else:
        return
    beam = heavy_blade(profile, E=E, l=found.l, b=b, density=density)
    for each in across:
        w, turn, sign = ((1, 5, 1.0), (2, 4, -1.0))[each]
        yield _Inner(
            beam, [0, w, turn, 6, 6 + w, 6 + turn], np.array([1.0, 1.0, sign] * 2),
            outer * beam.bending[:, 6:], each,
        )  # fmt: skip


def _rigid(assembly: SpaceAssembly, axis: str, size: int) -> Floats:
    """Return the coordinates, bodies then ground then inner ones, when all moves along an axis."""
    unit = np.array([float(axis == each) for each in "xyz"])
    found = np.zeros(size)
    for i in range(len(assembly.layout.bodies) + 1):
        found[6 * i : 6 * i + 3] = unit
    # a translation has the same components at any point, so only the axes change
    found[assembly.moving] = assembly.to_body[:3, :3].T @ unit @ np.eye(3, 6)
    return found
