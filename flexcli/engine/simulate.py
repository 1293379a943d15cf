"""The verb simulate: the joint over its stroke, in exact equilibrium at every travel."""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from time import perf_counter
from typing import Any, NamedTuple

from flexcli.engine import omitted_effects
from flexcli.engine import values as design_values
from flexcli.engine.joint_models.joint_states import layout_of
from flexcli.engine.judge import Interrupted, Judgement, judge, stopped_result
from flexcli.engine.models import model_series
from flexcli.errors import NoSolution, SolveError
from flexcli.mechanics.mesh import Effects
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Ask, JointModel
from flexcli.results import Cost, Note, QuantityKind, Result, Status, Value
from flexcli.results.activity import doing
from flexcli.results.simulation import (
    SpacePoint,
    SpaceSweep,
    SupportSweeps,
    Sweep,
    SweepPoint,
    SweepResult,
)

__all__ = ["simulate", "strokes", "support_over_stroke"]

ALL = Effects()


class Follower(NamedTuple):
    """A model of the joint, and how it follows the stroke of a case at so many travels."""

    joint_model: JointModel
    follow: Callable[[Ask, int], Sweep]


def _in_plane(blades: Effects = ALL) -> Follower:
    from flexcli.engine.joint_models.exact import ExactModel
    from flexcli.engine.stroke_in_plane import stroke_in_plane

    return Follower(ExactModel(blades), partial(stroke_in_plane, blades=blades))


def _in_space(model: str | None = None) -> Follower:
    from flexcli.engine.joint_models.space_exact import SpaceExactModel
    from flexcli.engine.joint_models.space_shell import SpaceShellModel
    from flexcli.engine.stroke_in_space import stroke_in_space

    joint_model = SpaceShellModel() if model == "shell" else SpaceExactModel()
    return Follower(joint_model, partial(stroke_in_space, model=joint_model))


def simulate(
    design: DesignSpec, sizes: Sizes, spec: str, points: int, blades: Effects = ALL
) -> Result:
    """Return the sweep of every case that has a stroke, and the margins by the exact model.

    ``blades`` are the deformations that they have besides bending, in a plane. In space it is the
    shell model where the spec names that.

    Raises
    ------
    SolveError
        When no case has a stroke, the joint is not made of blades and bodies, or it has no
        equilibrium (:class:`NoSolution`).

    """
    started = perf_counter()
    by = _in_space(design.model) if design.geometry.in_space else _in_plane(blades)
    moving = _moving_cases(design, sizes, by)
    models = model_series(design, by.joint_model.name)
    sweeps: list[Sweep] = []
    try:
        sweeps.extend(_swept(moving, points, by))
        values = design_values.values(design, sizes, by.joint_model)
        found = judge(design, sizes, models)
    except NotAvailable as error:
        raise _no_sweep(moving[0], error) from error
    except KeyboardInterrupt as stopped:
        if not sweeps:
            raise
        so_far = stopped.so_far if isinstance(stopped, Interrupted) else Judgement((), {}, models)
        result = stopped_result("simulate", design, spec, so_far, perf_counter() - started)
        return replace(result, **_by_kind(sweeps))
    reached = not any(sweep.missed for sweep in sweeps)
    effects = omitted_effects.effects(design, sizes, models[0].joint_model)
    told = {**values, **_at_ends(design, sweeps, by.joint_model.name)}
    errors = [_error(point) for sweep in sweeps for point in sweep.points]
    known = [error for error in errors if error is not None]
    return Result(
        command="simulate",
        spec=spec,
        status=found.status if reached or found.status is not Status.PASS else Status.FAIL,
        title=design.title,
        values=design_values.with_errors(
            told, omitted_effects.errors_of(design, sizes, models[0].joint_model, told)
        ),
        checks=found.checks,
        effects=effects,
        warnings=(*omitted_effects.warnings(design, sizes, effects), *_kept_upright(moving)),
        cost=Cost(
            perf_counter() - started,
            by.joint_model.name,
            max(known, default=None) if len(known) == len(errors) else None,
            by_model=found.by_model,
        ),
        **_by_kind(sweeps),
    )


