"""Utilisation, demand over capacity, as a logarithm that is finite for any sign of both."""

import numpy as np
from numpy.typing import ArrayLike, NDArray

__all__ = ["log_utilisation"]

JOINT = float(np.exp(-1.5))
"""Utilisation below which the logarithm is continued, far below the limit of one."""
TOP = 30.0
"""Largest logarithm of a demand over a positive capacity; above it lie those without capacity."""


def log_utilisation(demand: ArrayLike, capacity: ArrayLike) -> NDArray[np.float64]:
    """Return ln(demand/capacity), continued to demands and capacities that are not positive.

    ``f = ln u`` for u = demand/capacity ≥ u₀, below it ``f = ln u₀ + asinh(u/u₀ − 1)``.

    The continuation has the same value and slope at u₀ = exp(−1.5) and falls like a logarithm of
    −u for large negative u, so that a stress that changes its sign leaves no pole. Without a
    positive capacity the value lies above that of every positive one and grows with the lack.

    Parameters
    ----------
    demand, capacity : array
        Both in one unit, of any sign.

    Returns
    -------
    f : array
        At most 0 where demand ≤ capacity [-].

    Notes
    -----
    Holds for all finite values. A demand at most 0 counts as met, whatever the capacity.

    Raises
    ------
    FloatingPointError
        Never; what is not a number stays so.

    Examples
    --------
    >>> [round(float(f), 3) for f in log_utilisation([1.0, 2.0, 0.0, 1.0], [1.0, 1.0, 1.0, -1.0])]
    [0.0, 0.693, -2.381, 30.881]

    """
    above, below = np.broadcast_arrays(
        np.asarray(demand, dtype=np.float64), np.asarray(capacity, dtype=np.float64)
    )
    with np.errstate(divide="ignore", invalid="ignore", over="ignore"):
        u = np.where(below > 0.0, above / below, np.where(above > 0.0, np.inf, 0.0))
        u = np.where(np.isnan(above) | np.isnan(below), np.nan, u)
        lack = np.where((below <= 0.0) & (above > 0.0), np.arcsinh(-below / above), 0.0)
        plain = np.minimum(np.log(np.maximum(u, JOINT)), TOP)
        continued = np.log(JOINT) + np.arcsinh(np.minimum(u, JOINT) / JOINT - 1.0)
    return np.asarray(np.where(u >= JOINT, plain + lack, continued))
