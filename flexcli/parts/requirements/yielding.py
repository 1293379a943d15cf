"""Yield: the largest stress of a case against an allowable of the material."""

from collections.abc import Iterator, Sequence
from math import isnan
from typing import Annotated, Any, ClassVar, Literal

from pydantic import field_validator

from flexcli.parts.base import OneOrMore, spec_error
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements.ask import Ask, EndStress, RequirementError
from flexcli.parts.requirements.base import HELD_ACROSS, FactorRequirement, Limit
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
        """Yield the stress at clamps that keep blades from growing, with that along them.

        Its range goes up to what rigid clamps hold but in their edges, and down to what they hold
        amid them; unless they are said to be rigid, down to clamps that leave the stress along.
        """
        if ask.scene.temperature is None:
            return
        from flexcli.parts.held_at_clamps import held_at_clamps

        held = held_at_clamps(ask.scene.temperature, ask.geometry, ask.material, ask.sizes)
        if held is None or held.most(0.0, 0.0) <= FELT * strength:
            return
        along = max(float(stress.largest) for stress in found)
        pulled = ask.joint_model.axial_stress(ask)
        axial = along if pulled is None else min(pulled, along)
        both = held.likely(along, axial)
        error = ask.joint_model.error(ask, QuantityKind.STRESS)
        if error is not None:
            more, less = 1.0 + error.high, 1.0 + error.low
            most = held.most(along * more, axial * more)
            least = held.least(along * less, axial * more)
            # no stress along has no share that it may be off by
            error = None if isnan(most) else ErrorRange(least / both - 1.0, most / both - 1.0)
        yield Limit(
            self.label,
            ask.scene.case,
            "stress at clamps that keep blades from growing, with that along",
            both,
            strength,
            "Pa",
            f"allowable: {allowable}; clamp-held-middle and -face, by von Mises",
            required=self.factor,
            variant=f"{allowable}, {HELD_ACROSS}",
            kind=QuantityKind.STRESS,
            error=error,
            strengths=(allowable.replace("-", "_"),),
        )
