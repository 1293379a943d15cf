"""Findings about a spec, and the errors that carry them to the edge of the program."""

from dataclasses import dataclass

__all__ = ["Finding", "NoSolution", "SolveError", "SpecError", "printable"]


@dataclass(frozen=True)
class Finding:
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


def printable(text: str) -> str:
    """Return a text that cannot steer a terminal; each character keeps its column."""
    if text.isprintable():
        return text
    return "".join(
        c if c.isprintable() else " " if c.isspace() else "\N{REPLACEMENT CHARACTER}" for c in text
    )
