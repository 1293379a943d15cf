"""Stress along a blade or rod in space, per the six forces at its elastic centre."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant
from flexcli.formulas.restrained_torsion import restrained_stresses
from flexcli.formulas.torsion_section import shear_factor, torsion_constant
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod
from flexcli.mechanics.space.springs import MemberSprings
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["AROUND", "StressRows", "equivalent", "stress_rows"]

Floats = NDArray[np.float64]

AROUND = 32
"""Points around a round section; the bending is taken as much larger as may lie between two."""

NODES = 16
"""Places on each piece of a blade whose thickness varies."""

CORNERS = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))


class StressRows(NamedTuple):
    """Normal and shear stress at places (places, 9) per force at the centre and per weight.

    The columns are N, V_y, V_z [N], T, M_y, M_z at the elastic centre [N·m], then a weight along
    x, y, z of the blade [N/m] beyond what it puts on the ends. ``where`` says where each is,
    ``offsets`` (places, 2) how far from the axis across thickness and width, over half of each,
    and ``positions`` how far along the blade, over its length. ``warping`` is the part of the
    normal stress that is of restrained warping.
    """

    normal: Floats
    shear: Floats
    warping: Floats
    where: tuple[str, ...]
    offsets: Floats
    positions: Floats


def equivalent(normal: Floats, shear: Floats) -> Floats:
    """Return von Mises' stress of a normal and a shear stress, √(σ² + 3 τ²) [Pa]."""
    return np.asarray(np.sqrt(normal**2 + 3.0 * shear**2))


