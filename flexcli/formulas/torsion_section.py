"""The rectangular section in torsion, by Saint-Venant's exact series."""

from math import pi
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Table

__all__ = [
    "CARDS",
    "Warping",
    "narrow_shear_factor",
    "shear_factor",
    "torsion_constant",
    "warping",
]

Floats = NDArray[np.float64]

ODD = np.arange(1.0, 25.0, 2.0)
"""Orders of the series; the term after the last is below 1e-17 of the first for a square."""

AT_THE_EDGE = 0.2384
"""What the warping y z of a strip loses to its edge, over h²: δ/2h + (8/π³) Σ exp(−nπδ/h)/n³ where
(8/π²) Σ exp(−nπδ/h)/n² = ½."""

SUM_OF_FIFTH_POWERS = 1.0045237627951398
"""Σ 1/n⁵ over odd n, (31/32) ζ(5)."""

CATALAN = 0.9159655941772190
"""Σ (−1)^k/n² over odd n = 2k + 1."""


def _sides(h: ArrayLike, b: ArrayLike) -> tuple[Floats, Floats, Floats]:
    """Return thin side, broad side, and nπ broad/thin on a trailing axis of orders n."""
    one, other = positive(h=h, b=b)
    thin, broad = np.minimum(one, other), np.maximum(one, other)
    return thin, broad, (pi * broad / thin)[..., np.newaxis] * ODD


def torsion_constant(h: ArrayLike, b: ArrayLike) -> Floats:
    """Return the torsion constant of a rectangular section, by Saint-Venant's exact series.

    ``J = b h³/3 (1 − (192/π⁵)(h/b) Σ tanh(nπb/2h)/n⁵)`` over odd n, for the thin side h.

    Parameters
    ----------
    h, b : array_like
        Sides of the section in either order [m]; broadcast.

    Returns
    -------
    J : array
        Torsion constant, G J φ' = T [m⁴].

    Notes
    -----
    With tanh = 1 − 2/(e^{2x} + 1) the slow part of the series is a constant, and twelve terms
    give all digits at any ratio of the sides. Free warping.

    Raises
    ------
    ValueError
        When a side is not positive and finite.

    Examples
    --------
    >>> round(float(torsion_constant(1.0, 1.0)), 6)
    0.140577

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109 and its table.

    """
    thin, broad, x = _sides(h, b)
    fading = np.exp(-x)
    series = SUM_OF_FIFTH_POWERS - np.sum(2.0 * fading / (1.0 + fading) / ODD**5, axis=-1)
    return np.asarray(broad * thin**3 / 3.0 * (1.0 - 192.0 / pi**5 * thin / broad * series))


def shear_factor(h: ArrayLike, b: ArrayLike) -> Floats:
    """Return the largest shear stress of a twisted rectangle over that of a thin strip, G h φ'.

    ``k = 1 − (8/π²) Σ 1/(n² cosh(nπb/2h))`` over odd n, for the thin side h.

    Parameters
    ----------
    h, b : array_like
        Sides of the section in either order [m]; broadcast.

    Returns
    -------
    k : array
        Factor, τ = k G h φ' at the middle of the broad sides, with h the thin side [-].

    Notes
    -----
    From 0.675 (square) to 1 (strip); k = 1 errs to the safe side. Free warping.

    Raises
    ------
    ValueError
        When a side is not positive and finite.

    Examples
    --------
    >>> round(float(shear_factor(1.0, 1.0)), 6)
    0.675314

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109 and its table.

    """
    _, _, x = _sides(h, b)
    fading = np.exp(-x / 2.0)
    return np.asarray(
        1.0 - 8.0 / pi**2 * np.sum(2.0 * fading / (1.0 + fading**2) / ODD**2, axis=-1)
    )


def narrow_shear_factor(h: ArrayLike, b: ArrayLike) -> Floats:
    """Return the shear stress in the middle of the narrow sides over that of a thin strip, G h φ'.

    ``k_n = (8/π²) Σ (−1)^k tanh(nπb/2h)/n²`` over odd n = 2k + 1, for the thin side h.

    Parameters
    ----------
    h, b : array_like
        Sides of the section in either order [m]; broadcast.

    Returns
    -------
    k_n : array
        Factor, τ = k_n G h φ' [-].

    Notes
    -----
    From 0.675 (square, as of its other sides) to 0.742 (strip). Free warping.

    Raises
    ------
    ValueError
        When a side is not positive and finite.

    Examples
    --------
    >>> round(float(narrow_shear_factor(1.0, 1.0)), 6)
    0.675314

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109.

    """
    _, _, x = _sides(h, b)
    fading = np.exp(-x)
    signs = np.where(ODD % 4.0 == 1.0, 1.0, -1.0)
    lost = np.sum(signs * 2.0 * fading / (1.0 + fading) / ODD**2, axis=-1)
    return np.asarray(8.0 / pi**2 * (CATALAN - lost))


