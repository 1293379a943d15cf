"""Stops on the operating line: height and gap for a range of the tip, and the blade's stress.

δ_O is the whole range of the tip's motion, twice the deflection allowed to one side. The line
gives the gap for a height; statics says whether the tip-loaded blade reaches that stop at all,
and the forces and stresses with the tip at the end of its range.
"""

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range
from flexcli.formulas.pi_law import MEASURED, operating_line, ratio_on_line
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.formulas.stop_stiffness import height_share, stiffness_ratio

__all__ = [
    "CARDS",
    "HARD_STOP",
    "REACHED",
    "allowed_travel",
    "line_gap",
    "line_height",
]


REACHED = Range(
    "L_a/L", 0.506, 0.894, "where the operating line lies above the quasi-static contact threshold"
)


def allowed_travel(*, E: Quantity, h: Quantity, L: Quantity, sigma: Quantity) -> Computed:
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


def line_gap(*, L_a: Quantity, L_b: Quantity, delta_O: Quantity) -> Computed:
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


def line_height(*, d: Numbers, L: Numbers, delta_O: Numbers) -> Computed:
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
)
