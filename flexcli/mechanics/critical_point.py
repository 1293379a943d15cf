"""The first point of a path at which its energy loses a direction: a root along the arc length."""

from collections.abc import Iterable
from typing import NamedTuple, Protocol, Self, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.assembly import Assembly, at_nodes, finer
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.inertia_count import closing_and_balance, inertia_count
from flexcli.mechanics.uncondensed import uncondensed
from flexcli.numerics.arc_length import Hyperplane, Steps, correct_on

__all__ = [
    "CriticalPoint",
    "Point",
    "Search",
    "Stretch",
    "arc_weight",
    "crossing",
    "endless_path",
    "first_critical",
    "lost_path",
    "mode_of",
    "none_up_to",
    "on_plane",
    "refined",
    "steps_of",
    "unstable_start",
    "without_poles",
]

Floats = NDArray[np.float64]

_ASIDE = 1e-6
"""How far to either side of a critical point the path is looked at, over the longest step.

Nearer, rounding grows as the equations get singular; the error of what is read off between the two
sides is the square."""

_NEAR = 1e-4
"""How near the next crossing is, over the longest step, where its two sides are looked at: by then
it is off by the product of the last two ways, which is less than the sides are apart."""

_SETTLING = 0.3
"""Way to the next crossing over the way to the last, below which the crossings converge."""

_CORRECTION = 1e-12
_MOST = 60

_REAL = 1e-3
"""Imaginary part of a ratio, over its size, that rounding gives to modes that meet."""

_STILL = 1e-6
"""Motion of the bodies in a mode, over the forces in it, below which only blades buckle."""

_APART = 1e-15
"""Change of P, over it, below which it tells of no crossing."""

_ALONE = np.arange(1)


class Point(NamedTuple):
    """An equilibrium on the plane s: λ, unknowns, inertia count, and P (see ``Search.point``)."""

    s: float
    parameter: float
    x: Floats
    P: Floats
    unstable: int


class CriticalPoint(NamedTuple):
    """Where a path gets critical: λ there, its two sides, and the null vector of P.

    ``slope`` is dλ/ds: zero where the load itself turns.
    """

    parameter: float
    before: Point
    after: Point
    null: Floats
    slope: float


class Stretch(Protocol):
    """A stretch of a path: planes at the distances s; ``length`` is the longest step on it."""

    @property
    def length(self) -> float:
        """Return the longest step along the path."""

    def at(self, s: float, low: Point, high: Point) -> Point:
        """Return the equilibrium on the plane s, from the straight line through two points."""

    def lifted(self, point: Point, fine: Self) -> Point:
        """Return a point with its unknowns at the nodes of a finer stretch."""

    def on(self, nodes: int) -> Self:
        """Return the same stretch at another number of nodes."""


_Stretch = TypeVar("_Stretch", bound=Stretch)


class Search(NamedTuple):
    """A stretch of a path: planes at the distances s from ``plane``, which is normal to it.

    ``counted`` is the demand with what is free in the inertia count; ``length`` is the
    longest step along the path, ``unit`` are those of blade forces and free motions in S.
    """

    assembly: Assembly
    demand: Demand
    counted: Demand
    plane: Hyperplane
    length: float
    unit: Floats

    def point(self, x: Floats, parameter: float, s: float) -> Point:
        """Return an equilibrium on the plane s as a point of the path.

        P is S without its poles (:func:`without_poles`).
        """
        at = self.assembly.linearise(x[None], np.array([parameter]), _ALONE, self.demand)
        unstable = int(inertia_count(self.assembly, self.counted, at, x[None], _ALONE)[0])
        S = closing_and_balance(self.assembly, self.counted, at)[0] * np.outer(self.unit, self.unit)
        return Point(s, parameter, x, without_poles(S, 3 * self.assembly.blades), unstable)

    def at(self, s: float, low: Point, high: Point) -> Point:
        """Return the equilibrium on the plane s, from the straight line through two points."""
        x, parameter = on_plane(self.plane, s, low, high, steps_of(self.assembly, self.demand))
        return self.point(x, parameter, s)

    def lifted(self, point: Point, fine: Self) -> Point:
        """Return a point with its unknowns at the nodes of a finer assembly."""
        return point._replace(x=finer(self.assembly, fine.assembly, point.x[None])[0])

    def on(self, nodes: int) -> Self:
        """Return the same stretch at another number of nodes."""
        fine = at_nodes(self.assembly, nodes)
        plane = self.plane._replace(
            x=finer(self.assembly, fine, self.plane.x[None])[0],
            tangent=finer(self.assembly, fine, self.plane.tangent[None])[0],
            weight=arc_weight(fine),
        )
        return self._replace(assembly=fine, plane=plane)


