"""Reasons why a result does not pass, as a list for machines: code, severity, line."""

from collections.abc import Iterator
from typing import NamedTuple

from flexcli.report.margins_text import sentence, worst_first
from flexcli.results import Result, Status, Verdict

__all__ = ["Problem", "headline", "problems"]


class Problem(NamedTuple):
    """One problem: a stable code of its kind, a sentence, and the place if it has one.

    ``file`` is empty for a mistake in the command line.
    """

    code: str
    text: str
    file: str
    line: int = 0
    column: int = 0
    check: str = ""
    is_finding: bool = False


def problems(result: Result) -> Iterator[Problem]:
    """Yield findings, checks that do not pass, and what else the status says; worst first."""
    for found in result.findings:
        where = f"{found.path}: " if found.path else ""
        hint = f" ({found.hint})" if found.hint else ""
        is_placed = bool(found.line) or found.file == result.spec
        option = "" if is_placed else f"{found.file}: "
        text, file = f"{option}{where}{found.text}{hint}", found.file if is_placed else ""
        yield Problem("finding", text, file, found.line, found.column, is_finding=True)
    rows = [check for check in worst_first(result.checks) if check.verdict is not Verdict.PASS]
    for check in rows:
        file, line, column, _ = check.place or (result.spec, 0, 0, "")
        code = check.verdict.value.replace(" ", "-")
        yield Problem(code, sentence(check), file, line, column, check.full_name)
    if not result.findings and not rows and result.status is not Status.PASS:
        yield Problem(result.status.value, headline(result), result.spec)


def headline(result: Result) -> str:
    """Return why a result without a failing check has its status, in one sentence."""
    if result.sizing is not None and result.sizing.conflict:
        names = ", ".join(row.name for row in result.sizing.conflict)
        return f"infeasible: these cannot all hold: {names}."
    for section in (result.balance, result.stops):
        if section is not None and section.reason:
            return f"{result.status.value}: {section.reason}."
    wrong = dict.fromkeys(row.effect for row in result.audit if row.right is False)
    if wrong:
        return f"the plan is wrong about {', '.join(wrong)}."
    return f"{result.command} ended as {result.status.value}."
