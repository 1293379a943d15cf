"""Ranges of what clamps stiffen of one wide blade: its factors with their errors."""

from math import inf
from typing import Any

from flexcli.formulas import plate_buckling, plate_shortening
from flexcli.formulas import plate_factors as plates
from flexcli.formulas import sheet_factors as sheets
from flexcli.formulas import thick_plates as thick
from flexcli.formulas.section import shear_parameter
from flexcli.numerics.rows import Number, larger, number, smaller
from flexcli.parts.bending.base import SHORTEST, Factor
from flexcli.parts.geometries.base import Blade

__all__ = [
    "HINGED",
    "LOCKED",
    "TINY",
    "UNSURE_ALONG",
    "along_factor",
    "between",
    "blade_factor",
    "buckled",
    "buckling",
    "floats",
    "is_compared",
    "pivot_shift",
    "plate_alone",
    "plate_factor",
    "shear_of",
    "shortening",
]

UNSURE_ALONG = 0.3
"""Part of a pivot's shift along its bisector that shear and the next order in θ may change."""

ENDS = {
    plates.pure_bending_factor: 2.0,
    plates.cantilever_factor: 3.0,
    plates.limb_hinge_factor: 3.0,
}
"""Squares of both end moments of a blade over their mean square along it, 6 of an S at most."""

LOCKED, HINGED = "clamped-clamped", "pinned-pinned"

TINY = 1e-12
"""Share of S-shaped bending below which there is none."""


def blade_factor(formula: Any, blade: Blade, nu: float, **more: float) -> Factor:
    """Return a factor of a formula with its error, of a solid blade between rigid clamps.

    Of one unlike the solids that were compared, it is that of a plate, with what thickness may
    change of it.
    """
    if not _is_bent_as_compared(blade, nu):
        return plate_factor(formula, blade, nu, **more)
    h, l, b = blade
    own = {"h": h, "l": l, "b": b, "poisson_ratio": nu}
    arc, s_shape = number(thick.thick_arc_factor(**own)), number(thick.thick_s_factor(**own))
    value = _of_shapes(formula, arc, s_shape, blade, nu, **more)
    error = number(thick.thick_error(value, h=h, l=l, poisson_ratio=nu))
    return Factor(value, larger(1.0, value - error), value + error)


def is_compared(blade: Blade, nu: float) -> bool:
    """Return whether solids like a blade were compared, bent and stretched."""
    return _is_bent_as_compared(blade, nu) and blade.b <= sheets.WIDEST * blade.l


def _is_bent_as_compared(blade: Blade, nu: float) -> bool:
    h, l, b = blade
    return h <= min(thick.THICKEST * l, b) and 0.0 <= nu <= thick.LARGEST_NU


def along_factor(blade: Blade, nu: float) -> Factor:
    """Return the factor of the stiffness along a blade with its error, between rigid clamps.

    Of one unlike the solids that were compared it is that of a sheet, and what its clamps hold of
    its thickness is in its error.
    """
    h, l, b = blade
    if not is_compared(blade, nu):
        value = number(sheets.axial_factor(b=b, l=l, poisson_ratio=nu))
        held = nu**2 * h / l
        return Factor(value, value - sheets.SHEET_ERROR, value + sheets.SHEET_ERROR + held)
    value = number(sheets.block_axial_factor(h=h, l=l, b=b, poisson_ratio=nu))
    error = sheets.HELD_ERROR * (value - 1.0)
    return Factor(value, value - error, value + error)


def _of_shapes(
    formula: Any, arc: Number, s_shape: Number, blade: Blade, nu: float, **more: float
) -> Number:
    """Return a factor of ``plate_factors`` by those of the two shapes, as its formula has it.

    Where a force bends both, a thick blade has more of the S, by what that shears.
    """
    if formula in (plates.pure_bending_factor, plates.guided_factor):
        return arc if formula is plates.pure_bending_factor else s_shape
    if formula in (plates.pivot_factor, plates.end_moment_factor):
        gamma = abs(0.5 + more["delta"])
        share = 12.0 * gamma**2 if formula is plates.pivot_factor else 6.0 * gamma
        return (arc + share * s_shape) / (1.0 + share)
    arm: Number = more.get("arm", blade.l / 2.0)  # of a cantilever
    turned, sheared = arm**2, blade.l**2 / 12.0 * (1.0 + shear_of(blade, nu))
    return number((turned + sheared) / (turned / arc + sheared / s_shape))


