"""Stiffness at rest of a joint whose blades are of a crystal or sheet, beside isotropic blades'."""

from collections.abc import Sequence
from math import sqrt
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.card import Range, outside
from flexcli.formulas.directed_plates import ShapeRanges, beside_isotropic
from flexcli.formulas.profile import Constant
from flexcli.formulas.section import second_moment
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.linear import linear
from flexcli.numerics.rows import number, one_alone
from flexcli.parts.bending.plate_range import shear_of
from flexcli.parts.geometries.base import MOVING, Blade, Held
from flexcli.parts.material import Material
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["COMPARED", "bending_range", "bent_as_plates"]

Floats = NDArray[np.float64]

COMPARED = (
    Range("h/l", most=1.0 / 15.0, why="thicker ones are told worse by plates"),
    Range("b/h", least=1.0, why="plates are no thicker than wide"),
    Range("b/l", most=2.0, why="wider ones were not compared with solids"),
)
"""Blades of a crystal or sheet that were compared with solids."""


SHARED = 0.1
"""Part of how far the shapes of a joint's bending differ that its beams' shares of them leave."""


class _Part(NamedTuple):
    """Twice the energy of a shape of a blade, and what the material may change of its stiffness."""

    energy: float
    low: float
    high: float


def bent_as_plates(
    material: Material, kind: QuantityKind | None, layout: Layout, held: Held
) -> ErrorRange | None:
    """Return what a stiffness or a frequency at rest is off for the anisotropy of its plates.

    Of blades in a plane, ``held`` a unit travel of the moving body; nothing where they are none
    that were compared with solids, or other numbers are asked for.
    """
    if not material.planes or kind not in (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY):
        return None
    nu = material.elastic.most_nu
    found = bending_range(material.planes, nu=nu, along=material.bounds, layout=layout, held=held)
    if found is None or kind is QuantityKind.STIFFNESS:
        return found
    low, high = (sqrt(max(0.0, 1.0 + end)) - 1.0 for end in found)
    return ErrorRange(low, high)


def bending_range(
    planes: Sequence[Floats], *, nu: float, along: ErrorRange, layout: Layout, held: Held
) -> ErrorRange | None:
    """Return what the stiffness of a joint at rest is off that of isotropic blades, relative.

    The even and the odd part of each blade's bending by its own range, with the motions of the
    beams for an upper bound and with their forces for a lower: an arc's ends may twist for the
    lower, as a body that nothing holds out of the plane lets them.

    Parameters
    ----------
    planes : sequence of array, shape (3, 3)
        Compliance of blades in the plane of their faces, of any directions in the joint [1/Pa].
    nu : float
        Poisson's ratio as which they are taken [-].
    along : ErrorRange
        What the stiffness along a blade may be off.
    layout, held : Layout, Held
        The joint in its plane, and a unit travel of its moving body.

    Returns
    -------
    range : ErrorRange or None
        Nothing where any blade is unlike what was compared, or nothing bends.

    Notes
    -----
    Single blades between rigid bodies were compared with CalculiX's bricks, for the constants of
    ``is_compared`` and the sizes of ``COMPARED``: of six cubic crystals and orthotropic sheets up
    to E_1/E_2 = 14, in any direction of the wafers that a spec can state; see
    ``formulas.directed_plates``. Solids of 19 random stages, cantilevers and pivots had 0.55 of it.

    """
    one_alone()
    ranges = dict[tuple[float, float, float], ShapeRanges]()
    solution = linear(layout, {MOVING: held})
    axis = next(i for i in (2, 1) if held[i])
    whole = number(solution.reactions[0, layout.index(MOVING), axis])
    if not solution.unique.all() or whole <= 0.0:
        return None
    parts = list[_Part]()
    for strip, force in zip(layout.blades, solution.end_forces[0], strict=True):
        if not isinstance(strip.profile, Constant) or strip.crossed != (1.0, 1.0):
            return None
        x, y = (float(each) for each in np.subtract(strip.end, strip.start))
        h, l, b = number(strip.profile.h), float(np.hypot(x, y)), number(strip.b)
        E = number(layout.E * strip.stiffer)
        if outside(COMPARED, {"h/l": h / l, "b/h": b / h, "b/l": b / l}):
            return None
        if (h, l, b) not in ranges:
            ranges[h, l, b] = _hull(
                [beside_isotropic(S, h=h, b=b, l=l, poisson_ratio=nu) for S in planes]
            )
        found = ranges[h, l, b]
        last = number(force[2])
        first = last + number(force[1] * x - force[0] * y)
        even, odd = (first + last) / 2.0, (first - last) / 2.0
        turned, stretched = l / (E * number(second_moment(b, h))), l / (E * b * h)
        bent = odd**2 / 3.0 * turned * (1.0 + shear_of(Blade(h, l, b), nu))
        pulled = number(force[0] * x + force[1] * y) / l
        parts += [
            _Part(even**2 * turned, *found.arc),
            _Part(bent, *found.guided),
            _Part(pulled**2 * stretched, *along),
        ]
    return _together(parts, whole)


def _hull(each: Sequence[ShapeRanges]) -> ShapeRanges:
    """Return the ranges that hold all."""
    arcs, guided = zip(*each, strict=True)
    return ShapeRanges(
        (min(low for low, _ in arcs), max(high for _, high in arcs)),
        (min(low for low, _ in guided), max(high for _, high in guided)),
    )


def _together(parts: Sequence[_Part], whole: float) -> ErrorRange:
    """Return the range of the whole, of which springs that are no blades are what is left."""
    shares = [part.energy / whole for part in parts]
    middles = [(part.low + part.high) / 2.0 for part in parts]
    mean = sum(w * m for w, m in zip(shares, middles, strict=True))
    off = SHARED * sum(w * abs(m - mean) for w, m in zip(shares, middles, strict=True))
    high = sum(w * part.high for w, part in zip(shares, parts, strict=True))
    softer = sum(w * -part.low / (1.0 + part.low) for w, part in zip(shares, parts, strict=True))
    return ErrorRange(1.0 / (1.0 + softer) - 1.0 - off, high + off)
