"""What a scene with end stops calls for: a contact that gives, or one that is taken as rigid."""

from collections.abc import Iterator

from flexcli.engine.stopping.choice import choose
from flexcli.engine.stopping.judge import CONTACT_HISTORY
from flexcli.engine.stopping.statics import task_of
from flexcli.formulas.contact import point_contact
from flexcli.formulas.stop_stiffness import bent_shape
from flexcli.parts.design import DesignSpec
from flexcli.parts.effect_names import EffectName
from flexcli.parts.geometries import Sizes
from flexcli.parts.stops import Ball, Cylinder
from flexcli.results import EffectRow

__all__ = ["stop_effects"]

COST = 5.0
"""Times that a run with Hertz' contact takes of one with a rigid or linear one, as measured."""


def stop_effects(design: DesignSpec, sizes: Sizes) -> Iterator[EffectRow]:
    """Yield what the indentation of a round head adds to the travel, at the force of statics."""
    stops = design.stops
    if stops is None or not isinstance(stops.contact, Ball | Cylinder):
        return
    task = task_of(design, stops, sizes)
    place = choose(task).place
    if place is None or not place.R_stop > 0.0:
        return
    # a ball gives more than a cylinder of its radius
    deep = point_contact(
        F=place.R_stop, R=stops.contact.radius, E_star=stops.contact.modulus(task.elastic)
    ).approach
    added = CONTACT_HISTORY * float(deep) / float(bent_shape(place.L_a / task.L))
    share = float(deep) / place.delta_G
    text = (
        f"indentation {share:.2g} of the gap at {place.R_stop:.3g} N; in time Hertz' contact costs "
        f"some {COST:.0f} times a rigid one, and is run where that cannot tell"
    )
    estimates = {"travel": added / task.travel}
    yield EffectRow(
        f"{EffectName.END_STOPS}, contact", False, share, estimates["travel"], text, estimates
    )
