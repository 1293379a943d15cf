"""The empirical law of a vibrating cantilever between two stops, in dimensionless numbers.

δ_O is the whole range of the tip's motion (twice its amplitude), δ_G the gap on each side.
"""

import numpy as np

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.quantity import Computed, Numbers
from flexcli.formulas.stop_stiffness import bent_shape, stiffness_ratio

__all__ = [
    "CARDS",
    "MEASURED",
    "SCATTER",
    "contact_threshold",
    "operating_line",
    "ratio_on_line",
]


FACTOR, EXPONENT = 10.032, -0.304
SCATTER = 0.068
"""Largest standard error of the fit (relative), at pi_1 = 5.77; below 0.03 elsewhere."""

MEASURED = (
    Range("pi_1", 5.0, 250.0, "the range of k_contact/k_free of the measured stops"),
    Range("pi_5", 2.0, why="the tip travels at least to the gap on both sides: below 2 (the line "
          "beyond pi_1 = 201) no contact exists with a rigid stop"),
    Range("gap/free range", 0.03, why="below it the measured ratio was erratic"),
    Range("modes", 1.0, 1.0, "only the first mode was excited, by a sine at its frequency"),
)  # fmt: skip
"""Conditions of the tests behind the operating line: sine at the free frequency, ball stops."""


def operating_line(pi_1: Numbers) -> Computed:
    """Return the measured range of the tip over the gap, for a stop that stiffens π1 times.

    ``π5 = 10.032 π1^(−0.304)``, the fit to resonant tests of four blades.

    Parameters
    ----------
    pi_1 : Quantity
        k_contact/k_free [-].

    Returns
    -------
    Quantity
        Whole range of the tip over the gap on one side, π5 [-].

    Raises
    ------
    ValueError
        When π1 is not positive and finite.

    Notes
    -----
    Empirical, for π1 from 5 to 250 and the conditions of `MEASURED`; standard error 6.8 % at
    π1 = 5.77, below 3 % elsewhere. It is the source's line at the tip of the blade ("offset").

    Examples
    --------
    >>> round(float(operating_line(129.0)), 2)
    2.29

    References
    ----------
    Monti (2014), section 8.4, equation of y_offset.

    """
    (ratio,) = positive(pi_1=pi_1)
    return FACTOR * ratio**EXPONENT


def ratio_on_line(pi_5: Numbers) -> Computed:
    """Return the stiffness ratio at which the operating line gives a range over gap.

    ``π1 = (π5/10.032)^(−1/0.304)``.

    Parameters
    ----------
    pi_5 : Quantity
        Whole range of the tip over the gap on one side [-].

    Returns
    -------
    Quantity
        k_contact/k_free [-]; below 1 no stop has it.

    Raises
    ------
    ValueError
        When π5 is not positive and finite.

    Examples
    --------
    >>> round(float(ratio_on_line(2.29)))
    129

    References
    ----------
    Monti (2014), section 8.4, solved for π1.

    """
    (ratio,) = positive(pi_5=pi_5)
    return (ratio / FACTOR) ** (1.0 / EXPONENT)


def contact_threshold(share: Numbers) -> Computed:
    """Return the range of the tip over the gap below which a tip-loaded blade meets no stop.

    ``π5 = 2/φ(a) = 4/(a² (3 − a))`` with ``a = L_a/L``: at the instant of contact the blade
    still has the shape φ that a force at its tip bends it to.

    Parameters
    ----------
    share : Quantity
        Height of the stop over the blade's length, a [-], 0 < a ≤ 1.

    Returns
    -------
    Quantity
        Whole range of the tip over the gap on one side, π5 [-].

    Raises
    ------
    ValueError
        When a is not positive.

    Notes
    -----
    The operating line lies above it only for a from 0.506 to 0.894 (π1 from 4.7 to 114):
    elsewhere the line asks for a contact that this shape does not make. A mass that sits beyond
    the blade's end or turns bends it to another shape, with a lower threshold.

    Examples
    --------
    >>> float(contact_threshold(1.0)), float(contact_threshold(0.5))
    (2.0, 6.4)

    References
    ----------
    From the shape of a cantilever under a tip force,
    :func:`flexcli.formulas.stop_stiffness.bent_shape`.

    """
    (height,) = positive(share=share)
    return 2.0 / bent_shape(height)


def _line_at(share: float) -> float:
    return float(operating_line(stiffness_ratio(L_a=share, L_b=1.0 - share)))


_HEIGHTS = Table(
    variable="L_a/L",
    values=tuple(float(a) for a in np.linspace(0.4, 0.9, 6)),
    columns={
        "operating line": ("", _line_at),
        "contact threshold": ("", lambda a: float(contact_threshold(a))),
    },
    note="the line below the threshold asks for a contact that a tip-loaded blade does not make",
)


CARDS: tuple[Card, ...] = (
    Card("stop-operating-line", operating_line, {"pi_1": 129.0}, MEASURED, {"heights": _HEIGHTS}),
    Card("stop-ratio-on-line", ratio_on_line, {"pi_5": 2.29}, MEASURED),
    Card("stop-contact-threshold", contact_threshold, {"share": 0.9}, (Range("L_a/L", 0.0, 1.0),)),
)
