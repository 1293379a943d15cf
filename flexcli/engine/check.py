"""The verb check: judge the sizes that the spec gives."""

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import replace
from time import perf_counter

from flexcli.engine import omitted_effects
from flexcli.engine import values as design_values
from flexcli.engine.beyond_elastic import beyond_elastic
from flexcli.engine.judge import Interrupted, Judgement, judge, stopped_result
from flexcli.engine.models import NamedModel, model_series, series_of
from flexcli.errors import NoSolution, SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import FREE
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import JointModel
from flexcli.parts.requirements.base import HELD_ACROSS
from flexcli.results import Check, Cost, Note, QuantityKind, Result, Value, Verdict, with_seconds

__all__ = ["check", "judged", "told_values", "verdicts"]

REACH = 4.0
"""Times h/l that clamps which give way change a number along the motion at most: 2.6, and room."""

REACH_OFF = 60.0
"""The same of a compliance off the motion, which grows with the bodies."""

LOADS = 0.01
"""Share of a stiffness from which it is told that the loads of a case change it."""

SEEN = 0.01
"""Share of a shift from which it is told that a tilt moves the centre besides."""

OFF = (QuantityKind.SUPPORT, QuantityKind.SAG, QuantityKind.RESPONSE)


def check(design: DesignSpec, sizes: Sizes, spec: str, model: str | None = None) -> Result:
    """Return the checks of given sizes, each by the cheapest model that decides it.

    Parameters
    ----------
    design : DesignSpec
        The design.
    sizes : named tuple
        Its sizes [m].
    spec : str
        Its name in the result.
    model : str, optional
        The model that alone judges, over that of the spec.

    Returns
    -------
    Result
        Checks with their verdicts, values, effects and warnings.

    """
    started = perf_counter()
    found: Judgement | None = None
    try:
        found = _judgement(design, sizes, model)
        result = judged("check", design, sizes, spec, found, model)
    except KeyboardInterrupt as stopped:
        so_far = stopped.so_far if isinstance(stopped, Interrupted) else found
        if so_far is None:
            raise
        return stopped_result("check", design, spec, so_far, perf_counter() - started)
    assert result.cost is not None  # a judgement has one
    return replace(result, cost=replace(result.cost, seconds=perf_counter() - started))


def verdicts(design: DesignSpec, sizes: Sizes, spec: str, model: str | None = None) -> Result:
    """Return the checks of :func:`check` alone: no values, effects or warnings."""
    started = perf_counter()
    found = _judgement(design, sizes, model)
    cost = Cost(perf_counter() - started, found.deciding, None, by_model=found.by_model)
    return Result("check", spec, found.status, title=design.title, checks=found.checks, cost=cost)


def _judgement(design: DesignSpec, sizes: Sizes, model: str | None) -> Judgement:
    """Return every check of a design, between its stops where it has some."""
    if not _has_something_to_judge(design):
        raise SolveError(
            "nothing-to-judge",
            "the requirements are empty: there is nothing to judge",
            "ask for something, e.g. requirements: {yield: 1.5}",
        )
    found = judge(design, sizes, model_series(design, model))
    if design.stops is None:
        return found
    from flexcli.engine.stopping.between import between_stops

    return between_stops(found, design, sizes, model)


