"""Compliant clamps: the reduced stiffness of blades cut from one piece with their bodies."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.clamps import ClampCompliance, clamp_compliance, fillet_compliance
from flexcli.formulas.notch_compliance import planar_compliance
from flexcli.formulas.profile import Filleted, Notch
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

OF_NEXT = 0.2
"""Part of the change of a shift that orders beyond the first may add."""

AWAY = 3.0
"""Distance of two blades in line over h, from which on their body reaches h beyond the face of
either on that side, as halfway to the other it does. With h beyond a face a unit moment turns a
root by 5.22/(E h²), far from sides by 5, and 5.25 are told at most. That of a blade 3 h away turns
it by 2/9π the other way (Flamant's half-plane): a row of them in turn by 2.3 % more, alike by 4.6 %
less."""

ACROSS = 1.5
"""Largest ratio of a root's shift across the width per shear force to its stretch per axial
force."""


class Roots(NamedTuple):
    """Ends of the blades of a joint: ν; rigid clamps, in a body, or maybe flush with its side.

    ``fillet`` is the radius of their fillets, 0 for sharp corners; ``joined`` are bodies formed by
    blades that meet, whose crossing has its own formula.
    """

    nu: float
    is_rigid: bool
    flush: bool
    fillet: float
    joined: frozenset[str]

    def compliance(self, h: float, b: float) -> ClampCompliance:
        """Return the compliance of the root of a blade."""
        if self.is_rigid:
            return fillet_compliance(h=h, r=self.fillet)
        at = {"h": h, "b": b, "poisson_ratio": self.nu, "r": self.fillet}
        return clamp_compliance(**at, flush=self.flush)


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
    softer = [_softer(strip, BENDS) for strip in strips]
    whole = [_softer(strip, slice(None)) for strip in strips]
    # what one blade takes more of than another under loads, or where bodies between them follow
    spread = max(whole) - min(whole)
    lowest = 1.0 / (1.0 + max(softer))
    frame = RootedFrame(layout, held, [strip.rooted for strip in strips])
    low, high = frame.stiffness() or (lowest, 1.0)
    # roots that are alike lower it, by no more than they soften a blade
    stress, told = (lowest, 1.0 + (spread if len(layout.bodies) > 1 else 0.0)), frame.stress()
    if told is not None:
        stress = max(stress[0], told[0]), min(stress[1], told[1])
    least = min(_arc(strip.blade, strip.least) for strip in strips)
    most = max(_arc(strip.blade, strip.most) for strip in strips)
    return CompliantClamps(
        max(strip.slender for strip in strips),
        Factor((low + high) / 2.0, low, high),
        (stress[0] - 1.0, stress[1] - 1.0),
        spread + max(softer),
        Factor(max((1.0 + (least + most) / 2.0) ** -2, lowest), lowest, 1.0),
        shift_within(map(_shortening, (least, most)), shift, (0.0, OF_NEXT)),
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
    l, b = float(np.hypot(*np.subtract(blade.end, blade.start))), float(blade.b)
    places, added = list(_places(blade, l, roots)), np.zeros(5)
    mirrored = sorted((round((l - s) / l, 9), round(h / l, 9)) for s, _, h, _ in places)
    even = mirrored == sorted((round(s / l, 9), round(h / l, 9)) for s, _, h, _ in places)
    for s, _, h, _ in places:
        found = roots.compliance(h, b)
        arm = abs(s - l / 2.0) if even else l
        turned, stretched = found.most / (b * h**2), found.stretch / b
        wide = 12.0 * stretched / b**2
        added += (
            stretched,
            turned * arm**2 + found.shift / b + 2.0 * arm * found.mixed / (b * h),
            wide * arm**2 + ACROSS * stretched,
            wide,
            turned,
        )
    # ends that differ couple forces with moments
    return added if even else added * np.array([1.0, 2.0, 2.0, 2.0, 2.0])


def linked_clamps(each: Sequence[CompliantClamps | None]) -> CompliantClamps | None:
    """Return the range for a linkage's joints, which reflect their stiffness to the input."""
    found = [one for one in each if one is not None]
    if not found:
        return None
    high = 1.0 if len(found) < len(each) else max(g.stiffness.high for g in found)
    low = min(g.stiffness.low for g in found)
    held = min(g.buckling.low for g in found)
    return CompliantClamps(
        max(g.ratio for g in found),
        Factor((low + high) / 2.0, low, high),
        (low - 1.0, high - low),
        max(g.loaded for g in found) + high - low,
        Factor((held + 1.0) / 2.0, held, 1.0),
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
    for i, (s, inward, h, share) in enumerate(places):
        found = roots.compliance(h, b)
        # moment, its slope into the blade and axial force at the root, per force at the end
        at[i] = [[0.0, l - s, 1.0], [0.0, -inward, 0.0], [1.0, 0.0, 0.0]]
        least[i, 0, 0] = share * found.least / (b * h**2)
        most[i] = np.diag([found.most / h**2, found.shift, found.stretch]) / b
        most[i, 0, 1] = most[i, 1, 0] = -found.mixed / (b * h)
        axial, wide = found.stretch * h / reach, (l / b) ** 2
        sheared = 3.0 * axial * (wide + ACROSS / 3.0) / (wide + SHEARED)
        out += max(axial, sheared)
    thickest = max((place[2] for place in places), default=0.0)
    rooted = Rooted(beam, at, least, most)
    softened = rooted.softened(least) - beam, rooted.softened(most) - beam
    return _Strip(beam, *softened, thickest / float(reach), out, rooted)


def _places(blade: Blade, l: float, roots: Roots) -> Iterator[tuple[float, float, float, float]]:
    """Yield the places where a flexible part of a blade ends in something rigid.

    Each has its place [m], the direction of the blade from there, the thickness [m], and the share
    of the least compliance: zero at a mouth, whose block the notch correction includes.
    """
    if roots.fillet:
        h = float(blade.profile.pieces(l)[1].thickness(PIECE)[0])
        yield from ((0.0, 1.0, h, 1.0), (l, -1.0, h, 1.0))
        return
    pieces = blade.profile.pieces(l)
    ends = [np.ravel(piece.position(PIECE)) for piece in pieces]
    open_ = not isinstance(blade.profile, Filleted | Notch)
    for piece, own in zip(pieces, ends, strict=True):
        thickness = np.ravel(np.broadcast_to(piece.thickness(PIECE), 2))
        for index, inward in ((0, 1.0), (1, -1.0)):
            beside = (other[1 - index] for other in ends)
            if not np.isclose(list(beside), own[index], rtol=0.0, atol=ROUNDING * l).any():
                body = blade.first if own[index] < l / 2.0 else blade.second
                if body not in roots.joined:
                    yield float(own[index]), inward, float(thickness[index]), float(open_)


def _softer(strip: _Strip, which: slice) -> float:
    """Return the largest increase of any compliance of a blade in its plane, or in bending."""
    blade, most = strip.blade[which, which], strip.most[which, which]
    return float(np.linalg.eigvals(np.linalg.solve(blade, most)).real.max())


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
    found = list[float]()
    for pure, bent in shapes:
        change = shift(pure, bent)
        if change is None:
            return -CANCELS * abs(pure), CANCELS * abs(pure)
        found += [change * (1.0 + each) for each in off]
    return min(found), max(found)


def _shortening(more: float) -> tuple[float, float]:
    """Return the relative change of a blade's shortening at given motion, arc and S [-].

    The roots take 2δ = ``more`` of the rotation of an arc: ``(1 + 2δ)⁻² − 1`` and ``(1 + 10δ +
    30δ²)/(1 + 6δ)² − 1``.
    """
    delta = more / 2.0
    s_shape = (1.0 + 10.0 * delta + 30.0 * delta**2) / (1.0 + 6.0 * delta) ** 2
    return (1.0 + more) ** -2 - 1.0, s_shape - 1.0
