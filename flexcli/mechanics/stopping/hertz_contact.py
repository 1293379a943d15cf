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

RTOL = 1e-12
"""Local error per step of the eighth-order method, relative to the state at the touch."""
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

    def _forces(self, q: Floats, rate: Floats) -> tuple[float, float, float]:
        """Return elastic push, push, and rate of approach."""
        elastic = self._law.stiffness * self._root_of_indentation(self.approach(q)) ** 3
        speed = self._side * float(self._blade.stop @ rate)
        return elastic, max(elastic * (1.0 + self._law.dissipation * speed), 0.0), speed

    def pass_through(self, q: Floats, rate: Floats, piece: Piece) -> HertzPass:
        """Integrate from a state in touch to release, or to the end of a piece."""
        blade, n = self._blade, q.size
        square, damper = blade.angular**2, np.diagonal(blade.damper)

        def slope(t: float, x: Floats) -> Floats:
            q, v = x[:n], x[n : 2 * n]
            a = piece(t)
            elastic, push, speed = self._forces(q, v)
            force = -blade.base * a - damper * v - square * q - self._side * push * blade.stop
            sums = (
                -a * float(blade.base @ v),
                float(damper @ v**2),
                (push - elastic) * speed,
                a,
                push,
            )
            return np.concatenate([v, force, sums, q])

        # unit modal masses: energy gives the scale of speeds, and the fastest mode that of q
        energy = 0.5 * float(rate @ rate + square @ q**2) or 1e-150
        speed_size = sqrt(2.0 * energy)
        size = np.concatenate(
            [
                np.full(n, speed_size / float(blade.angular.max())),
                np.full(n, speed_size),
                (energy, energy, energy, np.inf, np.inf),
                np.full(n, np.inf),
            ]
        )
        start = np.concatenate([q, rate, np.zeros(5 + n)])
        atol: Any = RTOL * size  # one for each, which the stubs don't know
        solver = DOP853(slope, 0.0, start, piece.duration, rtol=RTOL, atol=atol)
        times, states = [np.zeros(1)], [start[:, None]]
        released = False
        while solver.status == "running":
            solver.step()
            dense = solver.dense_output()
            end = float(solver.t)
            if self.approach(solver.y[:n]) <= 0.0:
                end = self._release(dense, float(solver.t_old or 0.0), end, n)
                released = True
            grid = np.linspace(float(solver.t_old or 0.0), end, _SAMPLES)[1:]
            times.append(grid)
            states.append(dense(grid))
            if released:
                break
        t, x = np.concatenate(times), np.concatenate(states, axis=1)
        final = x[:, -1]
        pushes = np.array([self._forces(s[:n], s[n : 2 * n])[1] for s in x.T])
        work, damped, lost, base_integral, impulse = final[2 * n : 2 * n + 5]
        return HertzPass(
            length=float(t[-1]),
            released=released,
            q=final[:n],
            rate=final[n : 2 * n],
            work=float(work),
            damped=float(damped),
            lost=float(lost),
            base_integral=float(base_integral),
            impulse=float(impulse),
            q_integral=final[2 * n + 5 :],
            evaluations=solver.nfev,
            times=t,
            motions=x[:n],
            pushes=pushes,
        )

    def _release(self, dense: Callable[[float], Floats], begin: float, end: float, n: int) -> float:
        """Return when the approach vanishes in a step; a touch of no length ends at once."""

        def approach(t: float) -> float:
            return self.approach(dense(t)[:n])

        grid = np.linspace(begin, end, 2 * _SAMPLES)[:-1]
        inside = [float(t) for t in grid if approach(t) > 0.0]
        if not inside:
            return begin
        return float(brentq(approach, inside[-1], end, xtol=1e-300, rtol=1e-14))
