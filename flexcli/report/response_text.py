"""The response of a case's modes as tables."""

from collections.abc import Iterator, Mapping
from math import inf

from flexcli.report.tables import Line, Piece, Rows, table
from flexcli.results import Result
from flexcli.results.vibration import CaseResponse, ModeResult, OutputResult
from flexcli.units import show

__all__ = ["response_tables", "section"]

PER_MODE = (("stress", "Pa"), ("force", "N"))
"""Outputs shown for each mode: the worst of a kind, with its unit."""


def section(result: Result) -> Iterator[Piece]:
    """Yield the response of every case."""
    for response in result.responses:
        yield from response_tables(response)


def response_tables(response: CaseResponse) -> Iterator[Piece]:
    """Yield modes, outputs and lives of one case."""
    yield Line((f"{response.case}: {response.kind}", "bold"))
    if response.modes:
        yield _modes(response.modes)
    yield _outputs(response.outputs)
    if response.lives:
        joints = [name.removeprefix("stress ") for name in response.lives]
        lives = table("Life", "method", *joints, numbers=range(1, 1 + len(joints)))
        by_joint = list(response.lives.values())
        for method in by_joint[0]:
            lives.add_row(method, *(show(found[method], "s", 3) for found in by_joint))
        lives.add_row("longest over shortest", *(f"{_spread(found):.2g}" for found in by_joint))
        yield lives


def _spread(lives: Mapping[str, float]) -> float:
    """Return the ratio of the largest life to the least of all methods; 1 for an infinite life."""
    shortest, longest = min(lives.values()), max(lives.values())
    return longest / shortest if 0.0 < shortest < inf else 1.0


def _modes(modes: tuple[ModeResult, ...]) -> Rows:
    rows = table("Modes", "frequency", "moves", "rms stress", "rms force", "", numbers=range(4))
    for mode in modes:
        worst = [
            show(max(v for name, v in mode.rms.items() if name.startswith(kind)), unit)
            if mode.rms
            else ""
            for kind, unit in PER_MODE
        ]
        told = "" if mode.dynamic else "not excited"
        rows.add_row(show(mode.frequency, "Hz"), f"{mode.mass_share:.1%}", *worst, told)
    return rows


def _outputs(outputs: tuple[OutputResult, ...]) -> Rows:
    if all(row.rms is None for row in outputs):
        rows = table("Responses", "output", "peak", numbers=[1])
        for row in outputs:
            rows.add_row(row.name, show(row.peak, row.unit))
        return rows
    columns = ("output", "rms", "peak (sigma)", "peak in the time", "crossings")
    rows = table("Responses", *columns, numbers=range(1, 5))
    for row in outputs:
        sizes = [(row.rms, row.unit), (row.peak, row.unit), (row.expected_peak, row.unit)]
        sizes.append((row.crossing_rate, "Hz"))
        rows.add_row(row.name, *(show(v, unit) if v is not None else "" for v, unit in sizes))
    return rows
