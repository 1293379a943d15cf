"""Natural modes of a linear system K − ω² M."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Modes", "natural_modes"]

Floats = NDArray[np.float64]

MASSLESS = 1e-14
"""Share of the largest 1/ω² below which a mode has no mass to speak of and is left out."""


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
