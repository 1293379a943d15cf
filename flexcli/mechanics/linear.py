"""The linear model: small motions of exact beams, and the axial forces that they have by it."""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly, assemble
from flexcli.mechanics.demand import Demand, Held
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.prescribed_motion import demand_of, designs_of
from flexcli.mechanics.si import blade_forces, body_forces, body_motions

__all__ = ["NODES", "LinearSolution", "linear", "straight_state"]

Floats = NDArray[np.float64]

NODES = 24
"""Nodes on a piece: exact to rounding for the tanh and tan of axial loads of either sign, and for
profiles that are no sharp notches."""


class LinearSolution(NamedTuple):
    """Motions and reactions of the bodies (designs, bodies, 3), forces on the blades' ends.

    All SI, as in :class:`flexcli.mechanics.equilibrium.Equilibrium`; NaN where a design has no
    unique solution (``unique`` false).
    """

    motions: Floats
    end_forces: Floats
    reactions: Floats
    unique: NDArray[np.bool_]


def linear(
    layout: Layout,
    held: Held | None = None,
    *,
    loads: Sequence[Load] = (),
    effects: Effects | None = None,
    nodes: int = NODES,
) -> LinearSolution:
    """Return the small motions of a mechanism under motions and loads.

    Each blade is the exact Euler (``shear`` off) or Timoshenko beam of its profile.

    Parameters
    ----------
    layout, held, loads, effects
        As in :func:`flexcli.mechanics.equilibrium.solve`.
    nodes : int
        Gauss nodes on a piece.

    Returns
    -------
    LinearSolution
        Motions, forces and reactions.

    Notes
    -----
    Second-order effects of the motions (shortening, rotated levers) are left out, and axial forces
    do not stiffen the blades.

    """
    assembly = assemble(layout, Effects() if effects is None else effects, nodes)
    demand = demand_of(assembly, {} if held is None else held, loads)
    return _from_rest(assembly, demand)[1]


def straight_state(assembly: Assembly, demand: Demand) -> tuple[LinearSolution, Floats, Floats]:
    """Return the linear solution, the straight state with its axial forces, and these [N].

    The state has shape (designs, unknowns), the forces (designs, blades); tension is positive.
    """
    x, found = _from_rest(assembly, demand)
    return found, *_axial(assembly, x)


def _from_rest(assembly: Assembly, demand: Demand) -> tuple[Floats, LinearSolution]:
    """Return the solution linearised about rest, as unknowns and in SI."""
    x = np.zeros((designs_of(assembly, demand), assembly.size))
    rows, share = np.arange(x.shape[0]), np.ones(x.shape[0])
    step = assembly.step(x, share, rows, demand)
    at = assembly.linearise(x, share, rows, demand)
    change = step[:, assembly.turns :]
    residual = at.residual + np.einsum("nij,nj->ni", at.matrix, change)
    found = x + step
    return found, LinearSolution(
        motions=body_motions(assembly, found, rows),
        end_forces=blade_forces(assembly, found, rows),
        reactions=body_forces(assembly, demand.held, residual[:, 3 * assembly.blades :], rows),
        unique=np.all(np.isfinite(step), axis=1),
    )


def _axial(assembly: Assembly, x: Floats) -> tuple[Floats, Floats]:
    """Return the straight state with only the axial forces of x, and these forces [N]."""
    _, forces, _ = assembly.split(x)
    straight = np.zeros_like(x)
    kept = np.zeros_like(forces)
    tensions = np.zeros(forces.shape[:2])
    for mesh, place in zip(assembly.meshes, assembly.places, strict=True):
        index = list(mesh.blades)
        along = np.stack([place.along.real, place.along.imag], axis=-1)
        N = np.sum(forces[:, index, :2] * along, axis=-1)
        kept[:, index, :2] = N[..., None] * along
        tensions[:, index] = N * mesh.EI / mesh.l**2
    straight[:, assembly.turns : assembly.turns + 3 * assembly.blades] = kept.reshape(len(x), -1)
    return straight, tensions
