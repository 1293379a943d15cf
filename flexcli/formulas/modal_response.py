"""Random response of a linear structure, all of its modes together, to one base acceleration."""

from math import log

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.spectrum import Scale
from flexcli.numerics.quadrature import gauss_rule

__all__ = ["harmonic_gain", "response_moments", "squared_gain"]

Floats = NDArray[np.float64]

NODES = 16
"""Gauss nodes per panel."""
WIDEST = 1.5
"""Largest ratio of the ends of a panel: away from resonances the integrand is a power law."""
AT_ONCE = 500
"""Panels integrated at once, to stay within the cache."""


def response_moments(
    *,
    frequency: Floats,
    level: Floats,
    scale: Scale,
    angular: Floats,
    Q: float | Floats,
    coefficients: Floats,
    residual: Floats,
    orders: tuple[float, ...] = (0.0, 1.0, 2.0, 4.0),
) -> Floats:
    """Return spectral moments of linear outputs of a base-excited structure.

    ``y(ω) = [Σ c_i / (ω_i² − ω² + i ω ω_i/Q) + r] a(ω)`` and ``m_n = ∫ f^n |y/a|² G df``: the
    modes add as they are, correlation included.

    Parameters
    ----------
    frequency, level : array, shape (n,)
        Breakpoints of the base acceleration density [Hz], [(m/s²)²/Hz]; a repeated frequency is
        a step.
    scale : "log" or "linear"
        Axes in which the profile is straight.
    angular : array, shape (m,)
        Natural angular frequencies [rad/s] of the modes that may resonate.
    Q : float or array, shape (m,)
        Quality factor of every mode, or of each.
    coefficients : array, shape (k, m)
        c: output k per unit of mode m times its participation [unit of y per m/s² · rad²/s²].
    residual : array, shape (k,)
        r: what the other modes add without resonance [unit of y per m/s²].
    orders : tuple of float
        The moments wanted.

    Returns
    -------
    array, shape (len(orders), k)
        Moments [unit of y squared, times Hz^n].

    Notes
    -----
    Gauss quadrature on panels that shrink towards each resonance as fast as its pole comes near
    (at a distance f/2Q), so that the error is of the order of 1e-12 for any Q.

    Examples
    --------
    >>> flat = np.array([2.0, 2.0])
    >>> m = response_moments(frequency=np.array([1.0, 4.0]), level=flat, scale="log",
    ...                      angular=np.array([]), Q=10.0, coefficients=np.zeros((1, 0)),
    ...                      residual=np.array([3.0]))
    >>> round(float(m[0, 0]), 9)
    54.0

    References
    ----------
    Newland (1993), An Introduction to Random Vibrations, Spectral & Wavelet Analysis, 3rd ed.,
    chapter 8.

    """
    moments = np.zeros((len(orders), residual.size))
    nodes, weights = gauss_rule(NODES)
    edges = _edges(frequency, _marks(angular / (2.0 * np.pi), Q))
    for part in np.split(np.arange(edges.size - 1), range(AT_ONCE, edges.size - 1, AT_ONCE)):
        start, width = edges[part, None], np.diff(edges)[part, None]
        f = start + width * nodes
        # a panel lies on one segment, steps have none
        segment = np.searchsorted(frequency, start[:, 0], side="right") - 1
        f1, f2, g1, g2 = (
            each[:, None]
            for each in (frequency[segment], frequency[segment + 1],
                         level[segment], level[segment + 1])
        )  # fmt: skip
        if scale == "log":
            density = g1 * (f / f1) ** (np.log(g2 / g1) / np.log(f2 / f1))
        else:
            density = g1 + (g2 - g1) * (f - f1) / (f2 - f1)
        power = (density * width * weights).reshape(-1)
        f = f.reshape(-1)
        square = squared_gain(f, angular, Q, coefficients, residual) * power[:, None]
        moments += np.stack([f**order @ square for order in orders])
    return moments


def harmonic_gain(
    f: Floats, angular: Floats, Q: float | Floats, coefficients: Floats, residual: Floats
) -> NDArray[np.complex128]:
    """Return the complex amplitude of outputs per acceleration of the base, all modes together.

    ``y/a = Σ c_i / (ω_i² − ω² + i ω ω_i/Q) + r``.

    Parameters
    ----------
    f : array, shape (n,)
        Frequencies [Hz].
    angular : array, shape (m,)
        Natural angular frequencies [rad/s].
    Q : float or array, shape (m,)
        Quality factor of every mode, or of each.
    coefficients : array, shape (k, m)
        As in :func:`response_moments`.
    residual : array, shape (k,)
        As in :func:`response_moments`.

    Returns
    -------
    array, shape (n, k)
        Amplitudes [unit of y per m/s²].

    Examples
    --------
    >>> one = np.ones((1, 1))
    >>> f, angular = np.array([1.0]), np.array([2.0 * np.pi])
    >>> at_resonance = harmonic_gain(f, angular, 50.0, one, np.zeros(1))
    >>> round(float(abs(at_resonance[0, 0])) * (2.0 * np.pi) ** 2, 9)
    50.0

    References
    ----------
    Newland (1993), An Introduction to Random Vibrations, Spectral & Wavelet Analysis, 3rd ed.,
    chapter 7.

    """
    return np.asarray(_of_modes(f, angular, Q) @ coefficients.T + residual)


def squared_gain(
    f: Floats, angular: Floats, Q: float | Floats, coefficients: Floats, residual: Floats
) -> Floats:
    """Return the square of the size of :func:`harmonic_gain`, by products of real arrays alone."""
    gain = _of_modes(f, angular, Q)
    found, other = gain.real @ coefficients.T + residual, gain.imag @ coefficients.T
    found *= found
    other *= other
    found += other
    return np.asarray(found)


def _of_modes(f: Floats, angular: Floats, Q: float | Floats) -> NDArray[np.complex128]:
    """Return the gain of each mode (frequencies, modes) [s²]."""
    omega = 2.0 * np.pi * f[:, None]
    gain = 1.0 / ((angular - omega) * (angular + omega) + 1j * omega * angular / Q)
    return np.asarray(gain)


def _marks(resonances: Floats, Q: float | Floats) -> Floats:
    """Return panel ends that close in on each resonance by halves, down to its bandwidth."""
    found = [np.zeros(0)]
    for resonance, quality in zip(resonances, np.broadcast_to(Q, resonances.shape), strict=True):
        steps = max(0, int(np.ceil(np.log2(2.0 * quality)))) + 2
        offsets = 0.5 * 2.0 ** -np.arange(steps)
        found.append(resonance * (1.0 + np.concatenate([-offsets, [0.0], offsets])))
    return np.concatenate(found)


def _edges(frequency: Floats, marks: Floats) -> Floats:
    """Return panel ends over the band: no panel is wide, crosses a breakpoint or a mark."""
    low, high = float(frequency[0]), float(frequency[-1])
    count = max(1, int(np.ceil(log(high / low) / log(WIDEST))))
    regular = low * (high / low) ** (np.arange(1, count) / count)
    inside = marks[(marks > low) & (marks < high)]
    return np.unique(np.concatenate([frequency, regular, inside]))
