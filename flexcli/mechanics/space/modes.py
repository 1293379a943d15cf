"""Natural modes of a mechanism in space about rest, its drive locked or free."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.inertia import blade_masses, mass_matrix
from flexcli.mechanics.space.linear import SpaceAssembly

__all__ = ["SpaceModes", "natural_modes", "own_blade_frequency"]

Floats = NDArray[np.float64]

MASSLESS = 1e-7
"""Share of the longest period below which a mode has no mass to speak of and is left out."""

FIRST = 22.3733
"""(β l)² of a clamped beam's lowest frequency, cosh βl cos βl = 1."""


class SpaceModes(NamedTuple):
    """Angular frequencies [rad/s], lowest first; shapes of unit modal mass in the columns."""

    angular: Floats
    shapes: Floats


def natural_modes(assembly: SpaceAssembly, *, locked: bool) -> SpaceModes:
    """Return the modes of bodies and blades.

    ``S L = U Σ Vᵀ`` with C = SᵀS the compliance and M = L Lᵀ: ω = 1/Σ.

    Parameters
    ----------
    assembly : SpaceAssembly
        The mechanism.
    locked : bool
        Whether the drive holds its one motion.

    Returns
    -------
    SpaceModes
        Modes that have a mass.

    Notes
    -----
    Small vibration about rest, without loads. A blade follows its ends; its inner vibration
    lowers the frequencies, see :func:`own_blade_frequency`.

    """
    M = mass_matrix(assembly)[: assembly.size, : assembly.size]
    scale = np.sqrt(np.where(np.diag(M) > 0.0, np.diag(M), 1.0))
    weights, axes = np.linalg.eigh(M / np.outer(scale, scale))
    L = scale[:, None] * axes * np.sqrt(np.maximum(weights, 0.0))
    S = assembly.compliance_root(locked=locked)
    U, periods, _ = np.linalg.svd(S @ L, full_matrices=False)
    kept = periods > MASSLESS * periods[0] if len(periods) else np.zeros(0, dtype=bool)
    return SpaceModes(1.0 / periods[kept], (S.T @ U[:, kept]) / periods[kept])


def own_blade_frequency(assembly: SpaceAssembly) -> float:
    """Return the lowest frequency of a blade between ends that do not move [rad/s].

    Infinite where the blades have no mass.
    """
    found = np.inf
    masses = blade_masses(assembly)
    for springs, mass in zip(assembly.members, masses, strict=True):
        if mass > 0.0:
            # EI/l from the softer bending; of a profile with notches the rigid middle is heavy
            stiff = float(springs.springs.stiffness[4:].min())
            found = min(found, FIRST * np.sqrt(stiff / (mass * springs.l**2)))
    return float(found)
