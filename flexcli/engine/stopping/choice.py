"""Choose height and gap of a stop on the operating line: the smallest gap that keeps all limits."""

from collections.abc import Callable, Iterator
from math import inf
from typing import NamedTuple

import numpy as np

from flexcli.engine.stopping.statics import StopTask, holds, margin, place_limits, stop_place
from flexcli.formulas.pi_law import MEASURED
from flexcli.formulas.stop_line import HARD_STOP, line_gap, line_height
from flexcli.formulas.stop_stiffness import height_share
from flexcli.parts.mechanisms.free_value import Free
from flexcli.results.stops import StopHold, StopPlace
from flexcli.units import show

__all__ = ["Choice", "choose", "measured_heights", "on_line"]

TRIED = 401
HALVINGS = 50


class Choice(NamedTuple):
    """The stop that was chosen, or the nearest to one; ``reason`` says why there is none."""

    outcome: str
    place: StopPlace
    reason: str = ""
    remedy: str = ""
    holds: tuple[StopHold, ...] = ()


def measured_heights(task: StopTask) -> tuple[float, float]:
    """Return the heights [m] at which the line was measured and a stop is no hard one."""
    (pi_1,) = (r for r in MEASURED if r.quantity == "pi_1")
    least, most = (float(height_share(end)) for end in (pi_1.least, pi_1.most))
    return least * task.L, min(most, HARD_STOP) * task.L


def on_line(task: StopTask, name: str, L_a: float) -> StopPlace:
    """Return the stop at a height with the gap that the operating line gives it."""
    gap = float(line_gap(L_a=L_a, L_b=task.L - L_a, delta_O=2.0 * task.travel))
    return stop_place(task, name, L_a, gap)


def choose(task: StopTask) -> Choice:
    """Return the stop: as given, or with what is free of it chosen on the operating line."""
    height, gap = task.stops.height, task.stops.gap
    if isinstance(height, float) and isinstance(gap, float):
        return Choice("given", stop_place(task, "given", height, gap))
    if isinstance(height, float):
        place = on_line(task, "chosen", height)
        return _within(place, "gap", place.delta_G, gap)
    if isinstance(gap, float):
        try:
            found = float(line_height(d=gap, L=task.L, delta_O=2.0 * task.travel))
        except ValueError:
            nearest = on_line(task, "nearest", measured_heights(task)[0])
            text = f"the gap {show(gap, 'm')} is below any that the operating line has"
            return Choice("infeasible", nearest, text, "take a wider gap, or leave it free")
        place = stop_place(task, "chosen", found, gap)
        return _within(place, "height", found, height)
    return _lowest(task, height, gap)


def _within(place: StopPlace, what: str, value: float, bounds: Free | float) -> Choice:
    """Return a place that follows from what is given, if it keeps the bounds of what is free."""
    if not isinstance(bounds, Free) or _is_in(value, bounds):
        return Choice("chosen", place)
    text = f"the operating line asks for a {what} of {show(value, 'm')}, outside its bounds"
    return Choice("infeasible", place._replace(name="nearest"), text, f"widen the bounds of {what}")


def _is_in(value: float, bounds: Free) -> bool:
    return (bounds.least or 0.0) <= value <= (inf if bounds.most is None else bounds.most)


def _lowest(task: StopTask, height: Free | float, gap: Free | float) -> Choice:
    """Return the lowest stop, which has the smallest gap, that keeps every limit and bound."""
    assert isinstance(height, Free)
    assert isinstance(gap, Free)
    low, high = measured_heights(task)
    least = max(low, height.least or 0.0)
    most = min(high, inf if height.most is None else height.most)
    if least > most:
        nearest = on_line(task, "nearest", low if (height.most or inf) < low else high)
        text = (
            f"height is bounded outside {show(low, 'm')} to {show(high, 'm')}, where the operating "
            "line was measured and a stop is no hard one"
        )
        return Choice("infeasible", nearest, text, "widen the bounds, or give height and gap")
    tried = [on_line(task, "nearest", float(L_a)) for L_a in np.linspace(least, most, TRIED)]

    def is_kept(place: StopPlace) -> bool:
        return _is_in(place.delta_G, gap) and all(map(holds, place_limits(task, place)))

    kept = [is_kept(place) for place in tried]
    if not any(kept):
        return _nearest(task, tried, gap)
    first = kept.index(True)
    found = tried[first].L_a
    if first > 0:
        found = _edge(tried[first - 1].L_a, found, lambda L_a: is_kept(on_line(task, "", L_a)))
    return Choice("chosen", on_line(task, "chosen", found), holds=tuple(_holds(task, tried)))


def _edge(outside: float, inside: float, is_kept: Callable[[float], bool]) -> float:
    """Return the height next to one that fails, by bisection from the safe side."""
    for _ in range(HALVINGS):
        middle = (outside + inside) / 2.0
        outside, inside = (outside, middle) if is_kept(middle) else (middle, inside)
    return inside


def _nearest(task: StopTask, tried: list[StopPlace], gap: Free) -> Choice:
    """Return the stop whose worst limit misses least, with what cannot hold together."""
    worst = [min(margin(limit) for limit in place_limits(task, place)) for place in tried]
    best = tried[int(np.argmax(worst))]
    rows = tuple(_holds(task, tried))
    never = [row.name for row in rows if not row.ranges]
    if never:
        reason = f"nowhere on the operating line: {', '.join(never)}"
    elif not any(_is_in(place.delta_G, gap) for place in tried):
        ends = " to ".join(show(place.delta_G, "m") for place in (tried[0], tried[-1]))
        reason = f"gap is bounded outside {ends}, what the operating line has there"
    else:
        reason = "the limits hold at different heights, at none together"
    remedy = "allow more travel or lower factors, change the blade or the contact's radius"
    return Choice("infeasible", best, reason, remedy, rows)


def _holds(task: StopTask, tried: list[StopPlace]) -> Iterator[StopHold]:
    """Yield between which of the heights tried each limit holds."""
    kept: dict[str, list[bool]] = {}
    for place in tried:
        for limit in place_limits(task, place):
            kept.setdefault(limit.name, []).append(holds(limit))
    for name, flags in kept.items():
        edges = np.flatnonzero(np.diff([False, *flags, False])).reshape(-1, 2)
        ranges = tuple((tried[first].L_a, tried[after - 1].L_a) for first, after in edges)
        yield StopHold(name, ranges)
