"""The models of what shakes the base, in turn as they judge: which is accurate enough, and why.

Miles' formula has the strongest mode alone, and what is left out as its error. Modes are those of
the blades with their mass, as stiff as the joint is by each of its models; what that stiffness and
the stress may be off by moves resonances, which is the error of the peaks. Where stops are in the
way, a run in time follows the operating line, its contact finer each time.
"""

from collections.abc import Iterator
from math import inf

from flexcli.engine.models import model_series
from flexcli.engine.planning.coverage import COVERAGE
from flexcli.engine.planning.in_space import COSTS
from flexcli.errors import SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, RequirementError
from flexcli.parts.requirements.dynamic import Dynamic, DynamicYield, FindsPeaks
from flexcli.parts.requirements.shaking import SHAKES
from flexcli.parts.scene import Scene
from flexcli.results.plan import ModelRow, ScenePlan

__all__ = ["MODES", "scene_plans"]

MODES = "modes, "
"""Start of the name of a model of the response, before that of the joint's."""

RESPONSE = 60.0
"""Cost in closed forms of a response over the range of its structure, as measured: 60 ms."""
BY_FORMULA = 30.0
"""The same of Miles' formula, which looks at no mode over that range but those that tell."""
OUTSIDE = ("other modes", "slope and ends of the band")
"""What Miles' formula leaves out."""
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
    """Yield Miles' formula and the modes by each model of the joint, until one will do."""
    requirement, series = _requirement(design, scene), model_series(design)
    costs = COSTS if design.geometry.in_space else {n: row.cost for n, row in COVERAGE.items()}
    formula = requirement.formula(scene) if len(series) > 1 else ""
    if formula:
        ask = design.ask(scene, sizes, series[0].joint_model)
        error = _error(requirement.miles_peaks, ask)
        if error is not None:
            yield ModelRow(formula, BY_FORMULA, error, OUTSIDE)
            if error <= asked:
                return
    for model in series:
        error = _error(requirement.peaks, design.ask(scene, sizes, model.joint_model))
        if error is not None:
            cost = RESPONSE + costs.get(model.name, 0.0)
            yield ModelRow(f"{MODES}{model.name}", cost, error, ())
            if error <= asked:
                return


def _error(peaks: FindsPeaks, ask: Ask) -> float | None:
    """Return the largest error of the stresses, or nothing where there is no answer."""
    try:
        errors = [peak.error for peak in peaks(ask, "stress", inf)]
    except (NotAvailable, RequirementError, SolveError):
        return None
    return max((inf if each is None else each.largest for each in errors), default=inf)


def _requirement(design: DesignSpec, scene: Scene) -> Dynamic:
    """Return what is asked of the response, so that its own peaks count; else the stress."""
    asked = (each for _, each in design.requirements.each() if isinstance(each, Dynamic))
    return next((each for each in asked if each.applies(scene)), DynamicYield(factor=1.0))


def _why(design: DesignSpec, scene: Scene) -> str:
    """Return what the modes have in them, and on which side what they leave out lies."""
    mass = "with" if design.material.density is not None else "without a density for"
    told = [f"all modes that the band reaches, {mass} the blades' mass"]
    told.append("in space" if scene.vibrates_in_space else "in the plane")
    if scene.sweep is not None:
        told.append("steady at each frequency, which a sweep does not exceed by a mode of its own")
    return ", ".join(told)
