"""Joints and stages that a spec can name; a new kind is a file here and a name below."""

from typing import Annotated, TypeAlias

from pydantic import Field

from flexcli.parts.geometries.base import Blade, Extent, Geometry, NotAvailable
from flexcli.parts.geometries.cross_spring import CrossSpringPivot
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.geometries.three_blade import ThreeBladePivot

__all__ = ["AnyGeometry", "Blade", "Extent", "Geometry", "NotAvailable"]

AnyGeometry: TypeAlias = Annotated[
    RCCPivot | CrossSpringPivot | ThreeBladePivot | LeafSpringStage, Field(discriminator="kind")
]
