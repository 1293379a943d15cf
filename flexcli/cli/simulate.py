"""``flexure simulate``: the joint over its stroke, by geometrically exact mechanics."""

from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import (
    Format,
    FormatOption,
    SpecArgument,
    attempt,
    finish,
    spec_path,
    write_file,
)
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "simulate"


def run(
    spec: SpecArgument = None,
    points: Annotated[
        int, typer.Option("--points", min=2, max=10_000, help="Travels over the stroke.")
    ] = 11,
    table: Annotated[
        Path | None, typer.Option("--csv", help="Save every point, with SI units.")
    ] = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Simulate the stroke: effort, stiffness, shift and stress at every travel, and margins."""
    path = spec_path(spec)
    result = attempt(NAME, path, lambda: _simulate(path, points, table))
    finish(NAME, [result], style, many=False)


def _simulate(path: Path, points: int, table: Path | None) -> Result:
    from flexcli.engine.simulate import simulate
    from flexcli.report.sweep_text import sweep_csv
    from flexcli.spec.given import given_sizes
    from flexcli.spec.load import load_design

    design, document = load_design(path)
    sizes = given_sizes(design, document)
    if design.accuracy is not None:
        from flexcli.engine.planning.by_plan import simulate_by_plan

        result = simulate_by_plan(design, sizes, str(path), points)
    else:
        result = simulate(design, sizes, str(path), points)
    if table is not None:
        write_file(table, sweep_csv(result.sweeps))
    return result
