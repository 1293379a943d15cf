"""How far beams and shells at stroke are off: bounds of what they were seen to be, and their range.

Beams were held against shells, and both against CalculiX's solids, over the range of ``SEEN``
(``tests/benchmarks/blades_at_stroke.py``). Outside of it nobody knows.
"""

from dataclasses import replace
from math import inf, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.amplified import amplified
from flexcli.formulas.card import Range
from flexcli.formulas.clamped_star import stiffer_across
from flexcli.formulas.profile import Constant, Filleted, NeckedDown, Notch, Tabulated
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.rotation import (
    conjugate,
    matrix_of,
    product,
    quaternion_of,
    vector_of,
)
from flexcli.mechanics.space.exact.stresses import section_states
from flexcli.mechanics.space.layout import Directed, SpaceBlade, SpaceRod, SpaceStar
from flexcli.mechanics.space.linear import SpaceAssembly
from flexcli.mechanics.space.springs import MemberSprings, springs_of
from flexcli.mechanics.space.warping_error import warping_error
from flexcli.results import ErrorRange

__all__ = [
    "AT_STROKE",
    "SEEN",
    "Bend",
    "StrokeErrors",
    "beam_errors",
    "hinges_more",
    "shell_errors",
    "springs_without_blocks",
    "strain_error",
    "warping_errors",
    "width_error",
]

Floats = NDArray[np.float64]


class StrokeErrors(NamedTuple):
    """Relative errors at a stroke beside that of the level: of what blades are made of.

    A critical load is as far off as the support stiffness that it takes away: beams at strokes were
    within 0.02 of shells in it.
    ``rest`` is what a motion beside the stroke may be off besides, however small it is [m].
    """

    support: float
    shift: float
    stress: float
    rest: float

    def stress_of(self, bent: float) -> float:
        """Return the error of a stress of which so much is what forces bend.

        ``bent`` [-] is that of :func:`bent_by_forces`: it is as far off as the stiffness is.
        """
        return self.stress + (amplified(bent, self.support) if bent else 0.0)


class Bend(NamedTuple):
    """How far a blade or rod is deformed, its end against its start.

    ``curve`` is the largest curvature of a cubic centre line with these ends across its
    thickness, times the length [-]; ``turn`` is the whole turn and ``twist`` that about it [rad];
    ``shift`` that of its end over its length [-].
    """

    curve: float
    turn: float
    twist: float
    shift: float


SEEN = {
    "slender": Range("h/l", 0.0, 0.25, "guides and pivots, strained by 0.5 to 3 %, against solids"),
    "rod": Range("d/l", 0.0, 0.05, "as a narrow blade"),
    "width": Range("b/l", 0.0, 3.0, "beams were held against shells from 0.1 to 3, rods besides"),
    "poisson": Range("ν", 0.0, 0.45, "sections curl by its square"),
    "shift": Range("shift of a blade's end over l", 0.0, 0.306, "guides up to 0.3 l, pivots 30°"),
    "curve": Range("curvature times l", 0.0, 1.84, "guides up to a stroke of 0.3 l"),
    "curl": Range("b² κ/h", 0.0, 3610.0, "b/l = 3, h/l = 1/333, a stroke of l/5"),
    "twist": Range("b² φ/(h l)", 0.0, 4.4, "coaxial blades, up to where wide ones buckle"),
}
"""Where beams were held against shells and solids."""

STRAINED, STRAINED_AT = 0.06, 0.3
"""Of what thermal forces change of a stiffness, what beams may be off, at this ν; by its square."""

WIDE, THICK, LONGEST = 2.0, 0.1, 0.204
"""Largest b/l, h/l and shift of a blade's end over l for which is told what thermal forces change.

Bridges between walls, to four fifths of what buckles them, against CalculiX's solids: the change is
within 4 % of its own at h/l 0.02 to 0.1 and b/l 0.2 to 1.5.
"""

