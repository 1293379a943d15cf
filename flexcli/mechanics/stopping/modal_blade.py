"""A blade as natural modes: what its base, its tip and a stop along it see of them."""

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

__all__ = ["ModalBlade"]

Floats = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class ModalBlade:
    """Modes of unit modal mass, motion relative to the base; each array has shape (modes,).

    ``angular`` [rad/s] and ``damping`` (share of critical) rule each mode. Per unit of modal
    coordinate, ``tip`` and ``stop`` are the deflections there and ``base_moment`` the moment at
    the clamp; ``base`` is the force per (negative) acceleration of the base.

    What the left-out modes do at once is kept as compliance to a force at the stop:
    ``stop_residual`` [m/N] at the stop, ``tip_residual`` [m/N] at the tip, ``moment_residual``
    [N·m/N] at the clamp.
    """

    angular: Floats
    damping: Floats
    base: Floats
    tip: Floats
    stop: Floats
    base_moment: Floats
    stop_residual: float = 0.0
    tip_residual: float = 0.0
    moment_residual: float = 0.0

    @property
    def stiffness(self) -> Floats:
        """The modal stiffness matrix [1/s²]."""
        return np.diag(self.angular**2)

    @property
    def damper(self) -> Floats:
        """The modal damping matrix [1/s]."""
        return np.diag(2.0 * self.damping * self.angular)

    def truncated(self) -> "ModalBlade":
        """Return the blade without what the left-out modes do."""
        return replace(self, stop_residual=0.0, tip_residual=0.0, moment_residual=0.0)
