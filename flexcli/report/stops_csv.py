"""Histories and frequency responses of ``flexure stops`` as a CSV table, numbers in SI."""

from flexcli.report.rows_csv import rows_csv
from flexcli.results.stops import StopsResult

__all__ = ["history_csv", "sweep_csv"]

HISTORY = ("case", "time_s", "tip_m", "at_stop_m", "force_N")
RESPONSE = (
    "case", "direction", "frequency_Hz", "tip_m", "force_N", "contacts_per_period", "settled",
    "periods", "multiplier", "least_tip_m", "outcome", "response",
)  # fmt: skip


def history_csv(stops: StopsResult) -> str:
    """Return the samples of every simulated case."""
    return rows_csv(
        HISTORY,
        (
            (each.case, *numbers)
            for each in stops.histories
            for numbers in zip(each.time, each.tip, each.at_stop, each.force, strict=True)
        ),
    )


def sweep_csv(stops: StopsResult) -> str:
    """Return the steps of every frequency response."""
    return rows_csv(
        RESPONSE,
        (
            (
                sweep.case,
                "up" if step.up else "down",
                step.frequency,
                step.travel,
                step.force,
                step.contacts,
                str(step.settled).lower(),
                step.periods if step.settled else None,
                step.multiplier,
                step.least,
                step.outcome,
                sweep.how,
            )
            for sweep in stops.sweeps
            for step in sweep.steps
        ),
    )
