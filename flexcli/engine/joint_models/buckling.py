"""Critical forces of a case by the linear and by the exact model: its body held, at its motion."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from math import cos, inf, isfinite, sin

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.holds import hold_of
from flexcli.engine.joint_models.joint_states import blades_of, layout_of, paths, turned
from flexcli.engine.joint_models.remembered import Remembered
from flexcli.errors import SolveError
from flexcli.formulas.joint_buckling import pulled_straight
from flexcli.formulas.plate_factors import pure_bending_factor
from flexcli.formulas.profile import Filleted, Notch
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load
from flexcli.mechanics.linear_buckling import LinearCritical, linear_critical
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.own_weight import blade_places
from flexcli.mechanics.stability import critical_load, inertia_count_held
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import blade_stress
from flexcli.numerics.rows import one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import ENDS, Hold
from flexcli.parts.geometries.base import MOVING, Critical
from flexcli.parts.requirements import Ask, CriticalShare
from flexcli.parts.requirements.closed_form import of_case
from flexcli.parts.scene import Push
from flexcli.results import ErrorRange
from flexcli.units import show

__all__ = [
    "SETTLED",
    "PushScene",
    "critical_unsure",
    "ends_held",
    "exact_critical",
    "linear_critical_forces",
    "push_scene",
    "warm_shares",
]

Floats = NDArray[np.float64]

WAY = "in the plane"

SWAY = 3.0
"""Largest change of a critical factor over the strain there times 1 + bends², by how the body gives
way before it: exact solutions of rcc, crossed and star pivots have at most 1.5."""

WIDE = 0.3
"""An error beyond which it is none of a first order any more."""

HINGE_STRAINED = 2.5
"""Share of the strain in a hinge's throat by which solids buckle at less force than Reissner's
beams: which force shears a section, and whether what it shortens by counts, are of that order.
CalculiX's solids of 16 notches of e/r 0.03 to 0.3 and five ellipses, strained by 0.004 to 0.2, had
0.8 to 2.1, beside what thick notches and wide throats change."""

SETTLED = 100.0
"""Error of a critical force over the tolerance of the solver, which else has no answer."""

STILL = 1e-9
"""Motion over the strain that is rounding."""

BEYOND = 1.6
"""How far beyond the critical force of straight blades at rest the exact one is looked for."""

LEANS = 1.2
"""How far beyond it a joint is taken to bear no more, though it leans away without falling."""

ROUGH = 1e-6
"""Tolerance of the equilibria that tell whether a joint stands."""

SHARES = (0.5, 0.7, 0.85, 0.9, 0.94, 0.97, 0.985, 1.0, 1.015, 1.03, 1.06, 1.12, LEANS)
"""Of the critical force of straight blades: where it is looked whether a joint stands."""

SWINGS = 12
"""Newton's steps to where blades on hinges keep their lengths: a few are enough."""

QUARTER = 1e-9
"""Sine of twice an angle that counts as a multiple of a right one."""


@dataclass(frozen=True, eq=False)
class PushScene:
    """A joint under one direction of its forces: the layout, the unit force, what holds."""

    layout: Layout
    pattern: tuple[Load, ...]
    across: int
    hold: Hold


def linear_critical_forces(ask: Ask, effects: Effects) -> Iterator[Critical]:
    """Yield the critical forces of straight blades at rest, one for each sense they may have."""
    for push in ask.scene.pushes():
        scene, found = _straight_under(ask, push, effects)
        error = None if ask.scene.bends else _linear_error(scene, found)
        if error is not None and isfinite(found.factor):
            error += _strained(scene, found.factor * found.strain)
        source = f"linear beams at rest, {scene.hold.spoken}"
        critical = Critical(WAY, found.factor, source, found.stress, error)
        yield of_case(ask, push, critical)


