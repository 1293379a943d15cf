"""``flexure sweep``: one verb at many points of a spec, a row for each."""

import sys
from collections.abc import Generator, Mapping, Sequence
from contextlib import closing
from enum import Enum
from functools import partial
from itertools import chain
from pathlib import Path
from time import monotonic, perf_counter
from typing import TYPE_CHECKING, Annotated, Any

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    Format,
    FormatOption,
    ModelOption,
    SchedulerOption,
    SetOption,
    attempt,
    fail,
    finish,
    read,
)
from flexcli.cli.files import ForceOption, write_or_end, write_picture
from flexcli.errors import Finding, SolveError, SpecError
from flexcli.results import Cost, Result, Status
from flexcli.units import number_and_unit

if TYPE_CHECKING:
    from flexcli.api import Loaded
    from flexcli.parts.study import Study
    from flexcli.results.study import StudyResult
    from flexcli.study import Row

__all__ = ["NAME", "run"]

NAME = "sweep"

FORM = "write PATH=FROM:TO:POINTS or PATH=a,b,c"

SAVED = 10.0
"""Seconds after which what is done is saved again."""

SAVING = 20.0
"""Factor on the time of a save that passes before the next, however many rows there are."""

BLOCK = 16
"""Number of designs in a block for a cluster's worker."""

EACH = 64
"""Least number of blocks, so that all workers end together."""


