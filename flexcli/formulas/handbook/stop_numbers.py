"""A stopped cantilever in numbers: Pi terms, deflection, a stop on the operating line."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Card, Range
from flexcli.formulas.pi_law import MEASURED, operating_line
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.stop_line import HARD_STOP, REACHED
from flexcli.formulas.stop_stiffness import (
    bent_shape,
    stiffness_ratio,
)
from flexcli.formulas.stopped_cantilever import (
    bending_moment,
    bending_stress,
    contact_load,
    load_at_travel,
    reaction,
)

__all__ = ["CARDS", "PiTerms", "StopDesign", "deflection", "pi_terms", "stop_design"]


class PiTerms(NamedTuple):
    """The five dimensionless numbers of a blade that vibrates between stops [-]."""

    pi_1: Computed
    pi_2: Computed
    pi_3: Computed
    pi_4: Computed
    pi_5: Computed


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


def _of_force(force: Numbers, at: Numbers, x: Numbers, rigidity: Numbers) -> Computed:
    """Return the deflection at x of a cantilever under one lateral force at a height."""
    near = np.minimum(x, at)
    # straight beyond the force: slope of the bent part times the rest of the way
    bent = force * near**2 * (3.0 * at - near) / (6.0 * rigidity)
    return bent + force * near * (2.0 * at - near) / (2.0 * rigidity) * (x - near)


def deflection(
    *,
    x: Numbers,
    F: Numbers,
    E: Numbers,
    I: Numbers,
    L_a: Numbers,
    L_b: Numbers,
    d: Numbers,
    d_behind: Numbers = np.inf,
) -> Computed:
    """Return the deflection at height x of a cantilever that may rest on a stop.

    ``δ(x) = δ_F(x) + δ_R(x)``: superposed cantilevers under F at the tip and R at L_a, each
    ``P x² (3s − x)/(6EI)`` up to its force at s and straight beyond.

    Parameters
    ----------
    x : Quantity
        Height above the clamped end [m], 0 ≤ x ≤ L; L gives the tip.
    F : Quantity
        Force at the tip [N].
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    L_a, L_b : Quantity
        Length below and above the stops [m].
    d, d_behind : Quantity
        Gap on the side of + and of − [m]; infinite for no stop.

    Returns
    -------
    Quantity
        Deflection [m].

    Raises
    ------
    ValueError
        When a gap is negative.

    Examples
    --------
    >>> blade = {"E": 6.0, "I": 1.0, "L_a": 1.0, "L_b": 1.0, "d": 0.5}
    >>> round(float(deflection(x=1.0, F=9.0, **blade)), 12)
    0.5

    References
    ----------
    Monti (2014), section 4.1.3, step 8 and the equations for any x below it.

    """
    force = reaction(F=F, E=E, I=I, L_a=L_a, L_b=L_b, d=d, d_behind=d_behind)
    return _of_force(F, L_a + L_b, x, E * I) + _of_force(force, L_a, x, E * I)


@dataclass(frozen=True, eq=False)
class StopDesign:
    """Stops on the operating line with the statics of the tip at the end of its range."""

    gap: Computed
    """Gap on each side [m]."""
    pi_1: Computed
    """Stiffness in contact over free stiffness [-]."""
    pi_5: Computed
    """Range of the tip over the gap [-]."""
    tip_at_contact: Computed
    """Deflection of the tip when the blade touches [m]; the tip is free up to it."""
    reached: NDArray[np.bool_]
    """Whether the tip-loaded blade touches the stop within the range."""
    hard: NDArray[np.bool_]
    """Whether the source would call it a hard stop."""
    load: Computed
    """Force that holds the tip at half the range [N]."""
    stop_force: Computed
    """Force on the stop then [N]."""
    onset_stress: Computed
    """Bending stress at the base when it touches, or at half the range if it never does [Pa]."""
    base_stress: Computed
    """Bending stress at the base at half the range [Pa], with its sign."""
    stop_stress: Computed
    """Bending stress at the stop at half the range [Pa]."""

    def factor(self, sigma: Numbers) -> Computed:
        """Return the safety factor of bending against a stress [Pa]: the worst place decides."""
        worst = np.maximum(self.onset_stress, np.abs(self.base_stress))
        return sigma / np.maximum(worst, self.stop_stress)


def stop_design(
    *, E: Quantity, I: Quantity, h: Quantity, L_a: Quantity, L_b: Quantity, delta_O: Quantity
) -> StopDesign:
    """Return the stops at height L_a that keep the tip to a range, with what the blade bears.

    ``δ_G = δ_O/π5(π1)``; stresses of the tip-loaded blade on its stop with the tip at δ_O/2.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area [m⁴].
    h : Quantity
        Thickness [m].
    L_a, L_b : Quantity
        Length below and above the stops [m].
    delta_O : Quantity
        Whole range of the tip's motion [m], twice the allowed deflection.

    Returns
    -------
    StopDesign
        Gap, Pi terms, forces and stresses.

    Notes
    -----
    The stresses belong to a force at the tip that moves slowly; a contact adds its shock. Where
    `reached` is false the line contradicts that shape and only the gap is the source's.

    Examples
    --------
    >>> design = stop_design(
    ...     E=60e9, I=1.2695e-12, h=1.25e-3, L_a=20e-3, L_b=8.5e-3, delta_O=200e-6)
    >>> round(float(design.gap) * 1e6, 1), round(float(design.tip_at_contact) * 1e6, 1)
    (44.1, 78.0)
    >>> round(float(design.factor(55.4e6)), 1)
    3.5

    References
    ----------
    Monti (2014), sections 8.5 and 9.1.

    """
    pi_1 = stiffness_ratio(L_a=L_a, L_b=L_b)
    pi_5 = operating_line(pi_1)
    gap = delta_O / pi_5
    share = L_a / (L_a + L_b)
    tip = gap / bent_shape(share)
    beam = {"E": E, "I": I, "L_a": L_a, "L_b": L_b, "d": gap}
    load = load_at_travel(delta=delta_O / 2.0, **beam)
    onset = np.minimum(contact_load(**beam), load) * (L_a + L_b)
    base = bending_moment(x=0.0, F=load, **beam)
    return StopDesign(
        gap=gap,
        pi_1=pi_1,
        pi_5=pi_5,
        tip_at_contact=tip,
        reached=np.asarray(tip <= delta_O / 2.0),
        hard=np.asarray(share >= HARD_STOP),
        load=load,
        stop_force=-reaction(F=load, **beam),
        onset_stress=bending_stress(M=onset, I=I, h=h),
        base_stress=bending_stress(M=base, I=I, h=h),
        stop_stress=bending_stress(M=load * L_b, I=I, h=h),
    )


_PUSHED = {"F": 3.0, "E": 60e9, "I": 1.2695e-12, "L_a": 14.25e-3, "L_b": 14.25e-3, "d": 30e-6}
_SMALL = (Range("delta/L", -0.1, 0.1, "small rotation"),)

CARDS: tuple[Card, ...] = (
    Card(
        "stop-pi-terms",
        pi_terms,
        {"m": 15.35e-3, "k_free": 4629.33, "k_contact": 46293.3, "delta_G": 1e-5}
        | {"f_D": 53.0, "delta_D": 1e-6, "f_O": 53.0, "delta_O": 5e-5},
    ),
    Card("stopped-cantilever-deflection", deflection, {"x": 28.5e-3, **_PUSHED}, _SMALL),
    Card(
        "stop-design",
        stop_design,
        {"E": 60e9, "I": 1.2695e-12, "h": 1.25e-3, "L_a": 20e-3, "L_b": 8.5e-3, "delta_O": 2e-4},
        (*MEASURED, REACHED),
    ),
)
