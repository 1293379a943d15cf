"""Convex models of rows known as numbers, as posynomials, and the step that minimises them."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from flexcli.numerics.interior_point import central_path
from flexcli.numerics.log_sum_exp import Expansion, LogSumExp
from flexcli.numerics.signomial import Floats

__all__ = ["ModelStep", "best_step", "posynomials"]

STRAIGHT = 1e-6
"""Curvature below which a row is a monomial."""
SPREAD = 0.5
"""Largest share of a posynomial that is moved from its middle term to represent curvature."""
START = 1.0
"""How far above the largest violation the interior-point path starts, in logarithms."""


class ModelStep(NamedTuple):
    """A step, multipliers of the rows after the objective, and the violation left by the model.

    ``fall`` is the decrease of the model's objective, its log violation not counted.
    """

    step: Floats
    multipliers: Floats
    violation: float
    fall: float


def posynomials(at: Expansion) -> LogSumExp:
    r"""Return rows with the values, gradients and convex parts of the curvatures of an expansion.

    .. math:: f(d) = \ln\Big(1 - \sum_i w_i + \sum_i \tfrac{w_i}{2}
              (e^{s v_i d} + e^{-s v_i d})\Big) + g d + f_0, \quad w_i s^2 = \lambda_i

    where λ, v are the positive eigenvalues of the curvature and their directions: a mean of
    exponents equal to the gradient, a covariance equal to the curvature. Concave parts are left
    out, which makes the row larger than it is.
    """
    lambdas, vectors = np.linalg.eigh(at.curvatures)
    exponents: list[Floats] = []
    logs: list[float] = []
    first: list[int] = []
    for value, gradient, bends, ways in zip(
        at.values, at.jacobian, lambdas, np.swapaxes(vectors, 1, 2), strict=True
    ):
        first.append(len(logs))
        curved = bends > STRAIGHT
        total = float(bends[curved].sum())
        s2 = max(1.0, total / SPREAD)
        exponents.append(gradient)
        logs.append(float(value + np.log1p(-total / s2)))
        for bend, way in zip(bends[curved], ways[curved], strict=True):
            for sign in (1.0, -1.0):
                exponents.append(gradient + sign * np.sqrt(s2) * way)
                logs.append(float(value + np.log(0.5 * bend / s2)))
    return LogSumExp(np.array(exponents), np.array(logs), np.array(first, dtype=np.intp))


def best_step(
    at: Expansion, convex: LogSumExp, low: Floats, high: Floats, *, penalty: float
) -> ModelStep:
    """Minimise the model's objective plus ``penalty`` times its largest violation in a box.

    Row 0 of the expansion is the objective, then come inequalities, which ``convex`` holds as
    convex rows over the step, and equalities, whose tangents count. The violation t is a variable,
    so the model is feasible at any point and needs no first phase; an infinite penalty leaves the
    objective out.

    References
    ----------
    R. Fletcher (1987), Practical Methods of Optimization, §14.4, for the exact penalty of the
    largest violation in a trust region.

    """
    keep = convex.first.size
    n = low.size
    goal = convex.rows([0])
    if np.isinf(penalty):
        goal, penalty = LogSumExp(np.zeros((1, n)), np.zeros(1), np.zeros(1, dtype=np.intp)), 1.0
    limits = convex.rows(range(1, keep))
    G, g = at.jacobian[keep:], at.values[keep:]
    lines = np.vstack([G, -G, np.zeros((1, n)), np.eye(n), -np.eye(n)])
    offsets = np.concatenate([g, -g, [0.0], -high, low])
    above = np.concatenate([
        np.full(goal.logs.size, penalty), np.full(limits.logs.size, -1.0),
        np.full(2 * g.size + 1, -1.0), np.zeros(2 * n),
    ])  # fmt: skip
    count = goal.logs.size + limits.logs.size
    pack = LogSumExp(
        np.column_stack([np.vstack([goal.exponents, limits.exponents, lines]), above]),
        np.concatenate([goal.logs, limits.logs, offsets]),
        np.concatenate([
            [0], goal.logs.size + limits.first, count + np.arange(offsets.size)
        ]).astype(np.intp),
    )  # fmt: skip
    worst = max(0.0, float(at.values[1:keep].max(initial=0.0)), float(np.abs(g).max(initial=0.0)))
    point = central_path(pack, np.append(np.zeros(n), worst + START))
    m, q = keep - 1, g.size
    both = point.multipliers[m : m + 2 * q]
    step = point.y[:n]
    fall = float(goal.values(np.zeros(n))[0] - goal.values(step)[0])
    multipliers = np.append(point.multipliers[:m], both[:q] - both[q:])
    return ModelStep(step, multipliers, float(point.y[n]), fall)
