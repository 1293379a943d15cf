"""``flexure tolerances``: what share of the parts passes, and which tolerance decides it."""

from collections.abc import Callable, Generator, Sequence
from typing import TYPE_CHECKING, Annotated, Any

import typer

from flexcli.cli.common import (
    Format,
    FormatOption,
    ModelOption,
    SchedulerOption,
    SetOption,
    SpecsArgument,
    finish,
    on_each,
)
from flexcli.results import Result

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = ["NAME", "run"]

NAME = "tolerances"

A_JOB = 32
"""Designs for which a further process is worth its start."""


def run(
    specs: SpecsArgument = None,
    parts: Annotated[
        int, typer.Option("--parts", min=100, max=10_000_000, help="Draw so many parts.")
    ] = 100_000,
    seed: Annotated[int, typer.Option("--seed", min=0, help="Draw the parts of this seed.")] = 0,
    confidence: Annotated[
        float,
        typer.Option("--confidence", min=0.5, max=0.999999, help="Of the intervals of yields."),
    ] = 0.95,
    jobs: Annotated[
        int | None,
        typer.Option("--jobs", "-j", min=1, help="Processes; left out, one of each core."),
    ] = None,
    scheduler: SchedulerOption = "",
    model: ModelOption = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Tell how many parts pass within the tolerances of the spec.

    There are yields with their intervals, the worst case of each requirement, what each hangs on,
    and what tolerance to narrow first. It passes where the share of robust: does, or, where none
    is stated, the worst case. Ctrl-C keeps what was judged.
    """

    def verb(spec: "Loaded") -> Result:
        from flexcli import api

        return api.tolerances(
            spec, parts=parts, seed=seed, confidence=confidence,
            model=model.value if model else None, over=over_processes(jobs, scheduler),
        )  # fmt: skip

    results = on_each(NAME, specs, stated, verb)
    finish(NAME, results, style, many=len(results) > 1)


def over_processes(
    jobs: int | None,
    scheduler: str,
) -> Callable[[Callable[[Any], Any], Sequence[Any]], Generator[Any, None, None]]:
    """Return what puts a question to many designs in several processes, or workers, in order."""
    from flexcli.cli.jobs import A_JOB as A_TASK
    from flexcli.cli.jobs import over, usual_jobs

    def each(do: Callable[[Any], Any], tasks: Sequence[Any]) -> Generator[Any, None, None]:
        count = jobs or usual_jobs(len(tasks) * A_TASK // A_JOB)
        return over(do, _not_done, tasks, count, scheduler)

    return each


def _not_done(task: Any) -> None:
    """Answer for a design that Ctrl-C left undone."""
