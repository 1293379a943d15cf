"""A vibration profile named on the command line, and one written to a file."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from flexcli.errors import Finding, SpecError
from flexcli.parts.asd import ASDProfile
from flexcli.parts.design import DesignSpec
from flexcli.results import Result
from flexcli.spec.document import Document
from flexcli.spec.load import Loaded, load_shipped, validated
from flexcli.spec.read import read_document
from flexcli.spec.references import FORMAT, SUFFIXES, TABLE_SUFFIXES
from flexcli.spec.shipped import shipped_path
from flexcli.spec.table_file import Columns, read_table
from flexcli.units import written_in

__all__ = ["load_design_or_profile", "load_profile", "load_profiles", "profile_text"]

KIND = "asd"
_HINT = "a profile holds 'flexure' and 'asd' alone"


def load_design_or_profile(
    name: str, overrides: Mapping[Any, Any] | None = None, columns: Columns | None = None
) -> Loaded:
    """Return a shipped profile by its name, or the design or profile of a file.

    ``columns`` tells of a table what its heading does not. Raises SpecError with every finding.
    """
    if name.lower().endswith(TABLE_SUFFIXES):
        return validated(_table_document(name, columns), Path(), overrides)
    is_file = Path(name).suffix in SUFFIXES or Path(name).exists()
    path = shipped_path(KIND, name)
    if path is None and not is_file:
        load_shipped(KIND, name)  # raises what is near to it
    path = path or Path(name)
    loaded = validated(read_document(path), path.parent, overrides)
    if not isinstance(loaded.part, DesignSpec | ASDProfile):
        text = f"is a spec of kind {loaded.kind}, neither a design nor an ASD profile"
        raise SpecError([Finding(name, text, _HINT)])
    return loaded


def _table_document(name: str, columns: Columns | None) -> Document:
    """Return a table of points as the document of a profile."""
    table = read_table(Path(name), KIND, columns or Columns())
    place = table.position()
    profile = place._replace(children={"points": place})
    value = {"flexure": FORMAT, KIND: {"points": table.points()}}
    whole = place._replace(children={KIND: profile})
    return Document(name, value, whole, {table.file: table.lines})


def load_profile(name: str, columns: Columns | None = None) -> ASDProfile:
    """Return a shipped profile by its name, or that of a file; raise SpecError."""
    found = load_design_or_profile(name, columns=columns).part
    if isinstance(found, DesignSpec):
        raise SpecError([Finding(name, "is a design, not an ASD profile", _HINT)])
    profile: ASDProfile = found
    return profile


def load_profiles(names: Sequence[str], columns: Columns | None = None) -> dict[str, ASDProfile]:
    """Return profiles by their names; raise SpecError with the findings of all of them."""
    profiles: dict[str, ASDProfile] = {}
    findings: list[Finding] = []
    for name in names:
        try:
            profiles[name] = load_profile(name, columns)
        except SpecError as error:
            findings.extend(error.findings)
    if findings:
        raise SpecError(findings)
    return profiles


def profile_text(described: Result, *, as_table: bool = False) -> str:
    """Return a described profile as the text of a spec, or of a table.

    Reading it gives the same floats back.
    """
    (profile,) = described.profiles
    if as_table:
        return _table_text(described)
    content: dict[str, Any] = {"name": profile.title, "note": profile.note}
    content["points"] = []
    before = None
    for point in described.breakpoints:
        row = {
            "frequency": written_in("Hz", point.frequency, "frequency"),
            "level": written_in("g^2/Hz", point.level, "acceleration density"),
        }
        is_step = point.frequency == before
        content["points"].append({**row, "step": True} if is_step else row)
        before = point.frequency
    if profile.interpolation != "log-log":
        content["interpolation"] = profile.interpolation
    if profile.duration is not None:
        content["duration"] = written_in("s", profile.duration, "time")
    if profile.axis:
        content["axis"] = profile.axis
    spec = {"flexure": FORMAT, KIND: content}
    return yaml.safe_dump(spec, sort_keys=False, allow_unicode=True, width=100)


def _table_text(described: Result) -> str:
    """Return the points of a profile as a table with its units, with a column of steps if any."""
    rows, before, has_steps = [], None, False
    for point in described.breakpoints:
        frequency, level = (
            written_in(unit, value, dimension).partition(" ")[0]
            for unit, value, dimension in (
                ("Hz", point.frequency, "frequency"),
                ("g^2/Hz", point.level, "acceleration density"),
            )
        )
        is_step = point.frequency == before
        has_steps = has_steps or is_step
        rows.append((frequency, level, "true" if is_step else ""))
        before = point.frequency
    heading = ("frequency [Hz]", "level [g^2/Hz]", "step")
    width = 3 if has_steps else 2
    return "".join(f"{','.join(row[:width])}\n" for row in (heading, *rows))
