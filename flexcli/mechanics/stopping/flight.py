"""Motion of a blade over many samples of the base at once, as far as nothing can happen."""

from math import inf

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.stopping.laws import Stops
from flexcli.mechanics.stopping.phases import Contact, Output, Phase
from flexcli.numerics.sampled_response import SampledResponse

__all__ = ["Flight"]

Floats = NDArray[np.float64]
Complexes = NDArray[np.complex128]

_FEWEST, _MOST = 16, 4096
"""Steps tried at once: twice as many after a flight that met nothing, half after one that may."""


class Flight:
    """A phase driven by lines between samples a step [s] apart, free or at a stop."""

    def __init__(self, phase: Phase, stops: Stops, step: float) -> None:
        """Prepare the flow, and what stays positive until something happens."""
        self.sampled = SampledResponse(phase.system, phase.drive, step)
        free = [
            Output(-side * phase.deflection.on_y, stops.gap(side))
            for side in (1, -1)
            if stops.gap(side) < inf
        ]
        self._margins = free if phase.contact is Contact.FREE else [phase.force]
        self._count = _FEWEST

    def ahead(self, y: Complexes, a: Floats) -> tuple[Complexes, int]:
        """Return y at samples from the first on, and after how many steps an event may come.

        That many steps are proven free of touch and release; of the next nothing is known.
        """
        count = min(a.size - 1, self._count, self.sampled.most)
        a = a[: count + 1]
        states = self.sampled.at_samples(y, a)
        may_end = np.zeros(count, dtype=np.bool_)
        for row in self._margins:
            margin = row.constant + (row.on_y @ states).real + row.direct * a
            stray = self.sampled.stray(row.on_y, states[:, :-1], a[:-1], a[1:], self.sampled.step)
            may_end |= np.minimum(margin[1:], margin[:-1]) <= stray
        clear = int(np.argmax(may_end)) if may_end.any() else count
        self._count = min(2 * self._count, _MOST) if clear == count else max(clear, _FEWEST)
        return states[:, : clear + 1], clear
