"""Wide blades in the shift of a drawn layout: each bends and shortens otherwise than its beam."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas import plate_factors as plates
from flexcli.formulas.blade_spring import middle_stiffness
from flexcli.formulas.plate_factors import bound, effective_width
from flexcli.formulas.plate_flattening import flat_width, secant_factor
from flexcli.formulas.plate_shortening import pure_shortening_factor, s_shortening_factor
from flexcli.mechanics.layout import Layout, Support
from flexcli.mechanics.space.layout import SpaceBlade, Vector
from flexcli.mechanics.space.linear import SpaceAssembly, assemble
from flexcli.mechanics.space.planar import from_plane
from flexcli.parts.bending.base import UNEVEN
from flexcli.parts.bending.plate_range import along_factor, blade_factor, is_compared
from flexcli.parts.geometries.base import MOVING, Blade, Held

__all__ = ["DrawnPath", "drawn_path"]

Floats = NDArray[np.float64]

GUIDED = 6.0
"""Shortening of a guided blade, 3x²/(5l), over the part of its S shape beside its chord,
x²/(10l)."""

FITS = 2e-3, 5e-4
"""Errors of the factors of shortening, of an arc and of an S."""

THICKEST = 0.3
"""Largest h/l of blades of which it is known how plates shorten; of thicker ones all that plates
change of it counts as an error."""

PLANE = ALONG, ACROSS, TURN = [0, 1, 5]
"""Springs of a blade in its plane: along it, of its S shape and of its arc."""

RIGID = 1e6
"""Stiffness of a guide over that of the blades."""

SHELLS, FLOOR = 0.2, 0.01
"""By what shells differ besides: a share of all that plates change, one of their widening.

Shells of random pivots and stages, drawn unevenly (``tests/benchmarks/drawn_shifts.py``)."""

CANCELLED = 0.1
"""Error from which on the parts of a stage's blades, all alike, tell less than that they cancel."""

HIGHER, MOST = 2.0, 3.0
"""What may come of higher order over all that plates change: for each order, and at most."""

NARROW, ALIKE, ROUNDING = 0.2, 1.35, 1e-13
"""Blades all alike, b/l to 0.2, whose shortening cancels to rounding: the shift is of fourth order.

Plates then change it by up to twice 1.35 times what an arc shortens, the less the more they are
flattened. Thin shells of folded stages of b/l 0.08 to 0.25, ν 0.3 and 0.45, strokes of 0.01 to
0.25 l, had 1.0 to 2.5 times that (``tests/benchmarks/shell_shifts.py``)."""


class _Orders(NamedTuple):
    """How the centre moves in first and second order of a unit travel (2, 2) [m].

    ``each`` are the parts of the second that blades alone are of (2, blades), which may cancel;
    ``tension`` is the largest axial force by it, of either sense [EI/l²], ``lever`` the largest
    motion of the centre over what a blade grows by [-].
    """

    whole: Floats
    each: Floats
    tension: float
    lever: float


