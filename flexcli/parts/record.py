"""A recorded acceleration of a base."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Record"]


@dataclass(frozen=True, eq=False)
class Record:
    """Acceleration [m/s²] at equal steps of time [s]."""

    name: str
    step: float
    acceleration: NDArray[np.float64]

    @property
    def duration(self) -> float:
        """Return the time from the first to the last sample [s]."""
        return self.step * (self.acceleration.size - 1)

    @property
    def rms(self) -> float:
        """Return the root mean square of the acceleration [m/s²]."""
        return float(np.sqrt(np.mean(self.acceleration**2)))
