"""Stability of an equilibrium: how many ways there are to fall, the critical load and its mode."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.beam import local
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects, pick
from flexcli.mechanics.state import Equilibrium, Part
from flexcli.mechanics.tangent import free_compliance

__all__ = ["Critical", "critical_load", "is_stable", "unstable_directions"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]

_MOST_SOLVES = 120
_STEPS = 8
"""Steps to the largest factor; two critical points within one step count as the first."""

_GROWN = 1e4
"""Growth of a compliance that means the bodies move in the critical mode."""

_TOLERANCE = 1e-10
"""Width of the bracket over the critical factor at which the search ends."""


@dataclass(frozen=True, eq=False)
class Critical:
    """The critical factor of a load pattern, the state just below it, how many modes meet there.

    ``mode`` is the motion (x [m], y [m], φ [rad]) of each body in the direction of falling, with
    a largest entry (lengths in mean blade lengths) of one, zero when only blades buckle between
    bodies that stand still.
    """

    factor: float
    state: Equilibrium
    multiplicity: int
    mode: Floats


def unstable_directions(state: Equilibrium) -> Integers:
    """Return in how many independent ways each design would fall if let go (designs,).

    The number of negative eigenvalues of the second derivative of the whole energy, bodies and
    sections of the blades alike: ``Σ n(blade with its end free) + n(S) − 3 blades``, with S the
    matrix of closing and balance, by the inertia of its Schur complements.

    Notes
    -----
    Loads that follow a body have no energy; the symmetric part of S decides then, which finds
    loss by divergence but not by flutter. Held coordinates stay held.

    """
    values = []
    for part, at in zip(state.parts, state.linearised, strict=True):
        k_f = 3 * part.assembly.blades
        unknown = np.concatenate([np.arange(k_f), k_f + part.demand.free])
        S = at.matrix[:, unknown[:, None], unknown]
        size = np.max(np.abs(S), axis=-1)
        balance = 1.0 / np.sqrt(np.where(size > 0.0, size, 1.0))
        S = S * balance[:, :, None] * balance[:, None, :]
        negative = np.sum(np.linalg.eigvalsh((S + np.swapaxes(S, -1, -2)) / 2.0) < 0.0, axis=-1)
        values.append((negative - k_f + _free_ended(part)).astype(np.float64))
    return np.rint(state.scatter(values)).astype(np.intp)


def is_stable(state: Equilibrium) -> NDArray[np.bool_]:
    """Return which designs stand by themselves, their held coordinates held (designs,)."""
    return np.asarray(unstable_directions(state) == 0)


def _free_ended(part: Part) -> Integers:
    """Return how many unstable directions the blades of each design have, their ends let go."""
    assembly = part.assembly
    rotations, forces, motions = assembly.split(part.x)
    count = np.zeros(part.rows.size, dtype=np.intp)
    for k, mesh in enumerate(assembly.meshes):
        q = assembly.local_forces(forces, motions, k, part.rows)
        # for the eigenvalues of A f_ψ beyond one; they are real, A being symmetric in its weights
        f_psi = local(mesh, part.rows, rotations[k], q).f_psi
        matrix = pick(mesh.A, part.rows) * f_psi[..., None, :]
        bound = np.max(np.sum(np.abs(matrix), axis=-1), axis=-1)
        doubtful = bound >= 1.0
        if np.any(doubtful):
            eigenvalues = np.linalg.eigvals(matrix[doubtful]).real
            beyond = np.zeros(doubtful.shape, dtype=np.intp)
            beyond[doubtful] = np.sum(eigenvalues > 1.0, axis=-1)
            count += beyond.sum(axis=-1)
    return count


def critical_load(
    layout: Layout,
    held: Held | None,
    pattern: Sequence[Load],
    *,
    most: float,
    effects: Effects | None = None,
    tolerance: float = 1e-9,
) -> Critical:
    """Return the least factor in (0, most] on a load pattern at which an equilibrium is critical.

    The path runs from the equilibrium under the layout's own loads and what is held; the factor
    is where the number of unstable directions changes. What ``held`` holds decides which load
    this is: a body locked, free to turn, or free in the plane are three different numbers.

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
    effects, tolerance
        As in :func:`flexcli.mechanics.equilibrium.solve`.

    Returns
    -------
    Critical
        Factor, state just below, multiplicity and mode.

    Raises
    ------
    SolveError
        ``unstable-start`` when the mechanism falls without the pattern, ``no-critical-load``
        when nothing is critical up to ``most``.

    """

    def at(factor: float, start: Equilibrium | None) -> Equilibrium:
        return solve(
            layout,
            held,
            loads=pattern,
            load_factor=factor,
            effects=effects,
            tolerance=tolerance,
            start=start,
        )

    below = at(0.0, None).checked()
    if not is_stable(below)[0]:
        raise SolveError(
            "unstable-start",
            "the mechanism is unstable before the load pattern acts",
            "hold more of its motions, or lessen its own loads",
        )
    at_rest = below
    low, high, jump = 0.0, most, 0
    for _ in range(_MOST_SOLVES):
        factor = (low + high) / 2.0 if jump else min(low + most / _STEPS, most)
        state = at(factor, below)
        fell = int(unstable_directions(state)[0]) if state.converged[0] else 1
        if fell:
            high, jump = factor, fell
        else:
            low, below = factor, state
        if low >= most:
            raise SolveError(
                "no-critical-load",
                f"no equilibrium up to {most:g} times the pattern is critical",
                "raise the largest factor, or turn the pattern round",
            )
        if jump and high - low <= _TOLERANCE * high:
            break
    return Critical(low, below, jump, _mode(at_rest, below))


def _mode(at_rest: Equilibrium, state: Equilibrium) -> Floats:
    """Return the motion of the bodies whose compliance grew without end (bodies, 3)."""
    part = state.parts[0]
    free = part.demand.free
    mode = np.zeros(3 * part.assembly.bodies)
    if free.size:
        unit = np.where(free % 3 == 2, 1.0, float(part.assembly.length[0]))
        values, vectors = _softest(state, unit)
        if values > _GROWN * _softest(at_rest, unit)[0]:
            mode[free] = vectors / vectors[np.argmax(np.abs(vectors))] * unit
    return mode.reshape(-1, 3)


def _softest(state: Equilibrium, unit: Floats) -> tuple[float, Floats]:
    """Return the largest scaled compliance of the free coordinates and its direction."""
    G = free_compliance(state)[0] / np.outer(unit, unit)
    values, vectors = np.linalg.eigh((G + G.T) / 2.0)
    most = int(np.argmax(np.abs(values)))
    return float(abs(values[most])), vectors[:, most]
