"""Solutions of n equations in n unknowns, followed as the last equation is driven.

The equations are F(q) = (0, …, 0, t): all but the last stay closed while t, the parameter, moves.
"""

from dataclasses import dataclass
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError

__all__ = ["Curve", "CurvePoints", "Equations", "follow", "solve_at"]

Floats = NDArray[np.float64]

MOST_CHANGE = 0.5
"""Largest spectral radius of J⁻¹ΔJ in a step. Below 1 no matrix between J and J + ΔJ is singular,
so that a step jumps neither over a bifurcation nor to another branch. Unlike a norm it does not
depend on the units of the unknowns, which would shorten the steps of ill-shaped loops."""
LONGEST = 1.0
"""Largest change of any unknown in a step: J may be the same again a full turn away."""
BESIDE = 2.0
"""A solution is rejected when it is farther from the nearest point of the curve than so many times
the distance from there to the next one."""
WISH = 0.3
"""Spectral radius of J⁻¹ΔJ that steps aim for."""
GROWTH = 3.0
SHORTEST = 1e-11
"""Step, over the larger of |t| and 1, at which the curve ends. Steps are a share of the distance to
a singular point, so this is also about how near to it the curve comes."""
CLOSE = 1e-9
"""Newton step after which one more, by quadratic convergence, reaches rounding."""
NEWTON_STEPS = 10


class Equations(Protocol):
    """n functions of n unknowns with their derivatives; unknowns and values of order one."""

    def values(self, q: Floats) -> Floats:
        """Return F, shape (..., n), at q, shape (..., n)."""
        ...

    def jacobian(self, q: Floats) -> Floats:
        """Return ∂F/∂q, shape (..., n, n)."""
        ...

    def bend(self, q: Floats, v: Floats) -> Floats:
        """Return the second derivative of F along v, shape (..., n)."""
        ...


class CurvePoints(NamedTuple):
    """Points q of a curve of solutions, shape (m, n), with dq/dt and d²q/dt²."""

    q: Floats
    first: Floats
    second: Floats


@dataclass(frozen=True, eq=False)
class Curve:
    """A curve of solutions: its points at parameters t, rising, shape (k,)."""

    parameters: Floats
    points: CurvePoints


def follow(equations: Equations, q: Floats, *, start: float, low: float, high: float) -> Curve:
    """Return the curve through the solution q at t = start, from t = low to t = high.

    It ends early where J = ∂F/∂q turns singular. Each step goes along the second-order Taylor
    series and back to the curve by Newton's method; it is as long as the spectral radius of
    J⁻¹ΔJ stays below ½ and |Δq| below 1.

    Parameters
    ----------
    equations : Equations
        F(q) and its derivatives.
    q : array, shape (n,)
        A solution, at which J is regular.
    start, low, high : float
        Its parameter, and the ends asked for: low ≤ start ≤ high.

    Returns
    -------
    Curve
        Its ends equal low and high exactly unless it ended early.

    Examples
    --------
    >>> class Square:
    ...     def values(self, q): return q**2
    ...     def jacobian(self, q): return 2 * q[..., None]
    ...     def bend(self, q, v): return 2 * v**2
    >>> curve = follow(Square(), np.array([1.0]), start=1.0, low=-1.0, high=4.0)
    >>> abs(round(float(curve.parameters[0]), 9)), float(curve.points.q[-1, 0])
    (0.0, 2.0)

    References
    ----------
    Deuflhard (2004), Newton Methods for Nonlinear Problems, section 5.1 (step control).

    """
    falling_t, falling_q = _branch(equations, q, start, low)
    rising_t, rising_q = _branch(equations, q, start, high)
    points = np.array([*falling_q[::-1], q, *rising_q])
    return Curve(
        np.array([*falling_t[::-1], start, *rising_t]),
        CurvePoints(points, *_derivatives(equations, points)),
    )