def exact_critical(
    ask: Ask, effects: Effects, tolerance: float, levels: Sequence[int]
) -> Iterator[Critical]:
    """Yield the critical forces at the motions that a case holds, the least of them for each sense.

    They are those of rest and of both ends of its stroke. Of one force that acts either way, the
    sense that bears more is looked at no further than where it is seen to.
    """
    pushes = ask.scene.pushes()
    senses = [(push, *_straight_under(ask, push, effects)) for push in pushes]
    either_way, most = len({push.force for push in pushes}) == 1 and len(pushes) == 2, inf
    for push, scene, straight in sorted(senses, key=lambda sense: sense[2].factor):
        least: Critical | None = None
        for travel in ask.scene.ends_and_rest:
            solver = _Exact(ask, scene, effects, tolerance, levels, travel)
            found = solver.critical(straight, most if least is None else float(least.force))
            if found is not None and (least is None or found.force < least.force):
                least = found
        if least is not None:
            yield of_case(ask, push, least)
            unsure = 0.0 if least.error is None else least.error.high
            most = float(least.force) * (1.0 + unsure) if either_way else inf


def warm_shares(
    ask: Ask, effects: Effects, tolerance: float, levels: Sequence[int]
) -> Iterator[CriticalShare]:
    """Yield the shares of temperature and loads together at which a joint buckles, in the plane.

    They are those of rest and both ends of its stroke, which a drive keeps by an effort, and of
    each sense that the loads may have; what the ends of the case hold is held. A joint that leans
    from the first on passes no critical point where it would buckle else: the share may be as
    little as that of straight blades.
    """
    if hold_of(ask.scene).hinged:
        raise NotAvailable("has no critical share beside a temperature of blades on hinges")
    wide, spoken = sum(critical_unsure(ask)), ask.scene.keeps
    for layout, held, driven, loads in paths(ask):
        most, blades = ask.most_share, blades_of(layout, effects)
        straight = _from_rest(layout, held, loads, blades)
        try:
            found = critical_load(
                layout, held, loads, most=most, driven=driven,
                effects=blades, tolerance=tolerance, levels=levels,
            )  # fmt: skip
        except SolveError as error:
            if error.code != "no-critical-load":
                raise NotAvailable(f"has no exact critical load: {error}") from error
            kept = {**held, **driven}
            pushed = _compression_under(layout.grown(most), kept, loads, most, blades, levels)
            share, said, off, high = most, f"{spoken}: none up to that", wide, inf
        else:
            pushed = _compression(found.state)
            share, said, off = found.factor, spoken, wide + found.estimated_error
            high = off
        low = min(1.0, straight.factor / share) * (1.0 - off)
        known = ErrorRange(low - 1.0, high) if pushed is not None and isfinite(off) else None
        yield CriticalShare(share, said, known, max(pushed or 0.0, straight.stress * share))


def _from_rest(
    layout: Layout, held: Held, loads: Sequence[Load], effects: Effects
) -> LinearCritical:
    """Return what share of loads and growth buckles blades that stay straight, at rest."""
    x, y, phi = (None if each is None else 0.0 for each in held[MOVING])
    try:
        return linear_critical(layout, {MOVING: (x, y, phi)}, loads, effects=effects)
    except SolveError as error:
        raise NotAvailable(f"has no critical share of straight blades: {error}") from error


def critical_unsure(ask: Ask) -> tuple[float, float]:
    """Return by what share soft clamps and a crossing may lower a critical share, and raise it.

    A crossing and wide blades do that.
    """
    nu = ask.material.elastic.most_nu
    most = 1.0 / (1.0 - nu**2) - 1.0
    blade = ask.geometry.blade(ask.sizes)
    if blade is not None:
        h, l, b = (float(size) for size in blade)
        most = float(pure_bending_factor(b=b, l=l, h=h, poisson_ratio=nu)) - 1.0
    least, stiffest = map(float, ask.geometry.crossed(ask.sizes))
    return ask.clamp_softening + max(1.0 - least, 0.0), most + max(stiffest - 1.0, 0.0)


def _compression(state: Equilibrium) -> float:
    """Return the largest force that pushes a blade over its area [Pa], 0 if none does."""
    blades = state.layout.blades
    pulls = (blade_stress(state, each.name).axial / each.peak[1] for each in blades)
    return max(0.0, *(float(np.max(-pull)) for pull in pulls))


