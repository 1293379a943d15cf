"""The height of a stage that balancing leaves free, chosen together with the blades."""

from collections.abc import Callable
from functools import cache
from math import inf

import numpy as np

from flexcli.parts.design import DesignSpec
from flexcli.parts.mechanisms.free_value import Free
from flexcli.parts.mechanisms.parallel_stage import ParallelStage

__all__ = ["best_height", "with_height"]

PLACES = 17
"""Heights tried over the range before the best stretch is searched more closely."""

CLOSE = 1e-6
"""Width of the last stretch, as a share of the range."""


def with_height(design: DesignSpec, height: float) -> DesignSpec:
    """Return a design on a stage of a given height [m], its balancing masses solved anew."""
    assert isinstance(design.mechanism, ParallelStage)
    mechanism = design.mechanism.model_copy(update={"stated_height": height})
    mechanism.__dict__.pop("balancing", None)  # that of the height before
    return design.model_copy(update={"mechanism": mechanism})


def best_height(design: DesignSpec, merit: Callable[[DesignSpec], float | None]) -> float | None:
    """Return the balanced height [m] of the least merit, where the spec leaves a choice of it.

    Parameters
    ----------
    design : DesignSpec
        The design; a height that is free between bounds, beside another unknown, leaves a choice.
    merit : callable
        What the design of a height is worth, the less the better; nothing where there is none.

    """
    stage = design.mechanism
    if not isinstance(stage, ParallelStage) or not isinstance(stage.stated_height, Free):
        return None
    least, most = stage.stated_height
    if least is None or most is None or len(stage.balancing.unknowns) < 2:
        return None

    @cache
    def worth(height: float) -> float:
        tried = with_height(design, height)
        assert isinstance(tried.mechanism, ParallelStage)
        found = merit(tried) if tried.mechanism.balancing.met else None
        return inf if found is None else found

    places = [float(x) for x in np.linspace(least, most, PLACES)]
    at = min(places, key=worth)
    if worth(at) == inf:
        return None
    step = (most - least) / (PLACES - 1)
    while step > CLOSE * (most - least):
        step /= 2.0
        near = (max(at - step, least), at, min(at + step, most))
        at = min(near, key=worth)
    return at
