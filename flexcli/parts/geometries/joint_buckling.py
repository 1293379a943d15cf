"""Closed forms of the buckling of a joint of equal blades, with their errors."""

from collections.abc import Callable, Sequence
from math import inf, pi

from flexcli.formulas.buckling import thick_load
from flexcli.formulas.joint_buckling import (
    STRAIN,
    held_load,
    pulled_straight,
    shares,
    sway,
    turning_load,
)
from flexcli.formulas.pulled_stage import overturning_tension
from flexcli.formulas.section import second_moment, shear_parameter
from flexcli.numerics.rows import cos, isfinite, larger, number, one_by_one, sin
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.ends import ENDS
from flexcli.parts.geometries.base import Blade, Critical
from flexcli.results import ErrorRange

__all__ = ["CARRIED", "pivot_critical", "pulled_critical", "row_critical"]

CARRIED = frozenset({EffectName.SHEAR, EffectName.AXIAL_EXTENSION})
"""Effects that the closed forms of this module include."""

SWAY = 3.0
"""Largest change of a critical force over the strain there times 1 + sway², by the motion of the
body before it: exact solutions of rcc, crossed and star pivots have at most 1.6."""

TILT = 2.0
"""Largest change over the strain times (l/2r)², r the blades' distance from their middle, by the
tilt of a stage that may turn: exact solutions have 0.9."""

PULLED = 3.0
"""Share of the strain by which a stage that is pulled turns over at less tension than slender
blades that keep their lengths: linear beams (h/l 0.01 to 0.06, ξ 0.1 to 1, r/l 0.03 to 0.26, ν 0 to
0.49) have at most 1.5 up to a strain of 0.3, beyond which no model looks."""

WIDE = 0.3
"""Error beyond which a first-order estimate is not valid."""

SAME = 1e-9
"""Rounding error of equal angles [rad], and of forces [-]."""


def pivot_critical(
    elastic: Elastic,
    sizes: Blade,
    p: float,
    angles: Sequence[float],
    ends: str,
    direction: float,
) -> Critical:
    """Return the critical force at the centre of a pivot of equal blades [N].

    Its error is known where the body is kept from turning, or where the design is its own mirror
    image about the line of the force: elsewhere the force turns it a little from the start.
    """
    hold, l = ENDS[ends], sizes.l
    try:
        tensions = shares(angles=angles, direction=direction, across=hold.across)
    except ValueError as error:
        raise NotAvailable(f"is not held against that force: {error}") from error

    def load(axial: float, shear: float, delta: float) -> float:
        if hold.hinged or hold.turn:
            named = "pinned-pinned" if hold.hinged else "clamped-clamped"
            return held_load(tensions=tensions, ends=named, axial=axial, shear=shear)
        return turning_load(tensions=tensions, delta=delta, axial=axial, shear=shear)

    strain = larger(abs(t) for t in tensions)
    first = SWAY * (1.0 + sway(angles=angles, shares=tensions) ** 2)
    known = hold.turn or _is_mirrored(angles, direction)
    turns = not (hold.turn or hold.hinged)
    how = "turns away or its blades bow" if not hold.turn else "its blades bow"
    return _critical(
        elastic,
        sizes,
        load,
        p / l,
        strain,
        (first, first) if known else None,
        f"{hold.spoken}; {how}",
        (larger(0.0, *tensions), larger(0.0, *(-t for t in tensions))) if turns else (0.0, 0.0),
    )


