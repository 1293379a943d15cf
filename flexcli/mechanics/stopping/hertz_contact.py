"""A blade against a Hertzian stop: the one phase that is not linear, integrated adaptively."""

from cmath import exp
from collections.abc import Callable, Sequence
from functools import cache
from math import sqrt
from operator import mul
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.stopping.laws import HertzStop
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.exponential_sum import polynomial_at
from flexcli.numerics.signal_pieces import Piece

__all__ = ["HertzContact", "HertzPass"]

Floats = NDArray[np.float64]

RTOL = 1e-9
"""Local error per step of the eighth-order method, relative to the state at the touch."""
LEAST = 1e-8
"""Least u at the start, as a share of its size to come."""
SAMPLES = np.arange(1, 9) / 8.0
"""Shares of a step at which the motion is sampled, by Hermite's cubic between its ends."""
_TIME, _ROOT = -2, -1
"""Places of t and u in a state."""
_NEWTON = 50
_EPS = 1e-15
_SAFETY, _LEAST_STEP, _MOST_STEP = 0.9, 0.2, 6.0
"""Of a next step: what it keeps of the one that the error calls for, and its least and most."""


class _Tableau(NamedTuple):
    """Dormand and Prince's tableau of order 8, and its errors of order 3 and 5.

    Hairer, Nørsett and Wanner (1993), section II.10.
    """

    rows: list[list[float]]
    weights: list[float]
    third: list[float]
    fifth: list[float]


@cache
def _tableau() -> _Tableau:
    from scipy.integrate import DOP853  # of balls only, and slow to import

    rows = [row[:s].tolist() for s, row in enumerate(DOP853.A)][1 : DOP853.n_stages]
    return _Tableau(rows, DOP853.B.tolist(), DOP853.E3.tolist(), DOP853.E5.tolist())


class HertzPass(NamedTuple):
    """What a pass through a contact did, to its end or to the end of a piece.

    ``times`` from the start, ``motions`` (modes, times) and ``pushes`` are samples; the integrals
    are those of a record.
    """

    length: float
    released: bool
    q: Floats
    rate: Floats
    work: float
    damped: float
    lost: float
    base_integral: float
    impulse: float
    q_integral: Floats
    evaluations: int
    times: Floats
    motions: Floats
    pushes: Floats


