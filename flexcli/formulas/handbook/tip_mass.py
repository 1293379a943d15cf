"""Natural frequencies of a cantilever that carries a body beyond its end.

The body has mass m, its centre lies c beyond the blade's end on the blade's axis, and J is its
moment of inertia about that centre. Motion is lateral and small; gravity and shear are left out.
A blade with mass of its own has its exact Euler–Bernoulli dynamic stiffness, and the count of
frequencies below a trial one (Wittrick & Williams), which a bisection cannot miss or skip.
"""

from math import factorial, pi
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Computed, Quantity

__all__ = [
    "CARDS",
    "massless_frequencies",
    "tip_mass_frequencies",
]


def massless_frequencies(
    *, E: Quantity, I: Quantity, L: Quantity, m: Quantity, c: Quantity = 0.0, J: Quantity = 0.0
) -> tuple[Computed, Computed]:
    """Return both natural frequencies of a massless cantilever with a body beyond its end.

    ``1/ω² = (T ± √(T² − 4D))/2`` with ``T = (m L³/3 + m c L² + (J + m c²) L)/(EI)`` and
    ``D = m J L⁴/(12 (EI)²)``.

    Parameters
    ----------
    E : Quantity
        Young's modulus [Pa].
    I : Quantity
        Second moment of area of the blade [m⁴].
    L : Quantity
        Length of the blade [m].
    m : Quantity
        Mass of the body [kg].
    c : Quantity
        Offset of its centre beyond the blade's end [m].
    J : Quantity
        Moment of inertia about its centre [kg·m²].

    Returns
    -------
    f_1, f_2 : Quantity
        Natural frequencies [Hz]; f_2 is infinite when J is 0.

    Notes
    -----
    Blade far lighter than the body: its mass m_b lowers f_1 by about (33/280) m_b/m when c and J
    are 0, by less otherwise. With c = J = 0 this is √(k/m)/2π.

    Examples
    --------
    >>> f_1, f_2 = massless_frequencies(E=3.0, I=1.0, L=1.0, m=9.0)
    >>> round(float(2 * pi * f_1), 12), float(f_2)
    (1.0, inf)

    References
    ----------
    Two by two eigenproblem of the tip's compliance (Timoshenko 1955, Strength of Materials, Part I)
    with the body's mass matrix about the end.

    """
    flexibility = L / (E * I)
    half_sum = flexibility * (m * (L**2 / 3.0 + c * (L + c)) + J) / 2.0
    product = (flexibility * L) ** 2 * m * J / 12.0
    slow = half_sum + np.sqrt(half_sum**2 - product)  # 1/ω1²
    with np.errstate(divide="ignore"):
        fast = np.sqrt(np.divide(slow, product))  # the other root without cancellation
    return 1.0 / (2.0 * pi * np.sqrt(slow)), fast / (2.0 * pi)


Floats = NDArray[np.float64]

_HALVINGS = 64  # from kπ to below the spacing of floats


class _DynamicStiffness(NamedTuple):
    """Stiffness at the tip times D/x⁴ in units of EI and L, D/x⁴, and 1 + cos x cosh x.

    D = 1 − cos x cosh x; all may carry one positive factor.
    """

    force: Floats
    couple: Floats
    moment: Floats
    denominator: Floats
    free: Floats


def _series(x: Floats) -> _DynamicStiffness:
    """Return the terms at small x, where the closed form cancels: powers of 4x⁴."""
    z = -4.0 * x**4

    def power(first: int, scale: float) -> Floats:
        total = np.zeros_like(z)
        for k in reversed(range(6)):
            total = total * z + scale / factorial(4 * k + first)
        return total

    denominator = power(4, 4.0)
    free = 2.0 - denominator * x**4
    return _DynamicStiffness(power(1, 2.0), power(2, 2.0), power(3, 4.0), denominator, free)


def _closed(x: Floats) -> _DynamicStiffness:
    """Return the terms from their definition, divided by eˣ to keep them finite."""
    sine, cosine, decay = np.sin(x), np.cos(x), np.exp(-2.0 * x)
    cosh, sinh = (1.0 + decay) / 2.0, (1.0 - decay) / 2.0
    return _DynamicStiffness(
        (sine * cosh + cosine * sinh) / x,
        sine * sinh / x**2,
        (sine * cosh - cosine * sinh) / x**3,
        (np.exp(-x) - cosine * cosh) / x**4,
        np.exp(-x) + cosine * cosh,
    )


