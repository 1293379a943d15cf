"""All effects together on a closed form: the factor that corrects it, and its error."""

from collections.abc import Iterable, Sequence
from itertools import combinations
from math import prod
from typing import NamedTuple

from flexcli.numerics.rows import isfinite, larger, smaller
from flexcli.parts.bending import FLOOR, Change
from flexcli.parts.effects.base import ModelEffect, Setting
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["BETWEEN", "MOST", "Estimate", "estimate", "left_by"]

BETWEEN = 2.0
"""Interaction of two effects over the product of their sizes: the largest seen in exact
solutions."""

MOST = 0.5
"""Error beyond which a corrected closed form is not used to judge."""


class Estimate(NamedTuple):
    """The factor by which effects correct a closed form, and the error that remains.

    Without a range the error is unknown, and nothing is judged by the number.
    """

    factor: float
    error: ErrorRange | None


def estimate(setting: Setting, kind: QuantityKind, effects: Iterable[ModelEffect]) -> Estimate:
    """Return the correction of a closed form's number of a kind by all effects.

    The number times the factor lies within the error of that of the finest model, as far as the
    effects cover all that it leaves out.
    """
    elastic, travel = setting.material.elastic, setting.largest_travel
    if not setting.geometry.is_known(elastic, setting.sizes, travel, kind):
        return Estimate(1.0, None)
    changes = [
        _beside_others(effect, change)
        for effect in effects
        if effect.indicator(setting) is not None
        and (not effect.lacks(setting) or effect.spans_what_it_needs)
        and (change := effect.all_changes(setting).get(kind)) is not None
    ]
    left = left_by(changes)
    if left is None:
        return Estimate(1.0, None)
    factor = prod(1.0 + change.value for change in changes if change.value is not None)
    return Estimate(factor, left + FLOOR)


def _beside_others(effect: ModelEffect, change: Change) -> Change:
    """Return a change as it counts: a complete one has its own error for its whole size."""
    if not effect.is_whole:
        return change
    if change.value is None:
        return Change(0.0, 0.0, change.bound, change.sign)
    return change._replace(bound=0.0)


def left_by(changes: Sequence[Change], beside: Sequence[Change] = ()) -> ErrorRange | None:
    """Return the error that remains after correcting a number by changes, None if one is unknown.

    Effects multiply. The interaction of two has not been derived: it is of the size of their
    product, and no more than the error of one of them for any shape of the blades. Those
    ``beside``, which the model includes, interact too.
    """
    low = high = 0.0
    for value, _, alone, sign, _ in changes:
        if value is None or not value > -1.0 or not isfinite(value + alone):
            return None
        one_sided = sign if value == 0.0 else 0
        low += 0.0 if one_sided > 0 else alone
        high += 0.0 if one_sided < 0 else alone
    pairs = [*combinations(changes, 2), *((one, other) for one in changes for other in beside)]
    both = sum(
        smaller(BETWEEN * one.bound * other.bound, one.other, other.other)
        for one, other in pairs
        if one.bound and other.bound
    )
    return ErrorRange(-low - both, high + both) if larger(low, high) + both < MOST else None
