"""Findings about a spec, how solutions end, and the errors that carry both to the user."""

from enum import Enum
from typing import NamedTuple

__all__ = ["Finding", "NoSolution", "Outcome", "SolveError", "SpecError", "printable"]


class Finding(NamedTuple):
    """One mistake in a spec: where it is, what is wrong, what would be right."""

    file: str
    text: str
    hint: str = ""
    path: str = ""
    line: int = 0
    column: int = 0
    source_line: str = ""

    @property
    def where(self) -> str:
        """Return ``file:line:column`` as editors understand it."""
        return f"{self.file}:{self.line}:{self.column}" if self.line else self.file


class SpecError(Exception):
    """The user's spec has mistakes: all of them, found in one pass."""

    def __init__(self, findings: list[Finding]) -> None:
        super().__init__("; ".join(f"{f.where}: {f.path}: {f.text}" for f in findings))
        self.findings = sorted(findings, key=lambda f: (f.file, f.line, f.column))


class SolveError(Exception):
    """The mathematics has no answer for a valid spec: a named cause and its remedy."""

    def __init__(self, code: str, text: str, remedy: str) -> None:
        super().__init__(f"{text}: {remedy}")
        self.code = code
        self.text = text
        self.remedy = remedy


class NoSolution(SolveError):
    """A good spec of which a solver found no answer, or of which there is none: exit code 1."""


class Outcome(Enum):
    """How a solution ended: the cause and its remedy."""

    CONVERGED = ("converged", "")
    INFEASIBLE = (
        "no values of the variables satisfy all constraints",
        "relax one of the smallest conflicting set, which `conflict` finds",
    )
    UNBOUNDED = (
        "the objective falls without limit",
        "give bounds to the variables that run away",
    )
    STALLED = (
        "did not converge",
        "start nearer to the design, or look for coefficients or exponents that are out of "
        "proportion",
    )
    TURNED = (
        "the path from rest turns or branches before the demand is met",
        "hold a motion in place of the load, or follow the path by arc length",
    )
    SINGULAR = (
        "the mechanism at rest has no unique answer",
        "hold or support every body, and let blades extend where more of them than needed share "
        "a load",
    )
    OFF_PATH = (
        "a correction leads away from the path that is followed",
        "take shorter steps",
    )
    INACCURATE = (
        "the finest nodes do not reach the tolerance",
        "ask for less, or take out what makes the forces so large (blades held against "
        "stretching, boundary layers)",
    )

    COMPLETE = ("the whole excitation was run", "")
    INTERRUPTED = (
        "the run was ended before its excitation",
        "what was done is kept; run longer to see the rest",
    )
    CHATTER = (
        "contacts follow each other without the motion going on",
        "give the stop compliance (LinearStop), or a restitution further from 1",
    )

    @property
    def cause(self) -> str:
        """Why the solution ended."""
        return self.value[0]

    @property
    def remedy(self) -> str:
        """What to do about it."""
        return self.value[1]

    def error(self, where: str = "") -> SolveError:
        """Return the error of a solution that ended so; ``where`` begins its text."""
        return SolveError(self.name.lower(), where + self.cause, self.remedy)


def printable(text: str) -> str:
    """Return a text that cannot steer a terminal; each character keeps its column."""
    if text.isprintable():
        return text
    return "".join(
        c if c.isprintable() else " " if c.isspace() else "\N{REPLACEMENT CHARACTER}" for c in text
    )
