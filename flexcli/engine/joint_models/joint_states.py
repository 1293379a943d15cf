"""The joint of a case in equilibrium: at the ends of its stroke, under its loads, as it is held."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from math import atan2, cos, inf, isinf, sin
from operator import itemgetter
from typing import Any, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.holds import (
    driven_axis,
    held_at_rest,
    held_by_stroke,
    hold_of,
    undriven,
)
from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import LEVELS, solve
from flexcli.mechanics.layout import Layout, Load, Number, Point, Support
from flexcli.mechanics.linear import NODES, LinearSolution, linear
from flexcli.mechanics.linear_buckling import linear_critical
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.own_weight import weights_on_bodies
from flexcli.mechanics.stability import critical_load
from flexcli.mechanics.state import Equilibrium
from flexcli.numerics.rows import all_of_each, one_alone, over_states
from flexcli.parts.elastic import Buckled, NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.loads_in_plane import accelerated, loads_in_plane, senses_in_plane
from flexcli.parts.requirements import Ask
from flexcli.parts.scene import Scene

__all__ = [
    "Solver",
    "at_rest",
    "at_temperature",
    "blades_of",
    "by_weight_alone",
    "driven_axis",
    "exactly",
    "fields",
    "layout_of",
    "linearly",
    "of_case",
    "over_stroke",
    "over_travels",
    "paths",
    "solved",
    "state_of",
    "states_of",
    "turned",
    "warmed",
]

Floats = NDArray[np.float64]

ALONG = 1e-7
"""Share of a motion along the stroke that is rounding."""

RIGHT = 1e-9
"""Sine of twice an angle that counts as a right one."""


NEAR, FAR = 3.0, 30.0
"""Times what straight blades bear within which joints of bent blades are seen to buckle."""

ROUGH = 1e-6
"""Tolerance of the share of the loads at which a joint buckles."""

LOOSE, FINE = 1e-5, LEVELS[-3:]
"""Tolerance and Gauss nodes of equilibria that cannot be had otherwise: boundary layers of blades
that are held against stretching leave more than rounding. What is left is told by the last two
levels."""

STEPS = (1e-3, 1e-2, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0)
"""Shares of the motions in which such blades are followed."""

STRIDES = (
    0.5, 0.7, 0.85, 0.95, 1.0, 1.05, 1.1, 1.2, 1.4, 1.7, 2.0, 2.5, 3.0, 4.0, 6.0, 8.0, 12.0, 20.0,
    50.0, 100.0, 300.0, 1000.0,
)  # fmt: skip
"""Steps of the loads over what straight blades bear, in which blades that lean away are followed.

Loads beyond the last are taken at once from there."""


class Moved(Protocol):
    """An answer of a solver: motions (designs, bodies, 3) of the bodies' points [m, m, rad]."""

    @property
    def motions(self) -> Floats:
        """Return the motions."""


Found = TypeVar("Found", bound=Moved)
Solver = Callable[[Layout, Held, Sequence[Load]], Found]


def layout_of(ask: Ask) -> Layout:
    """Return the joint as bodies and blades, each as stiff as its direction in a crystal."""
    layout = ask.geometry.plane_layout(ask.material.elastic, ask.sizes)
    return ask.material.laid_in_plane(layout, ask.geometry.drawn_turn)


def blades_of(layout: Layout, effects: Effects) -> Effects:
    """Return the effects that the layout can have: no shear without a shear modulus."""
    return effects if layout.G is not None else effects._replace(shear=False)


def of_case(ask: Ask, solver: Solver[Found]) -> Found:
    """Return a case's states by a solver.

    They are the two ends of the stroke, one after the other, under each combination of the signs
    with which the loads of the case may act; of a case without a stroke, one state for each.
    """
    scene = ask.scene
    signs = senses_in_plane(scene)
    if not scene.moves:
        return _states(ask, solver, None, signs)
    travels = np.tile(scene.stroke_ends, len(signs))
    return _states(ask, solver, travels, np.repeat(signs, 2, axis=0))


