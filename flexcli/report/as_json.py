"""Results as JSON by the output contract: stable keys, SI numbers, also when a run fails."""

import json
from cmath import phase
from collections.abc import Callable, Mapping
from math import isfinite, nan
from typing import Any

from flexcli import __version__
from flexcli.errors import Finding
from flexcli.report.formats import Page, Report
from flexcli.results import Cost, Result, Status
from flexcli.results.balance import BalanceResult
from flexcli.results.plan import Plan
from flexcli.results.sizing import SizingResult
from flexcli.results.stops import StopsResult
from flexcli.results.verification import Verification

__all__ = ["FORMAT", "contents", "document", "dumps", "listing", "render", "summary"]

FORMAT = 1
"""Version of the output contract."""


def render(report: Report, page: Page) -> str:
    """Return one document, or that of several results."""
    one = None if report.is_of_many else document(report.results[0])
    return dumps(one or summary(report), page.encoding) + "\n"


def dumps(content: Any, encoding: str = "utf-8") -> str:
    """Return JSON text; numbers that JSON lacks (infinity) become null, rows mappings.

    Characters outside the encoding, and those that could steer a terminal, are escaped.
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
    """Return one result by the contract, in plain Python: numbers that JSON lacks are None."""
    plain: dict[str, Any] = _plain(document(result))
    return plain


def document(result: Result) -> dict[str, Any]:
    """Return one result by the contract."""
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
        "effects": result.effects,
        "warnings": result.warnings,
        "findings": [finding(found) for found in result.findings],
    }
    for name, section in result.sections.items():
        content[name] = SECTIONS[name](section) if name in SECTIONS else section
    content["cost"] = _cost(result.cost)
    return content


def _cost(cost: Cost | None) -> dict[str, Any]:
    """Return the cost of an answer; None stands for what was not measured."""
    cost = cost or Cost(nan, "", None)
    return {
        "seconds": cost.seconds,
        "model": cost.model,
        "estimated_error": cost.estimated_error,
        "iterations": cost.iterations,
        "by_model": dict(cost.by_model),
    }


def finding(found: Finding) -> dict[str, Any]:
    """Return a finding by the contract."""
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
    """Return a list that a command prints which is no result of a spec."""
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


def _balance(found: BalanceResult) -> dict[str, Any]:
    return {
        "outcome": found.outcome,
        "reason": found.reason,
        "remedy": found.remedy,
        "unknowns": found.unknowns,
        "base_motion": found.motion,
        "q": found.quality,
        "transfer": [
            {
                "frequency": row.frequency,
                "T_init": row.init,
                "T_final": row.final,
                "T_init_damped": _complex(row.init_damped),
                "T_final_damped": _complex(row.final_damped),
            }
            for row in found.transfer
        ],
        "stroke": found.stroke,
        "over_stroke": found.over_stroke,
        "sensitivities": found.sensitivities,
        "gravity": [{**row._asdict(), "sag_unit": found.output_unit} for row in found.gravity],
    }


def _complex(number: complex | None) -> dict[str, float] | None:
    """Return a complex number as magnitude and phase [rad]."""
    return None if number is None else {"magnitude": abs(number), "phase": phase(number)}


def _stops(found: StopsResult) -> dict[str, Any]:
    """Return all but the histories, which are for the CSV file alone."""
    return {key: value for key, value in found._asdict().items() if key != "histories"}


def _plan(found: Plan) -> dict[str, Any]:
    """Return a plan without its effects, which are a section of the result themselves."""
    told = ("accuracy", "reported", "on", "model", "cost", "estimated_error", "tolerance",
            "models", "scenes")  # fmt: skip
    return {name: getattr(found, name) for name in told}


SECTIONS: Mapping[str, Callable[[Any], Any]] = {
    "sizing": _sizing,
    "balance": _balance,
    "stops": _stops,
    "plan": _plan,
    "verification": _verification,
}
"""Sections whose form in the contract differs from their records."""


def _plain(content: Any) -> Any:
    if isinstance(content, float):
        return content if isfinite(content) else None
    if hasattr(content, "_asdict"):  # a row of a result
        return _plain(content._asdict())
    if isinstance(content, Mapping):
        return {key: _plain(value) for key, value in content.items()}
    if isinstance(content, list | tuple):
        return [_plain(value) for value in content]
    return content
