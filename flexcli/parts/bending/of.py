"""Which way of bending a joint's blades have."""

from flexcli.parts.bending.base import Bending
from flexcli.parts.bending.bounded import Bounded
from flexcli.parts.bending.pair import Pair
from flexcli.parts.bending.straight import Straight
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.geometries.cross_spring import CrossSpringPivot
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.pivots import BladePivot
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.geometries.single_blade import Cantilever, GuidedBlade

__all__ = ["bending_of"]


def bending_of(geometry: Geometry, sizes: Sizes, travel: float) -> Bending | None:
    """Return how the blades bend at a travel, where there are slender ones."""
    blade = geometry.blade(sizes)
    if blade is None:
        return None
    h, l = float(blade.h), float(blade.l)
    if isinstance(geometry, Cantilever | GuidedBlade | LeafSpringStage):
        halves = 2 if isinstance(geometry, Cantilever) else 1
        return Straight(h=h, l=l, travel=travel, halves=halves)
    if isinstance(geometry, RCCPivot | CrossSpringPivot):
        p = float(geometry.offset(sizes))
        return Pair(h=h, l=l, p=p, theta=travel, half_angle=geometry.half_angle)
    share = geometry.s_bending_share(sizes)
    if isinstance(geometry, BladePivot):
        p, angles = float(geometry.offset(sizes)), geometry.blade_angles
        return Bounded(h=h, l=l, travel=travel, share=share, p=p, angles=angles)
    over = travel if geometry.motion == "rotation" else travel / l
    return Bounded(h=h, l=l, travel=over, share=share)
