"""Thick notches: how much softer a notch hinge is as a plane body than the beam of its profile.

The faces of a notch are not parallel, so that a section bends out of plane beside the throat, and
the blocks that the notch is cut into give way at its mouth. A beam has neither.
"""

from collections.abc import Iterator, Sequence
from typing import Any, Literal, NamedTuple, TypeAlias

import numpy as np

from flexcli.formulas.card import Card, Range
from flexcli.formulas.quantity import Numbers
from flexcli.numerics.rows import Number, larger, number, smaller

__all__ = [
    "CARDS",
    "DEEPEST",
    "THICKEST",
    "Blocks",
    "Softening",
    "bends_more",
    "massive_bars",
    "mouth_loss",
    "notch_places",
    "softening",
]

OF_SLOPE, AT_MOST = 1.2, 4.0
"""Share of its curvature that a section bends more, per square of the slope of its faces, and its
most: 1.2 makes the 0.4 e/ρ of a thin throat."""

OF_FIT, BESIDE = 0.045, 1.0
"""Error of that added compliance: a share of it, and a part in 1/(E b H²), H the mouth's height."""

AT_MOUTH, SHALLOWER, OF_SHORT, NEAR = 33.0, 0.9, 0.4, 0.13
"""Compliance that a mouth loses to a rigid body at most, in 1/(E b H²), how it falls with e/depth
and rises with (2 depth/l)^0.4 beyond that itself, and over which share of H behind the mouth."""

CLAMPED = 2.0
"""Distance from a mouth over that, within which lies what it loses."""

OF_BAR = 24.0
"""Compliance of two bars of height H and length L beside the notch, in L/(E b H³)."""

OF_MASS = 7.5, 18.0
"""Least and greatest compliance of two massive blocks, in 1/(E b H²)."""

SPREADS, SPREADS_MOST = 0.25, 0.012
"""Increase of the shift by how far the bending of a throat spreads, per e/ρ at most, and its
maximum."""

SHIFTS_LESS, SATURATES = 6.0, 0.7
"""By how much less a mouth bends than the beam and a bar behind it, as the shift tells, in
1/(E b H²): ``6 √m q/(1 + 0.7 q)``, m what a rigid body removes at most and q half the throat over
the mean distance at which the beam bends."""

OF_MOUTH, OF_MOUTH_FIT = 0.6, 0.2
"""Share of what a rigid body removes of a mouth that the shift loses, and its error."""

SHIFT_FIT, SHIFT_THICK, SHIFT_CLAMPED, SHIFT_STEEP, SHIFT_LONG = 2.5, 8.0, 4.0, 0.65, 1.0
"""Error of that, in 1/(E b H²); more of it above for q beyond 0.8, below for q at a clamped mouth
and for m beyond 30, per q², and either way for bars beyond H, per H. Of plane bodies of 272 shapes
(as :func:`softening` has them, 114 drawn at random after the fit), beside bars of none to 12 H and
massive blocks of 0.5 to 3 H, none was outside."""

STEEP, THICK = 30.0, 0.8
"""The m and the q beyond which these count."""

MASSIVE_SHIFT, MASSIVE_THICK, MASSIVE_MOST = 7.0, 9.0, 1.2
"""What massive blocks add to the shift of the body with its mouth kept straight, in 1/(E b H²):
``7 − 9 q``, q at most 1.2."""

MASSIVE_LESS, MASSIVE_MORE = 3.5, 15.0
"""Error of that: low wedges of several mouths' length give way more than high ones."""

HALVINGS = 40
"""Of the interval in which the length of a bar is looked for."""

PLACES = 40
"""Integration points along half a notch."""

THICKEST, DEEPEST = 1.0, 4.0
"""Largest e/radius and e/depth of the notches that were compared with solids."""

Blocks: TypeAlias = float | Literal["massive"] | None
"""The blocks beside a notch: the length [m] of such as are as high as its mouth and end in a rigid
body, massive ones, or nothing where they are not stated."""


