"""Torsion of a rectangular bar whose clamped ends cannot warp: stiffness and stresses."""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas.arguments import positive
from flexcli.formulas.card import Card, Range, Table
from flexcli.formulas.torsion_section import (
    narrow_shear_factor,
    shear_factor,
    torsion_constant,
    warping,
)
from flexcli.results import QuantityKind

__all__ = [
    "CARDS",
    "ErrorBand",
    "RestraintError",
    "TwistStress",
    "restrained_stiffness",
    "restrained_stresses",
    "restraint_error",
]

Floats = NDArray[np.float64]

ROUNDING = 1e-9
"""How far above ½ Poisson's ratio may come out of moduli rounded for ν = ½."""


CONVERGED = 2e-3
"""Largest error of the blocks that bars were compared with."""

LEAST_LENGTH = 0.25
"""l/b of the shortest blocks that bars were compared with, but for thin ones (0.05)."""

SHORTER = 0.3
"""How much more the shares of shorter ones may be off, for each b/(b + l) above that length's:
blocks of l/b = 0.05 to 0.2 and h/l ≤ ½ had 0.016 at most of 0.045."""

TOLD = 0.5
"""h/b up to which the normal stress was compared with blocks."""


class ErrorBand(NamedTuple):
    """Least and largest relative error [-]."""

    low: Floats
    high: Floats

    @property
    def middle(self) -> Floats:
        """Return the change that leaves as much to either side; none is a rise, nor an unknown."""
        halfway = np.minimum((self.low + self.high) / 2.0, 0.0)
        return np.asarray(np.where(self.low > -1.0, halfway, 0.0))

    @property
    def left(self) -> "ErrorBand":
        """Return what is left of it where the middle is counted."""
        counted = 1.0 + self.middle
        return ErrorBand((1.0 + self.low) / counted - 1.0, (1.0 + self.high) / counted - 1.0)

    @property
    def around(self) -> Floats:
        """Return what the middle leaves to either side, over the value that is changed so."""
        return np.asarray(np.maximum(self.left.high, -self.left.low))


class TwistStress(NamedTuple):
    """Stresses of a twisted bar with clamped ends [Pa]."""

    shear: Floats
    """At mid-length, in the middle of the broad sides."""
    normal: Floats
    """At both ends, where the section warps most, of either sign."""
    narrow: Floats
    """Shear at mid-length, in the middle of the narrow sides: the most of short, thick bars."""


class RestraintError(NamedTuple):
    """Relative errors of a bar whose ends cannot warp: true = computed · (1 + error)."""

    stiffness: ErrorBand
    shear: ErrorBand
    normal: ErrorBand
    narrow: ErrorBand


class _Bar(NamedTuple):
    """A bar between rigid ends, and what its twist needs."""

    GJ: Floats
    apart: Floats
    """1 − J/I_p: share of its twist that warping takes part in."""
    half: Floats
    """Half its length in lengths in which warping decays."""
    largest: Floats
    """Largest warping of the section [m²]."""
    plate_modulus: Floats

    @property
    def softness(self) -> Floats:
        """Return ``J/I_p + (1 − J/I_p)(1 − tanh(u)/u)``, 1 of a bar that may warp."""
        return np.asarray(1.0 - self.apart + self.apart * _lost_share(self.half))


def _bar(
    E: Floats, G: Floats, h: Floats, b: Floats, l: Floats, poisson_ratio: ArrayLike | None
) -> _Bar:
    modulus = _plate_modulus(E, G, poisson_ratio)
    J, section = torsion_constant(h, b), warping(h, b)
    apart = 1.0 - 12.0 * J / (b * h * (b**2 + h**2))
    half = l / 2.0 * np.sqrt(G * J * apart / (modulus * section.constant))
    return _Bar(np.asarray(G * J), apart, half, section.largest, modulus)


def _plate_modulus(E: Floats, G: Floats, poisson_ratio: ArrayLike | None) -> Floats:
    """Return E' = E/(1 − ν²), that of a strip kept straight across."""
    if poisson_ratio is not None:
        return np.asarray(E / (1.0 - np.asarray(poisson_ratio) ** 2))
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