EULER_SHEAR = 10.5
"""Share of (h/l)² by which shear lowers Euler's load of a clamped beam, 4π² E/(12 κ G), ν = 1/3."""

ROUNDING = 1e-9
"""Of a quantity at the very end of its range."""

SOLIDS = 0.012
"""Error of a support stiffness by thin shells, against solids of guides and pivots, b/l from 0.1
to 1.5: within 0.006, the solids themselves by their mesh within 0.008."""

SETTLED = 0.021
"""Beams over shells where no section curls: seen up to 0.0165 at ν = 0."""

CLAMPED, CLAMPED_MOST, CLAMPED_TO = 3.0, 0.17, 0.4
"""Times ν² b/l, and the most times ν², by which beams at a stroke are too soft where no section
curls: clamps keep it from narrowing over a length like b, which beams have for the shapes of rest.
Crossed pivots had, over CalculiX's solids, 0.08 ν² at b/l 0.05, 0.16 at 0.1 and 0.2 at 0.15 and
0.2, where sections curl besides, shells up to 0.03 ν² more; 0.06 at 0.5: from the last of these, in
l, it goes down."""

NARROW, NARROW_END, NARROW_WIDE, NARROW_STRAIN = 5e-3, 0.7, 0.05, 1.5
"""Error of a blade so narrow that it is a beam: by the meshes of solids, of the smaller side of its
section and of its width over its length, and of its strain. Solids of guides and pivots, b/l from
0.02 to 0.1 and h/l from 0.002 to 0.02, up to 30°, had 0.6 of what is told in all, mostly 0.3."""

WIDER, WIDER_FROM = 7e-3, 1.5
"""What they are besides, for each length that blades are wider than this many: 0.029 at ν = 0 and
b = 3 l in all."""

CURL = 5.0
"""Of b² κ/h, from which on the errors of sections that curl are as large as they get."""

SUPPORT_CURLED, MOMENT_CURLED = 0.36, 0.16
"""Times ν², what beams are too stiff where a section curls over a length no longer than its width:
in support and in their moments. Seen with what is told beside: 0.050 of the one at ν = 0.3 and
0.077 at ν = 0.45, 0.014 and 0.033 of the other (of 588 random guides and pivots against shells,
b/l 0.1 to 2)."""

MOMENTS = 6e-3
"""Nominal stress, where nothing curls and forces bend nothing. Of random guides and pivots under
loads out of the plane, b/l 0.02 to 1, h/l 0.002 to 0.1, beams were within 0.002 of CalculiX's
solids, 0.0035 at ν = 0.45 (``tests/benchmarks/moments_in_space.py``); within 0.004 of those of
single blades, whose meshes leave as much (``tests/benchmarks/blades_at_stroke.py``)."""

UNSEEN = 9e-3
"""Of the moments of rods and of blades that are stiffer one way, which were not looked at."""

THICK = 0.4
"""Share of (h/l)² besides: of what clamps do to the shear of a thick blade beams have no more than
its strip; square ones of l/10 were 0.02 too soft, h = l/5 and b = l 0.005. Of h = l/4, b/l
0.3 to 3, support stiffnesses were up to 0.046 and moments up to 0.042 less than those of solids at
ν = 0.45, 0.02 each at 0.34, none at 0."""

SHIFTED = 0.025
"""Besides, of the motion beside a stroke: what is left of it where blades shorten alike (a folded
stage) was 0.0225 off, that of guides and pivots 0.007."""

CANCELLED = 5e-4
"""Of l (θ² + t²) of a blade, θ and t l the turn and the shift of its end: what a motion beside the
stroke may be off in which the shortening of blades cancels. Beams were up to 5e-4 l θ² from shells
in crossed, triple and butterfly pivots."""

