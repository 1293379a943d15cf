"""The answer of the exact solver: designs in equilibrium, or how far they came and why."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import Outcome
from flexcli.mechanics.assembly import Assembly, Linearised
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.inertia_count import inertia_count
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.si import blade_forces, body_forces, body_motions
from flexcli.mechanics.statics import balance

__all__ = ["Equilibrium", "Part"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


class Part(NamedTuple):
    """Designs ``rows`` that ended at the same number of nodes: unknowns x at the share λ."""

    assembly: Assembly
    demand: Demand
    rows: Integers
    x: Floats
    share: Floats

    def linearise(self) -> Linearised:
        """Return the equations about the solution."""
        return self.assembly.linearise(self.x, self.share, self.rows, self.demand)

    def reactions(self) -> Floats:
        """Return what holds each body [N, N, N·m], zero on free coordinates."""
        left = balance(self.assembly, self.demand, self.x, self.share, self.rows)
        return body_forces(self.assembly, self.demand.held, left, self.rows)


@dataclass(frozen=True, eq=False)
class Equilibrium:
    """Designs in equilibrium; the first axis of every array is the design, also for one alone.

    A design that could not go all the way is in equilibrium at the share ``reached`` of what was
    asked, and its ``outcome`` says why: call ``checked`` before relying on numbers. One that went
    straight on through a branching point (a column past its Euler load) is in equilibrium, and
    ``unstable`` tells that it does not stay there.
    """

    layout: Layout
    effects: Effects
    outcome: tuple[Outcome, ...]
    reached: Floats
    iterations: Integers
    estimated_error: Floats
    nodes: Integers
    seconds: float
    parts: tuple[Part, ...]
    coarser_parts: tuple[Part, ...] = ()

    @property
    def coarser(self) -> "Equilibrium | None":
        """Return the same equilibria on the level of nodes before, where there is one for all.

        What is read off both tells by how much it is off itself.
        """
        known = sum(part.rows.size for part in self.coarser_parts)
        if known < self.designs:
            return None
        return replace(self, parts=self.coarser_parts, coarser_parts=())

    @property
    def designs(self) -> int:
        """Return the number of designs."""
        return len(self.outcome)

    @property
    def converged(self) -> NDArray[np.bool_]:
        """Return which designs meet the demand within the tolerance."""
        return np.array([o is Outcome.CONVERGED for o in self.outcome])

    def checked(self) -> "Equilibrium":
        """Return this when every design converged.

        Raises
        ------
        SolveError
            Naming the first design that did not, and why.
        """
        for i, outcome in enumerate(self.outcome):
            if outcome is not Outcome.CONVERGED:
                where = f"design {i}, at {self.reached[i]:.4g} of the demand: " * (self.designs > 1)
                raise outcome.error(where)
        return self

    def scatter(self, values: Sequence[Floats]) -> Floats:
        """Return one array of all designs from arrays of the parts."""
        shape = values[0].shape[1:]
        whole = np.zeros((self.designs, *shape))
        for part, value in zip(self.parts, values, strict=True):
            whole[part.rows] = value
        return whole

    @cached_property
    def linearised(self) -> tuple[Linearised, ...]:
        """Return the equations of each part about its solution."""
        return tuple(part.linearise() for part in self.parts)

    @cached_property
    def unstable(self) -> Integers:
        """Return in how many directions each design is unstable (designs,).

        Zero where the equilibrium is stable, its held coordinates held.
        """
        values = [
            inertia_count(part.assembly, part.demand, at, part.x, part.rows).astype(np.float64)
            for part, at in zip(self.parts, self.linearised, strict=True)
        ]
        return np.rint(self.scatter(values)).astype(np.intp)

    @cached_property
    def residual(self) -> Floats:
        """Return the largest residual in scaled equations (designs,) [-]."""
        values = []
        for part, at in zip(self.parts, self.linearised, strict=True):
            k_f = 3 * part.assembly.blades
            rows = np.concatenate([np.arange(k_f), k_f + part.demand.free])
            values.append(np.max(np.abs(at.residual * at.row_scale)[:, rows], axis=1))
        return self.scatter(values)

    @cached_property
    def motions(self) -> Floats:
        """Return (x [m], y [m], φ [rad]) of each body's reference point (designs, bodies, 3)."""
        return self.scatter([body_motions(p.assembly, p.x, p.rows) for p in self.parts])

    @cached_property
    def end_forces(self) -> Floats:
        """Return force (x, y) [N] and moment [N·m] on each blade's end (designs, blades, 3)."""
        return self.scatter([blade_forces(p.assembly, p.x, p.rows) for p in self.parts])

    @cached_property
    def reactions(self) -> Floats:
        """Return what holds each body at its reference point (designs, bodies, 3) [N, N, N·m].

        Zero on free coordinates.
        """
        return self.scatter([part.reactions() for part in self.parts])
