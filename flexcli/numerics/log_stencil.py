"""Values, gradients and curvatures of black-box functions, by finite differences."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeAlias

import numpy as np

from flexcli.numerics.log_sum_exp import Expansion
from flexcli.numerics.signomial import Floats

__all__ = ["STEP", "Field", "differences"]

Field: TypeAlias = Callable[[Floats], Floats]
"""Rows at points: from logarithms of the variables (n, points) to values (rows, points)."""

STEP = 2e-3
"""Step of the differences in logarithms: of fourth order they err by some 1e-12 in the gradient
and 1e-9 in the curvature, half from rounding and half from the order."""


def differences(rows: Field, y: Floats) -> Expansion:
    """Return the expansion of second order at y, all from one call of the rows.

    Central differences of fourth order along every axis and along every diagonal of two axes;
    the latter give the mixed curvatures: 1 + 2 n (n + 1) points.
    """
    n = y.size
    pairs = [(i, j) for i in range(n) for j in range(i)]
    ways = np.zeros((n + len(pairs), n))
    ways[:n] = np.eye(n)
    for k, (i, j) in enumerate(pairs):
        ways[n + k, [i, j]] = 1.0
    offsets = np.array([-2.0, -1.0, 1.0, 2.0])
    moves = (STEP * offsets[None, :, None] * ways[:, None, :]).reshape(-1, n)
    found = rows(np.column_stack([y[:, None], y[:, None] + moves.T]))
    values = found[:, 0]
    away = found[:, 1:].reshape(values.size, len(ways), 4)
    slopes = away[:, :n] @ np.array([1.0, -8.0, 8.0, -1.0]) / (12.0 * STEP)
    # differences from the centre first: the sum then rounds at the size of the change
    bends = (away - values[:, None, None]) @ np.array([-1.0, 16.0, 16.0, -1.0]) / (12.0 * STEP**2)
    H = np.zeros((values.size, n, n))
    axes = np.arange(n)
    H[:, axes, axes] = bends[:, :n]
    for k, (i, j) in enumerate(pairs):
        H[:, i, j] = H[:, j, i] = 0.5 * (bends[:, n + k] - bends[:, i] - bends[:, j])
    return Expansion(values, slopes, H)
