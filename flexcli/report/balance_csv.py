"""The transfer functions of ``flexure balance`` as a CSV table, numbers in SI."""

from cmath import phase

from flexcli.report.rows_csv import rows_csv
from flexcli.results.balance import TransferRow

__all__ = ["transfer_csv"]

COLUMNS = (
    "frequency_Hz",
    "T_init_s2",
    "T_final_s2",
    "T_init_damped_magnitude_s2",
    "T_init_damped_phase_rad",
    "T_final_damped_magnitude_s2",
    "T_final_damped_phase_rad",
)


def transfer_csv(rows: tuple[TransferRow, ...]) -> str:
    """Return the table with a heading; a cell is empty where there is no number."""
    return rows_csv(COLUMNS, map(_cells, rows))


def _cells(row: TransferRow) -> list[float | None]:
    numbers: list[float | None] = [row.frequency, row.init, row.final]
    for damped in (row.init_damped, row.final_damped):
        numbers += [None, None] if damped is None else [abs(damped), phase(damped)]
    return numbers
