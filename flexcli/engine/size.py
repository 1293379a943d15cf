"""The verb size: choose the free dimensions, then judge the chosen design like any other."""

from collections.abc import Iterable, Mapping
from dataclasses import replace
from time import perf_counter

from flexcli.engine import assess, left_out
from flexcli.engine import values as design_values
from flexcli.engine.check import MODEL, judged_by
from flexcli.engine.sizing.balanced import Balanced, NotBalanced
from flexcli.engine.sizing.grid import GridPoint
from flexcli.engine.sizing.number_program import LimitsOf, number_sizing
from flexcli.engine.sizing.number_route import NumberRoute
from flexcli.engine.sizing.posynomial_route import PosynomialRoute
from flexcli.engine.sizing.route import Route
from flexcli.errors import SolveError
from flexcli.numerics.geometric_program import Outcome, Solution
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import CLOSED_FORM, Answers
from flexcli.parts.sizing import Objective
from flexcli.results import Cost, Design, Note, Result, SizingResult, Status, Value

__all__ = ["size", "size_by"]

LARGE_SENSITIVITY = 3.0
"""Per cent by which 1 % more of a demand must move a dimension to be called ill-conditioned."""


def size(design: DesignSpec, spec: str, answers: Answers = CLOSED_FORM) -> Result:
    """Return the sized design with margins, or the conflict that leaves none.

    It is chosen by the closed forms; ``answers`` is the model that judges what was chosen.

    Raises
    ------
    SolveError
        When the geometry has no closed forms, beside what a sizing may run into.

    """
    if not design.geometry.closed_forms:
        raise SolveError(
            "no-closed-forms",
            f"a {design.geometry.name} has no closed forms to be sized by",
            "give its sizes and judge them with 'flexure check' or 'flexure simulate'",
        )
    if design.geometry.posynomial:
        return _sized(design, spec, PosynomialRoute(design), answers)
    return _sized(design, spec, NumberRoute(design, number_sizing(design)), answers)


def size_by(
    design: DesignSpec,
    spec: str,
    limits_of: LimitsOf | None = None,
    *,
    base: LimitsOf | None = None,
    starts: Iterable[Mapping[str, float]] = (),
    noise: float = 1e-14,
) -> Result:
    """Return the design sized by limits that are numbers, or the conflict that leaves none.

    Parameters
    ----------
    design : DesignSpec
        The design whose free dimensions are chosen.
    spec : str
        Its name in the result.
    limits_of : callable, optional
        Its limits at many sizes, the closed forms if not given; see :func:`number_sizing`, also
        for what follows.
    base : callable, optional
        A cheaper model of the same limits, which is corrected to them.
    starts : iterable of mapping
        Free sizes [m] to start from instead of a search between the bounds.
    noise : float
        Relative error [-] of the limits' numbers that changes from design to design.

    Returns
    -------
    Result
        The sized design, judged by its closed forms.

    """
    sizing = number_sizing(design, limits_of, base=base, starts=starts, noise=noise)
    return _sized(design, spec, NumberRoute(design, sizing), CLOSED_FORM)


def _sized(design: DesignSpec, spec: str, route: Route, answers: Answers) -> Result:
    started = perf_counter()
    given = design.fixed_sizes()
    chosen = _choose(design, route) if given is None else _Choice(given, _nothing_free())
    if chosen is None:
        result = _infeasible(design, spec, route)
    else:
        result = _judged(design, spec, chosen, answers)
    assert result.cost is not None  # both branches measure
    return replace(result, cost=replace(result.cost, seconds=perf_counter() - started))


class _Choice:
    """A chosen blade and how it was found."""

    def __init__(
        self,
        sizes: Sizes,
        sizing: SizingResult,
        ideal: Sizes | None = None,
        notes: tuple[Note, ...] = (),
        iterations: int = 0,
        *,
        failed_grid: bool = False,
    ) -> None:
        self.sizes = sizes
        self.sizing = sizing
        self.ideal = ideal
        self.notes = notes
        self.iterations = iterations
        self.failed_grid = failed_grid


