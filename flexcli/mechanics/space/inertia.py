"""Mass of a mechanism in space: bodies, and blades that follow their ends as beams do."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.rigid_motion import motion_along, motion_at
from flexcli.mechanics.space.layout import SpaceBlade, SpaceBody, SpaceRod
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.springs import MemberSprings
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["blade_masses", "end_motions", "mass_matrix", "weight_along"]

Floats = NDArray[np.float64]

NODES = 24
"""Gauss nodes on a piece of a blade: all digits of a constant one, six of a sharp notch."""


def mass_matrix(assembly: SpaceAssembly) -> Floats:
    """Return the mass of bodies and blades on the coordinates and, last, the ground's six.

    Parameters
    ----------
    assembly : SpaceAssembly
        The mechanism.

    Returns
    -------
    array, shape (coordinates + 6, coordinates + 6)
        Mass matrix [kg, kg·m, kg·m²]; the ground's motion is that of the origin along the axes
        of the drawing.

    Notes
    -----
    A blade moves as a beam under loads at its ends alone: exact for the work of its inertia while
    it vibrates well below its own lowest frequency.

    """
    layout, size = assembly.layout, assembly.size
    M = np.zeros((size + 6, size + 6))
    for i, body in enumerate(layout.bodies):
        at = slice(6 * i, 6 * i + 6)
        M[at, at] = _of_body(body)
    at = assembly.moving
    M[:, at] = M[:, at] @ assembly.to_body
    M[at] = assembly.to_body.T @ M[at]
    for member, found in zip(layout.blades, assembly.members, strict=True):
        ends = end_motions(assembly, member, found)
        M += ends.T @ _of_blade(member, found) @ ends
    return M


def end_motions(
    assembly: SpaceAssembly, member: SpaceBlade | SpaceRod, found: MemberSprings
) -> Floats:
    """Return the motions of a blade's start and end along its axes, shape (12, coordinates + 6).

    They are per coordinate and, last, per motion of the ground, as in :func:`mass_matrix`.
    """
    layout = assembly.layout
    names = [body.name for body in layout.bodies]
    ends = np.zeros((12, assembly.size + 6))
    for row, (name, point) in enumerate(
        ((member.first, member.start), (member.second, member.end))
    ):
        i = names.index(name) if name in names else len(names)
        origin = layout.bodies[i].point if i < len(names) else (0.0, 0.0, 0.0)
        turned = motion_along(found.axes) @ motion_at(np.subtract(point, origin))
        ends[6 * row : 6 * row + 6, 6 * i : 6 * i + 6] = turned
    at = assembly.moving
    ends[:, at] = ends[:, at] @ assembly.to_body
    return ends


def weight_along(assembly: SpaceAssembly, M: Floats, acceleration: Floats) -> Floats:
    """Return the load of an acceleration on all masses on the coordinates, shape (coordinates,).

    ``acceleration`` [m/s²] is that of a field, such as gravity, along the axes of the drawing.
    """
    field = np.zeros(assembly.size + 6)
    for body in assembly.layout.bodies:
        i = 6 * assembly.layout.index(body.name)
        field[i : i + 3] = acceleration
    field[-6:-3] = acceleration
    at = assembly.moving
    # a translation has the same components at any point, so only the axes change
    field[at] = assembly.to_body[:3, :3].T @ acceleration @ np.eye(3, 6)
    return np.asarray((M @ field)[: assembly.size])


def blade_masses(assembly: SpaceAssembly) -> Floats:
    """Return the mass of each blade and rod, without rigid parts of unknown section [kg]."""
    each = zip(assembly.layout.blades, assembly.members, strict=True)
    return np.array([_pieces(member, found)[1].sum() for member, found in each])


def _of_body(body: SpaceBody) -> Floats:
    """Return the 6×6 mass of a body on the motion of its point."""
    M = np.zeros((6, 6))
    M[:3, :3] = body.mass * np.eye(3)
    M[3:, 3:] = body.inertia
    at = motion_at(np.subtract(body.com, body.point))
    return np.asarray(at.T @ M @ at)


def _pieces(member: SpaceBlade | SpaceRod, found: MemberSprings) -> tuple[Floats, Floats, Floats]:
    """Return position over length, mass and inertia (3) of slices about their own axes."""
    nodes, weights = gauss_rule(NODES)
    density, l = member.material.density, found.l
    if isinstance(member, SpaceRod):
        mass = density * member.area * l * weights
        one = mass * member.bent / member.area
        return nodes, mass, np.stack([2.0 * one, one, one], axis=-1)
    u = 2.0 * nodes - 1.0
    each = []
    for piece in member.profile.pieces(l):
        s, h = np.broadcast_arrays(piece.position(u), piece.thickness(u))[:2]
        each.append((s / l, h, 2.0 * weights * piece.slope(u) * h * member.b * density))
    xi, h, mass = (np.concatenate(part) for part in zip(*each, strict=True))
    y, z = mass * member.b**2 / 12.0, mass * h**2 / 12.0
    return xi, mass, np.stack([y + z, y, z], axis=-1)


def _of_blade(member: SpaceBlade | SpaceRod, found: MemberSprings) -> Floats:
    """Return the 12×12 mass of a blade on the motions of its start and its end, along its axes."""
    xi, mass, inertia = _pieces(member, found)
    l = found.l
    # cubic Hermite functions of the ends' shift and turn, and their slopes
    shift = np.stack([1.0 - 3.0 * xi**2 + 2.0 * xi**3, 3.0 * xi**2 - 2.0 * xi**3])
    turn = np.stack([xi - 2.0 * xi**2 + xi**3, xi**3 - xi**2]) * l
    d_shift = np.stack([6.0 * xi**2 - 6.0 * xi, 6.0 * xi - 6.0 * xi**2]) / l
    d_turn = np.stack([1.0 - 4.0 * xi + 3.0 * xi**2, 3.0 * xi**2 - 2.0 * xi])
    line = np.stack([1.0 - xi, xi])
    F = np.zeros((len(xi), 6, 12))
    for end in (0, 1):
        k = 6 * end
        F[:, 0, k] = F[:, 3, k + 3] = line[end]
        F[:, 1, k + 1], F[:, 1, k + 5] = shift[end], turn[end]
        F[:, 2, k + 2], F[:, 2, k + 4] = shift[end], -turn[end]
        F[:, 5, k + 1], F[:, 5, k + 5] = d_shift[end], d_turn[end]
        F[:, 4, k + 2], F[:, 4, k + 4] = -d_shift[end], d_turn[end]
    each = np.concatenate([np.repeat(mass[:, None], 3, axis=1), inertia], axis=1)
    return np.asarray(np.einsum("nia,ni,nib->ab", F, each, F))
