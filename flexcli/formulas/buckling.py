"""Buckling of one blade: Euler's loads, shear and stretching in them, Johnson's for stocky ones."""

from math import cos, inf, pi, sin, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.card import SLENDER, Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = ["CARDS", "EFFECTIVE_LENGTH", "euler_load", "johnson_stress", "thick_load"]

EFFECTIVE_LENGTH = {
    "clamped-clamped": 0.5,
    "clamped-pinned": 0.6991556596428411,  # π over the first root of tan x = x
    "clamped-guided": 1.0,
    "pinned-pinned": 1.0,
    "clamped-free": 2.0,
}
"""Effective length over length, by what holds the two ends (Timoshenko & Gere 1961, §2.1)."""


def euler_load(*, E: Quantity, I: Quantity, l: Quantity, ends: str) -> Computed:
    """Return the critical axial force of a straight blade.

    ``N_cr = π² E I / (μ l)²`` with the effective length μ l of how its ends are held.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area about the axis of bending [m⁴].
    l : Quantity
        Length [m].
    ends : str
        A key of :data:`EFFECTIVE_LENGTH`.

    Returns
    -------
    N_cr : Quantity
        Critical force [N].

    Notes
    -----
    Elastic and slender: beyond half the yield strength :func:`johnson_stress` is what N_cr/(h b)
    comes to; :func:`thick_load` has shear and stretching.

    Examples
    --------
    >>> round(euler_load(E=200e9, I=1e-12, l=0.1, ends="pinned-pinned"), 3)
    197.392

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, §2.1.

    """
    return pi**2 * E * I / (EFFECTIVE_LENGTH[ends] * l) ** 2


def thick_load(*, ends: str, axial: float, shear: float) -> float:
    """Return the critical axial force of a blade that shears and shortens, in units EI/l².

    ``P (1 + (s − a) P) = (π/μ)²`` with the effective length μ of its ends; clamped–pinned it is
    ``tan k = k (1 − s k²/m²)``, ``k² = m P``, ``m = 1 + (s − a) P``.

    Parameters
    ----------
    ends : str
        A key of :data:`EFFECTIVE_LENGTH`.
    axial : float
        a = EI/(EA l²), (h/l)²/12 of a rectangle [-].
    shear : float
        s = EI/(κGA l²), Φ/12 of Timoshenko's parameter [-].

    Returns
    -------
    P : float
        Critical force over EI/l² [-]; infinite where the blade shortens faster than it bows.

    Notes
    -----
    Exact for Reissner's beam, as in the exact model: the shear force is normal to the section
    (Haringx), the blade straight before it buckles.

    Examples
    --------
    >>> round(thick_load(ends="clamped-guided", axial=0.0, shear=0.01), 4)
    9.0505

    References
    ----------
    Haringx (1942); Reissner (1972), J. Appl. Math. Phys. 23; Bažant & Cedolin (1991), Stability
    of Structures, section 1.7.

    """
    softer = shear - axial

    def load(square: float) -> float:
        root = 1.0 + 4.0 * softer * square
        return 2.0 * square / (1.0 + sqrt(root)) if root >= 0.0 else inf

    if ends != "clamped-pinned":
        return load((pi / EFFECTIVE_LENGTH[ends]) ** 2)

    # between k = π, where the residual is positive, and the root of tan k = k without shear
    low, high = load(pi**2), load((1.5 * pi) ** 2)
    if high == inf:
        return inf
    for _ in range(_HALVINGS):
        P = (low + high) / 2.0
        m = 1.0 + softer * P
        k = sqrt(m * P)
        if sin(k) > k * cos(k) * (1.0 - shear * k**2 / m**2):
            low = P
        else:
            high = P
    return (low + high) / 2.0


_HALVINGS = 54
"""Halvings of an interval that leave rounding."""


def johnson_stress(critical: ArrayLike, strength: ArrayLike) -> NDArray[np.float64]:
    """Return the axial stress at which a blade buckles or is crushed.

    ``σ_y (1 − σ_y/(4 σ_cr))`` where the elastic critical stress σ_cr is above σ_y/2, and σ_cr
    below.

    Parameters
    ----------
    critical : array_like
        Elastic critical stress [Pa]; infinite where nothing buckles.
    strength : array_like
        Yield strength [Pa].

    Returns
    -------
    stress : array
        Stress that the blade bears [Pa].

    Notes
    -----
    Residual stress and lack of straightness make real columns yield in part from σ_y/2 on; for
    a very short blade what is left is the squash load.

    Examples
    --------
    >>> float(johnson_stress(1000e6, 400e6)) / 1e6, float(johnson_stress(100e6, 400e6)) / 1e6
    (360.0, 100.0)

    References
    ----------
    J. B. Johnson's parabola: Timoshenko & Gere (1961), Theory of Elastic Stability, section 4.4.

    """
    sigma, yields = np.asarray(critical, dtype=np.float64), np.asarray(strength, dtype=np.float64)
    with np.errstate(divide="ignore"):
        parabola = yields * (1.0 - yields / (4.0 * sigma))
    return np.where(sigma > yields / 2.0, parabola, sigma)


CARDS = (
    Card(
        "euler-load",
        euler_load,
        {"E": 200e9, "I": 1e-12, "l": 0.1, "ends": "clamped-guided"},
        (SLENDER,),
    ),
    Card(
        "thick-blade-buckling",
        thick_load,
        {"ends": "clamped-clamped", "axial": 8e-4, "shear": 2.5e-3},
        (Range("Phi", 0.0, 1.0, "a blade as thick as this is no beam"),),
    ),
    Card("johnson-stress", johnson_stress, {"critical": 1e9, "strength": 880e6}),
)
