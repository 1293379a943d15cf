"""Stability of an equilibrium: unstable directions, the critical load and its mode."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.assembly import Assembly, assemble
from flexcli.mechanics.critical_point import (
    CriticalPoint,
    Point,
    Search,
    arc_weight,
    endless_path,
    first_critical,
    lost_path,
    mode_of,
    none_up_to,
    refined,
    steps_of,
    unstable_start,
)
from flexcli.mechanics.demand import Demand, Held, held_of
from flexcli.mechanics.equilibrium import LEVELS, solve
from flexcli.mechanics.inertia_count import (
    closing_and_balance,
    inertia_count,
    inertia_count_of_one,
    row_units,
)
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.numerics.arc_length import CLOSE, follow

__all__ = ["Critical", "critical_load", "inertia_count_held", "is_stable"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

_MOST = 100
"""Points of a path: those that lead to a critical load have a dozen."""

_CORRECTION = 1e-12


class _Gait(NamedTuple):
    """First and longest step of arc length, and what of the longest may cross a loss of stability.

    Two losses of stability that are made good within one step are not seen.
    """

    first: float
    longest: float
    close: float


_STRIDES = _Gait(0.1, 0.25, 1.0)
_STEPS = _Gait(0.02, 0.125, CLOSE)
"""At first in strides; where a path is lost that way, in small steps."""


_NOTHING = (None, None, None)

_LEVEL = 1e-4
"""Slope of the load over the arc length below which the load turns."""


@dataclass(frozen=True, eq=False)
class Critical:
    """The critical factor of a load pattern, the state just below it, how many modes meet there.

    ``mode`` is the motion (x [m], y [m], φ [rad]) of each body in the unstable direction, with
    a largest entry (lengths in mean blade lengths) of one, zero when only blades buckle between
    bodies that stand still. ``turns`` tells a limit point, where the load has its maximum and the
    mechanism snaps, from a branching point, past which it buckles away from its path.
    ``estimated_error`` is that of the factor, relative.
    """

    factor: float
    state: Equilibrium
    multiplicity: int
    mode: Floats
    turns: bool
    estimated_error: float


def is_stable(state: Equilibrium) -> NDArray[np.bool_]:
    """Return which designs stand by themselves, their held coordinates held (designs,)."""
    return np.asarray(state.unstable == 0)


def inertia_count_held(state: Equilibrium, held: Held) -> Integers:
    """Return in how many directions designs are unstable, only ``held`` held (designs,).

    What else holds them in the state is taken for an effort that keeps its size.
    """
    values = []
    for part, at in zip(state.parts, state.linearised, strict=True):
        index, free, _ = held_of(state.layout, held, part.assembly.length)
        counted = part.demand._replace(held=index, free=free)
        unstable = inertia_count(part.assembly, counted, at, part.x, part.rows)
        values.append(unstable.astype(np.float64))
    return np.rint(state.scatter(values)).astype(np.intp)


def critical_load(
    layout: Layout,
    held: Held | None,
    pattern: Sequence[Load],
    *,
    most: float,
    careful: bool = True,
    driven: Held | None = None,
    start: Equilibrium | None = None,
    effects: Effects | None = None,
    tolerance: float = 1e-9,
    levels: Sequence[int] = LEVELS,
) -> Critical:
    """Return the least factor in (0, most] on a load pattern at which an equilibrium is critical.

    What a temperature makes the layout grow by belongs to the pattern. The path runs from the
    equilibrium under the layout's own loads and what is held, by arc length, to where a first
    direction gets unstable. What ``held`` holds decides which load this is: a body locked, free to
    turn, or free in the plane are three different numbers. What ``driven`` holds besides stays
    where it is along the path, by an effort that keeps its size.

    Parameters
    ----------
    layout : Layout
        One mechanism (not a batch).
    held : mapping or None
        Motions held, as in :func:`flexcli.mechanics.equilibrium.solve`.
    pattern : sequence of Load
        The loads that grow together.
    most : float
        Largest factor of interest [-].
    careful : bool
        Whether a path that is lost in strides is walked again in small steps.
    driven : mapping, optional
        Motions at which an effort keeps the mechanism while the loads grow, free to buckle.
    start : Equilibrium, optional
        Where the path begins, as in :func:`flexcli.mechanics.equilibrium.solve`, of the layout that
        has not grown.
    effects, tolerance, levels
        As in :func:`flexcli.mechanics.equilibrium.solve`.

    Returns
    -------
    Critical
        Factor, state just below, multiplicity and mode.

    Raises
    ------
    SolveError
        ``unstable-start`` when the mechanism is unstable without the pattern, ``no-critical-load``
        when nothing is critical up to ``most``, ``lost-path`` when the path ends before,
        ``endless-path`` when it is too long, ``inaccurate`` when the finest nodes leave the factor
        unsure; what ``solve`` says of the equilibrium without the pattern.

    References
    ----------
    Allgower & Georg (2003), Introduction to Numerical Continuation Methods, chapters 4 and 5.

    """
    effects = Effects() if effects is None else effects
    held = {} if held is None else held
    along = _together(held, {} if driven is None else driven)
    cold = replace(layout, body_growth={}, blade_growth={})
    rest = solve(
        cold, along, start=start, effects=effects, tolerance=tolerance, levels=levels
    ).checked()
    coarse, grows = rest.parts[0].assembly, bool(layout.body_growth or layout.blade_growth)
    if grows:
        coarse = assemble(layout.grown(most), effects, coarse.nodes)
    index, free, _ = held_of(layout, held, coarse.length)
    if inertia_count_held(rest, held)[0]:
        raise unstable_start()
    demand = demand_of(coarse, along, pattern, most, rest)._replace(grown=not grows)
    demands = demand, demand._replace(held=index, free=free)
    gaits = (_STRIDES, _STEPS) if careful else (_STRIDES,)
    search, found = _first(coarse, demands, rest.parts[0].x[0], most, gaits)
    if len(levels) == 1:
        return _critical(search, found, np.inf, most)
    finer_levels = (level for level in levels if level > coarse.nodes)
    return _critical(*refined(search, found, finer_levels, tolerance), most)


def _together(held: Held, driven: Held) -> Held:
    """Return motions held and driven as one; what both name is held."""
    found = {}
    for body in {**held, **driven}:
        pairs = zip(held.get(body, _NOTHING), driven.get(body, _NOTHING), strict=True)
        x, y, phi = (other if one is None else one for one, other in pairs)
        found[body] = (x, y, phi)
    return found


def _first(
    assembly: Assembly,
    demands: tuple[Demand, Demand],
    x: Floats,
    most: float,
    gaits: Sequence[_Gait],
) -> tuple[Search, CriticalPoint]:
    """Return the first critical point of the path and the stretch it lies on."""
    for gait in gaits:
        try:
            search, low, high = _stretch(assembly, demands, x, most, gait)
            return search, first_critical(search, low, high)
        except SolveError as error:
            if error.code != "lost-path" or gait is gaits[-1]:
                raise
    raise lost_path()


def _stretch(
    assembly: Assembly, demands: tuple[Demand, Demand], x: Floats, most: float, gait: _Gait
) -> tuple[Search, Point, Point]:
    """Return the first step of the path over which stability is lost, and its ends."""
    demand, counted = demands
    known: list[tuple[Floats, int]] = []

    def unstable(x: Floats, parameter: float) -> int:
        if not (known and known[-1][0] is x):
            known.append((x, inertia_count_of_one(assembly, counted, x, parameter)))
        return known[-1][1]

    points = follow(
        steps_of(assembly, demand),
        (x, 0.0),
        arc_weight(assembly),
        stride=gait.first,
        longest=gait.longest,
        goal=lambda x, parameter: parameter >= 1.0 or unstable(x, parameter) > 0,
        kind=unstable,
        tolerance=_CORRECTION,
        most=_MOST,
        close=gait.close,
    )
    last = points[-1]
    lost = unstable(last.x, last.parameter) > 0
    if not lost and last.parameter >= 1.0:
        raise none_up_to(most)
    if not lost:
        # smaller steps lead no further along a path that is too long
        raise endless_path() if len(points) == _MOST else lost_path()
    before = points[-2]
    s = float(before.tangent @ (before.weight * (last.x - before.x)))
    s += before.slope * (last.parameter - before.parameter)
    at = assembly.linearise(before.x[None], np.array([before.parameter]), np.arange(1), demand)
    unit = row_units(closing_and_balance(assembly, counted, at))[0]
    search = Search(assembly, demand, counted, before, _STEPS.longest, unit)
    return (
        search,
        search.point(before.x, before.parameter, 0.0),
        search.point(last.x, last.parameter, s),
    )


def _critical(search: Search, found: CriticalPoint, error: float, most: float) -> Critical:
    if found.parameter > 1.0:
        raise none_up_to(most)
    side, assembly = found.before, search.assembly
    part = Part(assembly, search.demand, np.arange(1), side.x[None], np.array([side.parameter]))
    return Critical(
        factor=found.parameter * most,
        state=_state_of(part, error),
        multiplicity=found.after.unstable,
        mode=mode_of(assembly, search.counted, found.null * search.unit),
        turns=bool(abs(found.slope) < _LEVEL * search.plane.slope),
        estimated_error=error,
    )


def _state_of(part: Part, error: float) -> Equilibrium:
    """Return a point of a path as an equilibrium."""
    return Equilibrium(
        layout=part.assembly.layout,
        effects=part.assembly.effects,
        outcome=(Outcome.CONVERGED,),
        reached=part.share,
        iterations=np.zeros(1, dtype=np.intp),
        estimated_error=np.array([error]),
        nodes=np.array([part.assembly.nodes], dtype=np.intp),
        seconds=0.0,
        parts=(part,),
    )
