"""Guided blades, leaf-spring stages and cantilevers: the tip moves across the blade."""

from math import inf, pi

from flexcli.formulas import blade_shear, stage_next_order, thick_shift
from flexcli.formulas.beam_column import s_bending
from flexcli.parts.bending.base import Bending, Changes, whole

__all__ = ["Straight"]


class Straight(Bending):
    """A guided blade; a cantilever is half of one with twice its length (``halves`` 2)."""

    def __init__(self, *, h: float, l: float, travel: float, halves: int) -> None:
        self.h = h
        self.l = l
        self.travel = travel
        self.halves = halves

    @property
    def ratio(self) -> float:
        """Return (x/l)²: odd orders vanish by symmetry."""
        return (self.travel / self.l) ** 2

    def shear(self, Phi: float) -> Changes:
        """Return what Φ in series with the bending changes, exactly at small stroke."""
        guided = Phi / self.halves**2
        change = whole(blade_shear.stiffness_change(Phi=guided))
        shift = whole(thick_shift.shear_factor(guided) - 1.0)
        return {"stiffness": change, "stress": change, "shift": shift}

    def extension(self) -> Changes:
        """Return the change of the shift alone: nothing stretches the blades at rest."""
        change = thick_shift.stage_stretch(h=self.h, l=self.halves * self.l)
        return {"shift": whole(change)} if self.travel else {}

    def stretched(self, n: float) -> Changes:
        """Return nothing: the blades are parallel, and the body moves along them."""
        return {}

    def rotation(self) -> Changes:
        """Return the next order in x/l of stress and shift."""
        if not self.travel:
            return {}
        stroke = {"l": self.l, "x": self.travel}
        return {
            "stress": whole(stage_next_order.stress_change(**stroke)),
            "shift": whole(stage_next_order.shift_change(**stroke)),
        }

    def tension(self) -> Changes:
        """Return nothing: the force of the stroke is across the blade where its stress is worst."""
        return {}

    def load(self, n: float) -> Changes:
        """Return how an axial force of either sign changes the moment at a given stroke."""
        guided = n * self.halves**2
        if guided >= pi**2:  # it buckles
            return {"stress": whole(inf)}
        most = max(abs(float(s_bending(sign * guided)) - 1.0) for sign in (1.0, -1.0))
        return {"stress": whole(most)}
