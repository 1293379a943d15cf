"""The tip's range over the gap along the operating line: as measured, and at resonance in time."""

from collections.abc import Callable, Iterator
from math import inf

import numpy as np

from flexcli.engine.stopping.choice import measured_heights, on_line
from flexcli.engine.stopping.scene import stop_scene
from flexcli.engine.stopping.statics import StopTask
from flexcli.mechanics.stopping.response import stepped_motion
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.results.stops import StopRatio

__all__ = ["ratios"]

COUNT = 9
"""Heights over which the line is shown, from end to end of where it was measured."""


def ratios(
    design: DesignSpec,
    task: StopTask,
    sizes: Sizes,
    case: str,
    acceleration: float,
    goes_on: Callable[[], bool],
) -> Iterator[StopRatio]:
    """Yield π5 over π1 for stops on the line: a rigid stop, the base at the free blade's frequency.

    The steady motion that a blade at rest comes to; without it where there is none, or no contact.
    """
    for height in np.linspace(*measured_heights(task), COUNT):
        if not goes_on():
            return
        place = on_line(task, "", float(height))
        blade, stops, _ = stop_scene(design, task, sizes, place, case, head=inf)
        found = stepped_motion(blade, stops, acceleration).follow(float(blade.angular[0]))
        travel = found.peaks.tip_above + found.peaks.tip_below
        touches = found.settled and found.contacts > 0.0
        yield StopRatio(
            place.L_a, place.delta_G, place.pi_1, place.pi_5, place.pi_5_threshold,
            travel / place.delta_G if touches else None,
        )  # fmt: skip