def shear_of(blade: Blade, nu: float) -> float:
    """Return Φ of a blade across its thickness [-]."""
    return number(shear_parameter(depth=blade.h, l=blade.l, poisson_ratio=nu))


def buckled(blade: Blade, nu: float) -> Factor:
    """Return the range of the factor of the force that buckles a blade in any shape between clamps.

    Plates under any axial force, bent evenly or oddly, are softest where their ends have no moment.
    """
    least = buckling(blade, nu, HINGED).low
    most = plate_factor(plates.pure_bending_factor, blade._replace(b=SHORTEST * blade.b), nu).high
    return Factor((least + most) / 2.0, least, most)


def floats(blade: Blade) -> Blade:
    """Return the blade without its fillets, in plain numbers."""
    return Blade(number(blade.h), number(blade.l), number(blade.b))


def shortening(blade: Blade, nu: float) -> tuple[float, float]:
    """Return the extra shortening of a blade over a beam, bent to an arc and to an S [-]."""
    at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
    pure = number(plate_shortening.pure_shortening_factor(**at)) - 1.0
    return pure, number(plate_shortening.s_shortening_factor(**at)) - 1.0


def plate_factor(formula: Any, blade: Blade, nu: float, **more: float) -> Factor:
    """Return a factor of a formula with its error, between beam and flat plate.

    Of blades that a force buckles, that another one clamps, or that are too thick for more.
    """
    at = {"b": blade.b, "l": blade.l, "poisson_ratio": nu, **more}
    value, thin = number(formula(h=blade.h, **at)), number(formula(**at))
    error, ends = number(plates.factor_error(value, thin)), ENDS.get(formula, 6.0)
    return _with_error(value, error, blade, nu, ends)


def buckling(blade: Blade, nu: float, ends: str) -> Factor:
    """Return the range of the factor of the force that buckles a blade, by what holds its ends."""
    at: dict[str, Any] = {"b": blade.b, "l": blade.l, "poisson_ratio": nu, "ends": ends}
    value = number(plate_buckling.buckling_factor(h=blade.h, **at))
    thin = number(plate_buckling.buckling_factor(**at))
    fit = plate_buckling.BUCKLING_ERROR[ends]
    return _with_error(value, number(plates.factor_error(value, thin, fit)), blade, nu)


def plate_alone(formula: Any, blade: Blade, nu: float) -> Factor:
    """Return a factor with its error, of blades that do not shear and whose ends may thin."""
    at = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
    value, thin = number(formula(h=blade.h, **at)), number(formula(**at))
    return _between_beam_and_plate(value, number(plates.factor_error(value, thin)), nu)


def _between_beam_and_plate(value: float, error: float, nu: float) -> Factor:
    most = 1.0 + number(plates.bound(nu))
    return Factor(value, larger(1.0, value - error), smaller(most, value + error))


def _with_error(value: float, error: float, blade: Blade, nu: float, ends: float = 6.0) -> Factor:
    """Return a factor with its range: of thin plates, and what thickness changes of wide ones."""
    flat = plates.flat_share(value, nu)
    beyond = plates.beyond_plate(h=blade.h, l=blade.l, poisson_ratio=nu, flat=flat, ends=ends)
    less, more = (value * number(each) for each in beyond)
    value, low, high, _ = _between_beam_and_plate(value, error, nu)
    return Factor(value, low - less, high + more)


def between(low: float, nu: float) -> Factor:
    """Return a factor between a lower bound and that of a plate kept flat."""
    flat = 1.0 + number(plates.bound(nu))
    return Factor((low + flat) / 2.0, low, flat)


def pivot_shift(gamma: float, pure: float, bent: float) -> tuple[float, float]:
    """Return the change of 5 − 9γ², whose parts −5/2 and −9γ² are shortenings of both shapes."""
    left = 5.0 - 9.0 * gamma**2
    moved = 2.5 * pure + 9.0 * gamma**2 * bent
    if left == 0.0:
        return 0.0, inf if moved else 0.0
    return -moved / left, 0.2 * moved / abs(left)
