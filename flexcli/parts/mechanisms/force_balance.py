"""Choice of the free numbers of a parallel stage that balances it against its base's motion.

The static moment of the moving bodies about the base pivots is affine in each arm, mass, split and
lever height. So one unknown is solved in closed form, and of two unknowns one stands at a bound of
its own, because the added mass and then the arms fall monotonically towards it.
"""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import replace
from math import inf, isfinite
from typing import NamedTuple

from flexcli.mechanics.layout import Body
from flexcli.mechanics.parallel_stage import Stage
from flexcli.parts.mechanisms.free_value import Free
from flexcli.units import show

__all__ = ["Balancing", "Unknown", "balance"]


NO_EFFECT = 1e-12
"""Ratio of the difference of both sides' effects to one of them below which it is rounding."""


SHORTEST = 1e-6
"""Least height of a lever that the spec does not bound [m]."""


class Unknown(NamedTuple):
    """One free number: an arm or a mass (on some sides), the split of a total mass, the height."""

    kind: str
    sides: tuple[int, ...]
    bounds: Free
    total: float = 0.0

    @property
    def label(self) -> str:
        """Return its name in words."""
        where = f" of balance-{2 * self.sides[0] + 1}" if len(self.sides) == 1 else ""
        what = {"split": "share of the added mass on side 1", "height": "height of the levers"}
        return what.get(self.kind, f"balancing {self.kind}{where}")

    @property
    def unit(self) -> str:
        """Return its SI unit."""
        return {"arm": "m", "height": "m", "mass": "kg"}.get(self.kind, "")

    @property
    def least(self) -> float:
        """Return its lower bound: 0 where the spec gives none."""
        if self.bounds.least is not None:
            return self.bounds.least
        return SHORTEST if self.kind == "height" else 0.0

    @property
    def most(self) -> float:
        """Return its upper bound."""
        if self.bounds.most is not None:
            return self.bounds.most
        return 1.0 if self.kind == "split" else inf

    def put(self, stage: Stage, value: float) -> Stage:
        """Return the stage with the unknown set to a value."""
        if self.kind == "height":
            return replace(stage, height=value)
        levers = list(stage.levers)
        for side in self.sides:
            balance = self._set(levers[side].balance, side, value)
            levers[side] = replace(levers[side], balance=balance)
        return replace(stage, levers=(levers[0], levers[1]))

    def _set(self, balance: Body, side: int, value: float) -> Body:
        if self.kind == "arm":
            return balance._replace(com=(balance.com[0], -value))
        if self.kind == "mass":
            return balance._replace(mass=value)
        share = value if side == 0 else 1.0 - value
        return balance._replace(mass=self.total * share)

    def rates(self, stage: Stage) -> tuple[float, ...]:
        """Return the change of the static moment per unit of the unknown, on both sides."""
        if self.kind == "height":
            return (stage.platform,)
        masses = [stage.levers[side].balance for side in self.sides]
        if self.kind == "arm":
            return tuple(-each.mass for each in masses)
        along = tuple(each.com[1] for each in masses)
        return along if self.kind == "mass" else (self.total * along[0], -self.total * along[1])

    def shown(self, value: float) -> str:
        """Return a value of it with its unit, for a message."""
        return show(value, self.unit) if self.unit else f"{value:.4g}"


class Balancing(NamedTuple):
    """A stage with its unknowns set, and the reason where they do not suffice."""

    stage: Stage
    unknowns: tuple[Unknown, ...] = ()
    found: tuple[float, ...] = ()
    reason: str = ""
    remedy: str = ""

    @property
    def met(self) -> bool:
        """Return whether the required coupling is reached within the bounds."""
        return not self.reason


def balance(stage: Stage, unknowns: Sequence[Unknown], allowed: float) -> Balancing:
    """Return the stage whose coupling is at most ``allowed`` times that without balancing masses.

    Least mass is added; then the arms are shortest. Where the bounds leave no such stage, the
    nearest one comes with the reason and a remedy.
    """
    if not unknowns:
        return Balancing(stage)
    if len(unknowns) == 1:
        return _one(stage, unknowns[0], allowed)
    tried = list(_with_one_at_a_bound(stage, unknowns, allowed))
    met = [solution for solution in tried if solution.met]
    if met:
        return min(met, key=lambda solution: _cost(solution.stage))
    return min(tried, key=lambda solution: abs(solution.stage.moment / solution.stage.height))


