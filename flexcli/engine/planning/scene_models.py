"""The models of what shakes the base, in turn as they judge: which is accurate enough, and why.

Modes are those of the blades with their mass, as stiff as the joint is by each of its models; what
that stiffness and the stress may be off by moves resonances, which is the error of the peaks. Where
stops are in the way, a run in time follows the operating line, its contact finer each time.
"""

from collections.abc import Iterator
from math import inf

from flexcli.engine.models import model_series
from flexcli.engine.planning.coverage import COVERAGE
from flexcli.engine.planning.in_space import COSTS
from flexcli.engine.planning.vibration_effects import against_miles, largest_peaks
from flexcli.engine.response_spectra import structure_of_case
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, RequirementError
from flexcli.parts.requirements.dynamic import Dynamic, DynamicYield
from flexcli.parts.requirements.shaking import SHAKES
from flexcli.parts.scene import Scene
from flexcli.results.plan import ModelRow, ScenePlan

__all__ = ["MODES", "scene_plans"]

MODES = "modes, "
"""Start of the name of a model of the response, before that of the joint's."""

RESPONSE = 60.0
"""Cost in closed forms of a response over the range of its structure, as measured: 60 ms."""
RUN = 300.0
"""The same of a run between stops with a rigid or linear contact; Hertz' takes five times it."""


def scene_plans(design: DesignSpec, sizes: Sizes, asked: float) -> Iterator[ScenePlan]:
    """Yield the plan of each case that shakes the base, for an accuracy of its peak stress."""
    for name, case in design.cases.items():
        scene = design.scene(name)
        if not scene.loads & SHAKES:
            continue
        if design.stops is not None and "x" in case.shaken_axes:
            from flexcli.engine.planning.stop_effects import contact_models

            rows = tuple(contact_models(design, sizes, RUN))
            why = "runs with other blades and more modes tell how far each is off"
        else:
            rows = tuple(_responses(design, sizes, scene, asked))
            why = _why(design, scene)
        if rows:
            yield _chosen(name, rows, asked, why)


def _chosen(case: str, rows: tuple[ModelRow, ...], asked: float, why: str) -> ScenePlan:
    """Return the cheapest that is accurate enough, else the most accurate one."""
    taken = min(rows, key=lambda row: (max(row.error, asked), row.cost))
    reason = "the cheapest within the accuracy" if taken.error <= asked else "the most accurate"
    return ScenePlan(case, rows, taken.name, taken.cost, taken.error, f"{reason}; {why}")


def _responses(design: DesignSpec, sizes: Sizes, scene: Scene, asked: float) -> Iterator[ModelRow]:
    """Yield Miles' worst case and the modes by each model of the joint, until one will do."""
    requirement = _requirement(design, scene)
    costs = COSTS if design.geometry.in_space else {n: row.cost for n, row in COVERAGE.items()}
    for index, model in enumerate(model_series(design)):
        ask = design.ask(scene, sizes, model.joint_model)
        try:
            errors = [peak.error for peak in requirement.peaks(ask, "stress")]
        except (NotAvailable, RequirementError, SolveError):
            continue
        error = max((inf if each is None else each.largest for each in errors), default=inf)
        if index == 0:
            yield from _miles(ask, error)
        yield ModelRow(f"{MODES}{model.name}", RESPONSE + costs.get(model.name, 0.0), error, ())
        if error <= asked:
            return


def _requirement(design: DesignSpec, scene: Scene) -> Dynamic:
    """Return what is asked of the response, so that its own peaks count; else the stress."""
    asked = (each for _, each in design.requirements.each() if isinstance(each, Dynamic))
    return next((each for each in asked if each.applies(scene)), DynamicYield(factor=1.0))


def _miles(ask: Ask, of_modes: float) -> Iterator[ModelRow]:
    """Yield Miles' worst case, which sizes blades: what it is off by is seen in the modes.

    It is off by that and by what the modes are.
    """
    try:
        peaks = largest_peaks(ask, structure_of_case(ask))
    except (SolveError, ValueError, RequirementError):
        return  # said where it is judged
    for row in against_miles(ask, peaks):
        error = (1.0 + row.estimate) * (1.0 + of_modes) - 1.0
        yield ModelRow("Miles", 1.0, error, ("higher modes", "blade mass"))


def _why(design: DesignSpec, scene: Scene) -> str:
    """Return what the modes have in them, and on which side what they leave out lies."""
    mass = "with" if design.material.density is not None else "without a density for"
    told = [f"all modes that the band reaches, {mass} the blades' mass"]
    told.append("in space" if scene.vibrates_in_space else "in the plane")
    if scene.sweep is not None:
        told.append("steady at each frequency, which a sweep does not exceed by a mode of its own")
    return ", ".join(told)
