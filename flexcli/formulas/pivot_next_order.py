"""Next order in the rotation of the closed forms of a pivot of two blades.

Derivation: the elastica θ'' = p sin θ − f cos θ of one blade is solved in powers of the pivot's
rotation ε, with its end's motion (w, φ) and its axial force p all of order ε [units l, EI/l²]:

    f = 12w − 6φ + p (6w/5 − φ/10) + p² (φ/1400 − w/700)
          + 432w³/35 − 54w²φ/7 + 72wφ²/35 − φ³/7
    m = 4φ − 6w + p (2φ/15 − w/10) + p² (w/1400 − 11φ/6300)
          − 18w³/7 + 72w²φ/35 − 3wφ²/7 − 8φ³/35
    λ = 3w²/5 − wφ/10 + φ²/15 + p (wφ − w²)/700 − 11pφ²/6300 + quartic terms

(the terms linear in w, φ are the beam constraint model of Awtar, Slocum & Sevincer 2007), and
inserted in equilibrium and closure of the body: ``λ_i = (1 + δ)(1 − cos θ) − d·e_i``,
``w_i = (1 + δ) sin θ + d·n_i``, ``Σ(p_i e_i + f_i n_i) = 0``, for the shift d of the centre. With
``γ = 1 + 2δ`` the first order of the axial forces is ``p = ∓6γ θ cot α``: it grows with θ itself,
and so does the stress of one of the blades.

Along the bisector the next term of the parasitic shift is of order θ⁴, and rules at Wittrick's
crossing; across it the shift begins with θ³.
"""

from typing import NamedTuple

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Numbers, Quantity

__all__ = [
    "CARDS",
    "LARGE_ROTATION",
    "Parts",
    "moment_change",
    "moment_parts",
    "next_shift",
    "shift_across",
    "shift_parts",
    "stress_bound",
    "stress_change",
]


LARGE_ROTATION = (
    Range("theta", most=0.35, unit="rad", why="the change is the next term only"),
    Range("delta", -2.0, 1.0, "the axial force of the blades outgrows the expansion"),
)
"""Validity: the next term alone estimates the error."""


class Parts(NamedTuple):
    """A next-order term by powers of cot α: their sum is the term, that of magnitudes a bound."""

    square: Computed
    none: Computed
    inverse: Computed

    @property
    def total(self) -> Computed:
        """Return the sum."""
        return self.square + self.none + self.inverse

    @property
    def bound(self) -> Computed:
        """Return the sum of the magnitudes, which no chance cancellation makes small."""
        return np.abs(self.square) + np.abs(self.none) + np.abs(self.inverse)


