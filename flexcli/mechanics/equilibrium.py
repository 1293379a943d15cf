"""Equilibrium of any planar mechanism of rigid bodies and blades, at any stroke and load.

Formulation: blades are geometrically exact (Reissner) beams in mixed form. Nothing loads a blade
between its ends, so its force is constant along it and, with the moment at its end, makes three
unknowns; statics gives the moment along the blade from the deformed centre line. The rotations of
the sections sit at Gauss nodes on each smooth piece of the thickness profile (collocation, order
twice the number of nodes at the ends) and are eliminated blade by blade, which leaves the end
motion and a 3 × 3 flexibility. Closing every blade between its bodies (3 equations) and balancing
every body (3 equations) gives one small symmetric system a design, in scaled variables in which no
stiffness stands: thin, short or inextensible blades are all alike. Newton's method takes whole
batches of designs; the first step from a known equilibrium is the tangent of the path, the second
tells how far the path bends, and the stroke is cut where that is too far to be sure of the branch.
A second solution with more nodes gives the error, design by design, until it is small enough.
"""

from collections.abc import Sequence
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly, assemble, at_nodes, finer
from flexcli.mechanics.demand import Demand, Held
from flexcli.mechanics.inertia_count import inertia_count
from flexcli.mechanics.layout import Layout, Load, Number
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of, designs_of
from flexcli.mechanics.state import Equilibrium, Outcome, Part
from flexcli.numerics.continuation import TRUST, March, march
from flexcli.numerics.newton import NewtonEnd, NewtonResult, newton