def judged(
    command: str,
    design: DesignSpec,
    sizes: Sizes,
    spec: str,
    found: Judgement,
    model: str | None = None,
) -> Result:
    """Return a judgement with the values of a design by the cheapest model, and its warnings."""
    name = model or design.model or _cheapest(design, found)
    joint_model, started = _judging(design, found, name), perf_counter()
    values, notes = _values_of_any(design, sizes, joint_model)
    by_model = with_seconds(found.by_model, name, perf_counter() - started)
    rows = omitted_effects.effects(design, sizes, joint_model)
    errors = [v.estimated_error for v in values.values() if v.estimated_error is not None]
    result = Result(
        command=command,
        spec=spec,
        status=found.status,
        title=design.title,
        values=values,
        checks=found.checks,
        effects=rows,
        warnings=(
            *omitted_effects.warnings(design, sizes, rows),
            *beyond_elastic(design, sizes, joint_model, found.checks),
            *notes,
            *_open(design, sizes, found),
            *_rigid_clamps(design, sizes, found),
            *_shaken(design, sizes, joint_model, found),
            *_without_loads(design, sizes, found),
            *_of_upright(design, sizes, found),
            *_held_in_plane(design, sizes, joint_model),
        ),
        cost=Cost(0.0, found.deciding, max(errors, default=None), by_model=by_model),
    )
    if design.accuracy is None or joint_model.name == "source":
        return result
    from flexcli.engine.planning.by_plan import with_planned_values

    return with_planned_values(result, design, sizes, model or design.model)


def _shaken(
    design: DesignSpec, sizes: Sizes, joint_model: JointModel, found: Judgement
) -> Iterator[Note]:
    """Yield what to know of the cases of which the response was judged."""
    judged = {c.case for c in found.checks if c.kind is QuantityKind.RESPONSE}
    cases = [case for case in design.cases if case in judged]
    for case in cases:
        from flexcli.engine.vibration_notes import vibration_notes

        with suppress(SolveError):  # said where the response is judged
            yield from vibration_notes(design.ask(design.scene(case), sizes, joint_model))


def _without_loads(design: DesignSpec, sizes: Sizes, found: Judgement) -> Iterator[Note]:
    """Yield the cases whose loads change the stiffness that is judged without them."""
    of_rest = (QuantityKind.STIFFNESS, QuantityKind.FREQUENCY)
    geometry, scenes = design.geometry, [design.scene(case) for case in design.cases]
    loaded = [s for s in scenes if (s.is_loaded or s.across_by) and not s.on_bodies]
    asked = any(check.kind in of_rest and not check.case for check in found.checks)
    if not asked or not loaded or geometry.is_guided:
        return
    from flexcli.parts.space_joint import joint_in_space
    from flexcli.parts.space_states import stiffened_by

    for scene in loaded:
        with suppress(NotAvailable, SolveError):
            joint = joint_in_space(geometry, design.material, sizes, None)
            stated, either = stiffened_by(joint, scene)
            if joint.is_uniform and abs(stated) + either > LOADS:
                share = f"{stated:+.0%}" if abs(stated) > either else f"±{abs(stated) + either:.0%}"
                text = (
                    f"the loads of case '{scene.case}' change the stiffness of the joint by some "
                    f"{share}; stiffness and frequency are judged without them"
                )
                yield Note("without-loads", text)


def _held_in_plane(design: DesignSpec, sizes: Sizes, joint_model: JointModel) -> Iterator[Note]:
    """Yield the cases whose ends or lock are taken to hold a body that may else leave its plane."""
    mechanism = design.mechanism
    if mechanism is not None and mechanism.joints > 1:
        return
    for scene in map(design.scene, design.cases):
        held = scene.lock is not None or scene.ends not in (None, FREE)
        if not held or not scene.is_loaded or scene.in_space or scene.on_bodies:
            continue
        from flexcli.engine.lateral_factor import lateral_factor

        free = scene._replace(ends=FREE, ends_why="", lock=None)
        bound = lateral_factor(design.ask(free, sizes, joint_model), as_stated=False)
        if bound < 1.0:
            by = f"ends: {scene.ends}" if scene.lock is None else f"lock: {scene.lock}"
            text = (
                f"{by} of case '{scene.case}' is taken to hold the body in its plane as well; by "
                f"its blades alone it may leave it from {bound:.3g} of its loads on"
            )
            yield Note("held-in-plane", text)


