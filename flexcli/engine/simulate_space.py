"""The verb simulate in space: support stiffness in six axes at every travel of a stroke."""

from dataclasses import replace
from math import inf, isfinite
from time import perf_counter

import numpy as np

from flexcli.engine import omitted_effects
from flexcli.engine import values as design_values
from flexcli.engine.joint_models.space_errors import StrokeErrors
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_shell import SpaceShellModel
from flexcli.engine.joint_models.space_stroke import (
    along_cases,
    at_travel,
    compliance_along_cases,
    driven_coordinate,
)
from flexcli.engine.judge import Interrupted, Judgement, judge, stopped_result
from flexcli.engine.models import model_series
from flexcli.engine.simulate import moving_cases, strokes
from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import axes_about_z
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.support import driven_stiffness, vibration
from flexcli.mechanics.space.layout import Drive
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.support import DIRECTIONS
from flexcli.results import Cost, Result, Status
from flexcli.results.activity import doing
from flexcli.results.simulation import SpacePoint, SpaceSweep, SupportSweeps

__all__ = ["simulate_in_space", "strokes_in_space", "support_over_stroke"]

CENTRE = (0.0, 0.0, 0.0)

ALIGNED = 1.0 - 1e-9
"""Cosine between a drive and an axis of cases from which they are one: rounding of their angle."""


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
    turns = design.geometry.motion == "rotation"
    stroke = "rotation: 5 deg" if turns else "translation: 1 mm"
    moving = moving_cases(design, sizes, joint_model, stroke)
    return tuple(_sweep(ask, points, joint_model) for ask in moving)


def support_over_stroke(design: DesignSpec, sizes: Sizes, points: int) -> SupportSweeps:
    """Return what holds the joint over the stroke of every case, in space where it can be followed.

    A joint of the plane can where it is made of blades of constant thickness whose shear modulus
    is known; else it has the sweep in its plane.

    Raises
    ------
    SolveError
        When no case has a stroke, or the joint has no sweep in its plane either.

    """
    followed = strokes_in_space(design, sizes, points)
    left = {sweep.case for sweep in followed if len(sweep.points) < 2}
    swept = strokes(design, sizes, points) if left and not design.geometry.in_space else ()
    return SupportSweeps(
        tuple(sweep for sweep in followed if sweep.case not in left),
        tuple(sweep for sweep in swept if sweep.case in left),
        tuple(f"{sweep.case}: {sweep.missed}" for sweep in followed if sweep.missed),
    )


def _sweep(ask: Ask, points: int, model: SpaceExactModel) -> SpaceSweep:
    scene = ask.scene
    doing(f"the stroke of {scene.case}")
    found, missed, why, drive = list[SpacePoint](), 0, "", ""
    for travel in np.linspace(scene.middle - scene.travel, scene.middle + scene.travel, points):
        try:
            state = at_travel(ask, float(travel), model.blades)
            drive = _driven_axis(ask, state.layout.drive)
            found.append(_point(ask, float(travel), state, drive, model))
        except (NotAvailable, SolveError) as error:
            missed, why = missed + 1, str(error)
    told = f"{missed} of {points} travels were not reached: {why}" if missed else ""
    return SpaceSweep(scene.case, ask.geometry.motion, tuple(found), told, drive)


def _driven_axis(ask: Ask, drive: Drive) -> str:
    """Return the axis of cases that a drive moves along or about; empty where it is oblique."""
    cosines = np.abs(axes_about_z(ask.geometry.axes) @ np.array(drive.direction))
    i = int(np.argmax(cosines))
    return DIRECTIONS[i + 3 * drive.turns] if cosines[i] >= ALIGNED else ""


def _point(
    ask: Ask, travel: float, state: SpaceEquilibrium, drive: str, model: SpaceExactModel
) -> SpacePoint:
    layout = state.layout
    body = layout.body(layout.drive.body)
    motion = along_cases(ask) @ state.motion_of(body.name, body.point)
    own = driven_coordinate(layout)
    stiffness = _stiffnesses(ask, state, drive)
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
        error=_support_error(ask, state, drive, stiffness, errors),
    )


def _stiffnesses(ask: Ask, state: SpaceEquilibrium, drive: str) -> dict[str, float]:
    """Return the support stiffness in six axes, the drive locked, endless where it is held.

    A drive that turns holds a coordinate of the rotation vector: where the body tilts besides, that
    leaves some 1e-9 of compliance about its axis, which is none.
    """
    locked = compliance_along_cases(ask, state, CENTRE, locked=True)
    stiffness = {}
    for i, axis in enumerate(DIRECTIONS):
        block = slice(0, 3) if i < 3 else slice(3, 6)
        held = axis == drive or locked[i, i] <= 1e-12 * np.trace(np.abs(locked)[block, block])
        stiffness[f"k_{axis}"] = inf if held else float(1.0 / locked[i, i])
    return stiffness


def _support_error(
    ask: Ask,
    state: SpaceEquilibrium,
    drive: str,
    stiffness: dict[str, float],
    errors: StrokeErrors | None,
) -> float | None:
    """Return the error of a support stiffness: of the blades, and of the level of nodes before."""
    if state.coarser is None or errors is None:
        return None
    before = _stiffnesses(ask, state.coarser, drive)
    changes = (abs(before[name] / k - 1.0) for name, k in stiffness.items() if isfinite(k))
    return errors.support + max(changes, default=0.0)
