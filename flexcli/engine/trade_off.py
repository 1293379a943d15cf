"""Pareto fronts by bounds on the second objective, and the best of several options."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import pairwise, product
from math import exp, hypot, isclose, isfinite, isnan, log, nan, sqrt
from typing import Any

import numpy as np

from flexcli.errors import NoSolution
from flexcli.parts.design import DesignSpec
from flexcli.parts.trade_off import MovingBound
from flexcli.results import Check, Note, Result, Status
from flexcli.results.activity import doing
from flexcli.results.trade_off import ChoiceRow, Choices, Front, FrontPoint

__all__ = ["best_option", "front_of"]

DECADES = 2.0
"""How far the second objective is followed from where the first is best."""

HALVINGS = 7
"""Steps to where no design is left: the end is known to 100^(1/128), 4 %."""

ROOM = 0.002
"""Share by which the last design of a front keeps clear of the best second objective."""

SAME = 1e-4
"""Difference (relative) of second objectives at which two designs are one: a front that jumps there
is filled no further."""

CLOSE = 0.4
"""Share of an even step below which a design is left out for its neighbour."""

BULGE = 0.03
"""Distance from the line between the ends, over its own length, below which there is no knee."""


def objective_of(design: DesignSpec, result: Result) -> tuple[str, str, float]:
    """Return name, unit and value of what a sizing made least or largest."""
    if design.pursued is not None:
        return design.pursued.key, *_worst(design.pursued, result)
    goal = design.sizing.objective
    named = {"least-stiffness": "k_pivot", "shortest": "l"}
    name = (
        named.get(goal, "volume") if isinstance(goal, str) else goal.minimize or goal.maximize or ""
    )
    if name == "mass":
        density = design.material.density
        value = result.values["volume"].value
        return name, "kg", value * (density.value if density is not None else float("nan"))
    stiffness = "k_pivot" if "k_pivot" in result.values else "k_stage"
    found = result.values[stiffness if name == "k_pivot" else name]
    return name, found.unit, found.value


def _checks_of(moving: MovingBound, result: Result) -> list[Check]:
    """Return the checks of the requirement that is the second objective."""
    return [
        check
        for check in result.checks
        if check.path[:2] == ("requirements", moving.key) and moving.has(check.name)
    ]


def _worst(moving: MovingBound, result: Result) -> tuple[str, float]:
    """Return unit and worst value of a requirement over the cases."""
    own = _checks_of(moving, result)
    if not own:
        return "", nan  # it does not apply to any case
    if len(moving.path) < 3:
        return "", min(check.factor for check in own)
    worst = min(c.capacity for c in own) if moving.rises else max(c.demand for c in own)
    return own[0].unit, worst


def _is_most(design: DesignSpec) -> bool:
    goal = design.sizing.objective
    return not isinstance(goal, str) and goal.maximize is not None


def best_option(
    among: Mapping[str, Sequence[Any]],
    sized: Callable[[Mapping[str, Any]], tuple[DesignSpec | None, Result]],
) -> Result:
    """Return the sizing of the best of all combinations of options.

    Parameters
    ----------
    among : mapping
        By places of the spec, what may stand there.
    sized : callable
        Sizes the design with such values put in; no design where the spec does not take them.

    """
    rows: list[ChoiceRow] = []
    best: tuple[float, Result, Mapping[str, Any]] | None = None
    told = ("", "")
    last: Result | None = None
    for values in product(*among.values()):
        option = dict(zip(among, values, strict=True))
        doing(", ".join(map(str, values)))
        design, result = sized(option)
        last = last or result
        objective, reason = None, "; ".join(found.text for found in result.findings)
        if design is not None and all(n in result.values for n in design.geometry.free):
            name, unit, objective = objective_of(design, result)
            told = (name, unit)
            worth = -objective if _is_most(design) else objective
            if (
                result.status is Status.PASS
                and isfinite(worth)
                and (best is None or worth < best[0])
            ):
                best = (worth, result, option)
        if result.sizing is not None and result.sizing.conflict:
            reason = "in conflict: " + ", ".join(row.name for row in result.sizing.conflict)
        rows.append(ChoiceRow(option, result.status.value, objective, reason))
    assert last is not None  # of two options at least
    choices = Choices(*told, tuple(rows), best[2] if best is not None else {})
    if best is None:
        note = Note("no-option", "none of the options has a design that passes")
        return replace(last, choices=choices, warnings=(*last.warnings, note))
    return replace(best[1], choices=choices)


def front_of(
    design: DesignSpec,
    moving: MovingBound,
    sized: Callable[[str | None, Mapping[str, float]], Result],
    best: Callable[[str | None, Mapping[str, float]], Result],
    count: int,
) -> Result:
    """Return the front of a design, and the sizing at its knee.

    Parameters
    ----------
    design : DesignSpec
        The design with two objectives.
    moving : MovingBound
        The requirement that is the second.
    sized : callable
        Sizes the design for the first objective with a bound on the second as the spec writes it,
        beginning with sizes that were found at another bound, if any.
    best : callable
        Sizes the design for the second objective alone, likewise.
    count : int
        How many designs the front has.

    """
    run = _Run(design, moving, sized, best)
    start = run.at(None)
    if start is None:
        return run.last
    remarks, notes = [], []
    try:
        remarks.append(run.end())
        run.fill(count)
    except KeyboardInterrupt:
        notes.append(Note("interrupted", "the run was stopped: the front has what was done"))
    points = run.even(count)
    knee = _knee(points)
    shown = run.results[points[knee if knee is not None else len(points) // 2].bound]
    name, unit, _ = objective_of(design, shown)
    front = Front(
        first=name,
        first_unit=unit,
        second=moving.key,
        second_unit=run.unit,
        points=tuple(points),
        knee=knee,
        proved=all(point.certificate.startswith("global") for point in points),
        remarks=tuple(remarks),
    )
    status = Status.UNDECIDED if notes else shown.status
    return replace(shown, status=status, front=front, warnings=(*shown.warnings, *notes))


class _Run:
    """A front on its way: its designs by the bound that led to them."""

    def __init__(
        self,
        design: DesignSpec,
        moving: MovingBound,
        sized: Callable[[str | None, Mapping[str, float]], Result],
        best: Callable[[str | None, Mapping[str, float]], Result],
    ) -> None:
        self.design, self.moving, self.sized, self.best = design, moving, sized, best
        self.found: list[FrontPoint] = []
        self.results: dict[float | None, Result] = {}
        self.last: Result
        self.unit = ""
        self.sense = 1.0 if moving.rises else -1.0
        """Sign with which the second objective grows as it becomes better."""

    @property
    def points(self) -> list[FrontPoint]:
        """Return the designs, the loosest second objective first."""
        return sorted(self.found, key=lambda point: self.sense * point.second)

    def at(self, bound: float | None, near: Mapping[str, float] | None = None) -> FrontPoint | None:
        """Return the design at a bound on the second objective, if one passes.

        It is looked for from sizes ``near``, else from between those of its neighbours.
        """
        text = self._text(bound)
        doing(f"{self.moving.key} at {text or 'its loosest'}")
        try:
            self.last = result = self.sized(text, near or self._near(bound))
        except NoSolution:
            if bound is None:
                raise
            return None
        free = self.design.geometry.free
        if result.status is not Status.PASS or any(n not in result.values for n in free):
            return None
        _, _, first = objective_of(self.design, result)
        self.unit, second = _worst(self.moving, result)
        if isnan(second):
            return None
        point = FrontPoint(
            first, second, bound, {n: result.values[n].value for n in free},
            result.sizing.certificate if result.sizing is not None else "",
            result.choices.chosen if result.choices is not None else {},
        )  # fmt: skip
        self.found.append(point)
        self.results[bound] = result
        return point

    def _near(self, bound: float | None) -> Mapping[str, float]:
        """Return sizes to look from: between those of the designs about a bound, in logarithms."""
        if bound is None or not self.found:
            return {}
        points = self.points
        at = self.sense * log(bound)
        own = [self.sense * log(point.second) for point in points]
        sizes = [np.log([*point.sizes.values()]) for point in points]
        y = [float(np.interp(at, own, column)) for column in zip(*sizes, strict=True)]
        return dict(zip(points[0].sizes, np.exp(y).tolist(), strict=True))

    def end(self) -> str:
        """Follow the second objective to where no design is left, and say where that is."""
        (start,) = self.points
        sense = self.sense
        far = start.second * exp(sense * DECADES * log(10.0))
        doing(f"the best {self.moving.key}")
        found = self._best(None, {})
        if found is not None and sense * log(found[0] / far) < 0.0 and found[1] > ROOM:
            # far from its loosest bound a rough model may have judged it
            found = self._best(found[0] * exp(-sense * ROOM), found[2]) or found
        if found is None:
            return self._sought_end(start.second, far)
        last, _, near = found
        if sense * log(last / far) >= 0.0:
            self.at(far, near)
            return f"{self.moving.key} goes on beyond the last: it was followed for two decades"
        if self.at(last * exp(-sense * ROOM), near) is None:
            return self._sought_end(start.second, last)
        return f"beyond the last, to within {ROOM:.1%} of {self.moving.key}, none was found to pass"

    def _best(
        self, bound: float | None, near: Mapping[str, float]
    ) -> tuple[float, float, Mapping[str, float]] | None:
        """Return the tightest bound that the best second objective keeps, how unsure it is, sizes.

        That is by the low ends of the factors; nothing where no design passes.
        """
        try:
            result = self.best(self._text(bound), near)
        except NoSolution:
            return None
        if result.status is not Status.PASS:
            return None
        own = _checks_of(self.moving, result)
        shares = [c.factor_range[0] / c.factor if c.factor_range else 1.0 for c in own]
        worst = min(shares, default=1.0)
        _, value = _worst(self.moving, result)
        kept = value * worst if self.moving.rises else value / worst
        sizes = {n: result.values[n].value for n in self.design.geometry.free}
        return kept, 1.0 / worst - 1.0, sizes

    def _text(self, bound: float | None) -> str | None:
        """Return a bound as the spec writes it."""
        return None if bound is None else f"{bound!r} {self.unit}".strip()

    def _sought_end(self, start: float, far: float) -> str:
        """Look for where no design is left by halves, and say where that is."""
        if self.at(far) is not None:
            return f"{self.moving.key} goes on beyond the last: it was followed for two decades"
        low, high = log(start), log(far)
        for _ in range(HALVINGS):
            middle = (low + high) / 2.0
            found = self.at(exp(middle))
            low, high = (low, middle) if found is None else (middle, high)
        return f"beyond the last, to within {abs(high - low):.1%} of {self.moving.key}, none passes"

    def fill(self, count: int) -> None:
        """Put designs between those that are farthest apart, in logarithms."""
        ends: dict[tuple[float | None, float | None], float] = {}
        while len(self.even(count)) < count:
            points, at = self.points, list(_logs(self.points))
            whole = sum(_distance(one, other) for one, other in pairwise(at))
            gaps: list[tuple[float, float, FrontPoint, FrontPoint]] = []
            for k, (one, other) in enumerate(pairwise(points)):
                # what is asked beyond the last end gave the other again: the front jumps there
                end = ends.get((one.bound, other.bound), other.second)
                share = log(end / one.second) / (log(other.second / one.second) or 1.0)
                gaps.append((share * _distance(at[k], at[k + 1]), end, one, other))
            if not gaps:
                return
            widest, end, one, other = max(gaps, key=lambda gap: gap[0])
            if widest < 2.0 * CLOSE * whole / (count - 1):
                return  # what is between is left out for its neighbours
            middle = sqrt(one.second * end)
            found = self.at(middle)
            if found is None or _is_same(found, one):
                ends[one.bound, other.bound] = one.second
            elif _is_same(found, other):
                ends[one.bound, other.bound] = middle
            if found is not None and any(_is_same(found, each) for each in (one, other)):
                self.found.pop()

    def even(self, count: int) -> list[FrontPoint]:
        """Return the designs that are best in both, without those too near another."""
        sign = 1.0 if not _is_most(self.design) else -1.0
        kept: list[FrontPoint] = []
        for point in reversed(self.points):  # none after it has as tight a second objective
            if not kept or sign * point.first < sign * kept[-1].first * (1.0 - sign * 1e-9):
                kept.append(point)
        kept.reverse()
        if len(kept) < 3:
            return kept
        at = list(_logs(kept))
        whole = sum(_distance(one, other) for one, other in pairwise(at))
        step, taken = CLOSE * whole / (count - 1), [0]
        for k in range(1, len(kept) - 1):
            if min(_distance(at[taken[-1]], at[k]), _distance(at[k], at[-1])) >= step:
                taken.append(k)
        return [*(kept[k] for k in taken), kept[-1]]


def _is_same(one: FrontPoint, other: FrontPoint) -> bool:
    """Return whether a design is another one again, though sized anew."""
    return isclose(one.second, other.second, rel_tol=SAME)


def _logs(points: Sequence[FrontPoint]) -> Iterator[tuple[float, float]]:
    """Yield the logarithms of both objectives, each over its range."""
    first, second = (
        np.log([getattr(point, name) for point in points]) for name in ("first", "second")
    )
    spans = [float(np.ptp(x)) or 1.0 for x in (first, second)]
    for x, y in zip(first, second, strict=True):
        yield float(x - first[0]) / spans[0], float(y - second[0]) / spans[1]


def _distance(one: tuple[float, float], other: tuple[float, float]) -> float:
    return hypot(one[0] - other[0], one[1] - other[1])


def _knee(points: Sequence[FrontPoint]) -> int | None:
    """Return the place of the design farthest from the line between the ends."""
    if len(points) < 3:
        return None
    at = np.array(list(_logs(points)))
    along = at[-1] - at[0]
    off = at - at[0]
    distances = np.abs(off[:, 0] * along[1] - off[:, 1] * along[0]) / float(np.hypot(*along))
    knee = int(np.argmax(distances))
    return knee if distances[knee] > BULGE else None
