"""The ladder of models on one design, and the numbers that each is asked for."""

from collections.abc import Callable, Iterator
from functools import partial
from math import isfinite
from typing import NamedTuple

from flexcli.engine.answers.exact import ExactAnswers
from flexcli.engine.answers.joint_states import over_stroke
from flexcli.engine.answers.linear import LinearAnswers
from flexcli.errors import SolveError
from flexcli.mechanics.stresses import greatest_stress
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.requirements import AS_PRINTED, Answers, Ask, EndStress

__all__ = ["CONTROL_LEVELS", "FINEST", "Finest", "Number", "Rung", "ladder", "numbers"]

NODES = (3, 4, 6, 8, 12)
"""Gauss nodes on a piece of a blade, taken as they are."""

FINEST = (1e-12, 1e-9)
"""Tolerances of the finest model, the first that all numbers of a design reach."""

CONTROL_LEVELS = (10, 15, 22, 33, 50, 75, 112)
"""Nodes of which none are the finest's: what both agree on is no accident of either."""


class Finest(ExactAnswers):
    """The exact model to its last digits; the stress is sought between places too."""

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the greatest stress at a face anywhere."""
        peak = greatest_stress(over_stroke(ask, self.effects, self.tolerance, self.levels))
        stress = float(peak.total.max())
        return "greatest stress at a face", [EndStress("where it is greatest", stress, 0.0, 0.0)]


class Rung(NamedTuple):
    """A model by the name that reports give it; a new one remembers no answer."""

    name: str
    new: Callable[[], Answers]


class Number(NamedTuple):
    """A number of the design that every model may be asked for, SI."""

    name: str
    label: str
    unit: str
    by: Callable[[Answers], float]

    def tried(self, answers: Answers) -> float | None:
        """Return the number by a model, or nothing where it has no finite answer."""
        try:
            value = self.by(answers)
        except (NotAvailable, SolveError):
            return None
        return value if isfinite(value) else None


def ladder(geometry: Geometry, tolerance: float = FINEST[0]) -> tuple[Rung, ...]:
    """Return the models that fit a geometry, from the cheapest to the finest.

    Those of given nodes solve their equations to the finest's tolerance, so that their error is
    that of their nodes.
    """
    closed = [Rung(AS_PRINTED.model, lambda: AS_PRINTED)] if geometry.closed_forms else []
    exact = [
        Rung(f"exact, {nodes} nodes", partial(ExactAnswers, tolerance=tolerance, levels=(nodes,)))
        for nodes in NODES
    ]
    return (
        *closed,
        Rung("linear", LinearAnswers),
        *exact,
        Rung("exact", ExactAnswers),
        Rung(f"exact to {tolerance:g}", partial(Finest, tolerance=tolerance)),
    )


def numbers(design: DesignSpec, sizes: Sizes) -> Iterator[Number]:
    """Yield what is reported of a design's joint: at rest, then case by case."""
    geometry, asks = design.geometry, design.asks(sizes, AS_PRINTED)
    turns = geometry.motion == "rotation"
    stiffness, unit = ("k_pivot", "N*m/rad") if turns else ("k_stage", "N/m")
    yield Number(stiffness, "stiffness at rest", unit, _by(asks[0], _stiffness))
    for ask in asks:
        scene = ask.scene
        end = f"_{scene.case}" if len(asks) > 1 else ""
        if scene.moves or scene.is_loaded:
            yield Number(f"sigma{end}", f"largest stress, {scene.case}", "Pa", _by(ask, _stress))
        if scene.moves:
            label = f"stiffness at full stroke, {scene.case}"
            yield Number(f"k_end{end}", label, unit, _by(ask, _stiffness_at_end))
            yield Number(f"shift{end}", f"parasitic shift, {scene.case}", "m", _by(ask, _shift))
        if scene.forces and scene.ends is not None:
            yield Number(f"F_cr{end}", f"critical force, {scene.case}", "N", _by(ask, _critical))


def _by(ask: Ask, number: Callable[[Ask], float]) -> Callable[[Answers], float]:
    return lambda answers: float(number(ask._replace(answers=answers)))


def _stiffness(ask: Ask) -> float:
    return float(ask.answers.stiffness(ask))


def _stiffness_at_end(ask: Ask) -> float:
    """Return the tangent at full stroke: that at rest by a model in which nothing changes it."""
    if isinstance(ask.answers, ExactAnswers):
        return ask.answers.stiffness_at_end(ask)
    return _stiffness(ask)


def _stress(ask: Ask) -> float:
    _, stresses = ask.answers.stresses(ask)
    return max(abs(float(stress.largest)) for stress in stresses)


def _shift(ask: Ask) -> float:
    return float(ask.answers.parasitic_shift(ask))


def _critical(ask: Ask) -> float:
    """Return the least critical force in the plane, where all models know it."""
    found = ask.answers.critical(ask)
    return min(float(c.force) for c in found if c.way != "across the width")
