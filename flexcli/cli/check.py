"""``flexure check``: margins of designs."""

from collections.abc import Sequence
from contextlib import closing
from enum import Enum
from functools import partial
from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    STDIN,
    Format,
    FormatOption,
    ModelOption,
    SetOption,
    attempt,
    finish,
    read,
)
from flexcli.errors import Finding
from flexcli.results import PassedOver, Result, Status

__all__ = ["NAME", "run"]

NAME = "check"


class Free(str, Enum):  # noqa: UP042 - typer reads the values of a str enum
    """Treatment of a design whose sizes are free."""

    SIZE = "size"
    SKIP = "skip"


def run(
    specs: Annotated[
        list[Path] | None,
        typer.Argument(
            metavar="[SPEC|FOLDER]...",
            help=f"Name designs, folders of them, or - for stdin; left out, it is {DEFAULT_SPEC}.",
        ),
    ] = None,
    model: ModelOption = None,
    free: Annotated[
        Free, typer.Option("--free", help="Size designs with free sizes first, or skip them.")
    ] = Free.SIZE,
    fail_fast: Annotated[
        bool, typer.Option("--fail-fast", help="Stop at the first design that does not pass.")
    ] = False,
    quiet: Annotated[
        bool, typer.Option("--quiet", "-q", help="Print in text what does not pass, and no more.")
    ] = False,
    jobs: Annotated[
        int | None,
        typer.Option(
            "--jobs", "-j", min=1, help="Processes; left out, one of each core for many designs."
        ),
    ] = None,
    stated: SetOption = None,
    style: FormatOption = Format.TEXT,
) -> None:
    """Judge designs: every requirement of every case.

    Each check has demand, capacity, factor with its range, and margin.
    Of a folder it takes every design below it, and names what it passes over.
    """
    from flexcli.cli.jobs import over, usual_jobs

    named = specs or [Path(DEFAULT_SPEC)]
    taken, passed, empty = _taken(named)
    results: list[Result] = empty
    task = partial(_checked, stated=stated, model=model.value if model else None, free=free)
    # a process of its own has no stdin
    processes = 1 if Path(STDIN) in taken else jobs or usual_jobs(len(taken))
    with closing(over(task, _stopped, taken, processes)) as answers:
        for number, answer in enumerate(answers, start=1):
            if isinstance(answer, PassedOver):
                passed.append(answer)
                continue
            results.append(answer)
            if fail_fast and answer.status is not Status.PASS:
                why = f"not checked: {answer.spec} did not pass"
                passed += [PassedOver(str(path), why) for path in taken[number:]]
                break
    if not results:
        text, hint = "no design was checked", "leave --free skip out, and they are sized first"
        results.append(_error(str(named[0]), text, hint))
    many = len(named) > 1 or len(results) > 1 or any(path.is_dir() for path in named)
    if quiet and style is Format.TEXT:
        results = [result for result in results if result.status is not Status.PASS]
        passed = []
        if not results:
            return
    finish(NAME, results, style, many=many, passed_over=passed)


def _taken(named: Sequence[Path]) -> tuple[list[Path], list[PassedOver], list[Result]]:
    """Return the designs to check, the skipped files, and the folders without any."""
    taken: dict[Path, None] = {}
    passed: dict[PassedOver, None] = {}
    empty = []
    for path in named:
        if not path.is_dir():
            taken[path] = None
            continue
        from flexcli.spec.folder import members

        found = members(path)
        designs = [file for file, why in found if not why]
        taken |= dict.fromkeys(designs)
        passed |= dict.fromkeys(PassedOver(str(file), why) for file, why in found if why)
        if not designs:
            hint = "a design has flexure, material, geometry, cases and requirements"
            empty.append(_error(str(path), "there is no design in this folder", hint))
    return list(taken), list(passed), empty


def _error(spec: str, text: str, hint: str) -> Result:
    return Result(NAME, spec, Status.ERROR, findings=(Finding(spec, text, hint),))


def _checked(
    path: Path, stated: Sequence[str] | None, model: str | None, free: Free
) -> Result | PassedOver:
    from flexcli import api

    passed: list[PassedOver] = []

    def verb() -> Result:
        spec = read(path, stated)
        names = spec.part.geometry.free if free is Free.SKIP and spec.kind == "design" else ()
        if not names:
            return api.check(spec, model=model)
        passed.append(PassedOver(str(path), f"{', '.join(names)} free; --free size sizes it"))
        return Result(NAME, str(path), Status.PASS)

    result = attempt(NAME, path, verb)
    return passed[0] if passed else result


def _stopped(path: Path) -> Result:
    finding = Finding(str(path), "interrupted", "run it again to its end")
    return Result(NAME, str(path), Status.UNDECIDED, findings=(finding,))
