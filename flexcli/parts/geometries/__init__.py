"""Joints and stages that a spec can name: any flexure, a linkage of them, or one drawn freely."""

from typing import Annotated, TypeAlias

from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.any_flexure import FLEXURES
from flexcli.parts.geometries.base import BEAM_EFFECTS, Blade, Critical, Extent, Geometry, Sizes
from flexcli.parts.named import Kinds

__all__ = [
    "BEAM_EFFECTS",
    "GEOMETRIES",
    "AnyGeometry",
    "Blade",
    "Critical",
    "Elastic",
    "Extent",
    "Geometry",
    "NotAvailable",
    "Sizes",
]

GEOMETRIES = Kinds(
    {
        **FLEXURES.paths,
        "linkage": "flexcli.parts.geometries.linkage:LinkageGeometry",
        "layout": "flexcli.parts.geometries.free_layout:FreeLayout",
        "space-layout": "flexcli.parts.geometries.space_layout:SpaceDrawing",
    }
)

AnyGeometry: TypeAlias = Annotated[Geometry, GEOMETRIES]
