"""A blade or rod between rigid clamps in space: six springs at its middle, each with its error.

x along it, y across its thickness, z across its width. The springs are those of beams times the
factors of plates (bending across the thickness), of sheets (in its own plane) and of restrained
warping (torsion).
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas.arguments import positive
from flexcli.formulas.blade_spring import middle_stiffness
from flexcli.formulas.card import Card, Range
from flexcli.formulas.restrained_torsion import restrained_stiffness, restraint_error

__all__ = [
    "CARDS",
    "NARROWER",
    "OF_RODS",
    "VALIDITY",
    "WIDE",
    "Across",
    "ClampedSprings",
    "clamped_blade",
    "clamped_rod",
]

Floats = NDArray[np.float64]

ROUND_SHEAR = 0.15
"""Share of the shear of a round rod that its shear factor is uncertain by [-]."""

OF_DIRECTION, SHEAR_DIRECTION, TWIST_DIRECTION = 0.5, 0.04, 0.03
"""How far factors of isotropic plates and sheets are off those of directed ones, for each |ln γ|:
as a share of what they widen by; of the S shape across the width and of torsion besides [-]."""

EDGE = 0.63
"""Share of the torsion constant that the ends of a thin section take, times h/b [-]."""

WIDE, WIDEST = 4.0, 8.0
"""b/l from which, and up to which, errors grow by what follows."""

WIDE_BENT, WIDE_TWISTED = 0.05, 0.12
"""Times ν², by how much more very wide blades are off across their thickness, and stiffer in
torsion: solids of b up to 60 l had 0.033 and 0.098."""

VALIDITY = (
    Range("b/l", most=60.0, why="wider blades were not compared with solids"),
    Range("h/l", most=0.3, why="thicker ones were not compared with solids"),
)
"""Blades of an isotropic material whose springs are those of CalculiX's solids, h ≤ b."""

NARROWER = (
    Range("b/l", most=2.0, why="wider ones were not compared"),
    Range("h/l", most=0.2, why="thicker ones were not compared"),
)
"""The same of their stress, and of plates that are stiffer one way, b as of an isotropic one."""

OF_RODS = (Range("d/l", most=0.2, why="thicker ones are no beams between their clamps"),)


class Across(NamedTuple):
    """What a blade that is stiffer one way has beside E along it and G of its broad faces.

    ``nu`` is √(ν_13 ν_31), 1 along it and 3 across its width; ``wider`` is (E_1/E_3)^¼ [-];
    ``G_thin`` is the shear modulus of its narrow sides, plane 12 [Pa]; ``skew`` is
    S_16²/(S_11 S_66), by which pulling it shears these sides [-].
    """

    nu: float
    wider: float
    G_thin: float
    skew: float = 0.0


class ClampedSprings(NamedTuple):
    """Six springs at the middle, shape (..., 6): along x, y, z [N/m], about them [N·m/rad].

    ``low`` and ``high`` are between what relative errors each is: true = stiffness · (1 + error).
    """

    stiffness: Floats
    low: Floats
    high: Floats