WIDTH, WIDTH_MOST = 0.17, 1.0
"""Times (b/l)², and the most: by how much more beams bear along their width than shells before they
turn aside, where their ends are kept from turning. Guides had 0.034 at b/l 0.5, 0.124 at 1 and
0.213 at 1.5, at ν = 0.3 and h/l 0.0025 and 0.01, 0.150 at ν = 0.45 and b/l 1; 0.18 at b/l 2 and
0.61 at 3, 0.64 there at ν = 0.45; cantilevers 0.01."""

HINGE_TURN, HINGE_TWIST, AT_STROKE = 0.21, 1e-3, 0.015
"""Turn of a hinge [rad], and that about itself, up to which its errors are those of its springs at
rest, and what a stroke adds: CalculiX's solids of notches at 5° have the ratios to beams that they
have at rest, within 0.01; those of a filleted blade at 12° are within 0.017 of beams."""

COMPARED = 0.087
"""Turn of a hinge [rad] from which on that counts in full: what a stroke changes is even in it. The
stiffness about the axis of two notches (e/r 0.1 and 0.25, b/e 15 and 4, ν 0.3 and 0.4), beams over
CalculiX's solids, differed from that at rest by 3e-5 and 5e-5 at 1°, 5e-5 and 1.4e-4 at 2°, 1e-4
and 3.4e-4 at 3°, and of the first 3e-4 at 5°: by the square of the turn."""

FLAT = 0.3
"""Of b² κ/h of a hinge, up to which it has the errors of rest at a stroke, however wide or thick:
necked-down stages of b up to 26 l_c bear along z what straight beams do, within 0.05 by solids."""

EDGE = 0.63
"""Share of h/b by which the edges of a section lessen Saint-Venant's b h³/3 of a thin strip."""

SHEAR = 3.2
"""Share of (h/l)² by which shear across the thickness softens an S shape, E/(κ G) at ν = 1/3."""

THICKEST, STOUTEST = 0.05, 0.2
"""Largest h/l and h/b for which a thin shell's error is told."""

STARRED, STAR_TWIST = 0.02, 2.7
"""Error of stars besides, at rest and twisted, and b² φ/(h l) up to which it was looked at: beams
were within 0.015 of CalculiX's solids, held in twist by φ of 0.3 to 0.9, b/l 0.2 to 0.4."""

ARMS = 0.75
"""Share of what may buckle the arms of a star up to which bending leaves them as they are."""

RIM = 0.03
"""Error of the stress at a clamp besides: polynomials swing there by a hundredth or two."""