__all__ = ["LEVELS", "Equilibrium", "Outcome", "difference", "solve"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

LEVELS = (8, 12, 18, 27, 40, 60, 90, 135)
"""Gauss nodes on a piece, level by level; each level tells the error of the one before."""

_NOTHING = 1e-280
"""Size of the unknowns below which numbers have no digits left, and no error."""

_NEWTON = 1e-3
"""Newton's tolerance over the tolerance asked."""


def solve(
    layout: Layout,
    held: Held | None = None,
    *,
    loads: Sequence[Load] = (),
    load_factor: Number = 1.0,
    effects: Effects | None = None,
    tolerance: float = 1e-9,
    start: Equilibrium | None = None,
    levels: Sequence[int] = LEVELS,
) -> Equilibrium:
    """Return the equilibrium on the path from rest, or from ``start``, to the motions and loads.

    Parameters
    ----------
    layout : Layout
        The mechanism, or a batch of them.
    held : mapping, optional
        Motion (x [m], y [m], φ [rad]) of the reference point of bodies, None where free.
    loads : sequence of Load
        Loads besides those of the layout, each times ``load_factor``.
    load_factor : Number
        Factor on ``loads`` [-].
    effects : Effects, optional
        Which deformations blades have besides bending; all of them by default.
    tolerance : float
        Error of the blades' end forces, over the largest of them, and of motions, over the
        largest (lengths in mean blade lengths) [-].
    start : Equilibrium, optional
        Where the path begins: an equilibrium of the same layout, whatever was held or loaded.
    levels : sequence of int
        Gauss nodes on a piece, level by level; a single one is taken as it is, its error unknown.

    Returns
    -------
    Equilibrium
        The solution of each design, or how far it came and why.

    Raises
    ------
    KeyError
        When a body of ``held`` or of a load is not in the layout.

    """
    begun = perf_counter()
    effects = Effects() if effects is None else effects
    held = {} if held is None else held
    coarse = assemble(layout, effects, levels[0])
    demand = demand_of(coarse, held, loads, load_factor, start)
    designs = designs_of(coarse, demand)
    x = np.zeros((designs, coarse.size))
    if start is not None:
        for part in start.parts:
            x[part.rows] = finer(part.assembly, coarse, part.x)
    scale = coarse.length_of(x, x)
    path = _march(coarse, demand, x, scale, tolerance)
    iterations, error = path.iterations.copy(), np.full(designs, np.inf)
    nodes = np.full(designs, levels[0], dtype=np.intp)
    came = path.reached > 0.0
    outcome = [_outcome(path, i) for i in range(designs)]
    parts: list[Part] = []
    before: list[Part] = []
    _keep(parts, coarse, demand, ~came | (len(levels) == 1), path.x, path.reached)
    rows, x, share = np.flatnonzero(came), path.x[came], path.reached[came]
    for level in levels[1:]:
        if rows.size == 0:
            break
        fine = at_nodes(coarse, level)
        guess = finer(coarse, fine, x)
        found = _newton(fine, demand, guess, share, rows, scale[rows], tolerance)
        iterations[rows] += found.iterations
        change = difference(coarse, fine, x, found.x, scale[rows])
        # what Newton's method did not finish is no equilibrium: the coarser one stands in for it
        kept = np.where(found.converged[:, None], found.x, guess)
        error[rows] = np.where(found.converged, change, np.inf)
        nodes[rows] = level
        # a path that ended by turning ends where no digit is sure
        done = (found.converged & (change <= tolerance)) | (share < 1.0)
        last = level == levels[-1]
        _keep(parts, fine, demand, done | last, kept, share, rows)
        _keep(before, coarse, demand, done | last, x, share, rows)
        for i in rows[~done & (share == 1.0)] if last else ():
            outcome[i] = Outcome.INACCURATE
        rows, x, share, coarse = rows[~done], kept[~done], share[~done], fine
        if last:
            break
    return Equilibrium(
        layout=layout,
        effects=effects,
        outcome=tuple(outcome),
        reached=path.reached,
        iterations=iterations,
        estimated_error=error,
        nodes=nodes,
        seconds=perf_counter() - begun,
        parts=tuple(parts),
        coarser_parts=tuple(before),
    )


def _newton(
    assembly: Assembly,
    demand: Demand,
    x: Floats,
    share: Floats,
    rows: Integers,
    scale: Floats,
    tolerance: float,
    trust: float = np.inf,
) -> NewtonResult:
    return newton(
        lambda at, of: assembly.step(at, share[of], rows[of], demand),
        assembly.length_of,
        x,
        tolerance=_NEWTON * tolerance,
        scale=scale,
        trust=trust,
    )


def _march(assembly: Assembly, demand: Demand, x: Floats, scale: Floats, tolerance: float) -> March:
    """Return the path from x."""

    def correct(at: Floats, share: Floats, rows: Integers) -> NewtonResult:
        return _newton(assembly, demand, at, share, rows, scale[rows], tolerance, TRUST)

    def step(at: Floats, share: Floats, rows: Integers) -> Floats:
        return assembly.step(at, share, rows, demand)

    def kind(at: Floats, share: Floats, rows: Integers) -> Integers:
        return inertia_count(
            assembly, demand, assembly.linearise(at, share, rows, demand), at, rows
        )

    return march(correct, step, assembly.length_of, kind, x)


def _outcome(path: March, design: int) -> Outcome:
    if path.reached[design] == 1.0:
        return Outcome.CONVERGED
    if path.reached[design] == 0.0 and path.end[design] is NewtonEnd.SINGULAR:
        return Outcome.SINGULAR
    return Outcome.TURNED


def _keep(
    parts: list[Part],
    assembly: Assembly,
    demand: Demand,
    which: NDArray[np.bool_],
    x: Floats,
    share: Floats,
    rows: Integers | None = None,
) -> None:
    if np.any(which):
        index = np.flatnonzero(which) if rows is None else rows[which]
        parts.append(Part(assembly, demand, index, x[which], share[which]))


def difference(coarse: Assembly, fine: Assembly, x: Floats, y: Floats, scale: Floats) -> Floats:
    """Return by how much forces and motions at two levels differ, over the largest of each.

    What stands still under forces is measured by how much they stretch a blade, and what bears
    nothing where it is by the forces that bend one as far: neither scale vanishes by itself.
    """
    (_, forces, motions), (_, fine_forces, fine_motions) = coarse.split(x), fine.split(y)
    pulled, moved = (_largest(each) for each in (fine_forces, fine_motions))
    stretch = min(float(np.min(mesh.thinnest / mesh.l)) for mesh in fine.meshes) ** 2 / 12.0
    change = np.zeros(x.shape[0])
    for a, b, size in (
        (forces, fine_forces, np.maximum(pulled, moved)),
        (motions, fine_motions, np.maximum(moved, stretch * pulled)),
    ):
        over = np.maximum(np.maximum(scale, size), _NOTHING)
        change = np.maximum(change, _largest(b - a) / over)
    return change


def _largest(values: Floats) -> Floats:
    return np.asarray(np.max(np.abs(values), axis=(1, 2), initial=0.0))
