"""Periodic motions of a blade between stops under a sine, by Newton's method on its period map."""

from dataclasses import dataclass, replace
from functools import cached_property
from math import exp, inf, pi

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import brentq

from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.mechanics.stopping.result import Peaks
from flexcli.mechanics.stopping.vibration import StoppedVibration
from flexcli.numerics.signal_pieces import sine

__all__ = ["DrivenBlade", "LinearMotion", "MotionPoint", "PeriodicMotion"]

Floats = NDArray[np.float64]

DIFFERENCE = 1e-6
"""Step of the central differences of the period map, over the speed that fits the gap: their
error is its square, and the map is good to some 1e-14."""
CLOSED = 1e-11
"""A motion that comes back to that share of the speed that fits the gap is periodic."""
NEUTRAL = 1e-7
"""A multiplier that near to 1 may be 1, where nothing is ever lost; at Q = 1e4 it is 3e-4 off."""
ITERATIONS = 15
HALVINGS = 4
WORTH = 0.2
"""Contraction of the residual below which the last derivative is still good enough."""
FREE = 0.5
"""Share of the gap within which a period should begin, so that it begins free of contact."""


@dataclass(frozen=True, eq=False)
class MotionPoint:
    """A modal state (q, q') at a phase [rad] of the base's sine."""

    q: Floats
    rate: Floats
    phase: float = 0.0


@dataclass(frozen=True, eq=False)
class LinearMotion:
    """The steady motion that meets no stop: amplitudes of tip [m], stop [m] and clamp [N·m]."""

    start: MotionPoint
    tip: float
    at_stop: float
    base_moment: float


@dataclass(frozen=True, eq=False)
class PeriodicMotion:
    """A motion that repeats after some periods of the base, with its Floquet multipliers.

    ``contacts`` are those of the whole motion, ``residual`` is how far it misses its start, as a
    share of the speed that fits the gap.
    """

    angular: float
    start: MotionPoint
    periods: int
    multipliers: NDArray[np.complex128]
    contacts: int
    residual: float

    @property
    def largest(self) -> float:
        """The largest Floquet multiplier's magnitude: disturbances die where it is below 1."""
        return float(np.abs(self.multipliers).max())

    @property
    def is_stable(self) -> bool:
        """Whether disturbances die, by more than the derivative of the map is unsure of."""
        return self.largest < 1.0 - NEUTRAL