def beam_errors(state: SpaceEquilibrium) -> StrokeErrors | None:
    """Return the errors of exact beams; nothing outside of what was looked at.

    Of hinges and of what varies in thickness nothing is known but the support stiffness.
    """
    curling, hinged, thick, directed, starred, wider = 0.0, 0.0, 0.0, 0.0, 0.0, 0.0
    settled = 0.0
    for blade in state.layout.blades:
        bend, l, own = _bend(state, blade), _length(blade), SOLIDS + SETTLED
        if isinstance(blade, SpaceStar):
            if not springs_of(blade).in_stress or _arms_may_buckle(state, blade):
                return None
            across = STARRED + stiffer_across(blade.b / l)
            starred = max(starred, across + SHEAR * (blade.h / l) ** 2)
            if blade.b**2 * bend.twist > STAR_TWIST * blade.h * l:
                return None
            felt = {"rod": blade.h / l, "shift": bend.shift, "curve": bend.curve}
        elif isinstance(blade, SpaceRod):
            felt = {"rod": blade.d / l, "shift": bend.shift, "curve": bend.curve}
        elif isinstance(blade.profile, Constant):
            b, h, nu = blade.b, float(blade.profile.h), blade.material.nu
            wide = b**2 / (h * l)
            felt = {
                "slender": h / l, "width": b / l, "poisson": nu, "shift": bend.shift,
                "curve": bend.curve, "curl": wide * bend.curve, "twist": wide * bend.twist,
            }  # fmt: skip
            curling = max(curling, nu**2 * min(wide * (bend.curve + bend.twist) / CURL, 1.0))
            own = _settled(h / l, b / l, nu, bend)
            if isinstance(blade.material, Directed):
                directed = max(directed, _most(springs_of(blade)))
        else:
            off = _hinge_error(blade, bend)
            if off is None:
                return None
            hinged = max(hinged, off)
            continue
        if any(value > SEEN[name].most * (1.0 + ROUNDING) for name, value in felt.items()):
            return None
        settled = max(settled, own)
        thick = max(thick, felt.get("slender", 0.0))
        wider = max(wider, felt.get("width", 0.0) - WIDER_FROM)
    besides = THICK * thick**2 + starred
    # solids of silicon at a stroke of 5 % have the ratios to beams that they have at rest
    support = settled + SUPPORT_CURLED * curling + WIDER * wider + besides + directed
    plain = all(
        isinstance(b, SpaceBlade) and not isinstance(b.material, Directed)
        for b in state.layout.blades
    )
    moments = MOMENT_CURLED * curling + besides
    shift = moments + SOLIDS + SHIFTED
    if starred:
        # ends that may warp are of no solid, and roots have the stress of their fillets
        return StrokeErrors(support, shift, inf, _cancelled(state))
    if hinged:
        support = max(support, hinged + AT_STROKE)
        return StrokeErrors(support, inf, inf, inf)
    crossed = _crossed(state)
    if crossed == inf:
        return None
    nominal = moments + MOMENTS + UNSEEN * (not plain)
    support, shift, moments = (each + crossed for each in (support, shift, nominal))
    return StrokeErrors(support, shift, moments, _cancelled(state))


def _crossed(state: SpaceEquilibrium) -> float:
    """Return what blades that are one piece where they cross may be stiffer or softer by."""
    ranges = (b.crossed for b in state.layout.blades if not isinstance(b, SpaceRod))
    return max((max(most - 1.0, 1.0 - least) for least, most in ranges), default=0.0)


def _settled(h: float, b: float, nu: float, bend: Bend) -> float:
    """Return the error of a support stiffness by blades whose sections do not curl.

    ``h`` and ``b`` are over the length of the blade.
    """
    clamped = min(CLAMPED * b, CLAMPED_MOST * min(CLAMPED_TO / b, 1.0)) * nu**2
    strain = bend.curve * h / 2.0
    narrow = NARROW + NARROW_END * min(h, b) + NARROW_WIDE * b + NARROW_STRAIN * strain
    return min(narrow + clamped, SOLIDS + max(SETTLED, clamped))


def _arms_may_buckle(state: SpaceEquilibrium, star: SpaceStar) -> bool:
    """Return whether bending may make a star's arms buckle, of which beams know nothing.

    That of an axial force alone, by which a star twists aside, is in beams.
    """
    at = section_states(state)[state.layout.blades.index(star)]
    return star.arms_bent(float(at.N.min()), float(np.hypot(at.M_y, at.M_z).max())) > ARMS


def width_error(assembly: SpaceAssembly, forces: Floats) -> float:
    """Return by how much less than beams blades may bear that are bent across their width.

    ``forces`` are those of the springs (rows,) [N, N·m] of a linear state. It counts in full from
    ``M l = π/2 √(EI GJ)`` on, by which no strip turns aside. Stars count by what may make their
    arms buckle.
    """
    most = 0.0
    for k, (blade, member) in enumerate(zip(assembly.layout.blades, assembly.members, strict=True)):
        if isinstance(blade, SpaceStar):
            arms = blade.arms_bent_by(member.l, forces[6 * k : 6 * k + 6])
            most = max(most, arms / ARMS - 1.0)
        if isinstance(blade, SpaceRod):
            continue
        l, stiffness = member.l, member.springs.stiffness
        M = abs(forces[6 * k + 4]) + abs(forces[6 * k + 2]) * l / 2.0
        felt = min(float(M / np.sqrt(stiffness[3] * stiffness[5])) / (pi / 2.0), 1.0)
        most = max(most, felt * min(WIDTH * (blade.b / l) ** 2, WIDTH_MOST))
    return most


