"""The worst part within the tolerances: of each check the least margin, and how sure that is."""

from collections.abc import Mapping, Sequence
from math import exp
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.assess import ROUNDING
from flexcli.engine.judge import judge
from flexcli.engine.models import model_series
from flexcli.engine.tolerances.readings import MOST
from flexcli.engine.tolerances.response import Response
from flexcli.engine.tolerances.variations import Variation, as_made
from flexcli.parts.design import DesignSpec
from flexcli.results import Check, Verdict
from flexcli.results.activity import doing
from flexcli.results.tolerances import WorstCase

__all__ = ["Least", "judged_of", "least_of", "worst_cases"]

Floats = NDArray[np.float64]

ALL_CORNERS = 14
"""Numbers that differ, up to which every corner of the tolerances is looked at."""

TRIED = 4096
"""Points looked at besides, where the least need not be at a corner."""


LEVEL = 1e-6
"""Change of a margin (relative) over a whole tolerance that is none."""


class Least(NamedTuple):
    """Where one limit's margin is least: the logarithm there, what none falls below, how found."""

    at: Floats
    margin: float
    bound: float
    is_corner: bool


def _box(each: Sequence[Variation]) -> tuple[Floats, Floats]:
    """Return the ends of the tolerances as scaled variables."""
    ends = [v.scale(v.nominal + np.array([v.spread.low, v.spread.high])) for v in each]
    low, high = np.array(ends).T
    return low, high


def least_of(response: Response, low: Floats, high: Floats) -> list[Least]:
    """Return where the margin of each row is least in a box of the scaled variables.

    A margin that falls or rises along every number, wherever the others are, is least at a
    corner; its slopes are bounded over the box, to within the error of the fit.
    """
    slopes = [response.low.slope(i).bounds(low, high) for i in range(len(low))]
    falls = np.array([most * (h - l) for (_, most), l, h in zip(slopes, low, high, strict=True)])
    rises = np.array([least * (h - l) for (least, _), l, h in zip(slopes, low, high, strict=True)])
    level = np.maximum(response.error_low, LEVEL)
    is_monotone = np.asarray(((falls <= level) | (rises >= -level)).all(axis=0))
    below, _ = response.low.bounds(low, high)
    points = _corners_and_inside(low, high)
    values = response.low.at(points)
    found = []
    for k in range(len(response.rows)):
        at = points[int(np.argmin(values[:, k]))]
        if is_monotone[k]:
            at = np.where(falls[:, k] + rises[:, k] < 0.0, high, low)
        margin = float(response.low.at(at[None, :])[0, k])
        error = float(response.error_low[k])
        bound = margin if is_monotone[k] else min(float(below[k]), margin)
        found.append(Least(at, margin, bound - error, bool(is_monotone[k])))
    return found


def _corners_and_inside(low: Floats, high: Floats) -> Floats:
    """Return the corners of a box, or many of them, and points inside it."""
    count = len(low)
    inside = np.random.default_rng(0).uniform(low, high, (TRIED, count))
    if count > ALL_CORNERS:
        signs = np.random.default_rng(1).integers(0, 2, (TRIED, count))
    else:
        signs = np.array(list(np.ndindex(*(2,) * count)))
    return np.vstack([np.where(signs == 1, high, low), inside])


def worst_cases(
    response: Response, each: Sequence[Variation], design: DesignSpec
) -> dict[str, WorstCase]:
    """Return the worst case of each check, judged by the models where the fit says that it is."""
    least = least_of(response, *_box(each))
    known: dict[tuple[float, ...], Mapping[str, Check]] = {}
    found = {}
    for check in response.checks:
        worst = min((least[k] for k in response.places(check)), key=lambda one: one.margin)
        corner = tuple(worst.at.tolist())
        if corner not in known:
            doing(f"the worst case of {check}")
            known[corner] = judged_of(design, each, _values(each, worst.at))
        there = known[corner].get(check)
        verdict = Verdict.UNDECIDED if there is None else there.verdict
        bound = min(least[k].bound for k in response.places(check))
        by, share = "corner", _share(there, worst.margin)
        if check in response.unknown:
            by = "search"
            verdict = Verdict.FAIL if verdict is Verdict.FAIL else Verdict.UNDECIDED
        elif not all(least[k].is_corner for k in response.places(check)):
            by = "search"
            if verdict is Verdict.PASS:
                by, share = "bound", min(share, exp(min(bound, MOST)))
                verdict = Verdict.PASS if share >= 1.0 - ROUNDING else Verdict.UNDECIDED
        at = dict(zip([v.name for v in each], _values(each, worst.at), strict=True))
        found[check] = WorstCase(share, verdict.value, by, at)
    return found


def _values(each: Sequence[Variation], u: Floats) -> list[float]:
    """Return the numbers of a part [SI] from the scaled variables."""
    return [float(v.value(x)) for v, x in zip(each, u, strict=True)]


def judged_of(
    design: DesignSpec, each: Sequence[Variation], values: Sequence[float]
) -> Mapping[str, Check]:
    """Return what the models say of each check of a part by its numbers [SI]."""
    made = as_made(design, each, values)
    sizes = made.fixed_sizes()
    return {check.full_name: check for check in judge(made, sizes, model_series(made)).checks}


def _share(check: Check | None, margin: float) -> float:
    """Return the least factor of a check over the required one, by the fit where it has none."""
    if check is None or check.factor_range is None or check.is_target:
        return exp(margin)
    return check.factor_range[0] / check.required
