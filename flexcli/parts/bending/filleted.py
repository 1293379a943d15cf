"""Filleted roots: change by fillets of a joint whose closed forms leave them out."""

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.notch_compliance import planar_compliance
from flexcli.mechanics.layout import Blade, Layout
from flexcli.mechanics.linear import LinearSolution, linear
from flexcli.mechanics.stresses import BladeStress, beside_beam
from flexcli.numerics.rows import one_alone
from flexcli.parts.bending.base import FilletedRoots
from flexcli.parts.bending.compliant_clamps import Shift, shift_within
from flexcli.parts.geometries.base import MOVING, Held

__all__ = ["filleted_roots"]

Floats = NDArray[np.float64]

OF_SHAPES = 0.03
"""Error of what fillets change of a shift by the shortening of both shapes, a share of it."""

PLACES = np.linspace(-1.0, 1.0, 201)
"""Places on every piece of a blade where the stress is evaluated: its maximum is smooth."""


def filleted_roots(
    plain: Layout, filleted: Layout, held: Held, shift: Shift
) -> FilletedRoots | None:
    """Return the change from blades of constant thickness to those with fillets, at small motions.

    ``held`` is a unit travel of the moving body. Nothing where the joint has no unique motion.
    """
    one_alone()
    axis = next(i for i in (2, 1) if held[i])
    numbers = []
    for layout in (plain, filleted):
        solution = linear(layout, {MOVING: held})
        if not solution.unique.all():
            return None
        drive = float(solution.reactions[0, layout.index(MOVING), axis])
        numbers.append((drive, *_largest_stress(layout, solution)))
    (drive, stress, _), (stiffer, peak, off) = numbers
    arcs = [_turn(new) / _turn(old) - 1.0 for old, new in _pairs(plain, filleted)]
    ratio = max(_radius_share(blade) for blade in filleted.blades)
    moved = shift_within(map(_shortened, filleted.blades), shift, (-OF_SHAPES, OF_SHAPES))
    return FilletedRoots(ratio, stiffer / drive, peak / stress, off / peak, moved, min(arcs))


def _pairs(plain: Layout, filleted: Layout) -> list[tuple[Blade, Blade]]:
    return list(zip(plain.blades, filleted.blades, strict=True))


def _radius_share(blade: Blade) -> float:
    """Return r/l."""
    l = float(blade.length)
    return float(blade.profile.pieces(l)[1].position(np.array(-1.0))) / l


def _turn(blade: Blade) -> float:
    """Return the rotation of a blade per moment at its end, at E b = 1 [1/m²]."""
    l = float(blade.length)
    return float(planar_compliance(blade.profile, E=1.0, l=l, b=1.0, a=l)[2, 2])


def _shortened(blade: Blade) -> tuple[float, float]:
    """Return the relative changes of the shortening of an arc and of an S, at given motions [-].

    Of an arc what its slope is beside its mean, half the rotation, shortens it more or less.
    """
    l = float(blade.length)
    places, h = _along(blade, l)
    softness = (np.min(h) / h) ** 3
    arc = _integrated(softness, places)
    arc = arc / arc[-1] - 0.5
    bent = _integrated(softness * (1.0 - 2.0 * places / l), places)
    moved = float(np.trapezoid(bent, places))
    return (
        12.0 * float(np.trapezoid(arc**2, places)) / l - 1.0,
        float(np.trapezoid(bent**2, places)) * l / moved**2 / 1.2 - 1.0,
    )


def _integrated(values: Floats, places: Floats) -> Floats:
    """Return the integral of values from the first place to each."""
    steps = np.diff(places) * (values[1:] + values[:-1]) / 2.0
    return np.concatenate([[0.0], np.cumsum(steps)])


def _largest_stress(layout: Layout, solution: LinearSolution) -> tuple[float, float]:
    """Return the largest bending stress in any blade, with its peak, and how far it may be off."""
    found = most = 0.0
    for blade, force in zip(layout.blades, solution.end_forces[0], strict=True):
        x, y = np.subtract(blade.end, blade.start)
        l = float(blade.length)
        across = (x * force[1] - y * force[0]) / l
        s, h = _along(blade, l)
        bending = float(blade.peak[0]) * 6.0 * (force[2] + across * (l - s)) / (blade.b * h**2)
        added, off = beside_beam(blade, BladeStress(s, bending, 0.0 * s, h)) or (0.0, 0.0)
        stress = np.abs(bending + added)
        found, most = max(found, float(stress.max())), max(most, float((stress + off).max()))
    return found, most - found


def _along(blade: Blade, l: float) -> tuple[Floats, Floats]:
    """Return places along the pieces of a blade, and its thickness there [m]."""
    pieces = blade.profile.pieces(l)
    return (
        np.concatenate([np.ravel(piece.position(PLACES)) for piece in pieces]),
        np.concatenate(
            [np.broadcast_to(np.ravel(x.thickness(PLACES)), PLACES.shape) for x in pieces]
        ),
    )
