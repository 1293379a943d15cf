"""Compliant clamps: the reduced stiffness of blades cut from one piece with their bodies."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.clamps import (
    NARROW,
    FilletCompliance,
    clamp_compliance,
    fillet_compliance,
    filleted_root,
)
from flexcli.formulas.notch_compliance import planar_compliance
from flexcli.formulas.profile import Filleted, Notch, Profile
from flexcli.mechanics.layout import Blade, Layout
from flexcli.numerics.rows import one_alone
from flexcli.parts.bending.base import CompliantClamps, Factor
from flexcli.parts.bending.rooted_frame import Rooted, RootedFrame
from flexcli.parts.geometries.base import PIECE, ROUNDING, Held

__all__ = [
    "Roots",
    "Shift",
    "compliant_clamps",
    "linked_clamps",
    "root_springs",
    "shift_within",
]

Floats = NDArray[np.float64]

Shift: TypeAlias = Callable[[float, float], float | None]
"""Gives the relative change of a shift from the relative changes of a blade's shortening when bent
to an arc and to an S."""

CANCELS = 10.0
"""Largest ratio of a blade's shortening to the joint's shift that comes from it."""

SHEARED = 2.4
"""12 EI/(κ G A b²) at the least ν: part of shear in a blade's compliance across its width."""

BENDS = slice(1, None)
"""Indices of the force across a blade and the moment among its end forces; the first stretches
it."""

PLACES = np.linspace(-1.0, 1.0, 201)
"""Places on every piece of a blade with fillets where it is integrated."""

OF_NEXT = 0.2
"""Part of the change of a shift that orders beyond the first may add."""

AWAY = 3.0
"""Distance of two blades in line over h, from which on their body reaches h beyond the face of
either on that side, as halfway to the other it does. With h beyond a face a unit moment turns a
root by 5.22/(E h²), far from sides by 5, and 5.25 are told at most. That of a blade 3 h away turns
it by 2/9π the other way (Flamant's half-plane): a row of them in turn by 2.3 % more, alike by 4.6 %
less."""

OF_RIGID = (0.04, 0.07, 0.01)
"""Errors of what fillets on a rigid body give way turned, shifted and stretched, the second times
1 + √(r/h): of the fits, the mixed one in equal parts of the first two."""

OF_LEAST, OF_MOST = (0.06, 0.2, 0.01), (0.06, 0.26, 0.12)
"""The same of roots with fillets in bodies, of the last the shift times 1 + √(r/h)."""

OF_FLUSH = (0.66, 25.0, 7.5)
"""What is more of a root at the side of its body, times 1 + √(r/h) to the powers 1, 3 and 1: it
couples what stretches a blade with what turns and shifts its root."""

ACROSS = 1.5
"""Largest ratio of a root's shift across the width per shear force to its stretch per axial
force."""


UNKNOWN_NU = (0.0, 0.25, 0.5)
"""Poisson's ratios that stand for those of a material that gives none, of which ½ is told."""

SLOPES = 0.25
"""Thickness over the distance in which the moment at a root changes by itself, where the bounds of
what fillets give way are as unsure of the moment as of its slope."""

STIFFEST = 0.01
"""Compliance of a blade over that of its beam to which sharp fillets so near each other that nobody
compared them lower it at most."""


class RootRange(NamedTuple):
    """Between which the compliances of a root lie, and the most along the blade, at E = 1.

    ``least`` and ``most`` (3, 3) are of the moment, its slope into the blade and the axial force
    [1/m³, 1/m², 1/m]; ``stretch`` [1/m] is along it without what a crooked root shifts.
    """

    least: Floats
    most: Floats
    stretch: float