def _kept_upright(moving: Sequence[Ask]) -> Iterator[Note]:
    """Yield the cases whose sweep holds a body in its plane that tilts out of it."""
    tilting = [ask.scene.case for ask in moving if ask.scene.tilts and not ask.geometry.in_space]
    if tilting:
        text = (
            "the blades pull at different heights, and nothing but they holds the body upright: "
            f"the sweep of {', '.join(tilting)} is that of one that something holds, its "
            "requirements are judged by a body that tilts. geometry.tilt: held says that it is"
        )
        yield Note("held-upright", text)


def strokes(design: DesignSpec, sizes: Sizes, points: int) -> tuple[Sweep, ...]:
    """Return the sweep of every case that has a stroke, without a verdict.

    Raises
    ------
    SolveError
        As :func:`simulate`.

    """
    by = _in_space() if design.geometry.in_space else _in_plane()
    return _followed(design, sizes, points, by)


def support_over_stroke(design: DesignSpec, sizes: Sizes, points: int) -> SupportSweeps:
    """Return what holds the joint over the stroke of every case, in space where it can be followed.

    A joint of the plane can where it is made of blades of constant thickness whose shear modulus
    is known; else it has the sweep in its plane.

    Raises
    ------
    SolveError
        When no case has a stroke, or the joint has no sweep in its plane either.

    """
    followed = _followed(design, sizes, points, _in_space())
    left = {sweep.case for sweep in followed if len(sweep.points) < 2}
    swept = strokes(design, sizes, points) if left and not design.geometry.in_space else ()
    kept = [sweep for sweep in followed if sweep.case not in left]
    return SupportSweeps(
        tuple(sweep for sweep in kept if isinstance(sweep, SpaceSweep)),
        tuple(s for s in swept if isinstance(s, SweepResult) and s.case in left),
        tuple(f"{sweep.case}: {sweep.missed}" for sweep in followed if sweep.missed),
    )


def _followed(design: DesignSpec, sizes: Sizes, points: int, by: Follower) -> tuple[Sweep, ...]:
    """Return the sweep of every case that has a stroke."""
    moving = _moving_cases(design, sizes, by)
    try:
        return tuple(_swept(moving, points, by))
    except NotAvailable as error:
        raise _no_sweep(moving[0], error) from error


def _swept(moving: Sequence[Ask], points: int, by: Follower) -> Iterator[Sweep]:
    """Yield the sweep of each case, and say which is under way."""
    for ask in moving:
        doing(f"the stroke of {ask.scene.case}")
        yield by.follow(ask, points)


def _moving_cases(design: DesignSpec, sizes: Sizes, by: Follower) -> list[Ask]:
    """Return what is asked in the cases that have a stroke; raise SolveError where none has."""
    moving = [ask for ask in design.asks(sizes, by.joint_model) if ask.scene.moves]
    if not moving:
        turns = design.geometry.motion == "rotation"
        stroke = "rotation: 5 deg" if turns else "translation: 1 mm"
        remedy = f"add stroke: to a case, e.g. {{{stroke}}}"
        raise SolveError("no-stroke", "no case moves the joint", remedy)
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


def _by_kind(sweeps: Sequence[Sweep]) -> dict[str, Any]:
    """Return sweeps as fields of a result: all are in a plane, or all in space."""
    in_space = any(isinstance(sweep, SpaceSweep) for sweep in sweeps)
    return {"space_sweeps" if in_space else "sweeps": tuple(sweeps)}


def _error(point: SweepPoint | SpacePoint) -> float | None:
    """Return the error of what is told of a travel, where it is known."""
    return point.estimated_error if isinstance(point, SweepPoint) else point.error


def _at_ends(design: DesignSpec, sweeps: Sequence[Sweep], model: str) -> dict[str, Value]:
    """Return how the stiffness changes over the stroke, case by case."""
    found = {}
    unit = design.geometry.stiffness_unit
    for sweep in sweeps:
        stiffness = [point.stiffness for point in sweep.points]
        if stiffness:
            suffix = "" if len(sweeps) == 1 else f"_{sweep.case}"
            for name, value in (("k_least", min(stiffness)), ("k_most", max(stiffness))):
                label = f"{name[2:]} stiffness over the stroke"
                found[name + suffix] = Value(value, unit, label, model, kind=QuantityKind.STIFFNESS)
    return found