def restrained_stiffness(
    *,
    E: ArrayLike,
    G: ArrayLike,
    h: ArrayLike,
    b: ArrayLike,
    l: ArrayLike,
    poisson_ratio: ArrayLike | None = None,
) -> Floats:
    """Return the torsional stiffness of a rectangular bar clamped so that neither end can warp.

    ``K = (G J/l)/(s + (1 − s)(1 − tanh(u)/u))`` with ``s = J/I_p``,
    ``u = (l/2) √(G J (1 − s)/(E' Γ))`` and ``E' = E/(1 − ν²)``; J, Γ by Saint-Venant's series.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus [Pa]; broadcast.
    h, b, l : array_like
        Sides of the section in either order, and length [m]; broadcast.
    poisson_ratio : array_like, optional
        ν where the material is stiffer one way: √(ν_13 ν_31), 3 across the width; left out, that of
        an isotropic one, E/2G − 1 [-].

    Returns
    -------
    K : array
        Torsional stiffness [N·m/rad].

    Notes
    -----
    The section warps by f ψ(y, z), f being free of the rate of twist φ' (Benscoter):
    ``G I_p φ' = T + G (I_p − J) f``, ``E' Γ f'' = G (I_p − J)(f − φ')``. From G I_p/l (short) to
    G J/l (long); of a strip, s = 4 (h/b)², it is Vlasov's with E' in the place of E. Its error is
    ``restraint_error``: Vlasov's f = φ' is 53 % too stiff at h = 0.35 b, l = b/2.

    Raises
    ------
    ValueError
        When an argument is not positive and finite, or E > 3 G.

    Examples
    --------
    >>> K = restrained_stiffness(E=2.6, G=1.0, h=0.01, b=1.0, l=1.0)
    >>> round(float(K) / (0.01**3 / 3 * (1 - 0.63 * 0.01)), 3)
    1.898

    References
    ----------
    Benscoter (1954), A theory of torsion bending for multicell beams, J. Appl. Mech. 21, 25-34;
    Reissner & Stein (1951), NACA TN 2369, for E/(1 − ν²) in a plate that stays straight across.

    """
    E_, G_, h_, b_, l_ = positive(E=E, G=G, h=h, b=b, l=l)
    bar = _bar(E_, G_, h_, b_, l_, poisson_ratio)
    return np.asarray(bar.GJ / l_ / bar.softness)


def restrained_stresses(
    *,
    E: ArrayLike,
    G: ArrayLike,
    h: ArrayLike,
    b: ArrayLike,
    l: ArrayLike,
    theta: ArrayLike,
    poisson_ratio: ArrayLike | None = None,
) -> TwistStress:
    """Return the stresses of a rectangular bar that is twisted by θ between ends that cannot warp.

    ``τ = G h ((k − ½) f + ½ φ')`` with ``f = (K θ/GJ)(1 − 1/cosh u)`` at mid-length and
    ``φ' = s K θ/GJ + (1 − s) f``; ``σ = E' ψ f'`` at the largest warping ψ, with
    ``f' = (K θ/GJ)(2 u/l) tanh u`` at the ends; in the narrow sides
    ``τ = G (¾ b (φ' − f) + k_n h f)``.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus [Pa]; broadcast.
    h, b, l : array_like
        Sides of the section in either order, and length [m]; broadcast.
    theta : array_like
        Twist [rad]; broadcasts.
    poisson_ratio : array_like, optional
        As of ``restrained_stiffness`` [-].

    Returns
    -------
    shear : array
        Largest shear stress, at mid-length [Pa].
    normal : array
        Largest normal stress of the restraint, at the clamped ends [Pa].
    narrow : array
        Shear stress at mid-length in the middle of the narrow sides [Pa].

    Notes
    -----
    Without the concentration at the clamped corners; they act at different places, so that the
    equivalent stress is the largest of √3 τ and σ. Short bars of h > 0.3 b are sheared most in
    their narrow sides: each edge is a short beam there, its shear a parabola across h, 3/2 of the
    mean. Errors are those of ``restraint_error``.

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
    Benscoter (1954), A theory of torsion bending for multicell beams, J. Appl. Mech. 21, 25-34.

    """
    E_, G_, h_, b_, l_ = positive(E=E, G=G, h=h, b=b, l=l)
    bar = _bar(E_, G_, h_, b_, l_, poisson_ratio)
    long = np.asarray(theta) / l_ / bar.softness
    # 1 − 1/cosh x = 2 sinh²(x/2)/cosh x, in powers of e^(−x), which neither cancel nor overflow
    fading = np.exp(-bar.half)
    warps = long * np.expm1(-bar.half) ** 2 / (1.0 + fading**2)
    apart = (1.0 - bar.apart) * long * 2.0 * fading / (1.0 + fading**2)
    rate = (1.0 - bar.apart) * long + bar.apart * warps
    sheared = (shear_factor(h_, b_) - 0.5) * warps + 0.5 * rate
    bend = long * 2.0 * bar.half / l_ * np.tanh(bar.half)
    thin, broad = np.minimum(h_, b_), np.maximum(h_, b_)
    edge = 0.75 * broad * apart + narrow_shear_factor(h_, b_) * thin * warps
    return TwistStress(
        shear=np.asarray(G_ * thin * sheared),
        normal=np.asarray(bar.plate_modulus * bar.largest * bend),
        narrow=np.asarray(G_ * edge),
    )


