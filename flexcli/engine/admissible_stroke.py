"""The stroke at which the stress reaches a strength, by the model that answers for the stress."""

from math import exp, log
from typing import NamedTuple

from flexcli.errors import SolveError
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.results import QuantityKind

__all__ = ["AdmissibleStroke", "admissible_stroke"]

ROUNDS = 30
"""Steps after which the stress is said not to reach the strength."""

SETTLED = 1e-5
"""Of the stress against the strength, before the last secant, which leaves some of its square."""

GENTLEST, STEEPEST = 0.3, 5.0
"""Powers of the stroke between which a stress is taken to grow."""


class AdmissibleStroke(NamedTuple):
    """A stroke from rest [rad or m], with its relative error, nothing where that is unknown."""

    travel: float
    error: float | None


def admissible_stroke(ask: Ask, strength: float) -> AdmissibleStroke | None:
    """Return the stroke at which the largest stress reaches a strength [Pa], without other loads.

    The stress of the model is inverted, what the rotation adds to it included. Where the model
    does not get there, or nobody knows its error there, it is the first order from rest with an
    unknown error; nothing where the joint tells no stress.
    """
    try:
        stresses = ask.geometry.end_stresses(ask.material.elastic, ask.sizes, 1.0)
    except NotAvailable:
        return None
    first = strength / max(abs(float(stress)) for stress in stresses.values())
    try:
        return _inverted(ask, strength, first) or AdmissibleStroke(first, None)
    except (NotAvailable, SolveError):
        return AdmissibleStroke(first, None)


def _inverted(ask: Ask, strength: float, first: float) -> AdmissibleStroke | None:
    """Return where the stress of the model is the strength, by secants in logarithms."""
    travel, power, before = first, 1.0, None
    for _ in range(ROUNDS):
        at = _moved(ask, travel)
        stress = max(abs(float(each.largest)) for each in ask.joint_model.stresses(at)[1])
        if not stress > 0.0:
            return None  # too small a number to tell
        off = log(strength / stress)
        if before is not None and travel != before[0]:
            seen = log(stress / before[1]) / log(travel / before[0])
            power = min(max(seen, GENTLEST), STEEPEST)
        before = travel, stress
        travel *= exp(off / power)
        if abs(off) <= SETTLED:
            error = ask.joint_model.error(at, QuantityKind.STRESS)
            return None if error is None else AdmissibleStroke(travel, error.largest / power)
    return None


def _moved(ask: Ask, travel: float) -> Ask:
    """Return what is asked at a stroke alone."""
    scene = ask.scene.without_loads()
    return ask._replace(scene=scene._replace(travel=travel, mean_travel=0.0, middle=0.0, lock=None))
