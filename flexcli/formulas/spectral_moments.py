"""Moments of a stress spectrum, and the rates and bandwidths that follow from them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

__all__ = ["Moments"]

Floats = NDArray[np.float64]
# Rounding in the moments may put a bandwidth parameter this far above its bound of one.
_BANDWIDTH_SLACK = 1e-9


@dataclass(frozen=True, eq=False)
class Moments:
    """Moments m_n = ∫ f^n G df of a one-sided stress density, [Pa² Hz^n].

    Attributes
    ----------
    m0, m1, m2, m4 : arrays that broadcast
        sqrt(m0) is the root-mean-square stress.
    """

    m0: Floats
    m1: Floats
    m2: Floats
    m4: Floats

    def __post_init__(self) -> None:
        for name in ("m0", "m1", "m2", "m4"):
            value = np.asarray(getattr(self, name), dtype=np.float64)
            if not (np.isfinite(value).all() and (value > 0).all()):
                raise ValueError(f"{name} must be positive and finite, got {value}")
            object.__setattr__(self, name, value)
        alpha1_squared = self.m1**2 / (self.m0 * self.m2)
        alpha2_squared = self.m2**2 / (self.m0 * self.m4)
        limit = 1 + _BANDWIDTH_SLACK
        if not ((alpha2_squared <= limit * alpha1_squared) & (alpha1_squared <= limit)).all():
            raise ValueError("no spectrum has these moments: m1² ≤ m0·m2 and m2³ ≤ m1²·m4")

    @property
    def crossing_rate(self) -> Floats:
        """Upward zero crossings per second, ν_0 = sqrt(m_2/m_0) [Hz] (Rice 1945)."""
        return np.sqrt(self.m2 / self.m0)

    @property
    def peak_rate(self) -> Floats:
        """Peaks per second, ν_p = sqrt(m_4/m_2) [Hz]."""
        return np.sqrt(self.m4 / self.m2)

    @property
    def alpha1(self) -> Floats:
        """Bandwidth parameter m_1/sqrt(m_0 m_2), 1 for a single frequency [-]."""
        return np.minimum(1.0, self.m1 / np.sqrt(self.m0 * self.m2))

    @property
    def alpha2(self) -> Floats:
        """Irregularity factor m_2/sqrt(m_0 m_4) = ν_0/ν_p, 1 for a single frequency [-]."""
        return np.minimum(1.0, self.m2 / np.sqrt(self.m0 * self.m4))
