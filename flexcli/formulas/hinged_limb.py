"""Limbs between two notch hinges: how much softer they are as plane bodies than their beams.

A limb is symmetric about its middle, so that it bends in two ways that do not mix: by a moment that
is the same all along, and by a force across its middle, which bends it like an S. Each has its own
share of the notches, of the bar between them and of the blocks outside them.
"""

from collections.abc import Iterator, Sequence
from typing import NamedTuple

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.thick_notch import (
    BESIDE,
    NEAR,
    OF_BAR,
    OF_FIT,
    OF_MASS,
    THICKEST,
    Blocks,
    bends_more,
    mouth_loss,
    notch_places,
)
from flexcli.numerics.rows import Number, larger, number, smaller

__all__ = ["CARDS", "LimbSoftening", "Span", "limb_softening"]

WIDENS, WIDENS_ERROR = 0.65, 0.35
"""Share of what a rigid body takes of the compliance of a mouth that the middle of a limb near it
takes, which stays plane as it bends but may widen, and its error."""

OUTER_ERROR = 0.15
"""Error of what a rigid body takes of an outer mouth, which a force turns more than the notch."""

SHEARED, SHEARED_ERROR = 2.4 * 1.25, 2.4 * 0.25
"""1.2 E/G, and its error by any Poisson's ratio up to ½."""

BORNE = 0.4
"""Share of its shear that a notch has not, as its faces bear part of the force, and its error."""

PULLED, PULLED_THICK, PULLED_FALLS = 1.04, 0.05, 0.75
"""Compliance of a limb along itself beside that of its sections, times E b, with bars as high as
the mouths on either side: ``1.04 − 0.75 ln(e/r + 0.05)``."""

OUTSIDE, INSIDE = (0.6, 0.65, 0.27), (0.47, 0.45, 0.13)
"""What rigid bodies take of it outside the limb and what its middle does: at the mouths, how that
falls with e/r, and over which share of H behind them."""

PULLED_MASSIVE, PULLED_MOST = (0.85, 3.0), 4.3
"""What massive blocks add to it, of half to some four heights of the mouth in length, and the most
that it was taken for of any."""

PULLED_ERROR, OF_SECTIONS = 0.15, 0.01
"""Its error, and that of the sections: 122 plane bodies with bars of 0.02 to 2.5 H outside were
within 0.145, and 72 with massive blocks no more than 0.09 below the least of these."""

SHORTENED = 0.1
"""Error of the shortening by bending, of what it differs from that of the beam."""

ARC, ARC_ERROR = -0.06, 0.11
SWAY, SWAY_ERROR, SWAY_REST = -0.12, 0.12, 0.07
"""What ``arc`` and ``sway`` have besides, per e/l, of ``sway`` per 2r/l too, and their errors: a
plane body bends elsewhere in a throat. It was −0.17 to 0.04, and −0.23 to 0.06."""

PIECES = 4
"""Integration points along half the bar of a limb, and along a block."""


class Span(NamedTuple):
    """A number of a limb as a beam, and as a plane body with its bounds."""

    beam: Number
    value: Number
    low: Number
    high: Number


class LimbSoftening(NamedTuple):
    """Compliances of a limb times E b, and how it shortens as it bends.

    ``turn`` is the rotation of an end against the other by a moment [1/m²], ``swing`` the motion
    across the limb by a force at its middle [-], ``along`` that by a force along it [-].
    ``arc`` is ∫(1 − g²) dx/l, g the rotation by the moment over that of the end, and ``sway``
    l ∫ψ² dx/(∫ψ dx)², ψ the rotation by the force [-]: both 1 between pins.
    """

    turn: Span
    swing: Span
    along: Span
    arc: Span
    sway: Span


class _Sides(NamedTuple):
    """What is beside the mouths of a limb's notches.

    ``turn`` and ``swing`` are compliances of an inner mouth as the limb is bent by a moment and by
    a force, ``outer`` that of an outer one, in 1/(E b H²); ``bar`` is the part of the bar between
    the notches that gives way, ``block`` the length of the bars outside [m].
    """

    turn: Number
    swing: Number
    outer: Number
    bar: float
    block: Number


class _Place(NamedTuple):
    """A place of half a limb: distance from its middle, length, and compliances times E b."""

    x: Number
    dx: Number
    turn: Number
    swing: Number


class _Bent(NamedTuple):
    turn: Number
    swing: Number
    arc: Number
    sway: Number


