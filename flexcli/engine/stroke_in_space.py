"""A joint in space over the stroke of a case: its support stiffness in six axes at every travel."""

from math import inf, isfinite

import numpy as np

from flexcli.engine.joint_models.space_errors import StrokeErrors
from flexcli.engine.joint_models.space_exact import SpaceExactModel
from flexcli.engine.joint_models.space_stroke import (
    along_cases,
    at_travel,
    compliance_along_cases,
    driven_coordinate,
)
from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import axes_about_z
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.support import driven_stiffness, vibration
from flexcli.mechanics.space.layout import Drive
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.support import DIRECTIONS
from flexcli.results.simulation import SpacePoint, SpaceSweep

__all__ = ["stroke_in_space"]

CENTRE = (0.0, 0.0, 0.0)

ALIGNED = 1.0 - 1e-9
"""Cosine between a drive and an axis of cases from which they are one: rounding of their angle."""


def stroke_in_space(ask: Ask, points: int, model: SpaceExactModel) -> SpaceSweep:
    """Return the joint at so many travels of a case, those left out that were not reached."""
    scene = ask.scene
    found, missed, why, drive = list[SpacePoint](), 0, "", ""
    for travel in np.linspace(*scene.stroke_ends, points)[::-1]:
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
