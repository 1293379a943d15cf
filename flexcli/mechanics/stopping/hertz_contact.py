"""A blade against a Hertzian stop: the one phase that is not linear, integrated adaptively."""

from collections.abc import Callable
from math import sqrt
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import DOP853
from scipy.optimize import brentq

from flexcli.mechanics.stopping.laws import HertzStop
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.numerics.signal_pieces import Piece

__all__ = ["HertzContact", "HertzPass"]

Floats = NDArray[np.float64]

RTOL = 1e-11
"""Local error per step of the eighth-order method, relative to the state at the touch."""
LEAST = 1e-8
"""Least u at the start, as a share of its size to come."""
_SAMPLES = 9
_NEWTON = 50


class HertzPass(NamedTuple):
    """What a pass through a contact did, to its end or to the end of a piece.

    ``samples`` are rows of time from the start, q and push; the integrals are those of a record.
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
        where u vanishes: ``du/dσ`` is the rate of approach, and δ needs no root.
        """
        blade, law, n = self._blade, self._law, q.size
        square, damper = blade.angular**2, np.diagonal(blade.damper)
        springs, dampers = square.tolist(), damper.tolist()
        base, at_stop = blade.base.tolist(), (self._side * blade.stop).tolist()
        hardness = 3.0 * self._compliance * law.stiffness
        modes = range(n)

        def slope(_: float, x: Floats) -> Floats:
            # numbers one by one: for a few modes much faster than arrays
            state = x.tolist()
            t, u = state[-2:]
            pace = u * (2.0 + hardness * u)
            a = piece(t)
            speed = sum(at_stop[i] * state[n + i] for i in modes)
            elastic = law.stiffness * u**3
            push = max(elastic * (1.0 + law.dissipation * speed), 0.0)
            found = [pace * v for v in state[n : 2 * n]]
            work = damped = 0.0
            for i in modes:
                v = state[n + i]
                force = base[i] * a + dampers[i] * v + springs[i] * state[i] + push * at_stop[i]
                found.append(-pace * force)
                work -= a * base[i] * v
                damped += dampers[i] * v * v
            found += [pace * work, pace * damped, pace * (push - elastic) * speed]
            found += [pace * a, pace * push]
            found += [pace * z for z in state[:n]]
            found += [pace, speed]
            return np.array(found)

        # unit modal masses: energy gives the scale of speeds, and the fastest mode that of q
        energy = 0.5 * float(rate @ rate + square @ q**2) or 1e-150
        speed_size, fastest = sqrt(2.0 * energy), float(blade.angular.max())
        deep = speed_size * float(np.abs(blade.stop).max()) / fastest
        size = np.concatenate(
            [
                np.full(n, speed_size / fastest),
                np.full(n, speed_size),
                (energy, energy, energy, np.inf, np.inf),
                np.full(n, np.inf),
                (1.0 / fastest, sqrt(deep)),
            ]
        )
        # from u = 0 at rest nothing would start; so small, δ is below rounding
        u = max(self._root_of_indentation(self.approach(q)), LEAST * sqrt(deep))
        start = np.concatenate([q, rate, np.zeros(5 + n), (0.0, u)])
        atol: Any = RTOL * size  # one for each, which the stubs don't know
        solver = DOP853(slope, 0.0, start, np.inf, rtol=RTOL, atol=atol)
        states = [start[:, None]]
        released = ended = False
        while not (released or ended) and solver.status == "running":
            solver.step()
            dense, begin, end = solver.dense_output(), float(solver.t_old or 0.0), float(solver.t)
            if solver.y[-1] <= 0.0:
                end, released = _zero_within(dense, -1, 0.0, begin, end), True
            if dense(end)[-2] >= piece.duration:
                end = _zero_within(dense, -2, piece.duration, begin, end)
                released, ended = False, True
            states.append(dense(np.linspace(begin, end, _SAMPLES)[1:]))
        x = np.concatenate(states, axis=1)
        final, t = x[:, -1], x[-2]
        speeds = np.array(at_stop) @ x[n : 2 * n]
        elastic = law.stiffness * np.maximum(x[-1], 0.0) ** 3
        work, lost_in_blade, lost, base_integral, impulse = final[2 * n : 2 * n + 5]
        return HertzPass(
            length=piece.duration if ended else float(t[-1]),
            released=released,
            q=final[:n],
            rate=final[n : 2 * n],
            work=float(work),
            damped=float(lost_in_blade),
            lost=float(lost),
            base_integral=float(base_integral),
            impulse=float(impulse),
            q_integral=final[2 * n + 5 : 3 * n + 5],
            evaluations=solver.nfev,
            times=t,
            motions=x[:n],
            pushes=np.maximum(elastic * (1.0 + law.dissipation * speeds), 0.0),
        )


def _zero_within(
    dense: Callable[[float], Floats], index: int, level: float, begin: float, end: float
) -> float:
    """Return where in a step one of its variables passes a level."""

    def over(s: float) -> float:
        return float(dense(s)[index]) - level

    if over(begin) * over(end) >= 0.0:
        return end if over(end) == 0.0 else begin
    return float(brentq(over, begin, end, xtol=1e-300, rtol=1e-14))
