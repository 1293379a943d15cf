"""Buckling of a stage whose parallel blades are pulled: its body turns over."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.quantity import Numbers

__all__ = ["CARDS", "overturning_tension"]

Floats = NDArray[np.float64]

_HALVINGS = 54
"""Halvings of an interval that leave rounding."""


def overturning_tension(*, upright: Numbers, xi: Numbers = 1.0, across: bool) -> Floats:
    """Return the tension of a blade at which a stage that is pulled turns over, in units EI/l².

    ``k(n) − n/2 + U = 0`` where the body may move across the force, ``k(n) − n/4 + U = 0`` where
    it turns about its point; U = EA r²/(2 l_c) over EI/l, ``12 r²/(h² ξ)``. With q = √n and
    t = tanh(ξ q/2) ``k = q (t + 1/t + (1 − ξ) q)/(2 + (1 − ξ) q t)`` of a blade whose end bears no
    force across the tension, ``k = q/(2 t)`` of one that is bent evenly.

    Parameters
    ----------
    upright : Numbers
        U, what the stretching of the blades holds against the turning of the body [EI/l per blade].
    xi : Numbers
        Share of a blade's length that bends, 2 l_c/l; 1 for a plain blade [-].
    across : bool
        Whether the body is held across the force.

    Returns
    -------
    n : array
        Tension of each blade [EI/l²].

    Notes
    -----
    The force acts at half the height of the blades, half their length behind the ends that they
    are pulled by: n/2 of it turns the body further. What a blade holds grows by n/3 at most, by
    n/12 bent evenly, so that the root is between twice and six times 1/ξ + U. Slender hinges:
    their shear and their stretching lower it (``PULLED`` in ``parts.geometries.joint_buckling``).

    Raises
    ------
    ValueError
        When ``upright`` or ``xi`` is not above 0, or ``xi`` above 1.

    Examples
    --------
    >>> n = overturning_tension(upright=1e6, across=False)
    >>> f"{float(n) / 2e6:.3f} {float(overturning_tension(upright=1e6, across=True)) / 4e6:.3f}"
    '1.001 1.001'

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 1.11 (bars under tension).

    """
    U, share = positive(upright=upright, xi=xi)
    if (share > 1.0).any():
        raise ValueError(f"xi must be at most 1, got {share}")
    rest = 1.0 / share + U
    low, high = 2.0 * rest, 6.0 * rest
    for _ in range(_HALVINGS):
        n = (low + high) / 2.0
        q = np.sqrt(n)
        t, c = np.tanh(share * q / 2.0), (1.0 - share) * q
        free = q * (t + 1.0 / t + c) / (2.0 + c * t) - n / 2.0
        stands = (q / (2.0 * t) - n / 4.0 if across else free) + U > 0.0
        low, high = np.where(stands, n, low), np.where(stands, high, n)
    return np.asarray((low + high) / 2.0)


CARDS = (
    Card(
        "stage-buckling-pulled",
        overturning_tension,
        {"upright": 1200.0, "xi": 1.0, "across": False},
        (SLENDER, Range("xi", 0.0, 1.0, "two hinges make up at most the whole blade")),
    ),
)
