"""The dimensionless numbers of a cantilever that vibrates between two stops.

δ_O is the whole range of the tip's motion (twice its amplitude), δ_G the gap on each side.
"""

from typing import NamedTuple

from flexcli.formulas.card import Card
from flexcli.formulas.quantity import Quantity

__all__ = ["CARDS", "PiTerms", "pi_terms"]


class PiTerms(NamedTuple):
    """The five dimensionless numbers of a blade that vibrates between stops [-]."""

    pi_1: Quantity
    pi_2: Quantity
    pi_3: Quantity
    pi_4: Quantity
    pi_5: Quantity


def pi_terms(
    *,
    m: Quantity,
    k_free: Quantity,
    k_contact: Quantity,
    delta_G: Quantity,
    f_D: Quantity,
    delta_D: Quantity,
    f_O: Quantity,
    delta_O: Quantity,
) -> PiTerms:
    """Return the five Pi terms of a cantilever that vibrates between stops.

    ``π1 = k_contact/k_free, π2 = f_D √(m/k_free), π3 = δ_D/δ_G, π4 = f_O √(m/k_free),
    π5 = δ_O/δ_G``.

    Parameters
    ----------
    m : Quantity
        Mass at the tip [kg].
    k_free, k_contact : Quantity
        Stiffness at the tip, free and on the stop [N/m].
    delta_G : Quantity
        Gap on each side [m].
    f_D, f_O : Quantity
        Frequency of the base and of the tip [Hz].
    delta_D, delta_O : Quantity
        Whole range of the base's and of the tip's motion [m].

    Returns
    -------
    PiTerms
        The terms [-].

    Notes
    -----
    In SI a blade without offset of its mass has π2 = 1/2π in resonance. The source's screens
    show π2 and π4 a thousand times greater, for they mix g with N/mm.

    Examples
    --------
    >>> terms = pi_terms(m=15.35e-3, k_free=4629.33, k_contact=46293.3, delta_G=1e-5,
    ...                  f_D=53.0, delta_D=1e-6, f_O=53.0, delta_O=5e-5)
    >>> [round(term, 4) for term in terms]
    [10.0, 0.0965, 0.1, 0.0965, 5.0]

    References
    ----------
    Monti (2014), table 5.2.

    """
    inertia = (m / k_free) ** 0.5
    return PiTerms(
        pi_1=k_contact / k_free,
        pi_2=f_D * inertia,
        pi_3=delta_D / delta_G,
        pi_4=f_O * inertia,
        pi_5=delta_O / delta_G,
    )


CARDS: tuple[Card, ...] = (
    Card(
        "stop-pi-terms",
        pi_terms,
        {"m": 15.35e-3, "k_free": 4629.33, "k_contact": 46293.3, "delta_G": 1e-5}
        | {"f_D": 53.0, "delta_D": 1e-6, "f_O": 53.0, "delta_O": 5e-5},
    ),
)
