"""A mechanism on its one degree of freedom, as one state of mounting leaves it."""

from dataclasses import dataclass
from functools import cached_property

from flexcli.mechanics.single_freedom import Expansion, SingleFreedom, expand
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import NotAvailable
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.mechanisms.parallel_stage import ParallelStage

__all__ = ["Freedom", "freedoms"]


@dataclass(frozen=True, eq=False)
class Freedom:
    """Bodies and springs with or without the balancing masses; ``mounted`` says which.

    ``shifted`` is the same with the parasitic shift of the joints, where its direction is not
    part of the spec: all of them to one side, the worst there is, and all to the other.
    """

    mounted: str
    system: SingleFreedom
    shifted: tuple[SingleFreedom, ...]
    base_turns: bool
    coordinate_turns: bool
    has_springs: bool

    @cached_property
    def rest(self) -> Expansion:
        """Return the equation of motion about the rest position, to the third order."""
        return expand(self.system, order=4)

    @property
    def m(self) -> float:
        """Return the equivalent mass [kg, or kg·m² where the output is an angle]."""
        return self.rest.mass.value

    @property
    def k(self) -> float | None:
        """Return the equivalent stiffness [N/m or N·m/rad], None where no joint has one."""
        return self.rest.stiffness.value if self.has_springs else None

    @property
    def coupling(self) -> float:
        """Return the coupling to the base's own kind of motion."""
        found = self.rest.coupling_rotation if self.base_turns else self.rest.coupling_x
        return found.value


def freedoms(design: DesignSpec, mechanism: Mechanism) -> tuple[Freedom, ...]:
    """Return the mechanism before its balancing masses, where it has such a state, and after."""
    blade, geometry = design.fixed_sizes(), design.geometry
    joint = shift = 0.0
    if blade is not None:
        joint = float(geometry.stiffness(design.material.elastic, blade))
        try:
            shift = float(geometry.parasitic_shift(blade, 1.0))
        except NotAvailable:
            shift = 0.0
    balanced = isinstance(mechanism, ParallelStage)
    stated = isinstance(mechanism, ParallelStage) and None not in mechanism.stiffnesses(None)

    def system(on: bool, shift: float) -> SingleFreedom:
        return mechanism.freedom(joint, geometry, balanced=on, shift=shift)

    def freedom(mounted: str, on: bool) -> Freedom:
        either = (shift, -shift) if balanced and shift else ()
        return Freedom(
            mounted,
            system(on, 0.0 if balanced else shift),
            tuple(system(on, sign) for sign in either),
            base_turns=mechanism.shaken_by(geometry) == "rotation",
            coordinate_turns=geometry.motion == "rotation",
            has_springs=blade is not None or stated,
        )

    after = freedom("after", True)
    if not balanced:
        return (after,)
    before = freedom("before", False)
    return (before, after) if before.m > 0.0 else (after,)
