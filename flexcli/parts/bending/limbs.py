"""Stages and pivots of rigid limbs between notch hinges."""

from typing import ClassVar, NamedTuple

from flexcli.formulas import hinged_next_order
from flexcli.numerics.rows import number, tan
from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes, whole

__all__ = ["Hinge", "LimbPivot", "LimbStage"]


class Hinge(NamedTuple):
    """A limb's hinges, dimensions in lengths of the limb l."""

    reach: float
    """Reach c of the bending about the centre, without shear."""
    sheared: float
    """Square of the reach c by shear alone, without its factor of 1 + ν: C_shear/C_φ at ν = 0."""
    stretch: float
    """Square root of the compliance along a hinge over that of its rotation, √(C_along/C_φ)."""
    spread: float
    """∫f(1 − f) ds, f the share of a hinge's rotation up to s."""
    throat: float
    """Thickness of the throat."""
    peak: float
    """Distance from the throat of the greatest stress: e r/l², twice its relative increase."""


class _Limbs(Bending):
    travel_most: ClassVar[float] = 0.35

    def __init__(self, *, hinge: Hinge, travel: float) -> None:
        self.hinge = hinge
        self.travel = travel

    @property
    def hinge_reach(self) -> float:
        """Return c/l."""
        return self.hinge.reach

    def _across(self, poisson_ratio: float | None) -> float:
        """Return 1 + 4c²/l², c with the shear of a hinge at a Poisson's ratio."""
        square = self.hinge.reach**2
        if poisson_ratio is not None:
            square += self.hinge.sheared**2 * (1.0 + poisson_ratio)
        return 1.0 + 4.0 * square

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return an unknown change: it has not been derived."""
        return {"stress": UNKNOWN} if n else {}

    def load(self, n: float) -> Changes:
        """Return an unknown change: it has not been derived."""
        return {"stress": UNKNOWN} if n else {}

    @property
    def _spread(self) -> float:
        """Return the terms of higher order in the reach of the hinges along the limb."""
        return 4.0 * self.hinge.reach**2 + self.hinge.spread**2


class LimbStage(_Limbs):
    """Parallel limbs: a parallelogram, moved by x = ``travel`` l."""

    @property
    def ratio(self) -> float:
        """Return (x/l)²: odd orders vanish by symmetry."""
        return self.travel**2

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the shear of the hinges, exactly at small stroke."""
        change = whole(self._across(None) / self._across(poisson_ratio) - 1.0)
        error = change.bound
        return {
            "stiffness": change,
            "stress": change,
            "shift": Change(0.0, change.bound, 2.0 * error),
        }

    def extension(self) -> Changes:
        """Return no change at rest; the limbs shorten by no more than their hinges."""
        return {"shift": Change(0.0, 0.0, 2.0 * self.hinge.stretch**2)} if self.travel else {}

    def rotation(self) -> Changes:
        """Return the exact motion of a parallelogram; the length of the hinges is in its error."""
        if not self.travel:
            return {}
        stroke = {"l": 1.0, "x": self.travel}
        reach = self.hinge.reach
        stress = number(hinged_next_order.stage_turn_change(**stroke))
        shift = number(hinged_next_order.stage_shift_change(**stroke))
        return {
            "stress": whole(stress, 2.0 * reach * self.ratio),
            "shift": whole(shift, 2.0 * reach * self.ratio),
        }

    def tension(self) -> Changes:
        """Return no change: the force of the stroke is across the limbs."""
        return {}

    def hinge_length(self) -> Changes:
        """Return the shortening of limbs on hinges of finite length, and the peak stress."""
        if not self.travel:
            return {}
        return {
            "stress": Change(self.hinge.peak / 2.0, self.hinge.peak / 2.0, self.hinge.peak / 2.0),
            "shift": whole(-2.0 * self.hinge.spread, 4.0 * self._spread),
        }


class LimbPivot(_Limbs):
    """Two limbs at ± a half-angle, turned by θ about the point that they aim at."""

    def __init__(self, *, hinge: Hinge, delta: float, theta: float, half_angle: float) -> None:
        super().__init__(hinge=hinge, travel=theta)
        self.gamma = 1.0 + 2.0 * delta
        self.half_angle = half_angle
        self.turn = {"l": 1.0, "p": delta, "theta": theta, "half_angle": half_angle}

    @property
    def ratio(self) -> float:
        """Return θ."""
        return abs(self.travel)

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the shear of the hinges, exactly at small rotation."""
        softer = self._across(poisson_ratio) / self._across(None)
        return self._softer(softer)

    def extension(self) -> Changes:
        """Return the stretching of the hinges, exactly at small rotation."""
        kappa = 4.0 * self.hinge.stretch**2 / self._across(None) / tan(self.half_angle) ** 2
        # what shear and stretching soften together, each told as if without the other
        return self._softer(1.0 + kappa, 6.0 * self.hinge.sheared**2 * kappa)

    def rotation(self) -> Changes:
        """Return the next order in θ of stress and shift, of pins with springs."""
        if not self.travel:
            return {}
        stress = number(hinged_next_order.pivot_turn_change(**self.turn))
        shift = number(hinged_next_order.pivot_shift_change(**self.turn))
        reach, theta = self.hinge.reach, abs(self.travel)
        slope = abs(self.gamma) / tan(self.half_angle) + tan(self.half_angle) * abs(
            self.gamma**2 - 1.0
        )
        if theta * slope > 1.0:
            return {"stress": UNKNOWN, "shift": UNKNOWN}
        rough = reach * theta * (slope + 1.0)
        return {
            "stress": whole(stress, rough + 3.0 * stress**2 + theta**2 * abs(stress)),
            "shift": whole(shift, rough + shift**2),
        }

    def tension(self) -> Changes:
        """Return the axial stress of the throats: N = f cot α over the moment that f makes."""
        if not self.travel:
            return {}
        force = 2.0 * abs(self.gamma) / self._across(None)  # f l/(K θ/2)
        moment = 1.0 + force / 2.0
        return {"stress": whole(force / tan(self.half_angle) * self.hinge.throat / 6.0 / moment)}

    def hinge_length(self) -> Changes:
        """Return the reduced S-shaped bending by hinges of finite length, and its peak stress."""
        if not self.travel:
            return {}
        gamma, across = abs(self.gamma), self._across(None)
        value = (1.0 + gamma / across) / (1.0 + gamma) - 1.0
        return {
            "stress": Change(value, abs(value), 2.0 * self.hinge.peak),
            "shift": UNKNOWN,
        }

    def _softer(self, softer: float, error: float = 0.0) -> Changes:
        """Return the changes where the S-shaped part is divided by a factor."""
        gamma, across = abs(self.gamma), self._across(None)
        bends, lever = gamma**2 / across, gamma / across
        less = 1.0 / softer - 1.0
        found = {"stiffness": whole(bends / (1.0 + bends) * less, error)}
        if self.travel:
            found["stress"] = whole(lever / (1.0 + lever) * less, error)
            found["shift"] = UNKNOWN
        return found
