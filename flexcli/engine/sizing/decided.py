"""Formulas corrected to the models that judge: what a sizing chooses by.

A sizing needs thousands of designs judged, a fine model can judge a few. So the sources' formulas
choose, the models that decide judge the choice, and each check is corrected by how far the two
differ there, in value and in slope over the logarithms of the sizes, so that the optimum of the
corrected formulas is one of the models that judge (first-order model management, Alexandrov et al.
1998). What has no formula is taken by its value and slope alone.
"""

from collections.abc import Iterable, Mapping
from math import inf, log

from flexcli.engine.judge import FAR, finest
from flexcli.engine.models import NamedModel
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit
from flexcli.parts.sizing import Correction

__all__ = ["corrections_at", "difference"]

LARGEST = 1e3
"""A formula is corrected by no more than this factor."""

STEP = 1e-3
"""Change of a size (relative) over which slopes are taken: far above the models' tolerances, and
small enough for the slope to be that of the place."""

STEEPEST = 12.0
"""A slope beyond any power law of a blade is noise, or a model that changed on the way."""


def corrections_at(
    design: DesignSpec,
    sizes: Sizes,
    models: tuple[NamedModel, ...],
    known: Mapping[str, Correction] | None = None,
) -> dict[str, Correction]:
    """Return how the formulas of each check differ from the models that judge, at a design.

    Parameters
    ----------
    design : DesignSpec
        The design, without corrections.
    sizes : named tuple
        Sizes at which they are compared [m].
    models : tuple of NamedModel
        The models that judge, the cheapest first.
    known : mapping, optional
        Corrections near by whose slopes are kept; else slopes are taken of what is near its limit.

    Returns
    -------
    dict of Correction
        By the name of the check.

    """
    fine, plain = finest(design, sizes, models), _used(design.closed_limits(sizes))
    ratios = {name: used.share / plain.get(name, 1.0) for name, used in fine.items()}
    about = {name: float(getattr(sizes, name)) for name in design.geometry.free}
    near = {name for name, used in fine.items() if used.share > 1.0 / FAR}
    rises = {name: dict(known[name].slopes) if known and name in known else {} for name in fine}
    questions = {fine[name].question for name in near}
    for size, x in about.items() if known is None and near else ():
        beside = sizes._replace(**{size: x * (1.0 + STEP)})
        there = finest(design, beside, models, questions)
        formulas = _used(design.closed_limits(beside))
        for name in near & there.keys():
            ratio = there[name].share / formulas.get(name, 1.0)
            slope = log(ratio / ratios[name]) / log(1.0 + STEP)
            if abs(slope) <= STEEPEST:
                rises[name][size] = slope
    return {
        name: Correction(
            min(max(ratio, 1.0 / LARGEST), LARGEST), about, rises[name], name not in plain
        )
        for name, ratio in ratios.items()
    }


def difference(old: Mapping[str, Correction], new: Mapping[str, Correction], sizes: Sizes) -> float:
    """Return the largest relative difference of two sets of corrections at a design."""
    if not new:
        return 0.0
    return max(
        abs(float(found.at(sizes)) / float(old[name].at(sizes)) - 1.0) if name in old else inf
        for name, found in new.items()
    )


def _used(limits: Iterable[Limit]) -> dict[str, float]:
    """Return the largest share of what each check allows that is used, by its formulas."""
    found: dict[str, float] = {}
    for limit in limits:
        demand, capacity = float(limit.demand), float(limit.capacity)
        if capacity <= 0.0 or demand <= 0.0:
            continue
        asked = limit.required if limit.tolerance is None else 1.0
        used = asked * (demand / capacity) ** (1.0 / limit.power)
        found[limit.name] = max(found.get(limit.name, 0.0), used)
    return found
