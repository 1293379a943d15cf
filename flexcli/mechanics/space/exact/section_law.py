"""A wide strip that is bent across its thickness and twisted: how its section curls.

A bent strip curls across its width (ν κ), a twisted one as well, since its edges are longer; where
it is curved, curling stretches it. With the profile of least energy, its long sides free,

    U = ½ EI κ² + ½ EI/(1 − ν²) (1 − F(β)) (ν κ + τ²/κ)²,  β⁴ = 3 (1 − ν²) b⁴ κ²/h²,
    F = (2/β) (cosh β − cos β)/(sinh β + sin β),

besides ½ GJ τ². Without twist that is the flattening of a curved strip, without curvature the
stiffening by its long fibres, E b⁵ h τ⁴/1440; together, a curved strip is stiffer against twist, by
up to 1/(1 − ν) times GJ. Clamps add ``½ p F EI κ²``, p being what they stiffen a flat strip by.
Derived here; in units of the blade (EI, l).
"""

from math import factorial
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Curled", "curled"]

Floats = NDArray[np.float64]

_TERMS = 40
"""Terms of the series in β⁴, all of one sign: every digit up to ``_WIDE``."""

_WIDE = 25.0
"""β above which F is 2/β but for exp(−β)."""

_ABOVE = np.array([2.0 / factorial(4 * k + 5) - 4.0 / factorial(4 * k + 6) for k in range(_TERMS)])
_BELOW = np.array([2.0 / factorial(4 * k + 1) for k in range(_TERMS)])
"""(1 − F)/β⁴ is the quotient of these two polynomials of β⁴."""


def _derivatives(c: Floats) -> list[Floats]:
    """Return the coefficients of a polynomial and of its first two derivatives, equally many."""
    return [np.pad(np.polynomial.polynomial.polyder(c, k), (0, k)) for k in range(3)]


_COLUMNS = np.stack([*_derivatives(_ABOVE), *_derivatives(_BELOW)], axis=-1)

_MOST = 60
_CLOSE = 1e-14


class Curled(NamedTuple):
    """Curvature by moment M and twist rate τ, and the torque that curling adds.

    ``compliance`` is ∂κ/∂M, ``coupling`` ∂κ/∂τ = −∂T/∂M, ``stiffness`` ∂T/∂τ at constant moment.
    """

    kappa: Floats
    torque: Floats
    compliance: Floats
    coupling: Floats
    stiffness: Floats


def curled(M: Floats, tau: Floats, clamped: Floats, width: Floats, nu: Floats) -> Curled:
    """Return how a strip bends and twists.

    Parameters
    ----------
    M, tau : array
        Bending moment across the thickness [EI/l] and twist rate [1/l].
    clamped : array
        p, what the clamps stiffen bending by at small curvature [-].
    width : array
        β⁴/κ² = 3 (1 − ν²) (b²/(h l))², zero for a section that does not curl [-].
    nu : array
        Poisson's ratio [-].

    Notes
    -----
    Far twisted, a strip bends by itself, and a moment has more than one curvature; the compliance
    is negative where it is not that of the least energy.

    """
    M, tau, p, B, nu = np.broadcast_arrays(M, tau, clamped, width, nu)
    if not B.any():  # nothing curls
        none = np.zeros(M.shape)
        return Curled(M / (1.0 + p), none, 1.0 / (1.0 + p), none, none)
    plate = 1.0 / (1.0 - nu**2)
    kappa = M / (1.0 + p)
    for _ in range(_MOST):
        slope, bend, *_ = _energy(kappa, tau, p, B, nu, plate)
        step = (slope - M) / bend
        kappa = kappa - step
        if np.max(np.abs(step) / (1.0 + np.abs(kappa)), initial=0.0) <= _CLOSE:
            break
    _, bend, torque, mixed, twist = _energy(kappa, tau, p, B, nu, plate)
    return Curled(kappa, torque, 1.0 / bend, -mixed / bend, twist - mixed**2 / bend)


def _energy(
    kappa: Floats, tau: Floats, p: Floats, B: Floats, nu: Floats, plate: Floats
) -> tuple[Floats, Floats, Floats, Floats, Floats]:
    """Return the derivatives of the energy by κ, κκ, τ, κτ and ττ."""
    q = kappa**2
    g, g_1, g_2 = _flat(B * q)
    S = nu * q + tau**2
    square, slope = plate * S**2 - p * q**2, 2.0 * (plate * nu * S - p * q)
    U_q = (1.0 + p + B * (B * g_1 * square + g * slope)) / 2.0
    U_qq = B / 2.0 * (B**2 * g_2 * square + 2.0 * B * g_1 * slope + 2.0 * g * (plate * nu**2 - p))
    mixed = 4.0 * kappa * plate * B * tau * (B * g_1 * S + nu * g)
    twist = 2.0 * plate * B * g
    return (
        2.0 * kappa * U_q,
        2.0 * U_q + 4.0 * q * U_qq,
        twist * S * tau,
        mixed,
        twist * (S + 2.0 * tau**2),
    )


def _flat(X: Floats) -> tuple[Floats, Floats, Floats]:
    """Return ``(1 − F)/X`` of X = β⁴ and its first two derivatives."""
    low = np.minimum(X, _WIDE**4)
    powers = np.empty((*X.shape, _TERMS))
    powers[..., 0], powers[..., 1:] = 1.0, low[..., None]
    sums = np.multiply.accumulate(powers, axis=-1, out=powers) @ _COLUMNS
    P, Q = ([sums[..., k] for k in each] for each in (range(3), range(3, 6)))
    g = P[0] / Q[0]
    g_1 = (P[1] - g * Q[1]) / Q[0]
    g_2 = (P[2] - 2.0 * g_1 * Q[1] - g * Q[2]) / Q[0]
    far = X > _WIDE**4
    if np.any(far):
        high = np.maximum(X, _WIDE**4)
        # 1/X − 2 X^(−5/4)
        root = high**-0.25
        g = np.where(far, (1.0 - 2.0 * root) / high, g)
        g_1 = np.where(far, (-1.0 + 2.5 * root) / high**2, g_1)
        g_2 = np.where(far, (2.0 - 5.625 * root) / high**3, g_2)
    return g, g_1, g_2