def arc_weight(assembly: Assembly) -> Floats:
    """Return the weights in arc length: rotations in the mean, motions, no forces."""
    weight = np.zeros(assembly.size)
    weight[: assembly.turns] = 1.0 / assembly.turns
    weight[assembly.turns + 3 * assembly.blades :] = 1.0
    return weight


def steps_of(assembly: Assembly, demand: Demand) -> Steps:
    """Return the steps of one mechanism for following its path by arc length."""
    alone = uncondensed(assembly, demand)
    if alone is not None:
        return alone.steps

    def steps(x: Floats, share: float) -> tuple[Floats, Floats]:
        step, rate = assembly.steps(x[None], np.array([share]), np.arange(1), demand)
        return step[0], rate[0]

    return steps


def without_poles(S: Floats, forces: int) -> Floats:
    """Return ``P = (S⁻¹ + Z)⁻¹`` of a matrix S of so many blade forces and of free motions.

    Z is a unit compliance of every body and a unit stiffness of every blade added: P is singular
    where S⁻¹ is infinite, and finite before, where S⁻¹ has the signs of Z. S itself has poles,
    where a blade with its ends free would buckle.
    """
    Z = np.ones(S.shape[-1])
    Z[:forces] = -1.0
    return np.asarray(np.linalg.solve(np.eye(Z.size) + S * Z, S))


def on_plane(
    plane: Hyperplane, s: float, low: Point, high: Point, steps: Steps
) -> tuple[Floats, float]:
    """Return the equilibrium on the plane at s, from the straight line through two points, and λ.

    Raises :class:`SolveError` where there is none.
    """
    share = (s - low.s) / (high.s - low.s)
    foot = plane._replace(
        x=low.x + share * (high.x - low.x),
        parameter=low.parameter + share * (high.parameter - low.parameter),
    )
    found = correct_on(foot, steps, _CORRECTION)
    if found is None:
        raise lost_path()
    return found.x, found.parameter


def refined(
    search: _Stretch, found: CriticalPoint, levels: Iterable[int], tolerance: float
) -> tuple[_Stretch, CriticalPoint, float]:
    """Return a critical point at more and more nodes until it settles, and its relative change.

    Raises :class:`SolveError` where the finest nodes leave it unsure.
    """
    for nodes in levels:
        again = search.on(nodes)
        better = on_finer(search, again, found)
        error = abs(better.parameter / found.parameter - 1.0)
        search, found = again, better
        if error <= tolerance:
            return search, found, error
    raise SolveError(
        "inaccurate",
        "the finest nodes do not settle the critical load",
        "the linear model tells the load at rest",
    )


def unstable_start() -> SolveError:
    """Return what is said of a mechanism that falls before its loads grow."""
    return SolveError(
        "unstable-start",
        "the mechanism is unstable before the load pattern acts",
        "hold more of its motions, or lessen its own loads",
    )


def none_up_to(most: float) -> SolveError:
    """Return what is said where nothing is critical up to a factor on the loads."""
    return SolveError(
        "no-critical-load",
        f"no equilibrium up to {most:g} times the loads is critical",
        "only the opposite direction of the loads may buckle it",
    )


def lost_path() -> SolveError:
    """Return what is said where no equilibrium is found on the way."""
    return SolveError(
        "lost-path",
        "the path of the load pattern is lost before anything is critical",
        "hold fewer of its motions, or lessen its stroke",
    )


def endless_path() -> SolveError:
    """Return what is said where the loads have hardly grown after many steps."""
    return SolveError(
        "endless-path",
        "the path of the load pattern is too long: the mechanism goes far under a part of it",
        "hold more of its motions, or lessen its loads",
    )