def clamped_blade(
    *,
    E: ArrayLike,
    G: ArrayLike,
    h: ArrayLike,
    l: ArrayLike,
    b: ArrayLike,
    across: Across | None = None,
) -> ClampedSprings:
    """Return the six springs of a rectangular blade between rigid clamps.

    The springs of ``blade-support-stiffness``, times ``sheet-axial`` (x), ``plate-guided`` (y),
    ``sheet-guided`` (z), ``sheet-bending`` (θ_y), ``plate-pure-bending`` (θ_z); torsion as
    ``restrained-torsion``.

    Parameters
    ----------
    E, G : array_like
        Young's modulus along it and shear modulus of its broad faces [Pa]; broadcast.
    h, l, b : array_like
        Thickness, length and width [m]; h ≤ b.
    across : Across, optional
        What else it has if it is stiffer one way; left out, it is isotropic.

    Returns
    -------
    ClampedSprings
        Stiffness with errors, shape (..., 6).

    Notes
    -----
    Small motion, both ends on rigid bodies. An orthotropic plate or sheet of width b is the
    isotropic one of width b (E_1/E_3)^¼ and ν = √(ν_13 ν_31) but for its shear modulus, γ times
    √(E_1 E_3)/(2 (1 + ν)): factors are those of γ = 1, and the error has by how far they are off in
    Ritz solutions with γ from ¼ to 4, 0 ≤ ν ≤ 0.42 and a width so scaled of at most 2 l.

    Examples
    --------
    >>> k = clamped_blade(E=120.0, G=48.0, h=0.01, l=1.0, b=0.3)
    >>> round(float(k.stiffness[5] / (120.0 * 0.3 * 0.01**3 / 12.0)), 3)
    1.015

    References
    ----------
    Przemieniecki (1968), Theory of Matrix Structural Analysis, section 5.6, stated at the middle;
    the factors are derived here.

    """
    E_, G_, h_, l_, b_ = np.broadcast_arrays(*positive(E=E, G=G, h=h, l=l, b=b))
    nu = E_ / (2.0 * G_) - 1.0 if across is None else np.full_like(E_, across.nu)
    wider, G_thin, skew = (1.0, G_, 0.0) if across is None else across[1:]
    gamma = np.ones_like(E_) if across is None else 2.0 * (1.0 + nu) * G_ * wider**2 / E_
    beam = middle_stiffness(E=E_, G=G_, h=h_, l=l_, b=b_)
    size = {"b": wider * b_, "l": l_, "poisson_ratio": nu}
    pure, thin_pure = plates.pure_bending_factor(**size, h=h_), plates.pure_bending_factor(**size)
    guided, thin_guided = plates.guided_factor(**size, h=h_), plates.guided_factor(**size)
    Phi = 1.2 * E_ / G_thin * (h_ / l_) ** 2
    # clamps hold a thick blade's thickness too, which a plate or sheet narrows and widens
    held = nu**2 * h_ / l_
    more_pure, more_guided = (
        plates.beyond_plate(
            h=h_, l=l_, poisson_ratio=nu, flat=plates.flat_share(factor, nu), ends=ends
        )[1]
        for factor, ends in ((pure, 2.0), (guided, 6.0))
    )
    off_pure = plates.factor_error(pure, thin_pure) + held * h_ / l_
    # clamps make the shear more even and less soft
    off_guided = plates.factor_error(guided, thin_guided) + Phi / 10.0 + held / 2.0
    more = nu**2 * np.clip((b_ / l_ - WIDE) / (WIDEST - WIDE), 0.0, 1.0)
    off_pure, off_guided = off_pure + WIDE_BENT * more, off_guided + WIDE_BENT * more
    twist = restraint_error(nu=nu, h=h_, b=wider * b_, l=l_).stiffness
    stretched, flat = sheets.axial_factor(**size), sheets.bending_factor(**size)
    stiffness = (
        beam.x * stretched,
        12.0 * beam.theta_z / l_**2 / (1.0 + Phi) * guided,
        beam.z * sheets.guided_factor(**size, shear=gamma),
        restrained_stiffness(E=E_, G=G_, h=h_, b=b_, l=l_, poisson_ratio=nu),
        beam.theta_y * flat,
        beam.theta_z * pure,
    )
    sheet, bent = sheets.SHEET_ERROR, sheets.GUIDED_ERROR
    low = (sheet, off_guided, bent, -twist.low, sheet, off_pure)
    twisted = np.maximum(twist.high, 0.0) + WIDE_TWISTED * more
    high_guided = off_guided + np.maximum(more_guided - held / 2.0, 0.0)
    high_pure = off_pure + more_pure
    high = (sheet + held, high_guided, bent + held, twisted, sheet + held, high_pure)
    if across is not None:
        off = np.abs(np.log(gamma))
        thick = h_ / b_ * np.abs(np.sqrt(G_ / G_thin) - 1.0)
        # of thickness in a plate that is stiffer one way nothing was compared
        widened = [
            OF_DIRECTION * off * (factor - 1.0) + (thin - factor)
            for factor, thin in (
                (stretched, stretched), (guided, thin_guided), (flat, flat), (flat, flat),
                (pure, thin_pure),
            )
        ]  # fmt: skip
        widened[2] = widened[2] + SHEAR_DIRECTION * off
        widened.insert(3, TWIST_DIRECTION * off + EDGE * thick)
        low = tuple(own + more for own, more in zip(low, widened, strict=True))
        high = tuple(
            own + more + skew / (1.0 - skew) for own, more in zip(high, widened, strict=True)
        )
    return ClampedSprings(_stacked(stiffness), -_stacked(low), _stacked(high))


