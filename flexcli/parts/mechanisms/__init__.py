"""Mechanisms that a spec can name; a new kind is a file here and a name below."""

from typing import Annotated, TypeAlias

from pydantic import Field

from flexcli.parts.mechanisms.base import Mechanism, MechanismError, Mode
from flexcli.parts.mechanisms.parallel_stage import ParallelStage
from flexcli.parts.mechanisms.payload import Payload
from flexcli.parts.mechanisms.tip_mass import TipMass

__all__ = ["AnyMechanism", "Mechanism", "MechanismError", "Mode"]

AnyMechanism: TypeAlias = Annotated[ParallelStage | Payload | TipMass, Field(discriminator="kind")]