def restraint_error(*, nu: ArrayLike, h: ArrayLike, b: ArrayLike, l: ArrayLike) -> RestraintError:
    """Return how far bars whose ends cannot warp may be from elastic blocks between rigid bodies.

    ``1/(1 + s ± e) − 1`` with the share s by which a thin plate is softer, or stressed less, and
    what its thickness adds; ``e = (0.002 + 0.03 t) min(1, 4 y)`` of the stiffness, t ≤ 0.4, and
    ``0.0045 + 0.045 t + 0.03 ν⁴`` of the normal stress; t = h/b, y = b/(b + l). Of shear an
    envelope.

    Parameters
    ----------
    nu : array_like
        Poisson's ratio, −1 to ½ [-]; broadcasts.
    h, b, l : array_like
        Sides of the section in either order, and length [m]; broadcast.

    Returns
    -------
    RestraintError
        Of the stiffness, of the shear at mid-length, of the normal stress at the ends (by its
        moment of warping, ∫σ y z dA; beyond h = b/2 nothing but its sign is told, by ∫σ ψ dA), of
        the shear in the narrow sides [-].

    Notes
    -----
    Thin: fitted to Kirchhoff plates by Ritz's method at 19 and more l/b from 0.02 to 12 and ν from
    0 to ½, within 0.0008 (stiffness) and 0.001 (stress). What thickness adds: to 780 blocks by
    Ritz's method in three dimensions, h/b from 0.01 to 1, l/b from 0.25 to 6, ν from 0 to 0.49; e
    has a tenth more than fits leave of them, or more. Shorter bars, and those of ν < 0 (as of
    ν = 0, but for what plates of ν = −0.3 to −0.9 had less), are less sure. From l = b/4 on a bar
    is never stiffer than computed: between clamps that keep the section from narrowing E' is the
    most that its fibres resist with, and E the least, far from them or in a thick bar.

    Examples
    --------
    >>> error = restraint_error(nu=0.3, h=0.1, b=1.0, l=2.0)
    >>> round(float(error.stiffness.low), 4), round(float(error.stiffness.high), 4)
    (-0.011, -0.0011)

    """
    h_, b_, l_ = positive(h=h, b=b, l=l)
    given = np.asarray(nu, dtype=np.float64)
    nu_, less = np.maximum(given, 0.0), np.maximum(-given, 0.0)
    broad = np.maximum(h_, b_)
    thick, short = np.minimum(h_, b_) / broad, broad / l_
    near = short / (1.0 + short)
    shorter = SHORTER * np.maximum(near - 1.0 / (1.0 + LEAST_LENGTH), 0.0)
    soft_left = (0.002 + 0.03 * np.minimum(thick, 0.4)) * np.minimum(1.0, 4.0 * near)
    held_left = 0.0045 + 0.045 * thick + 0.03 * nu_**4
    stiffness = _lowered(_softer(nu_, thick, near), soft_left + 0.09 * less, shorter)
    normal = _lowered(_less_stressed(nu_, thick, near), held_left + 0.3 * less, shorter)
    uneven = 1.2 / (1.0 / short + 0.2) * (0.008 + 0.09 * nu_**2 + np.minimum(0.14 * thick, 0.035))
    uneven = uneven + short**2 * np.minimum(0.25 * thick, 0.05)
    steep = 0.05 * np.minimum(1.0, (1.6 * short) ** 3) + 0.1 * less
    parabola = near**2 * (0.15 + 14.0 * nu_**2 * near**2 / (1.0 + 14.0 * thick)) + 0.1 * less
    return RestraintError(
        stiffness=stiffness,
        shear=ErrorBand(-uneven / (1.0 + uneven) - CONVERGED, steep + CONVERGED),
        normal=ErrorBand(
            np.where(thick > TOLD, -1.0, normal.low), np.where(thick > TOLD, CONVERGED, normal.high)
        ),
        narrow=ErrorBand(-0.55 * near**2 - CONVERGED, parabola + CONVERGED),
    )


