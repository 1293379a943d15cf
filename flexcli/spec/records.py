"""A recorded acceleration, or a vibration profile, named on the command line."""

from pathlib import Path

import numpy as np

from flexcli.errors import Finding, SpecError
from flexcli.parts.asd import ASDProfile
from flexcli.parts.record import Record
from flexcli.spec.profiles import load_profile
from flexcli.spec.references import TABLE_SUFFIXES
from flexcli.spec.table_file import Columns, is_over_time, read_table

__all__ = ["load_environment", "load_record"]

UNEVEN = 1e-2
"""Share of a step that a time may be off: files write it in a few digits."""


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
    table = read_table(Path(name), "record", columns)
    time, acceleration = table.si.T
    step = float(time[-1] - time[0]) / (time.size - 1)
    off = np.abs(time - time[0] - step * np.arange(time.size)).max() / step
    steps = np.abs(np.diff(time) / step - 1.0).max()
    if off > UNEVEN * time.size**0.5 and steps > UNEVEN:
        text = f"the samples are not at equal steps: one is {steps:.2g} of a step off"
        raise SpecError([Finding(name, text, "resample it evenly")])
    return Record(name, step, np.ascontiguousarray(acceleration))
