"""What an actuator makes of a design: its stiffness, the stroke it reaches, what heat adds."""

from collections.abc import Iterator
from math import pi
from typing import NamedTuple

from flexcli.engine.models import NamedModel
from flexcli.errors import SolveError
from flexcli.parts.actuator import Actuator
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, DriveEffort
from flexcli.parts.requirements.drive import Driven, driven_by
from flexcli.results import QuantityKind, Value

__all__ = ["drive_values"]

SETTLED = 1e-7
"""Change of the stroke from step to step at which it is reached [-]."""

STEPS = 12

FARTHEST = pi
"""Rotation beyond which no pivot is followed: blades have broken long before [rad]."""

SMALL = 1e-9
"""A travel [rad or m] for a stiffness at rest in the terms of the actuator."""

MODEL = "exact"


class Reached(NamedTuple):
    """Where the force of an actuator meets that of the joint [m], and how far off that is [-]."""

    stroke: float
    error: float | None


def drive_values(design: DesignSpec, sizes: Sizes) -> dict[str, Value]:
    """Return stiffness, stroke and thermal stroke of the actuator of a design, by exact blades."""
    actuator = design.actuator
    assert actuator is not None
    joint_model = NamedModel(design, MODEL).joint_model
    found = {"k_T": Value(actuator.k_T, "N/m", "stiffness of the actuator", "given")}
    rest = design.ask(design.scenes()[0].at_assembly().without_loads(), sizes, joint_model)
    try:
        reached = _reached(actuator, rest)
    except (NotAvailable, SolveError):
        reached = None
    if reached is not None:
        found["s_reached"] = Value(
            reached.stroke, "m", "stroke that the actuator reaches at full drive",
            joint_model.name, "balance of its force and that of the joint",
            estimated_error=reached.error,
        )  # fmt: skip
    found.update(_thermal(actuator, design, rest))
    return found


def _reached(actuator: Actuator, ask: Ask) -> Reached | None:
    """Return the stroke at which k_T s + F(s) is the blocking force, from that of small motion."""
    travel = SMALL
    driven = _at_rest(actuator, ask)
    for _ in range(STEPS):
        before = driven
        wanted = actuator.force / (actuator.k_T + before.force / before.travel)
        if not wanted > 0.0:  # the joint pulls the drive along: it holds at no stroke
            return None
        travel *= wanted / before.travel
        if ask.geometry.motion == "rotation" and travel > FARTHEST:
            return None
        driven = _at(actuator, ask, travel)
        if abs(driven.travel / before.travel - 1.0) <= SETTLED:
            slope = driven.force / driven.travel
            error = driven.error
            off = None if error is None else error.largest * slope / (actuator.k_T + slope)
            return Reached(driven.travel, off)
    return None


def _at_rest(actuator: Actuator, ask: Ask) -> Driven:
    effort = float(ask.joint_model.stiffness(ask)) * SMALL
    error = ask.joint_model.error(ask, QuantityKind.STIFFNESS)
    return driven_by(actuator, ask, DriveEffort(SMALL, effort, error))


def _at(actuator: Actuator, ask: Ask, travel: float) -> Driven:
    """Return the larger of the forces at a travel [rad or m] either way, or one way."""
    if actuator.drives == "both-ways":
        scene = ask.scene._replace(travel=travel, mean_travel=0.0, middle=0.0)
    else:
        half = travel / 2.0
        scene = ask.scene._replace(travel=half, mean_travel=half, middle=half)
    asked = ask._replace(scene=scene)
    efforts = [e for e in ask.joint_model.effort(asked) if e.travel != 0.0]
    found = driven_by(actuator, asked, max(efforts, key=lambda each: each.effort))
    return found._replace(travel=abs(found.travel))


def _thermal(actuator: Actuator, design: DesignSpec, rest: Ask) -> Iterator[tuple[str, Value]]:
    """Yield how far each temperature moves the joint through the actuator at no drive."""
    for scene in design.scenes():
        if scene.temperature is None:
            continue
        try:
            growth = actuator.growth(scene.temperature, design.material)
            driven = _at_rest(actuator, rest)
        except NotAvailable:
            continue
        k = driven.force / driven.travel
        share = k / (actuator.k_T + k)
        off = None if driven.error is None else driven.error.largest * share
        yield (
            f"s_thermal_{scene.case}",
            Value(
                growth * (1.0 - share), "m",
                "how far the actuator's own growth moves the joint", rest.joint_model.name,
                "growth against both springs", estimated_error=off,
            ),
        )  # fmt: skip
