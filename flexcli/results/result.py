"""The answer of one command about one spec."""

from collections.abc import Mapping
from dataclasses import dataclass, field, fields
from enum import Enum
from typing import TYPE_CHECKING, Any, NamedTuple

from flexcli.errors import Finding
from flexcli.results.shown import records, rendered, tables

if TYPE_CHECKING:
    from flexcli.results.accuracy import AccuracyResult
    from flexcli.results.balance import BalanceResult
    from flexcli.results.judgement import Check, EffectRow, Note, Value
    from flexcli.results.plan import AuditRow, Plan
    from flexcli.results.simulation import SpaceSweep, SweepResult
    from flexcli.results.sizing import SizingResult
    from flexcli.results.stops import StopsResult
    from flexcli.results.study import StudyResult
    from flexcli.results.tolerances import TolerancesResult
    from flexcli.results.trade_off import Choices, Front
    from flexcli.results.verification import Verification
    from flexcli.results.vibration import (
        BreakpointRow,
        CaseResponse,
        ProfileRow,
        Spectrum,
        WorstCaseRow,
    )

__all__ = ["Cost", "PassedOver", "Result", "Status"]


class Status(Enum):
    """How a command ended, the best first; the exit code follows from it."""

    PASS = "pass"
    UNDECIDED = "undecided"
    FAIL = "fail"
    INFEASIBLE = "infeasible"
    ERROR = "error"

    @property
    def exit_code(self) -> int:
        """Return 0 when the design passed, 2 for bad input, 1 for all that is no pass."""
        return {Status.PASS: 0, Status.ERROR: 2}.get(self, 1)


@dataclass(frozen=True, eq=False)
class Cost:
    """What the answer cost in all and by model [s], and how far off its values may be."""

    seconds: float
    model: str
    estimated_error: float | None
    iterations: int = 0
    by_model: Mapping[str, float] = field(default_factory=dict)


def with_seconds(by_model: Mapping[str, float], model: str, seconds: float) -> dict[str, float]:
    """Return the seconds of models with some more of one."""
    return {**by_model, model: by_model.get(model, 0.0) + seconds}


HEADER = frozenset(
    {"command", "spec", "status", "title", "values", "checks", "effects", "warnings"}
    | {"findings", "cost"}
)
"""Fields that every result has; all others are sections."""


class PassedOver(NamedTuple):
    """A file or folder that was skipped, and why."""

    spec: str
    why: str


@dataclass(frozen=True, eq=False)
class Result:
    """The answer of one command about one spec: a header, and sections that it may have.

    A new kind of section is a record, a field here and its entry in ``report/as_text.py``.
    """

    command: str
    spec: str
    status: Status
    title: str = ""
    values: Mapping[str, "Value"] = field(default_factory=dict)
    checks: tuple["Check", ...] = ()
    effects: tuple["EffectRow", ...] = ()
    warnings: tuple["Note", ...] = ()
    findings: tuple[Finding, ...] = ()
    cost: Cost | None = None
    sizing: "SizingResult | None" = None
    responses: tuple["CaseResponse", ...] = ()
    profiles: tuple["ProfileRow", ...] = ()
    breakpoints: tuple["BreakpointRow", ...] = ()
    worst_cases: tuple["WorstCaseRow", ...] = ()
    spectra: tuple["Spectrum", ...] = ()
    sweeps: tuple["SweepResult", ...] = ()
    space_sweeps: tuple["SpaceSweep", ...] = ()
    balance: "BalanceResult | None" = None
    stops: "StopsResult | None" = None
    accuracy: "AccuracyResult | None" = None
    plan: "Plan | None" = None
    audit: tuple["AuditRow", ...] = ()
    verification: "Verification | None" = None
    study: "StudyResult | None" = None
    tolerances: "TolerancesResult | None" = None
    front: "Front | None" = None
    choices: "Choices | None" = None

    @property
    def sections(self) -> dict[str, Any]:
        """Return the sections that it has, by name."""
        names = (f.name for f in fields(self) if f.name not in HEADER)
        return {name: getattr(self, name) for name in names if getattr(self, name)}

    def to_dict(self) -> dict[str, Any]:
        """Return it as ``--format json`` prints it: plain Python, SI numbers, stable keys."""
        found: dict[str, Any] = rendered(self, "mapping")
        return found

    @property
    def tables(self) -> tuple[str, ...]:
        """Return the names of the tables that :meth:`records` gives."""
        content = self.to_dict()
        return ("values", *tables({k: v for k, v in content.items() if k != "values"}))

    def records(self, table: str = "checks") -> list[dict[str, Any]]:
        """Return a table as a list of rows, which ``pandas.DataFrame`` takes as it is.

        A table within another is named by its path, ``sweeps.points``; each of its rows repeats
        the plain cells of the row that it is in.
        """
        content = self.to_dict()
        content["values"] = [{"name": name, **row} for name, row in content["values"].items()]
        return records(content, table)

    def _repr_html_(self) -> str | None:
        html: str | None = rendered(self, "html")
        return html