def moment_parts(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Parts:
    """Return the parts of the relative change of the moment, see :func:`moment_change`."""
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    share = theta**2 / (2.0 * (1.0 + 3.0 * gamma**2))
    return Parts(
        square=-share * gamma**2 * cot**2 * (9.0 * gamma**2 + 35.0) / 175.0,
        none=-share * 2.0 * gamma**2 * (243.0 * gamma**2 - 175.0) / 175.0,
        inverse=share * (9.0 * gamma**2 - 5.0) ** 2 / (75.0 * cot**2),
    )


def moment_change(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the relative change that a large rotation makes to the moment over the rotation.

    ``M/(Kθ) − 1 = θ²/(2(1 + 3γ²)) · (−γ²(9γ² + 35) cot²α/175 − 2γ²(243γ² − 175)/175
    + (9γ² − 5)² tan²α/75)`` with ``γ = 1 + 2δ``.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    change : Quantity
        True over closed-form secant stiffness, less one [-].

    Notes
    -----
    The centre is free to shift; slender blades. The next term is of order θ⁴. It softens but for
    wide angles: the symmetric pivot (γ = 0) stiffens by θ² tan²α/6.

    Examples
    --------
    >>> from math import pi
    >>> round(float(6.0 * moment_change(l=1.0, p=-0.5, theta=0.1, half_angle=pi / 4)), 9)
    0.01

    References
    ----------
    Derived, see the module; first terms as Haringx (1949), Applied Scientific Research A1.

    """
    return moment_parts(l=l, p=p, theta=theta, half_angle=half_angle).total


def stress_change(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the relative change that a large rotation makes to the largest bending stress.

    ``σ/σ₀ − 1 = max|1 + 3γ ± s₁ θ + s₂ θ²|/(1 + 3|γ|) − 1`` over both blades and, with −γ for γ,
    their outer ends; ``s₁ = (3γ² + 5γ) cot α/10 − (9γ² − 5) tan α/10``,
    ``s₂ = −γ(18γ² + 35γ + 35) cot²α/700 − γ(342γ² + 105γ − 175)/700
    + (3γ + 5)(9γ² − 5) tan²α/300``.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    change : Quantity
        True over closed-form stress, less one [-].

    Notes
    -----
    The rotation compresses one blade and stretches the other: the closed form is on the unsafe
    side by a share that grows with θ itself. The next term is of order θ³.

    Examples
    --------
    >>> from math import pi
    >>> change = stress_change(l=1.0, p=0.0, theta=1e-4, half_angle=pi / 4)
    >>> round(float(change / 1e-4), 4)
    0.1

    References
    ----------
    Derived, see the module.

    """
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    most: Computed = 0.0
    for side in (gamma, -gamma):
        odd, even = _end_moment(side, theta, cot)
        most = np.maximum(most, np.abs(1.0 + 3.0 * side + even.total) + np.abs(odd))
    return most / (1.0 + 3.0 * np.abs(gamma)) - 1.0


def stress_bound(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the sum of the magnitudes in ``stress_change``, which nothing cancels.

    ``(|s₁| θ + Σ|s₂ terms| θ²)/(1 + 3|γ|)``, the larger of both ends.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    change : Quantity
        Size of the change of the largest bending stress [-].

    Examples
    --------
    >>> from math import pi
    >>> bound = stress_bound(l=1.0, p=0.0, theta=1e-4, half_angle=pi / 4)
    >>> round(float(bound / 1e-4), 4)
    0.15

    References
    ----------
    Derived, see the module.

    """
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    inner, outer = (_end_moment(side, theta, cot) for side in (gamma, -gamma))
    sizes = [np.abs(odd) + even.bound for odd, even in (inner, outer)]
    most = np.maximum(*sizes)
    return most / (1.0 + 3.0 * np.abs(gamma))


def _end_moment(gamma: Quantity, theta: Quantity, cot: Quantity) -> tuple[Computed, Parts]:
    """Return the next terms of the inner end's moment, odd and even in θ, over EI θ/l."""
    odd = (3.0 * gamma**2 + 5.0 * gamma) * cot - (9.0 * gamma**2 - 5.0) / cot
    square, none = theta**2 * gamma * cot**2, theta**2 * gamma
    return odd * theta / 10.0, Parts(
        square=-square * (18.0 * gamma**2 + 35.0 * gamma + 35.0) / 700.0,
        none=-none * (342.0 * gamma**2 + 105.0 * gamma - 175.0) / 700.0,
        inverse=theta**2 * (3.0 * gamma + 5.0) * (9.0 * gamma**2 - 5.0) / (300.0 * cot**2),
    )


_PIVOT = {"l": 17.5e-3, "p": 2e-3, "theta": 0.1, "half_angle": 0.7}


def shift_parts(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Parts:
    """Return the parts of the fourth-order shift [m], see :func:`next_shift`."""
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    square, size = gamma**2, l * theta**4 / np.cos(half_angle)
    cubic = gamma * (35.0 + gamma * (27.0 + gamma * (9.0 + 9.0 * gamma)))
    quartic = -35.0 + gamma * (-70.0 + gamma * (-13.0 + gamma * (126.0 + 108.0 * gamma)))
    return Parts(
        square=-size * cubic * cot**2 / 8400.0,
        none=-size * quartic / 2800.0,
        inverse=size * (9.0 * square - 7.0) * (9.0 * square - 5.0) / (6300.0 * cot**2),
    )


def next_shift(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return what the next order in θ adds to the shift of the centre along the bisector.

    ``ΔPP' = −θ⁴ l/cos α · (γ(9γ³ + 9γ² + 27γ + 35) cot²α/8400 + (108γ⁴ + 126γ³ − 13γ² − 70γ −
    35)/2800 − (9γ² − 7)(9γ² − 5) tan²α/6300)``, ``γ = 1 + 2δ``. At Wittrick's crossing, where
    9γ² = 5, the last term vanishes too, and the first two are all there is.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m]; the inner ends are
        on the fixed body.
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    shift : Quantity
        Shift besides ``pivot.parasitic_shift``, with the same sign [m].

    Notes
    -----
    The next term is of order θ⁶. Unlike the leading term it is not symmetric in δ ↔ −1 − δ, since
    it is stated in the axes of the body that holds the inner ends.

    Examples
    --------
    >>> from math import pi, sqrt
    >>> wittrick = (sqrt(45.0) - 9.0) / 18.0
    >>> shift = next_shift(l=1.0, p=wittrick, theta=0.1, half_angle=pi / 4)
    >>> f"{shift:.3g}"
    '-3.52e-07'

    References
    ----------
    Derived, see ``pivot_next_order``; the leading term is of Wittrick (1951), Aeronautical
    Quarterly 2.

    """
    return shift_parts(l=l, p=p, theta=theta, half_angle=half_angle).total


def shift_across(*, l: Numbers, p: Numbers, theta: Numbers, half_angle: Numbers) -> Computed:
    """Return the shift of the centre across the bisector, of the order θ³ with which it begins.

    ``Y = −θ³ l/sin α · (γ(9γ² + 35) cot α + (378γ³ + 315γ² − 210γ − 175) tan α)/4200``.

    Parameters
    ----------
    l, p : Quantity
        Length of a blade and distance from the centre to the inner ends [m].
    theta : Quantity
        Rotation [rad].
    half_angle : Quantity
        Half the angle between the blades [rad].

    Returns
    -------
    Y : Quantity
        Shift, towards where the rotation turns the bisector when positive [m].

    Notes
    -----
    Slender blades; ``thick_blades.pivot_shift_across`` adds what their stretching makes of order θ.

    Examples
    --------
    >>> from math import pi
    >>> f"{shift_across(l=1.0, p=0.0, theta=0.1, half_angle=pi / 4):.3g}"
    '-0.000119'

    References
    ----------
    Derived, see ``pivot_next_order``.

    """
    gamma, cot = 1.0 + 2.0 * p / l, 1.0 / np.tan(half_angle)
    tilt = gamma * (9.0 * gamma**2 + 35.0) * cot
    tilt = tilt + (gamma * (gamma * (378.0 * gamma + 315.0) - 210.0) - 175.0) / cot
    return -(theta**3) * l * tilt / (4200.0 * np.sin(half_angle))


CARDS: tuple[Card, ...] = (
    Card("pivot-moment-at-large-rotation", moment_change, _PIVOT, LARGE_ROTATION),
    Card("pivot-stress-at-large-rotation", stress_change, _PIVOT, LARGE_ROTATION),
    Card("pivot-next-shift", next_shift, _PIVOT, LARGE_ROTATION),
    Card("pivot-shift-across", shift_across, _PIVOT, LARGE_ROTATION),
)