class Softening(NamedTuple):
    """Compliance in rotation beyond that of a hinge's beam, times E b, and its error [1/m²].

    The shift of the hinge is ``shift_least`` to ``shift_most`` times that of its beam [-]. Of a
    moment that falls towards the ends, where it is none, the compliance of the faces is at least
    ``bowed`` more than the beam's, as a share of it [-].
    """

    more: Number
    error: Number
    shift_least: Number
    shift_most: Number
    bowed: Number


def softening(
    *, e: Number, depth: Number, l: Number, straight: Number = 0.0, blocks: Blocks = None
) -> Softening:
    """Return the compliance of a notch as a plane body beyond that of the beam of its profile.

    ``ΔC = ∫12/h³ · 1.2 s²/(1 + 0.3 s²) dx/(E b)``, s the slope of a face, and what the blocks give
    way: bars of height H = e + 2 depth and length L bend by ``24 L/(E b H³)``, less what a rigid
    body takes of the mouth.

    Parameters
    ----------
    e : float
        Thickness of the throat [m].
    depth, l : float
        Depth of each half-ellipse and its length along the hinge [m]; l = 2 depth is a circle.
        The two quarter circles of a filleted hinge are one such notch: r and 2 r.
    straight : float
        Length of constant thickness e between the two halves [m].
    blocks : float or str, optional
        Length of blocks as high as the mouth, with rigid bodies behind them [m], or ``massive``:
        at least twice as high at their ends, and half as long as the mouth is high. Left out,
        anything from rigid at the mouth to as long as it is high.

    Returns
    -------
    softening : Softening
        ΔC E b, its error [1/m²], and the change of the shift.

    Notes
    -----
    Plane stress, and plane strain with E/(1 − ν²): a plane body under given moments has the same
    stress for any ν. Compared for circles of e/r from 0.01 to 1, ellipses of l/(2 depth) from ¼ to
    5 with e/ρ ≤ 1 and e/depth ≤ 4, ρ = l²/(4 depth) the radius of the throat, fillets of h/r up
    to 20. The shift is ``(θ²/4) ∬κ κ' |x − x'|``, κ the share of the bending at a place.

    Examples
    --------
    >>> from flexcli.formulas.notch import elliptic_stiffness
    >>> hinge = {"e": 0.2e-3, "depth": 1e-3, "l": 2e-3}
    >>> beam = 1.0 / elliptic_stiffness(E=1.0, b=1.0, **hinge)
    >>> [round(float(part / beam), 3) for part in softening(**hinge, blocks=2e-3)[:2]]
    [0.083, 0.004]

    References
    ----------
    Fitted here to finite elements of high order for plane bodies.

    """
    H = e + 2.0 * depth
    places = list(notch_places(e, depth, l))
    bends = [12.0 / h**3 * dx for _, dx, h, _ in places]
    shares = (bends_more(s) for *_, s in places)
    softer = 2.0 * sum(bend * share for bend, share in zip(bends, shares, strict=True))
    low, high, bar = _of_blocks(e, depth, l, blocks)
    fit = OF_FIT * softer + BESIDE / H**2
    beam = body = Spread(6.0 / e**3 * straight, straight / 3.0)
    grown = 1.0 + softer / (2.0 * sum(bends))
    for (x, *_), bend in zip(places, bends, strict=True):
        beam = beam.beside(bend, straight / 2.0 + x)
        body = body.beside(bend * grown, straight / 2.0 + x)
    end = (straight + l) / 2.0
    lever = (end / beam.mean - 1.0) / body.turn / H**2  # of a compliance at the mouth
    mouth, q = mouth_loss(e, depth, l), e / 2.0 / beam.mean
    spreads = smaller(SPREADS * e * 4.0 * depth / l**2, SPREADS_MOST)

    def beside(L: Number) -> tuple[Number, Number]:
        bent = body.beside_bar(L, end, H).mean / beam.mean
        low, high = _bar_shift(q, mouth, L / H)
        return bent + lever * low, bent + lever * high

    rest = body.mean / beam.mean
    least, most = (rest + lever * each for each in _massive_shift(q, mouth))
    if blocks is None:
        least, most = beside(0.0 * H)[0], larger(most, beside(H)[1])
    elif not isinstance(blocks, str):
        least, most = beside(bar)
    value, error = softer + (low + high) / 2.0, fit + (high - low) / 2.0
    # a clamped mouth loses what bends near it, where a bow has little moment
    clamped = larger(-low, 0.0) * smaller(1.0, (CLAMPED * NEAR * H / end) ** 2)
    bowed = _bowed(places, e, straight, end, fit + clamped / H**2)
    return Softening(value, error, least, most + spreads, bowed)