class HertzContact:
    """The blade and one of two like Hertzian stops."""

    def __init__(self, blade: ModalBlade, law: HertzStop, gap: float, side: int) -> None:
        """Keep what the equations need."""
        self._blade = blade
        self._law = law
        self._gap = gap
        self._side = side
        self._compliance = law.compliance + blade.stop_residual

    def approach(self, q: Floats) -> float:
        """Return how far the modes lie beyond the stop's place [m]."""
        return self._side * float(self._blade.stop @ q) - self._gap

    def _root_of_indentation(self, approach: float) -> float:
        """Return u = √δ of ``δ + C k δ^(3/2) = approach``: convex, so Newton comes from above."""
        if approach <= 0.0:
            return 0.0
        hardness = self._compliance * self._law.stiffness
        u = sqrt(approach)
        for _ in range(_NEWTON):
            change = (u * u * (hardness * u + 1.0) - approach) / (u * (3.0 * hardness * u + 2.0))
            u -= change
            if abs(change) <= 1e-15 * u:
                break
        return u

    def energy(self, q: Floats) -> float:
        """Return what contact and compliance store [J]."""
        u = self._root_of_indentation(self.approach(q))
        force = self._law.stiffness * u**3
        return 0.4 * force * u * u + 0.5 * self._compliance * force**2

    def pass_through(self, q: Floats, rate: Floats, piece: Piece) -> HertzPass:
        """Integrate from a state in touch to release, or to the end of a piece.

        In time the force starts and ends as t^(3/2), which no method of high order likes. For
        u = √δ the approach w is ``u² + C k u³``; with σ by ``dt = (dw/du) dσ`` all is smooth, also
        where u vanishes: ``du/dσ`` is the rate of approach, and δ needs no root. Beyond a release
        the equations go on as smoothly, so that the last step may be taken too far, and again.
        """
        n, square, stop = q.size, self._blade.angular**2, self._side * self._blade.stop
        # unit modal masses: energy gives the scale of speeds, and the fastest mode that of q
        energy = 0.5 * float(rate @ rate + square @ q**2) or 1e-150
        speed_size, fastest = sqrt(2.0 * energy), float(self._blade.angular.max())
        deep = speed_size * float(np.abs(stop).max()) / fastest
        size = [speed_size / fastest] * n + [speed_size] * n + [1.0 / fastest, sqrt(deep)]
        # from u = 0 at rest nothing would start; so small, δ is below rounding
        u = max(self._root_of_indentation(self.approach(q)), LEAST * sqrt(deep))
        slope, x = self._slope(piece), [*q.tolist(), *rate.tolist(), 0.0, u]
        steps = [_Step(0.0, x, *slope(x), [0.0] * (5 + n), 0.0)]
        h, evaluations, released, ended = self._first_step(x), 1, False, False
        while not (released or ended):
            last, found = steps[-1], _stepped(slope, steps[-1], h, size)
            evaluations += 1 + len(_tableau().rows)
            if found.error > 1.0:
                h *= max(_LEAST_STEP, _SAFETY * found.error**-0.125)
                continue
            if found.x[_ROOT] <= 0.0:
                found, released = _stepped_to(slope, last, found, size, _ROOT, 0.0), True
            if found.x[_TIME] >= piece.duration:
                found = _stepped_to(slope, last, found, size, _TIME, piece.duration)
                released, ended = False, True
            steps.append(found)
            h *= min(_MOST_STEP, _SAFETY * max(found.error, _EPS) ** -0.125)
        times, motions, rates, indented = _samples(steps, n)
        factor = 1.0 + self._law.dissipation * (stop @ rates)
        work, damped, lost, base_integral, impulse, *of_modes = (
            sum(parts) for parts in zip(*(step.sums for step in steps), strict=True)
        )
        return HertzPass(
            length=piece.duration if ended else steps[-1].x[_TIME],
            released=released,
            q=np.array(steps[-1].x[:n]),
            rate=np.array(steps[-1].x[n : 2 * n]),
            work=work,
            damped=damped,
            lost=lost,
            base_integral=base_integral,
            impulse=impulse,
            q_integral=np.array(of_modes),
            evaluations=evaluations,
            times=times,
            motions=motions,
            pushes=self._law.stiffness * np.maximum(indented, 0.0) ** 3 * np.maximum(factor, 0.0),
        )

    def _slope(self, piece: Piece) -> "_Slope":
        """Return what gives the slopes of (q, their rates, t, u) by σ, and those of the sums.

        These are work, losses in blade and stop, integrals of base, push and each mode. Numbers
        one by one: for a few modes much faster than arrays.
        """
        blade, law, n = self._blade, self._law, self._blade.angular.size
        base, stop = blade.base.tolist(), (self._side * blade.stop).tolist()
        springs, dampers = (blade.angular**2).tolist(), np.diagonal(blade.damper).tolist()
        hardness = 3.0 * self._compliance * law.stiffness
        # of conjugate terms one stands for both
        waves = [(f, p, 2.0 if f.imag else 1.0) for f, p in piece.terms if f.imag >= 0.0]

        def slope(x: Sequence[float]) -> tuple[list[float], list[float]]:
            t, u = x[-2:]
            q, rate = x[:n], x[n : 2 * n]
            a = sum([twice * (polynomial_at(p, t) * exp(f * t)).real for f, p, twice in waves])
            pace, speed = u * (2.0 + hardness * u), sum(map(mul, stop, rate))
            elastic = law.stiffness * u**3
            push = elastic * max(1.0 + law.dissipation * speed, 0.0)
            paced = [pace * v for v in rate]
            forces = [
                -pace * (b * a + c * v + k * z + push * s)
                for b, c, k, s, z, v in zip(base, dampers, springs, stop, q, rate, strict=True)
            ]
            work = -a * sum(map(mul, base, paced))
            damped = sum(map(mul, dampers, map(mul, rate, paced)))
            lost = pace * (push - elastic) * speed
            sums = [work, damped, lost, pace * a, pace * push, *[pace * z for z in q]]
            return [*paced, *forces, pace, speed], sums

        return slope

    def _first_step(self, x: Sequence[float]) -> float:
        """Return a share of the way in σ to the deepest place, as a mass at the stop would go."""
        blade, k, C = self._blade, self._law.stiffness, self._compliance
        weight, n = float(blade.stop @ blade.stop), blade.angular.size
        speed = abs(float(blade.stop @ x[n : 2 * n]))
        deepest = (1.25 * speed**2 / (k * weight)) ** 0.2
        if C:
            deepest = min(deepest, (speed / (k * sqrt(weight * C))) ** (1.0 / 3.0))
        u = max(x[_ROOT], deepest)
        slow = 1.0 / (float(blade.angular.max()) * u * (2.0 + 3.0 * C * k * u))
        return 0.25 * float(min(u / speed, slow) if speed > 0.0 else slow)


