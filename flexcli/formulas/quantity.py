"""The type of number that formulas take and return: a float, an array or a signomial."""

from typing import Any, Protocol, TypeAlias

import numpy as np
from numpy.typing import NDArray

__all__ = ["Computed", "Numbers", "Quantity"]


class Quantity(Protocol):
    """A float, a NumPy array that broadcasts, or a ``Signomial`` in the blade's dimensions.

    The formulas use nothing but arithmetic on it, so one definition serves the check of a million
    designs (arrays) and the proof of an optimum (signomials). A word or a list is none.
    """

    def __add__(self, other: Any, /) -> Any:
        """Return the sum."""

    def __radd__(self, other: Any, /) -> Any:
        """Return the sum."""

    def __sub__(self, other: Any, /) -> Any:
        """Return the difference."""

    def __rsub__(self, other: Any, /) -> Any:
        """Return the difference."""

    def __mul__(self, other: Any, /) -> Any:
        """Return the product."""

    def __rmul__(self, other: Any, /) -> Any:
        """Return the product."""

    def __truediv__(self, other: Any, /) -> Any:
        """Return the quotient."""

    def __rtruediv__(self, other: Any, /) -> Any:
        """Return the quotient."""

    def __pow__(self, other: Any, /) -> Any:
        """Return the power."""

    def __neg__(self) -> Any:
        """Return the negative."""


Computed: TypeAlias = Any
"""What a formula makes of quantities: the same kind as they are."""

Numbers: TypeAlias = float | NDArray[np.float64]
"""What a formula takes that needs more than arithmetic, such as a sine: no signomial."""