class DrawnPath(NamedTuple):
    """The path of a layout's centre by its beams and by its plates.

    ``off`` is how far either order of the plates' may be off (2,), ``flat`` how much further
    where curvature keeps all sections from curling, ``curls`` the square of the largest width over
    that on which they do, at a unit travel. ``slope`` is the largest rotation of a body or of a
    chord there, ``cancels`` says that they are those of a stage whose blades are all alike, and
    ``arc`` by how much more of those an arc shortens, where they are narrow.
    """

    beams: _Orders
    plates: _Orders
    off: Floats
    flat: Floats
    curls: float
    poisson_ratio: float
    slope: float
    cancels: bool
    arc: float | None

    def change(self, ends: Sequence[float]) -> tuple[float, float] | None:
        """Return the relative change of the largest shift at travels, and its error [-].

        None where that is of higher than second order, or wide blades alike cancel. What is of the
        third, where the blades hold the centre by a long lever or pull, may change by all that
        its parts do.
        """
        travel = max(map(abs, ends))
        beam, plate = (
            max(float(np.hypot(*(end * path.whole[0] + end**2 * path.whole[1]))) for end in ends)
            for path in (self.beams, self.plates)
        )
        order, slope = np.array([travel, travel**2]), self.slope * travel
        apart = order[1] * float(np.linalg.norm(self.beams.each, axis=0).sum())
        if self.cancels and self.arc is not None and beam <= ROUNDING * apart:
            return ALIKE * self.arc, ALIKE * self.arc
        if beam <= slope**2 * apart:
            return None
        beta = float(np.sqrt(self.curls * travel))
        flattened = float(secant_factor(beta=beta, poisson_ratio=self.poisson_ratio)) - 1.0
        share = flattened / float(bound(self.poisson_ratio)) if flattened > 0.0 else 0.0
        parts = float(np.linalg.norm(self.plates.each - self.beams.each, axis=0).sum())
        first = float(np.linalg.norm(self.plates.whole[0] - self.beams.whole[0]))
        higher = HIGHER * (slope * self.plates.lever + order[1] * self.plates.tension)
        beyond = (SHELLS + min(higher, MOST)) * float(order @ (first, parts))
        beyond += share * UNEVEN * float(bound(self.poisson_ratio)) * apart
        off = float(order @ (self.off + share * self.flat)) + beyond
        if self.cancels and off > CANCELLED * beam:
            return None
        value = plate / beam - 1.0
        # of a shift that nearly vanishes the square of its change counts
        off = float(off) / beam + FLOOR * float(bound(self.poisson_ratio)) + value**2
        return value, off


def drawn_path(blades: Sequence[Blade], nu: float, layout: Layout, held: Held) -> DrawnPath | None:
    """Return the path of a layout's centre by its beams and by its plates, to second order.

    A blade whose ends turn by α and β from its chord shortens by ``l ((α − β)²/24 + (α + β)²/40)``,
    the first part of an arc and the second of an S, each more in a plate: of the two shapes one is
    even and the other odd about the middle, so that no more comes of both together. Besides, its
    ends move by the square of the rotation of its bodies, and its chord turns. What compensates
    all this is the linear response to blades of excess length. The plates' springs turn the bodies
    between, and stretch, otherwise than the beams' do.

    Parameters
    ----------
    blades : sequence of Blade
        Thickness, length and width of each [m], in the order of the layout's.
    nu : float
        Poisson's ratio [-].
    layout : Layout
        The beams.
    held : tuple
        A unit travel of its moving body [rad or m].

    Returns
    -------
    path : DrawnPath or None
        Nothing where the errors of its blades' springs are not known.

    """
    turns = held[1] is None
    if not turns and held[2] is not None:
        rigid = RIGID * layout.E * max(blade.b * blade.h * blade.l for blade in blades)
        guide = Support(MOVING, layout.body(MOVING).point, (0.0, 0.0, rigid))
        layout = replace(layout, supports=(*layout.supports, guide))
    try:
        joint = _Joint(assemble(from_plane(layout, MOVING, turns=turns)), blades, turns=turns)
    except SolveError:
        return None
    joint, known = joint.of_solids(nu)
    if not np.isfinite(known).all():
        return None
    more = np.array([_shortens(blade, nu) for blade in blades])
    off = np.array([_shortens(blade, nu, thick=True) for blade in blades]) - more
    unlike = np.array([[blade.h > THICKEST * blade.l] for blade in blades])
    off = np.abs(off) + FITS + unlike * np.abs(more)
    none = np.zeros_like(more)
    found = joint.path(more)
    # of alike blades errors are alike
    alike: dict[Blade, list[int]] = {}
    for k, blade in enumerate(blades):
        alike.setdefault(blade, []).append(k)
    flat = 1.0 + float(bound(nu))
    unsure, curled = np.zeros(2), joint.apart_from(found, none)
    for own in alike.values():
        for spring in PLANE:
            stiffer = 1.0 + known[own[0], spring]
            unsure += joint.stiffened(own, spring, stiffer).apart_from(found, more)
            if spring != ALONG:
                widened = joint.factors[own[0], spring]
                flatter = joint.stiffened(own, spring, max(flat / widened, 1.0))
                curled += flatter.apart_from(found, more)
        for shape in (0, 1):
            longer = more.copy()
            longer[own, shape] += off[own, shape]
            unsure += joint.apart_from(found, longer)
    beams = joint.of_beams().path(none)
    cancels = len(alike) == 1 and not turns
    is_narrow = max(blade.b / blade.l for blade in blades) <= NARROW
    arc = float(more[0, 0]) if is_narrow else None
    return DrawnPath(beams, found, unsure, curled, joint.curls(nu), nu, joint.slope, cancels, arc)


