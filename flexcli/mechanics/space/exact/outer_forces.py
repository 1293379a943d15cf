"""Forces and springs on bodies in space: their part of the balance and of its derivative."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.demand import Force, Spring
from flexcli.mechanics.space.exact.rotation import cross, inverse_tangent, moved, skew, vector_of

__all__ = ["apply_force", "apply_spring"]

Floats = NDArray[np.float64]


def apply_force(force: Force, turn: Floats, size: float, residual: Floats, K: Floats) -> None:
    """Subtract ``size`` times a force from the residual, and its stiffness from the matrix."""
    shift, spin = _rows(force.body)
    arm = force.arm + moved(turn[force.body], force.arm)
    P = size * force.force
    residual[shift] -= P
    residual[spin] -= size * force.moment + cross(arm, P)
    # the arm turns by θ × arm
    K[spin, spin] -= skew(P) @ skew(arm)


def apply_spring(spring: Spring, shift: Floats, turn: Floats, residual: Floats, K: Floats) -> None:
    """Add the forces of springs to the residual and their stiffness to the matrix.

    ``½ Σ k u² + ½ Σ k φ²`` of the point's shift u and the body's rotation vector φ.
    """
    i = spring.body
    rows, spin = _rows(i)
    way = moved(turn[i], spring.arm)
    arm = skew(spring.arm + way)
    pull = spring.shift * (shift[i] + way)
    k = np.diag(spring.shift)
    residual[rows] += pull
    residual[spin] += arm @ pull
    K[rows, rows] += k
    K[rows, spin] -= k @ arm
    K[spin, rows] += arm @ k
    K[spin, spin] += skew(pull) @ arm - arm @ k @ arm
    if np.any(spring.turn != 0.0):
        phi = vector_of(turn[i])
        moment, by_phi = _spring_moment(phi, spring.turn)
        residual[spin] += moment
        K[spin, spin] += by_phi @ inverse_tangent(phi)


def _spring_moment(phi: Floats, k: Floats) -> tuple[Floats, Floats]:
    """Return ``T⁻ᵀ k φ``, the moment about fixed axes, and its derivative by φ.

    ``T⁻ᵀ y = y + ½ φ × y + a φ × (φ × y)``, ``a = (1 − (φ/2) cot(φ/2))/φ²``.
    """
    y, angle = k * phi, float(np.linalg.norm(phi))
    # a = 1/12 + φ²/720 + …, and (da/dφ)/φ
    a, slope = 1.0 / 12.0 + angle**2 / 720.0 + angle**4 / 30240.0, 1.0 / 360.0 + angle**2 / 7560.0
    if angle > _SERIES:
        half = angle / 2.0
        a = (1.0 - half / np.tan(half)) / angle**2
        # d(1 − half cot half)/dφ = (half/sin² half − cot half)/2
        slope = ((half / np.sin(half) ** 2 - 1.0 / np.tan(half)) / 2.0 - 2.0 * a * angle) / angle**3
    P, Y = skew(phi), skew(y)
    twice = P @ y
    moment = y + twice / 2.0 + a * (P @ twice)
    K = np.diag(k)
    by_phi = K + (P @ K - Y) / 2.0 + a * (-skew(twice) + P @ (P @ K - Y))
    return moment, by_phi + slope * np.outer(P @ twice, phi)


_SERIES = 0.05
"""Angle [rad] below which the coefficients are summed as series; the next terms are below 1e-12."""


def _rows(body: int) -> tuple[slice, slice]:
    return slice(6 * body, 6 * body + 3), slice(6 * body + 3, 6 * body + 6)