def _of_upright(design: DesignSpec, sizes: Sizes, found: Judgement) -> Iterator[Note]:
    """Yield how far a tilt moves the centre in cases whose shift is that of a body held upright."""
    for check in found.checks:
        scene = design.scene(check.case) if check.kind is QuantityKind.SHIFT else None
        if scene is None or not (scene.tilts and scene.moves):
            continue
        from flexcli.parts.tilted_joint import moved_by_tilt

        with suppress(NotAvailable):
            across = moved_by_tilt(design.geometry, design.material, sizes)
            moved = across * max(map(abs, scene.stroke_ends))
            if moved > SEEN * check.demand:
                text = (
                    f"the blades pass side by side: in case '{scene.case}' the centre moves by "
                    f"{moved:.3g} m more, across the bisector, where nothing but they holds the "
                    "body upright; its shift is judged as if something did. "
                    "geometry.tilt: held says that"
                )
                yield Note("held-upright", text)


def told_values(design: DesignSpec, sizes: Sizes, joint_model: JointModel) -> dict[str, Value]:
    """Return the values of a design by a model, each with its estimated error."""
    try:
        found = design_values.values(design, sizes, joint_model)
    except NotAvailable as error:
        text = f"a {design.geometry.name} {error}"
        remedy = "hold or support every body, or lessen the loads of the cases"
        raise NoSolution(f"{joint_model.name}-has-no-answer", text, remedy) from error
    errors = omitted_effects.errors_of(design, sizes, joint_model, found, at_rest=True)
    told = design_values.with_errors(found, errors)
    if not design.omitted:
        return told
    return design_values.with_whole(told, told_values(design.whole, sizes, joint_model))


def _values_of_any(
    design: DesignSpec, sizes: Sizes, joint_model: JointModel
) -> tuple[dict[str, Value], tuple[Note, ...]]:
    """Return the values by a model, or by the cheapest that has an answer, which a note says."""
    try:
        return told_values(design, sizes, joint_model), ()
    except SolveError as error:
        reason = error
    for name in series_of(design):
        try:
            found = told_values(design, sizes, NamedModel(design, name).joint_model)
        except SolveError:
            continue
        text = (
            f"the {joint_model.name} model has none of the values ({reason.text}); these are {name}"
        )
        return found, (Note("values-by-another-model", text),)
    raise reason


def _judging(design: DesignSpec, found: Judgement, model: str) -> JointModel:
    """Return a model, the one that judged where it did, as it knows what it has solved."""
    judged = (named for named in found.models if named.name == model)
    return next(judged, NamedModel(design, model)).joint_model


def _cheapest(design: DesignSpec, found: Judgement) -> str:
    """Return the closed form, else the linear model, or the exact one where linear did not do."""
    first = series_of(design)[0]
    if first == "closed-form":
        return first
    later = {named.name for named in found.models[1:]}
    return "exact" if any(check.model in later for check in found.checks) else first


def _has_something_to_judge(design: DesignSpec) -> bool:
    coupled = any(True for _ in design.coupling_limits())
    stated = coupled or design.stops is not None or design.manufacturing is not None
    return stated or any(True for _ in design.requirements.each())


