"""Stress along a blade or rod in space, per the six forces at its elastic centre."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Range, outside
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.formulas.restrained_torsion import restrained_stresses
from flexcli.formulas.torsion_section import shear_factor, torsion_constant, warping
from flexcli.mechanics.space.exact.mesh import mesh_of
from flexcli.mechanics.space.exact.section import section_of
from flexcli.mechanics.space.layout import SpaceBlade, SpaceRod, SpaceStar
from flexcli.mechanics.space.springs import NODES as MESHED
from flexcli.mechanics.space.springs import MemberSprings, springs_of, twist_rate
from flexcli.numerics.quadrature import gauss_rule

__all__ = [
    "AROUND",
    "SectionForces",
    "StressRows",
    "at_places",
    "equivalent",
    "hinge_error",
    "hinge_range",
    "shear_spread",
    "stress_rows",
    "twisted",
]

Floats = NDArray[np.float64]

AROUND = 32
"""Points around a round section; the bending is taken as much larger as may lie between two."""

NODES = 16
"""Places on each piece of a blade whose thickness varies."""

CORNERS = ((1.0, 1.0), (1.0, -1.0), (-1.0, 1.0), (-1.0, -1.0))

EVEN = 10.0
"""Width of a throat, in √(e ρ), that halves what its shear is above the mean."""

LOW, HIGH, HIGH_SHARP = -0.25, 0.28, 0.7
"""Least and largest error of the stress of forces across a notch, the second besides per e/ρ."""

NARROW, LOW_NARROW, HIGH_NARROW = 0.7, -0.2, 0.1
"""Width of a throat, in √(e ρ), up to which these are the least and largest error of the stress of
forces across it, the second besides ``HIGH_SHARP`` per e/ρ: solids had -0.165 to 0.125."""

BENT, BENT_NARROW, UNTWISTED = (-0.22, 0.04), (-0.03, 0.03), 2.0
"""Error of the stress of a moment M_y on a notch, and on a narrow one: solids had -0.2 to 0.022 and
-0.022 to 0.011. What V_z and T leave counts on no more of its stress than twice their own."""

WITHIN_LOW, EDGES, SIDES, WITHIN, WITHIN_HELD = -0.04, -0.2, -0.2, 0.06, 0.12
WITHIN_SHEARED, WITHIN_SHALLOW = 0.4, 0.2
"""Least error of the stress of N, V_y and M_z on a notch, what edges have less besides, per ν,
where a throat wider than √(e ρ) is kept from narrowing, and its shear amid the sides; the largest,
per ν likewise, per e/ρ, as a force across the thickness stresses the faces beside the throat, and
per e/ρ and e/depth.

