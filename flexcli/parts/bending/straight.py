"""Guided blades, stages on blades and cantilevers: the tip moves across the blade."""

from math import pi
from typing import ClassVar

from flexcli.formulas import necked_stage, stage_next_order, thick_blades
from flexcli.formulas.beam_column import s_bending
from flexcli.formulas.section import shear_parameter
from flexcli.numerics.rows import number
from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes, whole

__all__ = ["Necked", "Straight"]


class Straight(Bending):
    """A guided blade; a cantilever is half of one with twice its length (``halves`` 2).

    ``lever`` is l over the distance of the blades of a stage, which keep it from turning; single
    blades have none.
    """

    travel_most: ClassVar[float] = 0.5

    def __init__(
        self, *, h: float, l: float, travel: float, halves: int = 1, lever: float = 0.0
    ) -> None:
        self.h = h
        self.l = l
        self.travel = travel
        self.halves = halves
        self.lever = lever

    @property
    def ratio(self) -> float:
        """Return (x/l)²: odd orders vanish by symmetry."""
        return (self.travel / self.l) ** 2

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the changes by shear, in series with the bending, exactly at small stroke."""
        Phi = shear_parameter(depth=self.h, l=self.l, poisson_ratio=poisson_ratio)
        guided = Phi / self.halves**2
        value = thick_blades.stiffness_change(Phi=guided)
        shift = whole(thick_blades.shear_factor(guided) - 1.0)
        return {"stiffness": whole(value), "stress": whole(value), "shift": shift}

    def extension(self) -> Changes:
        """Return the change of the shift alone: nothing stretches the blades at rest."""
        if not self.travel:
            return {}
        value = thick_blades.stage_stretch(h=self.h, l=self.halves * self.l)
        slender = (self.h / self.l) ** 2
        return {
            "stress": whole(0.0, 2.0 * slender * self.ratio),
            "shift": whole(value, 4.0 * value**2 + slender * self.ratio),
        }

    def strain_law(self, poisson_ratio: float) -> float | None:
        """Return what the law of finite strain may change of the shift."""
        sizes = {"h": self.h, "l": self.halves * self.l}
        return number(thick_blades.stage_strain_law(**sizes, poisson_ratio=poisson_ratio))

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return no change: the blades are parallel, and the body moves along them."""
        return {}

    def rotation(self) -> Changes:
        """Return the next order in x/l of stress and shift; the one after it is the error."""
        if not self.travel:
            return {}
        stroke = {"l": self.l, "x": self.travel}
        error = 2.0 * self.ratio**2 + self._held_upright
        return {
            "stress": whole(stage_next_order.stress_change(**stroke), error),
            "shift": whole(stage_next_order.shift_change(**stroke), self._shifted_on),
        }

    @property
    def _held_upright(self) -> float:
        """Return what keeping a stage upright that moves towards its base adds to the stress.

        The force of the stroke moves down with it, by λ = 3 x²/(5 l): one blade is pulled, another
        pushed by n = 7.2 (x/l)³ times the lever, which stresses it by N/A and bends it n/60 more.
        """
        slope = abs(self.travel / self.l)
        return self.lever * self.ratio * (1.6 * self.h / self.l + 0.14 * slope)

    @property
    def _shifted_on(self) -> float:
        """Return the order after the next of the shift; the stage tilts as its blades are pulled.

        By some (x/l)⁵ times the lever squared, which bends them further.
        """
        return (0.5 + 0.02 * self.lever**2) * self.ratio**2

    def tension(self) -> Changes:
        """Return no change: the drive's force is across the blade at its largest stress."""
        return {}

    def load(self, n: float) -> Changes:
        """Return the change of the moment by an axial force: compression relieves it."""
        guided = n * self.halves**2
        if not guided < pi**2:  # pushed, it buckles
            return {"stress": UNKNOWN}
        value = number(s_bending(guided)) - 1.0
        # the force moves with the stage, which the blades hold upright
        error = n * (0.5 * self.ratio + self.lever * self.h / self.l / 6.0)
        return {"stress": Change(value, value, value * self.ratio + error)}

    def pulled(self, n: float) -> Changes:
        """Return no change: parallel blades move their body along them."""
        return {}

    def amplified(self, n: float) -> Changes:
        """Return no change up to half the buckling load: the blades are not bent by then."""
        return {} if n * self.halves**2 < pi**2 / 2.0 else {"stress": UNKNOWN}


class Necked(Straight):
    """Blades that bend at both ends alone, over the share ξ of their length."""

    travel_most: ClassVar[float] = 0.35

    def __init__(self, *, h: float, l: float, travel: float, xi: float, lever: float) -> None:
        super().__init__(h=h, l=l, travel=travel, lever=lever)
        self.xi = xi

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the changes by shear of the hinges, exactly at small stroke."""
        Phi = shear_parameter(depth=self.h, l=self.l, poisson_ratio=poisson_ratio)
        own = necked_stage.shear_parameter(Phi=Phi, xi=self.xi)
        value = whole(thick_blades.stiffness_change(Phi=own))
        shift = whole(necked_stage.shear_in_shift(Phi=own, xi=self.xi))
        return {"stiffness": value, "stress": value, "shift": shift}

    def extension(self) -> Changes:
        """Return the change of the shift alone: nothing stretches the hinges at rest."""
        if not self.travel:
            return {}
        value = necked_stage.stretch_in_shift(h=self.h, l=self.l, xi=self.xi)
        slender = (self.h / self.l) ** 2 / self.xi
        return {
            "stress": whole(0.0, 2.0 * slender * self.ratio),
            "shift": whole(value, 4.0 * value**2 + slender * self.ratio),
        }

    def strain_law(self, poisson_ratio: float) -> None:
        """Return nothing: it has not been derived."""

    def rotation(self) -> Changes:
        """Return the next order in x/l of stress and shift; the one after it is the error."""
        if not self.travel:
            return {}
        stroke = {"l": self.l, "x": self.travel, "xi": self.xi}
        error = 2.0 * self.ratio**2 + self._held_upright
        return {
            "stress": whole(stage_next_order.stress_change(**stroke), error),
            "shift": whole(stage_next_order.shift_change(**stroke), self._shifted_on),
        }

    def load(self, n: float) -> Changes:
        """Return an unknown change: it has not been derived."""
        return {"stress": UNKNOWN} if n else {}