@dataclass(frozen=True, eq=False)
class DrivenBlade:
    """A blade between stops whose base moves by a sine of some amplitude [m/s²]."""

    blade: ModalBlade
    stops: Stops
    amplitude: float

    @cached_property
    def gap(self) -> float:
        """The smaller gap [m]."""
        return min(self.stops.above, self.stops.below)

    @cached_property
    def speed(self) -> float:
        """Speed of a free first mode that swings as far as the gap [m/s·√kg]."""
        room = self.gap if self.gap < inf else 1.0
        reach = float(np.abs(self.blade.stop).max()) or 1.0
        return (room or self.stops.room) / reach * float(self.blade.angular[0])

    def linear(self, angular: float) -> LinearMotion:
        """Return the steady motion of the blade without stops.

        ``q_r = −b_r A sin(ωt)`` through ``1/(ω_r² − ω² + 2iζ_r ω_r ω)``: exact.
        """
        own, zeta = self.blade.angular, self.blade.damping
        gain = 1.0 / (own**2 - angular**2 + 2.0j * zeta * own * angular)
        complex_q = -self.blade.base * self.amplitude * gain  # of exp(iωt), its imaginary part
        return LinearMotion(
            start=MotionPoint(complex_q.imag, angular * complex_q.real),
            tip=abs(complex(self.blade.tip @ complex_q)),
            at_stop=abs(complex(self.blade.stop @ complex_q)),
            base_moment=abs(complex(self.blade.base_moment @ complex_q)),
        )

    def is_away(self, q: Floats) -> bool:
        """Return whether the blade is well away from each stop."""
        w = float(self.blade.stop @ q)
        return all(side * w <= FREE * self.stops.gap(side) for side in (1, -1))

    def is_free(self, angular: float) -> bool:
        """Return whether the linear motion meets no stop."""
        return self.linear(angular).at_stop < self.gap

    def grazing(self, one: float, other: float) -> float | None:
        """Return the frequency between two at which the linear motion just touches, if any."""

        def over(omega: float) -> float:
            return self.linear(omega).at_stop / self.gap - 1.0

        if over(one) * over(other) > 0.0:
            return None
        return float(brentq(over, one, other, xtol=1e-12 * other, rtol=1e-14))

    def steady(self, angular: float, phase: float) -> MotionPoint:
        """Return the linear motion's state at a phase of the base."""
        start = self.linear(angular).start
        turned = (start.rate / angular + 1j * start.q) * np.exp(1j * phase)
        return MotionPoint(turned.imag, angular * turned.real, phase)

    def dies_free(self, angular: float, point: MotionPoint) -> bool:
        """Return whether what is not steady yet dies without ever reaching a stop."""
        blade, linear = self.blade, self.linear(angular)
        steady = self.steady(angular, point.phase)
        q, rate = steady.q, steady.rate
        own, zeta = blade.angular, blade.damping
        damped = own * np.sqrt(np.maximum(1.0 - zeta**2, 1e-12))
        off = np.hypot(point.q - q, (point.rate - rate + zeta * own * (point.q - q)) / damped)
        return bool(linear.at_stop + np.abs(blade.stop) @ off < self.gap)

    def run(
        self, angular: float, start: MotionPoint, periods: float, *, keep_history: bool = False
    ) -> StoppedVibration:
        """Return the run of some periods from a point of the motion."""
        found = StoppedVibration(
            self.blade, self.stops, q=start.q, rate=start.rate, keep_history=keep_history
        )
        self.shake(found, angular, start.phase, periods)
        return found

    def shake(
        self, vibration: StoppedVibration, angular: float, phase: float, periods: float
    ) -> float:
        """Go on with a run for some periods from a phase of the base; return the phase after."""
        base = sine(
            amplitude=self.amplitude,
            angular=angular,
            duration=periods * 2.0 * pi / angular,
            phase=phase,
        )
        for _ in vibration.run(base):
            pass
        return (phase + 2.0 * pi * periods) % (2.0 * pi)

    def after(self, angular: float, start: MotionPoint, periods: float) -> MotionPoint:
        """Return where the motion is after some periods."""
        phase = (start.phase + 2.0 * pi * periods) % (2.0 * pi)
        return MotionPoint(*self.run(angular, start, periods).state, phase)

    def peaks(self, motion: PeriodicMotion) -> Peaks:
        """Return the greatest values of a periodic motion."""
        return self.run(motion.angular, motion.start, motion.periods).take_peaks()

    def periodic(
        self, angular: float, guess: MotionPoint, periods: int = 1
    ) -> PeriodicMotion | None:
        """Return the periodic motion near a point, stable or not, or nothing.

        Newton's method on ``P(x) − x``; P, the map over the periods, is exact between contacts,
        its derivative by central differences is that of contacts and flight alike.
        """
        x, phase = self.scaled(guess), guess.phase
        derivative = None
        mapped = self.mapped(angular, x, phase, periods)
        if mapped is None:
            return None
        missed = float(np.abs(mapped - x).max())
        before = inf
        for _ in range(ITERATIONS):
            if missed <= CLOSED:
                break
            if derivative is None or missed > WORTH * before:
                derivative = self._derivative(angular, x, phase, periods)
                if derivative is None:
                    return None
            before = missed
            step = np.linalg.lstsq(np.eye(x.size) - derivative, mapped - x, rcond=None)[0]
            for _ in range(HALVINGS):
                tried = self.mapped(angular, x + step, phase, periods)
                if tried is not None and np.abs(tried - x - step).max() < 2.0 * missed:
                    break
                step = step / 2.0
            else:
                return None
            x = x + step
            mapped, missed = tried, float(np.abs(tried - x).max())
        if missed > CLOSED:
            return None
        derivative = self._derivative(angular, x, phase, periods)
        if derivative is None:
            return None
        point = self.point(x, phase)
        return PeriodicMotion(
            angular=angular,
            start=point,
            periods=periods,
            multipliers=np.linalg.eigvals(derivative).astype(np.complex128),
            contacts=self.run(angular, point, periods).contact_count,
            residual=missed,
        )

    def begun_free(self, motion: PeriodicMotion) -> PeriodicMotion:
        """Return the same motion from where it is nearest to the middle of the gap."""
        if self.is_away(motion.start.q):
            return motion
        seen = self.run(
            motion.angular, motion.start, motion.periods, keep_history=True
        ).result().history  # fmt: skip
        assert seen is not None  # asked for
        time = float(seen.time[int(np.argmin(np.abs(seen.at_stop)))])
        if time <= 0.0:
            return motion
        turns = time * motion.angular / (2.0 * pi)
        return replace(motion, start=self.after(motion.angular, motion.start, turns))

    def scaled(self, point: MotionPoint) -> Floats:
        """Return (ω_r q_r, q_r') over the speed that fits the gap."""
        return np.concatenate([self.blade.angular * point.q, point.rate]) / self.speed

    def point(self, x: Floats, phase: float) -> MotionPoint:
        """Return the point that ``scaled`` gives, at a phase."""
        n = self.blade.angular.size
        return MotionPoint(x[:n] * self.speed / self.blade.angular, x[n:] * self.speed, phase)

    def mapped(self, angular: float, x: Floats, phase: float, periods: int) -> Floats | None:
        """Return where a period leads, nothing from inside a stop or where contacts never end."""
        if not np.isfinite(x).all():
            return None
        try:
            run = self.run(angular, self.point(x, phase), periods)
        except SolveError:
            return None
        if run.outcome is Outcome.CHATTER:
            return None
        return self.scaled(MotionPoint(*run.state))

    def slope(self, angular: float, start: MotionPoint, periods: int) -> Floats | None:
        """Return the derivative of the map over (x, ln ω), x scaled, shape (2n, 2n + 1)."""
        x, phase = self.scaled(start), start.phase
        over_x = self._derivative(angular, x, phase, periods)
        ahead, behind = (
            self.mapped(angular * exp(sign * DIFFERENCE), x, phase, periods) for sign in (1.0, -1.0)
        )
        if over_x is None or ahead is None or behind is None:
            return None
        return np.column_stack([over_x, (ahead - behind) / (2.0 * DIFFERENCE)])

    def _derivative(self, angular: float, x: Floats, phase: float, periods: int) -> Floats | None:
        """Return the derivative of the map over x, scaled, shape (2n, 2n)."""
        columns = []
        for direction in np.eye(x.size) * DIFFERENCE:
            ahead, behind = (
                self.mapped(angular, x + sign * direction, phase, periods) for sign in (1.0, -1.0)
            )
            if ahead is None or behind is None:
                return None
            columns.append((ahead - behind) / (2.0 * DIFFERENCE))
        return np.array(columns).T
