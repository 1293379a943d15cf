"""Thick notches: how much softer the hinges of a joint are as plane bodies than as beams."""

from collections.abc import Sequence

from flexcli.formulas.quantity import Numbers
from flexcli.formulas.thick_notch import DEEPEST, THICKEST, softening
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.bending.base import Factor, Thick

__all__ = ["thick_fillets", "thick_linked", "thick_notch"]


def thick_notch(
    *, e: Numbers, depth: Numbers, l: Numbers, turn: Numbers, uneven: float = 0.0
) -> Thick:
    """Return the factor of a notch, whose stiffness at E b = 1 as a beam is ``turn`` [m²].

    ``uneven`` is the share of its bending by moments that are not the same all along.
    """
    e, depth, l = number(e), number(depth), number(l)
    ratio = 4.0 * depth * e / l**2
    known = ratio <= THICKEST and e <= DEEPEST * depth
    return Thick(ratio, _factor(e, depth, l, number(turn), uneven) if known else None)


def thick_fillets(*, h: Numbers, r: Numbers, turn: Numbers) -> Thick:
    """Return the factor of a blade with fillets, whose stiffness at E b = 1 is ``turn`` [m²]."""
    h, r = number(h), number(r)
    return Thick(h / r, _factor(h, r, 2.0 * r, number(turn), 0.0))


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
    return Thick(ratio, Factor((low + high) / 2.0, low, high))


def _factor(e: float, depth: float, l: float, turn: float, uneven: float) -> Factor | None:
    """Return the stiffness over the beam's, nothing where its error is as large as itself."""
    more, error = (part * turn for part in softening(e=e, depth=depth, l=l))
    error += uneven * more
    if error >= 1.0 + more:
        return None
    return Factor(1.0 / (1.0 + more), 1.0 / (1.0 + more + error), 1.0 / (1.0 + more - error))
