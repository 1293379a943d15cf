"""What the models say of one part, as logarithms that are smooth in its numbers.

A check is the worst of several limits, and so has kinks; each of its limits has none. A target
is two limits, one either way.
"""

from collections.abc import Mapping
from math import e, inf, isfinite, log, nan
from typing import NamedTuple

import numpy as np

from flexcli.engine import assess
from flexcli.engine.judge import FAR, SURE, limits_by
from flexcli.engine.models import NamedModel, model_series
from flexcli.errors import SolveError
from flexcli.numerics.rows import number
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements import Limit, RequirementError

__all__ = ["Margin", "Plan", "Row", "finer", "first_plan", "reading"]

MOST = 20.0
"""Logarithm of the largest factor over the required one that is told from infinite."""

NO_ANSWER = (NotAvailable, RequirementError, SolveError, MechanismError)


class Row(NamedTuple):
    """Which limit: its check, the question that asks it, its place among them, which way.

    Without a place it is the worst of all limits of a check.
    """

    check: str
    question: int
    place: str = ""
    way: str = ""


class Margin(NamedTuple):
    """Logarithms of the ends of the range of factor over required; not a number if unknown."""

    low: float
    high: float

    @property
    def is_sure(self) -> bool:
        """Return whether a finer model would tell little more."""
        return self.low > log(FAR) or self.high - self.low <= SURE


Plan = Mapping[int, str]
"""The model that each question is put to, by the place of the question."""


def reading(design: DesignSpec, plan: Plan) -> dict[Row, Margin]:
    """Return the margins of a part by the planned models; what has no answer is not there."""
    sizes = design.fixed_sizes()
    assert sizes is not None  # a part has sizes
    found = _margins(-1, list(design.own_limits(sizes)))
    models = {name: NamedModel(design, name) for name in plan.values()}
    try:
        questions = list(design.questions(design.scenes()))
    except NO_ANSWER:
        return found
    for index, (requirement, scene) in enumerate(questions):
        if index not in plan:
            continue
        try:
            limits = list(limits_by(design, sizes, requirement, scene, models[plan[index]]))
        except NO_ANSWER:
            continue
        found |= _margins(index, limits)
    return found


def first_plan(design: DesignSpec) -> Plan:
    """Return for each question the cheapest model that is sure, else the surest that answers."""
    series = [named.name for named in model_series(design)]
    count = len(list(design.questions(design.scenes())))
    plan: dict[int, str] = {}
    widths: dict[int, float] = {}
    left = set(range(count))
    for name in series:
        found = reading(design, dict.fromkeys(left, name))
        for index in sorted(left):
            rows = [margin for row, margin in found.items() if row.question == index]
            if not rows:
                continue
            width = _widest(rows)
            if index not in plan or width < widths[index] or widths[index] == inf:
                plan[index], widths[index] = name, width
            if all(margin.is_sure for margin in rows):
                left.discard(index)
    return plan


def finer(design: DesignSpec, plan: Plan, questions: set[int]) -> Plan:
    """Return a plan that puts questions to the next finer model that is surer, if any.

    What is exact at a stroke may be less sure of a stiffness at rest than small motion is.
    """
    series = [named.name for named in model_series(design)]
    found = dict(plan)
    for index in questions & plan.keys():
        present = _widest(_asked(design, index, plan[index]))
        for name in series[series.index(plan[index]) + 1 :]:
            if _widest(_asked(design, index, name)) < present:
                found[index] = name
                break
    return found


def _asked(design: DesignSpec, index: int, name: str) -> list[Margin]:
    """Return the margins of a question by a model."""
    margins = reading(design, {index: name}).items()
    return [margin for row, margin in margins if row.question == index]


def _widest(margins: list[Margin]) -> float:
    """Return the widest range of margins; without limit if one is unknown, or there is none."""
    widths = [margin.high - margin.low for margin in margins]
    return max(widths, default=inf) if all(map(isfinite, widths)) else inf


def _margins(question: int, limits: list[Limit]) -> dict[Row, Margin]:
    found: dict[Row, Margin] = {}
    places: dict[tuple[str, str], int] = {}
    for limit in limits:
        key = limit.name, limit.quantity
        places[key] = places.get(key, -1) + 1
        row = Row(limit.name, question, f"{limit.quantity} {places[key]}")
        between = assess.span(limit._replace(tolerance=None))
        low, high = (_log(end) for end in between) if between is not None else (nan, nan)
        if limit.tolerance is None:
            asked = _log(limit.required)
            found[row] = Margin(low - asked, high - asked)
            continue
        room = log(1.0 + limit.tolerance)
        found[row._replace(way="above")] = Margin(room + low, room + high)
        found[row._replace(way="below")] = Margin(room - high, room - low)
    return found


def _log(ratio: float) -> float:
    """Return the logarithm of a ratio, or of those of many designs, within what is told apart."""
    return number(np.log(np.clip(ratio, e**-MOST, e**MOST)))
