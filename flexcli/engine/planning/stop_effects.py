"""What a scene with end stops calls for: a contact that gives, or one that is taken as rigid."""

from collections.abc import Iterator
from math import inf

from flexcli.engine.stopping.choice import choose
from flexcli.engine.stopping.judge import CONTACT_HISTORY
from flexcli.engine.stopping.scene import HERTZ, LINEAR, contact_series
from flexcli.engine.stopping.statics import LINE, StopTask, task_of
from flexcli.formulas.contact import CHORD, chord_deviation, point_contact
from flexcli.formulas.stop_stiffness import bent_shape
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.geometries import Sizes
from flexcli.parts.stops import Ball, Cylinder
from flexcli.results import EffectRow
from flexcli.results.plan import ModelRow
from flexcli.results.stops import StopPlace

__all__ = ["contact_models", "stop_effects"]

COST = 5.0
"""Times that a run with Hertz' contact takes of one with a rigid or linear one, as measured."""


def stop_effects(design: DesignSpec, sizes: Sizes) -> Iterator[EffectRow]:
    """Yield what the indentation of a round head adds to the travel, at the force of statics."""
    assert design.stops is not None  # the caller's
    task = task_of(design, design.stops, sizes)
    place = choose(task).place
    deep = _indented(task, place)
    if not deep:
        return
    share = deep / place.delta_G
    text = (
        f"indentation {share:.2g} of the gap at {place.R_stop:.3g} N; in time Hertz' contact costs "
        f"some {COST:.0f} times a rigid one, and is run where that cannot tell"
    )
    estimates = {"travel": _added(task, place, deep)}
    yield EffectRow(
        f"{EffectName.END_STOPS}, contact", False, share, estimates["travel"], text, estimates
    )


def contact_models(design: DesignSpec, sizes: Sizes, cost: float) -> Iterator[ModelRow]:
    """Yield line and runs as they judge in turn, with the error of the travel to expect of each.

    ``cost`` is that of a run with a rigid contact. What the blade's rigidity is off by is in all
    of them, what a round head gives in those without its law.
    """
    assert design.stops is not None  # the caller's
    task = task_of(design, design.stops, sizes)
    place = choose(task).place
    deep, series = _indented(task, place), contact_series(design.stops.contact)
    yield ModelRow(LINE, 1.0, inf, ("way there from rest",))
    for model in series:
        left = 0.0 if model == HERTZ else deep
        left *= chord_deviation(CHORD) if model == LINEAR else 1.0
        missing = () if model == series[-1] else ("Hertz' law",)
        error = task.rigidity_at(place).largest + _added(task, place, left)
        yield ModelRow(model, cost * (COST if model == HERTZ else 1.0), error, missing)


def _indented(task: StopTask, place: StopPlace) -> float:
    """Return how deep a round head goes into the blade at the force of statics [m]."""
    contact = task.stops.contact
    if not isinstance(contact, Ball | Cylinder) or not place.R_stop > 0.0:
        return 0.0
    # a ball gives more than a cylinder of its radius
    modulus = contact.modulus(task.elastic)
    return float(point_contact(F=place.R_stop, R=contact.radius, E_star=modulus).approach)


def _added(task: StopTask, place: StopPlace, deep: float) -> float:
    """Return what an indentation that a run does not have adds to the travel, relative."""
    return CONTACT_HISTORY * deep / float(bent_shape(place.L_a / task.L)) / task.travel