def hinges_more(state: SpaceEquilibrium) -> float | None:
    """Return by how much more than at rest the springs of hinges may be off at a stroke.

    Nothing where one of the blades does not bend in hinges, or was not compared.
    """
    most = 0.0
    for blade in state.layout.blades:
        bend = _bend(state, blade)
        curled = _hinge_curled(blade, bend) if isinstance(blade, SpaceBlade) else None
        if curled is None:
            return None
        # even in the turn, it is less than in proportion below what was compared
        most = max(most, AT_STROKE * min(_hinge_turn(blade, bend) / COMPARED, 1.0) + curled)
    return most


def _hinge_error(blade: SpaceBlade, bend: Bend) -> float | None:
    """Return the error of the stiffness of a blade that bends in hinges, at a stroke."""
    curled = _hinge_curled(blade, bend)
    return None if curled is None else _most(springs_without_blocks(blade)) + curled


def springs_without_blocks(blade: SpaceBlade) -> MemberSprings:
    """Return the springs of a hinge as its beams are: its blocks are all in the error."""
    return springs_of(replace(blade, blocks=(0.0, blade.blocks[1])))


def _hinge_curled(blade: SpaceBlade, bend: Bend) -> float | None:
    """Return what curled sections are off besides in a hinge, None where it was not compared."""
    springs = springs_without_blocks(blade)
    turn, l, curls, wide = _hinge_turn(blade, bend), _length(blade), 0.0, 0.0
    match blade.profile:
        case NeckedDown(h=h, hinge=hinge):
            curls = blade.b**2 / float(h * hinge)
        case Filleted(h=h):
            curls = blade.b**2 / (float(h) * l)
        case Tabulated(thicknesses=h):
            curls = blade.b**2 / (float(min(h)) * l)
        case Notch(e=e, depth=depth):
            wide = blade.b**2 / (float(e) * l * float(e / depth) ** 0.5)
        case _:
            return None
    # sections that hardly curl are those of rest
    compared = springs.in_stress or max(curls, wide) * turn <= FLAT
    if not (springs.is_known and compared) or turn > HINGE_TURN or bend.twist > HINGE_TWIST:
        return None
    return SUPPORT_CURLED * blade.material.nu**2 * min(curls * turn / CURL, 1.0)


def _hinge_turn(blade: SpaceBlade | SpaceRod, bend: Bend) -> float:
    """Return the largest turn of the hinges of a blade [rad]."""
    if isinstance(blade, SpaceBlade) and isinstance(blade.profile, NeckedDown):
        # the body between the hinges turns by no more than this
        return bend.turn + bend.shift / (1.0 - float(blade.profile.hinge) / _length(blade))
    if isinstance(blade, SpaceBlade) and isinstance(blade.profile, Filleted | Tabulated):
        return max(bend.turn, bend.curve)
    return bend.turn


def _most(springs: MemberSprings) -> float:
    """Return the largest error of the springs of a blade at rest."""
    return float(max(np.max(springs.high), -np.min(springs.low)))


def warping_errors(state: SpaceEquilibrium) -> list[ErrorRange]:
    """Return the error of the stress of restrained warping of each blade, as far as it curls."""
    found = []
    for blade in state.layout.blades:
        curled = 0.0
        if isinstance(blade, SpaceBlade) and isinstance(blade.profile, Constant):
            bend, wide = _bend(state, blade), blade.b**2 / (float(blade.profile.h) * _length(blade))
            curled = min(wide * (bend.curve + bend.twist) / CURL, 1.0)
        found.append(warping_error(blade, curled))
    return found


