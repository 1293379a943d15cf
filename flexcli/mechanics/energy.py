"""Strain energy of the blades at an equilibrium."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.beam import local, paired, section_forces
from flexcli.mechanics.mesh import pick
from flexcli.mechanics.state import Equilibrium

__all__ = ["blade_energies", "strain_energy"]

Floats = NDArray[np.float64]


def blade_energies(state: Equilibrium) -> Floats:
    """Return the strain energy of each blade.

    ``U = ½ ∫ (M²/EI + N²/EA + Q²/κGA) ds``.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.

    Returns
    -------
    array, shape (designs, blades)
        Strain energy [J].

    """
    values = []
    for part in state.parts:
        assembly = part.assembly
        rotations, forces, motions = assembly.split(part.x)
        energy = np.zeros((part.rows.size, assembly.blades))
        for k, mesh in enumerate(assembly.meshes):
            q = assembly.local_forces(forces, motions, k, part.rows)
            at = local(mesh, part.rows, rotations[k], paired(q[..., 0], q[..., 1]))
            M = section_forces(mesh, part.rows, rotations[k], q)[2][..., 1:-1]
            w, c, axial, shear = (
                pick(a, part.rows) for a in (mesh.w, mesh.c, mesh.axial, mesh.shear)
            )
            density = c * M**2 + axial * at.N**2 + shear * at.Q**2
            unit = pick(mesh.EI, part.rows) / pick(mesh.l, part.rows)
            energy[:, list(mesh.blades)] = 0.5 * unit * np.sum(w * density, axis=-1)
        values.append(energy)
    return state.scatter(values)


def strain_energy(state: Equilibrium) -> Floats:
    """Return the strain energy of all blades (designs,) [J]."""
    return np.asarray(blade_energies(state).sum(axis=1))
