"""Crossed blades that are joined where they cross: two pivots of p = 0, one after the other."""

from collections.abc import Callable
from typing import ClassVar

from flexcli.formulas import pivot, pivot_next_order, thick_blades, unseparated_next_order
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.bending.base import UNKNOWN, Bending, Change, Changes, whole
from flexcli.parts.bending.pair import Pair

__all__ = ["Joined"]


class Joined(Bending):
    """Two pairs of blades in series, c l on the side of the base and (1 − c) l on the other."""

    travel_most: ClassVar[float] = 0.35

    def __init__(
        self, *, h: float, l: float, crossing: float, theta: float, half_angle: float
    ) -> None:
        self.shares = crossing, 1.0 - crossing
        self.theta = theta
        self.turn = {"crossing": crossing, "theta": theta, "half_angle": half_angle}
        self.h, self.l = h, l
        self.parts: tuple[Pair, ...] = tuple(
            Pair(h=h, l=share * l, p=p, theta=share * theta, half_angle=half_angle)
            for share, p in zip(self.shares, (-crossing * l, 0.0), strict=True)
        )
        self.leading = tuple(
            number(pivot.parasitic_shift(theta=part.theta, **part.blade)) for part in self.parts
        )

    @property
    def ratio(self) -> float:
        """Return the larger of both parts."""
        return larger(part.ratio for part in self.parts)

    def shear(self, poisson_ratio: float) -> Changes:
        """Return the changes by shear of both parts, which share the moment, not the rotation."""
        found = self._in_series(
            lambda part: part.shear(poisson_ratio),
            lambda part: part.sheared_along(poisson_ratio),
        )
        if "shift" not in found:
            return found
        # what stretching shifts across shears away
        soft = 2.4 * (1.0 + poisson_ratio) * (self.h / self.l / smaller(self.shares)) ** 2
        first, across = sum(self.leading), self._across
        lost = abs(self.parts[0].theta * across[1]) / first + (sum(across) / first) ** 2
        shift = found["shift"]
        return {**found, "shift": shift._replace(error=shift.error + soft * lost)}

    def extension(self) -> Changes:
        """Return the changes by stretching; the far part shifts across the turned cross."""
        across = self._across
        coupled = self.parts[0].theta * across[1]
        found = self._in_series(
            lambda part: part.extension(), lambda part: part.stretched_along, coupled, sum(across)
        )
        if "shift" not in found:
            return found
        shift, widens = found["shift"], larger(part.widens for part in self.parts)
        return {**found, "shift": shift._replace(error=shift.error + 2.0 * widens**2)}

    @property
    def _across(self) -> list[float]:
        """Return the shift of each part's centre across the bisector by stretching [m]."""
        return [
            number(
                thick_blades.pivot_shift_across(
                    h=self.h, theta=part.theta, poisson_ratio=-1.0, **part.blade
                )
            )
            for part in self.parts
        ]

    def stretched(self, n: float, direction: float | None) -> Changes:
        """Return an unknown change, not derived: the cross between the parts is free."""
        return {"stress": UNKNOWN} if n else {}

    def rotation(self) -> Changes:
        """Return the next order in θ of stress and shift."""
        if not self.theta:
            return {}
        stress = [found.value or 0.0 for found in self._rotated]
        size = larger(found.bound for found in self._rotated)
        first = sum(self.leading)
        along = number(unseparated_next_order.next_shift(l=self.l, **self.turn)) / first
        across = sum(
            number(pivot_next_order.shift_across(theta=part.theta, **part.blade))
            for part in self.parts
        )
        across -= self.parts[0].theta * self.leading[1]  # the far part shifts along a turned axis
        shift = Pair.shifted(along, across / first)
        size_of_shift = larger(
            shift.bound, *(part.rotation()["shift"].bound for part in self.parts)
        )
        error = shift.error + 1.2 * size_of_shift**2 + self.theta**2 * size_of_shift
        return {
            "stress": Change(larger(stress), size, 1.6 * size**2 + abs(self.theta) * size),
            "shift": Change(shift.value, size_of_shift, error),
        }

    def tension(self) -> Changes:
        """Return the axial stress of the part that is worst with it, at the same bending."""
        if not self.theta:
            return {}
        bends = [found.value or 0.0 for found in self._rotated]
        pulls = [part.tension()["stress"].bound for part in self.parts]
        both = larger(b + p for b, p in zip(bends, pulls, strict=True))
        return {"stress": Change(both - larger(bends), larger(pulls))}

    @property
    def _rotated(self) -> list[Change]:
        """Return the next order of each part's stress, at the moment that both share."""
        whole_moment = number(unseparated_next_order.moment_change(**self.turn))
        found = []
        for part in self.parts:
            own = number(pivot_next_order.moment_change(theta=part.theta, **part.blade))
            stress = part.rotation()["stress"]
            value = (stress.value or 0.0) + whole_moment - own
            found.append(Change(value, larger(stress.bound, abs(value))))
        return found

    def load(self, n: float) -> Changes:
        """Return an unknown change, not derived: the cross between the parts is free."""
        return {"stress": UNKNOWN} if n else {}

    def _in_series(
        self,
        changes: Callable[[Pair], Changes],
        along: Callable[[Pair], float],
        coupled: float = 0.0,
        across: float = 0.0,
    ) -> dict[str, Change]:
        """Return the changes of both parts together, their shifts along the bisector added.

        ``coupled`` is a shift along it that both cause together, ``across`` the shift of each
        across it [m].
        """
        each = [changes(part) for part in self.parts]
        own = [1.0 + (found["stiffness"].value or 0.0) for found in each]
        stiffness = 1.0 / sum(s / k for s, k in zip(self.shares, own, strict=True))
        softened = 1.5 * larger(part["stiffness"].error for part in each)
        found = {"stiffness": whole(stiffness - 1.0, softened)}
        if not self.theta:
            return found
        turns = [stiffness / k for k in own]
        stress = [
            t * (1.0 + (part["stress"].value or 0.0)) for t, part in zip(turns, each, strict=True)
        ]
        found["stress"] = Change(
            larger(stress) - 1.0,
            larger(*(abs(s - 1.0) for s in stress), *(part["stress"].bound for part in each)),
            softened + larger(part["stress"].error for part in each),
        )
        first, moved = sum(self.leading), coupled
        for t, part, own_shift in zip(turns, self.parts, self.leading, strict=True):
            moved += own_shift * t**2 * (1.0 + along(part))
        shift = Pair.shifted(moved / first - 1.0, across / first)
        found["shift"] = shift._replace(error=shift.error + shift.bound**2 + softened)
        return found
