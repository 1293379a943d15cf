"""What the verbs share: which files, which model, and what becomes of the user's mistakes."""

import os
import sys
from collections.abc import Callable
from enum import Enum
from functools import wraps
from pathlib import Path
from typing import Annotated, Any, NoReturn

import typer

from flexcli.cli.output import Format, FormatOption, finish, write_json, write_text
from flexcli.errors import Finding, NoSolution, SolveError, SpecError
from flexcli.results import Result, Status

__all__ = [
    "DEFAULT_SPEC",
    "Format",
    "FormatOption",
    "Model",
    "ModelOption",
    "OutputOption",
    "SpecArgument",
    "attempt",
    "fail",
    "finish",
    "spec_path",
    "with_common_options",
    "write_file",
    "write_json",
    "write_new",
    "write_text",
]

DEFAULT_SPEC = "flexure.yaml"


class Model(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """The model of the joint that judges a design."""

    SOURCE = "source"
    CLOSED_FORM = "closed-form"
    LINEAR = "linear"
    EXACT = "exact"


def _positive(seconds: float | None) -> float | None:
    if seconds is not None and not 0.0 < seconds <= LONGEST:
        raise typer.BadParameter(f"give seconds above 0, at most {LONGEST:g}")
    return seconds


LONGEST = 1e6

ModelOption = Annotated[
    Model | None,
    typer.Option(
        "--model",
        help="Model that judges alone; each check by the cheapest that decides it, if left out.",
    ),
]
OutputOption = Annotated[
    Path | None, typer.Option("--output", "-o", help="File to write, which must be a new one.")
]
SpecArgument = Annotated[
    Path | None, typer.Argument(help=f"Design file; {DEFAULT_SPEC} of this folder if left out.")
]


AllowOutsideOption = Annotated[
    bool,
    typer.Option(
        "--allow-outside", help="Let specs name files outside their folders; not of strangers."
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


def spec_path(spec: Path | None) -> Path:
    """Return the spec that is meant."""
    return spec if spec is not None else Path(DEFAULT_SPEC)


def attempt(command: str, spec: Path, verb: Callable[[], Result]) -> Result:
    """Run a verb on a spec; the user's mistakes become the findings of its result.

    A run that was stopped, by Ctrl-C or by its time limit, decides nothing.
    """
    from flexcli.cli import progress

    try:
        with progress.bounded(f"{command} {spec}"):
            return verb()
    except KeyboardInterrupt:
        run = progress.run.get() or progress.Run()
        found = Finding(str(spec), run.stopped or "interrupted", run.remedy)
        return Result(command, str(spec), Status.UNDECIDED, findings=(found,))
    except SpecError as error:
        findings = tuple(error.findings)
    except SolveError as error:
        findings = (Finding(str(spec), error.text, error.remedy),)
        if isinstance(error, NoSolution):
            return Result(command, str(spec), Status.UNDECIDED, findings=findings)
    return Result(command=command, spec=str(spec), status=Status.ERROR, findings=findings)


def fail(command: str, spec: str, error: SpecError, style: Format) -> NoReturn:
    """End a run on the user's mistakes alone."""
    result = Result(command, spec, Status.ERROR, findings=tuple(error.findings))
    finish(command, [result], style, many=False)


def write_file(path: Path, content: str | bytes) -> None:
    """Write a file whole or not at all."""
    partial = path.with_name(f".{path.name}.{os.getpid()}.part")
    try:
        partial.write_bytes(content if isinstance(content, bytes) else content.encode())
        partial.replace(path)
    except OSError as error:
        partial.unlink(missing_ok=True)
        sys.stderr.write(f"flexure: cannot write {path}: {error.strerror}\n")
        raise typer.Exit(2) from error


def write_new(path: Path, text: str) -> None:
    """Write a file that is not there yet."""
    if path.exists():
        sys.stderr.write(f"flexure: {path} exists; name another file, or remove it\n")
        raise typer.Exit(2)
    write_file(path, text)
