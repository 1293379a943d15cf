"""Histories and frequency responses of ``flexure stops`` as a CSV table, numbers in SI."""

from collections.abc import Iterator

from flexcli.results import StopsResult

__all__ = ["history_csv", "sweep_csv"]


def history_csv(stops: StopsResult) -> str:
    """Return the samples of every simulated case."""

    def rows() -> Iterator[str]:
        yield "case,time_s,tip_m,at_stop_m,force_N"
        for history in stops.histories:
            columns = (history.time, history.tip, history.at_stop, history.force)
            for numbers in zip(*columns, strict=True):
                yield ",".join((history.case, *map(repr, numbers)))

    return "\n".join(rows()) + "\n"


def sweep_csv(stops: StopsResult) -> str:
    """Return the steps of every frequency response."""

    def rows() -> Iterator[str]:
        yield (
            "case,direction,frequency_Hz,tip_m,force_N,contacts_per_period,settled,"
            "periods,multiplier,least_tip_m"
        )
        for sweep in stops.sweeps:
            for step in sweep.steps:
                way = "up" if step.up else "down"
                numbers = (step.frequency, step.travel, step.force, step.contacts)
                periods = str(step.periods) if step.settled else ""
                told = ("" if x is None else repr(x) for x in (step.multiplier, step.least))
                settled = str(step.settled).lower()
                row = (sweep.case, way, *map(repr, numbers), settled, periods, *told)
                yield ",".join(row)

    return "\n".join(rows()) + "\n"
