"""What ``flexure check`` says of a spec, and how that scores against what is true."""

import json
import tempfile
import traceback
from pathlib import Path
from typing import NamedTuple

import yaml
from typer.testing import CliRunner

from flexcli.cli.app import command_line

RIGHT, UNSAFE, FALSE_FAIL, UNDECIDED, ERROR = (
    "right", "unsafe pass", "false fail", "undecided", "error",
)  # fmt: skip
SCORES = (RIGHT, UNSAFE, FALSE_FAIL, UNDECIDED, ERROR)

FORGOTTEN = []
"""What is remembered in a process and is forgotten before each answer, where its time is told."""


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


class Answer(NamedTuple):
    """What ``flexure check`` printed as JSON, its exit code and how long it took [s].

    ``seconds`` are those that the check says it took: in a test the command line is built anew
    each time, which takes longer than a closed form. ``beside`` is what deciding cost besides the
    rows that are found.
    """

    found: dict
    exit_code: int
    seconds: float
    bug: str = ""
    beside: float = 0.0

    @property
    def deciding(self):
        """Return how long it took to decide all checks [s], without the values beside them."""
        each = {}
        for row in self.found.get("checks", []):
            question = (row.get("place") or {}).get("path"), row.get("case")
            each[question] = max(each.get(question, 0.0), row.get("cost") or 0.0)
        return sum(each.values()) + self.beside

    def about(self, name):
        """Return what was said of one requirement."""
        if self.bug:
            return Said(ERROR, "bug", 101, (), (), (), self.seconds, {}, self.bug)
        found, label = self.found, spoken(name)
        every = found.get("checks", [])
        rows = [
            row for row in every
            if spoken(row["name"]).startswith(label) and row["verdict"] != "not judged"
        ]  # fmt: skip
        verdicts = {row["verdict"] for row in rows}
        verdict = "fail" if "fail" in verdicts else UNDECIDED
        if verdicts == {"pass"}:
            verdict = "pass"
        if not rows or self.exit_code == 2:
            verdict = "pass" if found["status"] == "pass" else ERROR if not rows else verdict
        return Said(
            verdict,
            found["status"],
            self.exit_code,
            tuple(row["model"] for row in rows),
            tuple(row["factor"] for row in rows),
            tuple(row.get("factor_range") for row in rows),
            self.seconds,
            (found.get("cost") or {}).get("by_model", {}),
            "; ".join(f["text"] for f in found.get("findings", [])),
            tuple(every),
            tuple(note["code"] for note in found.get("warnings", [])),
            tuple(f["path"] for f in found.get("findings", [])),
        )


def answer(spec, model=None):
    """Return what ``flexure check`` says of a spec (a mapping)."""
    for remembered in FORGOTTEN:
        remembered.cache_clear()
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "spec.yaml")
        path.write_text(yaml.safe_dump(spec, sort_keys=False, width=10_000))
        words = ["check", str(path), "--format", "json"]
        result = CliRunner().invoke(command_line(), words + (["--model", model] if model else []))
    if result.exception is not None and not isinstance(result.exception, SystemExit):
        text = "".join(traceback.format_exception(result.exception))
        return Answer({}, 101, 0.0, text)
    found = json.loads(result.stdout)
    return Answer(found, result.exit_code, (found.get("cost") or {}).get("seconds", 0.0))


def checked(spec, name, model=None):
    """Return what ``flexure check`` says of a requirement of a spec (a mapping)."""
    return answer(spec, model).about(name)


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
