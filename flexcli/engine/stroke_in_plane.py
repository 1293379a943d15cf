"""A joint in its plane over the stroke of a case, in exact equilibrium at every travel."""

from collections.abc import Sequence
from math import inf, pi, sqrt

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.exact import TOLERANCE, driven_stiffness
from flexcli.engine.joint_models.holds import driven_axis
from flexcli.engine.joint_models.joint_states import blades_of, over_travels
from flexcli.errors import Outcome
from flexcli.mechanics.demand import Held
from flexcli.mechanics.energy import strain_energy
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.stability import is_stable
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import greatest_stress
from flexcli.mechanics.tangent import body_stiffness
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.own_motion import own_mode
from flexcli.parts.requirements import Ask
from flexcli.results.simulation import Deflection, SweepPoint, SweepResult

__all__ = ["stroke_in_plane"]

Floats = NDArray[np.float64]


def stroke_in_plane(ask: Ask, points: int, blades: Effects) -> SweepResult:
    """Return the joint at so many travels of a case; ``blades`` is what they do besides bending.

    Raises :class:`NotAvailable` where the joint is not made of blades in a plane.
    """
    scene = ask.scene
    travels = np.linspace(*scene.stroke_ends, points)[::-1]

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        return solve(
            layout, held, loads=loads, effects=blades_of(layout, blades), tolerance=TOLERANCE
        )

    state = over_travels(ask, solver, travels)
    missed = [i for i, outcome in enumerate(state.outcome) if outcome is not Outcome.CONVERGED]
    why = ""
    if missed:
        cause = state.outcome[missed[0]].error()
        why = f"{len(missed)} of {points} travels were not reached: {cause}"
    points_found = _points(ask, state, travels)
    reached = np.array([point.travel for point in points_found])
    deflections = tuple(
        Deflection(joint, unit, tuple(values.tolist()))
        for joint, (unit, values) in ask.geometry.joint_deflections(reached).items()
    )
    return SweepResult(scene.case, ask.geometry.motion, points_found, why, deflections)


def _points(ask: Ask, state: Equilibrium, travels: Floats) -> tuple[SweepPoint, ...]:
    layout, axis = state.layout, driven_axis(ask.geometry)
    shift = point_motion(state, MOVING, layout.body(MOVING).point)
    peak = greatest_stress(state)
    worst = np.argmax(peak.total, axis=1)
    effort = state.reactions[:, layout.index(MOVING), axis]
    stiffness, energy, stable = driven_stiffness(state, ask), strain_energy(state), is_stable(state)
    plane = _in_plane(state, axis, stiffness)
    return tuple(
        SweepPoint(
            travel=float(travels[i]),
            effort=float(effort[i]),
            stiffness=float(stiffness[i]),
            stiffness_x=float(plane[i, 0]),
            stiffness_y=float(plane[i, 1]),
            stiffness_phi=float(plane[i, 2]),
            shift_x=float(shift[i, 0]),
            shift_y=float(shift[i, 1]),
            bending=float(peak.bending[i].max()),
            total=float(peak.total[i, worst[i]]),
            blade=layout.blades[worst[i]].name,
            energy=float(energy[i]),
            frequency=_frequency(ask, float(stiffness[i])),
            stable=bool(stable[i]),
            outcome=state.outcome[i].name.lower(),
            estimated_error=float(state.estimated_error[i]),
        )
        for i in range(state.designs)
        if state.outcome[i] is Outcome.CONVERGED
    )


def _in_plane(state: Equilibrium, driven: int, own: Floats) -> Floats:
    """Return the stiffness along x, along y and in rotation, the drive held (designs, 3)."""
    K = body_stiffness(state, MOVING)
    free = [axis for axis in range(3) if axis != driven]
    found = np.full((state.designs, 3), inf)  # between blades that do not stretch
    if np.isfinite(K).all():
        C = np.linalg.inv(K[:, free][:, :, free])
        found[:, free] = 1.0 / np.diagonal(C, axis1=1, axis2=2)
    found[:, driven] = own
    return found


def _frequency(ask: Ask, stiffness: float) -> float | None:
    """Return √(k/m)/2π of the mechanism's own motion with a joint's tangent stiffness [Hz]."""
    if stiffness <= 0.0:
        return None
    try:
        mode = own_mode(ask.mechanism, stiffness, ask.geometry, ask.material.elastic, ask.sizes)
    except MechanismError:
        return None
    return sqrt(float(mode.stiffness) / mode.mass) / (2.0 * pi)