def solve_at(equations: Equations, curve: Curve, parameters: Floats) -> CurvePoints:
    """Return the solutions on a curve at any parameters, shape (m,), and their derivatives.

    Raises
    ------
    ValueError
        When a parameter lies beyond the ends of the curve.
    SolveError
        When Newton's method does not settle, or settles off the curve.
    """
    nodes = curve.parameters
    if np.any((parameters < nodes[0]) | (parameters > nodes[-1])):
        raise ValueError(f"the curve has solutions from {nodes[0]:g} to {nodes[-1]:g} only")
    nearest = np.searchsorted((nodes[1:] + nodes[:-1]) / 2.0, parameters)
    at = curve.points
    away = (parameters - nodes[nearest])[:, None]
    guess = at.q[nearest] + away * (at.first[nearest] + away / 2.0 * at.second[nearest])
    q = _newton(equations, guess, parameters)
    if q is None or np.any(_size(q - at.q[nearest]) > BESIDE * _spacing(curve, parameters)):
        raise SolveError(
            "did-not-converge",
            "Newton's method did not settle on the curve",
            "follow the curve more closely",
        )
    return CurvePoints(q, *_derivatives(equations, q))


def _branch(
    equations: Equations, q: Floats, t: float, end: float
) -> tuple[list[float], list[Floats]]:
    """Return parameters and solutions after t, up to the end or a singular point."""
    parameters: list[float] = []
    points: list[Floats] = []
    step = end - t
    while t != end:
        J = equations.jacobian(q)
        first, second = _derivatives(equations, q)
        step = min(step, end - t, key=abs)
        while True:
            if abs(step) < SHORTEST * max(abs(t), 1.0) and step != end - t:
                return parameters, points
            target = end if step == end - t else t + step
            guess = q + step * (first + step / 2.0 * second)
            found = _newton(equations, guess, np.float64(target))
            if found is not None:
                ratio = np.linalg.solve(J, equations.jacobian(found))
                change = float(np.abs(np.linalg.eigvals(ratio) - 1.0).max())
                if change <= MOST_CHANGE and _size(found - q) <= LONGEST:
                    break
            step /= 2.0
        t, q = target, found
        parameters.append(t)
        points.append(q)
        step *= min(GROWTH, WISH / max(change, WISH / GROWTH))
    return parameters, points


def _derivatives(equations: Equations, q: Floats) -> tuple[Floats, Floats]:
    """Return dq/dt and d²q/dt² from J q' = (0, …, 0, 1) and J q'' = −F_qq q' q'."""
    J = equations.jacobian(q)
    drive = np.zeros_like(q)
    drive[..., -1] = 1.0
    first = np.asarray(np.linalg.solve(J, drive[..., None])[..., 0], dtype=np.float64)
    load = -equations.bend(q, first)[..., None]
    return first, np.asarray(np.linalg.solve(J, load)[..., 0], dtype=np.float64)


def _spacing(curve: Curve, parameters: Floats) -> Floats:
    """Return the distance between the neighbouring points of the curve at each parameter."""
    after = np.clip(np.searchsorted(curve.parameters, parameters), 1, curve.parameters.size - 1)
    return _size(curve.points.q[after] - curve.points.q[after - 1])


def _size(q: NDArray[np.floating]) -> Floats:
    """Return the largest magnitude along the last axis."""
    return np.asarray(np.abs(q).max(axis=-1), dtype=np.float64)


def _newton(equations: Equations, q: Floats, t: Floats | np.float64) -> Floats | None:
    """Return the solutions near q at parameters t, or None when one does not converge."""
    settled = np.zeros(q.shape[:-1], dtype=bool)
    for _ in range(NEWTON_STEPS):
        gap = equations.values(q)
        gap[..., -1] -= t
        try:
            step = np.linalg.solve(equations.jacobian(q), gap[..., None])[..., 0]
        except np.linalg.LinAlgError:
            return None
        q = q - step
        if np.all(settled):
            return q
        # once is enough: near a singular point rounding alone may make a later step as long
        settled = settled | (_size(step) <= CLOSE)
    return None
