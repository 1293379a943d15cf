"""Stops on the operating line: where one may stand for a range of the tip, what the blade bears.

δ_O is the whole range of the tip's motion, twice the deflection allowed to one side. The line
gives the gap for a height; statics says whether the tip-loaded blade reaches that stop at all,
and the forces and stresses with the tip at the end of its range.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range
from flexcli.formulas.pi_law import MEASURED, operating_line, ratio_on_line
from flexcli.formulas.quantity import Quantity
from flexcli.formulas.stop_stiffness import bent_shape, height_share, stiffness_ratio
from flexcli.formulas.stopped_cantilever import (
    bending_moment,
    bending_stress,
    contact_load,
    load_at_travel,
    reaction,
)

__all__ = [
    "CARDS",
    "HARD_STOP",
    "REACHED",
    "StopDesign",
    "allowed_travel",
    "line_gap",
    "line_height",
    "stop_design",
]


REACHED = Range(
    "L_a/L", 0.506, 0.894, "where the operating line lies above the quasi-static contact threshold"
)


def allowed_travel(*, E: Quantity, h: Quantity, L: Quantity, sigma: Quantity) -> Quantity:
    """Return the deflection of a tip-loaded cantilever whose base bears a stress.

    ``δ = 2 σ L²/(3 E h)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    h : Quantity
        Thickness [m].
    L : Quantity
        Length [m].
    sigma : Quantity
        Stress at the surface of the base [Pa].

    Returns
    -------
    Quantity
        Deflection of the tip from rest, to one side [m].

    Notes
    -----
    Half the range δ_O of the Pi terms. Free blade: on a stop the blade bends more sharply and
    `stop_design` gives the stress.

    Examples
    --------
    >>> round(allowed_travel(E=60e9, h=1.25e-3, L=28.5e-3, sigma=27.7e6) * 1e6)
    200

    References
    ----------
    Monti (2014), section 9.1.1.

    """
    return 2.0 * sigma * L**2 / (3.0 * E * h)


def line_gap(*, L_a: Quantity, L_b: Quantity, delta_O: Quantity) -> Quantity:
    """Return the gap that keeps the tip to a range, on the operating line.

    ``δ_G = δ_O/π5`` with ``π5 = 10.032 π1^(−0.304)``.

    Parameters
    ----------
    L_a, L_b : Quantity
        Length below and above the stops [m].
    delta_O : Quantity
        Whole range of the tip's motion [m].

    Returns
    -------
    Quantity
        Gap on each side [m].

    Examples
    --------
    >>> round(float(line_gap(L_a=25.65e-3, L_b=2.85e-3, delta_O=200e-6)) * 1e6, 1)
    87.4

    References
    ----------
    Monti (2014), section 9.1.1, equation (III).

    """
    return delta_O / operating_line(stiffness_ratio(L_a=L_a, L_b=L_b))


def line_height(*, d: Quantity, L: Quantity, delta_O: Quantity) -> Quantity:
    """Return the height of the stops that keeps the tip to a range, for a given gap.

    ``L_a = L a(π1)`` with ``π1 = (10.032 d/δ_O)^(1/0.304)``.

    Parameters
    ----------
    d : Quantity
        Gap on each side [m].
    L : Quantity
        Length of the blade [m].
    delta_O : Quantity
        Whole range of the tip's motion [m].

    Returns
    -------
    Quantity
        Height of the stops [m].

    Raises
    ------
    ValueError
        When the gap is below δ_O/10.032: no stop stiffens so little.

    Examples
    --------
    >>> round(float(line_height(d=87.36e-6, L=28.5e-3, delta_O=200e-6)) * 1e3, 2)
    25.65

    References
    ----------
    Monti (2014), section 9.1.1, equation (III) solved for L_a.

    """
    gap, travel = positive(d=d, delta_O=delta_O)
    return L * height_share(ratio_on_line(travel / gap))


_PIEZO = {"L_a": 20e-3, "L_b": 8.5e-3, "delta_O": 200e-6}


HARD_STOP = 0.9
"""Height over length from which the source counts a stop as a hard one."""


@dataclass(frozen=True, eq=False)
class StopDesign:
    """Stops on the operating line with the statics of the tip at the end of its range."""

    gap: Quantity
    """Gap on each side [m]."""
    pi_1: Quantity
    """Stiffness in contact over free stiffness [-]."""
    pi_5: Quantity
    """Range of the tip over the gap [-]."""
    tip_at_contact: Quantity
    """Deflection of the tip when the blade touches [m]; the tip is free up to it."""
    reached: NDArray[np.bool_]
    """Whether the tip-loaded blade touches the stop within the range."""
    hard: NDArray[np.bool_]
    """Whether the source would call it a hard stop."""
    load: Quantity
    """Force that holds the tip at half the range [N]."""
    stop_force: Quantity
    """Force on the stop then [N]."""
    onset_stress: Quantity
    """Bending stress at the base when it touches, or at half the range if it never does [Pa]."""
    base_stress: Quantity
    """Bending stress at the base at half the range [Pa], with its sign."""
    stop_stress: Quantity
    """Bending stress at the stop at half the range [Pa]."""

    def factor(self, sigma: Quantity) -> Quantity:
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


CARDS: tuple[Card, ...] = (
    Card(
        "stop-allowed-travel",
        allowed_travel,
        {"E": 60e9, "h": 1.25e-3, "L": 28.5e-3, "sigma": 27.7e6},
        (Range("L/h", 10.0, why="shear is left out"),),
    ),
    Card("stop-line-gap", line_gap, _PIEZO, (*MEASURED, REACHED)),
    Card(
        "stop-line-height",
        line_height,
        {"d": 44e-6, "L": 28.5e-3, "delta_O": 200e-6},
        (*MEASURED, REACHED),
    ),
    Card(
        "stop-design",
        stop_design,
        {"E": 60e9, "I": 1.2695e-12, "h": 1.25e-3, "L_a": 20e-3, "L_b": 8.5e-3, "delta_O": 2e-4},
        (*MEASURED, REACHED),
    ),
)
