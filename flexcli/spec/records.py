"""A recorded acceleration, or a vibration profile, named on the command line."""

from pathlib import Path

from flexcli.parts.asd import ASDProfile
from flexcli.parts.record import Record
from flexcli.spec.profiles import load_profile
from flexcli.spec.references import TABLE_SUFFIXES
from flexcli.spec.table_file import Columns, is_over_time, read_table, recorded

__all__ = ["load_environment", "load_record"]


def load_environment(name: str, columns: Columns | None = None) -> ASDProfile | Record:
    """Return a profile, shipped or of a file, or the record of a table over time.

    Raises SpecError with every finding.
    """
    told = columns or Columns()
    if name.lower().endswith(TABLE_SUFFIXES) and is_over_time(Path(name), told):
        return load_record(name, told)
    return load_profile(name, told)


def load_record(name: str, columns: Columns) -> Record:
    """Return the record of a table of time and acceleration; raise SpecError."""
    return recorded(name, read_table(Path(name), "record", columns))