class Roots(NamedTuple):
    """Ends of the blades of a joint: ν; rigid clamps, in a body, or maybe flush with its side.

    In rigid clamps those with fillets alone give way. ``joined`` are bodies formed by blades that
    meet, whose crossing has its own formula. A ν of ½ may be anything below.
    """

    nu: float
    is_rigid: bool
    flush: bool
    joined: frozenset[str]

    def compliance(self, h: float, b: float, r: float, share: float) -> RootRange:
        """Return the compliances of the root of a blade, with fillets of radius r where it begins.

        ``share`` is that of the least compliance of a sharp root.
        """
        if r:
            return self._on_rigid(h, b, r) if self.is_rigid else self._cut(h, b, r)
        found = clamp_compliance(h=h, b=b, poisson_ratio=self.nu, flush=self.flush)
        least = np.diag([share * found.least / h**2, 0.0, 0.0]) / b
        most = np.diag([found.most / h**2, found.shift, found.stretch]) / b
        most[0, 1] = most[1, 0] = -found.mixed / (b * h)
        return RootRange(least, most, found.stretch / b)

    def _on_rigid(self, h: float, b: float, r: float) -> RootRange:
        """Return those of fillets on a rigid body: in plane stress, plane strain or between.

        Plates and beams are wide or narrow against the length, fillets against the thickness.
        """
        each = list[Floats]()
        for nu in self._ratios:
            each.append(_matrix(fillet_compliance(h=h, r=r, poisson_ratio=nu)))
            held = _matrix(fillet_compliance(h=h, r=r, poisson_ratio=nu / (1.0 - nu)))
            each += [held, (1.0 - nu**2) * held]
        turned, shifted, stretched = OF_RIGID
        off = np.diag([turned, shifted * (1.0 + (r / h) ** 0.5), stretched])
        least, most = _lower(each) - off, _upper(each) + off
        return RootRange(_scaled(least, h, b), _scaled(most, h, b), float(most[2, 2]) / b)

    def _cut(self, h: float, b: float, r: float) -> RootRange:
        """Return those of roots in bodies, from plane strain in the widest to plane stress."""
        firm, soft = list[Floats](), list[Floats]()
        narrow, blunt = 1.0 - NARROW * min(1.0, h / b), 1.0 + (r / h) ** 0.5
        turned, shifted, stretched = OF_FLUSH
        beside = np.diag([turned * blunt, shifted * blunt**3, stretched * blunt])
        stretch = 0.0
        for nu in self._ratios:
            for ratio, held in ((nu, 1.0), (nu / (1.0 - nu), 1.0 - nu**2)):
                at = {"h": h, "r": r, "poisson_ratio": ratio}
                wide = held * _matrix(filleted_root(**at, body="wide"))
                firm += [wide, narrow * wide]
                soft.append(held * _matrix(filleted_root(**at, body="side")))
                stretch = max(stretch, float(soft[-1][2, 2]))
            if self.flush:
                side = filleted_root(h=h, r=r, poisson_ratio=nu, body="flush")
                soft.append(_matrix(side) + beside)
                stretch = max(stretch, side.stretch)
        turned, shifted, stretched = OF_MOST
        least = _lower(firm) - np.diag(OF_LEAST)
        most = _upper([*firm, *soft]) + np.diag([turned, shifted * blunt, stretched])
        return RootRange(_scaled(least, h, b), _scaled(most, h, b), (stretch + stretched) / b)

    @property
    def _ratios(self) -> tuple[float, ...]:
        return UNKNOWN_NU if self.nu == UNKNOWN_NU[-1] else (self.nu,)


def _matrix(found: FilletCompliance) -> Floats:
    """Return a compliance per moment, its slope into the blade times h, and axial force [-]."""
    turn, mixed, shift, stretch = found
    return np.array([[turn, mixed, 0.0], [mixed, shift, 0.0], [0.0, 0.0, stretch]])


def _scaled(compliance: Floats, h: float, b: float) -> Floats:
    """Return it per moment, its slope into the blade and axial force [1/m³, 1/m², 1/m]."""
    per = np.array([1.0 / h, 1.0, 1.0])
    return np.asarray(compliance * np.outer(per, per) / b)


def _upper(each: Sequence[Floats]) -> Floats:
    """Return a compliance that no load finds less than any of these."""
    found = each[0]
    for other in each[1:]:
        found = found + _positive(other - found)
    return found


def _lower(each: Sequence[Floats]) -> Floats:
    """Return a compliance that no load finds more than any of these."""
    return -_upper([-one for one in each])


def _positive(difference: Floats) -> Floats:
    """Return the positive part of a symmetric matrix."""
    per = np.array([1.0, SLOPES, 1.0])
    values, axes = np.linalg.eigh(difference * np.outer(per, per))
    return np.asarray((axes * np.maximum(values, 0.0)) @ axes.T / np.outer(per, per))


class _Strip(NamedTuple):
    """A blade's compliance at its end, and the range of what its roots add, at E = 1 [1/m]."""

    blade: Floats
    least: Floats
    most: Floats
    slender: float
    """h/l where it is thickest against its flexible length."""
    out: float
    """Largest increase of any compliance across its width."""
    rooted: Rooted
    """The same, root by root."""
    shapes: tuple[tuple[float, float], ...]
    """Relative changes of its shortening, arc and S, by roots that give least and most."""