_Slope: TypeAlias = Callable[[Sequence[float]], tuple[list[float], list[float]]]


class _Step(NamedTuple):
    """A step of length h: the state at its end, the slopes there, and what it adds to the sums.

    ``error`` is that of the step over what is allowed.
    """

    h: float
    x: list[float]
    slopes: list[float]
    sum_slopes: list[float]
    sums: list[float]
    error: float


def _stepped(slope: _Slope, last: _Step, h: float, size: Sequence[float]) -> _Step:
    """Return a step from the end of the last one."""
    stages, parts = [[k] for k in last.slopes], [last.sum_slopes]
    tableau = _tableau()
    for row in tableau.rows:
        slopes, sums = slope(_advanced(last.x, h, row, stages))
        for stage, value in zip(stages, slopes, strict=True):
            stage.append(value)
        parts.append(sums)
    x = _advanced(last.x, h, tableau.weights, stages)
    slopes, sums = slope(x)
    third = fifth = 0.0
    for stage, value, scale in zip(stages, slopes, size, strict=True):
        stage.append(value)
        third += (sum(map(mul, tableau.third, stage)) / scale) ** 2
        fifth += (sum(map(mul, tableau.fifth, stage)) / scale) ** 2
    whole = sqrt((fifth + 0.01 * third) * len(x))
    error = h * fifth / (whole * RTOL) if whole else 0.0
    total = [h * sum(map(mul, tableau.weights, part)) for part in zip(*parts, strict=True)]
    return _Step(h, x, slopes, sums, total, error)


def _advanced(
    x: Sequence[float], h: float, row: Sequence[float], stages: Sequence[Sequence[float]]
) -> list[float]:
    """Return a state moved by a step along the weighted slopes of stages."""
    return [z + h * sum(map(mul, row, stage)) for z, stage in zip(x, stages, strict=True)]


def _stepped_to(
    slope: _Slope, last: _Step, beyond: _Step, size: Sequence[float], index: int, level: float
) -> _Step:
    """Return the step at whose end a variable meets a level that it passes, by Newton's method."""
    low, high, found = 0.0, beyond.h, beyond
    rises = index == _TIME
    for _ in range(_NEWTON):
        over = found.x[index] - level
        if abs(over) <= _EPS * max(size[index], level):
            break
        low, high = (low, found.h) if (over > 0.0) is rises else (found.h, high)
        h = found.h - over / found.slopes[index] if found.slopes[index] else low
        if not low < h < high:
            h = (low + high) / 2.0
        found = _stepped(slope, last, h, size)
    return found


def _samples(steps: Sequence[_Step], n: int) -> tuple[Floats, Floats, Floats, Floats]:
    """Return times, q, their rates and u at the start and within every step."""
    x, slopes = (np.array([getattr(step, of) for step in steps]) for of in ("x", "slopes"))
    h = np.array([step.h for step in steps[1:]])[:, None, None]
    s = SAMPLES[:, None]
    whole = (
        x[:-1, None] * (1.0 + 2.0 * s) * (1.0 - s) ** 2 + x[1:, None] * s**2 * (3.0 - 2.0 * s)
        + h * (slopes[:-1, None] * s * (1.0 - s) ** 2 - slopes[1:, None] * s**2 * (1.0 - s))
    ).reshape(-1, x.shape[1])  # fmt: skip
    rows = np.concatenate([x[:1], whole]).T
    return rows[_TIME], rows[:n], rows[n : 2 * n], rows[_ROOT]