def _bowed(
    places: Sequence[tuple[Number, ...]], e: Number, straight: Number, end: Number, less: Number
) -> Number:
    """Return the share of its compliance that a hinge gains at least, bowed between pinned ends.

    ``less`` is what it may gain less, times E b [1/m²]. The bow of a column is concave: over the
    distance to its end it grows towards there. So what grows towards there as well is no less in
    the mean by its square than by that of a triangle.
    """
    inner = 1.0 - straight / 2.0 / end
    beam, more = 12.0 / e**3 * end * (1.0 - inner**3) / 3.0, 0.0 * e
    for x, dx, h, slope in places:
        weighed = 12.0 / h**3 * dx * (1.0 - (straight / 2.0 + x) / end) ** 2
        beam, more = beam + weighed, more + weighed * bends_more(slope)
    return larger(more - less / 2.0, 0.0) / beam  # of a half


def _bar_shift(q: Number, mouth: Number, L: Number) -> tuple[Number, Number]:
    """Return what the shift has of a mouth beside bars of a length over H, least and greatest.

    As compliances at the mouth beyond those of beam and bar, in 1/(E b H²).
    """
    clamped = number(np.exp(-L / NEAR))
    less = SHIFTS_LESS * mouth**0.5 * q / (1.0 + SATURATES * q) + OF_MOUTH * mouth * clamped
    fit = SHIFT_FIT + OF_MOUTH_FIT * mouth * clamped + SHIFT_LONG * larger(0.0, L - 1.0)
    low = fit + SHIFT_CLAMPED * q * clamped + _steep(q, mouth)
    return -less - low, fit + SHIFT_THICK * larger(0.0, q - THICK) - less


def _massive_shift(q: Number, mouth: Number) -> tuple[Number, Number]:
    """Return what the shift has of massive blocks, as :func:`_bar_shift`."""
    more = MASSIVE_SHIFT - MASSIVE_THICK * smaller(q, MASSIVE_MOST)
    return more - MASSIVE_LESS - _steep(q, mouth), more + MASSIVE_MORE


def _steep(q: Number, mouth: Number) -> Number:
    return SHIFT_STEEP * larger(0.0, mouth - STEEP) * q**2


def bends_more(slope: Numbers) -> Any:
    """Return the share of its curvature that a section bends more, by the slope of its faces [-].

    ``1.2 s²/(1 + 0.3 s²)``.
    """
    return OF_SLOPE * slope**2 / (1.0 + OF_SLOPE / AT_MOST * slope**2)


class Spread(NamedTuple):
    """Mean distance between two places at which a symmetric hinge bends.

    ``turn`` is the rotation of one half; ``mean`` is the mean of the larger of two distances from
    the middle, which equals the mean distance between two places of either half.
    """

    turn: Number
    mean: Number

    def beside(self, turn: Number, x: Number) -> "Spread":
        """Return it with more rotation at x, farther from the middle than all before."""
        whole = self.turn + turn
        mean = (self.turn**2 * self.mean + (2.0 * self.turn + turn) * turn * x) / whole**2
        return Spread(whole, mean)

    def beside_bar(self, L: Number, end: Number, H: Number) -> "Spread":
        """Return it with a bar of length L and height H added at its end, which bends evenly."""
        turn = OF_BAR / 2.0 * L / H**3
        whole = self.turn + turn
        middle, spread = end + L / 2.0, end + 2.0 / 3.0 * L
        mean = self.turn**2 * self.mean + 2.0 * self.turn * turn * middle + turn**2 * spread
        return Spread(whole, mean / whole**2)