def _nothing_free() -> SizingResult:
    return SizingResult("none: every size is given", "nothing to choose")


def _choose(design: DesignSpec, route: Route) -> _Choice | None:
    """Return the chosen design, or nothing when the requirements conflict."""
    smallest = route.least("least-volume")
    if smallest.outcome is Outcome.INFEASIBLE:
        return None
    if design.size.objective == "balanced":
        return _choose_balanced(design, route, smallest)
    return _choose_optimum(design, route, smallest, design.size.objective)


def _choose_optimum(
    design: DesignSpec, route: Route, smallest: Solution, objective: Objective
) -> _Choice:
    name = objective if isinstance(objective, str) else _spoken(objective.model_dump())
    solution = smallest if name == "least-volume" else route.least(objective)
    route.refuse(objective, solution, smallest)
    remarks = []
    if solution.tie_breakers:
        remarks.append(
            "the optimum is not unique: of all equally good designs this one has the least "
            "volume, then the shortest, narrowest and thinnest blades"
        )
    sizing = SizingResult(
        objective=name,
        certificate=route.certificate(solution),
        active=route.active(solution),
        sensitivities=route.sensitivities(objective, solution),
        remarks=tuple(remarks),
    )
    others = [] if name == "least-volume" else _least_volume(design, route, smallest)
    return _on_grid(
        design, route, sizing, route.complete(solution.x), objective, others,
        iterations=solution.iterations, label="optimum",
    )  # fmt: skip


def _least_volume(design: DesignSpec, route: Route, smallest: Solution) -> list[Design]:
    """Return the design of least volume to compare with, where there is one."""
    if not smallest.converged:
        return []
    return [_design(design, "least volume", route.complete(smallest.x))]


def _spoken(objective: Mapping[str, str | None]) -> str:
    return " ".join(f"{verb} {name}" for verb, name in objective.items() if name)


def _choose_balanced(design: DesignSpec, route: Route, smallest: Solution) -> _Choice:
    found = route.balanced()
    if isinstance(found, NotBalanced):
        chosen = _choose_optimum(design, route, smallest, "least-volume")
        text = f"no balanced design: {found.reason}; sized for least volume instead"
        chosen.notes = (*chosen.notes, Note("no-balanced-design", text))
        return chosen
    ideal = route.complete(found.x)
    least = _least_volume(design, route, smallest)
    remarks = ["there is no least volume to compare with: nothing holds it"]
    if least:
        more = float(design.geometry.volume(ideal)) / least[0].volume - 1.0
        remarks = [f"the balanced design has {more:.1%} more volume than the least volume"]
    if found.others:
        several = "designs exist" if found.others > 1 else "design exists"
        remarks.append(f"{found.others} other balanced {several}; this is the smallest")
    sizing = SizingResult(
        objective="balanced",
        certificate="root of the square system" if found.condition else "least volume on the rest",
        active=found.active,
        sensitivities=found.sensitivities,
        remarks=tuple(remarks),
    )
    chosen = _on_grid(design, route, sizing, ideal, None, least, iterations=0, label="balanced")
    chosen.notes = (*chosen.notes, *_conditioning(found))
    return chosen


def _conditioning(found: Balanced) -> tuple[Note, ...]:
    largest = max((abs(v) for s in found.sensitivities for v in s.on.values()), default=0.0)
    if largest < LARGE_SENSITIVITY:
        return ()
    text = (
        f"the balanced design is ill-conditioned: 1 % more demand moves a size by {largest:.1f} %"
    )
    return (Note("ill-conditioned", text),)


