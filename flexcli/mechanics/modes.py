"""Natural frequencies and modes of the bodies about an equilibrium, deflected or not."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.element import turned
from flexcli.mechanics.mesh import column
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.tangent import free_compliance

__all__ = ["Vibration", "mass_matrix", "vibration", "vibration_of"]

Floats = NDArray[np.float64]

_RIGID = 1e-13
"""Share of the softest mode's compliance below which a mode is held, or has no mass."""


class Vibration(NamedTuple):
    """Modes from soft to stiff (designs, modes), shapes (designs, free, modes) of unit modal mass.

    ``square`` is ω² [rad²/s²], negative for a mode that grows; infinite where a coordinate is
    held by inextensible blades or has no mass. ``frequency`` is in Hz, zero for growing modes.
    """

    square: Floats
    shapes: Floats

    @property
    def frequency(self) -> Floats:
        """Return the natural frequencies [Hz]."""
        return np.asarray(np.sqrt(np.maximum(self.square, 0.0)) / (2.0 * np.pi))


def mass_matrix(state: Equilibrium) -> Floats:
    """Return the inertia of all bodies on (x, y, φ) of their reference points, as they stand.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium.

    Returns
    -------
    array, shape (designs, 3 bodies, 3 bodies)
        Mass matrix [kg, kg·m, kg·m²]. The blades have no mass.

    """
    bodies = state.layout.bodies
    M = np.zeros((state.designs, 3 * len(bodies), 3 * len(bodies)))
    for i, body in enumerate(bodies):
        mass, inertia = column(body.mass), column(body.inertia)
        x, y = (column(c) - column(p) for c, p in zip(body.com, body.point, strict=True))
        arm = np.broadcast_to(np.stack(np.broadcast_arrays(x, y), axis=-1), (state.designs, 2))
        arm, _ = turned(arm, state.motions[:, i, 2])
        arm = np.where(mass[:, None] == 0.0, 0.0, arm)
        k = 3 * i
        M[:, k, k] = M[:, k + 1, k + 1] = mass
        M[:, k, k + 2] = M[:, k + 2, k] = -mass * arm[:, 1]
        M[:, k + 1, k + 2] = M[:, k + 2, k + 1] = mass * arm[:, 0]
        M[:, k + 2, k + 2] = inertia + mass * np.sum(arm**2, axis=-1)
    return M


def vibration(state: Equilibrium) -> Vibration:
    """Return the small vibrations of the free coordinates about an equilibrium.

    Parameters
    ----------
    state : Equilibrium
        The designs in equilibrium, their bodies with mass.

    Returns
    -------
    Vibration
        Frequencies and shapes.

    """
    free = state.parts[0].demand.free
    return vibration_of(mass_matrix(state)[:, free[:, None], free], free_compliance(state))


def vibration_of(M: Floats, G: Floats) -> Vibration:
    """Return the vibrations of coordinates with the mass M and the compliance G.

    ``M φ = (1/ω²) M G M φ``, so that coordinates without mass and directions without compliance
    cost nothing.

    Parameters
    ----------
    M, G : array, shape (designs, n, n)
        Mass and compliance, both symmetric; the compliance may be negative.

    Returns
    -------
    Vibration
        Frequencies and shapes.

    """
    weight, axes = np.linalg.eigh(M)
    root = axes * np.sqrt(np.maximum(weight, 0.0))[:, None, :]
    compliance = np.swapaxes(root, -1, -2) @ G @ root
    soft, vectors = np.linalg.eigh((compliance + np.swapaxes(compliance, -1, -2)) / 2.0)
    # growing modes first (the most negative 1/ω² grows slowest), then from soft to stiff
    order = np.argsort(np.where(soft < 0.0, -np.inf, -soft), axis=-1, kind="stable")
    soft = np.take_along_axis(soft, order, axis=-1)
    shapes = np.take_along_axis(G @ root @ vectors, order[:, None, :], axis=-1)
    largest = np.max(np.abs(soft), axis=-1, keepdims=True, initial=0.0)
    moves = np.abs(soft) > _RIGID * largest
    square = np.where(moves, 1.0 / np.where(moves, soft, 1.0), np.inf)
    shapes = np.where(moves[:, None, :], shapes / np.where(moves, soft, 1.0)[:, None, :], 0.0)
    return Vibration(square, shapes)
