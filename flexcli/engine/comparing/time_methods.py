"""A stopped blade in time by several methods: event by event, or a general integrator.

The general integrator sees each stop as a penalty: a force of approach and speed, and no events.
"""

from collections.abc import Callable, Iterable, Iterator
from itertools import chain, pairwise
from math import inf, isnan, nan
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray
from scipy.integrate import solve_ivp
from scipy.optimize import minimize_scalar

from flexcli.engine.comparing.penalty_law import penalty_law
from flexcli.engine.comparing.time_motions import StoppedMotion
from flexcli.mechanics.stopping.vibration import simulate
from flexcli.numerics.signal_pieces import Piece

__all__ = ["Method", "TimePeaks", "event_driven", "penalty_run", "stretches"]

Floats = NDArray[np.float64]
Method: TypeAlias = Literal["Radau", "DOP853"]

PER_STEP = 8
"""Places in a step of the integrator among which the greatest values are sought."""
SAME = 1e-9
"""Two signals whose terms differ by that share are one."""


class TimePeaks(NamedTuple):
    """What a run is asked for: peaks of tip [m] and stop [N], start of the last contact [s]."""

    tip: float
    force: float
    last_contact: float


def event_driven(motion: StoppedMotion) -> tuple[TimePeaks, float]:
    """Return what the event-driven run gives, and its energy residual as a share of what moved."""
    found = simulate(motion.blade, motion.stops, motion.pieces, rate=motion.rate)
    times = found.contacts.time
    last = float(times[-1]) if times.size else nan
    return TimePeaks(found.peaks.travel, found.peaks.force, last), found.balance.energy_error


def stretches(pieces: Iterable[Piece]) -> list[Piece]:
    """Return pieces with those joined that go on as the one before: the integrator runs through."""
    joined: list[Piece] = []
    for piece in pieces:
        if joined and _goes_on(joined[-1], piece):
            joined[-1] = joined[-1]._replace(duration=joined[-1].duration + piece.duration)
        else:
            joined.append(piece)
    return joined


def _goes_on(last: Piece, piece: Piece) -> bool:
    ahead = last.after(last.duration).terms
    return len(ahead) == len(piece.terms) and all(
        one == other and len(p) == len(q) and np.allclose(p, q, rtol=SAME, atol=0.0)
        for (one, p), (other, q) in zip(ahead, piece.terms, strict=True)
    )


def penalty_run(motion: StoppedMotion, method: Method, tolerance: float) -> TimePeaks:
    """Return what a general integrator gives that knows the forces and no events.

    Tolerance relative, and absolute as a share of the gap and of the speed that the first mode
    has there. The greatest values are those of its dense output, sought between steps too. Not a
    number where the integrator gives up.
    """
    blade, n = motion.blade, motion.blade.angular.size
    run = _Penalty(motion)
    gap = min(motion.stops.above, motion.stops.below)
    q_size = gap / float(np.linalg.norm(blade.stop))
    size = np.repeat([q_size, q_size * float(blade.angular[0])], n)
    state, begun = np.concatenate([np.zeros(n), motion.rate]), 0.0
    tip = force = 0.0
    last = nan
    for piece in stretches(motion.pieces):
        found: Any = solve_ivp(
            run.slope(piece), (0.0, piece.duration), state, method,
            rtol=tolerance, atol=tolerance * size, dense_output=True, events=run.touches,
        )  # fmt: skip
        if not found.success:
            return TimePeaks(nan, nan, nan)
        times = np.concatenate(
            [np.linspace(a, b, PER_STEP, endpoint=False) for a, b in pairwise(found.t)]
            + [found.t[-1:]]
        )
        motions = found.sol(times).T
        pushes = [run.signed_push(x) for x in motions]
        tips = [run.tip(x, p) for x, p in zip(motions, pushes, strict=True)]

        def tip_at(t: float, sol: Any = found.sol) -> float:
            x = sol(t)
            return abs(run.tip(x, run.signed_push(x)))

        def push_at(t: float, sol: Any = found.sol) -> float:
            return abs(run.signed_push(sol(t)))

        tip = max(tip, _greatest(tip_at, times, np.abs(tips)))
        force = max(force, _greatest(push_at, times, np.abs(pushes)))
        touched = max(chain.from_iterable(found.t_events), default=nan)
        last = last if isnan(touched) else float(begun + touched)
        state, begun = found.y[:, -1], begun + piece.duration
    return TimePeaks(tip, force, last)


def _greatest(function: Callable[[float], float], times: Floats, values: Floats) -> float:
    """Return the greatest value, refined beside the greatest of the samples."""
    i = int(np.argmax(values))
    begin, end = float(times[max(i - 1, 0)]), float(times[min(i + 1, times.size - 1)])
    best: Any = minimize_scalar(
        lambda t: -function(t),
        bounds=(begin, end),
        method="bounded",
        options={"xatol": 1e-6 * (end - begin)},
    )
    return max(float(values[i]), -float(best.fun))


class _Penalty:
    """The equations of motion of modes (q, q') between stops that are forces."""

    def __init__(self, motion: StoppedMotion) -> None:
        blade = motion.blade
        self._n = blade.angular.size
        self._blade, self._push = blade, penalty_law(blade, motion.stops.law)
        self._square, self._damper = blade.angular**2, np.diagonal(blade.damper)
        self._gaps = {side: g for side in (1, -1) if (g := motion.stops.gap(side)) < inf}
        self.touches = list(self._touches())

    def _touches(self) -> Iterator[Callable[[float, Floats], float]]:
        """Yield what rises through zero when the blade meets a stop."""
        for side, gap in self._gaps.items():

            def approach(_: float, x: Floats, side: int = side, gap: float = gap) -> float:
                return side * float(self._blade.stop @ x[: self._n]) - gap

            # solve_ivp reads it from the function itself
            approach.direction = 1.0  # type: ignore[attr-defined]
            yield approach

    def signed_push(self, x: Floats) -> float:
        """Return the push of the stop in touch, times its side."""
        w = float(self._blade.stop @ x[: self._n])
        for side, gap in self._gaps.items():
            approach = side * w - gap
            if approach > 0.0:
                speed = side * float(self._blade.stop @ x[self._n :])
                return side * self._push(approach, speed)
        return 0.0

    def tip(self, x: Floats, push: float) -> float:
        """Return the deflection of the tip, with what the left-out modes do there."""
        return float(self._blade.tip @ x[: self._n]) - self._blade.tip_residual * push

    def slope(self, piece: Piece) -> Callable[[float, Floats], Floats]:
        """Return the right-hand side under a piece of the base's acceleration."""
        blade, n = self._blade, self._n

        def slope(t: float, x: Floats) -> Floats:
            q, rate = x[:n], x[n:]
            force = -blade.base * piece(t) - self._damper * rate - self._square * q
            return np.concatenate([rate, force - self.signed_push(x) * blade.stop])

        return slope