def notch_places(e: Number, depth: Number, l: Number) -> Iterator[tuple[Number, ...]]:
    """Yield places from the throat to the mouth: x, its share dx, thickness and slope of a face.

    They crowd towards the throat: u = w sinh, u the tangent of half the angle.
    """
    w = number(np.sqrt(e / (e + 4.0 * depth)))
    reach = number(np.arcsinh(1.0 / w))
    for k in range(PLACES):
        v = reach * ((k + 0.5) / PLACES)
        u = w * number(np.sinh(v))
        cos, sin = (1.0 - u**2) / (1.0 + u**2), 2.0 * u / (1.0 + u**2)
        angle = 2.0 / (1.0 + u**2) * w * number(np.cosh(v)) * reach / PLACES
        x, dx = l / 2.0 * sin, l / 2.0 * cos * angle
        yield x, dx, e + 2.0 * depth * (1.0 - cos), 2.0 * depth * sin / (l * cos)


def _of_blocks(
    e: Number, depth: Number, l: Number, blocks: Blocks
) -> tuple[Number, Number, Number]:
    """Return least and greatest compliance of the blocks times E b, and a bar's length [m]."""
    H, mouth = e + 2.0 * depth, mouth_loss(e, depth, l)
    if blocks is None:
        return -mouth / H**2, OF_BAR / H**2, H
    if isinstance(blocks, str):
        return OF_MASS[0] / H**2, OF_MASS[1] / H**2, 0.0 * H
    bar = OF_BAR * blocks / H
    return (bar - mouth * number(np.exp(-blocks / (NEAR * H)))) / H**2, bar / H**2, blocks


def mouth_loss(e: Number, depth: Number, l: Number) -> Number:
    """Return the most compliance that a rigid body removes at a mouth, in 1/(E b H²)."""
    short = 2.0 * depth / l
    return AT_MOUTH * short * number(larger(1.0, short) ** OF_SHORT) / (1.0 + SHALLOWER * e / depth)


def massive_bars(*, e: float, depth: float, l: float) -> tuple[float, float]:
    """Return the lengths of bars that give way as massive blocks do at least and at most [m].

    The bars are as high as the mouth, with rigid bodies behind them: at least
    ``24 L/H − m exp(−L/(0.13 H)) = 7.5``, at most ``24 L/H = 18``, and what either may be off.

    Parameters
    ----------
    e, depth, l : float
        As of :func:`softening` [m].

    Examples
    --------
    >>> [round(L, 3) for L in massive_bars(e=0.2, depth=1.0, l=2.0)]
    [0.77, 1.742]

    """
    H, mouth = e + 2.0 * depth, mouth_loss(e, depth, l)
    low, high = 0.0, OF_MASS[1] / OF_BAR
    for _ in range(HALVINGS):
        share = (low + high) / 2.0
        less = OF_BAR * share - mouth * np.exp(-share / NEAR) < OF_MASS[0] - BESIDE
        low, high = (share, high) if less else (low, share)
    return low * H, (OF_MASS[1] + BESIDE) / OF_BAR * H


CARDS: tuple[Card, ...] = (
    Card(
        "thick-notch",
        softening,
        {"e": 0.2e-3, "depth": 1e-3, "l": 2e-3},
        (
            Range("e/radius", 0.0, THICKEST, "no thicker throat was compared"),
            Range("e/depth", 0.0, DEEPEST, "no shallower notch was compared"),
        ),
    ),
)