def _shortens(blade: Blade, nu: float, *, thick: bool = False) -> tuple[float, float]:
    """Return by how much more than its beam a blade shortens, bent to an arc and to an S [-].

    The second is of the S shape beside its chord: its factor is of all that a guided blade
    shortens, its chord's turn with it. A thick one is taken for a thin one of its effective width.
    """
    b = float(effective_width(b=blade.b, h=blade.h)) if thick else blade.b
    at = {"b": b, "l": blade.l, "poisson_ratio": nu}
    arc, bent = float(pure_shortening_factor(**at)), float(s_shortening_factor(**at))
    return arc - 1.0, GUIDED * (bent - 1.0)


class _Joint:
    """A layout on springs, and how its centre moves at a unit travel."""

    def __init__(self, assembly: SpaceAssembly, blades: Sequence[Blade], *, turns: bool) -> None:
        self.assembly, self.blades, self.turns = assembly, blades, turns
        at = assembly.moved(travel=np.ones(1))
        self.coordinates, self.bent = at.coordinates[:, 0], at.deformations[:, 0]
        drive = assembly.layout.drive
        self.point = (0.0, 0.0, 0.0) if turns else drive.point

    @property
    def factors(self) -> Floats:
        """Return the springs of the blades in their plane over those of beams (blades, 6)."""
        found = np.ones((len(self.blades), 6))
        for k, (own, drawn) in enumerate(self._each()):
            E, G = drawn.material.E, drawn.material.G
            beam = middle_stiffness(E=E, G=G, h=own.h, l=own.l, b=own.b)
            stiffness = self.assembly.stiffness[6 * k : 6 * k + 6]
            found[k, PLANE] = stiffness[PLANE] / (beam.x, beam.y, beam.theta_z)
        return found

    @property
    def slope(self) -> float:
        """Return the largest rotation of a body, or of a blade's chord against them [rad]."""
        turns = [self._moved(b.name, b.point)[0][TURN] for b in self.assembly.layout.bodies]
        sways = [self.bent[6 * k + ACROSS] / own.l for k, (own, _) in enumerate(self._each())]
        return float(np.max(np.abs([*turns, *sways])))

    def stiffened(self, which: Sequence[int], spring: int, factor: float) -> "_Joint":
        """Return the joint with one spring of some blades stiffer by a factor."""
        factors = np.ones(len(self.assembly.stiffness))
        factors[[6 * k + spring for k in which]] = factor
        return _Joint(self.assembly.scaled(factors), self.blades, turns=self.turns)

    def of_solids(self, nu: float) -> tuple["_Joint", Floats]:
        """Return the joint with its blades' springs in the plane of solids, where these tell more.

        Returns
        -------
        joint : _Joint
            With the springs of which less is unsure.
        known : array
            Relative error of each spring (blades, 6).

        """
        scales, known = np.ones(len(self.assembly.stiffness)), np.zeros((len(self.blades), 6))
        drawn = self.factors
        for k, own in enumerate(self.blades):
            member = self.assembly.members[k]
            errors = np.maximum(member.high, -member.low)[PLANE]
            known[k, PLANE] = errors if member.is_known else np.inf
            if not is_compared(own, nu):
                continue
            solid = {
                ALONG: along_factor(own, nu),
                ACROSS: blade_factor(plates.guided_factor, own, nu),
                TURN: blade_factor(plates.pure_bending_factor, own, nu),
            }
            for spring, factor in solid.items():
                if factor.off < known[k, spring]:
                    known[k, spring] = factor.off
                    scales[6 * k + spring] = factor.value / drawn[k, spring]
        return _Joint(self.assembly.scaled(scales), self.blades, turns=self.turns), known

    def of_beams(self) -> "_Joint":
        """Return the joint with the beams' springs."""
        factors = np.ones(len(self.assembly.stiffness))
        factors[: 6 * len(self.blades)] = 1.0 / self.factors.ravel()
        return _Joint(self.assembly.scaled(factors), self.blades, turns=self.turns)

    def curls(self, nu: float) -> float:
        """Return the square of the largest width over that on which a section curls [1/m or -]."""
        found = 0.0
        for k, blade in enumerate(self.blades):
            turn, across = abs(self.bent[6 * k + TURN]), abs(self.bent[6 * k + ACROSS])
            curvature = (turn + 6.0 * across / blade.l) / blade.l
            beta = flat_width(b=blade.b, h=blade.h, curvature=float(curvature), poisson_ratio=nu)
            found = max(found, float(beta) ** 2)
        return found

    def path(self, more: Floats) -> _Orders:
        """Return how the centre moves, blades shortening by ``more`` (blades, 2) than beams [-]."""
        misfits = np.zeros((len(self.bent), len(self.blades)))
        grown = np.zeros_like(misfits)
        for k, (own, drawn) in enumerate(self._each()):
            (u, u_2), (v, v_2) = (
                self._moved(body, at)
                for body, at in ((drawn.first, drawn.start), (drawn.second, drawn.end))
            )
            x, y = (np.subtract(drawn.end, drawn.start) / own.l)[:2]
            chord = (x * (v[1] - u[1]) - y * (v[0] - u[0])) / own.l
            rigid = (x, y) @ (v_2 - u_2) / own.l + chord**2 / 2.0
            arc = self.bent[6 * k + TURN] ** 2 / 24.0
            bent = (self.bent[6 * k + ACROSS] / own.l) ** 2 / 10.0
            shorter = np.array([arc, bent]) @ (1.0 + more[k]) + rigid
            misfits[6 * k + ALONG, k], grown[6 * k + ALONG, k] = shorter * own.l, 1.0
        body, still = self.assembly.layout.drive.body, np.zeros(len(self.blades))
        moves = self.assembly.motion(body, self.point)[:2]
        first, own_second = self._moved(body, self.point)
        answers = self.assembly.moved(misfits=misfits, travel=still)
        each = moves @ answers.coordinates
        lever = moves @ self.assembly.moved(misfits=grown, travel=still).coordinates
        orders = np.stack([first[:2], each.sum(axis=1) + own_second])
        if not self.turns:  # a stage's point leaves its path along x
            along = np.array([[1.0], [0.0]])
            orders, each, lever = orders * along.T, each * along, lever * along
        pulls = np.abs(answers.forces.sum(axis=1))
        tension = max(
            pulls[6 * k + ALONG] * own.l**2 * 12.0 / (drawn.material.E * own.b * own.h**3)
            for k, (own, drawn) in enumerate(self._each())
        )
        return _Orders(orders, each, float(tension), float(np.linalg.norm(lever, axis=0).max()))

    def apart_from(self, other: _Orders, more: Floats) -> Floats:
        """Return how far either order of its path is from another (2,)."""
        return np.asarray(np.linalg.norm(self.path(more).whole - other.whole, axis=1))

    def _each(self) -> Iterator[tuple[Blade, SpaceBlade]]:
        """Yield the sizes of each blade, and the blade as drawn."""
        for own, drawn in zip(self.blades, self.assembly.layout.blades, strict=True):
            assert isinstance(drawn, SpaceBlade)  # of the plane
            yield own, drawn

    def _moved(self, body: str, point: Vector) -> tuple[Floats, Floats]:
        """Return the motion of a point of a body (6,), and what its turn adds in second order (2,).

        The ground has none.
        """
        layout = self.assembly.layout
        if body not in {each.name for each in layout.bodies}:
            return np.zeros(6), np.zeros(2)
        moved = np.asarray(self.assembly.motion(body, point) @ self.coordinates)
        arm = np.subtract(point, layout.body(body).point)[:2]
        return moved, -(moved[TURN] ** 2) / 2.0 * arm