def first_critical(search: Stretch, low: Point, high: Point) -> CriticalPoint:
    """Return the first critical point between two points of a path, stable and unstable.

    Where ``P v = 0``: by the linear eigenvalue problem on the straight line through P at the two
    newest points, between sides that the inertia count tells apart, and by halves where
    no such line crosses between them.

    Parameters
    ----------
    search : Stretch
        The stretch of the path.
    low, high : Point
        Its ends.

    Returns
    -------
    CriticalPoint
        The point; the equilibrium before it is stable.

    Raises
    ------
    SolveError
        ``lost-path`` where no equilibrium is found between.

    References
    ----------
    Ruhe (1973), Algorithms for the nonlinear eigenvalue problem, section 3 (successive linear
    problems); Dekker (1969), Finding a zero by means of successive linear interpolation.

    """
    aside = _ASIDE * search.length
    older, newest, halve, last = low, high, False, np.inf
    for _ in range(_MOST):
        s, _ = crossing(older, newest, low.s, high.s)
        if high.s - low.s <= 2.0 * aside:
            return _between(low, high)
        move = abs(s - newest.s)
        settles, last = move <= _SETTLING * last, move
        if (halve and not settles) or not np.isfinite(s):
            older, newest, halve = newest, search.at((low.s + high.s) / 2.0, low, high), False
        elif move <= _NEAR * search.length or (met := _met(search, s, low, high)) is None:
            before, after = search.at(s - aside, low, high), search.at(s + aside, low, high)
            if before.unstable == 0 < after.unstable:
                return _between(before, after)
            older, newest = low, before if before.unstable else after
            halve, last = True, 0.0
        else:
            width = high.s - low.s
            older, newest = newest, met
            # an end that stands still is brought nearer by halves, unless the other arrives
            halve = max(newest.s - low.s, high.s - newest.s) > 0.9 * width
        low, high = (low, newest) if newest.unstable else (newest, high)
    raise lost_path()


def _met(search: Stretch, s: float, low: Point, high: Point) -> Point | None:
    """Return the equilibrium at s, or nothing beside an end or where the equations are singular."""
    if min(s - low.s, high.s - s) <= _ASIDE * search.length:
        return None
    try:
        return search.at(s, low, high)
    except SolveError:
        return None


def on_finer(search: _Stretch, fine: _Stretch, found: CriticalPoint) -> CriticalPoint:
    """Return a critical point again, with more nodes."""
    sides = [search.lifted(side, fine) for side in (found.before, found.after)]
    aside, reach = _ASIDE * search.length, 1.0
    while reach * aside < search.length:
        middle = (found.before.s + found.after.s) / 2.0
        low, high = (fine.at(middle + side * reach * aside, *sides) for side in (-1.0, 1.0))
        if low.unstable == 0 < high.unstable:
            return _between(low, high) if reach == 1.0 else first_critical(fine, low, high)
        reach *= 30.0
    raise lost_path()


def crossing(one: Point, other: Point, least: float, most: float) -> tuple[float, Floats]:
    """Return the first s between bounds at which P is singular if it is straight, and Pv = 0.

    ``P_2 v = μ P_1 v`` has μ < 0 where v changes sides, whatever the units; infinite where none.
    """
    try:
        ratios, vectors = np.linalg.eig(np.linalg.solve(one.P, other.P))
    except np.linalg.LinAlgError:
        # one is the crossing itself
        return np.inf, np.zeros(len(one.P))
    real = np.abs(ratios.imag) <= _REAL * (1.0 + np.abs(ratios))
    parts = np.abs(1.0 - ratios.real) > _APART
    share = 1.0 / np.where(real & parts, 1.0 - ratios.real, np.inf)
    s = np.where(real & parts, one.s + share * (other.s - one.s), np.inf)
    s = np.where((s > least) & (s < most), s, np.inf)
    first = int(np.argmin(s))
    return float(s[first]), vectors[:, first].real


def _between(before: Point, after: Point) -> CriticalPoint:
    """Return the critical point on the straight line between its two sides."""
    s, null = crossing(before, after, before.s, after.s)
    if not np.isfinite(s):
        raise lost_path()
    slope = (after.parameter - before.parameter) / (after.s - before.s)
    return CriticalPoint(before.parameter + slope * (s - before.s), before, after, null, slope)


def mode_of(assembly: Assembly, demand: Demand, null: Floats) -> Floats:
    """Return the motion of the bodies in the null vector of closing and balance (bodies, 3).

    Its largest entry (lengths in mean blade lengths) is one; zero when only blades buckle.
    """
    free = demand.free
    mode = np.zeros(3 * assembly.bodies)
    forces, motions = null[: 3 * assembly.blades], null[3 * assembly.blades :]
    if np.max(np.abs(motions), initial=0.0) > _STILL * np.max(np.abs(forces)):
        largest = motions[np.argmax(np.abs(motions))]
        mode[free] = motions / largest * np.where(free % 3 == 2, 1.0, assembly.length[0])
    return mode.reshape(-1, 3)