def _count_below(x: Floats, mass: Floats, offset: Floats, inertia: Floats) -> Floats:
    """Return how many natural frequencies lie below x = L (ω²ρA/EI)^¼."""
    small = x < 1.0
    series, closed = _series(np.minimum(x, 1.0)), _closed(np.maximum(x, 1.0))
    blade = _DynamicStiffness(*(np.where(small, s, c) for s, c in zip(series, closed, strict=True)))
    square = x**4
    about_end = inertia + mass * offset**2
    pull = mass * blade.moment + about_end * blade.force + 2.0 * mass * offset * blade.couple
    # the determinant of stiffness less ω² mass, times D/x⁴, with the cancelling terms taken out
    frequency = blade.free - square * pull + blade.denominator * square**2 * mass * inertia
    trace = blade.force + blade.moment - blade.denominator * square * (mass + about_end)
    sinks = trace * blade.denominator < 0.0
    negative = np.where(frequency * blade.denominator < 0.0, 1.0, np.where(sinks, 2.0, 0.0))
    # frequencies of the blade with both ends clamped, (1 − cos x cosh x) changing sign at each
    whole = np.floor(x / pi)
    sign = np.where(whole % 2 == 0, 1.0, -1.0) * np.sign(blade.denominator)
    clamped = whole - (1.0 - sign) / 2.0
    counted: Floats = clamped + negative
    return counted


def tip_mass_frequencies(
    *,
    E: ArrayLike,
    I: ArrayLike,
    L: ArrayLike,
    mass_per_length: ArrayLike,
    m: ArrayLike,
    c: ArrayLike = 0.0,
    J: ArrayLike = 0.0,
    modes: int = 1,
) -> Floats:
    """Return the lowest natural frequencies of a cantilever with a body beyond its end.

    ``det(K(ω) − ω² M) = 0`` with the exact dynamic stiffness K of the blade at its tip and
    ``M = [[m, m c], [m c, J + m c²]]``.

    Parameters
    ----------
    E : array
        Young's modulus [Pa].
    I : array
        Second moment of area of the blade [m⁴].
    L : array
        Length of the blade [m].
    mass_per_length : array
        ρ A of the blade [kg/m].
    m : array
        Mass of the body [kg], 0 for none.
    c : array
        Offset of its centre beyond the blade's end [m].
    J : array
        Moment of inertia about its centre [kg·m²].
    modes : int
        How many frequencies.

    Returns
    -------
    array
        Natural frequencies [Hz], ascending along a new last axis.

    Raises
    ------
    ValueError
        When E, I, L or ρA is not positive, m or J is negative, or modes is below 1.

    Notes
    -----
    Euler–Bernoulli: no shear, no rotary inertia of the blade itself. To some 1e-15 relative.

    Examples
    --------
    >>> tip_mass_frequencies(E=1.0, I=1.0, L=1.0, mass_per_length=1.0, m=0.0, modes=2).round(4)
    array([0.5596, 3.5069])

    References
    ----------
    Wittrick & Williams (1971), Quarterly Journal of Mechanics and Applied Mathematics 24(3).

    """
    modulus, second, length, density = positive(E=E, I=I, L=L, mass_per_length=mass_per_length)
    body, offset, inertia = (np.asarray(value, dtype=np.float64) for value in (m, c, J))
    if not ((body >= 0.0).all() and (inertia >= 0.0).all() and np.isfinite(offset).all()):
        raise ValueError(f"m and J must not be negative and c finite: {body}, {inertia}, {offset}")
    if modes < 1:
        raise ValueError(f"modes must be at least 1, got {modes}")
    # columns of ratios against a last axis of modes
    ratios = (body / (density * length), offset / length, inertia / (density * length**3))
    mass, arm, turn = (ratio[..., np.newaxis] for ratio in np.broadcast_arrays(*ratios))
    order = np.arange(1.0, modes + 1.0)
    high = np.broadcast_to(pi * order, np.broadcast_shapes(mass.shape, order.shape)).copy()
    low = np.zeros_like(high)
    for _ in range(_HALVINGS):
        middle = (low + high) / 2.0
        above = _count_below(middle, mass, arm, turn) >= order
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    unit = np.sqrt(modulus * second / density) / (2.0 * pi * length**2)
    frequencies: Floats = unit[..., np.newaxis] * high**2
    return frequencies


CARDS: tuple[Card, ...] = (
    Card(
        "tip-mass-frequencies",
        massless_frequencies,
        {"E": 69e9, "I": 9.528e-13, "L": 20.5e-3, "m": 9.96e-3, "c": 11.5e-3, "J": 1.9e-6},
        (Range("m_b/m", most=0.1, why="the blade's own mass is left out"),),
    ),
    Card(
        "tip-mass-beam-frequencies",
        tip_mass_frequencies,
        {"E": 69e9, "I": 9.528e-13, "L": 20.5e-3, "mass_per_length": 27.9e-3}
        | {"m": 9.96e-3, "c": 11.5e-3, "J": 1.9e-6, "modes": 2},
        (Range("L/h", 10.0, why="shear and the blade's own rotary inertia are left out"),),
    ),
)
