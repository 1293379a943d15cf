"""Results as text for a terminal: the verdict, the deciding check, then the details."""

from collections.abc import Iterator, Mapping, Sequence
from importlib import import_module
from math import isnan

from flexcli.errors import Finding
from flexcli.report.charset import plain
from flexcli.report.formats import Page, Report
from flexcli.report.margins_text import (
    against,
    decisive,
    margins,
    sentence,
    source_lines,
    sources,
)
from flexcli.report.numbers import apart, error_text, largest, shown
from flexcli.report.tables import Line, Piece, Rows, on_page, table
from flexcli.results import Cost, Result, Status, Value

__all__ = ["SECTIONS", "findings_text", "render"]

SECTIONS = {
    "sizing": "sizing_text",
    "accuracy": "accuracy_text",
    "verification": "verify_text",
    "balance": "balance_text",
    "stops": "stops_text",
    "profiles": "asd_text",
    "breakpoints": "asd_text",
    "worst_cases": "asd_text",
    "responses": "response_text",
    "spectra": "spectra_text",
    "sweeps": "sweep_text",
    "space_sweeps": "sweep_text",
    "plan": "plan_text",
    "audit": "plan_text",
    "study": "study_table",
    "tolerances": "tolerances_text",
    "front": "trade_off_text",
    "choices": "trade_off_text",
}
"""The module whose ``section(result)`` yields each section of a result, in their order."""

UNKNOWN = "?"
"""Stands for an unknown error beside a value."""

_STYLE = {
    Status.PASS: "bold green",
    Status.UNDECIDED: "bold yellow",
    Status.FAIL: "bold red",
    Status.INFEASIBLE: "bold red",
    Status.ERROR: "bold red",
}


def render(report: Report, page: Page) -> str:
    """Return the results without findings, which go to stderr, and the summary of many."""
    return on_page(_pieces(report, page.width), page)


def _pieces(report: Report, width: int) -> Iterator[Piece]:
    for result in report.results:
        if not result.findings:
            yield from _of_one(result, width)
    if report.is_of_many:
        yield _summary(report.results)
    for spec, why in report.passed_over:
        yield Line(("passed over ", "dim"), f"{spec}: {why}", hang=2)


def _of_one(result: Result, width: int) -> Iterator[Piece]:
    """Yield heading, margins, sections, values, effects, warnings, sources and cost."""
    yield Line((result.status.value.upper(), _STYLE[result.status]),
               f"  {result.command} {result.spec}", hang=6)  # fmt: skip
    if result.title:
        yield Line(result.title, indent=6)
    notes = sources(result.checks)
    worst = decisive(result.checks)
    values = result.values.values()
    scales = {v.unit: largest(o.value for o in values if o.unit == v.unit) for v in values}
    if worst is not None:
        yield Line(sentence(worst, scales), indent=6)
        yield margins(result.checks, notes, width)
        yield from ("", against(result.checks, scales))
    for module in dict.fromkeys(SECTIONS[name] for name in SECTIONS if name in result.sections):
        yield from import_module(f"flexcli.report.{module}").section(result)
    if result.values and result.accuracy is None and len(result.worst_cases) < 2:
        yield from _values(result.values, scales)
    if result.effects and result.command != "plan":
        yield _effects(result)
    if result.warnings:
        yield ""
    for note in result.warnings:
        yield Line(("warning ", "yellow"), f"{note.text} [{note.code}]", hang=2)
    if notes:
        yield from source_lines(notes)
    if result.cost is not None:
        yield ""
        yield Line((_cost(result.cost), "dim"), hang=2)


def _cost(cost: Cost) -> str:
    """Return the models that ran, the time of each, and the error of the values."""
    error = error_text(cost.estimated_error) if cost.estimated_error is not None else ""
    estimate = f"; values may be off by up to {error}" if error else ""
    if len(cost.by_model) > 1:
        each = (f"{name} {seconds * 1e3:.1f} ms" for name, seconds in cost.by_model.items())
        return f"{', '.join(each)}{estimate}; {cost.seconds * 1e3:.1f} ms in all"
    return f"{cost.model} model{estimate}; {cost.seconds * 1e3:.1f} ms"


def _values(values: Mapping[str, Value], scales: Mapping[str, float]) -> Iterator[Piece]:
    """Yield the values, each with the digits that its error leaves; noise is 0."""
    has_errors = any(map(_error, values.values()))
    heads = ("name", "value", *(["±"] if has_errors else []), "meaning")
    rows = table("Values", *heads, numbers=(1, 2) if has_errors else (1,))
    for name, value in values.items():
        number = shown(value.value, value.unit, scales[value.unit], value.estimated_error)
        errors = [_error(value)] if has_errors else []
        rows.add_row(name, number, *errors, value.label)
    yield rows
    if any(_error(value) == UNKNOWN for value in values.values()):
        yield Line((f"{UNKNOWN}: error unknown", "dim"))


def _error(value: Value) -> str:
    return UNKNOWN if value.estimated_error is None else error_text(value.estimated_error)


def _effects(result: Result) -> Rows:
    rows = table("Effects", "effect", "in the model", "may change results by", "why", numbers=[2])
    for row in result.effects:
        change = error_text(row.estimate) or ("< 0.05 %" if row.estimate else "0 %")
        rows.add_row(row.name, "yes" if row.on else "no", change, row.reason)
    return rows


def _summary(results: Sequence[Result]) -> Rows:
    """Return one line per spec: its worst check, or its mistakes."""
    rows = table("Summary", "", "spec", "worst margin", "of")
    for result in results:
        worst = decisive(result.checks)
        margin = f"{len(result.findings)} findings" if result.findings else ""
        if worst is not None and not isnan(worst.margin):
            margin, _ = apart(_share, worst.margin, 0.0)
        mark = (result.status.value, _STYLE[result.status])
        rows.add_row(mark, result.spec, margin, worst.full_name if worst is not None else "")
    return rows


def _share(margin: float, digits: int) -> str:
    return f"{margin:+z.{digits - 3}%}"


def findings_text(findings: Sequence[Finding], encoding: str = "utf-8") -> str:
    """Return findings as compilers print them: place, fault, the line with a caret, a hint.

    Lines are not wrapped, so that editors can follow them.
    """
    rows = []
    for found in findings:
        path = f" {found.path}:" if found.path else ""
        rows.append(f"{found.where}:{path} {found.text}")
        if found.source_line:
            line = found.source_line.expandtabs(1)
            start = max(0, found.column - 60)
            rows.append("    " + line[start : start + 100])
            rows.append("    " + " " * (found.column - 1 - start) + "^")
        if found.hint:
            rows.append(f"    {found.hint}")
    return "".join(f"{plain(row, encoding)}\n" for row in rows)
