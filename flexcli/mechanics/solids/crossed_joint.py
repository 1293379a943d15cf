"""What crossed blades of one piece do as solids: compliance, what arms bear, shift, with errors.

Solids on two meshes are each corrected by what much finer elements change of the same figure in a
plane, under plane stress and in plane strain, between which its corners are.
"""

from collections.abc import Callable
from functools import lru_cache
from math import degrees
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray
from scipy.linalg import LinAlgError

from flexcli.errors import SolveError
from flexcli.formulas.solid_crossing import ANGLES, crossing_reach
from flexcli.mechanics.solids.crossed import Crossed, CrossedMesh, CrossedSolid
from flexcli.mechanics.solids.extruded import (
    Law,
    Width,
    even_and_odd,
    flat,
    plane_stress,
    solid_law,
)

__all__ = ["STIFFEST_NU", "CrossedAside", "CrossedJoint", "Range", "crossed_aside", "crossed_joint"]

Floats = NDArray[np.float64]

STIFFEST_NU = 0.49
"""Largest Poisson's ratio: beyond, solids lock."""

LEAST_ARM = 0.15
"""Length of an arm beyond the crossing, over the thickness, from which on it was held against
others' elements."""

ORDER_OF_WIDTH = 4

NARROW = 0.4
"""First element at a free side over half of a narrow joint's width."""

LONG = 2.5
LONG_SHARE = 0.2
"""Longest element along an arm over its thickness, or over the blade where that is more."""

TWICE, FLOOR = 2.0, 1e-3
"""Errors: times by how much both meshes differ, and of the number itself. Orders of 6 over the
width from a first element of 0.3 h on changed a stiffness by 0.05 to 0.3 of what both differ by."""

ACROSS = 0.2
"""Part of that of a thickness, by which the motion across may be off over the rotation."""

SLENDEREST, ROUNDED = 5e-3, 2e-12
"""Least thickness over the length, as rounding grows with its fourth power: times this it is four
times what a stiffness was off at h = l/500."""

KEPT = 16
"""Joints whose answers are kept: the next verb or case asks the same."""


class Range(NamedTuple):
    """Numbers and by how much each may be off, of the same shape."""

    value: Floats
    off: Floats


class CrossedJoint(NamedTuple):
    """A joint of E = 1 and l = 1.

    ``diagonal`` is the compliance of the body along x, y and about the centre (3,), ``coupled`` its
    motion along y over the rotation, as a moment turns it; ``borne`` (3, 2, 2, 3) what arms bear by
    unit loads there, see :meth:`flexcli.mechanics.solids.crossed.CrossedSolid.borne`; ``shift`` the
    least and the most of second order in the rotation, towards the base.
    """

    diagonal: Range
    coupled: Range
    borne: Range
    shift: tuple[float, float]


class _Answers(NamedTuple):
    diagonal: Floats
    coupled: Floats
    borne: Floats
    shift: Floats

    def corrected(self, fine: "_Answers", own: "_Answers") -> "_Answers":
        """Return answers with what finer elements change in a plane."""
        return _Answers(
            self.diagonal * fine.diagonal / own.diagonal,
            *(a + b - c for a, b, c in zip(self[1:], fine[1:], own[1:], strict=True)),
        )


@lru_cache(maxsize=KEPT)
def crossed_joint(
    h: float, b: float, crossing: float, half_angle: float, nu: float
) -> CrossedJoint:
    """Return what a joint of l = 1 and E = 1 does.

    Parameters
    ----------
    h, b : float
        Thickness and width over the length of a blade from end to end [-].
    crossing : float
        Share of the length on the side of the base [-].
    half_angle : float
        Angle from the bisector to a blade [rad].
    nu : float
        Poisson's ratio [-].

    Raises
    ------
    SolveError
        For joints whose arms hardly reach beyond the crossing, or that elements cannot tell.

    """
    _check(h, crossing, half_angle, nu)
    sizes = Crossed(h, 1.0, crossing, half_angle)
    fine, coarse, dense = _meshes(h)
    wide, less = _widths(h, b)
    laws: tuple[Callable[[float, float], Law], ...] = plane_stress, solid_law
    if nu == 0.0:
        laws = laws[:1]  # both are alike
    try:
        solids = [_answers(sizes, solid_law(1.0, nu), *on) for on in ((wide, fine), (less, coarse))]
        planes = [
            [_answers(sizes, law(1.0, nu), flat(b), mesh) for mesh in (dense, fine, coarse)]
            for law in laws
        ]
    except LinAlgError as error:
        raise SolveError("no-solid", f"elements fail: {error}", "leave it to beams") from error
    ends = [solids[0].corrected(plane[0], plane[1]) for plane in planes]
    coarser = solids[1].corrected(planes[-1][0], planes[-1][2])
    share = FLOOR + ROUNDED * h**-4.0
    least_off = (
        share * ends[-1].diagonal,
        np.array(ACROSS * share * h),
        share * np.abs(ends[-1].borne).max(axis=(1, 2, 3), keepdims=True),
        np.array(share * np.abs(ends[-1].shift).max()),
    )
    found = []
    for one, other, rough, floor in zip(ends[0], ends[-1], coarser, least_off, strict=True):
        off = np.abs(one - other) / 2.0 + TWICE * np.abs(other - rough) + floor
        found.append(Range((one + other) / 2.0, off))
    diagonal, coupled, borne, shift = found
    ways = shift.value - shift.off, shift.value + shift.off
    return CrossedJoint(diagonal, coupled, borne, (float(ways[0].min()), float(ways[1].max())))


