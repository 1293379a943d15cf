"""A blade or rod of a mechanism in space as six springs, with the error of each."""

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.bar_limits import ROUND_FACTOR, BarLimits, bar_limits
from flexcli.formulas.blade_spring import SHEAR_FACTOR, BladeSprings, bending, blade_springs
from flexcli.formulas.card import Range, outside
from flexcli.formulas.clamped_blade import (
    NARROWER,
    OF_RODS,
    VALIDITY,
    ClampedSprings,
    clamped_blade,
    clamped_rod,
)
from flexcli.formulas.clamped_star import OF_STARS, STRESSED, clamped_star
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.formulas.torsion_section import torsion_constant
from flexcli.formulas.torsion_shapes import (
    star_area,
    star_arm,
    star_core_error,
    star_polar_moment,
    star_torsion_constant,
)
from flexcli.mechanics.space.exact.mesh import Mesh, mesh_of
from flexcli.mechanics.space.exact.section import section_of
from flexcli.mechanics.space.layout import Directed, Isotropic, SpaceBlade, SpaceRod, SpaceStar

__all__ = [
    "HINGES",
    "NODES",
    "STRETCH",
    "STRIP_CONSTRAINTS",
    "MemberSprings",
    "springs_of",
    "twist_rate",
]

Floats = NDArray[np.float64]

TURNED = [0, 2, 1, 3, 5, 4]
"""The springs of a blade whose thickness and width change places."""

STRETCH = (0,)
"""The spring of a rod that constrains: along it."""

STRIP_CONSTRAINTS = (0, 2, 4)
"""The springs of a blade that constrain: along it, across its width, bending of its width."""


BENDING = (0, 1, 5)
"""The springs of stretching and of bending across the thickness."""

HINGES = (
    Range("e/ρ", most=1.0, why="blunter notches were not compared with solids"),
    Range("2 depth/l", most=2.0, why="deeper notches were not compared with solids"),
    Range("e/b", most=1.0, why="throats thicker than wide were not compared with solids"),
    Range("b/l", most=30.0, why="wider ones were not compared with solids"),
    Range("ν", most=0.5, why="no solid has more"),
)
"""Hinges that were compared, ρ the radius of the throat; fillets are half a notch at either end."""

THICKEST, DEEP = 4.0, 0.4
"""Largest e/b, at rest, of throats of at most so many depths: our solids of 53 such notches (e/ρ
0.006 to 0.8, 2 depth/l 0.3 to 2, ν to 0.45) and of 36 blades with fillets (ν to 0.4) were within
what is told of wider ones, by 8e-4 at least; shallow thick ones were not."""

WIDE, THICK_WIDE = 8.0, 0.4
"""b/l from which on hinges are wide: of those none was compared at a stroke, nor any of which e/l
is more."""

OF_WIDE = 1.6
"""On by how much a wide one is stiffer at most: kept from narrowing and from thinning at once.
Solids of b/l from 8 to 31 and ν up to 0.49 had 0.9 of that, and were as soft as others at most."""

STRAIGHT = 0.01
FLANKS = np.array([0.15, 0.1, 0.15, 0.14, 0.13])
THROATS = np.array([0.45, 0.45, 0.45, 0.5, 0.45])
FLANK_BENT = 0.22
"""By how much less than its beam between rigid clamps a notch is stiff at most in five springs: the
flow of forces leaves steep flanks behind, the second per 2 depth/l, the third per √(e/ρ) of that,
as a sharp throat gives way more than its flanks; bending across the width under V_z is that of the
flanks, per 2 depth/l, by its share. CalculiX's solids (``tests/benchmarks/hinges_in_space.py``) and
ours of e/ρ from 0.0006 and ν to 0.49 had 0.117, 0.091, 0.12, 0.13 and 0.117 of the second, 0.39,
0.33, 0.39, 0.35 and 0.31 of the third, and 0.19 of the last."""

SOFT_SHEARED, SOFT_TWISTED = 0.1, 0.54
"""The same besides of V_y and of torsion per ν²: throats as wide as two to five times √(e ρ) had
0.078 and 0.5 of it, however shallow or sharp."""

