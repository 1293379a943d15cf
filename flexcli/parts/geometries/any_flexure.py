"""The joints and stages that are flexures themselves; a new kind is a file and a name below."""

from typing import Annotated, TypeAlias

from pydantic import Field

from flexcli.parts.geometries.cross_spring import CrossSpringPivot
from flexcli.parts.geometries.hinged import HingedPivot, HingedStage
from flexcli.parts.geometries.leaf_stage import LeafSpringStage
from flexcli.parts.geometries.necked_stage import NeckedDownStage
from flexcli.parts.geometries.notch import CircularHinge, EllipticHinge, FilletedHinge
from flexcli.parts.geometries.rcc import RCCPivot
from flexcli.parts.geometries.single_blade import Cantilever, GuidedBlade, MomentBlade
from flexcli.parts.geometries.star import StarPivot
from flexcli.parts.geometries.three_blade import ThreeBladePivot
from flexcli.parts.geometries.torsion import RoundTorsionBar, TorsionBar, TorsionStar
from flexcli.parts.geometries.unseparated import UnseparatedPivot

__all__ = ["AnyFlexure"]

AnyFlexure: TypeAlias = Annotated[
    Cantilever
    | GuidedBlade
    | MomentBlade
    | RCCPivot
    | CrossSpringPivot
    | UnseparatedPivot
    | ThreeBladePivot
    | StarPivot
    | LeafSpringStage
    | NeckedDownStage
    | CircularHinge
    | EllipticHinge
    | FilletedHinge
    | HingedStage
    | HingedPivot
    | TorsionBar
    | RoundTorsionBar
    | TorsionStar,
    Field(discriminator="kind"),
]
