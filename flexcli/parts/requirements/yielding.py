"""Yield: the largest stress of a case against an allowable of the material."""

from collections.abc import Iterator
from typing import Annotated, Any, ClassVar, Literal

from pydantic import field_validator

from flexcli.parts.base import OneOrMore, spec_error
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import QuantityKind

__all__ = ["Yield"]

Allowable = Literal["yield-strength", "tensile-strength", "fatigue-amplitude", "admissible-stress"]


class Yield(FactorRequirement):
    """Factor on the largest stress, against R_p0.2 unless other allowables are named."""

    label: ClassVar[str] = "yield"

    allowable: Annotated[tuple[Allowable, ...], OneOrMore()] = ("yield-strength",)
    """Strengths that the stress is held against: one, or a list,
    e.g. ``[yield-strength, fatigue-amplitude]``.
    """

    @field_validator("allowable", mode="before")
    @classmethod
    def _one_or_several(cls, data: Any) -> Any:
        if isinstance(data, list) and not data:
            raise spec_error("the list of allowables is empty", "leave the key out for R_p0.2")
        return data if isinstance(data, list) else [data]

    def applies(self, scene: Scene) -> bool:
        """Return whether the case stresses the blades at all."""
        return self.covers(scene) and scene.is_stressed

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke, and what pushes the joint in its plane or out of it."""
        return scene.pushed_by | scene.across_by | {LoadKind.STROKE}

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the largest stress at each end against each allowable."""
        name, found = ask.joint_model.stresses(ask)
        for allowable in self.allowable:
            field = allowable.replace("-", "_")
            try:
                strength = ask.material.strength(field)
            except MissingProperty as missing:
                raise RequirementError(
                    str(missing), f"give material.{missing.field}, or name another allowable"
                ) from missing
            for stress in found:
                yield Limit(
                    self.label,
                    ask.scene.case,
                    f"{name}, {stress.where}",
                    stress.largest,
                    strength,
                    "Pa",
                    f"allowable: {allowable}; {ask.geometry.source}",
                    required=self.factor,
                    variant=allowable,
                    load=True,
                    joint=stress.joint,
                    driver=ask.scene.driver,
                    kind=QuantityKind.STRESS,
                )