NARROWS, KEPT, KEPT_MOST = 0.02, 0.15, 0.2
OVER_WIDTH, OVER_LENGTH = 0.03, 0.25
"""By how much more: a throat is kept from narrowing, under V_y the second per b/l; along it and
across its width, of what a plate that is kept straight across has, a share per b/√(e ρ) beyond 1
and one per b/l; by no more than such a plate, and 0.01. Where its shear counts it is sheared
evenly, and always in torsion warped, by the third or by that. Solids had 0.03 of it at
b = 3.5 √(e ρ) and 0.39 at 15, where b is 0.2 and 0.75 l, 0.34 at 4.1, where b is 1.3 l; in V_z and
in torsion 0.191 and 0.15 at most."""

FILLETED_POISSON = 0.4
"""Largest ν of blades with fillets that were compared at a stroke."""

THROAT, THROAT_HIGH = 0.5, 0.02
"""Share of e/ρ by which a throat may bend more than its beam, and of its stiffness what it may be
off besides, or ν²/6; solids had 0.87 of that, and none was stiffer."""

FILLETED, FILLETED_SOFT, LONG = 0.07, 0.12, 4.0
"""The same of blades with fillets of a radius of at most l over this; solids had 0.053, and of ν
beyond 0.4 they were stiffer by 0.092."""

SHARP = (
    Range("h/r", most=4.0, why="sharper fillets were not compared with solids"),
    Range("h/l", most=1.0 / 6.0, why="thicker ones were not compared with solids"),
    Range("h/b", most=1.0, why="blades thicker than wide were not compared with solids"),
    Range("b/l", most=1.4, why="wider ones were not compared with solids"),
)
"""Blades thicker than the radius of their fillets that have the same errors: 24 solids were within
0.054 below and 0.033 above, 0.067 of ν beyond 0.4."""

TAPERS = (
    Range("dh/ds", most=0.13, why="steeper tapers were not compared with solids"),
    Range("h_max/h_min", most=4.0, why="tapers of more were not compared with solids"),
    Range("h_max/l", most=0.12, why="thicker ones were not compared with solids"),
    Range("h_max/b", most=1.0, why="tapers thicker than wide were not compared with solids"),
    Range("b/l", most=0.85, why="wider ones were not compared with solids"),
    Range("ν", most=0.4, why="no other was compared"),
)
"""Tapers that were compared, dh/ds the slope of the thickness."""

TAPERED, TWISTED = 0.035, 0.06
"""How far the springs of a taper may be off, and by how much less it is stiff in torsion at most:
solids were within 0.012 below and 0.022 above, 0.036 below in torsion."""

NODES = 32
"""Gauss nodes on a piece of a hinge."""

SPREAD = 0.5
"""Over how much of the height of the mouth forces spread into blocks, or end at a rigid body: by
so much a block may be longer or shorter than the bar that it is taken for."""

WARPED = 0.25
"""By what share more a hinge may twist between blocks than between rigid bodies, which keep its
ends flat. Solids had 0.07 of that beyond what is told between rigid bodies."""

SHEARED = 1.2
"""1/κ of a rectangle in shear."""


class MemberSprings(NamedTuple):
    """Six springs of a blade or rod and the relative errors they lie between.

    ``low`` and ``high`` have shape (6,): true = stiffness · (1 + error); a high of infinity says
    that clamps stiffen by an unknown amount. ``axes`` are the blade's as rows, ``l`` is its
    length [m], ``constrains`` lists the springs that an ideal blade is rigid in. ``is_known``
    says that its proportions are those for which the errors were compared, ``is_bounded`` that they
    hold all the same, ``in_stress`` that they are those for which nominal stresses, and hinges at a
    stroke, were compared.
    """

    springs: BladeSprings
    low: Floats
    high: Floats
    axes: Floats
    l: float
    constrains: tuple[int, ...]
    is_known: bool = True
    in_stress: bool = True
    is_bounded: bool = False