def compliant_clamps(
    layout: Layout,
    held: Held,
    roots: Roots,
    shift: Shift,
) -> CompliantClamps:
    """Return the changes by compliant roots in a joint, from the bending of its beams.

    The stiffness is between that on the softest roots and that on the stiffest, the stress between
    what any of them make of it; loads may share otherwise, and what a temperature strains.

    Parameters
    ----------
    layout : Layout
        The joint.
    held : tuple
        Unit travel of its moving body.
    roots : Roots
        How its blades end.
    shift : callable
        What the joint's shift changes when blades bent to an arc and to an S shorten otherwise, as
        shares; nothing where nobody knows.

    """
    one_alone()
    strips = [_strip(blade, _roots_of(blade, layout, roots)) for blade in layout.blades]
    softer = [max(_changes(strip.blade, strip.most, BENDS)) for strip in strips]
    firmer = [min(_changes(strip.blade, strip.least, BENDS)) for strip in strips]
    whole = [max(_changes(strip.blade, strip.most, slice(None))) for strip in strips]
    # what one blade takes more of than another under loads, or where bodies between them follow
    spread = max(whole) - min(whole) + max(firmer) - min(firmer)
    lowest, highest = 1.0 / (1.0 + max(softer)), 1.0 / (1.0 + min(firmer))
    frame = RootedFrame(layout, held, [strip.rooted for strip in strips])
    low, high = frame.stiffness() or (lowest, highest)
    # roots that are alike lower it, by no more than they soften a blade
    alike = highest * (1.0 + (spread if len(layout.bodies) > 1 else 0.0))
    stress, told = (lowest, alike), frame.stress()
    if told is not None:
        stress = max(stress[0], told[0]), min(stress[1], told[1])
    least = min(_arc(strip.blade, strip.least) for strip in strips)
    most = max(_arc(strip.blade, strip.most) for strip in strips)
    held_less = (1.0 + (least + most) / 2.0) ** -2
    return CompliantClamps(
        max(strip.slender for strip in strips),
        Factor((low + high) / 2.0, low, high),
        (stress[0] - 1.0, stress[1] - 1.0),
        spread + max(softer) + highest - 1.0,
        Factor(min(max(held_less, lowest), highest), lowest, highest),
        shift_within([x for strip in strips for x in strip.shapes], shift, (0.0, OF_NEXT)),
        max(*whole, *(strip.out for strip in strips)),
    )


def root_springs(layout: Layout, roots: Roots) -> Floats:
    """Return what roots add to five compliances of each blade, at most, times E.

    Of stretching, of forces across its thickness and across its width, both at its middle, and of
    bending its width and its thickness: shape (blades, 5) [1/m, 1/m³ of the last two]. Every strip
    of its width stretches by itself.
    """
    return np.array([_of_root(x, _roots_of(x, layout, roots)) for x in layout.blades])


def _roots_of(blade: Blade, layout: Layout, roots: Roots) -> Roots:
    """Return how a blade ends: one between two others in line is at no side of its bodies."""
    if not roots.flush:
        return roots
    start, end = np.array(blade.start), np.array(blade.end)
    l = float(np.hypot(*(end - start)))
    along = (end - start) / l
    normal = np.array([-along[1], along[0]])
    h = max(float(np.max(p.thickness(PIECE))) for p in blade.profile.pieces(l))
    sides = set[float]()
    for other in layout.blades:
        if {other.first, other.second} != {blade.first, blade.second}:
            continue
        ends = [np.array(other.start), np.array(other.end)]
        if other.first != blade.first:
            ends.reverse()
        apart = np.array([ends[0] - start, ends[1] - end])
        if np.all(np.abs(apart @ along) <= ROUNDING * l):
            away = apart @ normal
            sides |= {s for s in (-1.0, 1.0) if np.all(s * away >= AWAY * h)}
    return roots._replace(flush=len(sides) < 2)