def row_critical(
    elastic: Elastic,
    sizes: Blade,
    places: Sequence[float] | None,
    blades: int,
    ends: str,
    *,
    push: bool,
    guided: bool = False,
) -> Critical:
    """Return the critical force along equal parallel blades on one body [N].

    ``places`` are where they stand across it [m], None where that is not known; a single blade
    stands at zero. A body that may turn is kept upright by two blades or more, which would have to
    stretch. ``guided`` bodies never turn.
    """
    hold, l = ENDS[ends], sizes.l
    if not (push or hold.turn or guided or blades == 1):
        return pulled_critical(elastic, sizes, places, blades, ends)
    held = ends
    tilt: tuple[float, float] | None = (0.0, 0.0)
    if not hold.turn and (blades > 1 or guided):
        held = "clamped-clamped" if hold.across else "clamped-guided"
        if not guided:
            square = sum(y**2 for y in places) / blades if places is not None else 0.0
            tilt = (TILT * l**2 / (4.0 * square), 0.0) if square else None

    def load(axial: float, shear: float, _: float) -> float:
        return blades * thick_load(ends=held, axial=axial, shear=shear) if push else inf

    return _critical(elastic, sizes, load, 0.0, 1.0 / blades, tilt, hold.spoken)


def pulled_critical(
    elastic: Elastic,
    sizes: Blade,
    places: Sequence[float] | None,
    blades: int,
    ends: str,
    *,
    xi: float = 1.0,
) -> Critical:
    """Return the force that pulls along equal parallel blades at which their body turns over [N].

    ``places`` are where they stand across it [m], None where that is not known; ``xi`` is the share
    of their length that bends.
    """
    h, l, b = number(sizes.h), number(sizes.l), number(sizes.b)
    hold, force, error = ENDS[ends], inf, None
    if places is not None:
        upright = 12.0 * sum(y**2 for y in places) / blades / (h**2 * xi)
        n = overturning_tension(upright=upright, xi=xi, across=hold.across)
        force = number(blades * n * elastic.E * second_moment(b, h) / l**2)
        strain = number(n * (h / l) ** 2 / 12.0)
        error = ErrorRange(1.0 / (1.0 + PULLED * strain) - 1.0, SAME if strain < STRAIN else inf)
    source = f"beams whose stretching keeps the body upright, {hold.spoken}"
    return Critical("in the plane", force, source, 1.0 / (blades * h * b), error, CARRIED)


def _critical(
    elastic: Elastic,
    sizes: Blade,
    load: Callable[[float, float, float], float],
    delta: float,
    strain: float,
    changes: tuple[float, float] | None,
    spoken: str,
    turning: tuple[float, float] = (0.0, 0.0),
) -> Critical:
    """Return a load in units EI/l² as a force; ``changes`` are its errors over its strain.

    ``turning`` are the largest shares of it that pull and that push a blade of a body that turns.
    """
    h, l, b = number(sizes.h), number(sizes.l), number(sizes.b)
    axial, unit = (h / l) ** 2 / 12.0, elastic.E * second_moment(b, h) / l**2
    ratios = (0.0, 0.5) if elastic.nu is None else (elastic.nu,)
    shear = [shear_parameter(depth=h, l=l, poisson_ratio=nu) / 12.0 for nu in ratios]
    each = [one_by_one(load, axial, s, delta) for s in shear]
    F = (each[0] + each[-1]) / 2.0
    error = None
    if changes is not None and not isfinite(F):
        error = ErrorRange(0.0, 0.0)
    elif changes is not None:
        unsure = abs(each[0] - each[-1]) / (2.0 * F)
        more = axial * strain * F * pulled_straight(*(share * F for share in turning))
        low, high = (change * more + unsure + SAME for change in changes)
        error = ErrorRange(-low, high) if larger(low, high) < WIDE else None
    source = f"beams with shear and stretching, {spoken}"
    way = "in the plane"
    return Critical(way, number(F * unit), source, strain / (h * b), error, CARRIED)


def _is_mirrored(angles: Sequence[float], direction: float) -> bool:
    """Return whether the blades are their own mirror image about the line of the force."""

    def sorted_places(sign: float) -> list[tuple[float, float]]:
        turned = [sign * (angle - direction) for angle in angles]
        return sorted((round(cos(a) / SAME) * SAME, round(sin(a) / SAME) * SAME) for a in turned)

    pairs = zip(sorted_places(1.0), sorted_places(-1.0), strict=True)
    return all(
        abs(x - y) <= pi * SAME for one, other in pairs for x, y in zip(one, other, strict=True)
    )
