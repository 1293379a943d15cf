"""Buckling: the force on the joint against the one that buckles its most loaded blade."""

from collections.abc import Iterator
from typing import ClassVar

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import QuantityKind

__all__ = ["Buckling"]


class Buckling(FactorRequirement):
    """Factor on the force, about both axes of the section, for the stated hold of the ends."""

    label: ClassVar[str] = "buckling"

    def applies(self, scene: Scene) -> bool:
        """Return whether the case puts a force along the blades."""
        return self.covers(scene) and scene.blade_force > 0.0

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return what pushes the joint."""
        return scene.pushed_by

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield force against critical force, bending across the thickness and across the width."""
        scene = ask.scene
        if scene.ends is None:
            raise RequirementError(
                f"nothing says what holds the blades' ends in case '{scene.case}'",
                f"add ends: to the case, one of {', '.join(EFFECTIVE_LENGTH)}",
            )
        for critical in ask.answers.critical(ask):
            yield Limit(
                self.label,
                scene.case,
                f"force {scene.force_name}, buckling {critical.way}",
                scene.force,
                critical.force,
                "N",
                f"{critical.source}: {scene.ends_why}",
                required=self.factor,
                load=True,
                driver="force",
                kind=QuantityKind.BUCKLING,
                in_capacity=True,
            )
