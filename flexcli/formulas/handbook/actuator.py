"""A piezo actuator against the flexures that it moves: stroke, force, and what heat adds.

Its force falls on a straight line from the blocking force at rest to zero at the free stroke.
"""

from typing import NamedTuple

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Computed, Numbers

__all__ = ["CARDS", "Drive", "actuator_stroke", "drive_for_frequency", "thermal_stroke"]


class Drive(NamedTuple):
    """Stiffness of the actuator [N/m], stroke that it reaches [m] and its force there [N]."""

    k_T: Computed  # noqa: N815 - the source's symbol
    stroke: Computed
    force: Computed


def actuator_stroke(*, F_b: Numbers, s_0: Numbers, k: Numbers) -> Drive:
    """Return how far an actuator moves a flexure.

    ``k_T = F_b/s_0, s = s_0 k_T/(k_T + k), F = k s``.

    Parameters
    ----------
    F_b : Quantity
        Blocking force: that of the actuator held at rest [N].
    s_0 : Quantity
        Free stroke: that without any load [m].
    k : Quantity
        Stiffness of the flexures along the stroke [N/m].

    Returns
    -------
    Drive
        Stiffness of the actuator [N/m], stroke reached [m], force there [N].

    Examples
    --------
    >>> found = actuator_stroke(F_b=5.5, s_0=85e-6, k=31.8e3)
    >>> round(found.k_T), round(found.stroke * 1e6)
    (64706, 57)

    References
    ----------
    Monti (2014), section 2.1.2, ``F_max = k_T ΔL_0``; the stroke from the balance of both springs.

    """
    blocked, free, stiffness = positive(F_b=F_b, s_0=s_0, k=k)
    k_T = blocked / free
    stroke = blocked / (k_T + stiffness)
    return Drive(k_T, stroke, stiffness * stroke)


def drive_for_frequency(*, F: Numbers, ratio: Numbers) -> Computed:
    """Return the force for the same stroke of a stage whose frequency is a ratio higher.

    ``F' = F r²``: at a given mass the stiffness grows with the square of the frequency.

    Parameters
    ----------
    F : Quantity
        Force at the end of the stroke now [N].
    ratio : Quantity
        Natural frequency then over that now [-].

    Returns
    -------
    Quantity
        Force then [N].

    Examples
    --------
    >>> float(drive_for_frequency(F=1.2, ratio=2.0))
    4.8

    References
    ----------
    Monti (2014), section 2.2 and figure 2.9.

    """
    force, higher = positive(F=F, ratio=ratio)
    return force * higher**2


def thermal_stroke(
    *,
    alpha: Numbers,
    alpha_frame: Numbers,
    L: Numbers,
    dT: Numbers,
    k_T: Numbers,
    k: Numbers,
) -> Computed:
    """Return how far a change of temperature moves a stage that an actuator holds.

    ``s = (α − α_f) L ΔT k_T/(k_T + k)``: the actuator and the frame beside it expand, and the
    flexures press the difference back.

    Parameters
    ----------
    alpha, alpha_frame : Quantity
        Thermal expansion of the actuator along its stroke, and of the frame beside it [1/K].
    L : Quantity
        Length of the actuator along its stroke [m].
    dT : Quantity
        Change of temperature, the same everywhere [K].
    k_T, k : Quantity
        Stiffness of the actuator and of the flexures along the stroke [N/m].

    Returns
    -------
    Quantity
        Motion of the stage [m].

    Notes
    -----
    A bender of two like layers has no such stroke: its two faces expand alike.

    Examples
    --------
    >>> s = thermal_stroke(alpha=-5e-6, alpha_frame=23.6e-6, L=20e-3, dT=20.0, k_T=60e6, k=4e6)
    >>> round(float(s) * 1e6, 2)
    -10.72

    References
    ----------
    Free expansion against two springs in series; any text on thermal stress, e.g. Timoshenko &
    Goodier (1970), chapter 13.

    """
    length, actuator, flexures = positive(L=L, k_T=k_T, k=k)
    return (alpha - alpha_frame) * length * dT * actuator / (actuator + flexures)


CARDS: tuple[Card, ...] = (
    Card("actuator-stroke", actuator_stroke, {"F_b": 5.5, "s_0": 85e-6, "k": 31.8e3}),
    Card("drive-for-frequency", drive_for_frequency, {"F": 1.2, "ratio": 2.0}),
    Card(
        "thermal-stroke",
        thermal_stroke,
        {"alpha": -5e-6, "alpha_frame": 23.6e-6, "L": 20e-3, "dT": 20.0, "k_T": 60e6, "k": 4e6},
    ),
)