def _on_grid(
    design: DesignSpec,
    route: Route,
    sizing: SizingResult,
    ideal: Sizes,
    objective: Objective | None,
    others: list[Design],
    *,
    iterations: int,
    label: str,
) -> _Choice:
    """Return the choice as it can be made: on the grid where the spec has one.

    Without an objective the point nearest to the ideal blade is taken.
    """
    grids = {name: grid for name, grid in design.size.rounding.items() if name in route.names}
    designs = [_design(design, label, ideal), *others]
    if not grids:
        return _Choice(ideal, replace(sizing, designs=tuple(designs)), iterations=iterations)
    centre = {name: float(getattr(ideal, name)) for name in route.names}
    point = route.on_grid(grids, objective, centre)
    if point.x is None:
        text = "the manufacturing grid has no feasible design"
        if not point.proved:
            text = "no feasible design was found on the manufacturing grid"
        note = Note("no-grid-point", f"{text}: take a finer grid or more stock sizes")
        designed = replace(sizing, designs=tuple(designs))
        return _Choice(ideal, designed, ideal, (note,), iterations, failed_grid=True)
    blade = route.complete(point.x)
    designs.append(_design(design, "on the grid", blade))
    return _Choice(
        blade,
        replace(
            sizing,
            designs=tuple(designs),
            remarks=(*sizing.remarks, _grid_remark(design, blade, ideal, point, objective)),
        ),
        ideal,
        iterations=iterations,
    )


def _grid_remark(
    design: DesignSpec,
    blade: Sizes,
    ideal: Sizes,
    point: GridPoint,
    objective: Objective | None,
) -> str:
    what = "of the least objective" if objective else "nearest to the balanced design"
    price = float(design.geometry.volume(blade)) / float(design.geometry.volume(ideal)) - 1.0
    sure = "proved" if point.proved else "best of those searched"
    return (
        f"grid: the feasible point {what} ({sure}, {point.judged} judged); "
        f"it costs {price:+.1%} volume"
    )


def _design(design: DesignSpec, label: str, blade: Sizes) -> Design:
    sizes = {name: float(x) for name, x in blade._asdict().items()}
    return Design(label, sizes, float(design.geometry.volume(blade)))


def _judged(design: DesignSpec, spec: str, chosen: _Choice, answers: Answers) -> Result:
    blade = chosen.sizes._make(float(x) for x in chosen.sizes)
    rows = left_out.effects(design, blade, answers)
    errors = left_out.errors(rows)
    found = assess.checks(judged_by(design, blade, answers))
    sized = _sized_values(design, chosen)
    values = {
        **sized,
        **design_values.values(design, blade, answers),
        **sized,
    }  # sized ones first, and kept
    passed = all(check.passed for check in found)
    status = Status.PASS if passed else Status.FAIL
    return Result(
        command="size",
        spec=spec,
        status=Status.INFEASIBLE if chosen.failed_grid else status,
        title=design.title,
        values=design_values.with_errors(values, errors),
        checks=() if chosen.failed_grid else found,
        effects=rows,
        warnings=(*chosen.notes, *left_out.warnings(design, blade, rows)),
        cost=Cost(0.0, answers.model, max(errors.values(), default=None), chosen.iterations),
        sizing=chosen.sizing,
    )


def _sized_values(design: DesignSpec, chosen: _Choice) -> dict[str, Value]:
    """Return the chosen dimensions, and what they were before rounding."""
    model = f"sized, {MODEL}"
    found = {
        name: Value(float(getattr(chosen.sizes, name)), "m", design.geometry.label(name), model)
        for name in design.geometry.free
    }
    if chosen.ideal is not None:
        found |= {
            f"{name}_ideal": Value(
                float(getattr(chosen.ideal, name)),
                "m",
                f"{design.geometry.label(name)} before rounding",
                model,
            )
            for name in design.geometry.free
        }
    return found


def _infeasible(design: DesignSpec, spec: str, route: Route) -> Result:
    conflict, sure = route.conflict()
    objective = design.size.objective
    return Result(
        command="size",
        spec=spec,
        status=Status.INFEASIBLE,
        title=design.title,
        cost=Cost(0.0, MODEL, None),
        sizing=SizingResult(
            objective=objective if isinstance(objective, str) else _spoken(objective.model_dump()),
            certificate=sure,
            conflict=conflict,
        ),
    )
