"""Pivots of two crossing blades, or of pairs of them: a body that turns about their centre."""

from math import inf, pi
from typing import ClassVar

from flexcli.formulas import pivot, pivot_next_order, thick_blades
from flexcli.formulas.beam_column import s_bending, uniform_bending
from flexcli.formulas.section import shear_parameter
from flexcli.numerics.rows import larger, number, tan
from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes, whole

__all__ = ["Pair", "under_tension"]


class Pair(Bending):
    """Blades at ± a half-angle, the inner ends p from the centre, turned by θ."""

    travel_most: ClassVar[float] = 0.35

    def __init__(self, *, h: float, l: float, p: float, theta: float, half_angle: float) -> None:
        self.h = h
        self.l = l
        self.theta = theta
        self.blade = {"l": l, "p": p, "half_angle": half_angle}
        self.gamma = 1.0 + 2.0 * p / l
        self.stretch = (h / (l * tan(half_angle))) ** 2
        self.straightens = h / l / tan(half_angle)
        self.widens = (h / l * tan(half_angle)) ** 2  # what blades relieve the centre's shift by
        self.leading = (5.0 - 9.0 * self.gamma**2) / 60.0  # of the shift over l θ²/cos α
        self.most = 1.0 + 3.0 * abs(self.gamma)

    @property
    def ratio(self) -> float:
        """Return θ, or the ratio of the stress's next order to its first where that is larger."""
        turn = {**self.blade, "theta": self.theta}
        return larger(abs(self.theta), number(pivot_next_order.stress_bound(**turn)))

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the changes by shear in the S-shaped bending, exactly at small rotation."""
        Phi = shear_parameter(depth=self.h, l=self.blade["l"], poisson_ratio=poisson_ratio)
        found = self._softer(Phi)
        if self.theta:
            along = whole(self.sheared_along(poisson_ratio))
            less = Phi / (1.0 + Phi) * self._across**2  # what stretching shifts across shears away
            found["shift"] = Change(along.value, along.bound + less, less)
        return found

    def extension(self) -> Changes:
        """Return the changes by stretching: it softens like shear, and shifts the centre across."""
        # what shear and stretching soften together, each alone told as if without the other
        together = 3.6 * (self.h / self.blade["l"]) ** 2 * self.stretch
        found = self._softer(self.stretch, together)
        if self.theta:
            shift = self.shifted(self.stretched_along, self._across)
            found["shift"] = shift._replace(error=shift.error + 2.0 * self.widens**2)
            stress, turned = found["stress"], 2.0 * self.widens * self.rotation()["stress"].bound
            found["stress"] = stress._replace(error=stress.error + turned)
        return found

    def strain_law(self, poisson_ratio: float) -> float:
        """Return what the law of finite strain may change of the shift, along the bisector."""
        sizes = {"h": self.h, "l": self.blade["l"], "p": self.blade["p"]}
        law = thick_blades.pivot_strain_law(**sizes, poisson_ratio=poisson_ratio)
        across = self.extension()["shift"].value if self.theta else None
        whole_of_it = 1.0 if across is None else 1.0 + larger(across, 0.0)
        return abs(self._of_leading(number(law))) / whole_of_it

    def sheared_along(self, poisson_ratio: float) -> float:
        """Return the relative change of the shift along the bisector by shear."""
        Phi = shear_parameter(depth=self.h, l=self.blade["l"], poisson_ratio=poisson_ratio)
        curved = 3.0 * self.gamma**2 / 20.0
        return self._of_leading(-curved * number(thick_blades.shear_factor(Phi) - 1.0))

    @property
    def stretched_along(self) -> float:
        """Return the relative change of the shift along the bisector by stretching."""
        return self._of_leading(number(thick_blades.pivot_stretch(h=self.h, **self.blade)))

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return up to 6ε tan α/(θ(1 + 3|γ|)), ε = n(h/l)²/12, of a force along the bisector.

        It adds in one blade and subtracts in the other, which need not be the most stressed: the
        middle between zero and the full change is taken.
        """
        if not self.theta or not n:
            return {}
        if direction != 0.0:
            return {"stress": UNKNOWN}
        strain = n * (self.h / self.blade["l"]) ** 2 / 12.0
        share = 6.0 * strain * tan(self.blade["half_angle"]) / (abs(self.theta) * self.most)
        return {"stress": Change(share / 2.0, share, 0.75 * share)}

    def pulled(self, n: float) -> Changes:
        """Return up to 3 (h/l) larger(tan α, cot α): the stretching of one blade bends the other.

        A body that moves by ε l along one blade moves up to ε l larger(tan α, cot α) across the
        other, which bends it in an S by 3 (h/l) times E ε.
        """
        return {"stress": Change(0.0, self._bent, self._bent, 1)}

    def amplified(self, n: float) -> Changes:
        """Return the amplification of that bending by the force: up to 1/(1 − n/n_cr).

        n_cr ≥ 8 for any such pivot, whatever holds it; 2 is taken, and the change is unknown beyond
        half of it.
        """
        if not n < 1.0:
            return {"stress": UNKNOWN}
        more = self._bent * n / (2.0 - n)
        return {"stress": Change(0.0, more, more)}

    @property
    def _bent(self) -> float:
        tangent = tan(self.blade["half_angle"])
        return 3.0 * self.h / self.blade["l"] * larger(tangent, 1.0 / tangent)

    def rotation(self) -> Changes:
        """Return the next order in θ of stress and shift."""
        if not self.theta:
            return {}
        turn = {**self.blade, "theta": self.theta}
        stress = number(pivot_next_order.stress_change(**turn))
        bound = number(pivot_next_order.stress_bound(**turn))
        first = number(pivot.parasitic_shift(**turn))
        if first == 0.0:
            shift = Change(None, inf)
        else:
            along = pivot_next_order.shift_parts(**turn)
            across = number(pivot_next_order.shift_across(**turn)) / first
            bends = number(along.bound) / abs(first)
            shift = self.shifted(number(along.total) / first, across, bends)
            shift = shift._replace(error=shift.error + 1.2 * shift.bound**2)
        # the next order, in exact solutions: at most 1.3 of the square of this one's size
        error = 1.6 * bound**2 + abs(self.theta) * bound
        return {"stress": Change(stress, larger(bound, abs(stress)), error), "shift": shift}

    def tension(self) -> Changes:
        """Return σ = N/(h b) of N = 6γθ cot α EI/l² over the bending: γ cot α (h/l)/(1 + 3|γ|)."""
        share = abs(self.gamma) * self.straightens / self.most
        tangent = tan(self.blade["half_angle"])
        # the force itself changes with the rotation
        error = 2.0 * share * abs(self.theta) * (tangent + 1.0 / tangent)
        return {"stress": whole(share, error)} if self.theta else {}

    def load(self, n: float) -> Changes:
        """Return the largest change of a blade's end moments by an axial force of either sign.

        The change where the stress is largest lies between that and zero.
        """
        most = under_tension(n, self.gamma)
        if not most < inf:
            return {"stress": UNKNOWN}
        return {"stress": Change(most / 2.0, most, 0.75 * most)}

    def _softer(self, Phi: float, error: float = 0.0) -> dict[str, Change]:
        """Return the changes where the S-shaped part is divided by 1 + Φ.

        The axial forces, by which the stress grows at large rotation, are divided likewise.
        """
        soft, gamma = Phi / (1.0 + Phi), abs(self.gamma)
        bends = 3.0 * gamma**2
        found = {"stiffness": whole(-bends / (1.0 + bends) * soft, error)}
        if self.theta:
            value = -3.0 * gamma / self.most * soft
            turned = soft * self.rotation()["stress"].bound
            found["stress"] = Change(value, abs(value) + turned, turned + error)
        return found

    @property
    def _across(self) -> float:
        """Return the shift across that stretching causes over the shift along; Φ = 0 for ν = −1."""
        turn = {**self.blade, "theta": self.theta}
        first = abs(number(pivot.parasitic_shift(**turn)))
        across = abs(number(thick_blades.pivot_shift_across(h=self.h, poisson_ratio=-1.0, **turn)))
        return across / first if first else inf

    def _of_leading(self, bracket: float) -> float:
        return bracket / self.leading if self.leading else inf

    @staticmethod
    def shifted(along: float, across: float, bound: float | None = None) -> Change:
        """Return the change of the shift's length by motions along and across it, as shares.

        Those across add as squares; their product with another effect's may be twice as large and
        is unknown here, so it counts as an error.
        """
        if not across < inf:
            return Change(None, inf)
        value = ((1.0 + along) ** 2 + across**2) ** 0.5 - 1.0
        size = abs(along) if bound is None else bound
        return Change(value, size + across**2, across**2 / 2.0)


def under_tension(n: float, gamma: float) -> float:
    """Return the largest change by axial forces ±n EI/l² of the end moments of a turned blade."""
    if n >= pi**2:  # compression buckles a guided blade
        return inf
    most = 1.0 + 3.0 * abs(gamma)
    moments = (
        number(uniform_bending(sign * n)) + 3.0 * abs(gamma) * number(s_bending(sign * n))
        for sign in (1.0, -1.0)
    )
    return larger(abs(moment / most - 1.0) for moment in moments)
