"""Yield: the largest stress of a case against an allowable of the material."""

from collections.abc import Iterator, Sequence
from math import sqrt
from typing import Annotated, Any, ClassVar, Literal

from pydantic import field_validator

from flexcli.parts.base import OneOrMore, spec_error
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements.ask import Ask, EndStress, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["Yield"]

FELT = 1e-3
"""Share of the strength from which the stress by clamps across the width is judged."""

Allowable = Literal["yield-strength", "tensile-strength", "fatigue-amplitude", "admissible-stress"]


class Yield(FactorRequirement):
    """Factor on the largest stress, against R_p0.2 unless other allowables are named."""

    label: ClassVar[str] = "yield"
    by_shells: ClassVar[QuantityKind | None] = QuantityKind.STRESS
    by_solids: ClassVar[bool] = True
    is_of_stress: ClassVar[bool] = True

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
                    strengths=(field,),
                )
            yield from self._held_across(ask, found, strength, allowable)

    def _held_across(
        self, ask: Ask, found: Sequence[EndStress], strength: float, allowable: str
    ) -> Iterator[Limit]:
        """Yield the stress at clamps that keep blades from growing across, with that along them.

        Von Mises' of both on the face where they differ in sign. Its range goes from compliant
        clamps, which leave the stress along, to those that hold blades along as well.
        """
        if ask.scene.temperature is None:
            return
        from flexcli.parts.temperature import held_stress

        across = held_stress(ask.scene.temperature, ask.geometry, ask.material, ask.sizes)
        if across <= FELT * strength:
            return
        along = max(float(stress.largest) for stress in found)
        both = _equivalent(along, across)
        error = ask.joint_model.error(ask, QuantityKind.STRESS)
        if error is not None:
            nu = ask.material.elastic.most_nu
            most = _equivalent(along * (1.0 + error.high), across / (1.0 - nu**2))
            error = ErrorRange(along * (1.0 + error.low) / both - 1.0, most / both - 1.0)
        yield Limit(
            self.label,
            ask.scene.case,
            "stress along and across blades, at clamps that keep them from growing",
            both,
            strength,
            "Pa",
            f"allowable: {allowable}; E times the difference of strains, by von Mises",
            required=self.factor,
            variant=f"{allowable}, held across",
            kind=QuantityKind.STRESS,
            error=error,
            strengths=(allowable.replace("-", "_"),),
        )


def _equivalent(along: float, across: float) -> float:
    """Return von Mises' stress of two stresses of opposite sign."""
    return sqrt(along**2 + along * across + across**2)
