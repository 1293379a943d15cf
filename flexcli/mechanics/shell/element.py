"""Strips of thin shell on one set of functions: slope and Hessian of their energies.

A strip is x(s, t) = Σ φ_i(s) ψ_j(t) d_ij with vectors d_ij (:mod:`flexcli.mechanics.shell.basis`).
All is in units of its blade: lengths by l, energy by EI/l with EI = E b h³/12. Sums over Gauss
points are split, first across the strip, then along it.
"""

import functools
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.shell.basis import Basis
from flexcli.mechanics.shell.strain import density

__all__ = ["Strips", "derivatives", "energy_slopes"]

Floats = NDArray[np.float64]

_ORDERS = ((1, 0), (0, 1), (2, 0), (0, 2), (1, 1))
"""Orders along and across of x_1, x_2, x_11, x_22, x_12."""

_BY_ALONG = (slice(1, 4, 2), slice(0, 5, 4), slice(2, 3))
"""Which of them are of order 0, 1 and 2 along."""

_PAIRS = tuple((m, n) for m in range(3) for n in range(m, 3))


class Strips(NamedTuple):
    """Strips of equal functions: b/l (strips,), (l/h)², ν, and E_11 of each that is free."""

    basis: Basis
    width: Floats
    slender: Floats
    nu: Floats
    grown: Floats

    @property
    def law(self) -> Floats:
        """Return stress over strain, in units of the stiffness (strips, 3, 3)."""
        law = np.zeros((self.nu.size, 3, 3))
        law[:, 0, 0] = law[:, 1, 1] = 1.0
        law[:, 0, 1] = law[:, 1, 0] = self.nu
        law[:, 2, 2] = (1.0 - self.nu) / 2.0
        return law


def derivatives(strips: Strips, along: Floats, across: Floats, d: Floats) -> Floats:
    """Return x_1, x_2, x_11, x_22, x_12 at points (strips, along, across, 5, 3).

    ``along`` and ``across`` are the functions sampled there (3, functions, points), ``d`` the
    vectors (strips, functions along, functions across, 3).
    """
    B, m, n = d.shape[:3]
    half = 2.0 / strips.width[:, None, None, None]
    rows = [f.T @ d.reshape(B, m, n * 3) for f in along]
    found = []
    for o_along, o_across in _ORDERS:
        part = rows[o_along].reshape(B, -1, n, 3)
        g = across[o_across].T @ part
        found.append(g * half**o_across)
    return np.stack(found, axis=-2)


def energy_slopes(strips: Strips, d: Floats) -> tuple[Floats, Floats]:
    """Return slope (strips, n) and Hessian (strips, n, n) of the energies by the vectors d."""
    at = strips.basis.sampled()
    B, m, n = d.shape[:3]
    rows, columns = at.weight_along.size, at.weight_across.size
    g = derivatives(strips, at.along, at.across, d)
    points = rows * columns
    weight = np.outer(at.weight_along, at.weight_across).ravel()
    stiff = weight / 2.0 / (1.0 - strips.nu[:, None] ** 2)
    found = density(
        g.reshape(B, points, 5, 3),
        strips.grown,
        12.0 * strips.slender[:, None] * stiff,
        stiff,
        strips.law,
    )
    scale = np.array([(2.0 / strips.width) ** o[1] for o in _ORDERS]).T
    slope = found.slope.reshape(B, rows, columns, 5, 3) * scale[:, None, None, :, None]
    sums = np.zeros((B, rows, 3, n, 3))
    for k, (o_along, o_across) in enumerate(_ORDERS):
        sums[:, :, o_along] += at.across[o_across] @ slope[..., k, :]
    first = at.along.transpose(2, 0, 1).reshape(3 * rows, m)
    gradient = (first.T @ sums.reshape(B, rows * 3, n * 3)).reshape(B, m * n * 3)
    H = found.hessian.reshape(B, rows, columns, 5, 3, 5, 3)
    H = H * scale[:, None, None, :, None, None, None] * scale[:, None, None, None, None, :, None]
    along, across = _products(strips.basis)
    parts = np.empty((B, len(_PAIRS), rows, n * n, 9))
    for k, (p, q) in enumerate(_PAIRS):
        left, right = _BY_ALONG[p], _BY_ALONG[q]
        block = H[:, :, :, left][..., right, :]
        # to (orders, orders, across), (along, components)
        block = block.transpose(0, 3, 5, 2, 1, 4, 6).reshape(B, across[k].shape[1], rows * 9)
        summed = (across[k] @ block).reshape(B, n * n, rows, 9)
        parts[:, k] = np.swapaxes(summed, 1, 2)
    whole = along @ parts.reshape(B, len(_PAIRS) * rows, n * n * 9)
    whole = whole.reshape(B, m, m, n, n, 3, 3).transpose(0, 1, 3, 5, 2, 4, 6)
    whole = whole.reshape(B, m * n * 3, m * n * 3)
    return gradient, whole + np.swapaxes(whole, -1, -2)


@functools.cache
def _products(basis: Basis) -> tuple[Floats, tuple[Floats, ...]]:
    """Return products of functions along (m², pairs × points) with weights, those across."""
    at = basis.sampled()
    along, across = [], []
    for p, q in _PAIRS:
        share = 0.5 if p == q else 1.0
        both = share * at.along[p][:, None] * at.along[q][None]
        along.append(both.reshape(-1, at.weight_along.size))
        lines = [
            at.across[_ORDERS[a][1]][:, None] * at.across[_ORDERS[b][1]][None]
            for a in range(5)[_BY_ALONG[p]]
            for b in range(5)[_BY_ALONG[q]]
        ]
        stacked = np.stack(lines, axis=2)
        across.append(stacked.reshape(stacked.shape[0] ** 2, -1))
    return np.concatenate(along, axis=1), tuple(across)
