"""Gauss collocation on [−1, 1]: nodes, the matrix that integrates to them, interpolation.

Integrating a smooth function node by node with these matrices is the Gauss–Legendre method of
Runge–Kutta type: values at the far end have order 2·count and the method keeps the symmetry
(symplecticity) of a Hamiltonian system, so a tangent stiffness stays symmetric to rounding.
"""

import functools

import numpy as np
from numpy.typing import NDArray

__all__ = [
    "gauss_nodes",
    "integration_matrix",
    "integration_to",
    "interpolation_matrix",
    "refining_matrix",
    "slope_matrix",
]

Floats = NDArray[np.float64]


@functools.cache
def gauss_nodes(count: int) -> tuple[Floats, Floats]:
    """Return nodes and weights of the Gauss–Legendre rule on [−1, 1]; shared, do not write."""
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return nodes, weights


@functools.cache
def integration_matrix(count: int) -> Floats:
    """Return J with ``∫₋₁^{u_i} g du = Σ_j J_ij g(u_j)``, exact for degree count − 1.

    Parameters
    ----------
    count : int
        Number of Gauss nodes u_i [-].

    Returns
    -------
    array, shape (count, count)
        The matrix J [-]; shared, do not write.

    Examples
    --------
    >>> u, _ = gauss_nodes(3)
    >>> bool(np.allclose(integration_matrix(3) @ u, (u**2 - 1.0) / 2.0))
    True

    References
    ----------
    Hairer, Nørsett, Wanner (1993), Solving Ordinary Differential Equations I, section II.7.

    """
    return integration_to(count, gauss_nodes(count)[0])


def integration_to(count: int, points: Floats) -> Floats:
    """Return the matrix that integrates values at the Gauss nodes from −1 to each point.

    From the expansion in Legendre polynomials, ``∫₋₁^u P_n = (P_{n+1} − P_{n−1})/(2n + 1)``,
    which keeps all digits at any count.
    """
    P = np.polynomial.legendre.legvander(points, count)
    before = np.concatenate([-np.ones((*points.shape, 1)), P[..., : count - 1]], axis=-1)
    integrals = (P[..., 1:] - before) / (2.0 * np.arange(count) + 1.0)
    return np.asarray(integrals @ _coefficients(count))


def interpolation_matrix(count: int, points: Floats) -> Floats:
    """Return the matrix that takes values at the Gauss nodes to the points, through Legendre."""
    return np.asarray(np.polynomial.legendre.legvander(points, count - 1) @ _coefficients(count))


def slope_matrix(count: int, points: Floats) -> Floats:
    """Return the matrix that takes values at the Gauss nodes to slopes at the points."""
    slopes = np.polynomial.legendre.legder(_coefficients(count))
    return np.asarray(np.polynomial.legendre.legvander(points, len(slopes) - 1) @ slopes)


@functools.cache
def refining_matrix(count: int, fine: int) -> Floats:
    """Return the matrix from values at ``count`` Gauss nodes to ``fine``; shared, do not write."""
    return interpolation_matrix(count, gauss_nodes(fine)[0])


@functools.cache
def _coefficients(count: int) -> Floats:
    """Return the matrix from values at the nodes to coefficients of Legendre polynomials."""
    nodes, weights = gauss_nodes(count)
    P = np.polynomial.legendre.legvander(nodes, count - 1)
    return np.asarray((np.arange(count) + 0.5)[:, None] * P.T * weights)
