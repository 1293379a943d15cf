"""Results as Markdown: the summary of a job, or a comment on a change."""

import re

from flexcli.report.charset import plain
from flexcli.report.formats import Page, Report
from flexcli.report.margins_text import VERDICTS, cells_of, decisive, sentence, worst_first
from flexcli.report.problems import problems
from flexcli.results import Result, Status

__all__ = ["render"]

_MARKS = {Status.PASS: "✅", Status.UNDECIDED: "❔"}
_SPECIAL = re.compile(r"([\\`*_{}\[\]<>#|~&!$@]|:(?=[\w+-]+:))")


def render(report: Report, page: Page) -> str:
    """Return a heading with the verdict for each result, its margins and its problems."""
    rows = [row for result in report.results for row in _told(result)]
    rows += [f"- passed over: {_text(f'{spec}: {why}')}" for spec, why in report.passed_over]
    return "".join(f"{plain(row, page.encoding)}\n" for row in rows)


def _told(result: Result) -> list[str]:
    mark = _MARKS.get(result.status, "❌")
    told = [f"### {mark} {result.status.value.upper()} {result.command} {_text(result.spec)}", ""]
    if result.title:
        told += [_text(result.title), ""]
    worst = decisive(result.checks)
    if worst is not None:
        told += [f"**{_text(sentence(worst))}**", ""]
        told += ["| | check | factor | range | asked | demand | capacity | by | line |",
                 "|:--|:--|--:|--:|--:|--:|--:|:--|--:|"]  # fmt: skip
    for check in worst_first(result.checks):
        line = str(check.place.line) if check.place is not None and check.place.line else ""
        cells = (VERDICTS[check.verdict][0], check.full_name, *cells_of(check), check.model, line)
        told.append(f"| {' | '.join(map(_text, cells))} |")
    if worst is not None:
        told.append("")
    for problem in problems(result):
        if not problem.check:
            place = f"{problem.file}:{problem.line}: " if problem.line else ""
            told.append(f"- {_text(place + problem.text)}")
    told += [f"- warning: {_text(note.text)} ({_text(note.code)})" for note in result.warnings]
    return told if not told[-1] else [*told, ""]


def _text(text: str) -> str:
    """Return a text that Markdown shows as it stands."""
    return _SPECIAL.sub(r"\\\1", " ".join(text.split()))
