"""Critical loads of straight blades: what the axial forces of the linear solution do at rest."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import inf, isfinite
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.assembly import Assembly, assemble
from flexcli.mechanics.critical_point import Point, crossing, mode_of, without_poles
from flexcli.mechanics.demand import Demand, Held
from flexcli.mechanics.inertia_count import closing_and_balance, inertia_count, row_units
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.linear import straight_state
from flexcli.mechanics.mesh import Effects, meshes
from flexcli.mechanics.prescribed_motion import demand_of

__all__ = ["LinearCritical", "linear_critical"]

Floats = NDArray[np.float64]

_NODES = 12
"""Nodes on a piece: exact to rounding for blades up to some twice their clamped Euler load."""

_MANY, _SMOOTH = 40, 120.0
"""Nodes where a blade bears more than so many EI/l²: its moment then dies out near its ends."""

_AT_FIRST, _HALVINGS = 80.0, 8
"""Force looked at first [EI/l²], twice what buckles a clamped blade, and how many halves of it."""

_FAR = 24
"""Factors looked at beyond these."""

_CUTS = 12
"""Pieces that the stretch in which stability is lost is cut into."""

_MOST = 40

_ZERO = 1e-15
"""Ratio of a matrix's eigenvalues that is zero to rounding."""

_SETTLED = 1e-11
"""Change of the factor [-] that is rounding."""


@dataclass(frozen=True, eq=False)
class LinearCritical:
    """The critical factor of a load pattern on straight blades, and how they carry it.

    ``factor`` is infinite where nothing is critical up to ``most``. ``tensions`` (blades,) are the
    axial forces per factor [N], ``strain`` and ``stress`` [Pa] the largest magnitudes of theirs,
    where blades are thinnest. ``bends`` is the largest motion across a blade of one end against
    the other, over its length and ``strain``, ``turns`` the largest rotation of a body over
    ``strain``: both zero where the load leaves the blades straight. ``mode`` is the motion of each
    body (x [m], y [m], φ [rad]) in its unstable direction, zero when blades alone buckle.
    """

    factor: float
    most: float
    tensions: Floats
    strain: float
    stress: float
    bends: float
    turns: float
    mode: Floats


class _Straight(NamedTuple):
    """Straight blades under axial forces in proportion to the factor: a path without bending."""

    assembly: Assembly
    demand: Demand
    unit: Floats
    state: Floats

    def points(self, factors: Floats) -> list[Point]:
        """Return the states at factors as points of a path, whose place is the factor."""
        rows, x = np.arange(factors.size), factors[:, None] * self.state
        at = self.assembly.linearise(x, factors, rows, self.demand)
        unstable = inertia_count(self.assembly, self.demand, at, x, rows)
        S = closing_and_balance(self.assembly, self.demand, at) * np.outer(self.unit, self.unit)
        P = without_poles(S, 3 * self.assembly.blades)
        return [
            Point(float(f), float(f), *rest)
            for f, *rest in zip(factors, x, P, unstable, strict=True)
        ]


def linear_critical(
    layout: Layout,
    held: Held | None,
    pattern: Sequence[Load],
    *,
    strain: float = 0.3,
    effects: Effects | None = None,
) -> LinearCritical:
    """Return the least factor on a load pattern at which straight blades buckle.

    The blades stay straight and carry the axial forces of the linear solution, in proportion to
    the factor; each bends as a beam under that force, by the exact solution of its equation, with
    shear and stretching as in the exact model. Negative directions are counted of the bodies and
    of the blades' own bending alike, so that blades which buckle between bodies that stand still
    are not missed.

    Parameters
    ----------
    layout : Layout
        One mechanism (not a batch), without loads of its own.
    held : mapping or None
        Motions that stay held, all at zero.
    pattern : sequence of Load
        The loads that grow together.
    strain : float
        Largest axial strain of interest in a blade [-].
    effects : Effects, optional
        Which deformations blades have besides bending; all of them by default.

    Returns
    -------
    LinearCritical
        Factor, axial forces and mode.

    Raises
    ------
    SolveError
        ``singular`` when the layout has no unique linear solution, ``unstable-start`` when it
        falls at a hundredth of a millionth of the strain.

    Notes
    -----
    Exact where the load leaves the blades straight; what they bend before they buckle is left out.

    References
    ----------
    Wittrick & Williams (1971), A general algorithm for computing natural frequencies of elastic
    structures (the count); Bažant & Cedolin (1991), Stability of Structures, section 2.1.

    """
    effects = Effects() if effects is None else effects
    held = {} if held is None else held
    found = _at_nodes(layout, held, pattern, strain, effects, _NODES)
    finite = found.factor if isfinite(found.factor) else 0.0
    if finite * _scaled(layout, effects, found.tensions) <= _SMOOTH:
        return found
    return _at_nodes(layout, held, pattern, strain, effects, _MANY)


def _scaled(layout: Layout, effects: Effects, tensions: Floats) -> float:
    """Return the largest |N| l²/EI of the blades [-]."""
    found = 0.0
    for mesh in meshes(layout, effects, 1):
        scale = np.broadcast_to(mesh.l**2 / mesh.EI, (1, len(mesh.blades)))[0]
        found = max(found, float(np.max(np.abs(tensions[list(mesh.blades)]) * scale)))
    return found


