"""Finite rotations in space: unit quaternions (w, x, y, z), rotation vectors, spins.

A spin θ turns what it finds: R becomes exp(θ̂) R. Formulas are written for quaternions of unit
length in the form ``R x = x + 2 v × (w x + v × x)``, in which small rotations keep their digits.
"""

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "conjugate",
    "cross",
    "inverse_tangent",
    "matrix_of",
    "moved",
    "product",
    "quaternion_of",
    "skew",
    "spin_slope",
    "spin_tangent",
    "spun",
    "vector_of",
]

Floats = NDArray[np.float64]

_SERIES = 0.2
"""Angle [rad] below which the coefficients of the tangents are summed as series."""


def skew(a: Floats) -> Floats:
    """Return the matrices â with ``â b = a × b`` (..., 3, 3)."""
    A = np.zeros((*a.shape, 3))
    A[..., 2, 1], A[..., 0, 2], A[..., 1, 0] = a[..., 0], a[..., 1], a[..., 2]
    A[..., 1, 2], A[..., 2, 0], A[..., 0, 1] = -a[..., 0], -a[..., 1], -a[..., 2]
    return A


def cross(a: Floats, b: Floats) -> Floats:
    """Return ``a × b`` (..., 3); arrays broadcast."""
    (a_x, a_y, a_z), (b_x, b_y, b_z) = _components(a), _components(b)
    x = a_y * b_z - a_z * b_y
    found = np.empty((*x.shape, 3))
    found[..., 0], found[..., 1], found[..., 2] = x, a_z * b_x - a_x * b_z, a_x * b_y - a_y * b_x
    return found


def _components(a: Floats) -> tuple[Floats, Floats, Floats]:
    return a[..., 0], a[..., 1], a[..., 2]


def moved(q: Floats, x: Floats) -> Floats:
    """Return how far rotations move vectors, ``R x − x`` (..., 3)."""
    w, v = q[..., :1], q[..., 1:]
    t = 2.0 * cross(v, x)
    return np.asarray(w * t + cross(v, t))


def matrix_of(q: Floats) -> Floats:
    """Return the rotation matrices (..., 3, 3)."""
    V = skew(q[..., 1:])
    return np.asarray(np.eye(3) + 2.0 * (q[..., :1, None] * V + V @ V))


def product(p: Floats, q: Floats) -> Floats:
    """Return the rotations q followed by p, ``p ∘ q``."""
    a, u, b, v = p[..., :1], p[..., 1:], q[..., :1], q[..., 1:]
    w = a * b - np.sum(u * v, axis=-1, keepdims=True)
    return np.concatenate([w, a * v + b * u + cross(u, v)], axis=-1)


def quaternion_of(phi: Floats) -> Floats:
    """Return the quaternions (..., 4) of unit length of rotation vectors (..., 3) [rad]."""
    half = np.linalg.norm(phi, axis=-1, keepdims=True) / 2.0
    return np.concatenate([np.cos(half), np.sinc(half / np.pi) / 2.0 * phi], axis=-1)


def conjugate(q: Floats) -> Floats:
    """Return the inverse rotations."""
    return np.concatenate([q[..., :1], -q[..., 1:]], axis=-1)


def spun(q: Floats, theta: Floats) -> Floats:
    """Return the change of quaternions by small spins."""
    half = np.concatenate([np.zeros_like(theta[..., :1]), theta / 2.0], axis=-1)
    return product(half, q)


def vector_of(q: Floats) -> Floats:
    """Return the rotation vectors (..., 3) [rad], shorter than 2π, of quaternions of any length.

    No quaternion but that of a full turn is singular: a body may turn by more than half.
    """
    length = np.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2.0 * np.arctan2(length, q[..., :1])
    near = length < 1e-150
    whole = np.where(near, 2.0 / q[..., :1], angle / np.where(near, 1.0, length))
    return np.asarray(q[..., 1:] * whole)


def spin_tangent(phi: Floats) -> Floats:
    """Return T with ``spin = T dφ`` for changes of a rotation vector (..., 3, 3).

    ``T = 1 + (1 − cos φ)/φ² φ̂ + (φ − sin φ)/φ³ φ̂²``.
    """
    P = skew(phi)
    angle = np.linalg.norm(phi, axis=-1)
    one = np.sinc(angle / (2.0 * np.pi)) ** 2 / 2.0
    small = np.minimum(angle, _SERIES) ** 2
    series = 1 / 6 * (1 - small / 20 * (1 - small / 42 * (1 - small / 72 * (1 - small / 110))))
    large = np.maximum(angle, _SERIES)
    two = np.where(angle < _SERIES, series, (large - np.sin(large)) / large**3)
    return np.asarray(np.eye(3) + one[..., None, None] * P + two[..., None, None] * (P @ P))


def spin_slope(phi: Floats, y: Floats) -> Floats:
    """Return the derivative by φ of ``Tᵀ(φ) y``, the moment on a rotation vector (3, 3)."""
    angle = float(np.linalg.norm(phi))
    small = min(angle, _SERIES) ** 2
    one = 0.5 * float(np.sinc(angle / (2.0 * np.pi))) ** 2
    two = 1 / 6 - small / 120 + small**2 / 5040 - small**3 / 362880
    # the derivatives of both coefficients by the angle, over the angle
    d_one = -1 / 12 + small / 180 - small**2 / 6720 + small**3 / 453600
    d_two = -1 / 60 + small / 1260 - small**2 / 60480 + small**3 / 4989600
    if angle > _SERIES:
        sin, versine = np.sin(angle), 2.0 * np.sin(angle / 2.0) ** 2
        two = (angle - sin) / angle**3
        d_one = (angle * sin - 2.0 * versine) / angle**4
        d_two = (3.0 * (sin - angle) + angle * versine) / angle**5
    P, once = skew(phi), cross(phi, y)
    slope = one * skew(y) - two * (skew(once) + P @ skew(y))
    return np.asarray(slope + np.outer(d_two * (P @ once) - d_one * once, phi))


def inverse_tangent(phi: Floats) -> Floats:
    """Return the inverse of :func:`spin_tangent` (..., 3, 3); singular at a full turn."""
    return np.asarray(np.linalg.inv(spin_tangent(phi)))
