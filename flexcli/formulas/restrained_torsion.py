"""Torsion of a thin strip whose clamped ends cannot warp: stiffness and stresses."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.torsion_section import shear_factor, torsion_constant
from flexcli.formulas.torsion_shapes import warping_constant
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "TwistStress",
    "restrained_stiffness",
    "restrained_stresses",
    "thick_strip_error",
]

Floats = NDArray[np.float64]

ROUNDING = 1e-9
"""How far above ½ Poisson's ratio may come out of moduli rounded for ν = ½."""


SERIES_BELOW_STRIP = 0.8
"""Share of the warping constant, over h/b, that the series for a rectangle has less than b³h³/144:
16 % at b = 5 h, where it is most of all."""


def _length_in_warping_decays(E: Floats, G: Floats, h: Floats, b: Floats, l: Floats) -> Floats:
    """Return λ = l √(G J/(E' Γ))."""
    restraint = _plate_modulus(E, G) * warping_constant(h, b)
    return np.asarray(l * np.sqrt(G * torsion_constant(h, b) / restraint))


def _plate_modulus(E: Floats, G: Floats) -> Floats:
    """Return E' = E/(1 − ν²), that of a strip kept straight across."""
    nu = E / (2.0 * G) - 1.0
    if (nu > 0.5 + ROUNDING).any():
        raise ValueError(f"no isotropic material has ν = E/2G − 1 = {nu.max()}, above ½")
    return np.asarray(E / (1.0 - nu**2))


def _lost_share(u: Floats) -> Floats:
    """Return 1 − tanh(u)/u to all digits, u > 0.

    Lambert's fraction of tanh has positive terms, where the difference would lose u² of its
    digits; beyond 1 the difference is safe, and the fraction too short.
    """
    square = np.minimum(u, 1.0) ** 2
    tail = np.zeros_like(square)
    for odd in (17.0, 15.0, 13.0, 11.0, 9.0, 7.0, 5.0, 3.0):
        tail = square / (odd + tail)
    return np.where(u < 1.0, tail / (1.0 + tail), 1.0 - np.tanh(u) / u)


def thick_strip_error(
    *, E: ArrayLike, G: ArrayLike, h: ArrayLike, b: ArrayLike, l: ArrayLike
) -> Floats:
    """Return by how much a strip is softer than its stiffness, as its edges warp less [-].

    Saint-Venant's series gives a warping constant some 0.8 h/b below that of a thin strip.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus of an isotropic material [Pa]; broadcast.
    h, b, l : array_like
        Thickness, width and length, h ≤ 0.2 b [m]; broadcast.

    Returns
    -------
    array
        Share of the stiffness.

    """
    E_, G_, h_, b_, l_ = np.broadcast_arrays(*positive(E=E, G=G, h=h, b=b, l=l))
    u = _length_in_warping_decays(E_, G_, h_, b_, l_) / 2.0
    less = np.minimum(SERIES_BELOW_STRIP * h_ / b_, 0.9)
    return np.asarray(1.0 - _lost_share(u) / _lost_share(u / np.sqrt(1.0 - less)))


def restrained_stiffness(
    *, E: ArrayLike, G: ArrayLike, h: ArrayLike, b: ArrayLike, l: ArrayLike
) -> Floats:
    """Return the torsional stiffness of a thin strip clamped so that neither end can warp.

    ``K = G J/l / (1 − (2/λ) tanh(λ/2))`` with ``λ = l √(G J/(E' Γ))``, ``Γ = b³h³/144`` and
    ``E' = E/(1 − ν²)``.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus of an isotropic material, ν = E/2G − 1 [Pa]; broadcast.
    h, b, l : array_like
        Thickness, width and length of the strip [m]; broadcast.

    Returns
    -------
    K : array
        Torsional stiffness [N·m/rad].

    Notes
    -----
    From 12 E'Γ/l³ (short) to G J/l (long). Against a clamped Kirchhoff plate solved by Ritz's
    method it is within 0.6 % for l ≥ b and 0.8 % for l ≥ b/2 (ν = 0 and 0.3); Vlasov's E in the
    place of E' is 2.9 % low at l = b and 5.6 % at l = b/2. Free warping is 16 % low at l = 3 b.

    Raises
    ------
    ValueError
        When an argument is not positive and finite, or E > 3 G.

    Examples
    --------
    >>> K = restrained_stiffness(E=2.6, G=1.0, h=0.01, b=1.0, l=1.0)
    >>> round(float(K) / (0.01**3 / 3 * (1 - 0.63 * 0.01)), 3)
    1.899

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 5.3; Reissner & Stein (1951),
    NACA TN 2369, for E/(1 − ν²) in a plate that stays straight across.

    """
    E_, G_, h_, b_, l_ = positive(E=E, G=G, h=h, b=b, l=l)
    half = _length_in_warping_decays(E_, G_, h_, b_, l_) / 2.0
    return np.asarray(G_ * torsion_constant(h_, b_) / l_ / _lost_share(half))