def _compression_under(
    layout: Layout,
    held: Held,
    loads: Sequence[Load],
    factor: float,
    effects: Effects,
    levels: Sequence[int],
) -> float | None:
    """Return that under so many times the loads, None where no equilibrium is found."""
    try:
        found = solve(
            layout, held, loads=loads, load_factor=factor,
            effects=effects, tolerance=ROUGH, levels=levels,
        )  # fmt: skip
        return _compression(found.checked())
    except SolveError:
        return None


def push_scene(ask: Ask, push: Push) -> PushScene:
    """Return the joint under a unit force, turned until an axis lies across what it must hold."""
    one_alone()
    assert ask.scene.ends is not None  # the requirement asks for them
    hold, layout, angle = ENDS[ask.scene.ends], layout_of(ask), push.direction
    hold = hold._replace(turn=hold.turn or ask.geometry.is_guided)
    if hold.across and abs(sin(2.0 * angle)) > QUARTER:
        if ask.scene.moves and ask.geometry.motion == "translation":
            raise NotAvailable(
                "has no critical load for a force oblique to its stroke, held across"
            )
        layout, angle = turned(layout, -angle), 0.0
    force = Load(MOVING, layout.body(MOVING).point, (cos(angle), sin(angle)))
    return PushScene(layout, (force,), 1 if abs(cos(angle)) > 0.5 else 0, hold)


def ends_held(scene: PushScene, at: Sequence[float] = (0.0, 0.0, 0.0)) -> Held:
    """Return what the ends hold of the body, where it is."""
    held: list[float | None] = [None, None, at[2] if scene.hold.turn else None]
    if scene.hold.across:
        held[scene.across] = at[scene.across]
    return {MOVING: (held[0], held[1], held[2])}


_STRAIGHT: Remembered[tuple[PushScene, LinearCritical]] = Remembered(of_blades=True)


def _straight_under(ask: Ask, push: Push, effects: Effects) -> tuple[PushScene, LinearCritical]:
    """Return the joint under a push and the critical factor of straight blades, found once."""

    def find() -> tuple[PushScene, LinearCritical]:
        scene = push_scene(ask, push)
        return scene, _straight(scene, effects)

    return _STRAIGHT.of(f"{push} {effects}", ask, find)


def _straight(scene: PushScene, effects: Effects) -> LinearCritical:
    """Return the critical factor of straight blades at rest."""
    try:
        if scene.hold.hinged:
            return _hinged(scene, effects, ends_held(scene))
        layout = scene.layout
        return linear_critical(
            layout, ends_held(scene), scene.pattern, effects=blades_of(layout, effects)
        )
    except SolveError as error:
        raise NotAvailable(f"has no critical load: {error}") from error


def _linear_error(scene: PushScene, found: LinearCritical) -> ErrorRange | None:
    """Return what the bending before the blades buckle may change, where that is known.

    None where a body turns with the force from the start: it is no branching then.
    """
    sure = ErrorRange(-STILL, STILL)
    if found.bends <= STILL or scene.hold.hinged or not isfinite(found.factor):
        return sure
    if len(scene.layout.bodies) > 1 or scene.layout.supports:
        return None
    if not scene.hold.turn and found.turns > STILL:
        return None
    change = SWAY * found.strain * found.factor * (1.0 + found.bends**2)
    if not scene.hold.turn:
        change *= pulled_straight(*_largest_forces(scene.layout, found))
    return ErrorRange(-change, change) if change < WIDE else None


def _largest_forces(layout: Layout, found: LinearCritical) -> tuple[float, float]:
    """Return the largest tension and compression of a blade at the critical factor [EI/l²].

    EI is that of where it is thinnest.
    """
    pulled = pushed = 0.0
    for blade, tension in zip(layout.blades, found.tensions, strict=True):
        l = float(blade.length)
        _, h = blade_places(blade, l)
        EI = float(layout.E * blade.stiffer * blade.b * h.min() ** 3) / 12.0
        n = found.factor * float(tension) * l**2 / EI
        pulled, pushed = max(pulled, n), max(pushed, -n)
    return pulled, pushed