def over_travels(ask: Ask, solver: Solver[Found], travels: Floats | None) -> Found:
    """Return the states of a case at given travels, if it has a stroke, its loads as stated."""
    return _states(ask, solver, travels, np.ones((1, 1 + len(ask.scene.inertial))))


def _states(ask: Ask, solver: Solver[Found], travels: Floats | None, signs: Floats) -> Found:
    """Return the states at travels, under loads with signs (states, groups).

    Of many designs travels are (states,) or (states, designs), and the states (states·designs,).
    """
    geometry, states = ask.geometry, len(signs)
    own = (ask.scene, warmed(ask), _density(ask))
    designs, (scene, layout, density) = over_states(states, *own)
    signs = np.repeat(signs, designs, axis=0)
    if travels is not None:
        travels = travels.ravel() if travels.ndim > 1 else np.repeat(travels, designs)
    held: Held
    angle = _facing(scene)
    if travels is None:
        # where nothing is held across it, the direction of the force does not matter
        angle = angle if hold_of(scene).across else 0.0
        layout = turned(layout, -angle)
        held = {MOVING: held_at_rest(scene, geometry)}
        return solver(layout, held, loads_in_plane(scene, layout, density, signs, -angle))
    travels = travels + _sag(ask._replace(scene=scene), solver, layout, density, signs)
    if driven_axis(geometry) == 2 and hold_of(scene).across and scene.forces:
        layout = turned(layout, -angle)
        x, _, phi = held_by_stroke(scene, geometry, travels)
        led = solver(layout, {MOVING: (x, None, phi)}, ())
        held = {MOVING: (x, led.motions[:, layout.index(MOVING), 1], phi)}
        return solver(layout, held, loads_in_plane(scene, layout, density, signs, -angle))
    held = {MOVING: held_by_stroke(scene, geometry, travels)}
    return solver(layout, held, loads_in_plane(scene, layout, density, signs, 0.0))


def paths(ask: Ask) -> Iterator[tuple[Layout, Held, Held, list[Load]]]:
    """Yield layout, what is held and what a drive keeps, and loads that grow with a temperature.

    That is at rest and at both ends of a stroke; loads have each sense in which they buckle it.
    """
    one_alone()
    scene, geometry = ask.scene, ask.geometry
    across = hold_of(scene).across and not scene.moves
    angle = _facing(scene) if across else 0.0
    layout = turned(warmed(ask), -angle)
    for travel in scene.ends_and_rest:
        kept = held = held_at_rest(scene, geometry)
        if scene.moves:
            kept = held_by_stroke(scene, geometry, travel)
            held = undriven(scene, geometry, travel)
        for signs in senses_in_plane(scene, as_stated=True):
            loads = [
                load._replace(
                    force=(float(load.force[0][0]), float(load.force[1][0])),
                    moment=float(np.ravel(load.moment)[0]),
                )
                for load in loads_in_plane(scene, layout, _density(ask), signs[None], -angle)
            ]
            yield layout, {MOVING: held}, {MOVING: kept}, loads


def warmed(ask: Ask) -> Layout:
    """Return the joint as bodies and blades, grown by the temperature of the case."""
    layout, temperature = layout_of(ask), ask.scene.temperature
    if temperature is None:
        return layout
    return temperature.warmed(layout, ask.material, ask.geometry.axes)


def _left_by_temperature(ask: Ask, effects: Effects, layout: Layout) -> Floats:
    """Return how far a layout that has grown moves its body (x, y, φ) [m, m, rad]."""
    one_alone()
    guided = 0.0 if ask.geometry.is_guided else None
    held = {MOVING: (None, None, guided)}
    found = solved(layout, held, effects=blades_of(layout, effects))
    return np.asarray(found.motions[0, layout.index(MOVING)])