def strain_error(state: SpaceEquilibrium) -> float | None:
    """Return by what share of itself what thermal forces change of a stiffness may be off.

    Thicker blades and rods shear as they bend. Nothing where nobody compared.
    """
    most = 0.0
    for blade in state.layout.blades:
        l, nu = _length(blade), blade.material.nu
        if isinstance(blade, SpaceRod):
            wide, thick = 0.0, blade.d / l
        elif isinstance(blade.profile, Constant):
            wide, thick = blade.b / l, float(blade.profile.h) / l
        else:
            return None
        if wide > WIDE or thick > THICK + ROUNDING or _bend(state, blade).shift > LONGEST:
            return None
        bent = STRAINED * max(1.0, (nu / STRAINED_AT) ** 2)
        most = max(most, bent + EULER_SHEAR * thick**2)
    return most


def shell_errors(state: SpaceEquilibrium) -> StrokeErrors | None:
    """Return the errors of thin shells: what they carry of neither shear nor edges.

    That against solids grows in proportion beyond the range in which they were compared.
    """
    thin, beyond = 0.0, 1.0
    for blade in state.layout.blades:
        if isinstance(blade, SpaceRod):
            continue
        if not isinstance(blade.profile, Constant):
            return None
        h, l = float(blade.profile.h), _length(blade)
        if h > THICKEST * l or h > STOUTEST * blade.b:
            return None
        thin = max(thin, EDGE * h / blade.b + SHEAR * (h / l) ** 2)
        felt = {
            "width": blade.b / l,
            "poisson": blade.material.nu,
            "shift": _bend(state, blade).shift,
        }
        beyond = max(beyond, *(value / SEEN[name].most for name, value in felt.items()))
    support = SOLIDS * beyond + thin + _crossed(state)
    if support == inf:
        return None
    return StrokeErrors(support, support, support + RIM, _cancelled(state))


def _cancelled(state: SpaceEquilibrium) -> float:
    """Return what a motion beside the stroke may be off in which shortening cancels [m]."""
    each = ((_length(blade), _bend(state, blade)) for blade in state.layout.blades)
    return max(CANCELLED * l * (bend.turn**2 + bend.shift**2) for l, bend in each)


def _bend(state: SpaceEquilibrium, blade: SpaceBlade | SpaceRod) -> Bend:
    """Return how far a blade or rod is deformed in a state; a rod bends in any direction."""
    first, second = state.quaternion(blade.first), state.quaternion(blade.second)
    l, axes = _length(blade), blade.axes
    apart = np.subtract(blade.end, blade.start)
    shifted = state.shift_of(blade.second, blade.end) - state.shift_of(blade.first, blade.start)
    missed = state.part.demand.off(state.part.share)
    if missed is not None and state.layout.blades[missed.blade] is blade:
        shifted = shifted + matrix_of(second) @ missed.offset[:3]
        second = product(second, quaternion_of(missed.offset[3:]))
    # as seen from the start, along the blade's own axes
    t = axes @ (matrix_of(conjugate(first)) @ (apart + shifted) - apart) / l
    theta = axes @ vector_of(product(conjugate(first), second))
    # w″ l at both ends of w = (3t − θ) x² + (θ − 2t) x³
    curve = max(abs(6.0 * t[1] - 2.0 * theta[2]), abs(6.0 * t[1] - 4.0 * theta[2]))
    if isinstance(blade, SpaceRod):
        other = max(abs(6.0 * t[2] + 2.0 * theta[1]), abs(6.0 * t[2] + 4.0 * theta[1]))
        curve = float(np.hypot(curve, other))
    turn = float(np.linalg.norm(theta))
    return Bend(float(curve), turn, float(abs(theta[0])), float(np.linalg.norm(t)))


def _length(blade: SpaceBlade | SpaceRod) -> float:
    return float(np.linalg.norm(np.subtract(blade.end, blade.start)))
