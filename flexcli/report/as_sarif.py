"""Results as SARIF 2.1.0 (OASIS): what code scanning shows beside the lines of the spec."""

import json
from pathlib import Path
from typing import Any
from urllib.parse import quote

from flexcli import __version__
from flexcli.errors import printable
from flexcli.report.formats import Page, Report
from flexcli.report.problems import Problem, problems
from flexcli.results import Status

__all__ = ["render"]

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"

RULES = {
    "finding": "The spec has a mistake.",
    "fail": "A requirement does not hold.",
    "undecided": "No model can tell whether a requirement holds.",
    "not-judged": "No requirement looks at a load of a case.",
    "infeasible": "No design meets all requirements.",
}
"""Codes of problems, each with what it says."""

WARNING = "warning"


def render(report: Report, _: Page) -> str:
    """Return the log of one run."""
    found = [_result(p, "error") for result in report.results for p in problems(result)]
    found += [
        _result(Problem(WARNING, f"{note.text} [{note.code}]", result.spec), WARNING)
        for result in report.results
        for note in result.warnings
    ]
    ok = all(result.status is not Status.ERROR for result in report.results)
    rules = [{"id": code, "shortDescription": {"text": text}} for code, text in RULES.items()]
    rules.append({"id": WARNING, "shortDescription": {"text": "Something to know of a result."}})
    driver = {"name": "flexure", "version": __version__, "rules": rules}
    told = [
        {"level": "note", **_what(Problem("passed-over", f"passed over: {why}", spec))}
        for spec, why in report.passed_over
    ]
    run = {
        "tool": {"driver": driver},
        "columnKind": "unicodeCodePoints",
        "invocations": [
            {"executionSuccessful": ok} | ({"toolExecutionNotifications": told} if told else {})
        ],
        "results": found,
    }
    log = {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
    return json.dumps(log, indent=2) + "\n"


def _result(problem: Problem, level: str) -> dict[str, Any]:
    return {"ruleId": problem.code, "level": level, **_what(problem)}


def _what(problem: Problem) -> dict[str, Any]:
    """Return what a problem says, and where."""
    found: dict[str, Any] = {"message": {"text": printable(problem.text)}}
    if problem.file:
        location: dict[str, Any] = {"artifactLocation": {"uri": _uri(problem.file)}}
        if problem.line:
            location["region"] = {"startLine": problem.line, "startColumn": max(problem.column, 1)}
        found["locations"] = [{"physicalLocation": location}]
    return found


def _uri(file: str) -> str:
    """Return a file as a URI, relative where its path is."""
    path = Path(file)
    if path.is_absolute():
        return path.as_uri()
    return quote(path.as_posix(), errors="replace")
