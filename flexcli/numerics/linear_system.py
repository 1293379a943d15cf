"""A linear system ``q'' + C q' + K q = b f(t)`` in the basis that decouples it."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["LinearSystem", "second_order_system"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]

_UNCOUPLED = 1e-14
"""Relative coupling of the undamped modes by the damping that counts as rounding."""
_CRITICAL = 1e-8
"""Relative distance of a mode's two roots below which the eigenvectors are defective to
rounding."""
_WORST_CONDITION = 1e10


@dataclass(frozen=True, eq=False)
class LinearSystem:
    """Roots μ of a linear system and its matrices to and from the amplitudes, ``y' = μ y + w f``.

    ``q = Re(shapes y)`` and ``q' = Re(shapes (μ y))``: of each pair of conjugate roots one is kept.
    ``amplitudes`` (m, 2n) takes (q, q') to y. A system without coordinates has no roots.
    """

    roots: Complexes
    shapes: Complexes
    amplitudes: Complexes

    def project(self, q: Floats, rate: Floats) -> Complexes:
        """Return the amplitudes of a state."""
        projected: Complexes = self.amplitudes @ np.concatenate([q, rate])
        return projected

    def state(self, y: Complexes) -> tuple[Floats, Floats]:
        """Return (q, q') of amplitudes."""
        return (self.shapes @ y).real, (self.shapes @ (self.roots * y)).real

    def drive(self, b: Floats) -> Complexes:
        """Return w, how a force along b drives each amplitude."""
        driven: Complexes = self.amplitudes[:, b.size :] @ b
        return driven


def second_order_system(K: Floats, C: Floats) -> LinearSystem:
    """Return the roots and shapes of ``q'' + C q' + K q``, K and C symmetric, K definite.

    Damping that does not couple the undamped modes keeps their orthogonal shapes, so that the
    energy of an undamped system is kept to rounding; any other is solved in first-order form.

    Raises
    ------
    ValueError
        When a pair of roots coincides to rounding (critical damping): there is no such basis.
    """
    n = K.shape[0]
    if n == 0:
        none = np.zeros((0, 0), dtype=np.complex128)
        return LinearSystem(np.zeros(0, dtype=np.complex128), none, none)
    values, vectors = np.linalg.eigh((K + K.T) / 2.0)
    if values[0] <= 0.0:
        raise ValueError("the stiffness matrix is not positive definite")
    angular = np.sqrt(values)
    modal_damping = vectors.T @ C @ vectors
    coupling = modal_damping - np.diag(np.diagonal(modal_damping))
    if np.abs(coupling).max() <= _UNCOUPLED * np.abs(modal_damping).max():
        return _uncoupled(angular, np.diagonal(modal_damping), vectors)
    return _coupled(K, C, float(angular[-1]))


def _uncoupled(angular: Floats, damping: Floats, vectors: Floats) -> LinearSystem:
    """Return the system of modes ``η'' + d η' + ω² η``, each with its own two roots."""
    n = angular.size
    half = damping / 2.0
    difference = np.emath.sqrt(half**2 - angular**2).astype(np.complex128)
    if (np.abs(difference) <= _CRITICAL * angular).any():
        raise ValueError("a mode is critically damped")
    roots, shapes, amplitudes = [], [], []
    for r in range(n):
        to_mode = np.concatenate([vectors[:, r], np.zeros(n)])
        to_rate = np.concatenate([np.zeros(n), vectors[:, r]])
        upper, lower = -half[r] + difference[r], -half[r] - difference[r]
        if difference[r].imag != 0.0:
            roots.append(upper)
            shapes.append(vectors[:, r])
            # η = Re y, η' = Re(μ y)
            imaginary = (upper.real * to_mode - to_rate) / upper.imag
            amplitudes.append(to_mode + 1j * imaginary)
        else:
            # the slower root from the product of both, which doesn't cancel
            slow = angular[r] ** 2 / lower
            for own, other in ((slow, lower), (lower, slow)):
                roots.append(own)
                shapes.append(vectors[:, r])
                amplitudes.append((to_rate - other * to_mode) / (own - other))
    return LinearSystem(
        np.array(roots, dtype=np.complex128),
        np.array(shapes, dtype=np.complex128).T,
        np.array(amplitudes, dtype=np.complex128),
    )


def _coupled(K: Floats, C: Floats, scale: float) -> LinearSystem:
    """Return the system from the eigenvectors of the first-order form, rates scaled."""
    n = K.shape[0]
    A = np.block([[np.zeros((n, n)), scale * np.eye(n)], [-K / scale, -C]])
    roots, vectors = np.linalg.eig(A.astype(np.complex128))
    if np.linalg.cond(vectors) > _WORST_CONDITION:
        raise ValueError("a mode is critically damped")
    inverse = np.linalg.inv(vectors)
    real = np.abs(roots.imag) <= _UNCOUPLED * np.abs(roots)
    kept = real | (roots.imag > 0.0)
    weight = np.where(real, 1.0, 2.0)[kept]
    roots = np.where(real, roots.real, roots)[kept]
    amplitudes = inverse[kept] * np.concatenate([np.ones(n), np.full(n, 1.0 / scale)])
    return LinearSystem(roots, vectors[:n, kept] * weight, amplitudes)
