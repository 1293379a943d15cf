"""Drive: the force that the actuator has left at the ends of the stroke, over the force needed."""

from collections.abc import Iterator
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements.ask import Ask, DriveEffort, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

if TYPE_CHECKING:
    from flexcli.parts.actuator import Actuator

__all__ = ["Drive", "Driven", "driven_by"]


class Driven(NamedTuple):
    """Travel of the actuator [m], force needed there, outwards [N], and its error."""

    travel: float
    force: float
    error: ErrorRange | None


class Drive(FactorRequirement):
    """Factor on the force at both ends of the stroke against what the actuator has left there."""

    label: ClassVar[str] = "drive"
    closed_form: ClassVar[bool] = False
    by_solids: ClassVar[bool] = True

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a stroke to drive."""
        return scene.moves and self.covers(scene)

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke, and the temperature that moves joint and actuator besides."""
        return frozenset({LoadKind.STROKE, LoadKind.TEMPERATURE})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the force needed at either end against what the actuator has left."""
        actuator, scene = _actuator(ask), ask.scene
        try:
            growth = actuator.growth(scene.temperature, ask.material)
        except NotAvailable as error:
            hint = "give actuator.length and thermal_expansion, and a uniform temperature"
            raise RequirementError(f"at a temperature the design {error}", hint) from error
        for effort in ask.joint_model.effort(ask):
            found = driven_by(actuator, ask, effort)
            pushes = actuator.drives == "one-way"
            if found.travel == 0.0 and (not scene.is_loaded or (pushes and found.force < 0.0)):
                continue  # at rest nothing is to be held
            back = pushes and (found.travel < 0.0 or found.force < 0.0)
            text = f"force of the drive at {found.travel * 1e6:+.4g} um"
            yield Limit(
                self.label,
                scene.case,
                f"{text}, the way it does not drive" if back else text,
                abs(found.force),
                0.0 if back else actuator.available(found.travel, growth),
                "N",
                "load line, blocking force (1 - stroke/free stroke)",
                required=self.factor,
                kind=QuantityKind.STIFFNESS,
                error=found.error,
            )


def _actuator(ask: Ask) -> "Actuator":
    """Return the actuator of a design, or raise where there is none, or its load is unknown."""
    if ask.actuator is None:
        raise RequirementError(
            "there is no actuator that drives the stroke",
            "add actuator: {blocking_force: 5.5 N, free_stroke: 85 um}",
        )
    several = ask.mechanism is not None and ask.mechanism.joints > 1
    if several and LoadKind.ACCELERATION in ask.scene.loads:
        raise RequirementError(
            "what an acceleration puts on the drive of several joints is not known",
            "state the acceleration in a case without a stroke",
        )
    return ask.actuator


def driven_by(actuator: "Actuator", ask: Ask, effort: DriveEffort) -> Driven:
    """Return travel and force of the actuator at an effort of each joint.

    An arm, and joints between levers, turn by less than their shift suggests by a share θ²/2, which
    is in the error twice.
    """
    travel, spring, error, load = effort
    force = spring + load
    if error is not None and force != 0.0:
        error = ErrorRange(error.low * abs(spring / force), error.high * abs(spring / force))
    turns, mechanism = ask.geometry.motion == "rotation", ask.mechanism
    if mechanism is not None and mechanism.joints > 1:
        moved = travel / mechanism.joint_travel_per_motion
        if travel != 0.0:
            force = abs(moved) * mechanism.mode(force / abs(travel), ask.geometry).stiffness
    elif actuator.arm is not None:
        moved, force = travel * actuator.arm, force / actuator.arm
    else:
        moved = travel
    if turns and error is not None:
        error += ErrorRange(-(travel**2), travel**2)
    return Driven(moved, float(force), error)