def stress_rows(member: SpaceBlade | SpaceRod, found: MemberSprings) -> StressRows:
    """Return the stresses of a blade or rod where they may be the worst.

    Parameters
    ----------
    member : SpaceBlade or SpaceRod
        The blade or rod.
    found : MemberSprings
        Its springs.

    Returns
    -------
    StressRows
        At the corners, in the middle of the faces and of the sides of a blade, around a rod.

    Notes
    -----
    Nominal stress: that of the section's forces, without the concentration at the clamps. The
    shear of torsion in the middle of the sides is taken as that of the faces, which is larger.

    """
    if isinstance(member, SpaceRod):
        return _of_rod(member, found)
    s, h, names = _sections(member, found.l)
    b, l = member.b, found.l
    A, I_z, I_y = b * h, b * h**3 / 12.0, h * b**3 / 12.0
    N, V_y, V_z, T, M_y, M_z = _section_forces(s, l, found)
    twist_shear, warp = _torsion(member, found, s, h)
    bends, pulls = member.peak
    normal, shear, warping = list[Floats](), list[Floats](), list[Floats]()
    where, offsets = list[str](), list[tuple[float, float]]()

    def place(name: str, y: float, z: float, tau: Floats, warped: Floats) -> None:
        direct = pulls * (N / A[:, None] + M_y * (z * b / 2.0 / I_y)[:, None])
        sigma = direct - bends * M_z * (y * h / 2.0 / I_z)[:, None]
        normal.append(sigma + warped)
        shear.append(tau)
        warping.append(warped)
        where.extend(f"{at}, {name}" for at in names)
        offsets.extend([(y, z)] * len(s))

    none = np.zeros_like(N)
    for y, z in CORNERS:
        place("corner", y, z, none, T * (y * z * warp)[:, None])
    for y in (1.0, -1.0):
        tau = y * T * twist_shear[:, None] + pulls * 1.5 * V_z / A[:, None]
        place("middle of the face", y, 0.0, tau, none)
    for z in (1.0, -1.0):
        tau = z * T * twist_shear[:, None] + pulls * 1.5 * V_y / A[:, None]
        place("middle of the side", 0.0, z, tau, none)
    return StressRows(
        np.concatenate(normal), np.concatenate(shear), np.concatenate(warping), tuple(where),
        np.array(offsets), np.tile(s / l, len(offsets) // len(s)),
    )  # fmt: skip


def _sections(member: SpaceBlade, l: float) -> tuple[Floats, Floats, tuple[str, ...]]:
    """Return positions, thicknesses and names of the sections that are looked at."""
    if isinstance(member.profile, Constant):
        s = np.array([0.0, l / 2.0, l])
        return s, np.full(3, float(member.profile.h)), ("start", "middle", "end")
    nodes, _ = gauss_rule(NODES)
    u = np.concatenate([[-1.0], 2.0 * nodes - 1.0, [1.0]])
    each = [np.broadcast_arrays(p.position(u), p.thickness(u)) for p in member.profile.pieces(l)]
    s, h = (np.concatenate(part).astype(np.float64) for part in zip(*each, strict=True))
    return s, h, tuple(f"at {at / l:.0%} of its length" for at in s)


def _section_forces(s: Floats, l: float, found: MemberSprings) -> tuple[Floats, ...]:
    """Return N, V_y, V_z, T, M_y, M_z at the sections as rows (sections, 9)."""
    rows = np.zeros((6, len(s), 9))
    rows[range(6), :, range(6)] = 1.0
    rows[5, :, 1] = float(found.springs.across_thickness) - s
    rows[4, :, 2] = s - float(found.springs.across_width)
    # between clamps: what a weight does beyond the forces that it puts on the ends
    rows[0, :, 6] = rows[1, :, 7] = rows[2, :, 8] = l / 2.0 - s
    held = s**2 / 2.0 - l * s / 2.0 + l**2 / 12.0
    rows[5, :, 7], rows[4, :, 8] = held, -held
    return tuple(rows)


def _torsion(
    member: SpaceBlade, found: MemberSprings, s: Floats, h: Floats
) -> tuple[Floats, Floats]:
    """Return shear at the faces and normal stress at a corner per torque, at the sections."""
    E, G, b = member.material.E, member.material.G, member.b
    if member.warps_freely or not isinstance(member.profile, Constant):
        free = shear_factor(h, b) * np.minimum(h, b) / torsion_constant(h, b)
        return free, np.zeros_like(s)
    theta = 1.0 / float(found.springs.stiffness[3])
    at = restrained_stresses(
        E=E, G=G, h=h[0], b=b, l=found.l, theta=theta, poisson_ratio=member.material.nu
    )
    # warping is held at both ends, of opposite sign, and the shear is that of mid-length
    normal = float(at.normal) * np.array([1.0, 0.0, -1.0])
    return float(at.shear) * np.array([0.0, 1.0, 0.0]), normal


def _of_rod(member: SpaceRod, found: MemberSprings) -> StressRows:
    """Return the stresses around a round rod at its ends and in the middle."""
    d, l = member.d, found.l
    A, I = np.pi * d**2 / 4.0, np.pi * d**4 / 64.0
    s = np.array([0.0, l / 2.0, l])
    N, V_y, V_z, T, M_y, M_z = _section_forces(s, l, found)
    angles = 2.0 * np.pi * np.arange(AROUND) / AROUND
    between = 1.0 / np.cos(np.pi / AROUND)
    normal, shear, where = list[Floats](), list[Floats](), list[str]()
    offsets = list[tuple[float, float]]()
    for angle in angles:
        y, z = np.cos(angle), np.sin(angle)
        bent = between * d / 2.0 / I * (M_y * z - M_z * y)
        normal.append(N / A + bent)
        along = between * 4.0 / 3.0 * (V_z * y - V_y * z) / A
        shear.append(T * d / (4.0 * I) + along)
        where.extend(("start", "middle", "end"))
        offsets.extend([(between * y, between * z)] * len(s))
    found_normal = np.concatenate(normal)
    none = np.zeros_like(found_normal)
    return StressRows(
        found_normal, np.concatenate(shear), none, tuple(where),
        np.array(offsets), np.tile(s / l, AROUND),
    )  # fmt: skip
