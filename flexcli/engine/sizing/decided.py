"""What the models that judge say of a design, and formulas corrected to say the same near it.

A sizing needs thousands of designs judged, a fine model can judge a few. So the sources' formulas
choose, the models that decide judge the choice, and each check is corrected by how far the two
differ there, in value and in slope over the logarithms of the sizes, so that the optimum of the
corrected formulas is one of the models that judge (first-order model management, Alexandrov et al.
1998). What has no formula is taken by its value and slope alone.
"""

from collections.abc import Iterable, Mapping
from math import exp, log
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.judge import FAR, Used, finest
from flexcli.engine.models import NamedModel
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit
from flexcli.parts.sizing import Correction

__all__ = [
    "Place",
    "Slopes",
    "cheap_slopes_at",
    "corrections",
    "judged_at",
    "shares",
    "slopes_at",
    "updated_slopes",
]

Slopes: TypeAlias = dict[str, NDArray[np.float64]]
"""By check, what the logarithm of its correction changes per logarithm of each free size."""

LARGEST = 1e3
"""A formula is corrected by no more than this factor."""

STEP = 1e-3
"""Change of a size (relative) over which slopes are taken: far above the models' tolerances, and
small enough for the slope to be that of the place."""

STEEPEST = 50.0
"""Largest power of a size by which a correction changes: beyond it a model changed on the way, and
powers of a size in metres are no numbers any more."""


class Place(NamedTuple):
    """A design, what each check uses there by the models that judge, and by the formulas.

    ``y`` are the logarithms of the free sizes, in the order of the geometry; ``open`` the questions
    that no model has numbers for; ``drawn`` is the design with these sizes, and its own sizes.
    ``pursued`` are the checks of a requirement that is the objective.
    """

    sizes: Sizes
    y: NDArray[np.float64]
    used: Mapping[str, Used]
    plain: Mapping[str, float]
    open: frozenset[int]
    drawn: tuple[DesignSpec, Sizes] | None
    pursued: frozenset[str] = frozenset()

    def correction(self, name: str) -> float:
        """Return by what the formulas of a check are wrong, as a logarithm; all of it without."""
        return log(self.used[name].share / self.plain.get(name, 1.0))

    @property
    def near(self) -> frozenset[str]:
        """Return the checks that are near their limits, and those that are the objective."""
        near = (name for name, used in self.used.items() if used.share > 1.0 / FAR)
        return self.pursued.union(near)

    @property
    def alone(self) -> frozenset[str]:
        """Return the checks behind which no formula stands."""
        return frozenset(self.used.keys() - self.plain.keys())


def judged_at(
    design: DesignSpec,
    sizes: Sizes,
    models: tuple[NamedModel, ...],
    before: Place | None = None,
    only: Iterable[int] | None = None,
    *,
    rough: bool = False,
    near: Place | None = None,
) -> Place:
    """Return a design judged, each check by the model that was sure of it before.

    Of what is drawn a number whose error nobody knows leaves its question open, unless a ``rough``
    answer does.

    Parameters
    ----------
    design : DesignSpec
        The design, without corrections.
    sizes : named tuple
        Sizes at which it is judged [m].
    models : tuple of NamedModel
        The models that judge, the cheapest first.
    before : Place, optional
        A design near by, whose models are asked first.
    only : iterable of int, optional
        The questions that are asked; all if left out.
    near : Place, optional
        A design from whose solutions exact models go on, where differences from it are asked for.

    """
    hints: dict[int, int] = {}
    for known in before.used.values() if before is not None else ():
        hints[known.question] = max(known.model, hints.get(known.question, 0))
    y = np.log([float(getattr(sizes, name)) for name in design.geometry.free])
    asked = None if only is None else frozenset(only)
    try:
        sure = not (rough or design.geometry.closed_forms)
        drawn = design.redrawn(sizes)
        about = None if near is None else near.drawn
        used, open_ = finest(*drawn, models, asked, hints, known=sure, near=about)
    except NotAvailable:  # there is nothing to judge
        count = sum(1 for _ in design.questions(design.scenes()))
        used, open_ = {}, frozenset(range(count)) if asked is None else asked
        drawn = None
    meant = design.pursued
    own = [name for name, each in used.items() if meant and meant.has(each.check.name)]
    plain = shares(design.closed_limits(sizes))
    return Place(sizes, y, used, plain, open_, drawn, frozenset(own))


def slopes_at(
    design: DesignSpec, place: Place, models: tuple[NamedModel, ...], *, rough: bool = False
) -> Slopes:
    """Return the slopes of the corrections of what is near its limit or has no formula.

    They are differences: to one side, and of what is drawn, where all depends on them, to both
    sides unless a ``rough`` answer does. Exact beams are not solved anew beside the place.
    """
    sides = (1.0,) if rough or design.geometry.closed_forms else (1.0, -1.0)
    names = place.near | place.alone
    questions = {place.used[name].question for name in names}
    found = {name: np.zeros(place.y.size) for name in place.used}
    for k, size in enumerate(design.geometry.free if names else ()):
        x, there = float(getattr(place.sizes, size)), list[tuple[float, Place]]()
        for side in sides:
            beside = place.sizes._replace(**{size: x * (1.0 + side * STEP)})
            judged = judged_at(design, beside, models, place, questions, rough=rough, near=place)
            there.append((log(1.0 + side * STEP), judged))
        for name in names:
            known = [(y, each.correction(name)) for y, each in there if name in each.used]
            if not known:
                continue
            last = known[1] if len(known) > 1 else (0.0, place.correction(name))
            slope = (known[0][1] - last[1]) / (known[0][0] - last[0])
            if abs(slope) <= STEEPEST:
                found[name][k] = slope
    return found


def cheap_slopes_at(design: DesignSpec, place: Place, models: tuple[NamedModel, ...]) -> Slopes:
    """Return the slopes of what has no formula by the cheapest model alone."""
    questions = {place.used[name].question for name in place.alone}
    there = judged_at(design, place.sizes, models[:1], only=questions, rough=True)
    found = slopes_at(design, there, models[:1], rough=True)
    return {name: found[name] for name in place.alone & found.keys()}


def updated_slopes(slopes: Slopes, place: Place, there: Place, names: Iterable[str]) -> Slopes:
    """Return slopes by which the corrections of some checks hold at two places (Broyden's update).

    References
    ----------
    C. G. Broyden (1965), A class of methods for solving nonlinear simultaneous equations,
    Math. Comp. 19, 577-593.

    """
    step, new = there.y - place.y, dict(slopes)
    if not step.any():
        return new
    for name in names:
        old = slopes.get(name, np.zeros(step.size))
        missed = there.correction(name) - place.correction(name) - float(old @ step)
        new[name] = np.clip(old + missed / float(step @ step) * step, -STEEPEST, STEEPEST)
    return new


def corrections(
    design: DesignSpec, place: Place, slopes: Slopes, margin: float
) -> dict[str, Correction]:
    """Return by check what makes the formulas say at a place what the models that judge do.

    ``margin`` is what is asked beside, as a share.
    """
    about = {name: float(getattr(place.sizes, name)) for name in design.geometry.free}
    return {
        name: Correction(
            min(max(exp(place.correction(name)), 1.0 / LARGEST), LARGEST)
            * (1.0 + (0.0 if used.is_target else margin)),
            about,
            dict(zip(about, slopes[name].tolist(), strict=True)) if name in slopes else {},
            used.check if name in place.alone else None,
        )
        for name, used in place.used.items()
    }


def shares(limits: Iterable[Limit]) -> dict[str, float]:
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