def _open(design: DesignSpec, sizes: Sizes, found: Judgement) -> Iterator[Note]:
    """Yield what would decide a check that is not decided."""
    undecided = [c for c in found.checks if c.verdict is Verdict.UNDECIDED]
    moving = _names(check for check in undecided if check.depends_on_mass)
    if moving and _has_limbs(design, sizes):
        stated = "limb" in type(design.geometry).model_fields
        remedy = "geometry.limb" if stated else "a layout whose bodies have masses"
        text = (
            f"the limbs between the hinges have no stated mass, which {moving} may turn "
            f"on; {remedy} would decide"
        )
        yield Note("limbs-without-mass", text)
    if undecided and design.material.poisson_ratio is None:
        text = (
            "material.poisson_ratio is not given and was taken as anything from 0 to ½; "
            f"giving it may decide {_names(undecided)}"
        )
        yield Note("needs-poisson-ratio", text)
    if undecided and design.geometry.unstated:
        keys = ", ".join(f"geometry.{key}" for key in design.geometry.unstated)
        text = (
            f"{keys} is not given, without which the linear and the exact model are less sure or "
            f"have no answer; giving it may decide {_names(undecided)}"
        )
        yield Note(f"needs-{design.geometry.unstated[0]}", text)
    held = _names(check for check in undecided if HELD_ACROSS in check.name)
    if held and design.geometry.with_compliant_clamps() is not None:
        text = (
            "geometry.clamps is not given: rigid ones stress blades that they keep from growing "
            f"across more than compliant ones; saying rigid or monolithic may decide {held}"
        )
        yield Note("needs-clamps", text)
    warm = _names(_known_at_assembly_alone(design, sizes, undecided))
    if warm:
        text = (
            "the material is known at assembly alone, or in part; material.over_temperature may "
            f"decide {warm}"
        )
        yield Note("needs-over-temperature", text)
    tilting = _tilting(design, undecided)
    if tilting:
        text = (
            "the body's inertia about x and y is not stated and was taken as that of any radius of "
            "gyration up to a blade's length or its own about z; mechanism.inertia: {xx: …, "
            f"yy: …, zz: …}} may decide {tilting}"
        )
        yield Note("needs-inertia", text)
    if moving and design.material.density is None:
        text = (
            "material.density is not given and the blades' mass was taken as anything up to that "
            f"of the densest metal; giving it may decide {moving}"
        )
        yield Note("needs-density", text)


def _names(checks: Iterable[Check]) -> str:
    """Return the names of checks, in words."""
    return ", ".join(dict.fromkeys(check.name for check in checks))


def _known_at_assembly_alone(
    design: DesignSpec, sizes: Sizes, undecided: Sequence[Check]
) -> Iterator[Check]:
    """Yield the checks of cases so warm or cold that the material is not known well there."""
    known: dict[str, bool] = {}
    for check in undecided:
        if check.case and check.case not in known:
            scene = design.scene(check.case)
            known[check.case] = not omitted_effects.of_assembly(design, sizes, scene)
        if not known.get(check.case, True):
            yield check


def _tilting(design: DesignSpec, undecided: Sequence[Check]) -> str:
    """Return the checks that the unstated inertia of a carried body may leave open, in words."""
    kinds = (QuantityKind.RESPONSE, QuantityKind.FREQUENCY)
    of = [check for check in undecided if check.kind in kinds]
    mechanism, geometry = design.mechanism, design.geometry
    if not of or mechanism is None or mechanism.joints > 1 or geometry.in_space:
        return ""
    from flexcli.parts.space_vibration import stated_tilt

    if geometry.has_masses or stated_tilt(mechanism, geometry) is not None:
        return ""
    rocks = any(scene.tilts for scene in design.scenes()) and geometry.may_tilt(loaded=False)
    out = [
        check.name
        for check in of
        if (design.scene(check.case).vibrates_in_space if check.case else rocks)
    ]
    return ", ".join(dict.fromkeys(out))


def _rigid_clamps(design: DesignSpec, sizes: Sizes, found: Judgement) -> Iterator[Note]:
    """Yield which passes rest on clamps that nobody said are rigid."""
    softer, slender = design.geometry.with_compliant_clamps(), design.geometry.slenderness(sizes)
    if softer is None or slender is None or design.stops is not None:
        return
    near = [check for check in found.checks if _is_near(check, slender)]
    if near:
        from flexcli.engine.rigid_clamps import rests_on_rigid_clamps

        yield from rests_on_rigid_clamps(design, sizes, near, softer, found.models)


def _is_near(check: Check, slender: float) -> bool:
    """Return whether a pass may turn by what clamps give way."""
    if check.verdict is not Verdict.PASS or check.kind is None or check.factor_range is None:
        return False
    if check.kind in (QuantityKind.STRESS, QuantityKind.SHIFT):
        return False
    reach = (REACH_OFF if check.kind in OFF else REACH) * slender
    return check.factor_range[0] < check.required * (1.0 + reach)


def _has_limbs(design: DesignSpec, sizes: Sizes) -> bool:
    try:
        return design.geometry.has_limbs(design.material.elastic, sizes)
    except NotAvailable:  # not made of blades in a plane
        return False