def _at_nodes(
    layout: Layout,
    held: Held,
    pattern: Sequence[Load],
    strain: float,
    effects: Effects,
    nodes: int,
) -> LinearCritical:
    assembly = assemble(layout, effects, nodes)
    demand = demand_of(assembly, held, pattern)
    found, state, tensions = straight_state(assembly, demand)
    if not np.all(np.isfinite(state)):
        raise SolveError(
            "singular",
            "the mechanism at rest has no unique linear answer",
            "hold or support every body",
        )
    stress, bends = _carried(assembly, tensions[0], found.motions[0])
    strained = float(np.max(stress)) / float(np.max(layout.E))
    turns = float(np.max(np.abs(found.motions[0, :, 2])))
    most = strain / strained if strained else inf
    carried = {
        "most": most,
        "tensions": tensions[0],
        "strain": strained,
        "stress": float(np.max(stress)),
        "bends": bends / strained if strained else inf,
        "turns": turns / strained if strained else inf,
    }
    if not strained:  # no blade bears any of it along itself: nothing to buckle
        return LinearCritical(inf, **carried, mode=np.zeros((assembly.bodies, 3)))
    rest = assembly.linearise(0.0 * state, np.zeros(1), np.arange(1), demand)
    unit = row_units(closing_and_balance(assembly, demand, rest))[0]
    path = _Straight(assembly, demand, unit, state)
    between = _bracket(path, most, 1.0 / _scaled(layout, effects, tensions[0]))
    if between is None:
        return LinearCritical(inf, **carried, mode=np.zeros((assembly.bodies, 3)))
    factor, null = _refined(path, *between)
    return LinearCritical(factor, **carried, mode=mode_of(assembly, demand, null * unit))


def _carried(assembly: Assembly, tensions: Floats, motions: Floats) -> tuple[Floats, float]:
    """Return the axial stress of each blade [Pa], and the largest motion across one over l [-]."""
    layout, names = assembly.layout, [body.name for body in assembly.layout.bodies]
    stress, bends = np.zeros(len(layout.blades)), 0.0
    for mesh in assembly.meshes:
        area = np.broadcast_to(mesh.b * mesh.thinnest, (1, len(mesh.blades)))[0]
        stress[list(mesh.blades)] = np.abs(tensions[list(mesh.blades)]) / area
    for blade in layout.blades:
        start, end = (np.array(point, dtype=np.float64) for point in (blade.start, blade.end))
        l = float(np.hypot(*(end - start)))
        across = np.array([start[1] - end[1], end[0] - start[0]]) / l
        moved = []
        for name, point in ((blade.first, start), (blade.second, end)):
            if name not in names:
                moved.append(0.0)
                continue
            x, y, phi = motions[names.index(name)]
            arm = point - np.array(layout.body(name).point, dtype=np.float64)
            moved.append(float(across @ (x - phi * arm[1], y + phi * arm[0])))
        bends = max(bends, abs(moved[1] - moved[0]) / l)
    return stress, bends


def _bracket(path: _Straight, most: float, one: float) -> tuple[Point, Point] | None:
    """Return two points a few per cent apart, one at which it is stable and one at which it is not.

    ``one`` is the factor at which the most loaded blade bears EI/l².
    """
    top = min(most, _AT_FIRST * one)
    points = path.points(np.array([top * 0.5**i for i in reversed(range(_HALVINGS))]))
    if points[0].unstable > 0:
        low = points[0].s
        points = [*path.points(np.array([low * 0.5**i for i in range(_FAR, 0, -1)])), *points]
    elif points[-1].unstable == 0 and top < most:
        larger = most / top
        points = path.points(np.array([top * larger ** (i / _FAR) for i in range(_FAR + 1)]))
    if points[-1].unstable == 0:
        return None
    low_point, high_point = _first_fall(points)
    low, width = low_point.s, high_point.s - low_point.s
    between = path.points(np.array([low + width * i / _CUTS for i in range(1, _CUTS)]))
    return _first_fall([low_point, *between, high_point])


def _first_fall(points: list[Point]) -> tuple[Point, Point]:
    for a, b in pairwise(points):
        if a.unstable <= 0 < b.unstable:
            return a, b
    raise SolveError(
        "unstable-start",
        "the mechanism is unstable without its load",
        "hold more of its motions",
    )


def _refined(path: _Straight, low: Point, high: Point) -> tuple[float, Floats]:
    """Return where P is first singular between two points, and its null vector there."""
    older, newest, last = low, high, np.inf
    for _ in range(_MOST):
        s, _ = crossing(older, newest, low.s, high.s)
        if not np.isfinite(s):
            s = (low.s + high.s) / 2.0
        ratios, vectors = np.linalg.eig(newest.P)
        sizes = np.abs(ratios)
        if abs(s - last) <= _SETTLED * s or high.s - low.s <= _SETTLED * s:
            return s, vectors[:, int(np.argmin(sizes))].real
        if last < np.inf and np.min(sizes) <= _ZERO * np.max(sizes):
            return last, vectors[:, int(np.argmin(sizes))].real
        last, (point,) = s, path.points(np.array([s]))
        older, newest = newest, point
        low, high = (low, point) if point.unstable else (point, high)
    raise SolveError("inaccurate", "the critical load of straight blades does not settle", "")
