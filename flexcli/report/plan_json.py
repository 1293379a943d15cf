"""A plan as JSON content."""

from typing import Any

from flexcli.results.plan import Plan

__all__ = ["plan_document"]


def plan_document(plan: Plan) -> dict[str, Any]:
    """Return a plan, numbers relative; its effects stand beside it as those of any result."""
    return {
        "accuracy": plan.accuracy,
        "reported": list(plan.reported),
        "on": list(plan.on),
        "model": plan.model,
        "cost": plan.cost,
        "estimated_error": plan.estimated_error,
        "tolerance": plan.tolerance,
        "models": list(plan.models),
        "scenes": list(plan.scenes),
    }
