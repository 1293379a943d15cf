"""The series of models on one design, and the numbers that each is asked for."""

from collections.abc import Callable, Iterator, Sequence
from functools import partial
from math import isfinite
from typing import NamedTuple

from flexcli.engine.comparing.compared import Named, Reference, Timed
from flexcli.engine.joint_models.exact import ExactModel
from flexcli.engine.joint_models.joint_states import over_stroke
from flexcli.engine.joint_models.linear import LinearModel
from flexcli.errors import SolveError
from flexcli.mechanics.stresses import greatest_stress
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.requirements import AS_PRINTED, Ask, EndStress, JointModel

__all__ = [
    "CONTROL_LEVELS",
    "FINEST",
    "Finest",
    "Number",
    "SeriesModel",
    "SolvedSeries",
    "asked_of",
    "largest_stress",
    "numbers",
    "parasitic_shift",
    "series",
    "stiffness",
]

NODES = (3, 4, 6, 8, 12)
"""Gauss nodes on a piece of a blade, taken as they are."""

FINEST = (1e-12, 1e-9)
"""Tolerances of the finest model, the first that all numbers of a design reach."""

CONTROL_LEVELS = (10, 15, 22, 33, 50, 75, 112)
"""Nodes of which none are the finest's: what both agree on is no accident of either."""


class Finest(ExactModel):
    """The exact model to its last digits; the stress is sought between places too."""

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the greatest stress at a face anywhere."""
        peak = greatest_stress(over_stroke(ask, self.effects, self.tolerance, self.levels))
        stress = float(peak.total.max())
        return "greatest stress at a face", [EndStress("where it is greatest", stress, 0.0, 0.0)]


class SeriesModel(NamedTuple):
    """A model by the name that reports give it; a new one remembers no answer."""

    name: str
    new: Callable[[], JointModel]


class Number(NamedTuple):
    """A number of the design that every model may be asked for, SI."""

    name: str
    label: str
    unit: str
    by: Callable[[JointModel], float]

    def tried(self, joint_model: JointModel) -> float | None:
        """Return the number by a model, or nothing where it has no finite answer."""
        try:
            value = self.by(joint_model)
        except (NotAvailable, SolveError):
            return None
        return value if isfinite(value) else None


class SolvedSeries(NamedTuple):
    """Models on one design, the finest last, and the numbers that they are compared in.

    ``unsettled`` names the numbers without a sure value of the finest.
    """

    settled: Sequence[Reference[Number]]
    models: Sequence[Named]
    times: Timed
    unsettled: tuple[str, ...]


def series(geometry: Geometry, tolerance: float = FINEST[0]) -> tuple[SeriesModel, ...]:
    """Return the models that fit a geometry, from the cheapest to the finest.

    Those of given nodes solve their equations to the finest's tolerance, so that their error is
    that of their nodes.
    """
    closed = [SeriesModel(AS_PRINTED.name, lambda: AS_PRINTED)] if geometry.closed_forms else []
    exact = [
        SeriesModel(
            f"exact, {nodes} nodes", partial(ExactModel, tolerance=tolerance, levels=(nodes,))
        )
        for nodes in NODES
    ]
    return (
        *closed,
        SeriesModel("linear", LinearModel),
        *exact,
        SeriesModel("exact", ExactModel),
        SeriesModel(f"exact to {tolerance:g}", partial(Finest, tolerance=tolerance)),
    )


def numbers(design: DesignSpec, sizes: Sizes) -> Iterator[Number]:
    """Yield what is reported of a design's joint: at rest and assembly, then case by case."""
    geometry, asks = design.geometry, design.asks(sizes, AS_PRINTED)
    turns = geometry.motion == "rotation"
    name, unit = ("k_pivot", "N*m/rad") if turns else ("k_stage", "N/m")
    rest = design.ask(asks[0].scene.at_assembly(), sizes, AS_PRINTED)
    yield Number(name, "stiffness at rest", unit, asked_of(rest, stiffness))
    for ask in asks:
        scene = ask.scene
        end = f"_{scene.case}" if len(asks) > 1 else ""
        if scene.moves or scene.is_loaded:
            label = f"largest stress, {scene.case}"
            yield Number(f"sigma{end}", label, "Pa", asked_of(ask, largest_stress))
        if scene.moves:
            label = f"stiffness at full stroke, {scene.case}"
            yield Number(f"k_end{end}", label, unit, asked_of(ask, _stiffness_at_end))
            label = f"parasitic shift, {scene.case}"
            yield Number(f"shift{end}", label, "m", asked_of(ask, parasitic_shift))
        if scene.forces and scene.ends is not None:
            label = f"critical force, {scene.case}"
            yield Number(f"F_cr{end}", label, "N", asked_of(ask, _critical))


def asked_of(ask: Ask, number: Callable[[Ask], float]) -> Callable[[JointModel], float]:
    """Return what asks a model for a number of a case."""
    return lambda joint_model: float(number(ask._replace(joint_model=joint_model)))


def stiffness(ask: Ask) -> float:
    """Return the stiffness of the joint [N/m or N·m/rad]."""
    return float(ask.joint_model.stiffness(ask))


def _stiffness_at_end(ask: Ask) -> float:
    """Return the tangent at full stroke: that at rest by a model in which nothing changes it."""
    if isinstance(ask.joint_model, ExactModel):
        return ask.joint_model.stiffness_at_end(ask)
    return stiffness(ask)


def largest_stress(ask: Ask) -> float:
    """Return the largest magnitude of the stress in a case [Pa]."""
    _, stresses = ask.joint_model.stresses(ask)
    return max(abs(float(stress.largest)) for stress in stresses)


def parasitic_shift(ask: Ask) -> float:
    """Return the parasitic shift of a case [m]."""
    return float(ask.joint_model.parasitic_shift(ask))


def _critical(ask: Ask) -> float:
    """Return the least critical force in the plane, where all models know it."""
    found = ask.joint_model.critical(ask)
    return min(float(c.force) for c in found if c.way != "across the width")
