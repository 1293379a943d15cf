"""Mechanisms that a spec can name; a new kind is a file here and a name below."""

from typing import Annotated, TypeAlias

from flexcli.parts.mechanisms.base import Mechanism, MechanismError, Mode
from flexcli.parts.named import Kinds

__all__ = ["MECHANISMS", "AnyMechanism", "Mechanism", "MechanismError", "Mode"]

MECHANISMS = Kinds(
    {
        "parallel-stage": "flexcli.parts.mechanisms.parallel_stage:ParallelStage",
        "payload": "flexcli.parts.mechanisms.payload:Payload",
        "tip-mass": "flexcli.parts.mechanisms.tip_mass:TipMass",
    }
)

AnyMechanism: TypeAlias = Annotated[Mechanism, MECHANISMS]
