"""Natural modes of a cantilever blade with a tip mass whose centre lies beyond its end."""

import numpy as np
from numpy.polynomial import Legendre
from numpy.typing import NDArray

from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.modes import natural_modes
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["cantilever_modes"]

Floats = NDArray[np.float64]

_EXTRA = 10
"""Shape functions beyond the modes asked: the modes converge to rounding."""


def _shapes(count: int, xi: Floats) -> tuple[Floats, Floats, Floats]:
    """Return ξ² P_i(2ξ − 1), first and second derivative, shape (count, points)."""
    square = Legendre([1 / 3, 1 / 2, 1 / 6], domain=[0, 1])  # ξ² in polynomials of 2ξ − 1
    basis = [square * Legendre.basis(i, domain=[0, 1]) for i in range(count)]
    values, slopes, bends = (
        np.array([function.deriv(order)(xi) if order else function(xi) for function in basis])
        for order in (0, 1, 2)
    )
    return values, slopes, bends


def cantilever_modes(
    *,
    E: float,
    I: float,
    L: float,
    L_a: float,
    m: float,
    blade_mass: float = 0.0,
    c: float = 0.0,
    J: float = 0.0,
    modes: int = 1,
    quality: float = np.inf,
) -> ModalBlade:
    """Return the modes of a cantilever with a tip mass, and what a stop at L_a sees of them.

    Euler–Bernoulli, by Ritz's method in polynomials; the tip mass moves by ``w(L) + c w'(L)``
    and turns by w'(L). Residual compliances: ``L_a³/(3EI) − Σ φ(L_a)²/ω²`` and alike.

    Parameters
    ----------
    E : float
        Young's modulus [Pa].
    I : float
        Second moment of area [m⁴].
    L, L_a : float
        Length of the blade and height of the stop over the clamp [m].
    m : float
        Tip mass [kg].
    blade_mass : float
        Mass of the blade, uniform [kg].
    c : float
        Distance of the tip mass's centre beyond the end of the blade [m].
    J : float
        Inertia of the tip mass about its centre [kg·m²].
    modes : int
        Number of modes; fewer when fewer have mass.
    quality : float
        Quality factor Q of each mode.

    Returns
    -------
    ModalBlade
        Modes and residual compliances.

    Notes
    -----
    With a massless blade and a mass point there is one mode, the residual compliance is exact,
    and blade and stop are a bilinear oscillator of stiffness 3EI/L³ and 12EI/(L_b²(3L_a + 4L_b)).

    Raises
    ------
    ValueError
        When L_a does not lie on the blade.

    Examples
    --------
    >>> blade = cantilever_modes(E=60e9, I=1e-13, L=20e-3, L_a=12e-3, m=5e-3)
    >>> round(float(blade.angular[0] ** 2 * 5e-3 * 20e-3 ** 3 / (3 * 60e9 * 1e-13)), 9)
    1.0

    References
    ----------
    Meirovitch (2001), Fundamentals of Vibrations, sections 8.4, 9.6; Craig (1987), residual
    flexibility.

    """
    if not 0.0 < L_a <= L:
        raise ValueError(f"the stop must lie on the blade, got L_a = {L_a:g} of L = {L:g}")
    count = modes + _EXTRA if blade_mass else 2
    xi, weights = gauss_rule(2 * count + 2)
    w, _, bend = _shapes(count, xi)
    EI = E * I
    K = EI / L**3 * (bend * weights) @ bend.T
    end, end_slope, _ = (f[:, 0] for f in _shapes(count, np.array([1.0])))
    end_slope = end_slope / L
    centre = end + c * end_slope
    M = blade_mass * (w * weights) @ w.T + m * np.outer(centre, centre)
    M += J * np.outer(end_slope, end_slope)
    found = natural_modes(K, M)
    angular, shapes = found.angular[:modes], found.shapes[:, :modes]
    at_stop = _shapes(count, np.array([L_a / L]))[0][:, 0] @ shapes
    tip = end @ shapes
    base_moment = EI / L**2 * _shapes(count, np.array([0.0]))[2][:, 0] @ shapes
    return ModalBlade(
        angular=angular,
        damping=np.full(angular.size, 0.5 / quality),
        base=(blade_mass * w @ weights + m * centre) @ shapes,
        tip=tip,
        stop=at_stop,
        base_moment=base_moment,
        stop_residual=float(L_a**3 / (3.0 * EI) - (at_stop**2 / angular**2).sum()),
        tip_residual=float(
            L_a**2 * (3.0 * L - L_a) / (6.0 * EI) - (at_stop * tip / angular**2).sum()
        ),
        moment_residual=float(L_a - (at_stop * base_moment / angular**2).sum()),
    )
