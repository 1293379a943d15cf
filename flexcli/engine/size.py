"""The verb size: choose the free dimensions, then judge the chosen design like any other."""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from time import perf_counter

from flexcli.engine.check import judged
from flexcli.engine.judge import judge
from flexcli.engine.models import NamedModel, model_series
from flexcli.engine.sizing.choice import ON_GRID, Choice, choose, design_of, nothing_free, told
from flexcli.engine.sizing.conflict import explain_conflict
from flexcli.engine.sizing.decided import judged_at
from flexcli.engine.sizing.free_height import best_height, with_height
from flexcli.engine.sizing.optimum import optimum
from flexcli.engine.sizing.problem import SizingProblem
from flexcli.engine.sizing.program import SizingProgram, sizing_program
from flexcli.engine.sizing.runaway import refuse_runaway
from flexcli.engine.sizing.scouting import best_settled
from flexcli.engine.sizing.stock import points_about
from flexcli.engine.sizing.trust_region import AGREED, UNKNOWN, Settled, least_eased
from flexcli.errors import NoSolution
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Correction
from flexcli.results import Cost, Note, Result, Status, Value, Verdict
from flexcli.results.activity import doing
from flexcli.results.sizing import SizingResult
from flexcli.units import DIMENSIONS

__all__ = ["UNSETTLED", "size"]

UNSETTLED = "not proved: the rounds settled on no choice, and a better one may exist"
"""How sure a choice is that the models that judge still move."""

AT_THE_EDGE = (
    "not proved: near it some numbers have no known error, and better designs may lie there"
)
"""Certificate of a choice next to designs where the models that judge have no error."""

ROUNDED = 1e-3
"""Difference of a check by the models that judge and by the corrected formulas at which they agree
enough where the sizes are rounded, and judged anew."""

REGION = 0.1
"""Half-width, in logarithms, of the region about the place where the rounds ended in which the
corrected formulas choose."""

SLOPES = (
    "slopes of the checks are differences over ±0.1 % of each size, at strokes of what the "
    "solution becomes by its implicit derivative: within 1e-6 where small motion judges, 1e-5 "
    "where exact beams in the plane do, 2e-3 under loads, of which the share that bends is kept, "
    "1e-4 where those in space do"
)
"""How good the slopes are by which what is drawn is chosen."""

GRID_ROUNDS = 6
"""Grid points that the models that judge may refuse before those about the design without a grid
are judged one by one."""


def size(
    design: DesignSpec,
    spec: str,
    model: str | None = None,
    near: Mapping[str, float] | None = None,
    losses: Mapping[str, Correction] | None = None,
) -> Result:
    """Return the sized design with margins, or the conflict that leaves none.

    The sources' formulas choose, corrected in rounds until they say what the models that judge
    say of their choice; then the choice is judged like any other design. What is drawn has no
    formulas: there the checks are known by value and slope alone.

    Parameters
    ----------
    design : DesignSpec
        The design whose free dimensions are chosen.
    spec : str
        Its name in the result.
    model : str, optional
        The model that alone judges, over that of the spec.
    near : mapping, optional
        The free sizes of a design like it [SI], from which that of a drawing is looked for.
    losses : mapping, optional
        What the tolerances take of each check near the choice, by its name.

    Raises
    ------
    SolveError
        When a sizing has no answer.

    """
    started = perf_counter()
    height = best_height(design, _merit) if design.geometry.free else None
    if height is not None:
        design = with_height(design, height)
    series = model_series(design, model)
    problem = SizingProblem(design, losses=losses or {})
    if design.fixed_sizes() is not None or (model or design.model) == "source":
        result = _chosen_and_judged(problem, spec, series, model)
    else:
        result = _decided(problem, spec, series, model, near)
    values = dict(result.values)
    if height is not None:
        values["H"] = Value(
            height,
            "m",
            "height of the levers, chosen with the blades",
            "sized",
            estimated_error=0.0,
        )
    assert result.cost is not None  # every branch measures
    cost = replace(result.cost, seconds=perf_counter() - started)
    return replace(result, values=values, cost=cost)


