"""Inertia count: how many negative eigenvalues the energy of an equilibrium has; none is stable."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.assembly import Assembly, Linearised
from flexcli.mechanics.beam import local
from flexcli.mechanics.demand import Demand
from flexcli.mechanics.mesh import pick

__all__ = ["closing_and_balance", "inertia_count", "inertia_count_of_one", "row_units"]

Floats = NDArray[np.float64]
Integers = NDArray[np.intp]


def inertia_count(
    assembly: Assembly, demand: Demand, at: Linearised, x: Floats, rows: Integers
) -> Integers:
    """Return the number of negative eigenvalues of each design's energy (designs,).

    ``Σ n(blade with its end free) + n(S) − 3 blades``, bodies and sections of the blades alike,
    with S the matrix of closing and balance: the inertia of a matrix is that of its Schur
    complements.

    Parameters
    ----------
    assembly : Assembly
        The layout at its nodes.
    demand : Demand
        What is held and loaded; held coordinates stay held.
    at : Linearised
        The equations about x.
    x : array, shape (designs, unknowns)
        Equilibria of the designs ``rows``.
    rows : array of int
        Which designs of the whole these are.

    Returns
    -------
    array of int, shape (designs,)
        Zero where a design stands by itself.

    Notes
    -----
    Loads that follow a body have no energy; the symmetric part of S decides then, which finds
    loss by divergence but not by flutter.

    References
    ----------
    Haynsworth (1968), Determination of the inertia of a partitioned Hermitian matrix.

    """
    S = closing_and_balance(assembly, demand, at)
    unit = row_units(S)
    negative = np.sum(np.linalg.eigvalsh(S * unit[:, :, None] * unit[:, None, :]) < 0.0, axis=-1)
    return np.asarray(negative - 3 * assembly.blades + _blades_alone(assembly, at, x, rows))


def inertia_count_of_one(assembly: Assembly, demand: Demand, x: Floats, share: float) -> int:
    """Return the number of negative eigenvalues of a single design at an equilibrium."""
    alone = np.arange(1)
    at = assembly.linearise(x[None], np.array([share]), alone, demand)
    return int(inertia_count(assembly, demand, at, x[None], alone)[0])


def closing_and_balance(assembly: Assembly, demand: Demand, at: Linearised) -> Floats:
    """Return the matrix S of blade forces and free motions, its symmetric part."""
    k_f = 3 * assembly.blades
    unknown = np.concatenate([np.arange(k_f), k_f + demand.free])
    S = at.matrix[:, unknown[:, None], unknown]
    return np.asarray((S + np.swapaxes(S, -1, -2)) / 2.0)


def row_units(S: Floats) -> Floats:
    """Return units of the unknowns of matrices that bring their rows near one."""
    size = np.max(np.abs(S), axis=-1)
    return np.asarray(1.0 / np.sqrt(np.where(size > 0.0, size, 1.0)))


def _blades_alone(assembly: Assembly, at: Linearised, x: Floats, rows: Integers) -> Integers:
    """Return how many negative eigenvalues the blades have, their ends free (designs,).

    Those of ``1 − A f_ψ``, with A symmetric and positive in its weights: the eigenvalues of
    ``A f_ψ`` are real, and at most those with f_ψ where it is positive.
    """
    rotations, _, _ = assembly.split(x)
    count = np.zeros(rows.size, dtype=np.intp)
    for psi, mesh, q in zip(rotations, assembly.meshes, at.local, strict=True):
        f_psi = local(mesh, rows, psi, q.T).f_psi
        A = pick(mesh.A, rows)
        bound = np.max(np.abs(A) @ np.maximum(f_psi, 0.0)[..., None], axis=(-2, -1))
        doubtful = bound >= 1.0
        if np.any(doubtful):
            matrix = np.broadcast_to(A, (*f_psi.shape, f_psi.shape[-1]))[doubtful]
            eigenvalues = np.linalg.eigvals(matrix * f_psi[doubtful][:, None, :]).real
            beyond = np.zeros(doubtful.shape, dtype=np.intp)
            beyond[doubtful] = np.sum(eigenvalues > 1.0, axis=-1)
            count += beyond.sum(axis=-1)
    return count
