"""Stability of an equilibrium: how many ways there are to fall, the critical load and its mode."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.asked import demand_of
from flexcli.mechanics.assembly import Assembly, at_nodes, finer
from flexcli.mechanics.critical_point import (
    CriticalPoint,
    Point,
    Search,
    first_critical,
    lost_path,
    on_finer,
)
from flexcli.mechanics.demand import Demand, Held
from flexcli.mechanics.equilibrium import LEVELS, solve
from flexcli.mechanics.falling import closing_and_balance, row_units, ways_of_one
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.path import arc_weight, state_of, steps_of
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.numerics.arc_length import follow

__all__ = ["Critical", "critical_load", "is_stable", "unstable_directions"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

_FIRST, _LONGEST, _MOST = 0.02, 0.125, 300
"""First and longest step of arc length, over the largest factor; two losses of stability that are
made good within one step are not seen."""

_STILL = 1e-6
"""Motion of the bodies in a mode, over the forces in it, below which only blades buckle."""

_CORRECTION = 1e-12

_LEVEL = 1e-4
"""Slope of the load over the arc length below which the load turns."""


@dataclass(frozen=True, eq=False)
class Critical:
    """The critical factor of a load pattern, the state just below it, how many modes meet there.

    ``mode`` is the motion (x [m], y [m], φ [rad]) of each body in the direction of falling, with
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


def unstable_directions(state: Equilibrium) -> Integers:
    """Return in how many independent ways each design would fall if let go (designs,)."""
    return state.unstable


def is_stable(state: Equilibrium) -> NDArray[np.bool_]:
    """Return which designs stand by themselves, their held coordinates held (designs,)."""
    return np.asarray(state.unstable == 0)


def critical_load(
    layout: Layout,
    held: Held | None,
    pattern: Sequence[Load],
    *,
    most: float,
    effects: Effects | None = None,
    tolerance: float = 1e-9,
    levels: Sequence[int] = LEVELS,
) -> Critical:
    """Return the least factor in (0, most] on a load pattern at which an equilibrium is critical.

    The path runs from the equilibrium under the layout's own loads and what is held, by arc length,
    to where a first direction gets unstable. What ``held`` holds decides which load this is: a body
    locked, free to turn, or free in the plane are three different numbers.

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
    effects, tolerance, levels
        As in :func:`flexcli.mechanics.equilibrium.solve`.

    Returns
    -------
    Critical
        Factor, state just below, multiplicity and mode.

    Raises
    ------
    SolveError
        ``unstable-start`` when the mechanism falls without the pattern, ``no-critical-load``
        when nothing is critical up to ``most``, ``lost-path`` when the path ends before,
        ``inaccurate`` when the finest nodes leave the factor unsure; what ``solve`` says of the
        equilibrium without the pattern.

    References
    ----------
    Allgower & Georg (2003), Introduction to Numerical Continuation Methods, chapters 4 and 5.

    """
    effects = Effects() if effects is None else effects
    held = {} if held is None else held
    rest = solve(layout, held, effects=effects, tolerance=tolerance, levels=levels).checked()
    if rest.unstable[0]:
        raise SolveError(
            "unstable-start",
            "the mechanism is unstable before the load pattern acts",
            "hold more of its motions, or lessen its own loads",
        )
    coarse = rest.parts[0].assembly
    demand = demand_of(coarse, held, pattern, most, rest)
    search, low, high = _stretch(coarse, demand, rest.parts[0].x[0], most)
    found = first_critical(search, low, high)
    if len(levels) == 1:
        return _critical(search, found, np.inf, most)
    for nodes in (level for level in levels if level > coarse.nodes):
        fine = at_nodes(coarse, nodes)
        plane = search.plane._replace(
            x=finer(search.assembly, fine, search.plane.x[None])[0],
            tangent=finer(search.assembly, fine, search.plane.tangent[None])[0],
            weight=arc_weight(fine),
        )
        again = search._replace(assembly=fine, plane=plane)
        better = on_finer(search, again, found)
        error = abs(better.parameter / found.parameter - 1.0)
        search, found = again, better
        if error <= tolerance:
            return _critical(search, found, error, most)
    raise SolveError(
        "inaccurate",
        "the finest nodes do not settle the critical load",
        "ask for less accuracy",
    )


def _stretch(
    assembly: Assembly, demand: Demand, x: Floats, most: float
) -> tuple[Search, Point, Point]:
    """Return the first step of the path over which stability is lost, and its ends."""
    known: list[tuple[Floats, int]] = []

    def ways(x: Floats, parameter: float) -> int:
        if not (known and known[-1][0] is x):
            known.append((x, ways_of_one(assembly, demand, x, parameter)))
        return known[-1][1]

    points = follow(
        steps_of(assembly, demand),
        (x, 0.0),
        arc_weight(assembly),
        stride=_FIRST,
        longest=_LONGEST,
        goal=lambda x, parameter: parameter >= 1.0 or ways(x, parameter) > 0,
        kind=ways,
        tolerance=_CORRECTION,
        most=_MOST,
    )
    last = points[-1]
    fell = ways(last.x, last.parameter) > 0
    if not fell and last.parameter >= 1.0:
        raise _none_up_to(most)
    if not fell:
        raise lost_path()
    before = points[-2]
    s = float(before.tangent @ (before.weight * (last.x - before.x)))
    s += before.slope * (last.parameter - before.parameter)
    at = assembly.linearise(before.x[None], np.array([before.parameter]), np.arange(1), demand)
    unit = row_units(closing_and_balance(assembly, demand, at))[0]
    search = Search(assembly, demand, before, _LONGEST, unit)
    return (
        search,
        search.point(before.x, before.parameter, 0.0),
        search.point(last.x, last.parameter, s),
    )


def _critical(search: Search, found: CriticalPoint, error: float, most: float) -> Critical:
    if found.parameter > 1.0:
        raise _none_up_to(most)
    side, assembly = found.before, search.assembly
    part = Part(assembly, search.demand, np.arange(1), side.x[None], np.array([side.parameter]))
    layout, effects = assembly.layout, assembly.effects
    return Critical(
        factor=found.parameter * most,
        state=state_of(layout, effects, part, error, 0),
        multiplicity=found.after.ways,
        mode=_mode(search, found.null * search.unit),
        turns=bool(abs(found.slope) < _LEVEL * search.plane.slope),
        estimated_error=error,
    )


def _none_up_to(most: float) -> SolveError:
    return SolveError(
        "no-critical-load",
        f"no equilibrium up to {most:g} times the pattern is critical",
        "raise the largest factor, or turn the pattern round",
    )


def _mode(search: Search, null: Floats) -> Floats:
    """Return the motion of the bodies in the null vector of closing and balance (bodies, 3)."""
    assembly, free = search.assembly, search.demand.free
    mode = np.zeros(3 * assembly.bodies)
    forces, motions = null[: 3 * assembly.blades], null[3 * assembly.blades :]
    if np.max(np.abs(motions), initial=0.0) > _STILL * np.max(np.abs(forces)):
        largest = motions[np.argmax(np.abs(motions))]
        mode[free] = motions / largest * np.where(free % 3 == 2, 1.0, assembly.length[0])
    return mode.reshape(-1, 3)
