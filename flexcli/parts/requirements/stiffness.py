"""Stiffness of each joint along its motion."""

from collections.abc import Iterator
from typing import Any, ClassVar

from pydantic import field_validator

from flexcli.parts.base import RotationalStiffness, in_either
from flexcli.parts.base import Stiffness as AStiffness
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import Bound, Limit
from flexcli.results import QuantityKind

__all__ = ["Stiffness"]


_Either = AStiffness | RotationalStiffness


class Stiffness(Bound):
    """Bounds on the stiffness of one joint, N·m/rad for a rotation and N/m for a translation."""

    label: ClassVar[str] = "stiffness"
    by_solids: ClassVar[bool] = True
    is_warmed: ClassVar[bool] = True

    @field_validator("min", "max", "equals", mode="before", json_schema_input_type=_Either)
    @classmethod
    def _of_either_kind(cls, data: Any) -> Any:
        return None if data is None else in_either(data, "rotational stiffness", "stiffness")

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the bounds on the joint's stiffness."""
        unit = ask.geometry.stiffness_unit
        plain = {}
        for name in ("min", "max", "equals"):
            given = getattr(self, name)
            if given is None:
                continue
            if given[1] != unit:
                raise RequirementError(
                    f"the stiffness of this joint is in {unit}, not {given[1]}",
                    f"its motion is a {ask.geometry.motion}",
                )
            plain[name] = given[0]
        yield from self.model_copy(update=plain).bounds(
            ask.joint_model.stiffness(ask),
            case=self.case_of(ask.scene),
            quantity="stiffness of a joint",
            unit=unit,
            source=ask.geometry.source,
            kind=QuantityKind.STIFFNESS,
        )