def springs_of(member: SpaceBlade | SpaceRod) -> MemberSprings:
    """Return the springs of a blade or rod.

    Blades and hinges of constant thickness, and tapers, have the factors of plates and sheets,
    notches and blades with fillets that of their plate in bending. What is thicker than wide is a
    blade turned by a right angle about its length; where it is stiffer one way, a beam that may
    warp, and stiffer between clamps by an unknown amount. Of what is one piece with another where
    they cross all springs may be as much stiffer or softer.
    """
    if isinstance(member, SpaceBlade) and member.crossed != (1.0, 1.0):
        least, most = member.crossed
        alone = springs_of(replace(member, crossed=(1.0, 1.0)))
        low, high = (1.0 + alone.low) * least - 1.0, (1.0 + alone.high) * most - 1.0
        return alone._replace(low=low, high=high)
    l = float(np.linalg.norm(np.subtract(member.end, member.start)))
    material = member.material
    if isinstance(member, SpaceStar):
        star = clamped_star(
            E=material.E, G=material.G, h=member.h, l=l, b=member.b, strips=member.strips
        )
        felt = {
            "b/l": member.b / l, "h/b": member.h / member.b, "ν": round(material.nu, 9),
            "arm/h": float(star_arm(member.h, member.b, member.strips)), "strips": member.strips,
        }  # fmt: skip
        known = not outside(OF_STARS, felt)
        stressed = known and member.h <= STRESSED * member.b
        found = _at_middle(star, (known, stressed), member.axes, l, STRETCH)
        return found if known else _bounded_star(member, found)
    if isinstance(member, SpaceRod):
        rod = clamped_rod(E=material.E, G=material.G, d=member.d, l=l)
        known = not outside(OF_RODS, {"d/l": member.d / l})
        found = _at_middle(rod, (known, known), member.axes, l, STRETCH)
        return found if known else _bounded_rod(member, found)
    match member.profile:
        case Constant(h=h) if h <= member.b or isinstance(material, Isotropic):
            blade, compared = _clamped(member, float(h), l)
            found = _at_middle(blade, compared, member.axes, l, STRIP_CONSTRAINTS)
            plain = isinstance(material, Isotropic) and member.feels.plate
            return _bounded(member, found, float(h)) if plain and not compared[0] else found
        case NeckedDown(h=h, hinge=hinge) if h <= member.b or isinstance(material, Isotropic):
            each, compared = _clamped(member, float(h), float(hinge))
            both = _in_series(each, (l - float(hinge)) / 2.0)
            return _at_middle(both, compared, member.axes, l, STRIP_CONSTRAINTS)
        case Notch() | Filleted() | Tabulated():
            return _hinge(member, l)
        case _:
            beam = blade_springs(
                profile=member.profile, l=l, b=member.b, E=material.E, G=material.G
            )
            # no plate is stiffer than one that is kept straight across; how much shear and
            # warping are held back across the width and in torsion nobody has compared
            high = np.full(6, np.inf)
            high[list(BENDING)] = 1.0 / (1.0 - material.nu**2) - 1.0
            return MemberSprings(beam, np.zeros(6), high, member.axes, l, STRIP_CONSTRAINTS)


def _bounded(blade: SpaceBlade, found: MemberSprings, h: float) -> MemberSprings:
    """Return the springs of a blade that was compared with nothing, between what any bar has."""
    E, G, b = blade.material.E, blade.material.G, blade.b
    limits = bar_limits(
        E=E, G=G, l=found.l, area=b * h, I_y=h * b**3 / 12.0, I_z=b * h**3 / 12.0,
        J=float(torsion_constant(h, b)), shear_factor=SHEAR_FACTOR,
    )  # fmt: skip
    return _between_limits(found, limits)


def _bounded_rod(rod: SpaceRod, found: MemberSprings) -> MemberSprings:
    """Return the same of a round rod."""
    area, I = np.pi * rod.d**2 / 4.0, np.pi * rod.d**4 / 64.0
    limits = bar_limits(
        E=rod.material.E, G=rod.material.G, l=found.l, area=area, I_y=I, I_z=I, J=2.0 * I,
        shear_factor=ROUND_FACTOR,
    )  # fmt: skip
    return _between_limits(found, limits)


def _bounded_star(star: SpaceStar, found: MemberSprings) -> MemberSprings:
    """Return the same of a star."""
    E, G, n = star.material.E, star.material.G, star.strips
    across = float(star_polar_moment(star.h, star.b, n)) / 2.0
    J = float(star_torsion_constant(star.h, star.b, n))
    J -= star_core_error(float(star_arm(star.h, star.b, n)), n) * star.h**4
    area = float(star_area(star.h, star.b, n))
    limits = bar_limits(E=E, G=G, l=found.l, area=area, I_y=across, I_z=across, J=max(J, 0.0))
    return _between_limits(found, limits)


