"""Shared by the verbs: options, reading of specs, and mistakes turned into findings."""

import sys
from collections.abc import Callable, Sequence
from enum import Enum
from functools import partial, wraps
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, NoReturn

import typer

from flexcli.cli.output import Format, FormatOption, finish, write_json, write_text
from flexcli.errors import Finding, NoSolution, SolveError, SpecError
from flexcli.results import Result, Status

if TYPE_CHECKING:
    from flexcli.api import Loaded

__all__ = [
    "DEFAULT_SPEC",
    "STDIN",
    "Format",
    "FormatOption",
    "Model",
    "ModelOption",
    "OutputOption",
    "SchedulerOption",
    "SetOption",
    "SpecsArgument",
    "attempt",
    "fail",
    "finish",
    "on_each",
    "only_one",
    "overrides_of",
    "read",
    "with_common_options",
    "write_json",
    "write_text",
]

DEFAULT_SPEC = "flexure.yaml"
STDIN = "-"


class Model(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """The model of the joint that judges a design."""

    SOURCE = "source"
    CLOSED_FORM = "closed-form"
    LINEAR = "linear"
    EXACT = "exact"
    SHELL = "shell"
    SOLID = "solid"


def _positive(seconds: float | None) -> float | None:
    if seconds is not None and not 0.0 < seconds <= LONGEST:
        raise typer.BadParameter(f"give seconds above 0, at most {LONGEST:g}")
    return seconds


LONGEST = 1e6

ModelOption = Annotated[
    Model | None,
    typer.Option(
        "--model",
        help="Let this model judge alone; left out, the cheapest that decides a check judges it.",
    ),
]
OutputOption = Annotated[
    Path | None,
    typer.Option("--output", "-o", help="Write this file, which must be new without --force."),
]
SpecsArgument = Annotated[
    list[Path] | None,
    typer.Argument(
        metavar="[SPEC]...",
        help=f"Name design files, or - for stdin; left out, it is {DEFAULT_SPEC} of this folder.",
    ),
]
SchedulerOption = Annotated[
    str,
    typer.Option(
        "--scheduler",
        metavar="ADDRESS",
        help="Spread over the workers of a Dask cluster, e.g. tcp://host:8786.",
    ),
]
SetOption = Annotated[
    list[str] | None,
    typer.Option(
        "--set", metavar="PATH=VALUE", help="Put a value over the spec's, e.g. geometry.h=0.2mm."
    ),
]


AllowOutsideOption = Annotated[
    bool,
    typer.Option(
        "--allow-outside",
        help="Let specs name files outside their folders; don't for those of strangers.",
    ),
]
TimeLimitOption = Annotated[
    float | None,
    typer.Option(
        "--time-limit",
        metavar="SECONDS",
        callback=_positive,
        help="Stop after so long, with what was done kept; exits 1, as Ctrl-C does.",
    ),
]


def with_common_options(verb: Callable[..., None]) -> Callable[..., None]:
    """Return a verb with the options that every verb has: where specs lead, and how long."""
    from inspect import Parameter, signature

    own = signature(verb)
    added = {"allow_outside": (AllowOutsideOption, False), "time_limit": (TimeLimitOption, None)}

    @wraps(verb)
    def bounded_verb(
        *, allow_outside: bool = False, time_limit: float | None = None, **given: Any
    ) -> None:
        from flexcli.cli import progress
        from flexcli.spec.references import from_anywhere

        token = progress.run.set(progress.Run(time_limit))
        try:
            with from_anywhere(allow_outside):
                verb(**given)
        finally:
            progress.run.reset(token)

    parameters = [
        Parameter(name, Parameter.KEYWORD_ONLY, default=default, annotation=option)
        for name, (option, default) in added.items()
    ]
    bounded_verb.__signature__ = own.replace(  # type: ignore[attr-defined]
        parameters=[*own.parameters.values(), *parameters]
    )
    bounded_verb.__annotations__ = {
        **verb.__annotations__,
        **{name: option for name, (option, _) in added.items()},
    }
    return bounded_verb


def on_each(
    command: str,
    specs: Sequence[Path] | None,
    stated: Sequence[str] | None,
    verb: Callable[["Loaded"], Result],
) -> list[Result]:
    """Run a verb on every spec, with what ``--set`` states put over its values."""
    paths = specs or [Path(DEFAULT_SPEC)]
    return [attempt(command, path, partial(_told, path, stated, verb)) for path in paths]


def _told(path: Path, stated: Sequence[str] | None, verb: Callable[["Loaded"], Result]) -> Result:
    return verb(read(path, stated))


def read(path: Path, stated: Sequence[str] | None) -> "Loaded":
    """Read a spec, from stdin where its name is ``-``, with values put over its own."""
    from flexcli import api

    overrides = overrides_of(stated)
    if str(path) != STDIN:
        return api.load(path, overrides=overrides)
    from flexcli.spec.read import MAX_BYTES, text_of

    text = text_of(sys.stdin.buffer.read(MAX_BYTES + 1), _name(path))
    # a line alone would be the path of a spec
    return api.load(text + "\n", overrides=overrides, name=_name(path))


def _name(path: Path) -> str:
    return "<stdin>" if str(path) == STDIN else str(path)


def overrides_of(stated: Sequence[str] | None) -> dict[str, str]:
    """Return what ``--set`` states by its paths, or raise SpecError where it states nothing."""
    findings: list[Finding] = []
    found: dict[str, str] = {}
    for text in stated or ():
        path, equals, value = text.partition("=")
        path = path.strip()
        if not equals:
            findings.append(Finding("--set", f"'{text}' has no '='", "write geometry.h=0.2mm"))
        elif path in found:
            findings.append(Finding("--set", f"{path} is set twice", "keep one of them"))
        found[path] = value
    if findings:
        raise SpecError(findings)
    return found


def only_one(
    command: str, option: str, specs: Sequence[Path] | None, value: Path | None, style: Format
) -> None:
    """End the run where a file is to be written for several specs."""
    if value is not None and len(specs or ()) > 1:
        finding = Finding(option, "takes the result of one spec", "name one spec")
        fail(command, "", SpecError([finding]), style)


def attempt(command: str, spec: Path, verb: Callable[[], Result]) -> Result:
    """Run a verb on a spec; the user's mistakes become the findings of its result.

    A run that was stopped, by Ctrl-C or by its time limit, decides nothing.
    """
    from flexcli.cli import progress

    try:
        with progress.bounded(f"{command} {_name(spec)}"):
            return verb()
    except KeyboardInterrupt:
        run = progress.run.get() or progress.Run()
        found = Finding(_name(spec), run.stopped or "interrupted", run.remedy)
        return Result(command, _name(spec), Status.UNDECIDED, findings=(found,))
    except SpecError as error:
        findings = tuple(error.findings)
    except SolveError as error:
        findings = (Finding(_name(spec), error.text, error.remedy),)
        if isinstance(error, NoSolution):
            return Result(command, _name(spec), Status.UNDECIDED, findings=findings)
    return Result(command=command, spec=_name(spec), status=Status.ERROR, findings=findings)


def fail(command: str, spec: str, error: SpecError, style: Format) -> NoReturn:
    """End a run on the user's mistakes alone."""
    result = Result(command, spec, Status.ERROR, findings=tuple(error.findings))
    finish(command, [result], style, many=False)
