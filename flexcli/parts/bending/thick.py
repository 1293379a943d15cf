"""Thick notches: the reduced stiffness of hinges as plane bodies against beams."""

from collections.abc import Sequence

from flexcli.formulas.quantity import Numbers
from flexcli.formulas.thick_notch import DEEPEST, THICKEST, Blocks, Softening, softening
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.bending.base import Factor, Thick

__all__ = ["thick_fillets", "thick_linked", "thick_notch"]

BOWING = ("pinned-pinned",)
"""Ends of a hinge that bear no moment, between which it buckles to one side."""


def thick_notch(
    *,
    e: Numbers,
    depth: Numbers,
    l: Numbers,
    turn: Numbers,
    blocks: Blocks = None,
) -> Thick:
    """Return the factor of a notch, whose stiffness as a beam at E b = 1 is ``turn`` [m²]."""
    e, depth, l = number(e), number(depth), number(l)
    ratio = 4.0 * depth * e / l**2
    if not (ratio <= THICKEST and e <= DEEPEST * depth):
        return Thick(ratio, None)
    found = softening(e=e, depth=depth, l=l, blocks=blocks)
    return _thick(ratio, found, number(turn))


def thick_fillets(
    *, h: Numbers, r: Numbers, l: Numbers, turn: Numbers, blocks: Blocks = None
) -> Thick:
    """Return the factor of a blade with fillets, whose stiffness at E b = 1 is ``turn`` [m²]."""
    h, r, l = number(h), number(r), number(l)
    found = softening(e=h, depth=r, l=2.0 * r, straight=l - 2.0 * r, blocks=blocks)
    return _thick(h / r, found, number(turn))


def thick_linked(each: Sequence[Thick | None]) -> Thick | None:
    """Return the range of several joints or blades, of which some have no notch."""
    found = [thick for thick in each if thick is not None]
    if not found:
        return None
    ratio = larger(thick.ratio for thick in found)
    factors = [Factor(1.0, 1.0, 1.0) if thick is None else thick.factor for thick in each]
    known = [factor for factor in factors if factor is not None]
    if len(known) < len(factors):
        return Thick(ratio, None)
    low, high = smaller(f.low for f in known), larger(f.high for f in known)
    # hinges that soften unlike each other share the rotation otherwise, besides their own shifts
    ends = [end for thick in found for end in thick.shift]
    most = larger(high - 1.0, 1.0 - low, *(abs(end - 1.0) for end in ends))
    return Thick(ratio, Factor((low + high) / 2.0, low, high), (1.0 - most, 1.0 + most))


def _thick(ratio: float, found: Softening, turn: float) -> Thick:
    """Return the stiffness over the beam's, None where its error is as large as itself."""
    more, error = found.more * turn, found.error * turn
    if error >= 1.0 + more:
        return Thick(ratio, None)
    ends = 1.0 / (1.0 + more + error), 1.0 / (1.0 + more - error)
    factor = Factor(1.0 / (1.0 + more), *ends)
    shift = found.shift_least, found.shift_most
    return Thick(ratio, factor, shift, bowing=BOWING, bowed=1.0 / (1.0 + found.bowed))