def limb_softening(*, e: Number, r: Number, l: Number, blocks: Blocks = None) -> LimbSoftening:
    """Return the compliances of a limb between circular notches, as a beam and as a plane body.

    ``C = ∫12/h³ (1 + 1.2 s²/(1 + 0.3 s²)) dx/(E b)``, s the slope of a face, with a bar of height
    H = e + 2r between the notches and the blocks outside them; ``x²`` and the shear in it across.

    Parameters
    ----------
    e, r : float
        Thickness of the throats and radius of the notches [m].
    l : float
        Distance between the throats [m].
    blocks : float or str, optional
        Length of the blocks outside the hinges, as high as the mouths, with rigid bodies behind
        them [m], or ``massive``: at least twice as high at their ends, and half as long as the
        mouth is high. The limb is then a bar as high as the mouths. Left out, the limb is anything
        from rigid at the mouths to that, and blocks anything from none to as long as high.

    Returns
    -------
    softening : LimbSoftening
        Compliances and shortening with their bounds.

    Notes
    -----
    Plane stress, and plane strain with E/(1 − ν²). Compared with plane bodies for e/r from 0.02 to
    1, r/l from 0.05 to 0.48 and blocks of up to 3 H, ν from 0 to 0.45.

    Examples
    --------
    >>> limb = limb_softening(e=0.2e-3, r=1e-3, l=5e-3, blocks=2.2e-3)
    >>> [round(float(each.beam / each.value), 2) for each in (limb.turn, limb.swing)]
    [0.92, 0.92]

    References
    ----------
    Fitted here to finite elements of high order for plane bodies.

    """
    c, H = l / 2.0, e + 2.0 * r
    a = c - r
    places = list(notch_places(e, r, 2.0 * r))
    stiff, soft = _sides(e, r, a, blocks)
    beam = _bent(places, c, r, None)
    found = [_bent(places, c, r, sides) for sides in (stiff, soft)]
    stretch = 4.0 * sum(dx / h for _, dx, h, _ in places)
    bars = [2.0 * (sides.bar * a + sides.block) / H for sides in (stiff, soft)]
    sloped = sum(map(_sloped, places))
    grown = 4.0 * sloped / beam.turn
    off = 4.0 * OF_FIT * sloped + 2.0 * BESIDE / H**2
    outer = [-2.0 * OUTER_ERROR * smaller(0.0, sides.outer) / H**2 for sides in (stiff, soft)]
    near = 0.0 if blocks is None else 2.0 * WIDENS_ERROR * _taken(e, r, a) / H**2
    whole = beam.swing + SHEARED * stretch
    # all that faces add spreads like the rest of the bending, but what counts x² is beside a throat
    flanks = 4.0 * sum(_sloped(place) * place[0] ** 2 for place in places)
    spread = 4.0 * sum(12.0 / h**3 * dx * x**2 for x, dx, h, _ in places)
    flanks -= spread * grown
    ends = [
        each.swing + flanks + SHEARED * ((1.0 - BORNE) * stretch + bar)
        for each, bar in zip(found, bars, strict=True)
    ]
    # what notches have of shear is in the beam too
    of_swing = [
        c**2 * off
        + (SHEARED * BORNE + SHEARED_ERROR * abs(1.0 - whole / end)) * stretch
        + SHEARED_ERROR * bar
        + (c + r) ** 2 * clamped
        for end, bar, clamped in zip(ends, bars, outer, strict=True)
    ]
    if blocks is None:  # a bar between the notches shortens otherwise than blocks outside them
        mixed = (stiff._replace(outer=soft.outer, block=soft.block),
                 soft._replace(outer=stiff.outer, block=stiff.block))  # fmt: skip
        found += [_bent(places, c, r, sides) for sides in mixed]
    of_arc, of_sway = ARC * e / l, SWAY * 2.0 * r / l * e / l
    of_rest = (SWAY_ERROR * 2.0 * r / l + SWAY_REST) * e / l
    return LimbSoftening(
        turn=_span(beam.turn, [each.turn for each in found[:2]], [off + near + x for x in outer]),
        swing=_span(whole, ends, of_swing),
        along=_span(
            stretch,
            [
                stretch + bar + more
                for bar, more in zip(bars, _pulled(e, r, a, blocks), strict=True)
            ],
            [PULLED_ERROR + OF_SECTIONS * stretch] * 2,
        ),
        arc=_shortening(beam.arc, [each.arc + of_arc for each in found], ARC_ERROR * e / l),
        sway=_shortening(beam.sway, [each.sway + of_sway for each in found], of_rest),
    )


def _pulled(e: Number, r: Number, a: Number, blocks: Blocks) -> tuple[Number, Number]:
    """Return the least and the greatest compliance along a limb beside sections and bars."""
    H, thick = e + 2.0 * r, e / r
    bars = PULLED - PULLED_FALLS * number(np.log(thick + PULLED_THICK))

    def taken(by: tuple[float, float, float], length: Number) -> Number:
        most, falls, reach = by
        return most / (1.0 + falls * thick) * number(np.exp(-length / (reach * H)))

    least, most = PULLED_MASSIVE
    if blocks is None:  # both mouths rigid, to massive blocks where bars as long as high give 2
        return bars - 2.0 * taken(OUTSIDE, 0.0 * H), larger(PULLED_MOST, bars + most) - 2.0
    inner = bars - taken(INSIDE, a)
    if isinstance(blocks, str):
        return inner + least, larger(PULLED_MOST, bars + most)
    return inner - taken(OUTSIDE, blocks), inner - taken(OUTSIDE, blocks)


