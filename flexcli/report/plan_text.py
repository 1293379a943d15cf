"""A plan and its audit as tables."""

from collections.abc import Iterator, Sequence
from math import isfinite

from flexcli.report.tables import Cell, Line, Piece, Rows, table
from flexcli.results import Result
from flexcli.results.plan import AuditRow, Plan, ScenePlan

__all__ = ["audit_table", "plan_tables", "section", "share"]

NOTHING = 1e-8
"""Relative change below which none is shown."""


def section(result: Result) -> Iterator[Piece]:
    """Yield the plan, whole where it was asked for, and its audit."""
    if result.plan is not None:
        yield from plan_tables(result.plan, whole=result.command == "plan")
    if result.audit:
        yield audit_table(result.audit)


def plan_tables(plan: Plan, *, whole: bool) -> Iterator[Piece]:
    """Yield the effects with their changes of each number, and the models; or a short form."""
    if not whole:
        yield Line(_short(plan), hang=2)
        return
    names = plan.reported
    effects = table(
        "Effects", "effect", "", "asked", *names, "why", numbers=range(3, 3 + len(names))
    )
    for row in plan.effects:
        shares = (share(row.estimates[n]) if n in row.estimates else "" for n in names)
        mark = ("on", "green") if row.on else ("off", "dim")
        effects.add_row(row.name, mark, row.asked, *shares, row.reason)
    yield effects
    yield _models("Models", plan)
    yield Line(_short(plan), hang=2)
    for scene in plan.scenes:
        yield _models(f"Models, {scene.case}", scene)
        yield Line(f"{scene.case}: {scene.model}, {scene.reason}", hang=2)


def _models(title: str, plan: Plan | ScenePlan) -> Rows:
    """Return the models in question, the one that is taken marked."""
    models = table(title, "", "model", "cost", "error", "does not carry", numbers=[2, 3])
    for model in plan.models:
        taken = "→" if model.name == plan.model else ""
        cells = (f"{model.cost:.3g}", share(model.error), ", ".join(model.missing))
        models.add_row(taken, model.name, *cells)
    return models


def audit_table(rows: Sequence[AuditRow]) -> Rows:
    """Return the true change by each effect beside its estimate."""
    found = table(
        "Audit", "effect", "", "number", "estimate", "true", "plan", "how", numbers=[3, 4]
    )
    for row in rows:
        true = "?" if row.true is None else f"{row.true:+z.2%}" if abs(row.true) < 10.0 else "> 10"
        verdict: Cell = ""
        if row.right is not None:
            verdict = ("right", "green") if row.right else ("WRONG", "bold red")
        on = "on" if row.on else "off"
        found.add_row(row.effect, on, row.quantity, share(row.estimate), true, verdict, row.how)
    return found


def share(value: float) -> str:
    """Return a relative change in a few characters."""
    if not isfinite(value):
        return "∞"
    return f"{value * 100.0:.1g}%" if NOTHING < value < 1e-4 else f"{value:.2%}"


def _short(plan: Plan) -> str:
    asked = f"accuracy {share(plan.accuracy)}" if isfinite(plan.accuracy) else "effects as asked"
    on = ", ".join(plan.on) or "no effect"
    error = share(plan.estimated_error)
    return f"plan: {asked}; {on} on; {plan.model} model at cost {plan.cost:.3g}; error ≤ {error}"
