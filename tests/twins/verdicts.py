"""What ``flexure check`` says of a spec, and how that scores against what is true."""

import json
import tempfile
import traceback
from pathlib import Path
from time import perf_counter
from typing import NamedTuple

import yaml
from typer.testing import CliRunner

from flexcli.cli.app import command_line

RIGHT, UNSAFE, FALSE_FAIL, UNDECIDED, ERROR = (
    "right", "unsafe pass", "false fail", "undecided", "error",
)  # fmt: skip
SCORES = (RIGHT, UNSAFE, FALSE_FAIL, UNDECIDED, ERROR)


class Said(NamedTuple):
    """The verdict on one requirement, the models and numbers of its rows, exit code, time [s]."""

    verdict: str
    status: str
    exit_code: int
    models: tuple[str, ...]
    factors: tuple[float, ...]
    ranges: tuple
    seconds: float
    by_model: dict
    text: str = ""
    rows: tuple = ()
    notes: tuple = ()
    places: tuple = ()


def checked(spec, name, model=None):
    """Return what ``flexure check`` says of a requirement of a spec (a mapping)."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "spec.yaml")
        path.write_text(yaml.safe_dump(spec, sort_keys=False, width=10_000))
        words = ["check", str(path), "--format", "json"]
        started = perf_counter()
        result = CliRunner().invoke(command_line(), words + (["--model", model] if model else []))
        seconds = perf_counter() - started
    bug = result.exception is not None and not isinstance(result.exception, SystemExit)
    if bug:
        text = "".join(traceback.format_exception(result.exception))
        return Said(ERROR, "bug", 101, (), (), (), seconds, {}, text)
    found = json.loads(result.stdout)
    label = spoken(name)
    every = found.get("checks", [])
    rows = [
        row for row in every
        if spoken(row["name"]).startswith(label) and row["verdict"] != "not judged"
    ]  # fmt: skip
    verdicts = {row["verdict"] for row in rows}
    verdict = "fail" if "fail" in verdicts else UNDECIDED
    if verdicts == {"pass"}:
        verdict = "pass"
    if not rows or result.exit_code == 2:
        verdict = "pass" if found["status"] == "pass" else ERROR if not rows else verdict
    findings = "; ".join(f["text"] for f in found.get("findings", []))
    return Said(
        verdict,
        found["status"],
        result.exit_code,
        tuple(row["model"] for row in rows),
        tuple(row["factor"] for row in rows),
        tuple(row.get("factor_range") for row in rows),
        seconds,
        (found.get("cost") or {}).get("by_model", {}),
        findings,
        tuple(every),
        tuple(note["code"] for note in found.get("warnings", [])),
        tuple(f["path"] for f in found.get("findings", [])),
    )


def spoken(name):
    """Return the name of a requirement as a row has it, whatever ties its words."""
    return name.replace("_", " ").replace("-", " ")


def score(said, kept):
    """Return how a verdict on a requirement, truly kept or missed, counts."""
    if not kept and "pass" in (said.verdict, said.status):
        return UNSAFE
    if said.exit_code in (2, 101) or said.verdict == ERROR:
        return ERROR
    if kept and said.verdict == "fail":
        return FALSE_FAIL
    return UNDECIDED if said.verdict == UNDECIDED else RIGHT