def _thickness(thick: Floats, near: Floats) -> tuple[Floats, Floats]:
    """Return what shear changes, as (h/l)² where that is small, and what clamps hold, as h/l."""
    slope = thick * near / (1.0 - near)
    return slope**2 / (1.0 + 3.0 * slope**2), slope / (1.0 + 2.0 * slope)


def _softer(nu: Floats, thick: Floats, near: Floats) -> Floats:
    """Return the share by which a bar is softer than computed, of ``restraint_error``."""
    sheared, held = _thickness(thick, near)
    # of terms in y: what a wide plate has, y → 1, is nothing
    thin = 0.0335 * nu - near**3 * (0.0908 + 6.3413 * near * nu**4)
    thin = thin + near * (0.0666 - 0.7366 * nu + 1.0392 * nu**2)
    thin = thin + near**2 * nu * (0.7505 - 2.2278 * nu**2 + 8.2217 * nu**3)
    added = near * sheared * (0.5675 + thick * (14.845 * near**3 * nu**4 - 1.0455))
    added = added + 0.2795 * near**2 * thick
    clamped = nu**2 * (0.1671 - 0.463 * thick - 10.436 * near**4 * nu**2) - 0.0683 * near**2
    return near * (1.0 - near) * thin + added + held * clamped


def _less_stressed(nu: Floats, thick: Floats, near: Floats) -> Floats:
    """Return the share by which its ends are stressed less than computed, of the same."""
    sheared, held = _thickness(thick, near)
    thin = 0.0074 + 0.1303 * nu**2 + near * (0.0776 - 0.724 * nu + 2.0145 * nu**3)
    thin = thin + near**2 * (0.8473 * nu - 0.3162 * near**2 + 0.2329 * near**4)
    thin = thin - 3.8512 * near**5 * nu**4
    added = thick * (0.793 * thick + 0.208 * near + 0.0824 * nu**2)
    added = added + near**3 * sheared * (0.759 + 24.9 * near * thick**3)
    return (1.0 - near) * thin + added - near**3 * held * (9.36 * near * nu**4 + 8.96 * thick**2)


def _lowered(share: Floats, error: Floats, shorter: Floats) -> ErrorBand:
    """Return the range of 1/(1 + share ± error) − 1, above 0 where bars are shorter than compared.

    And of what was compared.
    """
    off = error + shorter
    low, high = 1.0 / (1.0 + share + off) - 1.0, 1.0 / (1.0 + share - off) - 1.0
    return ErrorBand(np.asarray(low), np.asarray(np.minimum(high, shorter + CONVERGED)))


_STRIP = {"E": 2.6, "G": 1.0, "h": 0.01, "b": 1.0}
"""Numbers without a unit, for the chart of a ratio: ν = 0.3, a strip."""

SHORTEST = Range("l/b", least=LEAST_LENGTH, why="shorter blocks are outside what was compared")

CARDS: tuple[Card, ...] = (
    Card(
        name="restrained-torsion",
        function=restrained_stiffness,
        example={"E": 114e9, "G": 42.5e9, "h": 0.5e-3, "b": 10e-3, "l": 20e-3},
        validity=(SHORTEST,),
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
        validity=(SHORTEST,),
        kind=QuantityKind.STRESS,
    ),
)
