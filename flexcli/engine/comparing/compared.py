"""Models beside each other: errors against the finest, Pareto sets, the cheapest that will do."""

from collections.abc import Sequence
from math import inf
from typing import Generic, NamedTuple, Protocol, TypeVar

import numpy as np
from numpy.typing import NDArray

from flexcli.numerics.pareto import pareto
from flexcli.results.accuracy import AccuracyResult, ModelAccuracy, QuantityAccuracy, Reading

__all__ = ["UNSURE", "Named", "Reference", "Timed", "compared", "relative_bound"]

Floats = NDArray[np.float64]

UNSURE = 0.1
"""Error of the finest value, relative, from which it is no more than rounding."""


class Named(Protocol):
    """What reports call by its name."""

    @property
    def name(self) -> str:
        """Return the name."""


class Reported(Named, Protocol):
    """A number as reports show it."""

    @property
    def label(self) -> str:
        """Return what it is, in words."""

    @property
    def unit(self) -> str:
        """Return its SI unit."""


N = TypeVar("N", bound=Reported)


class Reference(NamedTuple, Generic[N]):
    """A number with the finest model's value and the bound on its relative error."""

    number: N
    finest: float
    bound: float


class Timed(NamedTuple):
    """Numbers (models, quantities) and the seconds of each run (runs, models, quantities).

    Not a number where a model has no answer. ``whole`` are the seconds of all quantities together
    (runs, models), where that is not their sum because one run gives several.
    """

    values: Floats
    seconds: Floats
    whole: Floats | None = None


def relative_bound(finest: float, control: float, tolerance: float) -> float | None:
    """Return the error of a value that another route controls; nothing where both are unsure."""
    apart = abs(finest - control)
    # written so that what is not a number is unsure too
    if finest == 0.0 or not apart <= UNSURE * abs(finest):
        return None
    return apart / abs(finest) + tolerance


def compared(
    settled: Sequence[Reference[N]],
    models: Sequence[Named],
    times: Timed,
    asked: float,
    unsettled: tuple[str, ...] = (),
) -> AccuracyResult:
    """Return errors against the finest, the Pareto sets, and the cheapest within what is asked."""
    names = [model.name for model in models]
    finest = np.array([each.finest for each in settled])
    bound = np.array([each.bound for each in settled])
    missing = np.isnan(times.values)
    errors = np.where(missing, inf, np.abs(times.values - finest) / np.abs(finest))
    # below the finest's own error models cannot be told apart
    sure = np.maximum(errors, bound)
    seconds = np.where(missing, inf, times.seconds)
    quantities = tuple(
        _quantity(each, names, times.values[:, j], errors[:, j], seconds[:, :, j], asked)
        for j, each in enumerate(settled)
    )
    together = seconds.sum(axis=2) if times.whole is None else times.whole
    whole = np.where(missing.any(axis=1), inf, together)
    worst = sure.max(axis=1)
    middle = np.median(whole, axis=0)
    front = pareto(worst.tolist(), middle.tolist())
    accuracies = tuple(
        ModelAccuracy(
            name,
            float(errors[i].max()),
            float(middle[i]),
            float(whole[:, i].min()),
            float(whole[:, i].max()),
            front[i],
            tuple(each.number.name for each, gone in zip(settled, missing[i], strict=True) if gone),
        )
        for i, name in enumerate(names)
    )
    meets = np.all(errors + bound <= asked, axis=1)
    return AccuracyResult(
        accuracy=asked,
        runs=times.seconds.shape[0],
        finest=names[-1],
        quantities=quantities,
        models=accuracies,
        recommended=_cheapest(names, meets, whole),
        unsettled=unsettled,
    )


def _quantity(
    each: Reference[N], names: Sequence[str], values: Floats, errors: Floats, seconds: Floats,
    asked: float,
) -> QuantityAccuracy:  # fmt: skip
    middle = np.median(seconds, axis=0)
    front = pareto(np.maximum(errors, each.bound).tolist(), middle.tolist())
    readings = tuple(
        Reading(
            name,
            float(values[i]),
            float(errors[i]),
            float(middle[i]),
            float(seconds[:, i].min()),
            float(seconds[:, i].max()),
            front[i],
        )
        for i, name in enumerate(names)
        if errors[i] < inf
    )
    number = each.number
    recommended = _cheapest(names, errors + each.bound <= asked, seconds)
    return QuantityAccuracy(
        number.name, number.label, number.unit, each.finest, each.bound, readings, recommended
    )


def _cheapest(names: Sequence[str], meets: NDArray[np.bool_], seconds: Floats) -> str:
    """Return the cheapest of the models that meet what is asked, by their seconds (runs, models).

    Of those whose times cannot be told apart it is the first: the coarsest.
    """
    if not meets.any():
        return ""
    least = np.min(np.median(seconds, axis=0)[meets])
    alike = meets & (seconds.min(axis=0) <= least)
    return names[int(np.flatnonzero(alike)[0])]
