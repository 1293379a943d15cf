"""Checks of arguments that several formulas share."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["basquin", "positive"]


def positive(**values: ArrayLike) -> list[NDArray[np.float64]]:
    """Return the arrays, or name the one that has a value not positive and finite."""
    arrays = []
    for name, value in values.items():
        array = np.asarray(value, dtype=np.float64)
        if not (np.isfinite(array).all() and (array > 0).all()):
            raise ValueError(f"{name} must be positive and finite, got {array}")
        arrays.append(array)
    return arrays


def basquin(k: ArrayLike, C: ArrayLike) -> list[NDArray[np.float64]]:
    """Return exponent and constant of a life curve N = C a^(−k) as arrays, or refuse them."""
    return positive(**{"the exponent k": k, "the constant C": C})