def _of_root(blade: Blade, roots: Roots) -> Floats:
    l, b = float(blade.length), float(blade.b)
    places, added = list(_places(blade, l, roots)), np.zeros(5)
    mirrored = sorted((round((l - x.s) / l, 9), round(x.h / l, 9)) for x in places)
    even = mirrored == sorted((round(x.s / l, 9), round(x.h / l, 9)) for x in places)
    for x in places:
        found = roots.compliance(x.h, b, x.r, x.share)
        # fillets bend where they begin, and bodies stretch at their faces
        arm, far = (abs(x.s - l / 2.0), abs(x.s - l / 2.0) + x.r) if even else (l, l)
        turned, shifted = found.most[0, 0], found.most[1, 1]
        mixed, wide = abs(found.most[0, 1]), 12.0 * found.stretch / b**2
        added += (
            found.stretch,
            turned * arm**2 + shifted + 2.0 * arm * mixed,
            wide * far**2 + ACROSS * found.stretch,
            wide,
            turned,
        )
    # ends that differ couple forces with moments
    added = np.maximum(added, 0.0)
    return added if even else added * np.array([1.0, 2.0, 2.0, 2.0, 2.0])


def linked_clamps(each: Sequence[CompliantClamps | None]) -> CompliantClamps | None:
    """Return the range for a linkage's joints, which reflect their stiffness to the input."""
    found = [one for one in each if one is not None]
    if not found:
        return None
    ends = [(g.stiffness.low, g.stiffness.high) for g in found]
    if len(found) < len(each):
        ends.append((1.0, 1.0))
    low, high = min(low for low, _ in ends), max(high for _, high in ends)
    held, firmest = min(g.buckling.low for g in found), max(g.buckling.high for g in found)
    return CompliantClamps(
        max(g.ratio for g in found),
        Factor((low + high) / 2.0, low, high),
        (low - 1.0, high - low + max(high - 1.0, 0.0)),
        max(g.loaded for g in found) + high - low,
        Factor((held + firmest) / 2.0, held, firmest),
        (min(g.shift[0] for g in found), max(g.shift[1] for g in found)),
        max(g.softest for g in found),
    )


def _strip(blade: Blade, roots: Roots) -> _Strip:
    """Return the compliance of a blade and those that its roots add."""
    x, y = np.subtract(blade.end, blade.start)
    l, b = float(np.hypot(x, y)), float(blade.b)
    beam = planar_compliance(blade.profile, E=1.0, l=l, b=b, a=l, G=0.5 / (1.0 + roots.nu))
    places = list(_places(blade, l, roots))
    at, least, most = (np.zeros((len(places), 3, 3)) for _ in range(3))
    out = 0.0
    reach = sum(np.ptp(piece.position(PIECE)) for piece in blade.profile.pieces(l))
    for i, place in enumerate(places):
        found = roots.compliance(place.h, b, place.r, place.share)
        # moment, its slope into the blade and axial force at the root, per force at the end
        at[i] = [[0.0, l - place.s, 1.0], [0.0, -place.inward, 0.0], [1.0, 0.0, 0.0]]
        least[i], most[i] = found.least, found.most
        axial, wide = max(found.stretch, 0.0) * b * place.h / reach, (l / b) ** 2
        sheared = 3.0 * axial * (wide + ACROSS / 3.0) / (wide + SHEARED)
        out += max(axial, sheared)
    thickest = max((place.h for place in places), default=0.0)
    rooted = Rooted(beam, at, least, most)
    firmest = min(_changes(beam, rooted.softened(least) - beam, slice(None)))
    if firmest < STIFFEST - 1.0:
        of_these = (1.0 - STIFFEST) / -firmest
        rooted = rooted._replace(least=of_these * least, most=of_these * most)
    softened = rooted.softened(rooted.least) - beam, rooted.softened(rooted.most) - beam
    if places and places[0].r:
        each = (rooted.least, rooted.most)
        shapes = tuple(_filleted_shortening(blade.profile, l, b * root) for root in each)
    else:
        shapes = tuple(_shortening(_arc(beam, roots)) for roots in softened)
    return _Strip(beam, *softened, thickest / float(reach), out, rooted, shapes)


class _Place(NamedTuple):
    """Where a flexible part of a blade ends in something rigid, or where its fillet begins.

    ``s`` is from the blade's start and ``inward`` the direction of the blade from there; thickness,
    radius of the fillet, 0 for a sharp corner, and the share of the least compliance of one: zero
    at a mouth, whose block the notch correction includes.
    """

    s: float
    inward: float
    h: float
    r: float
    share: float