def _between_limits(found: MemberSprings, limits: BarLimits) -> MemberSprings:
    k = found.springs.stiffness
    low, high = limits.least / k, limits.most / k
    inside = np.clip(k, limits.least, limits.most) / k
    springs = found.springs._replace(stiffness=k * inside)
    low, high = np.minimum(low / inside, 1.0) - 1.0, np.maximum(high / inside, 1.0) - 1.0
    return found._replace(springs=springs, low=low, high=high, is_bounded=True)


def _clamped(blade: SpaceBlade, h: float, l: float) -> tuple[ClampedSprings, tuple[bool, bool]]:
    """Return the springs of a stretch of constant thickness, and what of it was compared.

    That is whether its errors are known, and whether those of its stress are.
    """
    if h > blade.b:
        turned, known = _clamped(replace(blade, b=h), blade.b, l)
        return ClampedSprings(*(each[TURNED] for each in turned)), known
    material = blade.material
    across = material.across if isinstance(material, Directed) else None
    b = blade.b if across is None else max(1.0, across.wider) * blade.b
    in_stress, in_springs = (
        not outside(ranges, {"h/l": h / l, "b/l": b / l}) for ranges in (NARROWER, VALIDITY)
    )
    found = clamped_blade(E=material.E, G=material.G, h=h, l=l, b=blade.b, across=across)
    if blade.warps_freely:
        found.stiffness[3] = material.G * float(torsion_constant(h, blade.b)) / l
        found.low[3] = found.high[3] = 0.0
    if not blade.feels.plate:
        beam = blade_springs(profile=Constant(h), l=l, b=blade.b, E=material.E, G=material.G)
        bent = [0, 1, 2, 4, 5]
        found.stiffness[bent] = beam.stiffness[bent]
    return found, (in_springs if across is None else in_stress, in_stress)


def _in_series(hinge: ClampedSprings, arm: float) -> ClampedSprings:
    """Return two hinges, whose middles are an arm from that of the rigid body between them [m]."""
    C = 2.0 / hinge.stiffness
    C[1] += C[5] * arm**2
    C[2] += C[4] * arm**2
    low, high = hinge.low.copy(), hinge.high.copy()
    low[1], low[2] = min(low[1], low[5]), min(low[2], low[4])
    high[1], high[2] = max(high[1], high[5]), max(high[2], high[4])
    return ClampedSprings(1.0 / C, low, high)


def _hinge(blade: SpaceBlade, l: float) -> MemberSprings:
    """Return a blade of varying thickness: its beams at rest, with what solids tell of it."""
    section = section_of(blade, blade.feels)
    mesh = mesh_of((section,), NODES)
    s, w, C = mesh.s[0], mesh.w[0], mesh.C[0]
    axial, sheared_y, sheared_z = w @ C
    across_thickness, turn_z, bent_y = bending(s, w / (1.0 + mesh.clamped[0]))
    across_width, turn_y, bent_z = bending(s, w * mesh.bend_y[0])
    twist = w @ (twist_rate(mesh) + mesh.spin[0])
    flexible = [axial, bent_y + sheared_y, bent_z + sheared_z, twist, turn_y, turn_z]
    stiffness = section.EI / np.array(flexible) / np.repeat([l**3, l], 3)
    springs = BladeSprings(stiffness, across_thickness * l, across_width * l)
    low, high, known, at_stroke = _hinge_errors(blade, l, float(sheared_z / (bent_z + sheared_z)))
    known = known and not isinstance(blade.material, Directed)  # of which no solid was made
    if isinstance(blade.profile, Filleted) and isinstance(blade.material, Isotropic):
        ends = float(blade.profile.h), float(blade.profile.r)
        errors = (low, high) if known else (np.full(6, -1.0), np.full(6, np.inf))
        stiffness, low, high, surely = _between_blades(blade, l, ends, stiffness, errors)
        springs, known = springs._replace(stiffness=stiffness), known or surely
    if any(blade.blocks):
        springs, low, high = _between_blocks(blade, l, springs, low, high)
    return MemberSprings(springs, low, high, blade.axes, l, STRIP_CONSTRAINTS, known, at_stroke)


