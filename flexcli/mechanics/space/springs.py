"""A blade or rod of a mechanism in space as six springs, with the error of each."""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.blade_spring import BladeSprings, blade_springs
from flexcli.formulas.card import outside
from flexcli.formulas.clamped_blade import VALIDITY, ClampedSprings, clamped_blade, clamped_rod
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import Directed, SpaceBlade, SpaceRod

__all__ = ["STRETCH", "STRIP_CONSTRAINTS", "MemberSprings", "springs_of"]

Floats = NDArray[np.float64]

STRETCH = (0,)
"""The spring of a rod that constrains: along it."""

STRIP_CONSTRAINTS = (0, 2, 4)
"""The springs of a blade that constrain: along it, across its width, bending of its width."""


BENDING = (0, 1, 5)
"""The springs of stretching and of bending across the thickness."""


class MemberSprings(NamedTuple):
    """Six springs of a blade or rod and the relative errors they lie between.

    ``low`` and ``high`` have shape (6,): true = stiffness · (1 + error); a high of infinity says
    that clamps stiffen by nobody knows how much. ``axes`` are the blade's as rows, ``l`` is its
    length [m], ``constrains`` lists the springs that an ideal blade is rigid in. ``is_known``
    says that its proportions are those for which the errors hold.
    """

    springs: BladeSprings
    low: Floats
    high: Floats
    axes: Floats
    l: float
    constrains: tuple[int, ...]
    is_known: bool = True


def springs_of(member: SpaceBlade | SpaceRod) -> MemberSprings:
    """Return the springs of a blade or rod.

    A blade of constant thickness has the factors of plates; any other profile is a beam that may
    warp, and stiffer between clamps by an unknown amount.
    """
    l = float(np.linalg.norm(np.subtract(member.end, member.start)))
    material = member.material
    if isinstance(member, SpaceRod):
        rod = clamped_rod(E=material.E, G=material.G, d=member.d, l=l)
        known = not outside(VALIDITY, {"h/l": member.d / l})
        return _at_middle(rod, member.axes, l, STRETCH, is_known=known)
    match member.profile:
        case Constant(h=h) if h <= member.b:
            across = material.across if isinstance(material, Directed) else None
            blade = clamped_blade(E=material.E, G=material.G, h=h, l=l, b=member.b, across=across)
            b = member.b if across is None else max(1.0, across.wider) * member.b
            known = not outside(VALIDITY, {"h/l": h / l, "b/l": b / l})
            return _at_middle(blade, member.axes, l, STRIP_CONSTRAINTS, is_known=known)
        case _:
            beam = blade_springs(
                profile=member.profile, l=l, b=member.b, E=material.E, G=material.G
            )
            # no plate is stiffer than one that is kept straight across; how much shear and
            # warping are held back across the width and in torsion nobody has compared
            high = np.full(6, np.inf)
            high[list(BENDING)] = 1.0 / (1.0 - material.nu**2) - 1.0
            return MemberSprings(beam, np.zeros(6), high, member.axes, l, STRIP_CONSTRAINTS)


def _at_middle(
    found: ClampedSprings, axes: Floats, l: float, constrains: tuple[int, ...], *, is_known: bool
) -> MemberSprings:
    middle = np.asarray(l / 2.0)
    springs = BladeSprings(found.stiffness, middle, middle)
    return MemberSprings(springs, found.low, found.high, axes, l, constrains, is_known)