def _places(blade: Blade, l: float, roots: Roots) -> Iterator[_Place]:
    """Yield where the flexible parts of a blade end, or their fillets begin."""
    if isinstance(blade.profile, Filleted):
        straight = blade.profile.pieces(l)[1]
        h, r = (
            float(np.ravel(x)[0]) for x in (straight.thickness(PIECE), straight.position(PIECE))
        )
        yield from (_Place(r, 1.0, h, r, 1.0), _Place(l - r, -1.0, h, r, 1.0))
        return
    if roots.is_rigid:
        return
    pieces = blade.profile.pieces(l)
    ends = [np.ravel(piece.position(PIECE)) for piece in pieces]
    open_ = not isinstance(blade.profile, Notch)
    for piece, own in zip(pieces, ends, strict=True):
        thickness = np.ravel(np.broadcast_to(piece.thickness(PIECE), 2))
        for index, inward in ((0, 1.0), (1, -1.0)):
            beside = (other[1 - index] for other in ends)
            if not np.isclose(list(beside), own[index], rtol=0.0, atol=ROUNDING * l).any():
                body = blade.first if own[index] < l / 2.0 else blade.second
                if body not in roots.joined:
                    h = float(thickness[index])
                    yield _Place(float(own[index]), inward, h, 0.0, float(open_))


def _changes(blade: Floats, roots: Floats, which: slice) -> list[float]:
    """Return the changes of compliances of a blade in its plane, or in bending, and none."""
    found = np.linalg.eigvals(np.linalg.solve(blade[which, which], roots[which, which])).real
    return [*map(float, found), 0.0]


def _arc(blade: Floats, roots: Floats) -> float:
    """Return the increase of the rotation of a blade bent by a moment."""
    return float(roots[2, 2] / blade[2, 2])


def shift_within(
    shapes: Iterable[tuple[float, float]], shift: Shift, off: tuple[float, float]
) -> tuple[float, float]:
    """Return the range of the change of the shift.

    By the changes of the shortening of an arc and of an S, of which there may be several, and
    between what errors that is known, as shares of it.
    """
    each = list(shapes)
    found = list[float]()
    for pure, bent in each:
        change = shift(pure, bent)
        if change is None:
            most = CANCELS * max(abs(part) for shape in each for part in shape)
            return -most, most
        found += [change * (1.0 + part) for part in off]
    return min(found), max(found)


def _shortening(more: float) -> tuple[float, float]:
    """Return the relative change of a blade's shortening at given motion, arc and S [-].

    The roots take 2δ = ``more`` of the rotation of an arc: ``(1 + 2δ)⁻² − 1`` and ``(1 + 10δ +
    30δ²)/(1 + 6δ)² − 1``.
    """
    delta = more / 2.0
    s_shape = (1.0 + 10.0 * delta + 30.0 * delta**2) / (1.0 + 6.0 * delta) ** 2
    return (1.0 + more) ** -2 - 1.0, s_shape - 1.0


def _filleted_shortening(profile: Profile, l: float, root: Floats) -> tuple[float, float]:
    """Return what roots with fillets change of a blade's shortening, arc and S, as shares [-].

    ``root`` (2, 3, 3) is their compliance where the fillets begin, at E = b = 1: there the slope
    and the place of a beam of the profile change at once.
    """
    pieces = profile.pieces(l)
    s = np.concatenate([np.ravel(piece.position(PLACES)) for piece in pieces])
    h = np.concatenate(
        [np.broadcast_to(np.ravel(x.thickness(PLACES)), PLACES.shape) for x in pieces]
    )
    r = float(np.ravel(pieces[1].position(PLACES))[0])
    found = list[float]()
    for slope in (0.0, -2.0 / l):
        moment = 1.0 + slope * s
        curved = np.concatenate([[0.0], np.cumsum(_trapezoids(12.0 * moment / h**3, s))])
        at = 1.0 + slope * r
        turn, jump = root[0, :2, :2] @ [at, slope]
        sense = 1.0 if slope == 0.0 else -1.0
        shares = list[float]()
        for turned, jumped in ((0.0, 0.0), (turn, jump)):
            # the second root bears the same moment in an arc, the opposite one in an S
            turns = curved + turned * ((s >= r) + sense * (s > l - r))
            if slope == 0.0:
                turns = turns - turns[-1] / 2.0
                motion = 2.0 * turns[-1]
            else:
                motion = float(np.sum(_trapezoids(turns, s))) - 2.0 * jumped
            shares.append(float(np.sum(_trapezoids(turns**2, s))) / motion**2)
        found.append(float(shares[1] / shares[0] - 1.0))
    return found[0], found[1]


def _trapezoids(values: Floats, places: Floats) -> Floats:
    """Return the integral of values from each place to the next."""
    return np.asarray(np.diff(places) * (values[1:] + values[:-1]) / 2.0)