def _between_blades(
    blade: SpaceBlade,
    l: float,
    ends: tuple[float, float],
    stiffness: Floats,
    errors: tuple[Floats, Floats],
) -> tuple[Floats, Floats, Floats, bool]:
    """Return the springs of a blade with fillets, their errors, and whether they are known so.

    ``ends`` are its thickness between them and their radius.
    It is no softer than the blade without its fillets, no stiffer than one that ends where they
    begin: what is added to a body, and what of it is made rigid, stiffens it against any load.
    """
    h, r = ends
    soft, (known, _) = _clamped(blade, h, l)
    least = soft.stiffness * (1.0 + soft.low)
    most = np.full(6, np.inf)
    if l > 2.0 * r:
        stiff, (compared, _) = _clamped(replace(blade, warps=False), h, l - 2.0 * r)
        most = stiff.stiffness * (1.0 + stiff.high) if compared else most
    if not known:
        return stiffness, *errors, False
    low, high = np.maximum(least, stiffness * (1.0 + errors[0])), stiffness * (1.0 + errors[1])
    high = np.maximum(np.minimum(most, high), low)
    middle = np.clip(stiffness, low, high)
    return middle, low / middle - 1.0, high / middle - 1.0, True


def twist_rate(mesh: Mesh) -> Floats:
    """Return the twist of a single blade that warping takes part in, per torque along it (K,)."""
    twist = mesh.twist[0]
    held = np.diag(mesh.hold[0]) + twist * mesh.torsion[0]
    return np.asarray(np.linalg.solve(held, twist.sum(axis=1)))


def _between_blocks(
    blade: SpaceBlade, l: float, springs: BladeSprings, low: Floats, high: Floats
) -> tuple[BladeSprings, Floats, Floats]:
    """Return the springs of a hinge with the blocks beside it, and their errors."""
    H, (least, most) = blade.profile.mouth(l), blade.blocks
    alone, whole = 1.0 / springs.stiffness, 1.0 / springs.stiffness + _bars(blade, l, H, least)
    stiffer = (1.0 - blade.material.nu**2) * _bars(blade, l, H, max(0.0, least - SPREAD * H))
    softer = _bars(blade, l, H, most + SPREAD * H)
    found = BladeSprings(1.0 / whole, springs.across_thickness, springs.across_width)
    softer[3] += WARPED * alone[3]
    low = whole / (alone / (1.0 + low) + softer) - 1.0
    with np.errstate(divide="ignore"):  # where nothing is known of how stiff it is
        high = whole / (alone / (1.0 + high) + stiffer) - 1.0
    return found, low, high


def _bars(blade: SpaceBlade, l: float, H: float, L: float) -> Floats:
    """Return six compliances of two bars of height H and length L beside a hinge of length l.

    They are about its middle, in the order of its springs [m/N, rad/(N·m)].
    """
    E, G, b, near = blade.material.E, blade.material.G, blade.b, l / 2.0
    arms = 2.0 / 3.0 * ((near + L) ** 3 - near**3)
    I_y, I_z = H * b**3 / 12.0, b * H**3 / 12.0
    sheared = 2.0 * SHEARED * L / (G * b * H)
    twisted = 2.0 * L / (G * float(torsion_constant(H, b)))
    return np.array(
        [2.0 * L / (E * b * H), arms / (E * I_z) + sheared, arms / (E * I_y) + sheared, twisted,
         2.0 * L / (E * I_y), 2.0 * L / (E * I_z)]
    )  # fmt: skip


