"""What a formula of this package computes with."""

from typing import Any, TypeAlias

__all__ = ["Quantity"]

Quantity: TypeAlias = Any
"""A float, a NumPy array that broadcasts, or a ``Signomial`` in the blade's dimensions.

The formulas use nothing but arithmetic on it, so one definition serves the check of a million
designs (arrays) and the proof of an optimum (signomials).
"""