class Warping(NamedTuple):
    """Saint-Venant's warping ψ of a section: Γ = ∫ψ² dA [m⁶], and the largest ψ [m²]."""

    constant: Floats
    largest: Floats


def warping(h: ArrayLike, b: ArrayLike) -> Warping:
    """Return the warping constant of a rectangular section, and its largest warping.

    ``ψ = y z − (8h²/π³) Σ (−1)^k sin(nπz/h) sinh(nπy/h)/(n³ cosh(nπb/2h))`` over odd n = 2k + 1,
    ``Γ = ∫ψ² dA``, for the thin side h along z.

    Parameters
    ----------
    h, b : array_like
        Sides of the section in either order [m]; broadcast.

    Returns
    -------
    constant : array
        Γ [m⁶]; ``b³h³/144`` of a thin strip.
    largest : array
        Largest ψ [m²]: ``b h/4 − 0.2384 h²`` and what the far edge adds to it, on the broad sides
        0.17 h from the corners of a strip.

    Notes
    -----
    Saint-Venant's exact warping: Γ is 4 % less than a strip's at b = 10 h and 16 % at b = 5 h. What
    the far edge adds, ``0.025 h² exp(−3.07 (b/h − 1))``, is fitted: the largest is right to 1e-3.

    Raises
    ------
    ValueError
        When a side is not positive and finite.

    Examples
    --------
    >>> constant, largest = warping(1.0, 5.0)
    >>> round(float(constant) / (5.0**3 / 144.0), 4), round(float(largest) / (5.0 / 4.0), 4)
    (0.8446, 0.8093)

    References
    ----------
    Timoshenko & Goodier (1970), Theory of Elasticity, section 109.

    """
    thin, broad, x = _sides(h, b)
    x = x / 2.0
    fading = np.exp(-2.0 * x)
    tanh, sech2 = (1.0 - fading) / (1.0 + fading), 4.0 * fading / (1.0 + fading) ** 2
    share = broad / thin
    cross = np.sum((x - tanh) / ODD**7, axis=-1)
    square = np.sum((tanh / (pi * ODD) - share[..., None] / 2.0 * sech2) / ODD**6, axis=-1)
    constant = broad**3 * thin**3 / 144.0 + thin**6 * (
        -64.0 / pi**7 * cross + 32.0 / pi**6 * square
    )
    lost = AT_THE_EDGE - 0.025 * np.exp(-3.07 * (share - 1.0))
    return Warping(np.asarray(constant), np.asarray(broad * thin / 4.0 - lost * thin**2))


RATIOS = (1.0, 1.2, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 10.0, 100.0)

CARDS: tuple[Card, ...] = (
    Card(
        name="torsion-constant",
        function=torsion_constant,
        example={"h": 0.5e-3, "b": 5e-3},
        tables={
            "ratio": Table(
                variable="b/h",
                values=RATIOS,
                columns={
                    "J/(b h³)": ("", lambda ratio: float(torsion_constant(1.0, ratio)) / ratio),
                    "τ/(G h φ')": ("", lambda ratio: float(shear_factor(1.0, ratio))),
                },
            )
        },
    ),
    Card(
        name="torsion-shear-factor",
        function=shear_factor,
        example={"h": 0.5e-3, "b": 5e-3},
    ),
    Card(
        name="torsion-narrow-shear-factor",
        function=narrow_shear_factor,
        example={"h": 0.5e-3, "b": 5e-3},
    ),
    Card(
        name="warping-constant",
        function=warping,
        example={"h": 0.5e-3, "b": 5e-3},
        tables={
            "ratio": Table(
                variable="b/h",
                values=RATIOS,
                columns={
                    "144 Γ/(b h)³": (
                        "",
                        lambda ratio: float(warping(1.0, ratio).constant) * 144.0 / ratio**3,
                    ),
                },
            )
        },
    ),
)