def _cost(stage: Stage) -> tuple[float, float]:
    return stage.added_mass, sum(abs(lever.balance.com[1]) for lever in stage.levers)


def _with_one_at_a_bound(
    stage: Stage, unknowns: Sequence[Unknown], allowed: float
) -> Iterator[Balancing]:
    first, second = unknowns
    for fixed, solved in ((first, second), (second, first)):
        for bound in _finite(fixed.least, fixed.most):
            if fixed.kind == "height" and bound <= 0.0:
                continue
            inner = _one(fixed.put(stage, bound), solved, allowed)
            values = (bound, *inner.found) if fixed is first else (*inner.found, bound)
            reason = inner.reason and f"{inner.reason}, with the {fixed.label} at its bound"
            yield inner._replace(unknowns=tuple(unknowns), found=values, reason=reason)


def _finite(*values: float) -> Iterable[float]:
    return (value for value in values if value < inf)


def _one(stage: Stage, unknown: Unknown, allowed: float) -> Balancing:
    """Solve for one unknown, of which the static moment is affine."""
    rest = unknown.put(stage, 0.0).moment
    rates = unknown.rates(stage)
    rate = sum(rates)
    seen = abs(rate) > NO_EFFECT * sum(abs(term) for term in rates)
    root = -rest / rate if seen else inf
    if not isfinite(root):
        return _without_effect(stage, unknown, allowed)
    nearest = min(max(root, unknown.least), unknown.most)
    if nearest != root and not _within(unknown.put(stage, nearest), allowed):
        return _out_of_bounds(stage, unknown, root, nearest, rest)
    chosen = nearest
    if unknown.kind in ("arm", "mass") and allowed > 0.0:  # the least that does
        band = allowed * abs(stage.without_balance().moment / rate)
        shortest = min(max(0.0, root - band), root + band)
        chosen = min(max(shortest, unknown.least), unknown.most)
    return Balancing(unknown.put(stage, chosen), (unknown,), (chosen,))


def _within(stage: Stage, allowed: float) -> bool:
    return abs(stage.moment) <= allowed * abs(stage.without_balance().moment)


def _left(stage: Stage) -> str:
    """Return the remaining coupling, in per cent of that before balancing."""
    before = stage.without_balance().moment
    return f"{abs(stage.moment / before):.3g} of that before" if before else "not zero"


def _without_effect(stage: Stage, unknown: Unknown, allowed: float) -> Balancing:
    value = min(max(0.0, unknown.least), unknown.most)
    there = unknown.put(stage, value)
    if _within(there, allowed):
        return Balancing(there, (unknown,), (value,))
    why, remedy = {
        "arm": ("a balancing mass of zero has no moment at any arm", "give it a mass"),
        "mass": ("the arms are zero or cancel each other", "give arms on one side of the pivots"),
        "split": ("both arms are equal, so that the split changes nothing", "let the arms differ"),
        "height": ("solid 2 has no mass, so that its height changes nothing", "free an arm"),
    }[unknown.kind]
    return Balancing(
        there, (unknown,), (value,), f"the {unknown.label} does nothing: {why}", remedy
    )


def _out_of_bounds(
    stage: Stage, unknown: Unknown, root: float, nearest: float, rest: float
) -> Balancing:
    there = unknown.put(stage, nearest)
    side = "below its least" if root < nearest else "above its limit"
    needed = unknown.shown(root)
    reason = (
        f"the {unknown.label} would have to be {needed}, {side} {unknown.shown(nearest)}; "
        f"there the coupling is still {_left(there)}"
    )
    remedy = f"allow {needed}"
    if root < 0.0 and unknown.kind in ("arm", "mass"):
        reason += "; the levers are over-balanced without it"
        remedy = "allow an arm towards solid 2 (a negative one), or take mass off below the pivots"
    elif unknown.kind == "arm" and nearest > 0.0:
        remedy += f", or {show(rest / nearest, 'kg')} of balancing mass at {unknown.shown(nearest)}"
    elif unknown.kind == "mass" and nearest > 0.0:
        arm = show(rest / (nearest * len(unknown.sides)), "m")
        remedy += f", or an arm of {arm} for {unknown.shown(nearest)}"
    return Balancing(there, (unknown,), (nearest,), reason, remedy)
