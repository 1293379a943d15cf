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

__all__ = ["CARDS", "VALIDITY", "ClampedSprings", "clamped_blade", "clamped_rod"]

Floats = NDArray[np.float64]

ROUND_SHEAR = 0.15
"""Share of the shear of a round rod that its shear factor is uncertain by [-]."""

VALIDITY = (
    Range("b/l", most=2.0, why="a wider blade was not compared in torsion"),
    Range("h/l", most=0.2, why="thicker ones are no beams or plates between their clamps"),
)


class ClampedSprings(NamedTuple):
    """Six springs at the middle, shape (..., 6): along x, y, z [N/m], about them [N·m/rad].

    ``low`` and ``high`` are between what relative errors each is: true = stiffness · (1 + error).
    """

    stiffness: Floats
    low: Floats
    high: Floats


def clamped_blade(
    *, E: ArrayLike, G: ArrayLike, h: ArrayLike, l: ArrayLike, b: ArrayLike
) -> ClampedSprings:
    """Return the six springs of a rectangular blade between rigid clamps.

    The springs of ``blade-support-stiffness``, times ``sheet-axial`` (x), ``plate-guided`` (y),
    ``sheet-guided`` (z), ``sheet-bending`` (θ_y), ``plate-pure-bending`` (θ_z); torsion as
    ``restrained-torsion``.

    Parameters
    ----------
    E, G : array_like
        Young's and shear modulus of an isotropic material [Pa]; broadcast.
    h, l, b : array_like
        Thickness, length and width [m]; h ≤ b.

    Returns
    -------
    ClampedSprings
        Stiffness with errors, shape (..., 6).

    Notes
    -----
    Small motion, both ends on rigid bodies.

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
    nu = E_ / (2.0 * G_) - 1.0
    beam = middle_stiffness(E=E_, G=G_, h=h_, l=l_, b=b_)
    size = {"b": b_, "l": l_, "poisson_ratio": nu}
    pure, thin_pure = plates.pure_bending_factor(**size, h=h_), plates.pure_bending_factor(**size)
    guided, thin_guided = plates.guided_factor(**size, h=h_), plates.guided_factor(**size)
    Phi = 2.4 * (1.0 + nu) * (h_ / l_) ** 2
    off_pure = plates.factor_error(pure, thin_pure)
    # clamps make the shear more even and less soft
    off_guided = plates.factor_error(guided, thin_guided) + Phi / 10.0
    # clamps hold a thick blade's thickness too, which a sheet's narrows and widens
    held = nu**2 * h_ / l_
    twist = restraint_error(nu=nu, h=h_, b=b_, l=l_).stiffness
    stiffness = (
        beam.x * sheets.axial_factor(**size),
        beam.y * guided,
        beam.z * sheets.guided_factor(**size),
        restrained_stiffness(E=E_, G=G_, h=h_, b=b_, l=l_),
        beam.theta_y * sheets.bending_factor(**size),
        beam.theta_z * pure,
    )
    sheet, bent = sheets.SHEET_ERROR, sheets.GUIDED_ERROR
    low = (sheet, off_guided, bent, -twist.low, sheet, off_pure)
    high = (sheet + held, off_guided, bent + held, twist.high, sheet + held, off_pure)
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
        (Range("d/l", most=0.2, why="thicker ones are no beams between their clamps"),),
    ),
)