def at_temperature(ask: Ask) -> tuple[float, ...]:
    """Return how far the temperature of a case alone moves its body (x, y, φ) [m, m, rad].

    x and y are the axes of cases.
    """
    x, y, phi = _left_by_temperature(ask, Effects(), warmed(ask)).tolist()
    c, s = cos(ask.geometry.axes), sin(ask.geometry.axes)
    return c * x + s * y, c * y - s * x, phi


def _facing(scene: Scene) -> float:
    """Return the direction of the case's forces together, from the layout's x [rad]."""
    x, y = (sum(f * trig(d) for f, d in scene.forces) for trig in (cos, sin))
    return atan2(y, x)


def _density(ask: Ask) -> Number:
    """Return the density of the blades [kg/m³], of which nothing is known that it is none."""
    density = ask.material.density
    return 0.0 if density is None else density.value


def fields(ask: Ask) -> tuple[Layout, Floats, Floats]:
    """Return the joint, and along x and y of it what accelerates its mass in a case's states."""
    signs = senses_in_plane(ask.scene)
    if ask.scene.moves:
        signs = np.repeat(signs, 2, axis=0)
    designs, (scene, layout) = over_states(len(signs), ask.scene, warmed(ask))
    return layout, *accelerated(scene, np.repeat(signs, designs, axis=0), 0.0)


def by_weight_alone(ask: Ask, solver: Solver[Found], density: Number) -> Found:
    """Return what blades of a density do in each state of a case, the drive free."""
    layout, x, y = fields(ask)
    held = held_at_rest(ask.scene, ask.geometry)
    if ask.scene.moves:
        held = undriven(ask.scene, ask.geometry)
    elif hold_of(ask.scene).across:
        held = (held[0], None, held[2])  # more moves then
    return solver(layout, {MOVING: held}, weights_on_bodies(layout, density, x, y))


def _sag(
    ask: Ask, solver: Solver[Found], layout: Layout, density: Number, signs: Floats
) -> Floats | float:
    """Return how far the loads move the joint along its stroke by themselves [m or rad].

    A stroke is from where the loads leave the joint: the drive does not hold against them.
    """
    scene, geometry = ask.scene, ask.geometry
    loads, kept = loads_in_plane(scene, layout, density, signs, 0.0), undriven(scene, geometry)
    if not loads or kept[driven_axis(geometry)] is not None:
        return 0.0
    held, body = {MOVING: kept}, layout.index(MOVING)
    own = geometry.own_mass > 0.0 and any(any(field[:2]) for field in scene.accelerations)
    if scene.push == 0.0 and not own:
        # a moment on a stage moves it, a force along the axis of symmetry nothing
        straight = linear(layout, held, loads=loads, effects=blades_of(layout, Effects()))
        if not _is_driven(straight.motions[:, body], layout, driven_axis(geometry)):
            return 0.0
    state = solver(layout, held, loads)
    return np.asarray(state.motions[:, body, driven_axis(geometry)])


def _is_driven(motion: Floats, layout: Layout, axis: int) -> bool:
    """Return whether a motion (states, 3) has a part along an axis that is no rounding."""
    longest = max(float(np.max(blade.length)) for blade in layout.blades)
    reach = np.abs(motion) * (1.0, 1.0, longest)
    return bool(np.any(reach[:, axis] > ALONG * reach.max()))


def over_stroke(
    ask: Ask, effects: Effects, tolerance: float, levels: Sequence[int] = LEVELS
) -> Equilibrium:
    """Return the exact equilibria of a case's states."""
    return of_case(ask, exactly(effects, tolerance, levels))


def exactly(
    effects: Effects, tolerance: float, levels: Sequence[int] = LEVELS
) -> Solver[Equilibrium]:
    """Return the exact solver, whose answers are stable equilibria."""

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        return solved(
            layout, held, loads=loads,
            effects=blades_of(layout, effects), tolerance=tolerance, levels=levels,
        )  # fmt: skip

    return solver


