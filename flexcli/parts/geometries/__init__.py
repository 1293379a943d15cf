"""Joints and stages that a spec can name: any flexure, a linkage of them, or one drawn freely."""

from typing import Annotated, TypeAlias

from pydantic import Field

from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.any_flexure import AnyFlexure
from flexcli.parts.geometries.base import Blade, Critical, Extent, Geometry, Sizes
from flexcli.parts.geometries.free_layout import FreeLayout
from flexcli.parts.geometries.linkage import LinkageGeometry

__all__ = [
    "AnyGeometry",
    "Blade",
    "Critical",
    "Elastic",
    "Extent",
    "Geometry",
    "NotAvailable",
    "Sizes",
]

AnyGeometry: TypeAlias = Annotated[
    AnyFlexure | LinkageGeometry | FreeLayout, Field(discriminator="kind")
]
