"""A vibration profile named on the command line, and one written to a file."""

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import yaml

from flexcli.errors import Finding, SpecError
from flexcli.parts.asd import ASDProfile
from flexcli.parts.design import DesignSpec
from flexcli.results import Result
from flexcli.spec.load import Loaded, load_shipped, validated
from flexcli.spec.read import read_document
from flexcli.spec.references import FORMAT, SUFFIXES
from flexcli.spec.shipped import shipped_path
from flexcli.units import written_in

__all__ = ["load_design_or_profile", "load_profile", "load_profiles", "profile_text"]

KIND = "asd"
_HINT = "a profile holds 'flexure' and 'asd' alone"


def load_design_or_profile(name: str, overrides: Mapping[Any, Any] | None = None) -> Loaded:
    """Return a shipped profile by its name, or the design or profile of a file.

    Raises SpecError with every finding.
    """
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


def load_profile(name: str) -> ASDProfile:
    """Return a shipped profile by its name, or that of a file; raise SpecError."""
    found = load_design_or_profile(name).part
    if isinstance(found, DesignSpec):
        raise SpecError([Finding(name, "is a design, not an ASD profile", _HINT)])
    profile: ASDProfile = found
    return profile


def load_profiles(names: Sequence[str]) -> dict[str, ASDProfile]:
    """Return profiles by their names; raise SpecError with the findings of all of them."""
    profiles: dict[str, ASDProfile] = {}
    findings: list[Finding] = []
    for name in names:
        try:
            profiles[name] = load_profile(name)
        except SpecError as error:
            findings.extend(error.findings)
    if findings:
        raise SpecError(findings)
    return profiles


def profile_text(described: Result) -> str:
    """Return a described profile as the text of a spec: reading it gives the same floats back."""
    (profile,) = described.profiles
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