def linearly(
    layout: Layout, held: Held, loads: Sequence[Load] = (), *, effects: Effects, nodes: int = NODES
) -> LinearSolution:
    """Return a linear solution, or say why there is none where a requirement asks."""
    found = linear(layout, held, loads=loads, effects=blades_of(layout, effects), nodes=nodes)
    if not all_of_each(found.unique):
        raise NotAvailable("has no unique linear solution: hold or support every body")
    return found


def at_rest(ask: Ask, effects: Effects, warmth: float = 1.0) -> tuple[Layout, Held]:
    """Return the joint at rest, its driven motion held where the case's temperature leaves it.

    ``warmth`` is the share that it has of what that strains.
    """
    layout, travel = warmed(ask), 0.0
    if ask.scene.temperature is not None:
        layout = layout.grown(warmth)
        travel = float(_left_by_temperature(ask, effects, layout)[driven_axis(ask.geometry)])
    return layout, {MOVING: ask.geometry.held(travel)}


def solved(layout: Layout, held: Held, *, loads: Sequence[Load] = (), **how: Any) -> Equilibrium:
    """Return an equilibrium, or say why there is none where a requirement asks.

    Motions and loads grow together; where that path ends before, the motions go first. That the
    loads buckle the joint is said only where their path is seen to lose its stability.
    """
    try:
        state = solve(layout, held, loads=loads, **how)
        if loads and _moves(held) and not all_of_each(state.converged):
            moved = solve(layout, held, **how)
            if all_of_each(moved.converged):
                state = solve(layout, held, loads=loads, start=moved, **how)
        stands = state.converged & (state.unstable == 0)
        if not all_of_each(stands) and loads:
            _prove_buckled(layout, held, loads, np.flatnonzero(~stands), how.get("effects"))
        if not all_of_each(stands) and Outcome.SINGULAR not in state.outcome:
            state = _by_small_steps(layout, held, loads, state.designs, how) or state
        state = state.checked()
    except SolveError as error:
        raise NotAvailable(f"has no exact equilibrium: {error}") from error
    if state.unstable.any():
        raise NotAvailable("has no stable exact equilibrium")
    return state


def _by_small_steps(
    layout: Layout, held: Held, loads: Sequence[Load], states: int, how: Mapping[str, Any]
) -> Equilibrium | None:
    """Return equilibria on more nodes, the motions first, by steps; then the loads, by strides.

    Nothing where the nodes are given.
    """
    one_alone()
    if len(how.get("levels", LEVELS)) == 1:
        return None
    how = {**how, "tolerance": LOOSE, "levels": FINE}
    state = solve(layout, held, **how)
    for share in STEPS if not state.converged.all() else ():
        start = state if share != STEPS[0] else None
        state = solve(layout, _share_of(held, share), start=start, **how)
        if not state.converged.all():
            break
    if not loads or not state.converged.all():
        return state
    patterns = [tuple(state_of(held, loads, which)[1]) for which in range(states)]
    effects, (there, _) = how.get("effects"), state_of(held, loads, 0)
    known = {each: _borne_straight(layout, there, each, effects) for each in set(patterns)}
    bears = np.array([known[each] for each in patterns])
    for stride in (*STRIDES, inf):
        grown = np.minimum(stride * bears, 1.0)
        state = solve(layout, held, loads=loads, load_factor=grown, start=state, **how)
        if not state.converged.all() or (grown == 1.0).all():
            break
    return state


def _prove_buckled(
    layout: Layout,
    held: Held,
    loads: Sequence[Load],
    which: Iterable[int],
    effects: Effects | None,
) -> None:
    """Raise :class:`Buckled` where any of several states loses its stability as its loads grow.

    States whose loads straight blades bear without end are tried only where no other buckles.
    """
    one_alone()
    states = list[tuple[Held, list[Load]]]()
    for each in which:
        state = state_of(held, loads, each)
        if state not in states:
            states.append(state)
    borne = [_borne_straight(layout, *state, effects) for state in states]
    found = list[float]()
    for bears, state in sorted(zip(borne, states, strict=True), key=itemgetter(0)):
        if found and isinf(bears):
            break
        share = _buckled_at(layout, *state, bears, effects)
        if share is not None:
            found.append(share)
    if found:
        raise Buckled(min(found))