def clamped_rod(*, E: ArrayLike, G: ArrayLike, d: ArrayLike, l: ArrayLike) -> ClampedSprings:
    """Return the six springs of a round rod between rigid clamps.

    ``k_x = E A/l``, ``k_y = k_z = 12 E I/(l³ (1 + Φ))``, ``k_θx = G J/l``,
    ``k_θy = k_θz = E I/l`` with ``I = π d⁴/64 = J/2`` and
    ``Φ = 12 E I/(κ G A l²)``, ``κ = 6 (1 + ν)/(7 + 6 ν)``.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus of an isotropic material [Pa]; broadcast.
    d, l : array_like
        Diameter and length [m].

    Returns
    -------
    ClampedSprings
        Stiffness with errors, shape (..., 6).

    Notes
    -----
    Clamps keep the rod from narrowing near them: it is stiffer than the beam, and at most as
    much as a plate as wide as its diameter, 2.6 ν² d/l.

    Examples
    --------
    >>> k = clamped_rod(E=2.6, G=1.0, d=0.02, l=1.0)
    >>> round(float(k.stiffness[5] / k.stiffness[3]), 3)
    1.3

    References
    ----------
    Cowper (1966), The shear coefficient in Timoshenko's beam theory, J. Appl. Mech. 33, 335-340.

    """
    E_, G_, d_, l_ = np.broadcast_arrays(*positive(E=E, G=G, d=d, l=l))
    nu = E_ / (2.0 * G_) - 1.0
    A, I = np.pi * d_**2 / 4.0, np.pi * d_**4 / 64.0
    kappa = 6.0 * (1.0 + nu) / (7.0 + 6.0 * nu)
    Phi = 12.0 * E_ * I / (kappa * G_ * A * l_**2)
    S, bent = 12.0 * E_ * I / (l_**3 * (1.0 + Phi)), E_ * I / l_
    held = 2.6 * nu**2 * d_ / l_
    sheared = ROUND_SHEAR * Phi
    none = np.zeros_like(held)
    high = (held, held + sheared, held + sheared, none, held, held)
    low = (none, sheared, sheared, none, none, none)
    stiffness = (E_ * A / l_, S, S, 2.0 * G_ * I / l_, bent, bent)
    return ClampedSprings(_stacked(stiffness), -_stacked(low), _stacked(high))


def _stacked(numbers: tuple[ArrayLike, ...]) -> Floats:
    arrays = [np.asarray(number, dtype=np.float64) for number in numbers]
    return np.stack(np.broadcast_arrays(*arrays), axis=-1)


CARDS = (
    Card(
        "clamped-blade",
        clamped_blade,
        {"E": 114e9, "G": 42.5e9, "h": 0.25e-3, "l": 30e-3, "b": 10e-3},
        VALIDITY,
    ),
    Card(
        "clamped-rod",
        clamped_rod,
        {"E": 114e9, "G": 42.5e9, "d": 0.5e-3, "l": 30e-3},
        OF_RODS,
    ),
)
