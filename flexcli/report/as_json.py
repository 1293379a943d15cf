"""Results as JSON by the output contract: stable keys, SI numbers, also when a run fails."""

import json
from collections.abc import Callable, Mapping
from math import isfinite, nan
from typing import Any

from flexcli import __version__
from flexcli.errors import Finding
from flexcli.report.balance_json import balance_document
from flexcli.report.formats import Page, Report
from flexcli.report.plan_json import plan_document
from flexcli.report.stops_json import stops_document
from flexcli.results import Cost, Result, Status
from flexcli.results.sizing import SizingResult
from flexcli.results.verification import Verification

__all__ = ["FORMAT", "contents", "document", "dumps", "listing", "render", "summary"]

FORMAT = 1
"""Version of the output contract."""


def render(report: Report, page: Page) -> str:
    """Return one document, or that of several results."""
    one = None if report.is_of_many else document(report.results[0])
    return dumps(one or summary(report), page.encoding) + "\n"


def dumps(content: Any, encoding: str = "utf-8") -> str:
    """Return JSON text; numbers that JSON has not (infinity) become null, rows mappings.

    What the encoding lacks, and what could steer a terminal, is escaped.
    """
    options: dict[str, Any] = {"indent": 2, "allow_nan": False}
    text = json.dumps(_plain(content), ensure_ascii=False, **options)
    try:
        text.encode(encoding)
    except UnicodeEncodeError:
        return json.dumps(_plain(content), **options)
    if text.replace("\n", "").isprintable():
        return text
    return json.dumps(_plain(content), **options).replace("\x7f", "\\u007f")


def contents(result: Result) -> dict[str, Any]:
    """Return one result as the contract has it, in plain Python: what JSON has not is nothing."""
    plain: dict[str, Any] = _plain(document(result))
    return plain


def document(result: Result) -> dict[str, Any]:
    """Return one result as the contract has it."""
    content: dict[str, Any] = {
        "flexure": FORMAT,
        "command": result.command,
        "version": __version__,
        "spec": result.spec,
        "title": result.title,
        "status": result.status.value,
        "values": {
            name: {
                "value": value.value,
                "unit": value.unit,
                "label": value.label,
                "model": value.model,
                "estimated_error": value.estimated_error,
                "source": value.source,
            }
            for name, value in result.values.items()
        },
        "checks": [
            {
                "name": check.name,
                "case": check.case,
                "quantity": check.quantity,
                "demand": check.demand,
                "capacity": check.capacity,
                "unit": check.unit,
                "factor": check.factor,
                "factor_range": check.factor_range,
                "required": check.required,
                "margin": check.margin,
                "verdict": check.verdict.value,
                "pass": check.passed,
                "model": check.model,
                "cost": check.seconds,
                "source": check.source,
                "place": check.place,
            }
            for check in result.checks
        ],
        "effects": [
            {
                "name": effect.name,
                "on": effect.on,
                "indicator": effect.indicator,
                "estimate": effect.estimate,
                "reason": effect.reason,
                "estimates": dict(effect.estimates),
                "asked": effect.asked,
                "models": list(effect.models),
            }
            for effect in result.effects
        ],
        "warnings": [{"code": note.code, "text": note.text} for note in result.warnings],
        "findings": [finding(found) for found in result.findings],
    }
    for name, section in result.sections.items():
        content[name] = SECTIONS[name](section) if name in SECTIONS else section
    content["cost"] = _cost(result.cost)
    return content


def _cost(cost: Cost | None) -> dict[str, Any]:
    """Return what an answer cost; nothing stands for what was not measured."""
    cost = cost or Cost(nan, "", None)
    return {
        "seconds": cost.seconds,
        "model": cost.model,
        "estimated_error": cost.estimated_error,
        "iterations": cost.iterations,
        "by_model": dict(cost.by_model),
    }


def finding(found: Finding) -> dict[str, Any]:
    """Return a finding as the contract has it."""
    return {
        "file": found.file,
        "line": found.line,
        "column": found.column,
        "path": found.path,
        "text": found.text,
        "hint": found.hint,
    }


def summary(report: Report) -> dict[str, Any]:
    """Return many results under the worst status of them, and what was passed over."""
    results = report.results
    worst = max((r.status for r in results), key=list(Status).index, default=Status.PASS)
    return {
        "flexure": FORMAT,
        "command": report.command,
        "version": __version__,
        "status": worst.value,
        "results": [document(result) for result in results],
        "passed_over": list(report.passed_over),
        "cost": {"seconds": sum(r.cost.seconds for r in results if r.cost is not None)},
    }


def listing(command: str, seconds: float, **content: Any) -> dict[str, Any]:
    """Return what a command lists or tells that is no result of a spec."""
    return {
        "flexure": FORMAT,
        "command": command,
        "version": __version__,
        "status": Status.PASS.value,
        **content,
        "cost": {"seconds": seconds},
    }


def _sizing(sizing: SizingResult) -> dict[str, Any]:
    return {
        "objective": sizing.objective,
        "certificate": sizing.certificate,
        "designs": [{"label": d.label, **d.sizes, "volume": d.volume} for d in sizing.designs],
        "active": list(sizing.active),
        "sensitivities": [
            {"constraint": s.constraint, "driver": s.driver, "on": dict(s.on)}
            for s in sizing.sensitivities
        ],
        "conflict": [{"name": r.name, "factor": r.factor, "text": r.text} for r in sizing.conflict],
        "remarks": list(sizing.remarks),
    }


def _verification(found: Verification) -> dict[str, Any]:
    rows = [{**n._asdict(), "apart": n.apart, "agrees": n.agrees} for n in found.numbers]
    return {**found._asdict(), "numbers": rows}


SECTIONS: Mapping[str, Callable[[Any], Any]] = {
    "sizing": _sizing,
    "balance": balance_document,
    "stops": stops_document,
    "plan": plan_document,
    "verification": _verification,
}
"""Sections that the contract has otherwise than their records are."""


def _plain(content: Any) -> Any:
    if isinstance(content, float):
        return content if isfinite(content) else None
    if hasattr(content, "_asdict"):  # a row of a result
        return _plain(content._asdict())
    if isinstance(content, dict):
        return {key: _plain(value) for key, value in content.items()}
    if isinstance(content, list | tuple):
        return [_plain(value) for value in content]
    return content
