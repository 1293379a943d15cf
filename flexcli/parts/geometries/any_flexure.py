"""The joints and stages that are flexures themselves; a new kind is a file and a name below."""

from typing import Annotated, TypeAlias

from flexcli.parts.geometries.base import Geometry
from flexcli.parts.named import Kinds

__all__ = ["FLEXURES", "AnyFlexure"]

_HERE = "flexcli.parts.geometries"

FLEXURES = Kinds(
    {
        "cantilever": f"{_HERE}.single_blade:Cantilever",
        "guided-blade": f"{_HERE}.single_blade:GuidedBlade",
        "moment-blade": f"{_HERE}.single_blade:MomentBlade",
        "rcc": f"{_HERE}.rcc:RCCPivot",
        "cross-spring": f"{_HERE}.cross_spring:CrossSpringPivot",
        "unseparated-cross": f"{_HERE}.unseparated:UnseparatedPivot",
        "three-blade": f"{_HERE}.three_blade:ThreeBladePivot",
        "star": f"{_HERE}.star:StarPivot",
        "leaf-spring-stage": f"{_HERE}.leaf_stage:LeafSpringStage",
        "necked-down-stage": f"{_HERE}.necked_stage:NeckedDownStage",
        "notch-hinge": f"{_HERE}.notch:CircularHinge",
        "elliptic-hinge": f"{_HERE}.notch:EllipticHinge",
        "filleted-hinge": f"{_HERE}.notch:FilletedHinge",
        "hinged-stage": f"{_HERE}.hinged:HingedStage",
        "hinged-pivot": f"{_HERE}.hinged:HingedPivot",
        "torsion-bar": f"{_HERE}.torsion_bar:TorsionBar",
        "round-torsion-bar": f"{_HERE}.torsion:RoundTorsionBar",
        "torsion-star": f"{_HERE}.torsion:TorsionStar",
    }
)

AnyFlexure: TypeAlias = Annotated[Geometry, FLEXURES]