def _strained(scene: PushScene, strain: float) -> ErrorRange:
    """Return by how much hinges in a joint may buckle at less force than its beams."""
    hinges = any(isinstance(blade.profile, Notch | Filleted) for blade in scene.layout.blades)
    return ErrorRange(-min(HINGE_STRAINED * strain, 1.0) if hinges else 0.0, 0.0)


def _hinged(scene: PushScene, effects: Effects, held: Held) -> LinearCritical:
    """Return the critical factor of blades hinged at both ends, one of which buckles alone.

    On hinges they bear no moment: they share the force as the bars of a truss do.
    """
    layout = scene.layout
    if len(layout.bodies) > 1 or layout.supports:
        raise NotAvailable("would fall apart on hinges: its bodies are held by clamped blades")
    least, tensions, stress = inf, *_of_truss(scene, held)
    for blade, tension in zip(layout.blades, tensions, strict=True):
        if tension < 0.0:
            strut = _strut(blade, layout)
            ends: Held = {"base": (0.0, 0.0, None), "body": (None, 0.0, None)}
            push = Load("body", strut.body("body").point, (-1.0, 0.0))
            alone = linear_critical(strut, ends, [push], effects=blades_of(strut, effects))
            least = min(least, alone.factor / -float(tension))
    still = np.zeros((len(layout.bodies), 3))
    return LinearCritical(least, inf, tensions, stress / float(layout.E), stress, 0.0, 0.0, still)


def _of_truss(scene: PushScene, held: Held) -> tuple[Floats, float]:
    """Return the axial forces of blades on hinges under the unit force, and the largest stress.

    By their stiffness E b/∫ds/h, since what is held of the body may take a share.
    """
    layout = scene.layout
    body, (load,) = layout.body(MOVING), scene.pattern
    free = [i for i, each in enumerate(held[MOVING]) if each is None]
    ends, moves = _ends(layout)
    rates = _lengthening(ends, ends - np.array(body.point), moves)[:, free]
    stiffness, areas = [], []
    for blade in layout.blades:
        along, h = (np.ravel(each) for each in blade_places(blade, float(blade.length)))
        softness = np.sum(np.diff(along) * (1.0 / h[1:] + 1.0 / h[:-1]) / 2.0)
        stiffness.append(float(layout.E * blade.stiffer * blade.b / softness))
        areas.append(float(blade.b * h.min()))
    k = np.array(stiffness)
    force = np.array([*load.force, 0.0], dtype=np.float64)[free]
    moved = np.linalg.lstsq((rates.T * k) @ rates, force, rcond=None)[0]
    tensions = k * (rates @ moved)
    return tensions, float(np.max(np.abs(tensions) / np.array(areas)))


def _ends(layout: Layout) -> tuple[Floats, NDArray[np.bool_]]:
    """Return the ends of blades (blades, 2, 2) [m], and which are on the moving body."""
    ends = np.array([(blade.start, blade.end) for blade in layout.blades], dtype=np.float64)
    moves = np.array([(blade.first == MOVING, blade.second == MOVING) for blade in layout.blades])
    return ends, moves


def _lengthening(ends: Floats, arms: Floats, moves: NDArray[np.bool_]) -> Floats:
    """Return by how much motions (x, y, φ) of the body lengthen blades (blades, 3).

    ``arms`` are from the body's point to the ends, of which those that ``moves`` go with it.
    """
    sense = np.where(moves, (-1.0, 1.0), 0.0)
    along = ends[:, 1] - ends[:, 0]
    x, y = (along / np.linalg.norm(along, axis=1)[:, None]).T
    turn = sense * (y[:, None] * arms[..., 0] - x[:, None] * arms[..., 1])
    return np.column_stack([x * sense.sum(axis=1), y * sense.sum(axis=1), turn.sum(axis=1)])