def _merit(design: DesignSpec) -> float | None:
    """Return what a sizing by the formulas makes least, else nothing where none is feasible."""
    objective = design.sizing.objective
    named = "least-volume" if objective == "balanced" else objective
    solution = optimum(sizing_program(SizingProblem(design)), named)
    return solution.objective if solution.converged else None


def _decided(
    problem: SizingProblem,
    spec: str,
    series: tuple[NamedModel, ...],
    model: str | None,
    near: Mapping[str, float] | None = None,
) -> Result:
    """Return the design sized by formulas that say at the choice what the models that judge do."""
    design, start = problem.design, _first(problem, near)
    if start is None:
        return _chosen_and_judged(problem, spec, series, model)
    is_gridded = set(design.geometry.free) <= design.sizing.rounding.keys()
    agreed = ROUNDED if is_gridded else AGREED
    found = best_settled(problem, start, series, agreed, alone=bool(near))
    if design.sizing.objective == "balanced" and not found.is_kept:
        return _without_balance(problem, found, spec, series, model)
    result = _settled_and_judged(problem, found, spec, series, model)
    if design.sizing.rounding and result.status is not Status.PASS:
        result = _rounded_anew(problem, found, result, spec, series, model)
    sizing = result.sizing
    if not found.unsettled:
        return result
    if sizing is not None:
        sizing = replace(sizing, certificate=_unsure(found), sensitivities=())
    text = f"the sizing did not settle in {found.unsettled[0]}: its choice may not be the optimum"
    if found.unsettled[0] == UNKNOWN:
        text = f"the sizing ended at {UNKNOWN}: its choice may not be the optimum"
    remark = Note("did-not-settle", text)
    return replace(result, sizing=sizing, warnings=(remark, *result.warnings))


def _without_balance(
    problem: SizingProblem,
    found: Settled,
    spec: str,
    series: tuple[NamedModel, ...],
    model: str | None,
) -> Result:
    """Return the least volume, where the models that judge know no balanced design."""
    rest = ", ".join(found.unsettled[:1]) or "what is asked"
    text = (
        f"no balanced design by the models that judge: {rest} cannot be at its limit with the rest"
    )
    options = problem.design.sizing.model_copy(update={"objective": "least-volume"})
    least = problem.design.model_copy(update={"size": options})
    try:
        result = _decided(problem._replace(design=least), spec, series, model)
    except NoSolution as error:
        raise NoSolution(
            error.code, f"{text}; of the least volume, {error.text}", error.remedy
        ) from error
    note = Note("no-balanced-design", f"{text}; sized for least volume instead")
    return replace(result, warnings=(note, *result.warnings))


def _rounded_anew(
    problem: SizingProblem,
    found: Settled,
    result: Result,
    spec: str,
    series: tuple[NamedModel, ...],
    model: str | None,
) -> Result:
    """Return the best point of the grid that passes, where the first that was chosen does not.

    The formulas are corrected at each point that does not and choose again; then the points
    about the design without a grid are judged one by one.
    """
    design, first, spreads = problem.design, result, dict[str, float]()
    refused: set[Sizes] = set()
    for _ in range(GRID_ROUNDS):
        if result.status is Status.INFEASIBLE:
            break
        spreads |= _spreads(result)
        at = design.geometry.sized({n: result.values[n].value for n in design.geometry.free})
        if at in refused:
            break
        refused.add(at)
        found = found.at(design, judged_at(design, at, series, found.place))
        corrected = {
            name: each._replace(spread=spreads.get(name, 0.0))
            for name, each in found.corrections.items()
        }
        found = found._replace(corrections=corrected)
        result = _settled_and_judged(problem, found, spec, series, model)
        if result.status is Status.PASS:
            return result
        if first.status in (Status.INFEASIBLE, Status.FAIL) and result.status is Status.UNDECIDED:
            first = result
    program = sizing_program(problem.corrected(found.corrections))
    for sizes in _beside(design, program, first):
        if sizes not in refused and judge(*design.redrawn(sizes), series).status is Status.PASS:
            sizing = first.sizing
            assert sizing is not None  # a sizing has one
            kept = tuple(each for each in sizing.designs if each.label != ON_GRID)
            before = tuple(each for each in sizing.remarks if not each.startswith("grid:"))
            sizing = replace(
                sizing,
                designs=(*kept, design_of(design, ON_GRID, sizes)),
                remarks=(*before, "grid: a point beside the best one, which passes"),
            )
            ideal = sizes._replace(**{n: first.values[f"{n}_ideal"].value for n in program.names})
            return _judged(design, spec, Choice(sizes, sizing, ideal), series, model)
    return first


