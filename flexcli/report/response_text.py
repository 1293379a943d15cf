"""The response of a case's modes as tables."""

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from flexcli.report.tables import table
from flexcli.results import CaseResponse, ModeResult, OutputResult
from flexcli.units import show

__all__ = ["response_tables"]

PER_MODE = (("stress", "Pa"), ("force", "N"))
"""What of each mode is shown: the worst output of a kind, with its unit."""


def response_tables(response: CaseResponse) -> RenderableType:
    """Return modes, outputs and lives of one case."""
    parts: list[RenderableType] = [Text(f"{response.case}: {response.kind}", "bold")]
    if response.modes:
        parts.append(_modes(response.modes))
    parts.append(_outputs(response.outputs))
    if response.lives:
        methods = list(next(iter(response.lives.values())))
        lives = table("Life", "output", *methods, numbers=range(1, 1 + len(methods)))
        for name, by_method in response.lives.items():
            lives.add_row(name, *(show(life, "s", 3) for life in by_method.values()))
        parts.append(lives)
    return Group(*parts)


def _modes(modes: tuple[ModeResult, ...]) -> Table:
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


def _outputs(outputs: tuple[OutputResult, ...]) -> Table:
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
