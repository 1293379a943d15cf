"""The verb simulate in space: support stiffness in six axes at every travel of a stroke."""

from dataclasses import replace
from math import inf, isfinite
from time import perf_counter

import numpy as np

from flexcli.engine import omitted_effects
from flexcli.engine import values as design_values
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_shell import SpaceShellModel
from flexcli.engine.joint_models.space_stroke import (
    StrokeErrors,
    along_cases,
    at_travel,
    compliance_along_cases,
    driven_coordinate,
)
from flexcli.engine.judge import Interrupted, Judgement, judge, stopped_result
from flexcli.engine.models import model_series
from flexcli.engine.simulate import moving_cases
from flexcli.errors import SolveError
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.support import driven_stiffness, vibration
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask
from flexcli.results import Cost, Result, Status
from flexcli.results.activity import doing
from flexcli.results.simulation import SpacePoint, SpaceSweep

__all__ = ["simulate_in_space", "strokes_in_space"]

CENTRE = (0.0, 0.0, 0.0)


def simulate_in_space(design: DesignSpec, sizes: Sizes, spec: str, points: int) -> Result:
    """Return the sweep of every case that has a stroke, and the margins by the model of the spec.

    That is the exact one, or the shell model where the spec names it.

    Raises
    ------
    SolveError
        When no case has a stroke.

    """
    started = perf_counter()
    joint_model = SpaceShellModel() if design.model == "shell" else SpaceExactModel()
    moving = moving_cases(design, sizes, joint_model, "translation: 1 mm")
    models = model_series(design, joint_model.name)
    sweeps: tuple[SpaceSweep, ...] = ()
    try:
        for ask in moving:
            sweeps += (_sweep(ask, points, joint_model),)
        values = design_values.values(design, sizes, joint_model)
        found = judge(design, sizes, models)
    except KeyboardInterrupt as stopped:
        if not sweeps:
            raise
        so_far = stopped.so_far if isinstance(stopped, Interrupted) else Judgement((), {}, models)
        result = stopped_result("simulate", design, spec, so_far, perf_counter() - started)
        return replace(result, space_sweeps=sweeps)
    reached = not any(sweep.missed for sweep in sweeps)
    return Result(
        command="simulate",
        spec=spec,
        status=found.status if reached or found.status is not Status.PASS else Status.FAIL,
        title=design.title,
        values=design_values.with_errors(
            values, omitted_effects.errors_of(design, sizes, models[0].joint_model, values)
        ),
        checks=found.checks,
        space_sweeps=sweeps,
        cost=Cost(perf_counter() - started, joint_model.name, None, by_model=found.by_model),
    )


def strokes_in_space(design: DesignSpec, sizes: Sizes, points: int) -> tuple[SpaceSweep, ...]:
    """Return the sweep of every case that has a stroke, without a verdict."""
    joint_model = SpaceExactModel()
    moving = moving_cases(design, sizes, joint_model, "translation: 1 mm")
    return tuple(_sweep(ask, points, joint_model) for ask in moving)


def _sweep(ask: Ask, points: int, model: SpaceExactModel) -> SpaceSweep:
    scene = ask.scene
    doing(f"the stroke of {scene.case}")
    found, missed, why = [], 0, ""
    for travel in np.linspace(scene.middle - scene.travel, scene.middle + scene.travel, points):
        try:
            found.append(_point(ask, float(travel), model))
        except (NotAvailable, SolveError) as error:
            missed, why = missed + 1, str(error)
    told = f"{missed} of {points} travels were not reached: {why}" if missed else ""
    return SpaceSweep(scene.case, ask.geometry.motion, tuple(found), told)


def _point(ask: Ask, travel: float, model: SpaceExactModel) -> SpacePoint:
    state = at_travel(ask, travel, model.blades)
    layout = state.layout
    body = layout.body(layout.drive.body)
    motion = along_cases(ask) @ state.motion_of(body.name, body.point)
    own = driven_coordinate(layout)
    stiffness = _stiffnesses(ask, state)
    mass = any(each.mass > 0.0 for each in layout.bodies)
    stress, blade = model.largest_stress(state)
    errors = model.blades.errors(state)
    moved = ("shift_x", "shift_y", "shift_z", "turn_x", "turn_y", "turn_z")
    return SpacePoint(
        travel=travel,
        effort=float(state.reactions.ravel()[own]),
        stiffness=driven_stiffness(state, own),
        **dict(zip(moved, map(float, motion), strict=True)),
        **stiffness,
        frequency=float(vibration(state).frequency[0, 0]) if mass else None,
        stress=stress,
        blade=blade,
        error=_support_error(ask, state, stiffness, errors),
    )


def _stiffnesses(ask: Ask, state: SpaceEquilibrium) -> dict[str, float]:
    """Return the support stiffness in six axes, the drive locked, endless where it is held."""
    locked = compliance_along_cases(ask, state, CENTRE, locked=True)
    stiffness = {}
    for i, axis in enumerate(("x", "y", "z", "theta_x", "theta_y", "theta_z")):
        block = slice(0, 3) if i < 3 else slice(3, 6)
        held = locked[i, i] <= 1e-12 * np.trace(np.abs(locked)[block, block])
        stiffness[f"k_{axis}"] = inf if held else float(1.0 / locked[i, i])
    return stiffness


def _support_error(
    ask: Ask, state: SpaceEquilibrium, stiffness: dict[str, float], errors: StrokeErrors | None
) -> float | None:
    """Return the error of a support stiffness: of the blades, and of the level of nodes before."""
    if state.coarser is None or errors is None:
        return None
    before = _stiffnesses(ask, state.coarser)
    changes = (abs(before[name] / k - 1.0) for name, k in stiffness.items() if isfinite(k))
    return errors.support + max(changes, default=0.0)