def _beside(design: DesignSpec, program: SizingProgram, result: Result) -> Iterator[Sizes]:
    """Yield the points of the grid about the design without one, the best first."""
    grids = design.sizing.rounding
    ideal = {f"{name}_ideal" for name in program.names}
    if set(program.names) != grids.keys() & set(program.names) or not ideal <= result.values.keys():
        return  # a size off the grid, or no design without one
    centre = {name: result.values[f"{name}_ideal"].value for name in program.names}
    objective = design.sizing.objective
    goals = None if objective == "balanced" else program.objectives(objective)
    yield from (
        program.complete(x)
        for x in points_about(program, {n: grids[n] for n in program.names}, goals, centre)
    )


def _spreads(result: Result) -> dict[str, float]:
    """Return the relative errors of the targets that a design's models leave undecided."""
    return {
        check.full_name: check.factor / check.factor_range[0] - 1.0
        for check in result.checks
        if check.is_target and check.verdict is Verdict.UNDECIDED
        if check.factor_range is not None and check.factor_range[0] > 0.0
    }


def _first(problem: SizingProblem, near: Mapping[str, float] | None) -> Sizes | None:
    """Return the sizes that the formulas choose without a grid, or that miss what is asked least.

    Nothing where not even the sizes' own bounds leave any.
    """
    design = problem.design
    if not design.geometry.closed_forms:
        return design.geometry.sized(near) if near else design.geometry.probe()
    doing("the optimum by the formulas")
    free = design.model_copy(update={"size": design.sizing.model_copy(update={"rounding": {}})})
    program = sizing_program(problem._replace(design=free))
    chosen = choose(free, program)
    if chosen is not None:
        refuse_runaway(design, chosen.sizes)
        return _ideal(chosen)
    solution = least_eased(program, program.objectives("least-volume"))
    if not solution.converged:
        return None
    sizes = program.complete(solution.x)
    return sizes._make(float(x) for x in sizes)


def _settled_and_judged(
    problem: SizingProblem,
    found: Settled,
    spec: str,
    series: tuple[NamedModel, ...],
    model: str | None,
) -> Result:
    """Return the choice of the corrected formulas about the place where they hold, judged."""
    design, corrected = problem.design, problem.corrected(found.corrections)
    program = sizing_program(corrected)
    if design.geometry.closed_forms:
        if found.is_kept:
            program = program.about(found.place.sizes, REGION)
        return _chosen_and_judged(corrected, spec, series, model, program)
    if found.unsettled and found.is_kept and not design.sizing.rounding:
        # beside it may be what no model knows the error of
        ended = (design_of(design, "where it ended", found.place.sizes),)
        sizing = SizingResult(told(design.sizing.objective), _unsure(found), designs=ended)
        return _judged(design, spec, Choice(found.place.sizes, sizing), series, model)
    program = program.about(found.place.sizes, REGION)
    return _chosen_and_judged(corrected, spec, series, model, program, found)


def _ideal(chosen: Choice) -> Sizes:
    sizes = chosen.sizes if chosen.ideal is None else chosen.ideal
    return sizes._make(float(x) for x in sizes)