def _strut(blade: Blade, layout: Layout) -> Layout:
    """Return one blade along x between two bodies that turn with its ends."""
    l = float(blade.length)
    bodies = (Body("base", (0.0, 0.0)), Body("body", (l, 0.0)))
    strip = Blade(
        blade.name, "base", "body", (0.0, 0.0), (l, 0.0), blade.profile, blade.b,
        stiffer=blade.stiffer,
    )  # fmt: skip
    return Layout(bodies, (strip,), layout.E, layout.G)


def _swung(scene: PushScene, motion: Sequence[float | None], near: Floats) -> PushScene:
    """Return a joint whose body moved as far as blades on hinges let it, which keep their lengths.

    What is given of its motion (x, y, φ) is held; the rest is the nearest to ``near``, where
    clamped blades bring it.
    """
    layout = scene.layout
    body = layout.body(MOVING)
    point = np.array(body.point, dtype=np.float64)
    ends, moves = _ends(layout)
    l = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    free = [i for i, each in enumerate(motion) if each is None]
    pose = np.array([n if m is None else m for m, n in zip(motion, near, strict=True)])
    placed = ends
    for _ in range(SWINGS):
        c, s = cos(pose[2]), sin(pose[2])
        arms = (ends - point) @ np.array([[c, s], [-s, c]])
        placed = np.where(moves[..., None], point + pose[:2] + arms, ends)
        now = np.linalg.norm(placed[:, 1] - placed[:, 0], axis=1)
        rates = _lengthening(placed, arms, moves)
        pose[free] += np.linalg.lstsq(rates[:, free], l - now, rcond=None)[0]
    moved = body._replace(point=tuple((point + pose[:2]).tolist()))
    blades = tuple(
        replace(blade, start=tuple(start), end=tuple(end))
        for blade, (start, end) in zip(layout.blades, placed.tolist(), strict=True)
    )
    (load,) = scene.pattern
    return replace(
        scene,
        layout=replace(layout, bodies=(moved,), blades=blades),
        pattern=(load._replace(point=moved.point),),
    )


