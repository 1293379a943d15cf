"""Impact of elastic bodies: Hertz' exact law, and the source's estimate from a mean deceleration.

Quasi-static contact (no waves), no loss, one contact: the bodies part with the speed they met.
"""

from math import gamma, pi, sqrt
from typing import NamedTuple

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = ["CARDS", "Estimate", "Impact", "hertz_impact", "reduced_mass", "stopping_estimate"]

# ∫₀¹ dx/√(1 − x^(5/2)): the time from contact to rest, in units of greatest approach over speed
_STOPPING = sqrt(pi) * gamma(0.4) / (2.5 * gamma(0.9))


class Impact(NamedTuple):
    """Time to rest and whole contact [s], greatest approach [m] and force [N]."""

    stopping_time: Computed
    duration: Computed
    approach: Computed
    force: Computed


class Estimate(NamedTuple):
    """Time to rest [s] and the mean force over it [N]."""

    stopping_time: Computed
    force: Computed


def reduced_mass(m_1: Quantity, m_2: Quantity) -> Computed:
    """Return the mass with which two free bodies meet.

    ``1/m = 1/m1 + 1/m2``; a body held fast has an infinite mass.

    Parameters
    ----------
    m_1, m_2 : Quantity
        Mass of each body [kg].

    Returns
    -------
    Quantity
        Reduced mass [kg].

    Examples
    --------
    >>> reduced_mass(2.0, 2.0), reduced_mass(0.001, float("inf"))
    (1.0, 0.001)

    References
    ----------
    Two bodies and their centre of mass; any mechanics text, e.g. Landau & Lifshitz (1976), § 13.

    """
    return 1.0 / (1.0 / m_1 + 1.0 / m_2)


def hertz_impact(*, m: Quantity, v: Quantity, R: Quantity, E_star: Quantity) -> Impact:
    """Return the time, approach and force of an elastic impact of a ball.

    ``δ = (5 m v²/(4 K))^(2/5)``, ``F = K δ^(3/2)``, ``t = 2.9433 δ/v`` with ``K = 4/3 E* √R``;
    the factor is ``4 √π Γ(2/5)/(5 Γ(9/10))``.

    Parameters
    ----------
    m : Quantity
        Mass of the ball, or reduced mass of both bodies [kg].
    v : Quantity
        Speed at which they meet [m/s].
    R : Quantity
        Relative radius [m].
    E_star : Quantity
        Contact modulus E* [Pa].

    Returns
    -------
    stopping_time, duration : Quantity
        Time from contact to greatest approach, and twice that [s].
    approach : Quantity
        Greatest approach of the bodies [m].
    force : Quantity
        Greatest force [N].

    Notes
    -----
    Elastic, and v far below the speed of sound, so that the bodies do not ring. The peak
    pressure is that of `point_contact` under the greatest force: check it against yield.

    Examples
    --------
    >>> impact = hertz_impact(m=1e-3, v=1.0, R=1e-3, E_star=70e9)
    >>> round(impact.duration * 1e6, 1), round(impact.stopping_time * 1e6, 1)
    (33.1, 16.5)
    >>> round(impact.force, 1)
    111.2

    References
    ----------
    Johnson (1985), Contact Mechanics, section 11.4.

    """
    stiffness = 4.0 / 3.0 * E_star * R**0.5
    approach = (1.25 * m * v**2 / stiffness) ** 0.4
    stopping = _STOPPING * approach / v
    return Impact(stopping, 2.0 * stopping, approach, stiffness * approach**1.5)


def stopping_estimate(*, m: Quantity, v: Quantity, R: Quantity, E: Quantity) -> Estimate:
    """Return the source's estimate of the time and force that stop a ball.

    ``t^(5/3) = R^(−1/3) (3m/(2E))^(2/3) v^(−1/3)``, ``F = m v/t``: the way v t/2 of an even
    deceleration equals ``½ R^(−1/3) (3F/(2E))^(2/3)`` under the mean force.

    Parameters
    ----------
    m : Quantity
        Mass of the ball [kg].
    v : Quantity
        Speed at contact [m/s].
    R : Quantity
        Radius of the ball [m].
    E : Quantity
        Modulus, as the source puts it in: Young's modulus of the one body [Pa].

    Returns
    -------
    stopping_time : Quantity
        Time from contact to rest [s].
    force : Quantity
        Mean force over that time [N].

    Notes
    -----
    To reproduce the source; size with `hertz_impact`. With the same modulus the exact peak force
    is 1.51 times greater and the exact stopping time 1.22 times longer, whatever m, v, R and E:
    the estimate takes a mean for the peak, and its approach is 2^(−1/3) of Hertz' for a ball on a
    flat (its formula wants the sum of all four curvatures).

    Examples
    --------
    >>> estimate = stopping_estimate(m=1e-3, v=1.0, R=1e-3, E=70e9)
    >>> round(estimate.stopping_time * 1e6, 1), round(estimate.force, 1)
    (13.6, 73.7)

    References
    ----------
    Monti (2014), section 3.1.3, equations (I) to (VI).

    """
    time = (1.5 * m / E) ** 0.4 / (R * v) ** 0.2
    return Estimate(time, m * v / time)


_BALL = {"m": 1e-3, "v": 1.0, "R": 1e-3}

CARDS: tuple[Card, ...] = (
    Card("reduced-mass", reduced_mass, {"m_1": 1e-3, "m_2": 1e-2}),
    Card(
        "hertz-impact",
        hertz_impact,
        {**_BALL, "E_star": 70e9},
        (Range("v/c", most=0.01, why="slow against sound, so that the bodies do not ring"),),
    ),
    Card("impact-stopping-estimate", stopping_estimate, {**_BALL, "E": 70e9}),
)
