"""A blade between its stops as the time engine takes it: modes, law of the stops, damping."""

from math import inf, sqrt

from flexcli.engine.stopping.damping import case_quality
from flexcli.engine.stopping.statics import StopTask
from flexcli.mechanics.stopping.cantilever_modes import cantilever_modes
from flexcli.mechanics.stopping.laws import (
    AnyStopLaw,
    HertzStop,
    LinearStop,
    RigidStop,
    Stops,
    damping_ratio,
    stiffness_on_blade,
)
from flexcli.mechanics.stopping.modal_blade import ModalBlade
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.stops import Ball, Contact, Rigid, Spring
from flexcli.results.stops import StopPlace

__all__ = [
    "HERTZ",
    "LINEAR",
    "RIGID",
    "contact_model",
    "contact_series",
    "is_round",
    "stop_scene",
]

HERTZ, LINEAR = "Hertz contact", "linear contact"

RIGID = "rigid, the blade's own compliance against it"


def is_round(contact: Contact) -> bool:
    """Return whether a contact gives by Hertz' law, which costs a simulation much more."""
    return isinstance(contact, Ball)


def contact_model(contact: Contact, head: float | None) -> str:
    """Return the name of the model of a contact in time, of a round one by its stand-in."""
    if is_round(contact) and head != inf:
        return HERTZ if head is None else LINEAR
    if isinstance(contact, Spring):
        return "spring contact"
    if isinstance(contact, Rigid) and contact.restitution is not None:
        return "impact"
    return "rigid contact"


def contact_series(contact: Contact) -> tuple[str, ...]:
    """Return the models of a contact in time that judge, the cheapest first."""
    cheapest = contact_model(contact, inf)
    return (cheapest, LINEAR, HERTZ) if is_round(contact) else (cheapest,)


def stop_scene(
    design: DesignSpec,
    task: StopTask,
    sizes: Sizes,
    place: StopPlace,
    case: str,
    *,
    head: float | None = None,
    stiffening: float = 0.0,
    more_modes: int = 0,
) -> tuple[ModalBlade, Stops, str]:
    """Return modes and stops of one case, and the law in words.

    ``head`` is the stiffness [N/m] of a head that stands for a round one, inf for one that does
    not give; ``stiffening`` is what the blade's rigidity has over that of the beam, relative.
    """
    mechanism, density = task.mechanism, design.material.density
    volume = float(design.geometry.volume(sizes))
    blade = cantilever_modes(
        E=task.elastic.E * (1.0 + stiffening),
        I=task.I,
        L=task.L,
        L_a=place.L_a,
        m=mechanism.mass,
        blade_mass=density.value * volume if density is not None else 0.0,
        c=mechanism.offset,
        J=mechanism.inertia,
        modes=task.stops.simulation.modes + more_modes,
        quality=case_quality(mechanism, case, design.cases[case]),
    )
    contact = task.stops.contact
    law, words = _law(contact, task, blade)
    if head is not None and is_round(contact):
        law, words = LinearStop(head), RIGID if head == inf else f"{words}, as a line"
    if isinstance(law, RigidStop):
        blade = blade.truncated()
    below = place.delta_G if task.stops.sides == "both" else inf
    return blade, Stops(law, above=place.delta_G, below=below), words


def _law(contact: Contact, task: StopTask, blade: ModalBlade) -> tuple[AnyStopLaw, str]:
    """Return how a contact pushes back; a line contact has no law of its own and is rigid."""
    if isinstance(contact, Ball):
        stiffness = 4.0 / 3.0 * contact.modulus(task.elastic) * sqrt(contact.radius)
        return HertzStop(stiffness), "ball, Hertz, elastic"
    if isinstance(contact, Spring):
        mass = 1.0 / float(blade.stop @ blade.stop)
        critical = 2.0 * sqrt(stiffness_on_blade(blade, contact.stiffness) * mass)
        law = LinearStop(contact.stiffness, damping_ratio(contact.restitution) * critical)
        return law, f"spring, restitution {contact.restitution:g}"
    if isinstance(contact, Rigid) and contact.restitution is not None:
        return RigidStop(contact.restitution), f"rigid, restitution {contact.restitution:g}"
    return LinearStop(), RIGID
