"""Results as text for a terminal, with rich: margins first, then what explains them."""

from collections.abc import Mapping, Sequence
from math import isnan

from rich.console import Console, Group, RenderableType
from rich.table import Table
from rich.text import Text

from flexcli.errors import Finding
from flexcli.report.accuracy_text import accuracy_tables
from flexcli.report.asd import profile_list, profile_sheet, worst_cases
from flexcli.report.balance_text import balance_tables
from flexcli.report.margins_text import margins
from flexcli.report.plan_text import audit_table, plan_tables
from flexcli.report.response_text import response_tables
from flexcli.report.stops_text import stops_tables
from flexcli.report.sweep_text import sweep_table
from flexcli.report.tables import table as _table
from flexcli.results import Cost, Result, SizingResult, Status, Value, Verdict
from flexcli.units import STANDARD_GRAVITY, show

__all__ = ["findings_text", "print_findings", "print_result", "print_summary"]

_STYLE = {
    Status.PASS: "bold green",
    Status.UNDECIDED: "bold yellow",
    Status.FAIL: "bold red",
    Status.INFEASIBLE: "bold red",
    Status.ERROR: "bold red",
}

MOST_COLUMNS = 4
"""Sizes that a table of designs shows before it leaves the given ones out."""


def print_result(result: Result, console: Console) -> None:
    """Print one result: heading, sizing, values, checks, effects, warnings, cost."""
    console.print(_heading(result))
    if result.checks:
        console.print(margins(result.checks))
    if result.sizing is not None:
        console.print(_sizing(result.sizing, result.values))
    if result.accuracy is not None:
        for part in accuracy_tables(result.accuracy):
            console.print(part)
    elif result.values and len(result.worst_cases) < 2:
        console.print(_values(result))
    if result.balance is not None:
        for part in balance_tables(result.balance):
            console.print(part)
    if result.stops is not None:
        for part in stops_tables(result.stops):
            console.print(part)
    if result.breakpoints:
        console.print(profile_sheet(result.profiles[0], result.breakpoints))
    elif result.profiles:
        console.print(profile_list(result.profiles))
    if result.worst_cases:
        console.print(worst_cases(result.worst_cases))
    for response in result.responses:
        console.print(response_tables(response))
    for sweep in result.sweeps:
        console.print(sweep_table(sweep))
    if result.sizing is not None and result.sizing.sensitivities:
        console.print(_sensitivities(result.sizing))
    if result.plan is not None:
        for part in plan_tables(result.plan, whole=result.command == "plan"):
            console.print(part)
    if result.effects and result.command != "plan":
        console.print(_effects(result))
    if result.audit:
        console.print(audit_table(result.audit))
    for note in result.warnings:
        console.print(Text.assemble(("warning ", "yellow"), f"{note.text} [{note.code}]"))
    if result.cost is not None:
        console.print(Text(_cost(result.cost), "dim"))


def _cost(cost: Cost) -> str:
    """Return which models ran, how long each, and how far off the values may be."""
    error = cost.estimated_error
    estimate = "" if error is None else f"; values may be off by up to {error:.1%}"
    if len(cost.by_model) > 1:
        each = (f"{name} {seconds * 1e3:.1f} ms" for name, seconds in cost.by_model.items())
        return f"{', '.join(each)}{estimate}; {cost.seconds * 1e3:.1f} ms in all"
    return f"{cost.model} model{estimate}; {cost.seconds * 1e3:.1f} ms"


def _heading(result: Result) -> Text:
    style = _STYLE[result.status]
    title = f"  {result.title}" if result.title else ""
    return Text.assemble(
        (result.status.value.upper(), style), f"  {result.command} {result.spec}{title}"
    )


def _values(result: Result) -> Table:
    table = _table("Values", "name", "value", "what", numbers=[1])
    for name, value in result.values.items():
        shown = show(value.value, value.unit)
        if value.unit == "m/s^2":
            shown = f"{value.value / STANDARD_GRAVITY:.4g} g"
        table.add_row(name, shown, value.label)
    return table


def _sizing(sizing: SizingResult, values: Mapping[str, Value]) -> RenderableType:
    parts: list[RenderableType] = [Text(f"objective: {sizing.objective} ({sizing.certificate})")]
    if sizing.designs:
        names = list(sizing.designs[0].sizes)
        if len(names) > MOST_COLUMNS:  # the given ones stand among the values
            names = [n for n in names if n in values and values[n].model != "given"]
        columns = ("design", *names, "volume")
        table = _table("Designs", *columns, numbers=range(1, 2 + len(names)))
        for d in sizing.designs:
            sizes = (show(d.sizes[name], "m", 5) for name in names)
            table.add_row(d.label, *sizes, show(d.volume, "m^3"))
        parts.append(table)
    if sizing.conflict:
        table = _table("Conflict: these cannot all hold", "requirement", "what would do")
        for relaxation in sizing.conflict:
            table.add_row(relaxation.name, relaxation.text)
        parts.append(table)
    if sizing.active:
        parts.append(Text("active: " + "; ".join(sizing.active)))
    parts.extend(Text(remark) for remark in sizing.remarks)
    return Group(*parts)


def _sensitivities(sizing: SizingResult) -> Table:
    names = list(sizing.sensitivities[0].on)
    table = _table(
        "What 1 % more of a demand changes", "constraint", "by", *names,
        numbers=range(2, 2 + len(names)),
    )  # fmt: skip
    for row in sizing.sensitivities:
        table.add_row(row.constraint, row.driver, *(f"{row.on[name]:+z.3g} %" for name in names))
    return table


def _effects(result: Result) -> Table:
    table = _table("Effects", "effect", "in the model", "may change results by", "why", numbers=[2])
    for row in result.effects:
        table.add_row(row.name, "yes" if row.on else "no", f"{row.estimate:.2%}", row.reason)
    return table


def print_summary(results: Sequence[Result], console: Console) -> None:
    """Print one line per spec: its worst check, or what is wrong with it."""
    table = _table("Summary", "", "spec", "worst margin", numbers=[2])
    for result in results:
        mark = Text(result.status.value, _STYLE[result.status])
        told = f"{len(result.findings)} findings" if result.findings else ""
        if result.checks:
            worst = next((c for c in result.checks if c.verdict is Verdict.NOT_JUDGED), None)
            known = [check for check in result.checks if not isnan(check.margin)]
            worst = min(known, key=lambda c: c.margin, default=worst)
            told = f"{worst.margin:+z.1%} {worst.full_name}" if worst is not None else ""
        table.add_row(mark, result.spec, told)
    console.print(table)


def findings_text(findings: Sequence[Finding]) -> str:
    """Return findings as compilers print them: place, what, the line with a caret, a hint."""
    blocks = []
    for found in findings:
        path = f" {found.path}:" if found.path else ""
        rows = [f"{found.where}:{path} {found.text}"]
        if found.source_line:
            line = found.source_line.expandtabs(1)
            start = max(0, found.column - 60)
            rows.append("    " + line[start : start + 100])
            rows.append("    " + " " * (found.column - 1 - start) + "^")
        if found.hint:
            rows.append(f"    {found.hint}")
        blocks.append("\n".join(rows))
    return "\n".join(blocks)


def print_findings(findings: Sequence[Finding], console: Console) -> None:
    """Print findings, wrapped by nothing so that editors can follow them."""
    console.print(Text(findings_text(findings)), soft_wrap=True)
