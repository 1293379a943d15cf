"""Gauss–Legendre quadrature: its nodes and weights."""

import functools

import numpy as np
from numpy.typing import NDArray

__all__ = ["gauss_rule"]

Floats = NDArray[np.float64]


@functools.cache
def gauss_rule(count: int) -> tuple[Floats, Floats]:
    """Give nodes and weights of the Gauss–Legendre rule on [0, 1].

    ∫₀¹ g(x) dx ≈ Σ w_i g(x_i), exact for polynomials of degree 2·count − 1.

    Parameters
    ----------
    count : int
        Number of nodes, [-].

    Returns
    -------
    tuple of arrays, shape (count,)
        Nodes x_i and weights w_i, [-]. Do not write to them: they are shared.

    Raises
    ------
    ValueError
        When `count` is less than one.

    Examples
    --------
    >>> x, w = gauss_rule(2)
    >>> round(float(w @ x**3), 12)
    0.25

    References
    ----------
    Abramowitz, Stegun 1964, Handbook of Mathematical Functions, 25.4.29.
    """
    nodes, weights = np.polynomial.legendre.leggauss(count)
    return 0.5 * (1 + nodes), 0.5 * weights