def _span(beam: Number, ends: Sequence[Number], off: Sequence[Number]) -> Span:
    """Return a number between the stiffest and the softest that may be, with their errors."""
    low, high = ends
    return Span(beam, (low + high) / 2.0, low - off[0], high + off[1])


def _shortening(beam: Number, found: Sequence[Number], off: Number) -> Span:
    low, high = smaller(*found), larger(*found)
    off = off + SHORTENED * larger(abs(low - beam), abs(high - beam))
    return Span(beam, (low + high) / 2.0, low - off, high + off)


def _sides(e: Number, r: Number, a: Number, blocks: Blocks) -> tuple[_Sides, _Sides]:
    """Return the stiffest and the softest that may be beside the mouths, ``a`` half a bar [m]."""
    H, mouth = e + 2.0 * r, _mouth(e, r)
    if blocks is None:
        more = OF_BAR / 2.0 * larger(0.0, 1.0 - a / H)
        return _Sides(-mouth, -mouth, -mouth, 0.0, 0.0 * H), _Sides(more, more, 0.0, 1.0, H)
    inner = -WIDENS * _taken(e, r, a)
    if isinstance(blocks, str):
        stiff, soft = (_Sides(inner, 0.0, of_mass / 2.0, 1.0, 0.0 * H) for of_mass in OF_MASS)
        return stiff, soft
    sides = _Sides(inner, 0.0, -mouth * number(np.exp(-blocks / (NEAR * H))), 1.0, blocks)
    return sides, sides


def _mouth(e: Number, r: Number) -> Number:
    """Return what a rigid body takes at most of the compliance of one mouth, in 1/(E b H²)."""
    return mouth_loss(e, r, 2.0 * r) / 2.0


def _taken(e: Number, r: Number, a: Number) -> Number:
    """Return what one takes that is as far from the mouth as the middle of the limb."""
    return _mouth(e, r) * number(np.exp(-a / (NEAR * (e + 2.0 * r))))


def _sloped(place: tuple[Number, ...]) -> Number:
    """Return the compliance of a place that its beam has not, by the slope of the faces."""
    _, dx, h, s = place
    return number(12.0 / h**3 * dx * bends_more(s))


def _along_limb(
    places: Sequence[tuple[Number, ...]], c: Number, r: Number, sides: _Sides | None
) -> Iterator[_Place]:
    """Yield the places of half a limb from its middle outwards, of its beam without sides."""
    a, H = c - r, places[0][2] + 2.0 * r
    bends = [12.0 / h**3 * dx for _, dx, h, _ in places]
    bar = grown = 0.0 * r
    if sides is not None:
        bar = 12.0 / H**3 * sides.bar
        grown = sum(map(_sloped, places)) / sum(bends)
    for k in range(PIECES):
        piece = a / PIECES
        yield _Place((k + 0.5) * piece, piece, bar * piece, bar * piece)
    if sides is not None:
        yield _Place(a, 0.0 * a, sides.turn / H**2, sides.swing / H**2)
    notch = [(x, dx, bend * (1.0 + grown)) for (x, dx, *_), bend in zip(places, bends, strict=True)]
    yield from (_Place(c - x, dx, gives, gives) for x, dx, gives in reversed(notch))
    yield from (_Place(c + x, dx, gives, gives) for x, dx, gives in notch)
    if sides is None:
        return
    yield _Place(c + r, 0.0 * r, sides.outer / H**2, sides.outer / H**2)
    piece = sides.block / PIECES
    for k in range(PIECES):
        gives = 12.0 / H**3 * piece
        yield _Place(c + r + (k + 0.5) * piece, piece, gives, gives)


def _bent(
    places: Sequence[tuple[Number, ...]], c: Number, r: Number, sides: _Sides | None
) -> _Bent:
    """Return the bending of a limb, both of whose halves have the same beside them."""
    half = list(_along_limb(places, c, r, sides))
    turn = sum(place.turn for place in half)
    turned = arc = 0.0
    for place in half:
        middle = (turned + place.turn / 2.0) / turn
        arc += (1.0 - middle**2) * place.dx / c
        turned += place.turn
    slope = swing = moved = sway = 0.0
    for place in reversed(half):
        middle = slope + place.swing * place.x / 2.0
        moved += middle * place.dx
        sway += middle**2 * place.dx
        slope += place.swing * place.x
        swing += place.swing * (place.x**2 + place.dx**2 / 12.0)
    return _Bent(2.0 * turn, 2.0 * swing, arc, sway * c / moved**2)


CARDS: tuple[Card, ...] = (
    Card(
        "hinged-limb",
        limb_softening,
        {"e": 0.2e-3, "r": 1e-3, "l": 5e-3},
        (
            Range("e/r", 0.0, THICKEST, "no thicker throat was compared"),
            Range("2r/l", 0.0, 0.98, "no shorter limb was compared"),
        ),
    ),
)