def _chosen_and_judged(
    problem: SizingProblem,
    spec: str,
    series: tuple[NamedModel, ...],
    model: str | None,
    program: SizingProgram | None = None,
    alone: Settled | None = None,
) -> Result:
    """Return the choice of a program, judged.

    ``alone`` is where the rounds ended of a design without formulas.
    """
    design, given = problem.design, problem.design.fixed_sizes()
    if given is not None:
        return _judged(design, spec, Choice(given, nothing_free()), series, model)
    program = program or sizing_program(problem)
    chosen = choose(design, program)
    if chosen is None:
        return _infeasible(design, spec, program, alone)
    refuse_runaway(design, chosen.sizes)
    if alone is not None:
        remarks = (*chosen.sizing.remarks, SLOPES)
        told = replace(chosen.sizing, certificate=_local(alone, series), remarks=remarks)
        chosen = replace(chosen, sizing=told)
    return _judged(design, spec, chosen, series, model)


def _unsure(found: Settled) -> str:
    return AT_THE_EDGE if found.unsettled[0] == UNKNOWN else UNSETTLED


def _local(found: Settled, series: tuple[NamedModel, ...]) -> str:
    """Return how sure a choice is that rounds found without formulas."""
    models = _models(found, series)
    if not models:
        return "local optimum of the drawing alone: no requirement needs a model"
    return (
        f"local optimum by the {' and '.join(models)} model{'s' * (len(models) > 1)}, best of "
        f"{_starts(found)}: not proved to be the best of all"
    )


def _models(found: Settled, series: tuple[NamedModel, ...]) -> list[str]:
    """Return the models that judged a place, the cheapest first."""
    used = {each.model for each in found.place.used.values()}
    return [series[index].name for index in sorted(used)]


def _starts(found: Settled) -> str:
    return f"{found.starts} start{'s' * (found.starts > 1)}"


def _judged(
    design: DesignSpec,
    spec: str,
    chosen: Choice,
    series: tuple[NamedModel, ...],
    model: str | None,
) -> Result:
    sizes = chosen.sizes._make(float(x) for x in chosen.sizes)
    drawn, own = design.redrawn(sizes)
    result = judged("size", drawn, own, spec, judge(drawn, own, series), model)
    assert result.cost is not None  # a judgement has one
    own = _sized_values(design, chosen)
    return replace(
        result,
        status=Status.INFEASIBLE if chosen.failed_grid else result.status,
        values={**own, **result.values, **own},  # sized ones first, and kept
        checks=() if chosen.failed_grid else result.checks,
        warnings=(*chosen.notes, *result.warnings),
        cost=replace(result.cost, iterations=chosen.iterations),
        sizing=chosen.sizing,
    )


def _sized_values(design: DesignSpec, chosen: Choice) -> dict[str, Value]:
    """Return the chosen dimensions, and what they were before rounding."""
    model, geometry = "sized", design.geometry
    units = {name: DIMENSIONS[geometry.dimension(name)].si for name in geometry.free}
    found = {
        name: Value(
            float(getattr(chosen.sizes, name)),
            unit,
            geometry.label(name),
            model,
            estimated_error=0.0,  # what was chosen is what is judged
        )
        for name, unit in units.items()
    }
    if chosen.ideal is not None:
        found |= {
            f"{name}_ideal": Value(
                float(getattr(chosen.ideal, name)),
                unit,
                f"{geometry.label(name)} before rounding",
                model,
            )
            for name, unit in units.items()
        }
    return found


def _infeasible(
    design: DesignSpec, spec: str, program: SizingProgram, alone: Settled | None
) -> Result:
    conflict, sure = explain_conflict(program)
    if alone is not None:
        sure = (
            f"no start found a design, of {_starts(alone)}; that is no proof that there is none: "
            "what conflicts is told by value and slope about the nearest to one"
        )
    if not conflict and alone is not None:
        raise NoSolution(
            "no-start-found",
            f"no start found a design, of {_starts(alone)}; that is no proof that there is none",
            "widen the ranges of what is free, or ask for less",
        )
    if not conflict:
        raise NoSolution(
            "did-not-converge",
            "no local search led to a design, though none of the requirements conflict",
            "bound the free dimensions more closely",
        )
    return Result(
        command="size",
        spec=spec,
        status=Status.INFEASIBLE,
        title=design.title,
        cost=Cost(0.0, "closed-form" if alone is None else "linear, exact", None),
        sizing=SizingResult(
            objective=told(design.sizing.objective),
            certificate=sure,
            conflict=conflict,
        ),
    )
