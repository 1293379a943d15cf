"""The verb simulate: the joint over its stroke, in exact equilibrium at every travel."""

from collections.abc import Sequence
from dataclasses import replace
from math import inf, pi, sqrt
from time import perf_counter

import numpy as np
from numpy.typing import NDArray

from flexcli.engine import omitted_effects
from flexcli.engine import values as design_values
from flexcli.engine.joint_models.exact import TOLERANCE, ExactModel, driven_stiffness
from flexcli.engine.joint_models.holds import driven_axis
from flexcli.engine.joint_models.joint_states import blades_of, layout_of, over_travels
from flexcli.engine.judge import Interrupted, Judgement, judge, stopped_result
from flexcli.engine.models import model_series
from flexcli.errors import NoSolution, SolveError
from flexcli.mechanics.demand import Held
from flexcli.mechanics.energy import strain_energy
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.stability import is_stable
from flexcli.mechanics.state import Equilibrium, Outcome
from flexcli.mechanics.stresses import greatest_stress
from flexcli.mechanics.tangent import body_stiffness
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.own_motion import own_mode
from flexcli.parts.requirements import Ask, JointModel
from flexcli.results import Cost, QuantityKind, Result, Status, Value
from flexcli.results.activity import doing
from flexcli.results.simulation import Deflection, SweepPoint, SweepResult

__all__ = ["moving_cases", "simulate", "strokes"]

Floats = NDArray[np.float64]

ALL = Effects()

EXACT_MODEL = ExactModel.name


def simulate(
    design: DesignSpec, sizes: Sizes, spec: str, points: int, blades: Effects = ALL
) -> Result:
    """Return the sweep of every case that has a stroke, and the margins by the exact model.

    ``blades`` are the deformations that they have besides bending.

    Raises
    ------
    SolveError
        When no case has a stroke, the joint is not made of blades and bodies, or it has no
        equilibrium (:class:`NoSolution`).

    """
    started = perf_counter()
    joint_model = ExactModel(blades)
    moving = moving_cases(design, sizes, joint_model)
    models = model_series(design, EXACT_MODEL)
    sweeps: tuple[SweepResult, ...] = ()
    try:
        for ask in moving:
            sweeps += (_sweep(ask, points, blades),)
        values = design_values.values(design, sizes, joint_model)
        found = judge(design, sizes, models)
    except NotAvailable as error:
        raise _no_sweep(moving[0], error) from error
    except KeyboardInterrupt as stopped:
        if not sweeps:
            raise
        so_far = stopped.so_far if isinstance(stopped, Interrupted) else Judgement((), {}, models)
        result = stopped_result("simulate", design, spec, so_far, perf_counter() - started)
        return replace(result, sweeps=sweeps)
    reached = not any(sweep.missed for sweep in sweeps)
    effects = omitted_effects.effects(design, sizes, models[0].joint_model)
    told = {**values, **_at_ends(design, sweeps)}
    errors = [p.estimated_error for sweep in sweeps for p in sweep.points]
    return Result(
        command="simulate",
        spec=spec,
        status=found.status if reached or found.status is not Status.PASS else Status.FAIL,
        title=design.title,
        values=design_values.with_errors(
            told, omitted_effects.errors_of(design, sizes, models[0].joint_model, told)
        ),
        checks=found.checks,
        sweeps=sweeps,
        effects=effects,
        warnings=omitted_effects.warnings(design, sizes, effects),
        cost=Cost(
            perf_counter() - started,
            joint_model.name,
            max(errors, default=None),
            by_model=found.by_model,
        ),
    )


def strokes(design: DesignSpec, sizes: Sizes, points: int) -> tuple[SweepResult, ...]:
    """Return the sweep of every case that has a stroke, without a verdict.

    Raises
    ------
    SolveError
        As :func:`simulate`.

    """
    moving = moving_cases(design, sizes, ExactModel())
    try:
        return tuple(_sweep(ask, points, ALL) for ask in moving)
    except NotAvailable as error:
        raise _no_sweep(moving[0], error) from error


def moving_cases(
    design: DesignSpec, sizes: Sizes, joint_model: JointModel, stroke: str = "rotation: 5 deg"
) -> list[Ask]:
    """Return what is asked in the cases that have a stroke; ``stroke`` is an example of one.

    Raises :class:`SolveError` where none has.
    """
    moving = [ask for ask in design.asks(sizes, joint_model) if ask.scene.moves]
    if not moving:
        raise SolveError(
            "no-stroke", "no case moves the joint", f"add stroke: to a case, e.g. {{{stroke}}}"
        )
    return moving


def _no_sweep(ask: Ask, error: NotAvailable) -> SolveError:
    """Return why there is no simulation: of what joint, or of what loads and stroke."""
    text = f"a {ask.geometry.name} {error}"
    try:
        layout_of(ask)
    except NotAvailable:
        remedy = "'flexure check' judges it by its formulas; blades in a plane can be simulated"
        return SolveError("no-layout", text, remedy)
    remedy = "lessen the loads or the stroke of its cases, or state ends: that hold it"
    return NoSolution("no-equilibrium", text, remedy)


def _sweep(ask: Ask, points: int, blades: Effects) -> SweepResult:
    scene = ask.scene
    doing(f"the stroke of {scene.case}")
    travels = np.linspace(scene.middle - scene.travel, scene.middle + scene.travel, points)

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        return solve(
            layout, held, loads=loads, effects=blades_of(layout, blades), tolerance=TOLERANCE
        )

    state = over_travels(ask, solver, travels)
    missed = [i for i, outcome in enumerate(state.outcome) if outcome is not Outcome.CONVERGED]
    why = ""
    if missed:
        cause = str(state.outcome[missed[0]].value)
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


def _at_ends(design: DesignSpec, sweeps: tuple[SweepResult, ...]) -> dict[str, Value]:
    """Return how the stiffness changes over the stroke, case by case."""
    found = {}
    unit = design.geometry.stiffness_unit
    for sweep in sweeps:
        stiffness = [point.stiffness for point in sweep.points]
        if stiffness:
            suffix = "" if len(sweeps) == 1 else f"_{sweep.case}"
            for name, value in (("k_least", min(stiffness)), ("k_most", max(stiffness))):
                label = f"{name[2:]} stiffness over the stroke"
                found[name + suffix] = Value(
                    value, unit, label, "exact", kind=QuantityKind.STIFFNESS
                )
    return found
