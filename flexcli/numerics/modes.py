"""Natural modes of a linear system by its stiffness, or by a compliance that may be indefinite."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Modes", "Vibration", "natural_modes", "vibration_of"]

Floats = NDArray[np.float64]

MASSLESS = 1e-14
"""Share of the largest 1/ω² below which a mode has negligible mass and is left out."""

HELD = 1e-13
"""Share of the softest mode's compliance below which a mode is held, or has no mass."""


@dataclass(frozen=True, eq=False)
class Modes:
    """Natural frequencies, lowest first, and shapes with unit modal mass in the columns."""

    angular: Floats
    shapes: Floats


def natural_modes(K: Floats, M: Floats) -> Modes:
    """Return the modes of symmetric matrices, K positive definite, M possibly singular.

    Solved as M x = (1/ω²) K x by a Cholesky factor of K, so that a coordinate without inertia
    costs no division by zero and the lowest modes, which matter, are the best conditioned.

    Raises
    ------
    ValueError
        When K is not positive definite: something is held by nothing.
    """
    diagonal = np.diagonal(K)
    scale = 1.0 / np.sqrt(np.where(diagonal > 0.0, diagonal, np.inf))
    try:
        factor = np.linalg.cholesky(K * np.outer(scale, scale))
    except np.linalg.LinAlgError:
        raise ValueError("the stiffness matrix is not positive definite") from None
    inverse = np.linalg.inv(factor)
    compliance = inverse @ (M * np.outer(scale, scale)) @ inverse.T
    values, vectors = np.linalg.eigh((compliance + compliance.T) / 2.0)
    values, vectors = values[::-1], vectors[:, ::-1]
    kept = values > MASSLESS * values[0]
    angular = 1.0 / np.sqrt(values[kept])
    shapes = scale[:, None] * (inverse.T @ vectors[:, kept]) * angular
    return Modes(angular, shapes)


class Vibration(NamedTuple):
    """Modes from soft to stiff (designs, modes); shapes (designs, n, modes) of unit modal mass.

    ``square`` is ω² [rad²/s²], negative for a mode that grows; infinite where a coordinate is
    rigidly held or has no mass. ``frequency`` is in Hz, zero for growing modes.
    """

    square: Floats
    shapes: Floats

    @property
    def frequency(self) -> Floats:
        """Return the natural frequencies [Hz]."""
        return np.asarray(np.sqrt(np.maximum(self.square, 0.0)) / (2.0 * np.pi))


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
    largest = np.max(np.abs(soft), axis=-1, keepdims=True, initial=0.0)
    moves = np.abs(soft) > HELD * largest
    over = np.where(moves, soft, 1.0)
    square = np.where(moves, 1.0 / over, np.inf)
    shapes = np.where(moves[:, None, :], G @ root @ vectors / over[:, None, :], 0.0)
    # growing modes first, the fastest before all, then from soft to stiff
    order = np.argsort(square, axis=-1, kind="stable")
    square = np.take_along_axis(square, order, axis=-1)
    shapes = np.take_along_axis(shapes, order[:, None, :], axis=-1)
    return Vibration(square, shapes)
