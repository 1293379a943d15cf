"""The answer of ``flexure balance`` as JSON content, numbers in SI."""

from cmath import phase
from typing import Any

from flexcli.results.balance import BalanceResult, TransferRow

__all__ = ["balance_document"]


def balance_document(balance: BalanceResult) -> dict[str, Any]:
    """Return it as the contract has it; a complex number as magnitude and phase [rad]."""
    return {
        "outcome": balance.outcome,
        "reason": balance.reason,
        "remedy": balance.remedy,
        "unknowns": [
            {
                "name": unknown.name,
                "value": unknown.value,
                "unit": unknown.unit,
                "least": unknown.least,
                "most": unknown.most,
            }
            for unknown in balance.unknowns
        ],
        "base_motion": balance.motion,
        "q": balance.quality,
        "transfer": [_transfer(row) for row in balance.transfer],
        "stroke": balance.stroke,
        "over_stroke": [
            {
                "name": row.name,
                "unit": row.unit,
                "at_rest": row.at_rest,
                "orders": list(row.orders),
                "at_stroke": row.at_stroke,
            }
            for row in balance.over_stroke
        ],
        "sensitivities": [
            {
                "name": term.name,
                "value": term.value,
                "unit": term.unit,
                "slope": term.slope,
                "tolerance": term.tolerance,
                "effect": term.effect,
            }
            for term in balance.sensitivities
        ],
        "gravity": [
            {
                "axis": row.axis,
                "mounted": row.mounted,
                "unit": row.unit,
                "at_rest": row.at_rest,
                "at_stroke": row.at_stroke,
                "sag": row.sag,
                "sag_unit": balance.output_unit,
                "stiffness": row.stiffness,
            }
            for row in balance.gravity
        ],
    }


def _transfer(row: TransferRow) -> dict[str, Any]:
    return {
        "frequency": row.frequency,
        "T_init": row.init,
        "T_final": row.final,
        "T_init_damped": _complex(row.init_damped),
        "T_final_damped": _complex(row.final_damped),
    }


def _complex(number: complex | None) -> dict[str, float] | None:
    return None if number is None else {"magnitude": abs(number), "phase": phase(number)}