class CrossedAside(NamedTuple):
    """Compliance of a joint of E = 1 and l = 1 out of its plane.

    ``diagonal`` is that of its body along z, about x and about y (3,), ``coupled`` its motion along
    z over the rotation, as a moment turns it about y.
    """

    diagonal: Range
    coupled: Range


@lru_cache(maxsize=KEPT)
def crossed_aside(
    h: float, b: float, crossing: float, half_angle: float, nu: float
) -> CrossedAside:
    """Return what a joint of l = 1 and E = 1 does out of its plane.

    Parameters and what is raised are as of :func:`crossed_joint`.
    """
    _check(h, crossing, half_angle, nu)
    sizes, found = Crossed(h, 1.0, crossing, half_angle), []
    try:
        fine, _, _ = _meshes(h)
        # what is uneven along an arm beside the crossing counts out of the plane
        finer = fine._replace(first=0.04, grows=5.0)
        for width, mesh in zip(_widths(h, b), (finer, fine), strict=True):
            K = CrossedSolid(sizes, solid_law(1.0, nu), width.aside, mesh).stiffness_aside
            C = np.linalg.inv(K)
            found.append((np.array(C.diagonal()), np.asarray(C[0, 2] / C[2, 2])))
    except LinAlgError as error:
        raise SolveError("no-solid", f"elements fail: {error}", "leave it to beams") from error
    share = FLOOR + ROUNDED * h**-4.0
    (diagonal, coupled), (rough, other) = found
    off = TWICE * np.abs(diagonal - rough) + share * diagonal
    moved = TWICE * np.abs(coupled - other) + ACROSS * share * h
    return CrossedAside(Range(diagonal, off), Range(coupled, np.asarray(moved)))


def _check(h: float, crossing: float, half_angle: float, nu: float) -> None:
    """Refuse what elements cannot tell."""
    least, most = ANGLES
    if not least <= half_angle <= most:
        text = f"solids cross at half-angles of {degrees(least):g} to {degrees(most):g} degrees"
        raise SolveError("no-solid", text, "leave it to beams")
    if h < SLENDEREST:
        text = "a solid as slender as that has too few digits"
        raise SolveError("no-solid", text, "leave it to beams")
    beyond = min(crossing, 1.0 - crossing) / h - float(crossing_reach(half_angle=half_angle))
    if beyond < LEAST_ARM:
        text = "its arms hardly reach beyond the crossing"
        raise SolveError("no-solid", text, "take longer ones")
    if nu > STIFFEST_NU:
        text = f"solids have a Poisson's ratio up to {STIFFEST_NU:g}"
        raise SolveError("no-solid", text, "leave it to beams")


def _meshes(h: float) -> tuple[CrossedMesh, CrossedMesh, CrossedMesh]:
    """Return the meshes of solids, the finer first, and that of planes alone."""
    long = max(LONG, LONG_SHARE / h)
    return (
        CrossedMesh(4, 0.075, 20.0, 0.9, long),
        CrossedMesh(3, 0.1, 20.0, 0.9, long),
        CrossedMesh(5, 2e-3, 6.0, 0.5, long),
    )


def _widths(h: float, b: float) -> tuple[Width, Width]:
    """Return the functions over the width, the finer first."""
    return (
        even_and_odd(_cuts(h, b, 0.6, 4.0, 2), ORDER_OF_WIDTH),
        even_and_odd(_cuts(h, b, 1.0, 6.0, 1), ORDER_OF_WIDTH),
    )


def _answers(sizes: Crossed, law: Law, width: Width, mesh: CrossedMesh) -> _Answers:
    solid = CrossedSolid(sizes, law, width, mesh)
    C = np.asarray(np.linalg.inv(solid.stiffness))
    borne = np.stack([solid.borne(motion) for motion in C.T])
    return _Answers(np.array(C.diagonal()), C[1, 2] / C[2, 2], borne, np.array(solid.second()))


def _cuts(h: float, b: float, first: float, grows: float, fewest: int) -> Floats:
    """Return where elements end over half the width, from that beside its middle on.

    They grow from the free side on, where what is uneven fades within a thickness.
    """
    half, at, cuts = b / 2.0, first * h, [0.0]
    while at < half / 1.5:
        cuts.append(at)
        at *= grows
    if len(cuts) < fewest:
        cuts.append(NARROW * half)
    return half - np.array(cuts)[::-1]
