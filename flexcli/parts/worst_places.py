"""The places of a blade that may be the worst under a stroke, whatever the mean stress counts."""

import numpy as np
from numpy.typing import NDArray

__all__ = ["worst_places"]

Floats = NDArray[np.float64]

WEIGHTS = (0.0, 0.1, 0.2, 0.35, 0.5, 0.75, 1.0)
"""Of the mean stress beside the amplitude: strength over what the mean is compared with."""


def worst_places(amplitude: Floats, mean: Floats) -> list[NDArray[np.intp]]:
    """Return where the stress, its amplitude or what stands for both is largest.

    Between the greatest amplitude and the greatest tension lies what a mean stress method may find
    the worst: a few weights of the mean find it. Compression earns nothing, and where two places
    are alike but for its sign, the stretched one counts.

    Parameters
    ----------
    amplitude, mean : array, shape (..., places)
        Of the stress at every place, the mean positive in tension [Pa].

    Returns
    -------
    list of array, shape (...)
        Places, some of them more than once.

    """
    sought = [amplitude + np.abs(mean)]
    sought += [amplitude + weight * np.maximum(mean, 0.0) for weight in WEIGHTS]
    return [np.asarray(np.argmax(each, axis=-1)) for each in sought]
