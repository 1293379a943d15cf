"""Wide hinges of a thickness profile: stiffness, shift and critical forces against beams."""

from collections.abc import Collection, Iterator, Mapping
from typing import TYPE_CHECKING

from flexcli.formulas import plate_factors as plates
from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.profile import Notch
from flexcli.formulas.quantity import Numbers
from flexcli.formulas.section import second_moment
from flexcli.numerics.rows import Number, larger, number, one_by_one, smaller
from flexcli.parts.bending.base import NOTCH_PULLED, SHORTEST, Factor, WideBlades, hull

if TYPE_CHECKING:
    from flexcli.formulas.profile import Profile

__all__ = ["LIMBS_BUCKLED", "wide_notch"]

RITZ_ERROR = 1e-3
"""Largest error of a plate solved by Ritz's method with few functions [-]."""

LIMBS_BUCKLED = 0.06
"""Part of what a notch in pure bending widens by, by which notches at the ends of a limb may differ
as it buckles: plates with a rigid middle of any length, e/r 0.005 to 0.8, had 0.05 at most as the
limb sways, and 0.045 less under a moment that is odd about the throat."""

STRETCHED, STRETCHED_FROM = 0.24, 0.33
STRETCHED_LEAST, NARROWEST, WIDEST, SHORT = 0.55, 0.75, 4.0, 0.6
"""The most by which the middle of a notch that is kept from narrowing bears more of a force along
it than the mean, per ν, and its share per b/√(e ρ), ρ the radius of the throat; and the least, of
the most: a share, one per b/√(e ρ), one over that, and one over b/l, as the edges that narrow are
less of a wide throat. Our solids of 198 notches had 0.0002 to 0.109, from 0.7 % of the most above
the least at first guess (0.23; 0.6, 0.85, 4.2, 0.65) to 3 % below the most: e/ρ 0.001 to 0.3,
b/√(e ρ) 0.3 to 40, b/l to 4.3, ν 0.1 to 0.49, with blocks beside them and without."""

STRETCHED_TO, DEEPEST = 0.35, 0.3
"""Largest throat over the depth of its notch, and least depth over half of the length, of which
that was looked at."""

PLATE, LEAST_PEAK, MOST_PEAK = 18.0, 0.6, 1.2
"""Width over thickness of a throat from which on it is a plate; least and largest shares of the
plate's peak in its middle: our solids of 30 throats, ν 0.3 and 0.45, e/r 0.01 to 0.1, had 0.63 to
1.1."""


def wide_notch(
    nu: float,
    profile: "Profile",
    *,
    throat: Numbers,
    length: Numbers,
    b: Numbers,
    turn: Numbers,
    uneven: float | None = None,
    swaying: Collection[str] = (),
) -> WideBlades:
    """Return the factors of a hinge of a given thickness profile between rigid bodies.

    ``turn`` is its stiffness at E = 1. Of hinges at the ends of limbs ``uneven`` is the part of
    their bending by moments that vary along them, as a force across the limb between two causes;
    by ``swaying`` ends the limbs sway as they buckle.
    """
    from flexcli.mechanics.wide_hinge import WideHinge, wide_hinge

    e, b = number(throat), number(b)
    numbers = tuple(number(each) for each in vars(profile).values())

    def hinge(l: float, b: float, nu: float, *numbers: float) -> WideHinge:
        return wide_hinge(type(profile), numbers, l, b, nu)

    effective = number(plates.effective_width(b=b, h=e))
    thin, thick, short = (
        one_by_one(hinge, number(length), width, nu, *numbers)
        for width in (b, effective, SHORTEST * effective)
    )
    widening, bends = number(plates.bound(nu)), number(second_moment(b, e)) / number(turn)
    factor = _as_a_solid(thick.stiffness, thick.less, e / b, e / bends, widening)
    held: Mapping[str, Factor]
    if uneven is None:
        held = _HeldHinge(profile, number(length), effective, nu, factor, (e / b, e / bends))
    else:
        most = _as_a_solid(short.stiffness, short.less, e / b, e / bends, widening)
        held = _held_limbs(factor, most.high, swaying)
        low, high = factor.low - uneven * widening, factor.high + uneven * widening
        factor = factor._replace(low=larger(1.0, low), high=high)
    moves = (thin.shift, thick.shift)
    middle = sum(moves) / 2.0 - 1.0
    spread = abs(moves[0] - moves[1]) / 2.0 + 0.3 * larger(abs(m - 1.0) for m in moves)
    # of limbs the path of the whole counts, which their hinges shorten by a share of it
    shift = (middle, spread) if uneven is None else (0.0, abs(middle) + spread)
    stress = _in_the_middle(factor, thin.peak, b / e)
    stretched = _stretched(profile, number(length), b, nu)
    return WideBlades(
        b / bends, factor, stress, held, shift, pulled=NOTCH_PULLED, stretched=stretched
    )


