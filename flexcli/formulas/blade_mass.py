"""Mass of the blades in a frequency: Rayleigh's share for each motion.

A blade of mass m_b that deflects as under a static force or rotation adds ∫ w² dm to the moving
mass, or inertia; the frequency so found is an upper bound and exact to second order in the share.
"""

from math import pi, sqrt, tan

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = [
    "CARDS",
    "TORSION_CLAMPED",
    "bar_frequency_change",
    "frequency_change",
    "pivot_inertia",
]

_HALVINGS = 60  # from π/2 to below the spacing of floats

TORSION_CLAMPED = 13.0 / 35.0
"""Share of a torsion bar's inertia that turns with its end where both ends hold the warping and
nothing else resists: ∫(3s² − 2s³)² ds; ⅓ where they are free."""


def pivot_inertia(*, m_b: Quantity, l: Quantity, p: Quantity, blades: int = 2) -> Computed:
    """Return the inertia that the blades of a pivot add to the body at their outer ends.

    ``J = n m_b l² (13(1 + δ)²/35 − 11(1 + δ)/105 + 1/105)``.

    Parameters
    ----------
    m_b : Quantity
        Mass of a blade [kg].
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends, which are fixed [m]; for
        fixed outer ends put −l − p for p.
    blades : int
        Number of blades.

    Returns
    -------
    J : Quantity
        Inertia about the centre [kg·m²].

    Examples
    --------
    >>> round(105.0 * pivot_inertia(m_b=1.0, l=1.0, p=0.0), 9)
    58.0

    References
    ----------
    Consistent mass of a beam whose end turns by θ and moves by (l + p)θ, Przemieniecki (1968),
    Theory of Matrix Structural Analysis, section 11.3.

    """
    reach = 1.0 + p / l
    return blades * m_b * l**2 * (39.0 * reach**2 - 11.0 * reach + 1.0) / 105.0


def frequency_change(ratio: float) -> float:
    """Return the relative change that the mass of the blades makes to a frequency.

    ``1/√(1 + r) − 1``.

    Parameters
    ----------
    ratio : float
        r: mass (or inertia) that the blades add over that of the body [-].

    Returns
    -------
    change : float
        Frequency with the blades over that without, less one [-].

    Examples
    --------
    >>> frequency_change(3.0)
    -0.5

    References
    ----------
    Rayleigh (1877), The Theory of Sound.

    """
    return 1.0 / sqrt(1.0 + ratio) - 1.0


def bar_frequency_change(ratio: float) -> float:
    """Return the relative change that the inertia of a torsion bar makes to a frequency.

    ``β tan β = r``, ``f/f_0 = β/√r`` with f_0 of the body on a bar without inertia.

    Parameters
    ----------
    ratio : float
        r: inertia of the bars about their axis over that of the body [-].

    Returns
    -------
    change : float
        Frequency with the bars over that without, less one [-].

    Notes
    -----
    Ends free to warp. For small r it is −r/6, Rayleigh's third of the bar.

    Examples
    --------
    >>> round(bar_frequency_change(0.06), 4)
    -0.0099

    References
    ----------
    Rao (2007), Vibration of Continuous Systems, section 10.4.

    """
    if ratio == 0.0:
        return 0.0
    low, high = 0.0, pi / 2.0
    for _ in range(_HALVINGS):
        beta = (low + high) / 2.0
        low, high = (low, beta) if beta * tan(beta) > ratio else (beta, high)
    return low / sqrt(ratio) - 1.0


CARDS = (
    Card("pivot-blade-inertia", pivot_inertia, {"m_b": 0.5e-3, "l": 17.5e-3, "p": 2e-3}),
    Card(
        "blade-mass-in-frequency",
        frequency_change,
        {"ratio": 0.05},
        (Range("r", 0.0, 1.0, "heavy blades bend otherwise than at rest"),),
    ),
)