@dataclass(frozen=True, eq=False)
class _Exact:
    """The exact model of a joint at one travel."""

    ask: Ask
    scene: PushScene
    effects: Effects
    tolerance: float
    levels: Sequence[int]
    travel: float

    def critical(self, straight: LinearCritical, least: float) -> Critical | None:
        """Return the critical factor here, or nothing where it is above the least so far."""
        if self.scene.hold.hinged:
            error = _linear_error(self.scene, straight) or self._settled
            if self.travel:
                straight = self._on_hinges()
                change = SWAY * straight.strain * straight.factor
                error = ErrorRange(-change, change)
            return self._told(straight, straight.factor, error)
        if not self.travel and not isfinite(straight.factor):
            return self._told(straight, inf, ErrorRange(0.0, 0.0))
        near = straight.factor if isfinite(straight.factor) else straight.most / BEYOND
        if not isfinite(near):
            raise NotAvailable("has no critical load to look for: at rest its loads push no blade")
        start = self._start()
        most = min(BEYOND * near, least)
        try:
            reached = critical_load(
                self.scene.layout, self._kept(start), self.scene.pattern,
                most=most, driven=self._driven(), start=start, careful=False,
                effects=self._blades, tolerance=self.tolerance, levels=self.levels,
            )  # fmt: skip
        except SolveError as error:
            if error.code == "no-critical-load" and (most == least or not self._leans(straight)):
                return None if most == least else self._told(straight, inf, self._settled)
            if error.code not in ("no-critical-load", "lost-path", "endless-path"):
                raise NotAvailable(f"has no exact critical load: {error}") from error
            return self._where_it_stands(start, straight, near)
        return self._told(straight, reached.factor, self._settled)

    def _on_hinges(self) -> LinearCritical:
        """Return the critical factor of blades on hinges, which the stroke turns and does not bend.

        The drive holds the body there.
        """
        start, layout = self._start(), self.scene.layout
        if start is None or len(layout.bodies) > 1 or layout.supports:
            raise NotAvailable("would fall apart on hinges: its bodies are held by clamped blades")
        motion = self._driven()[MOVING]
        swung = _swung(self.scene, motion, start.motions[0, layout.index(MOVING)])
        x, y, phi = (
            None if driven is None and kept is None else 0.0
            for driven, kept in zip(motion, ends_held(swung)[MOVING], strict=True)
        )
        try:
            return _hinged(swung, self.effects, {MOVING: (x, y, phi)})
        except SolveError as error:
            raise NotAvailable(f"has no critical load: {error}") from error

    @property
    def _settled(self) -> ErrorRange:
        """Return the error of the solver."""
        return ErrorRange(-SETTLED * self.tolerance, SETTLED * self.tolerance)

    @property
    def _blades(self) -> Effects:
        return blades_of(self.scene.layout, self.effects)

    def _leans(self, straight: LinearCritical) -> bool:
        """Return whether straight blades would buckle, so that a joint that does not leans away."""
        return isfinite(straight.factor)

    def _driven(self) -> Held:
        """Return the motion that the case holds by its drive."""
        return {MOVING: self.ask.geometry.held(self.travel)} if self.travel else {}

    def _start(self) -> Equilibrium | None:
        """Return the joint at its travel, under no force yet."""
        if not self.travel:
            return None
        try:
            return solve(
                self.scene.layout, self._driven(),
                effects=self._blades, tolerance=self.tolerance, levels=self.levels,
            ).checked()  # fmt: skip
        except SolveError as error:
            raise NotAvailable(f"has no exact equilibrium: {error}") from error

    def _kept(self, start: Equilibrium | None) -> Held:
        """Return what the ends of the case keep where the stroke has brought the body."""
        if start is None:
            return ends_held(self.scene)
        at = start.motions[0, self.scene.layout.index(MOVING)]
        return ends_held(self.scene, [float(x) for x in at])

    def _where_it_stands(
        self, start: Equilibrium | None, straight: LinearCritical, near: float
    ) -> Critical:
        """Return the largest force looked at under which the joint still stands.

        A joint that leans from the start, be it by a millionth, has no branching to be found: what
        straight blades bear is the low end of its range.
        """
        kept, driven = self._kept(start)[MOVING], self._driven().get(MOVING, (None, None, None))
        along = tuple(d if k is None else k for k, d in zip(kept, driven, strict=True))
        factors = near * np.array(SHARES)
        try:
            state = solve(
                self.scene.layout, {MOVING: (along[0], along[1], along[2])},
                loads=self.scene.pattern, load_factor=factors,
                effects=self._blades, tolerance=ROUGH, levels=self.levels,
            )  # fmt: skip
        except SolveError as error:
            raise NotAvailable(f"has no exact critical load: {error}") from error
        stands = state.converged & (inertia_count_held(state, self._kept(start)) == 0)
        if stands.all():
            leaning = ErrorRange(1.0 / LEANS - 1.0, 0.0)
            told = self._told(straight, float(factors[-1]), leaning)
            return told._replace(source=f"{told.source}; beyond, it leans away")
        first = int(np.argmin(stands))
        if first == 0:
            raise NotAvailable("has no exact critical load: its path is lost from the start")
        last = float(factors[first - 1])
        between = ErrorRange(min(0.0, near / last - 1.0), float(factors[first]) / last - 1.0)
        return self._told(straight, last, between)

    def _told(self, straight: LinearCritical, force: float, error: ErrorRange) -> Critical:
        """Return a critical force with what the solver, or how it was found, leaves open.

        What hinges are strained by before they buckle counts besides.
        """
        unit = self.ask.geometry.travel_unit
        where = f" at {show(self.travel, unit)} of its stroke" if self.travel else ""
        source = f"exact model, {self.scene.hold.spoken}"
        if isfinite(force):
            error += _strained(self.scene, force * straight.strain)
        return Critical(f"{WAY}{where}", force, source, straight.stress, error)
