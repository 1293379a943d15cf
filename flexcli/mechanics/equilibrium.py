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

from collections.abc import Callable, Sequence
from importlib import import_module
from time import perf_counter
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly, assemble, at_nodes, finer
from flexcli.mechanics.demand import Demand, Held
from flexcli.mechanics.inertia_count import inertia_count
from flexcli.mechanics.layout import Layout, Load, Number
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of, designs_of
from flexcli.mechanics.refinement import LEVELS, Reached, by_steps, refined
from flexcli.mechanics.refinement import difference as relative_difference
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.mechanics.uncondensed import uncondensed
from flexcli.numerics.compilation import is_compiled
from flexcli.numerics.newton import NewtonResult

__all__ = ["LEVELS", "Equilibrium", "difference", "solve"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


FEW = 5
"""Gauss nodes on a piece that a nearly straight path from rest begins with: small strokes need no
more, and what is solved on them costs a third."""


class _Solver(Protocol):
    """Newton's method for an assembly and its demand, faster than that by condensed blades."""

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's steps of the designs ``rows`` at x and shares λ of the way."""

    def newton(self, x: Floats, share: Floats, rows: Integers, **how: Any) -> NewtonResult:
        """Return where Newton's method leads."""


class _Planar(NamedTuple):
    """Blades in the plane and what is asked of them (``Discretised``).

    ``chosen`` gives the solver of an assembly and its demand, if there is a faster one.
    """

    assembly: Assembly
    demand: Demand
    chosen: Callable[[Assembly, Demand], _Solver | None]
    solver: _Solver | None

    @classmethod
    def of(
        cls,
        assembly: Assembly,
        demand: Demand,
        chosen: Callable[[Assembly, Demand], _Solver | None],
    ) -> "_Planar":
        """Return blades and what is asked of them."""
        return cls(assembly, demand, chosen, chosen(assembly, demand))

    @property
    def nodes(self) -> int:
        """Return the Gauss nodes on a piece."""
        return self.assembly.nodes

    def step(self, x: Floats, share: Floats, rows: Integers) -> Floats:
        """Return Newton's steps of the designs ``rows`` at the shares λ of the way."""
        if self.solver is not None:
            return self.solver.step(x, share, rows)
        return self.assembly.step(x, share, rows, self.demand)

    def newton(self, x: Floats, share: Floats, rows: Integers, **how: Any) -> NewtonResult:
        """Return where Newton's method leads from x."""
        if self.solver is not None:
            return self.solver.newton(x, share, rows, **how)
        return by_steps(self, x, share, rows, **how)

    def length_of(self, x: Floats, step: Floats) -> Floats:
        """Return the lengths of steps [-]."""
        return self.assembly.length_of(x, step)

    def unstable(self, x: Floats, share: Floats, rows: Integers) -> Integers:
        """Return in how many directions equilibria are unstable."""
        at = self.assembly.linearise(x, share, rows, self.demand)
        return inertia_count(self.assembly, self.demand, at, x, rows)

    def at_nodes(self, nodes: int) -> "_Planar":
        """Return the same at another number of nodes."""
        return _Planar.of(at_nodes(self.assembly, nodes), self.demand, self.chosen)

    def finer(self, fine: "_Planar", x: Floats) -> Floats:
        """Return unknowns interpolated to the nodes of a finer one."""
        return finer(self.assembly, fine.assembly, x)

    def changed(self, fine: "_Planar", x: Floats, y: Floats, scale: Floats) -> Floats:
        """Return by how much x differs from y, solved with finer nodes [-]."""
        return difference(self.assembly, fine.assembly, x, y, scale)

    def part(self, reached: Reached) -> Part:
        """Return the designs of a level as a part of the answer."""
        return Part(self.assembly, self.demand, reached.rows, reached.x, reached.share)


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
    planar = _Planar.of(coarse, demand, _solver(coarse, designs))
    few = planar.at_nodes(FEW) if start is None and len(levels) > 1 else None
    found = refined(planar, x, tolerance, levels, few)
    return Equilibrium(
        layout=layout,
        effects=effects,
        outcome=found.outcome,
        reached=found.reached,
        iterations=found.iterations,
        estimated_error=found.error,
        nodes=found.nodes,
        seconds=perf_counter() - begun,
        parts=tuple(reached.at.part(reached) for reached in found.parts),
        coarser_parts=tuple(reached.at.part(reached) for reached in found.coarser),
    )


def _solver(assembly: Assembly, designs: int) -> Callable[[Assembly, Demand], _Solver | None]:
    """Return what gives the fastest solver of so many designs, whatever the nodes."""
    if len(assembly.meshes) == 1 and is_compiled(designs):
        found: Callable[[Assembly, Demand], _Solver] = import_module(
            "flexcli.mechanics.compiled_newton"
        ).Compiled
        return found
    return uncondensed if designs == 1 else lambda *_: None


def difference(coarse: Assembly, fine: Assembly, x: Floats, y: Floats, scale: Floats) -> Floats:
    """Return by how much forces and motions at two levels differ, over the largest of each."""
    stretch = fine.slenderness**2 / 12.0
    before, after = coarse.forces_and_motions(x), fine.forces_and_motions(y)
    return relative_difference(before, after, stretch, scale)
