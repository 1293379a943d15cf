"""Compliant clamps: the reduced stiffness of blades cut from one piece with their bodies."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import NamedTuple, TypeAlias

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.clamps import ClampCompliance, clamp_compliance, fillet_compliance
from flexcli.formulas.notch_compliance import planar_compliance
from flexcli.formulas.profile import Filleted, Notch
from flexcli.mechanics.layout import Blade, Layout
from flexcli.mechanics.linear import linear
from flexcli.numerics.rows import one_alone
from flexcli.parts.bending.base import CompliantClamps, Factor
from flexcli.parts.geometries.base import MOVING, PIECE, ROUNDING, Held

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

ACROSS = 1.5
"""Largest ratio of a root's shift across the width per shear force to its stretch per axial
force."""


class Roots(NamedTuple):
    """Ends of the blades of a joint: ν; rigid clamps, in a body, or flush with its side.

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


def compliant_clamps(
    layout: Layout,
    held: Held,
    roots: Roots,
    shift: Shift,
) -> CompliantClamps:
    """Return the changes by compliant roots in a joint, from the bending of its beams.

    With the forces of rigid clamps the energy of the roots bounds the stiffness from below, with
    their motions from above.

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
    strips = [_strip(blade, roots) for blade in layout.blades]
    softer = [_softer(strip, BENDS) for strip in strips]
    whole = [_softer(strip, slice(None)) for strip in strips]
    # what one blade takes more of than another under loads, or where bodies between them follow
    spread = max(whole) - min(whole)
    lowest = 1.0 / (1.0 + max(softer))
    low, high = _bounds(layout, held, strips) or (lowest, 1.0)
    least = min(_arc(strip.blade, strip.least) for strip in strips)
    most = max(_arc(strip.blade, strip.most) for strip in strips)
    return CompliantClamps(
        max(strip.slender for strip in strips),
        Factor((low + high) / 2.0, low, high),
        (lowest - 1.0, spread if len(layout.bodies) > 1 else 0.0),
        spread + max(softer),
        Factor(max((1.0 + (least + most) / 2.0) ** -2, lowest), lowest, 1.0),
        shift_within(map(_shortening, (least, most)), shift, (0.0, OF_NEXT)),
        max(*whole, *(strip.out for strip in strips)),
    )


def _bounds(layout: Layout, held: Held, strips: list[_Strip]) -> tuple[float, float] | None:
    """Return the range in which the stiffness along the motion falls, None where it has none."""
    solution = linear(layout, {MOVING: held})
    axis = next(i for i in (2, 1) if held[i])
    whole = float(solution.reactions[0, layout.index(MOVING), axis])
    if not solution.unique.all() or not whole > 0.0:
        return None
    by_force, by_motion = 0.0, 0.0  # of twice the energy
    for blade, strip, force in zip(layout.blades, strips, solution.end_forces[0], strict=True):
        f = _along(blade, force)
        by_force += float(f @ strip.most @ f)
        q = strip.blade @ f
        by_motion += float(q @ np.linalg.solve(strip.blade + strip.least, q) - f @ q)
    return 1.0 / (1.0 + by_force / whole), 1.0 + by_motion / whole


def root_springs(layout: Layout, roots: Roots) -> Floats:
    """Return what roots add to five compliances of each blade, at most, times E.

    Of stretching, of forces across its thickness and across its width, both at its middle, and of
    bending its width and its thickness: shape (blades, 5) [1/m, 1/m³ of the last two]. Every strip
    of its width stretches by itself.
    """
    return np.array([_of_root(blade, roots) for blade in layout.blades])


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
    least, most = np.zeros((3, 3)), np.zeros((3, 3))
    out = 0.0
    reach = sum(np.ptp(piece.position(PIECE)) for piece in blade.profile.pieces(l))
    for s, inward, h, share in places:
        found = roots.compliance(h, b)
        # moment, its slope into the blade and axial force at the root, per force at the end
        at = np.array([[0.0, l - s, 1.0], [0.0, -inward, 0.0], [1.0, 0.0, 0.0]])
        least += share * found.least / (b * h**2) * np.outer(at[0], at[0])
        soft = np.diag([found.most / h**2, found.shift, found.stretch])
        soft[0, 1] = soft[1, 0] = -found.mixed / h
        most += at.T @ soft @ at / b
        axial, wide = found.stretch * h / reach, (l / b) ** 2
        sheared = 3.0 * axial * (wide + ACROSS / 3.0) / (wide + SHEARED)
        out += max(axial, sheared)
    thickest = max((place[2] for place in places), default=0.0)
    return _Strip(beam, least, most, thickest / float(reach), out)


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


def _along(blade: Blade, force: Floats) -> Floats:
    """Return the force at a blade's end along it and across it, and the moment."""
    x, y = np.subtract(blade.end, blade.start)
    along = np.array([x, y]) / np.hypot(x, y)
    return np.array([along @ force[:2], along[0] * force[1] - along[1] * force[0], force[2]])


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