class Each(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """What is done at each point."""

    CHECK = "check"
    VERDICT = "verdict"
    SIZE = "size"
    SIMULATE = "simulate"
    BALANCE = "balance"
    RESPONSE = "response"
    STOPS = "stops"


class Sample(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """How the points are laid."""

    GRID = "grid"
    SOBOL = "sobol"
    LATIN = "latin-hypercube"


def run(
    spec: Annotated[Path, typer.Argument(help="Name a design, or - for stdin.")] = Path(
        DEFAULT_SPEC
    ),
    vary: Annotated[
        list[str] | None,
        typer.Option(
            "--vary",
            metavar="PATH=FROM:TO:POINTS",
            help="Vary a place of the spec: from:to:points (with :log, at equal ratios; from:to "
            "of a sample), or a,b,c.",
        ),
    ] = None,
    each: Annotated[
        Each | None,
        typer.Option(
            "--each",
            help="Do this at each point; left out, check. A verdict has no values; a response is "
            "that of asd response.",
        ),
    ] = None,
    sample: Annotated[
        Sample | None, typer.Option("--sample", help="Lay all combinations, or spread points.")
    ] = None,
    points: Annotated[
        int | None, typer.Option("--points", min=1, help="Take so many points of a sample.")
    ] = None,
    seed: Annotated[
        int | None, typer.Option("--seed", min=0, help="Take the sample of this seed.")
    ] = None,
    shown: Annotated[
        list[str] | None,
        typer.Option("--value", help="Show this value in the table too, e.g. k_pivot."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Save every value and check as .csv or .parquet."),
    ] = None,
    picture: Annotated[
        Path | None,
        typer.Option(
            "--plot", help="Draw margins, or the first --value, over what varies, as SVG or PNG."
        ),
    ] = None,
    resume: Annotated[
        bool, typer.Option("--resume", help="Keep the rows of the .csv that are done already.")
    ] = False,
    jobs: Annotated[
        int | None,
        typer.Option("--jobs", "-j", min=1, help="Processes; left out, one of each core."),
    ] = None,
    scheduler: SchedulerOption = "",
    force: ForceOption = False,
    model: ModelOption = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Sweep a design over values of its spec.

    Each combination is a row; one that has no answer says why. Ctrl-C and the time limit keep what
    is done, and --resume goes on from there. It exits 0 only where every design passes.
    """
    options = {
        "each": each.value if each else None,
        "sample": sample.value if sample else None,
        "points": points,
        "seed": seed,
    }
    started = perf_counter()
    from flexcli.study import JUDGING

    def verb() -> Result:
        loaded = read(spec, stated)
        asked = _study(spec, loaded, vary, options)
        if model is not None and asked.each not in JUDGING:
            text = f"{asked.each} has models of its own"
            raise SpecError([Finding("--model", text, "leave it out, or check each design")])
        found = _Sweep(
            loaded, asked, model.value if model else None, output, force=force,
            resume=resume, jobs=jobs, scheduler=scheduler, shown=tuple(shown or ()),
        ).done()  # fmt: skip
        if picture is not None and found.rows:
            _draw(found, picture, force=force)
        models = dict.fromkeys(row.model for row in found.rows if row.model)
        cost = Cost(perf_counter() - started, ", ".join(models) or "no", None)
        return Result(NAME, str(spec), _status(found), study=found, cost=cost)

    if output is not None and output.suffix not in (".csv", ".parquet"):
        _refuse(spec, f"{output} is neither .csv nor .parquet", "name it .csv", style)
    if picture is not None and picture.suffix not in (".svg", ".png"):
        _refuse(spec, f"{picture} is neither .svg nor .png", "name it .svg", style)
    if picture is not None and picture.exists() and not force:
        _refuse(spec, f"{picture} exists", "--force replaces it", style)
    if resume and (output is None or output.suffix != ".csv"):
        _refuse(spec, "only rows of a .csv can be kept", "add -o FILE.csv", style)
    finish(NAME, [attempt(NAME, spec, verb)], style, many=False)


def _status(found: "StudyResult") -> Status:
    """Return the worst of all designs; undecided where some were not done."""
    there = {row.status for row in found.rows}
    if there == {Status.ERROR.value}:
        return Status.ERROR
    if {Status.FAIL.value, Status.INFEASIBLE.value, Status.ERROR.value} & there:
        return Status.FAIL
    if Status.UNDECIDED.value in there or len(found.rows) < found.points:
        return Status.UNDECIDED
    return Status.PASS


def _draw(found: "StudyResult", path: Path, *, force: bool) -> None:
    from flexcli.report.plots.chart import standalone
    from flexcli.report.plots.study import study_plot

    try:
        plot = study_plot(found)
    except SolveError as error:  # the rows are there all the same
        sys.stderr.write(f"flexure: nothing was written to {path}: {error.text}: {error.remedy}\n")
        return
    write_picture(standalone(plot.svg), path, force=force)
    sys.stderr.write(f"{path}: {plot.caption}\n")


def _refuse(spec: Path, text: str, hint: str, style: Format) -> None:
    fail(NAME, str(spec), SpecError([Finding(NAME, text, hint)]), style)


def _study(
    spec: Path, loaded: "Loaded", vary: Sequence[str] | None, options: Mapping[str, Any]
) -> "Study":
    """Return the study of the spec, with what the command line says of it."""
    from pydantic import ValidationError

    from flexcli.parts.study import Study

    own = loaded.part.study if loaded.kind == "design" else None
    content: dict[str, Any] = own.model_dump(by_alias=True) if own is not None else {"vary": {}}
    if own is not None:
        content["vary"] = {
            name: list(v.values) if v.values else v.model_dump(by_alias=True, exclude={"values"})
            for name, v in own.vary.items()
        }
    content |= {name: value for name, value in options.items() if value is not None}
    for text in vary or ():
        path, equals, values = text.partition("=")
        if not equals:
            hint = "write geometry.h=0.1mm:0.3mm:5 or material=a,b"
            raise SpecError([Finding("--vary", f"'{text}' has no '='", hint)])
        content["vary"][path.strip()] = _variation(values)
    if not content["vary"]:
        hint = "add --vary geometry.h=0.1mm:0.3mm:5, or study: to the spec"
        raise SpecError([Finding(str(spec), "nothing varies", hint)])
    try:
        return Study.model_validate(content)
    except ValidationError as error:
        findings = [
            Finding("--vary", str(one["msg"]), one.get("ctx", {}).get("hint") or FORM)
            for one in error.errors()
        ]
        raise SpecError(findings) from error


def _variation(text: str) -> Any:
    """Return what ``FROM:TO:POINTS``, ``FROM:TO`` or ``a,b,c`` says, as a study has it."""
    parts = text.split(":")
    if len(parts) == 2 and all(number_and_unit(part.strip()) for part in parts):
        return {"from": parts[0].strip(), "to": parts[1].strip()}
    if len(parts) not in (3, 4) or not parts[2].strip().isdigit():
        return [value.strip() for value in text.split(",")]
    spacing = {"spacing": parts[3].strip()} if len(parts) == 4 else {}
    return {"from": parts[0].strip(), "to": parts[1].strip(), "points": int(parts[2]), **spacing}


class _Sweep:
    """A study in progress: finished rows, and where they are saved."""

    def __init__(
        self,
        spec: "Loaded",
        asked: "Study",
        model: str | None,
        output: Path | None,
        *,
        force: bool,
        resume: bool,
        jobs: int | None,
        scheduler: str,
        shown: tuple[str, ...],
    ) -> None:
        from flexcli.api import Portable
        from flexcli.cli import progress
        from flexcli.parts.study import points_of
        from flexcli.study import is_compiled, rows_of

        self.asked, self.output, self.shown = asked, output, shown
        self.points = points_of(asked)
        self.rows: list[Row] = []
        self.made_by = Portable.of(spec), asked.each, model
        fast = is_compiled(asked.each, len(self.points))
        self.task = partial(rows_of, *self.made_by, is_compiled=fast)
        self.jobs, self.scheduler = jobs, scheduler
        self.kept = _kept(output) if resume and output is not None and output.exists() else {}
        self.may_replace = force or resume
        self.now = progress.run.get() or progress.Run()

    def done(self) -> "StudyResult":
        """Judge the points that are not done, save now and then, and return all rows."""
        if self.output is not None:
            self._save()  # what cannot be written is said before hours of work
            self.may_replace = True
        saved, pause = monotonic(), SAVED
        try:
            with closing(self._made()) as made:
                for point in self.points:
                    row = self.kept.get(tuple(point.values())) or next(made, None)
                    if row is None or self.now.stopped:  # what is judged half is not done
                        break
                    self.rows.append(row)
                    if self.output is not None and monotonic() - saved > pause:
                        begun = monotonic()
                        self._save()
                        saved = monotonic()
                        pause = max(SAVED, SAVING * (saved - begun))
        except KeyboardInterrupt:
            pass  # what is done is kept
        finally:
            if self.output is not None:
                self._save()
        return self._collected()

    def _made(self) -> "Generator[Row, None, None]":
        """Yield the new rows in order, as far as they are finished."""
        from flexcli.cli.jobs import over, usual_jobs
        from flexcli.study import block_of, shared

        size = block_of(*self.made_by, self.points)
        if size == 1 and self.scheduler:  # which has many tasks
            size = max(1, min(BLOCK, len(self.points) // EACH))
        blocks = [self.points[start : start + size] for start in range(0, len(self.points), size)]
        # a block that is kept in part is done again, for its designs were judged together
        todo = [block for block in blocks if any(map(self._is_open, block))]
        jobs = self.jobs or usual_jobs(sum(map(len, todo)))
        with closing(over(self.task, _not_done, todo, jobs, self.scheduler)) as answers:
            made = shared(chain.from_iterable(answers))
            yield from (row for row in made if self._is_open(row[0].point))

    def _is_open(self, point: "Mapping[str, str]") -> bool:
        return tuple(point.values()) not in self.kept

    def _collected(self) -> "StudyResult":
        from flexcli.study import collected

        found = collected(self.rows, self.asked.each, len(self.points))
        return found._replace(shown=self.shown, varied=tuple(self.asked.vary))

    def _save(self) -> None:
        from flexcli.report.study_table import parquet_bytes, study_csv

        assert self.output is not None  # the caller's
        found = self._collected()
        is_text = self.output.suffix == ".csv"
        content = study_csv(found) if is_text else parquet_bytes(found)
        write_or_end(self.output, content, force=self.may_replace)


def _not_done(_: "Sequence[Mapping[str, str]]") -> "list[Row]":
    """Return the rows of points that Ctrl-C left undone."""
    return []


def _kept(path: Path) -> "dict[tuple[str, ...], Row]":
    """Return the rows of a study that was saved before, by the values of their points."""
    import csv

    from flexcli.report.study_table import FIXED
    from flexcli.results.study import Column, StudyRow

    with path.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.reader(stream))
    if not rows or FIXED[0] not in rows[0]:
        hint = "name the file that an earlier sweep saved"
        raise SpecError([Finding(str(path), "is no table of a sweep", hint)])
    first = rows[0].index(FIXED[0])
    names, own = rows[0][:first], rows[0][first + len(FIXED) :]
    columns = []
    for name in own:
        plain, bracket, unit = name.removesuffix("]").rpartition(" [")
        columns.append(Column(plain, unit, "") if bracket else Column(name, "", ""))
    found = {}
    for row in rows[1:]:
        status, decided_by, by_model, reason = row[first : first + len(FIXED)]
        texts = zip(columns, row[first + len(FIXED) :], strict=True)
        cells = {column.name: _cell(text) for column, text in texts if text}
        point = dict(zip(names, row[:first], strict=True))
        there = tuple(column for column in columns if column.name in cells)
        done = StudyRow(point, status, decided_by, by_model, reason, cells)
        found[tuple(point.values())] = (done, there)
    return found


def _cell(text: str) -> float | str:
    for kind in (int, float):
        try:
            return kind(text)
        except ValueError:
            continue
    return text
