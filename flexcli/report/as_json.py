"""Results as JSON by the output contract: stable keys, SI numbers, also when a run fails."""

import json
from collections.abc import Sequence
from math import isfinite
from typing import Any

from flexcli import __version__
from flexcli.errors import Finding
from flexcli.report.balance_json import balance_document
from flexcli.report.plan_json import plan_document
from flexcli.report.stops_json import stops_document
from flexcli.results import Result, SizingResult, Status

__all__ = ["FORMAT", "document", "dumps", "summary"]

FORMAT = 1
"""Version of the output contract."""


def dumps(content: Any) -> str:
    """Return JSON text; numbers that JSON has not (infinity) become null, rows mappings."""
    return json.dumps(_plain(content), indent=2, ensure_ascii=False, allow_nan=False)


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
    if result.sizing is not None:
        content["sizing"] = _sizing(result.sizing)
    if result.responses:
        content["responses"] = list(result.responses)
    for key in ("profiles", "breakpoints", "worst_cases", "sweeps"):
        if getattr(result, key):
            content[key] = list(getattr(result, key))
    if result.balance is not None:
        content["balance"] = balance_document(result.balance)
    if result.stops is not None:
        content["stops"] = stops_document(result.stops)
    if result.accuracy is not None:
        content["accuracy"] = result.accuracy
    if result.plan is not None:
        content["plan"] = plan_document(result.plan)
    if result.audit:
        content["audit"] = list(result.audit)
    if result.cost is not None:
        content["cost"] = {
            "seconds": result.cost.seconds,
            "model": result.cost.model,
            "estimated_error": result.cost.estimated_error,
            "iterations": result.cost.iterations,
            "by_model": dict(result.cost.by_model),
        }
    return content


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


def summary(command: str, results: Sequence[Result]) -> dict[str, Any]:
    """Return many results under the worst status of them."""
    worst = max((r.status for r in results), key=list(Status).index, default=Status.PASS)
    return {
        "flexure": FORMAT,
        "command": command,
        "version": __version__,
        "status": worst.value,
        "results": [document(result) for result in results],
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