def _buckled_at(
    layout: Layout, there: Held, pattern: Sequence[Load], bears: float, effects: Effects | None
) -> float | None:
    """Return the share of a state's loads at which it is seen to lose its stability.

    What is held stands still where it is meanwhile. A path that is lost proves nothing. ``bears``
    is the share that buckles straight blades.
    """
    reaches = [reach * bears for reach in (NEAR, FAR) if reach * bears < 1.0]
    # loads a thousand times as large would be walked in strides in which the path is lost
    for most in reaches if FAR * bears < 1.0 else (*reaches, 1.0):
        try:
            found = critical_load(
                layout, there, pattern, most=most, effects=effects, tolerance=ROUGH
            )
        except SolveError:
            continue
        return float(found.factor)
    return None


def states_of(held: Held, loads: Sequence[Load]) -> list[tuple[Held, list[Load]]]:
    """Return what is held, and the loads, in each of all states."""
    numbers = [x for motion in held.values() for x in motion if x is not None]
    numbers += [x for load in loads for x in (*load.force, load.moment)]
    count = max((int(np.size(x)) for x in numbers), default=1)
    return [state_of(held, loads, which) for which in range(count)]


def state_of(held: Held, loads: Sequence[Load], which: int) -> tuple[Held, list[Load]]:
    """Return what is held, and the loads, in one of several states."""

    def one(number: Any) -> float | None:
        return None if number is None else float(np.ravel(number)[min(which, np.size(number) - 1)])

    there: Held = {body: (one(x), one(y), one(phi)) for body, (x, y, phi) in held.items()}
    return there, [
        load._replace(
            force=(one(load.force[0]) or 0.0, one(load.force[1]) or 0.0),
            moment=one(load.moment) or 0.0,
        )
        for load in loads
    ]


def _borne_straight(
    layout: Layout, held: Held, pattern: Sequence[Load], effects: Effects | None
) -> float:
    """Return the share of loads that buckles straight blades at rest, endless where none does."""
    try:
        return linear_critical(layout, _share_of(held, 0.0), pattern, effects=effects).factor
    except SolveError:
        return inf


def _share_of(held: Held, share: float) -> Held:
    """Return a share of what is held."""

    def of(motion: Any) -> Any:
        return None if motion is None else share * motion

    return {body: (of(x), of(y), of(phi)) for body, (x, y, phi) in held.items()}


def _moves(held: Mapping[str, Any]) -> bool:
    """Return whether anything is held elsewhere than at rest."""
    return any(
        np.any(np.asarray(v) != 0.0) for each in held.values() for v in each if v is not None
    )


def turned(layout: Layout, angle: float) -> Layout:
    """Return a layout turned about the origin by an angle [rad]."""
    c, s = cos(angle), sin(angle)
    if layout.guides and abs(s) > RIGHT:
        raise NotAvailable("has ideal joints: no load along another axis than x")

    def place(point: Point) -> Point:
        x, y = point
        return c * x - s * y, s * x + c * y

    return replace(
        layout,
        bodies=tuple(b._replace(point=place(b.point), com=place(b.com)) for b in layout.bodies),
        blades=tuple(
            replace(blade, start=place(blade.start), end=place(blade.end))
            for blade in layout.blades
        ),
        supports=tuple(_turned_support(support, place, angle) for support in layout.supports),
    )


def _turned_support(support: Support, place: Callable[[Point], Point], angle: float) -> Support:
    """Return a support turned by an angle; springs that differ turn by right angles only."""
    along, across, turn = support.stiffness
    if along != across and abs(sin(2.0 * angle)) > RIGHT:
        raise NotAvailable("has supports whose springs differ: no oblique load on them")
    if along != across and abs(sin(angle)) > 0.5:
        along, across = across, along
    return support._replace(point=place(support.point), stiffness=(along, across, turn))