Our solids of 178 notches (``tests/benchmarks/hinge_parts.py``), e/ρ 1e-4 to 0.65, e/depth to 3.5,
b/√(e ρ) 0.1 to 240, ν to 0.49: -0.011 to 0.36 by each force and eight mixtures, at most 0.87 of
what is told; with M_y 0.75 of that, under V_z, T and M_y 0.89, under mixtures of all six 0.76."""

FILLETED_LOW, FILLETED, FILLETED_WIDE = -0.28, 0.2, 0.45
"""The same of blades with fillets, the last per b/l: a wide one is sheared the most at its ends."""

SHARP_LOW = -0.55
"""Least error of those of h > r, whose peak is of no force across them: ten solids had -0.44 to
0.27."""

TAPERED = (-0.6, 0.25)
"""Error of the stress of a taper's sections, a thickness or more from its clamps, at rest and at a
stroke: 24 of CalculiX's solids (``tests/benchmarks/hinges_at_stroke.py``) had 0.43 to 1.18 of it
under V_z, T, M_y and mixtures of them, the least where its ends are kept from warping; 14 had 0.74
to 1.16 under N, V_y and M_z."""

STARS = (-0.1, 0.2)
"""Error of the stress of a star's sections: away from its clamps and roots, solids had up to 0.06
more and nothing less under N, M_y and M_z, twisted up to 0.17 more."""

COMPARED = (
    Range("e/ρ", most=1.0, why="blunter notches were not compared with solids"),
    Range("e/depth", most=4.0, why="shallower notches were not compared with solids"),
    Range("e/b", most=1.0, why="throats thicker than wide were not compared with solids"),
    Range("b/l", most=8.0, why="wider ones were not compared with solids"),
    Range("ν", most=0.5, why="no solid has more"),
)
"""Notches of which the stress under forces across them was compared, ρ the radius of the throat."""

FILLETS_COMPARED = (
    Range("h/r", most=3.7, why="sharper fillets were not compared with solids"),
    Range("h/b", most=1.0, why="blades thicker than wide were not compared with solids"),
    Range("b/l", most=2.0, why="wider ones were not compared with solids"),
    Range("ν", most=0.45, why="softer materials were not compared with solids"),
)
"""Blades with fillets of which it was."""


class SectionForces(NamedTuple):
    """Forces [N] and moments [N·m] in sections of a blade, shape (sections, columns).

    ``sheared`` is the shear of torsion in the middle of the broad faces, ``warped`` the normal
    stress of restrained warping at its largest [Pa].
    """

    N: Floats
    V_y: Floats
    V_z: Floats
    M_y: Floats
    M_z: Floats
    sheared: Floats
    warped: Floats


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
    if isinstance(member, SpaceStar):
        return _of_star(member, found)
    if isinstance(member, SpaceRod):
        return _of_rod(member, found)
    s, h, names = _sections(member, found.l)
    N, V_y, V_z, T, M_y, M_z = _section_forces(s, found.l, found)
    sheared, warped = _torsion(member, found, s, h)
    forces = SectionForces(N, V_y, V_z, M_y, M_z, T * sheared[:, None], T * warped[:, None])
    return at_places(member, s / found.l, h, names, forces)


def at_places(
    blade: SpaceBlade, positions: Floats, h: Floats, names: Sequence[str], forces: SectionForces
) -> StressRows:
    """Return the stresses of forces in sections of a blade, at eight places of each.

    ``positions`` along it, over its length, thicknesses ``h`` [m] and ``names`` are those of the
    sections; the columns of the stresses are those of the forces. At the corners of a hinge the
    shear of torsion counts beside the warping, which is largest a little way from them.
    """
    b, (bends, pulls), spread = blade.b, blade.peak, shear_spread(blade)
    A, I_z, I_y = b * h, b * h**3 / 12.0, h * b**3 / 12.0
    peak = bends if _is_hinge(blade) else 1.0
    # of a thin section it has all but a thickness of the edge
    beside = 1.0 if _is_hinge(blade) else 1.0 - np.minimum(h, b) / np.maximum(h, b)
    normal, shear, held = list[Floats](), list[Floats](), list[Floats]()
    where, offsets = list[str](), list[tuple[float, float]]()

    def place(name: str, y: float, z: float, tau: Floats, warped: Floats) -> None:
        direct = pulls * (forces.N / A[:, None] + forces.M_y * (z * b / 2.0 / I_y)[:, None])
        sigma = direct - bends * forces.M_z * (y * h / 2.0 / I_z)[:, None]
        normal.append(sigma + warped)
        shear.append(tau)
        held.append(warped)
        where.extend(f"{at}, {name}" for at in names)
        offsets.extend([(y, z)] * len(h))

    none, edge = np.zeros_like(forces.N), np.reshape(beside, (-1, 1))
    for y, z in CORNERS:
        place("corner", y, z, edge * y * forces.sheared, peak * y * z * forces.warped)
    for y in (1.0, -1.0):
        tau = y * forces.sheared + pulls * spread * forces.V_z / A[:, None]
        place("middle of the face", y, 0.0, tau, none)
    for z in (1.0, -1.0):
        tau = z * forces.sheared + pulls * 1.5 * forces.V_y / A[:, None]
        place("middle of the side", 0.0, z, tau, none)
    return StressRows(
        np.concatenate(normal), np.concatenate(shear), np.concatenate(held), tuple(where),
        np.array(offsets), np.tile(positions, len(offsets) // len(h)),
    )  # fmt: skip


def hinge_error(blade: SpaceBlade | SpaceRod) -> tuple[float, float] | None:
    """Return between what relative errors the stress of forces across a hinge lies [-].

    Of a notch or a blade with fillets under V_z, T and M_y: von Mises' stress of solids over that
    of :func:`stress_rows` less one. Nothing where none was compared; none of what is no hinge. That
    of stars and tapers is of all forces.
    """
    if isinstance(blade, SpaceStar):
        return STARS
    if not isinstance(blade, SpaceBlade) or isinstance(blade.profile, Constant | NeckedDown):
        return 0.0, 0.0
    if isinstance(blade.profile, Tabulated):
        return TAPERED if springs_of(blade).is_known else None
    wide = blade.b / float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    felt = {"b/l": wide, "ν": round(blade.material.nu, 9)}
    compared: tuple[Range, ...]
    match blade.profile:
        case Notch(e=e, depth=depth):
            sharp, over = _sharpness(blade, blade.profile)
            felt |= {"e/ρ": sharp, "e/depth": float(e / depth), "e/b": float(e) / blade.b}
            low, high = (LOW_NARROW, HIGH_NARROW) if over <= NARROW else (LOW, HIGH)
            compared, error = COMPARED, (low, high + HIGH_SHARP * sharp)
        case Filleted(h=h, r=r):
            felt |= {"h/r": float(h / r), "h/b": float(h) / blade.b}
            least = FILLETED_LOW if h <= r else SHARP_LOW
            compared, error = FILLETS_COMPARED, (least, FILLETED + FILLETED_WIDE * wide)
        case _:
            raise TypeError("only notches and fillets were compared with solids")
    return None if outside(compared, felt) else error


def hinge_range(
    blade: SpaceBlade | SpaceRod, rows: StressRows, acting: Floats
) -> tuple[float, float] | None:
    """Return between what the largest stress of a blade lies by what is unsure of hinges [Pa].

    ``acting`` are the nine forces and weights of ``rows``. On a notch, those in its plane, a moment
    about its thickness, and what shears it across leave their errors each of its own part of the
    stress, at every place; other hinges have that of :func:`hinge_error`, and nothing is told where
    that tells nothing.
    """
    across = hinge_error(blade)
    if across is None:
        return None

    def part(*columns: int) -> Floats:
        some = list(columns)
        return equivalent(rows.normal[:, some] @ acting[some], rows.shear[:, some] @ acting[some])

    whole = part(*range(9))
    if not isinstance(blade, SpaceBlade) or not isinstance(blade.profile, Notch):
        most = float(whole.max(initial=0.0))
        return most * (1.0 + across[0]), most * (1.0 + across[1])
    sharp, over = _sharpness(blade, blade.profile)
    held = blade.material.nu * min(over, 1.0)
    shallow = WITHIN_SHALLOW * float(blade.profile.e / blade.profile.depth)
    y, z = rows.offsets.T
    low = WITHIN_LOW + np.where(z != 0.0, EDGES * held + np.where(y == 0.0, SIDES, 0.0), 0.0)
    high = WITHIN + WITHIN_HELD * held + (WITHIN_SHEARED + shallow) * sharp
    within, bent, sheared, both = part(0, 1, 5, 6, 7), part(4), part(2, 3, 8), part(2, 3, 4, 8)
    alone = BENT_NARROW if over <= NARROW else BENT
    unsure = np.minimum(both, UNTWISTED * sheared.max())
    each = (alone[end] * bent + across[end] * unsure for end in (0, 1))
    # together they leave no more than as one
    less, more = (np.abs(one) for one in each)
    less, more = np.minimum(less, -across[0] * both), np.minimum(more, across[1] * both)
    return (
        float(np.max(whole + low * within - less)), float(np.max(whole + high * within + more))
    )  # fmt: skip


def _sharpness(blade: SpaceBlade, notch: Notch) -> tuple[float, float]:
    """Return e/ρ of a throat, and its width over √(e ρ)."""
    l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
    e, depth = float(notch.e), float(notch.depth)
    rho = l**2 / (4.0 * depth)
    return e / rho, blade.b / float(np.sqrt(e * rho))


def _is_hinge(blade: SpaceBlade) -> bool:
    return isinstance(blade.profile, Notch | Filleted)


def shear_spread(blade: SpaceBlade) -> float:
    """Return the largest shear stress across the width over its mean [-].

    1.5 of a beam; a throat that is wide against the length over which it gives way, √(e ρ), is
    sheared evenly.
    """
    if not isinstance(blade.profile, Notch):
        return 1.5
    return 1.0 + 0.5 / (1.0 + _sharpness(blade, blade.profile)[1] / EVEN)


def _sections(member: SpaceBlade, l: float) -> tuple[Floats, Floats, tuple[str, ...]]:
    """Return positions, thicknesses and names of the sections that are looked at."""
    if isinstance(member.profile, Constant):
        s, names = _ends_and_middle(l)
        return s, np.full(3, float(member.profile.h)), names
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
    varies = isinstance(member.profile, Notch | Filleted | Tabulated)
    if varies and not member.warps_freely:
        return _of_hinge(member, s, h)
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


def _of_hinge(blade: SpaceBlade, s: Floats, h: Floats) -> tuple[Floats, Floats]:
    """Return the same of a hinge between bodies that keep its ends from warping."""
    section = section_of(blade, blade.feels)
    mesh = mesh_of((section,), MESHED)
    rate, a, stiff = twist_rate(mesh), mesh.apart[0], mesh.warping[0]
    # E'Γ times the slope of what the sections warp by, whose mean is nought
    bimoment = mesh.J[0] @ (a * (mesh.torsion[0] * rate - 1.0))
    bimoment -= mesh.w[0] @ (bimoment / stiff) / (mesh.w[0] @ (1.0 / stiff))
    each = rate / a, rate + mesh.spin[0], bimoment / stiff / section.l
    by = [np.interp(s, mesh.s[0] * section.l, one / section.EI) for one in each]
    return twisted(blade, h, *by)


def twisted(
    blade: SpaceBlade, h: Floats, warps: Floats, turns: Floats, slope: Floats
) -> tuple[Floats, Floats]:
    """Return the shear at the faces of a blade, and the normal stress of its warping [Pa].

    By what its sections warp by and turn by per length [rad/m], and the slope of the first
    [rad/m²].
    """
    E, G, nu, b = blade.material.E, blade.material.G, blade.material.nu, blade.b
    shear = G * np.minimum(h, b) * ((shear_factor(h, b) - 0.5) * warps + 0.5 * turns)
    held = not blade.warps_freely
    return shear, held * E / (1.0 - nu**2) * warping(h, b).largest * slope


def _of_rod(member: SpaceRod, found: MemberSprings) -> StressRows:
    """Return the stresses around a round rod at its ends and in the middle."""
    d, l = member.d, found.l
    A, I = np.pi * d**2 / 4.0, np.pi * d**4 / 64.0
    s, names = _ends_and_middle(l)
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
        where.extend(names)
        offsets.extend([(between * y, between * z)] * len(s))
    found_normal = np.concatenate(normal)
    none = np.zeros_like(found_normal)
    return StressRows(
        found_normal, np.concatenate(shear), none, tuple(where),
        np.array(offsets), np.tile(s / l, AROUND),
    )  # fmt: skip


def _of_star(star: SpaceStar, found: MemberSprings) -> StressRows:
    """Return the stresses at the edges of a star's arms, and where its strips cross.

    There the strips share a force by what of it is along each, at ``3 V/A``: the parabola of each
    strip has its top on the axis. The shear of torsion is that of the faces, nearly up to the edge;
    the roots between two arms, whose stress is that of their fillet, are left out.
    """
    A, I, l = star.area, star.bent, found.l
    s, names = _ends_and_middle(l)
    N, V_y, V_z, T, M_y, M_z = _section_forces(s, l, found)
    twisted = T * star.sheared / star.torsion
    normal, shear, where = list[Floats](), list[Floats](), list[str]()
    offsets = list[tuple[float, float]]()
    for u, v in star.arms:
        for side in (1.0, -1.0):
            y, z = (star.b * a + side * star.h * c for a, c in ((u, -v), (v, u)))
            normal.append(N / A + (M_y * z - M_z * y) / (2.0 * I))
            shear.append(twisted)
            where.extend(f"{at}, edge of an arm" for at in names)
            offsets.extend([(y / star.d, z / star.d)] * len(s))
        normal.append(N / A)
        shear.append(twisted + 3.0 * (V_y * u + V_z * v) / A)
        where.extend(f"{at}, root of an arm" for at in names)
        offsets.extend([(0.0, 0.0)] * len(s))
    whole = np.concatenate(normal)
    return StressRows(
        whole, np.concatenate(shear), np.zeros_like(whole), tuple(where),
        np.array(offsets), np.tile(s / l, len(offsets) // len(s)),
    )  # fmt: skip


def _ends_and_middle(l: float) -> tuple[Floats, tuple[str, ...]]:
    """Return three places along a member of constant section [m], and their names."""
    return np.array([0.0, l / 2.0, l]), ("start", "middle", "end")