def _stretched(profile: "Profile", length: float, b: float, nu: float) -> Factor | None:
    """Return the largest stress across a throat of a force along it over its mean, if known."""
    if not isinstance(profile, Notch):
        return None
    e, depth, half = number(profile.e), number(profile.depth), length / 2.0
    if e > STRETCHED_TO * depth or depth < DEEPEST * half:
        return None
    over, wide = b / half * (depth / e) ** 0.5, b / length
    most = STRETCHED * nu * smaller(STRETCHED_FROM * over, 1.0)
    least = most * smaller(STRETCHED_LEAST, NARROWEST * over, WIDEST / over, SHORT / wide)
    return Factor(1.0 + (least + most) / 2.0, 1.0 + least, 1.0 + most)


def _in_the_middle(mean: Factor, peak: float, slender: float) -> Factor:
    """Return the factor of the largest stress across a throat, from that of its mean and a plate's.

    A narrower throat is no plate: it may have as little as nothing of the peak.
    """
    over = peak - 1.0
    least, middle = (LEAST_PEAK, 1.0) if slender > PLATE else (0.0, 0.5)
    low, value, high = (1.0 + share * over for share in (least, middle, MOST_PEAK))
    return Factor(mean.value * value, mean.low * low, mean.high * high)


def _held_limbs(bent: Factor, most: Number, swaying: Collection[str]) -> dict[str, Factor]:
    """Return the factors of the force that buckles limbs with hinges at their ends.

    As they sway their hinges bend nearly to arcs, by the factor ``bent``; where they are kept from
    that, to any shape, which makes them no flatter than ``most``.
    """
    off = LIMBS_BUCKLED * (bent.value - 1.0)
    high = smaller(bent.high + off, larger(bent.high, most))
    arc = bent._replace(low=larger(1.0, bent.low - off), high=high)
    locked = hull([arc, Factor(most, most, most)])
    return dict.fromkeys(EFFECTIVE_LENGTH, locked) | dict.fromkeys(swaying, arc)


class _HeldHinge(Mapping[str, Factor]):
    """The factors of the force that buckles one hinge, each found when it is asked for.

    A plate is no softer than in pure bending, but on pins, and at most as stiff as in the shape by
    which it buckles; a thick one, with shear in it, is between both. ``thick`` are the throat over
    the width and over the length of its bending.
    """

    def __init__(
        self,
        profile: "Profile",
        length: Number,
        width: Number,
        nu: float,
        bent: Factor,
        thick: tuple[Number, Number],
    ) -> None:
        self.profile, self.length, self.width = profile, length, width
        self.nu, self.bent, self.thick = nu, bent, thick

    def __getitem__(self, ends: str) -> Factor:
        """Return the factor between ends."""
        from flexcli.mechanics.wide_hinge_buckling import BuckledHinge, buckled_hinge

        if ends not in EFFECTIVE_LENGTH:
            raise KeyError(ends)
        kind = type(self.profile)

        def hinge(l: float, b: float, nu: float, *numbers: float) -> BuckledHinge:
            return buckled_hinge(kind, numbers, l, b, nu, ends)

        numbers = (number(each) for each in vars(self.profile).values())
        plate = one_by_one(hinge, self.length, self.width, self.nu, *numbers)
        widening = number(plates.bound(self.nu))
        shape = _as_a_solid(plate.factor, plate.error, *self.thick, widening)
        high = smaller(shape.high + plate.error, 1.0 + widening)
        return hull([self.bent, shape._replace(high=larger(shape.low, high))])

    def __iter__(self) -> Iterator[str]:
        """Yield the names of the ends."""
        return iter(EFFECTIVE_LENGTH)

    def __len__(self) -> int:
        """Return how many ends there are."""
        return len(EFFECTIVE_LENGTH)


def _as_a_solid(plate: float, less: float, t: float, depth: float, widening: float) -> Factor:
    """Return the factor of a notch, a solid, from that of a thin plate that is ``less`` at least.

    Solids of t = e/b up to ½ and e/r from 0.005 to 0.5 widen by 0.65 t less, to 0.75 t about that;
    a throat as deep as its bending is long (``depth``) redistributes its stress when it is kept
    flat.
    """
    over, share = plate - 1.0, 0.14 * depth**2
    away = smaller(RITZ_ERROR, plates.OF_WIDENING * over) + over * (0.75 * t + share)
    value = 1.0 + over * larger(1.0 - 0.65 * t, 0.35)
    high = smaller(1.0 + widening * (1.0 + share), value + away)
    return Factor(value, larger(1.0, value - away - less), high)
