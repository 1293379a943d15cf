"""Which way of bending a joint's blades have."""

from flexcli.formulas import hinge_shift
from flexcli.formulas.notch_compliance import bending_reach, circular_compliance
from flexcli.formulas.quantity import Quantity
from flexcli.parts.bending.arc import Arc
from flexcli.parts.bending.base import Bending
from flexcli.parts.bending.joined import Joined
from flexcli.parts.bending.limbs import Hinge, LimbPivot, LimbStage
from flexcli.parts.bending.pair import Pair
from flexcli.parts.bending.star import Star
from flexcli.parts.bending.straight import Necked, Straight
from flexcli.parts.bending.twist import Twist
from flexcli.parts.bending.unknown import NotEstimated
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.geometries.cross_spring import CrossSpringPivot
from flexcli.parts.geometries.hinged import HingedPivot, HingedStage, LimbSizes
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.necked_stage import NeckedDownStage
from flexcli.parts.geometries.notch import NotchGeometry
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.geometries.single_blade import Cantilever, GuidedBlade, MomentBlade
from flexcli.parts.geometries.star import StarPivot
from flexcli.parts.geometries.three_blade import ThreeBladePivot
from flexcli.parts.geometries.torsion import TorsionGeometry
from flexcli.parts.geometries.unseparated import UnseparatedPivot
from flexcli.results import QuantityKind

__all__ = ["bending_of", "is_known"]

AT_REST = frozenset({QuantityKind.STIFFNESS, QuantityKind.FREQUENCY, QuantityKind.SAG})
"""Kinds of numbers that closed forms state at rest, whatever the travel."""

TRAVELS = frozenset({"theta", "x/l"})
"""Quantities of a range that next orders extend."""


def bending_of(geometry: Geometry, elastic: Elastic, sizes: Sizes, travel: float) -> Bending:
    """Return how the blades bend at a travel."""
    match geometry:
        case Cantilever():
            h, l, _ = map(float, sizes)
            return Straight(h=h, l=l, travel=travel, halves=2)
        case GuidedBlade():
            h, l, _ = map(float, sizes)
            return Straight(h=h, l=l, travel=travel)
        case LeafSpringStage():
            h, l, _ = map(float, sizes)
            return Straight(h=h, l=l, travel=travel, lever=_lever(l, geometry.spacing))
        case NeckedDownStage():
            h, l, xi = float(sizes.h), float(sizes.l), float(sizes.xi)
            return Necked(h=h, l=l, travel=travel, xi=xi, lever=_lever(l, geometry.spacing))
        case MomentBlade() | NotchGeometry():
            return Arc(theta=travel)
        case RCCPivot() | CrossSpringPivot():
            h, l, _ = map(float, sizes)
            p, angle = float(geometry.offset(sizes)), geometry.half_angle
            return Pair(h=h, l=l, p=p, theta=travel, half_angle=angle)
        case UnseparatedPivot():
            h, l, _ = map(float, sizes)
            c, angle = geometry.crossing, geometry.half_angle
            return Joined(h=h, l=l, crossing=c, theta=travel, half_angle=angle)
        case StarPivot() | ThreeBladePivot():
            h, l, _ = map(float, sizes)
            p, angles = float(geometry.offset(sizes)), geometry.blade_angles
            return Star(h=h, l=l, p=p, theta=travel, angles=angles)
        case HingedStage():
            return LimbStage(hinge=_hinge(sizes), travel=travel / float(sizes.l))
        case HingedPivot():
            delta, angle = float(geometry.offset(sizes) / sizes.l), geometry.half_angle
            return LimbPivot(hinge=_hinge(sizes), delta=delta, theta=travel, half_angle=angle)
        case TorsionGeometry():
            return Twist(geometry, elastic, sizes, travel)
    return NotEstimated(travel=travel)


def is_known(
    geometry: Geometry, elastic: Elastic, sizes: Sizes, travel: float, kind: QuantityKind
) -> bool:
    """Return whether what the closed form of a kind leaves out is known at a travel.

    It is not where the joint has no estimates, and where the design leaves the range of the
    formula: as far as its next order reaches, a range of the travel is extended.
    """
    bending = bending_of(geometry, elastic, sizes, travel)
    if not bending.is_estimate:
        return False
    reach = 0.0 if kind in AT_REST else travel
    return all(
        limits.quantity in TRAVELS and at <= bending.travel_most
        for limits, at in geometry.outside_validity(sizes, reach, kind)
    )


def _hinge(sizes: LimbSizes) -> Hinge:
    """Return the hinges of a limb in lengths of the limb."""
    e, r, l, _ = map(float, sizes)
    C = circular_compliance(E=1.0, b=1.0, e=e, r=r)
    stretch = _over(C.along / C.turn, l)
    return Hinge(
        reach=float(bending_reach(across=C.across, turn=C.turn)) / l,
        sheared=2.4**0.5 * stretch,
        stretch=stretch,
        spread=2.0 * float(hinge_shift.circular_shift(e=e, r=r, theta=1.0)) / l,
        throat=e / l,
        peak=e * r / l**2,
    )


def _over(square: Quantity, l: float) -> float:
    root: float = float(square) ** 0.5
    return root / l


def _lever(l: float, spacing: float | None) -> float:
    """Return l over the distance between the blades of a stage; as far apart as long if unsaid."""
    return 1.0 if spacing is None else l / spacing
