"""What a sizing chooses: the optimum, or the balanced design, on the grid where there is one."""

from collections.abc import Mapping
from dataclasses import dataclass, replace

from flexcli.engine.sizing.balanced import Balanced, NotBalanced, balanced
from flexcli.engine.sizing.optimum import active_rows, certificate, optimum, refuse, sensitivities
from flexcli.engine.sizing.program import SizingProgram
from flexcli.engine.sizing.stock import StockChoice, from_stock
from flexcli.errors import Outcome
from flexcli.numerics.solution import Solution
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.sizing import Objective
from flexcli.results import Note
from flexcli.results.activity import doing
from flexcli.results.sizing import Design, SizingResult

__all__ = ["ON_GRID", "Choice", "choose", "design_of", "nothing_free", "told"]

ON_GRID = "on the grid"
"""What a design on the grid is called among those that are compared."""

LARGE_SENSITIVITY = 3.0
"""Per cent by which 1 % more of a demand must move a dimension to be called ill-conditioned."""


@dataclass(frozen=True, eq=False)
class Choice:
    """A chosen blade and how it was found."""

    sizes: Sizes
    sizing: SizingResult
    ideal: Sizes | None = None
    notes: tuple[Note, ...] = ()
    iterations: int = 0
    failed_grid: bool = False


def nothing_free() -> SizingResult:
    """Return what is told of a sizing whose sizes are all given."""
    return SizingResult("none: every size is given", "nothing to choose")


def choose(design: DesignSpec, program: SizingProgram) -> Choice | None:
    """Return the chosen design, or nothing when the requirements conflict."""
    smallest = optimum(program, "least-volume")
    if smallest.outcome is Outcome.INFEASIBLE:
        return None
    if design.sizing.objective == "balanced":
        return _choose_balanced(design, program, smallest)
    return _choose_optimum(design, program, smallest, design.sizing.objective)


def _choose_optimum(
    design: DesignSpec, program: SizingProgram, smallest: Solution, objective: Objective
) -> Choice:
    name = told(objective)
    solution = smallest if name == "least-volume" else optimum(program, objective)
    refuse(program, objective, solution, smallest)
    remarks = []
    if solution.tied:
        remarks.append(
            "the optimum is not unique: of all equally good designs this one has the least "
            "volume, then the shortest, narrowest and thinnest blades"
        )
    slopes = sensitivities(program, objective, solution)
    if slopes is None:
        remarks.append(
            "no sensitivities: what holds the optimum does not move it alike when demands grow "
            "and when they fall"
        )
    sizing = SizingResult(
        objective=name,
        certificate=_certificate(program, certificate(program, solution)),
        active=active_rows(program, solution),
        sensitivities=slopes or (),
        remarks=tuple(remarks),
    )
    others = [] if name == "least-volume" else _least_volume(design, program, smallest)
    return _on_grid(
        design, program, sizing, program.complete(solution.x), objective, others,
        iterations=solution.iterations, label="optimum",
    )  # fmt: skip


def _least_volume(design: DesignSpec, program: SizingProgram, smallest: Solution) -> list[Design]:
    """Return the design of least volume to compare with, where there is one."""
    if (
        not smallest.converged or program.problem.is_corrected
    ):  # corrected near the choice, not there
        return []
    return [design_of(design, "least volume", program.complete(smallest.x))]


def told(objective: Objective) -> str:
    """Return an objective in words."""
    return objective if isinstance(objective, str) else _spoken(objective.model_dump())


def _spoken(objective: Mapping[str, str | None]) -> str:
    return " ".join(f"{verb} {name}" for verb, name in objective.items() if name)


def _choose_balanced(design: DesignSpec, program: SizingProgram, smallest: Solution) -> Choice:
    found = balanced(program)
    if isinstance(found, NotBalanced):
        chosen = _choose_optimum(design, program, smallest, "least-volume")
        text = f"no balanced design: {found.reason}; sized for least volume instead"
        return replace(chosen, notes=(*chosen.notes, Note("no-balanced-design", text)))
    ideal = program.complete(found.x)
    least = _least_volume(design, program, smallest)
    remarks = []
    if not smallest.converged:
        remarks = ["there is no least volume to compare with: nothing holds it"]
    if least:
        more = _volume(design, ideal) / least[0].volume - 1.0
        remarks = [f"the balanced design has {more:z.1%} more volume than the least volume"]
    if found.others:
        several = "designs exist" if found.others > 1 else "design exists"
        remarks.append(f"{found.others} other balanced {several}; this is the smallest")
    sizing = SizingResult(
        objective="balanced",
        certificate=_certificate(
            program, "root of the square system" if found.is_square else "least volume on the rest"
        ),
        active=found.active,
        sensitivities=found.sensitivities,
        remarks=tuple(remarks),
    )
    chosen = _on_grid(design, program, sizing, ideal, None, least, iterations=0, label="balanced")
    return replace(chosen, notes=(*chosen.notes, *_conditioning(found)))


def _certificate(program: SizingProgram, found: str) -> str:
    """Return how sure a choice is, and of which model."""
    if not program.problem.is_corrected:
        return found
    return f"{found}, by the formulas corrected in value and slope to the models that judge"


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
    program: SizingProgram,
    sizing: SizingResult,
    ideal: Sizes,
    objective: Objective | None,
    others: list[Design],
    *,
    iterations: int,
    label: str,
) -> Choice:
    """Return the choice as it can be made: on the grid where the spec has one.

    Without an objective the point nearest to the ideal blade is taken.
    """
    grids = {name: grid for name, grid in design.sizing.rounding.items() if name in program.names}
    designs = [design_of(design, label, ideal), *others]
    if not grids:
        return Choice(ideal, replace(sizing, designs=tuple(designs)), iterations=iterations)
    centre = {name: float(getattr(ideal, name)) for name in program.names}
    goals = None if objective is None else program.objectives(objective)
    doing("the best point of the grid")
    point = from_stock(replace(program, around=None), grids, goals, centre)
    if point.x is None:
        text = "the manufacturing grid has no feasible design"
        if not point.proved:
            text = "no feasible design was found on the manufacturing grid"
        note = Note("no-grid-point", f"{text}: take a finer grid or more stock sizes")
        designed = replace(sizing, designs=tuple(designs))
        return Choice(ideal, designed, ideal, (note,), iterations, True)
    blade = program.complete(point.x)
    designs.append(design_of(design, ON_GRID, blade))
    return Choice(
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
    point: StockChoice,
    objective: Objective | None,
) -> str:
    what = "of the least objective" if objective else "nearest to the balanced design"
    price = _volume(design, blade) / _volume(design, ideal) - 1.0
    sure = "proved" if point.proved else "best of those searched"
    return (
        f"grid: the feasible point {what} ({sure}, {point.judged} judged); "
        f"it costs {price:+z.1%} volume"
    )


def design_of(design: DesignSpec, label: str, blade: Sizes) -> Design:
    """Return sizes as one of the designs that are compared, with the volume of what flexes."""
    sizes = {name: float(x) for name, x in blade._asdict().items()}
    return Design(label, sizes, _volume(design, blade))


def _volume(design: DesignSpec, sizes: Sizes) -> float:
    """Return the volume of what flexes [m³]."""
    geometry, drawn = design.geometry.drawn(sizes)
    return float(geometry.volume(drawn))