class TwistStress(NamedTuple):
    """Stresses of a twisted strip with clamped ends [Pa]."""

    shear: Floats
    """At mid-length, in the middle of the broad sides."""
    normal: Floats
    """At both ends, at the corners of the section, of either sign."""


def restrained_stresses(
    *, E: ArrayLike, G: ArrayLike, h: ArrayLike, b: ArrayLike, l: ArrayLike, theta: ArrayLike
) -> TwistStress:
    """Return the stresses of a thin strip that is twisted by θ between ends that cannot warp.

    ``τ = k G h φ'`` with ``φ' = (K θ/GJ)(1 − 1/cosh(λ/2))`` at mid-length;
    ``σ = E' (b h/4) φ''`` with ``φ'' = (K θ/GJ)(λ/l) tanh(λ/2)`` at the ends.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus of an isotropic material [Pa]; broadcast.
    h, b, l : array_like
        Thickness, width and length of the strip [m]; broadcast.
    theta : array_like
        Twist [rad]; broadcasts.

    Returns
    -------
    shear : array
        Largest shear stress of Saint-Venant's torsion, at mid-length [Pa].
    normal : array
        Largest normal stress of the restraint, at the corners of the clamped ends [Pa].

    Notes
    -----
    l ≥ b/2 and b ≥ 5 h. Without the concentration at the clamped corners; the two act at
    different places, so that the equivalent stress is the larger of √3 τ and σ.

    Raises
    ------
    ValueError
        When a modulus or a dimension is not positive and finite, or E > 3 G.

    Examples
    --------
    >>> at = restrained_stresses(E=2.6, G=1.0, h=0.01, b=0.1, l=1e4, theta=1.0)
    >>> round(float(at.shear) * 1e6, 4)
    1.0

    References
    ----------
    Timoshenko & Gere (1961), Theory of Elastic Stability, section 5.3; Reissner & Stein (1951),
    NACA TN 2369.

    """
    E_, G_, h_, b_, l_ = positive(E=E, G=G, h=h, b=b, l=l)
    length = _length_in_warping_decays(E_, G_, h_, b_, l_)
    J = torsion_constant(h_, b_)
    K = restrained_stiffness(E=E_, G=G_, h=h_, b=b_, l=l_)
    rate = K * np.asarray(theta) / (G_ * J)
    # 1 − 1/cosh x = 2 sinh²(x/2)/cosh x, in powers of e^(−x), which neither cancel nor overflow
    fading = np.exp(-length / 2.0)
    middle = np.expm1(-length / 2.0) ** 2 / (1.0 + fading**2)
    bend = rate * length / l_ * np.tanh(length / 2.0)
    return TwistStress(
        shear=np.asarray(shear_factor(h_, b_) * G_ * np.minimum(h_, b_) * rate * middle),
        normal=np.asarray(_plate_modulus(E_, G_) * b_ * h_ / 4.0 * bend),
    )


_STRIP = {"E": 2.6, "G": 1.0, "h": 0.01, "b": 1.0}
"""Numbers without a unit, for the chart of a ratio: ν = 0.3, a strip."""

CARDS: tuple[Card, ...] = (
    Card(
        name="restrained-torsion",
        function=restrained_stiffness,
        example={"E": 114e9, "G": 42.5e9, "h": 0.5e-3, "b": 10e-3, "l": 20e-3},
        validity=(
            Range("h/b", most=0.2, why="the warping function y z is that of a strip"),
            Range("l/b", least=0.5, why="shorter plates are outside what was compared"),
        ),
        tables={
            "slenderness": Table(
                variable="l/b",
                values=(0.5, 1.0, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0),
                columns={
                    "K l/(G J)": (
                        "",
                        lambda ratio: float(
                            restrained_stiffness(**_STRIP, l=ratio)
                            * ratio
                            / torsion_constant(_STRIP["h"], _STRIP["b"])
                        ),
                    ),
                },
                note="thin strip of ν = 0.3",
            )
        },
        kind=QuantityKind.STIFFNESS,
    ),
    Card(
        name="restrained-torsion-stress",
        function=restrained_stresses,
        example={
            "E": 114e9,
            "G": 42.5e9,
            "h": 0.5e-3,
            "b": 10e-3,
            "l": 20e-3,
            "theta": 0.1,
        },
        validity=(
            Range("h/b", most=0.2, why="the warping function y z is that of a strip"),
            Range("l/b", least=0.5, why="shorter plates are outside what was compared"),
        ),
        kind=QuantityKind.STRESS,
    ),
)
