"""How the coupling depends on each number of the stage, and what tolerances leave of it."""

from collections.abc import Sequence
from math import hypot

from flexcli.mechanics.parallel_stage import Stage
from flexcli.parts.balancing import Tolerances
from flexcli.results import Value
from flexcli.results.balance import CouplingTerm

__all__ = ["coupling_terms", "tolerance_values"]


def coupling_terms(stage: Stage, tolerances: Tolerances) -> tuple[CouplingTerm, ...]:
    """Return ∂τ/∂p for every mass, centre of mass, arm and the height, with its tolerance."""
    return tuple(
        CouplingTerm(
            term.name,
            term.value,
            term.unit,
            term.slope,
            allowed := getattr(tolerances, term.kind),
            abs(term.slope) * allowed,
        )
        for term in stage.coupling_terms()
    )


def tolerance_values(
    stage: Stage, tolerances: Tolerances, terms: Sequence[CouplingTerm], nominal: float
) -> dict[str, Value]:
    """Return the coupling that tolerances may leave: worst case, and root of the sum of squares.

    The worst case has the products of a mass's and a length's tolerance too.
    """
    if not tolerances.any:
        return {}
    arms = sum(lever.balance.mass > 0.0 for lever in stage.levers)
    solids = len(stage.levers)
    products = tolerances.mass * (solids * tolerances.com + arms * tolerances.arm) / stage.height
    worst = abs(nominal) + sum(term.effect for term in terms) + products
    return {
        "tau_worst": Value(worst, "kg", "largest coupling within the tolerances"),
        "tau_rss": Value(
            hypot(nominal, *(term.effect for term in terms)),
            "kg",
            "coupling to expect, tolerances by the root of the sum of squares",
        ),
    }