def _hinge_errors(blade: SpaceBlade, l: float, sheared: float) -> tuple[Floats, Floats, bool, bool]:
    """Return the errors of a hinge's springs, and whether such ones were compared.

    That is at rest, and at a stroke and in stress. ``sheared`` is the share that shear has of what
    gives way under V_z.
    """
    nu = round(blade.material.nu, 9)  # of E and G, it is off by digits
    match blade.profile:
        case Tabulated():
            return *_taper_errors(blade, l, nu), True
        case Notch(e=e, depth=depth):
            reach = l / 2.0
        case Filleted(h=e, r=depth):
            reach = depth
            if l >= LONG * depth:
                soft = nu > FILLETED_POISSON
                high = np.full(6, FILLETED_SOFT if soft else FILLETED)
                blunt, thick = bool(e <= depth), float(e)
                felt = {"h/r": thick / float(depth), "h/l": thick / l, "h/b": thick / blade.b}
                known = blunt or not outside(SHARP, felt | {"b/l": blade.b / l})
                return np.full(6, -FILLETED), high, known, blunt and not soft
        case _:
            raise TypeError("only notches and fillets were compared with solids")
    sharp, deep, wide = float(e) * float(depth) / reach**2, float(depth) / reach, blade.b / l
    at = {"e/ρ": sharp, "2 depth/l": deep, "e/b": float(e) / blade.b, "b/l": wide, "ν": nu}
    # over √(e ρ), along which the throat gives way
    over = blade.b / reach * deep / sharp**0.5
    low, high = _notch_errors(sharp, deep, (wide, over), nu, sheared)
    thick = at["e/b"] > 1.0
    if thick and at["e/b"] <= THICKEST and e <= DEEP * depth:
        at["e/b"] = 1.0  # as well known as those
    known, is_wide = not outside(HINGES, at), wide > WIDE
    if is_wide:
        high[:5] *= OF_WIDE
        known = known and float(e) <= THICK_WIDE * l
    if isinstance(blade.profile, Filleted):
        known = known and nu <= FILLETED_POISSON and not is_wide
    return low, high, known, not (is_wide or thick)


def _notch_errors(
    sharp: float, deep: float, wide: tuple[float, float], nu: float, sheared: float
) -> tuple[Floats, Floats]:
    """Return the errors of a notch of e/ρ = ``sharp`` and 2 depth/l = ``deep``.

    ``wide`` is its width over its length and over √(e ρ).
    """
    flanks = np.minimum(FLANKS, THROATS * sharp**0.5) * deep
    flanks[2] = sheared * flanks[2] + (1.0 - sheared) * FLANK_BENT * deep
    flanks[[1, 3]] += SOFT_SHEARED * nu**2, SOFT_TWISTED * nu**2
    turn = -THROAT * sharp / (1.0 + THROAT * sharp) - max(THROAT_HIGH, nu**2 / 6.0)
    low = np.append(-STRAIGHT - flanks, turn)
    flat = nu**2 / (1.0 - nu**2) + 0.01
    most = max(KEPT_MOST, flat)
    kept = OVER_WIDTH * max(wide[1] - 1.0, 0.0) + OVER_LENGTH * wide[0]
    along = min(NARROWS + kept * flat, flat)
    bent = min(NARROWS + KEPT * wide[0] * most / KEPT_MOST, flat)
    across = min(NARROWS + sheared * most, most)
    return low, np.array([along, bent, across, most, along, THROAT_HIGH])


def _taper_errors(blade: SpaceBlade, l: float, nu: float) -> tuple[Floats, Floats, bool]:
    """Return the errors of the springs of a taper, and whether such ones were compared."""
    ends = np.array([-1.0, 1.0])
    h = np.array([piece.thickness(ends) for piece in blade.profile.pieces(l)])
    s = np.array([piece.position(ends) for piece in blade.profile.pieces(l)])
    steep = np.abs(np.diff(h)) / np.diff(s)
    most = float(h.max())
    at = {
        "dh/ds": float(steep.max()), "h_max/h_min": most / float(h.min()), "h_max/l": most / l,
        "h_max/b": most / blade.b, "b/l": blade.b / l, "ν": nu,
    }  # fmt: skip
    low = np.full(6, -TAPERED)
    low[3] = -TWISTED
    return low, np.full(6, TAPERED), not outside(TAPERS, at)


def _at_middle(
    found: ClampedSprings,
    known: tuple[bool, bool],
    axes: Floats,
    l: float,
    constrains: tuple[int, ...],
) -> MemberSprings:
    middle = np.asarray(l / 2.0)
    springs = BladeSprings(found.stiffness, middle, middle)
    return MemberSprings(springs, found.low, found.high, axes, l, constrains, *known)
