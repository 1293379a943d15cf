"""``flexure report``: the page of a design, or of a folder of them, to read and to send."""

from datetime import UTC, datetime
from pathlib import Path
from typing import Annotated

import typer

from flexcli.cli.common import (
    DEFAULT_SPEC,
    Format,
    ModelOption,
    SetOption,
    attempt,
    fail,
    finish,
    read,
)
from flexcli.cli.files import ForceOption, write_or_end
from flexcli.errors import Finding, SpecError
from flexcli.results import Result

__all__ = ["NAME", "run"]

NAME = "report"

INDEX = "index.html"


def run(
    specs: Annotated[
        list[Path] | None,
        typer.Argument(help=f"Designs or folders of them; {DEFAULT_SPEC} if left out."),
    ] = None,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o",
            help="File to write, of several designs a folder; report.html or report/ if left out.",
        ),
    ] = None,
    force: ForceOption = False,
    model: ModelOption = None,
    stated: SetOption = None,
) -> None:  # fmt: skip
    """Write a page of each design, to read and send.

    It has verdicts, drawing, margins, plots, equations and the spec itself.

    The page stands alone: it needs no network, prints on A4, and follows the reader into the dark.
    """
    named = specs or [Path(DEFAULT_SPEC)]
    paths = [file for path in named for file in _designs(path)]
    many = len(named) > 1 or any(path.is_dir() for path in named)
    place = output or Path("report" if many else "report.html")
    if many and place.suffix:
        finding = Finding(str(place), "is a file, but there are several pages", "name a folder")
        fail(NAME, str(place), SpecError([finding]), Format.TEXT)
    now = datetime.now(tz=UTC).astimezone()
    date = f"{now.day} {now:%B %Y}"
    pages: dict[str, str] = {}
    results, rows = [], []
    for path in paths:
        result, html = _page(path, model.value if model else None, stated, date)
        results.append(result)
        if not many:
            pages[""] = html
            continue
        from flexcli.report.page import folder_row

        name = f"{'-'.join(path.with_suffix('').parts[-2:]).strip('./')}.html"
        rows.append(folder_row(result, name if html else ""))
        pages[name] = html
    if many:
        from flexcli.report.page import folder_page

        title = ", ".join(str(path) for path in named)
        pages[INDEX] = folder_page(title, rows, date)
        place.mkdir(parents=True, exist_ok=True)
    for name, html in pages.items():
        if html:
            write_or_end(place / name if many else place, html, force=force)
    finish(NAME, results, Format.TEXT, many=many)


def _designs(path: Path) -> list[Path]:
    """Return a file itself, or the designs below a folder; a folder without any is told as one."""
    from flexcli.spec.folder import members

    if not path.is_dir():
        return [path]
    return [file for file, why in members(path) if not why] or [path]


def _page(path: Path, model: str | None, stated: list[str] | None, date: str) -> tuple[Result, str]:
    """Return what was found of a design and its page; no page where it cannot be read."""
    html: list[str] = []

    def verb() -> Result:
        from flexcli import api
        from flexcli.report.page import design_page

        found = api.dossier(read(path, stated), model=model)
        html.append(design_page(found, date))
        return found.result

    result = attempt(NAME, path, verb)
    return result, html[0] if html else ""
