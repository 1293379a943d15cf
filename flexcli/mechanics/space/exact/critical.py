"""Critical loads of a mechanism in space: where on a load's path a first direction gets unstable.

Unstable directions are counted in sections and bodies alike, so that blades which buckle between
bodies that stand still are found as well.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from math import inf, sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.critical_point import (
    CriticalPoint,
    Point,
    crossing,
    first_critical,
    lost_path,
    none_up_to,
    on_plane,
    refined,
    unstable_start,
    without_poles,
)
from flexcli.mechanics.refinement import LEVELS
from flexcli.mechanics.space.exact.assembly import Assembly, assemble, at_nodes, finer
from flexcli.mechanics.space.exact.beams import beams_of
from flexcli.mechanics.space.exact.demand import Demand, Frame, Held, demand_of
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium, solve, started
from flexcli.mechanics.space.exact.members import MembersOf
from flexcli.mechanics.space.exact.second_variation import inertia_count, second_variation
from flexcli.mechanics.space.exact.support import unstable_when_free
from flexcli.mechanics.space.layout import BeamEffects, SpaceLayout, SpaceLoad
from flexcli.numerics.arc_length import CLOSE, Hyperplane, Steps, correct_on, follow

__all__ = ["NEAR_STRAIGHT", "SpaceCritical", "Walked", "critical_load", "straight_critical_factor"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

_FIRST, _LONGEST, _MOST = 0.02, 0.2, 100
_CORRECTION = 1e-12

_WALKED = 1e-6
"""Accuracy of the points that the walk goes over. What is rough from node to node, Newton's method
lessens there by a half a step: to more digits its iterations would not tell how long the steps may
be (a rod bent and twisted far took a hundred steps of 0.001, not ten of 0.1)."""

_BACK = (1.0, 0.95, 0.8)
"""Of how far a path was seen: where it is looked whether it stands on finer nodes."""

_STILL = 1e-6
"""Motion of the bodies in a mode, over the forces in it, below which only blades buckle."""

NEAR_STRAIGHT = 1e-3
"""How closely the factor of a mechanism that keeps its first shape is found, relative."""

_MOVED = 0.01
"""Share by which more nodes may move a critical load: one that moves more may be another."""

_ROUGHLY = 4.0
"""Ratio of an unstable factor to a stable one, below which a matrix is nearly straight between."""

_TRIES = 3
"""Shares on the straight line that may lessen what is not known by less than half, in a row."""

_LEVEL = 1e-4
"""Slope of the load over the arc length below which the load turns."""


@dataclass(frozen=True, eq=False)
class SpaceCritical:
    """The critical factor of a load pattern and how many modes meet there.

    ``mode`` (bodies, 6) is the motion of the bodies in the unstable direction, in their frames,
    with a largest entry (lengths in mean blade lengths) of one, zero when only blades buckle.
    ``turns`` tells a limit point from a branching point; ``estimated_error`` is relative. The
    factor is infinite where no equilibrium up to the largest of interest is critical. Where the
    path ``is_lost`` it is how far that was followed, stable: what is critical lies beyond.
    ``walked`` is how far its path was, where that is neither critical nor lost.
    """

    factor: float
    multiplicity: int
    mode: Floats
    turns: bool
    estimated_error: float
    is_lost: bool = False
    walked: "Walked | None" = None


class Walked(NamedTuple):
    """Unknowns and factor of an equilibrium on a path of loads on which none before is critical."""

    x: Floats
    factor: float


class _Search(NamedTuple):
    """A stretch of the path (``Stretch``); ``free`` are the coordinates free in the count."""

    assembly: Assembly
    demand: Demand
    free: Integers
    plane: Hyperplane
    length: float
    unit: Floats

    def point(self, x: Floats, parameter: float, s: float) -> Point:
        """Return an equilibrium on the plane s as a point of the path."""
        return self.of(
            x, parameter, s, _counted(self.assembly, self.demand, self.free, x, parameter)
        )

    def of(self, x: Floats, parameter: float, s: float, counted: tuple[Floats, int]) -> Point:
        """Return a point of which the matrix and the unstable directions are known."""
        S, unstable = counted
        P = _without_poles(S, self.unit, self.assembly.blades)
        return Point(s, parameter, x, P, unstable)

    def at(self, s: float, low: Point, high: Point) -> Point:
        """Return the equilibrium on the plane s, from the straight line through two points."""
        x, parameter = on_plane(self.plane, s, low, high, _steps(self.assembly, self.demand))
        return self.point(x, parameter, s)

    def lifted(self, point: Point, fine: "_Search") -> Point:
        """Return a point with its unknowns at the nodes of a finer assembly."""
        return point._replace(x=finer(self.assembly, fine.assembly, point.x[None])[0])

    def on(self, nodes: int) -> "_Search":
        """Return the same stretch at another number of nodes."""
        fine = at_nodes(self.assembly, nodes)
        return self._replace(assembly=fine, plane=_lifted(self.plane, self.assembly, fine))


def critical_load(
    layout: SpaceLayout,
    held: Held | None,
    pattern: Sequence[SpaceLoad],
    *,
    most: float,
    released: Sequence[int] = (),
    frames: Mapping[str, Frame] | None = None,
    start: SpaceEquilibrium | None = None,
    effects: BeamEffects | None = None,
    tolerance: float = 1e-7,
    levels: Sequence[int] = LEVELS,
    made: MembersOf = beams_of,
    walked: "Walked | None" = None,
) -> SpaceCritical:
    """Return the least factor in (0, most] on a load pattern at which an equilibrium is critical.

    Parameters
    ----------
    layout : SpaceLayout
        The mechanism; what a temperature makes it grow by belongs to the pattern.
    held : mapping or None
        Motions held while the loads grow, as in
        :func:`flexcli.mechanics.space.exact.equilibrium.solve`.
    pattern : sequence of SpaceLoad
        The loads that grow together.
    most : float
        Largest factor of interest [-].
    released : sequence of int
        Coordinates (6 body + 0…5) of those held that are free to buckle: the drive, where it is
        an effort that keeps its size.
    frames, start, effects, tolerance, levels, made
        As in :func:`flexcli.mechanics.space.exact.equilibrium.solve`, of the layout that has not
        grown; the tolerance is relative.
    walked : Walked, optional
        How far the path of the same loads is known.

    Returns
    -------
    SpaceCritical
        Factor, multiplicity and mode.

    Raises
    ------
    SolveError
        ``unstable-start`` when it is unstable without the pattern, ``lost-path`` when the path
        is lost and where it was seen last does not stand on finer nodes, ``inaccurate`` when the
        finest nodes leave the factor unsure.

    """
    cold = replace(layout, body_growth={}, blade_growth={})
    rest = solve(
        cold, held, frames=frames, effects=effects, start=start, tolerance=tolerance,
        levels=levels, made=made,
    ).checked()  # fmt: skip
    coarse, demand, free = _begun(layout, held, pattern, most, released, rest, made)
    begin = rest.part.x, 0.0
    if walked is not None and walked.x.size == begin[0].size and walked.factor < most:
        begin = walked.x, walked.factor / most
    points, falls = _walk(coarse, demand, free, begin)
    finer_levels = [level for level in levels if level > coarse.members.level]
    still = np.zeros((coarse.bodies, 6))
    try:
        if not falls and points[-1].parameter >= 1.0:
            raise none_up_to(most)
        if not falls:
            raise lost_path()
        search, low, high = _stretch(coarse, demand, free, *points[-2:])
        found = first_critical(search, low, high)
        search, last, change = refined(search, found, finer_levels, tolerance)
        if abs(last.parameter / found.parameter - 1.0) <= max(_MOVED, 2.0 * tolerance):
            return _critical(search, last, change, most)
    except SolveError as error:
        if error.code == "lost-path" and finer_levels:
            fine = at_nodes(coarse, finer_levels[0])
            share, off = _seen(coarse, fine, demand, free, points[:-1] if falls else points)
            return SpaceCritical(share * most, 0, still, False, off, is_lost=True)
        if error.code != "no-critical-load":
            raise
        far = None if falls else Walked(points[-1].x, points[-1].parameter * most)
        return SpaceCritical(inf, 0, still, False, 0.0, walked=far)
    # too few nodes led past the first point: those that are more look for it from the start
    return critical_load(
        layout, held, pattern, most=most, released=released, frames=frames, start=start,
        effects=effects, tolerance=tolerance, levels=finer_levels, made=made,
    )  # fmt: skip


def straight_critical_factor(
    layout: SpaceLayout,
    held: Held | None,
    pattern: Sequence[SpaceLoad],
    *,
    most: float,
    released: Sequence[int] = (),
    frames: Mapping[str, Frame] | None = None,
    start: SpaceEquilibrium | None = None,
    close: float = NEAR_STRAIGHT,
) -> float:
    """Return the least factor on a load pattern at which beams that do not move would buckle.

    They bear the forces of small motion in their first shape. A small load across a slender beam
    makes it bow from the first on, and its path passes no critical point where the straight beam
    buckles, though it moves far from there on.

    Parameters
    ----------
    layout, held, pattern, most, released, frames
        As in :func:`critical_load`.
    start : SpaceEquilibrium or None
        Beams without the pattern, as they are held.
    close : float
        How closely it is found, from below, relative.

    Returns
    -------
    float
        The factor; infinite where there is none up to ``most``.

    Raises
    ------
    SolveError
        ``unstable-start`` when it is unstable without the pattern.

    Notes
    -----
    The second variation is linear in the forces while nothing moves, so that what is unstable
    stays so beyond: the factor is bracketed by ever longer steps down, bisected, and where it is
    roughly known met on the straight line through its matrix on both sides.

    """
    cold = replace(layout, body_growth={}, blade_growth={})
    rest = solve(cold, held, frames=frames, start=start).checked()
    assembly, demand, free = _begun(layout, held, pattern, most, released, rest, beams_of)
    x = rest.part.x
    rate = assembly.split(assembly.steps(x, 0.0, demand)[1]).forces

    def counted(share: float) -> tuple[Floats, int]:
        still = x.copy()
        assembly.split(still).forces[:] += share * rate
        return _counted(assembly, demand, free, still, share)

    S, unstable = counted(1.0)
    if unstable == 0:
        return inf
    unit = _units(S)

    def point(share: float) -> Point:
        S, unstable = counted(share)
        return Point(share, share, x, _without_poles(S, unit, assembly.blades), unstable)

    newest = Point(1.0, 1.0, x, _without_poles(S, unit, assembly.blades), unstable)
    low, high, before, missed, down = 0.0, 1.0, 1.0, 0, 0.5
    # a straight column's own load is found by its path as well: it is just below
    share = 1.0 - NEAR_STRAIGHT
    while True:
        older, newest = newest, point(share)
        low, high = (low, share) if newest.unstable else (share, high)
        width = high - low
        if width <= close * high or high <= _CORRECTION:
            return low * most
        missed, before = (0 if width <= before / 2.0 else missed + 1), width
        if high <= _ROUGHLY * low:
            share = (low + high) / 2.0
            if missed < _TRIES:
                share = _beside_crossing(older, newest, (low, high), close * high / 4.0)
        elif low > 0.0:
            share = sqrt(low * high)
        else:
            share, down = down * high, down**2


def _beside_crossing(
    older: Point, newest: Point, between: tuple[float, float], aside: float
) -> float:
    """Return a share beside where P at two points is singular, on the side less known of.

    By halves where it crosses nowhere between a stable and an unstable share, or beside an end.
    """
    low, high = between
    share, _ = crossing(older, newest, low, high)
    share += -aside if share - low > high - share else aside
    return share if low + aside < share < high - aside else (low + high) / 2.0


def _begun(
    layout: SpaceLayout,
    held: Held | None,
    pattern: Sequence[SpaceLoad],
    most: float,
    released: Sequence[int],
    rest: SpaceEquilibrium,
    made: MembersOf,
) -> tuple[Assembly, Demand, Integers]:
    """Return a mechanism at rest, what its loads ask of it, and the coordinates free to buckle."""
    if unstable_when_free(rest, released):
        raise unstable_start()
    coarse = assemble(layout, rest.effects, rest.part.assembly.members.level, rest.frames, made)
    coarse = coarse._replace(growth=most * coarse.growth)
    demand = started(
        rest,
        demand_of(layout, held or {}, pattern, coarse.points, coarse.length, coarse.force, most),
    )._replace(grown=False)
    free = np.union1d(demand.free, np.asarray(released, dtype=np.intp)).astype(np.intp)
    return coarse, demand, free


def _counted(
    assembly: Assembly, demand: Demand, free: Integers, x: Floats, share: float
) -> tuple[Floats, int]:
    """Return the matrix of blade forces and free coordinates, and the unstable directions."""
    at = assembly.linearise(x, share, demand)
    variation = second_variation(assembly, demand, at, x, share)
    return (
        variation.of(free, assembly.blades),
        inertia_count(variation, free, assembly.blades),
    )


def _walk(
    assembly: Assembly, demand: Demand, free: Integers, start: tuple[Floats, float]
) -> tuple[list[Hyperplane], bool]:
    """Return the points of a path as far as it is found, and whether the last is unstable.

    It starts at stable unknowns and their share of the loads.
    """
    known: list[tuple[Floats, int]] = []  # of the last point of the path, and of one tried beyond

    def unstable(x: Floats, parameter: float) -> int:
        found = next((each for each in known if each[0] is x), None)
        if found is None:
            found = x, _counted(assembly, demand, free, x, parameter)[1]
        known[:] = [*[each for each in known if each[0] is not x][-1:], found]
        return found[1]

    points = follow(
        _steps(assembly, demand),
        start,
        _weight(assembly),
        stride=_FIRST,
        longest=_LONGEST,
        goal=lambda x, parameter: parameter >= 1.0 or unstable(x, parameter) > 0,
        kind=unstable,
        tolerance=_WALKED,
        most=_MOST,
        close=CLOSE,
    )
    return points, unstable(points[-1].x, points[-1].parameter) > 0


def _seen(
    coarse: Assembly, fine: Assembly, demand: Demand, free: Integers, points: list[Hyperplane]
) -> tuple[float, float]:
    """Return a share up to which a path that is lost was stable, and by how much it may be off.

    It is the farthest of its points that stands on finer nodes as well; how far off it is there
    tells its error.
    """
    for share in _BACK:
        seen = [point for point in points if point.parameter <= share * points[-1].parameter][-1]
        found = correct_on(_lifted(seen, coarse, fine), _steps(fine, demand), _WALKED)
        if found is None or _counted(fine, demand, free, found.x, found.parameter)[1]:
            continue
        if seen.parameter > 0.0 and found.parameter > 0.0:
            least = min(seen.parameter, found.parameter)
            return least, abs(found.parameter - seen.parameter) / least
    raise lost_path()


def _lifted(plane: Hyperplane, coarse: Assembly, fine: Assembly) -> Hyperplane:
    """Return a point of a path with its tangent at the nodes of a finer assembly."""
    return plane._replace(
        x=finer(coarse, fine, plane.x[None])[0],
        tangent=finer(coarse, fine, plane.tangent[None])[0],
        weight=_weight(fine),
    )


def _stretch(
    assembly: Assembly, demand: Demand, free: Integers, before: Hyperplane, last: Hyperplane
) -> tuple[_Search, Point, Point]:
    """Return a step of the path over which stability is lost, and its ends."""
    s = float(before.tangent @ (before.weight * (last.x - before.x)))
    s += before.slope * (last.parameter - before.parameter)
    counted = _counted(assembly, demand, free, before.x, before.parameter)
    search = _Search(assembly, demand, free, before, _LONGEST, _units(counted[0]))
    return (
        search,
        search.of(before.x, before.parameter, 0.0, counted),
        search.point(last.x, last.parameter, s),
    )


def _units(S: Floats) -> Floats:
    """Return the units of blade forces and free coordinates in which a matrix is of order one."""
    size = np.max(np.abs(S), axis=-1)
    return np.asarray(1.0 / np.sqrt(np.where(size > 0.0, size, 1.0)))


def _without_poles(S: Floats, unit: Floats, blades: int) -> Floats:
    return without_poles(S * np.outer(unit, unit), 6 * blades)


def _steps(assembly: Assembly, demand: Demand) -> Steps:
    return lambda x, share: assembly.steps(x, share, demand)


def _weight(assembly: Assembly) -> Floats:
    """Return the weights in arc length: rotations in the mean, motions, no forces."""
    weight = np.zeros(assembly.size)
    parts = assembly.split(weight)
    parts.inside[:] = assembly.members.weight()
    parts.shift[:] = 1.0
    parts.turn[:] = 4.0
    return weight


def _critical(search: _Search, found: CriticalPoint, error: float, most: float) -> SpaceCritical:
    if found.parameter > 1.0:
        raise none_up_to(most)
    assembly, null = search.assembly, found.null * search.unit
    forces, motions = null[: 6 * assembly.blades], null[6 * assembly.blades :]
    mode = np.zeros(6 * assembly.bodies)
    if np.max(np.abs(motions), initial=0.0) > _STILL * np.max(np.abs(forces)):
        mode[search.free] = motions / motions[np.argmax(np.abs(motions))]
    return SpaceCritical(
        factor=found.parameter * most,
        multiplicity=found.after.unstable,
        mode=mode.reshape(-1, 6),
        turns=bool(abs(found.slope) < _LEVEL * search.plane.slope),
        estimated_error=error,
    )
