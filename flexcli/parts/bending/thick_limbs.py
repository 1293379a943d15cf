"""Thick notches of limbs: stages and pivots of them as plane bodies against beams."""

from collections.abc import Callable

from flexcli.formulas.hinged_limb import LimbSoftening, Span, limb_softening
from flexcli.formulas.quantity import Numbers
from flexcli.formulas.thick_notch import THICKEST, Blocks
from flexcli.numerics.rows import Number, larger, number, smaller
from flexcli.parts.bending.base import Factor, Thick

__all__ = ["thick_limb_pivot", "thick_limb_stage"]

STRETCHED = 2.0
"""Error of a shift per share that the stretching of limbs has in their bending across, which moves
the centre aside, beyond that of the beams: 2 γ² + 2 γ of it at most."""

PEAKED, PEAKED_THICK = 0.3, 0.0035
"""By how much more the stress beside a throat rises than in beams, of e r/l² where the moment falls
along the limb, and that of a deep notch is off, of e/r: 0.05 in all at e = r on the shortest limbs.
"""


def thick_limb_stage(
    *,
    e: Numbers,
    r: Numbers,
    l: Numbers,
    blocks: Blocks = None,
    swaying: tuple[str, ...] = (),
) -> Thick:
    """Return the factors of a stage, whose limbs bend like an S, and buckle so by some ends."""
    e, r, l = number(e), number(r), number(l)
    limb = _limb(e, r, l, blocks)
    if limb is None:
        return Thick(e / r, None)
    sway, factor = limb.sway, _factor(lambda swing: 1.0 / swing, limb.swing)
    return Thick(
        e / r,
        factor,
        (sway.low / sway.beam, sway.high / sway.beam),
        stress=_peaked(factor, e, r, l),
        loaded=_of_either(limb),
        swaying=swaying,
    )


def thick_limb_pivot(
    *, e: Numbers, r: Numbers, l: Numbers, gamma: Numbers, slope: Numbers, blocks: Blocks = None
) -> Thick:
    """Return the factors of a pivot of two limbs, γ = 1 + 2δ and ``slope`` the tangent of α."""
    e, r, l, gamma, slope = map(number, (e, r, l, gamma, slope))
    gamma = abs(gamma)
    limb = _limb(e, r, l, blocks)
    if limb is None:
        return Thick(e / r, None)
    # a force across one limb stretches the other
    across = Span(
        *(swing + along / slope**2 for swing, along in zip(limb.swing, limb.along, strict=True))
    )
    lever = gamma * (l / 2.0) ** 2
    shift, first = _shift(limb, gamma, slope)
    moment = _factor(lambda turn, swing: 1.0 / turn + lever / swing, limb.turn, across)
    return Thick(
        e / r,
        _factor(lambda turn, swing: 1.0 / turn + gamma * lever / swing, limb.turn, across),
        shift,
        stress=_peaked(moment, e, r, l),
        loaded=_of_either(limb),
        first=first,
    )


def _limb(e: Number, r: Number, l: Number, blocks: Blocks) -> LimbSoftening | None:
    """Return how soft a limb is, where such ones were compared and its error is not all of it."""
    if not e <= THICKEST * r:
        return None
    limb = limb_softening(e=e, r=r, l=l, blocks=blocks)
    return limb if smaller(limb.turn.low, limb.swing.low) > 0.0 else None


def _factor(stiffness: Callable[..., Number], *compliances: Span) -> Factor:
    """Return a stiffness of plane bodies over that of beams: the softest is the least."""
    beam, value, low, high = (stiffness(*each) for each in zip(*compliances, strict=True))
    return Factor(value / beam, high / beam, low / beam)


def _peaked(factor: Factor, e: Number, r: Number, l: Number) -> Factor:
    """Return the factor of a moment with what the peak of its stress may be more."""
    more = PEAKED * e * r / l**2 + PEAKED_THICK * e / r
    return factor._replace(high=factor.high * (1.0 + more))


def _of_either(limb: LimbSoftening) -> Factor:
    """Return the range of a stiffness in which either way of bending may have any share."""
    turn, swing = (_factor(lambda x: 1.0 / x, each) for each in (limb.turn, limb.swing))
    low, high = smaller(turn.low, swing.low), larger(turn.high, swing.high)
    return Factor((low + high) / 2.0, low, high)


def _shift(
    limb: LimbSoftening, gamma: Number, slope: Number
) -> tuple[tuple[Number, Number], tuple[Number, Number, Number]]:
    """Return the range of the shift over that of the beams, and of what moves the centre aside.

    They are ``(γ² sway/(1 + κ)² − arc − 2 γ κ/(1 + κ)) θ² l/(8 cos α)`` along the bisector and
    ``γ κ/(1 + κ) θ l/(2 cos α)`` across it, κ the part that the stretching of limbs has in bending.
    """
    beam, least, most = (
        along / swing / slope**2
        for along, swing in (
            (limb.along.beam, limb.swing.beam),
            (limb.along.low, limb.swing.high),
            (limb.along.high, limb.swing.low),
        )
    )
    sway, arc = limb.sway, limb.arc

    def shifted(of_sway: Number, of_arc: Number, stretched: Number) -> Number:
        kept = 1.0 / (1.0 + stretched)
        return gamma**2 * of_sway * kept**2 - of_arc - 2.0 * gamma * stretched * kept

    rigid = shifted(sway.beam, arc.beam, beam)
    beside = STRETCHED * gamma * (1.0 + gamma) * (most - beam)
    ends = [
        (shifted(sway.low, arc.high, most) - beside) / rigid,
        (shifted(sway.high, arc.low, least) + beside) / rigid,
    ]
    aside = beam / (1.0 + beam)
    first = 4.0 * gamma * aside / abs(rigid)
    return (smaller(*ends), larger(*ends)), (
        first,
        least / (1.0 + least) / aside,
        most / (1.0 + most) / aside,
    )
