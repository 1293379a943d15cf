"""Von Mises' stress around the sections of beams in space, and what is unsure of their warping."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.stresses import BladeStress
from flexcli.mechanics.space.stresses import equivalent
from flexcli.results import EXACT, ErrorRange

__all__ = ["beam_peaks", "beam_swings", "section_peaks", "unsure_of_peaks", "unsure_of_swings"]

Floats = NDArray[np.float64]

DIAGONALS = np.array([1.0, -1.0, -1.0, 1.0])
"""Signs of the stress of restrained warping at the corners of a section."""


def beam_peaks(stresses: Sequence[BladeStress]) -> dict[str, Floats]:
    """Return von Mises' stress at the corners and faces of beams, signed as the normal stress."""
    return {blade.name: section_peaks(blade).ravel() for blade in stresses}


def beam_swings(first: Sequence[BladeStress], last: Sequence[BladeStress]) -> dict[str, Floats]:
    """Return half of von Mises' stress of what changes in beams between two states [Pa].

    The places are those of :func:`beam_peaks`; torsion and forces add up at each.
    """
    pairs = zip(first, last, strict=True)
    return {one.name: _swing(one, other).ravel() for one, other in pairs}


def unsure_of_peaks(stresses: Sequence[BladeStress], errors: Sequence[ErrorRange]) -> ErrorRange:
    """Return what the errors of restrained warping, one of each beam, make of the largest stress.

    That is relative; of a stress which is nothing it is nothing.
    """
    each = list(zip(stresses, errors, strict=True))
    ends = [[section_peaks(blade, end) for end in error] for blade, error in each]
    return _of_largest([section_peaks(blade) for blade in stresses], ends)


def unsure_of_swings(
    first: Sequence[BladeStress], last: Sequence[BladeStress], errors: Sequence[ErrorRange]
) -> ErrorRange:
    """Return the same of the largest of what changes between two states."""
    each = list(zip(first, last, errors, strict=True))
    ends = [[_swing(one, other, end) for end in error] for one, other, error in each]
    return _of_largest([_swing(one, other) for one, other, _ in each], ends)


def _of_largest(own: Sequence[Floats], ends: Sequence[Sequence[Floats]]) -> ErrorRange:
    """Return between what the largest of all places lies, each between two ends, over itself."""
    most = max(float(np.max(np.abs(each))) for each in own)
    if most == 0.0:
        return EXACT
    sizes = [np.abs(np.stack(each)) for each in ends]
    low = max(float(np.max(each.min(axis=0))) for each in sizes)
    high = max(float(np.max(each)) for each in sizes)
    return ErrorRange(min(low / most, 1.0) - 1.0, max(high / most, 1.0) - 1.0)


def section_peaks(blade: BladeStress, warped: float = 0.0) -> Floats:
    """Return von Mises' stress of each section of a beam, at its corners, faces and sides [Pa].

    It has the sign of the normal stress; the shape is (places, 8), for a rod (places, 6).
    ``warped`` is the share of restrained warping by which that is larger.
    """
    thin, wide = blade.signed[:, :2].T
    if blade.corner.shape[1] == 2:  # a rod: its extremes, wherever around it they are
        thin, wide = -blade.bend_thin, blade.bend_wide
    axial = blade.axial
    middles = axial - thin, axial + thin, axial + wide, axial - wide
    normal = np.column_stack([_warped(blade.corner, warped), *middles])
    turned = blade.shear
    whole = _around(normal, blade.edge * turned, turned + blade.faces, turned + blade.sides)
    return np.asarray(np.copysign(whole, normal))


def _swing(one: BladeStress, other: BladeStress, warped: float = 0.0) -> Floats:
    signed = (one.signed - other.signed) / 2.0
    thin, wide, twisted, faces, sides = np.moveaxis(signed, -1, 0)
    axial = (one.axial - other.axial) / 2.0
    corner = _warped((one.corner - other.corner) / 2.0, warped)
    around = np.ones(corner.shape[1])
    if len(around) == 2:  # a rod: around it bending is the largest somewhere, and so is shear
        bent, pushed = np.hypot(thin, wide), np.hypot(faces, sides)
        fibres = (one.fibres - other.fibres) / 2.0
        normal = np.outer(np.abs(axial) + np.abs(fibres) + bent, around)
        largest = np.abs(axial) + bent, np.abs(axial)
        shears = np.zeros_like(bent), np.abs(twisted), np.abs(twisted) + pushed
        normal = np.column_stack([normal, *np.repeat(largest, 2, axis=0)])
    else:
        turned = np.abs(twisted)
        middles = axial - thin, axial + thin, axial + wide, axial - wide
        shears = one.edge * turned, turned + np.abs(faces), turned + np.abs(sides)
        normal = np.column_stack([corner, *middles])
    return _around(normal, *shears)


def _warped(corner: Floats, share: float) -> Floats:
    """Return stresses at corners (places, corners), their warping larger by a share of itself.

    Of all that is along the corners of a blade only that is alike across both diagonals.
    """
    if not share or corner.shape[1] != len(DIAGONALS):
        return corner
    return corner + share * np.outer(corner @ DIAGONALS / 4.0, DIAGONALS)


def _around(normal: Floats, corner: Floats, face: Floats, side: Floats) -> Floats:
    """Return von Mises' stress around sections: at corners, both faces, and both sides [Pa]."""
    columns = (corner, normal.shape[1] - 4), (face, 2), (side, 2)
    shear = [np.outer(tau, np.ones(count)) for tau, count in columns]
    return equivalent(normal, np.concatenate(shear, axis=1))
