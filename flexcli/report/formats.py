"""The formats in which results are rendered; a new one is a file here and a member below."""

from enum import StrEnum
from importlib import import_module
from typing import NamedTuple

from flexcli.results import PassedOver, Result

__all__ = ["Format", "Page", "Report"]


class Report(NamedTuple):
    """The output of a command: its results, whether of several specs, skipped files."""

    command: str
    results: tuple[Result, ...]
    is_of_many: bool = False
    passed_over: tuple[PassedOver, ...] = ()


class Page(NamedTuple):
    """The medium of the output: columns, colours, and its character set."""

    width: int = 80
    is_coloured: bool = False
    encoding: str = "utf-8"


class Format(StrEnum):
    """How results are rendered: by the module ``as_<value>`` of this package.

    Each has ``render(report, page)``, which returns the text for stdout.
    """

    TEXT = "text"
    JSON = "json"
    JUNIT = "junit"
    SARIF = "sarif"
    GITHUB = "github"
    MARKDOWN = "markdown"

    def render(self, report: Report, page: Page) -> str:
        """Return the text for stdout; only the asked format is imported."""
        text: str = import_module(f"flexcli.report.as_{self.value}").render(report, page)
        return text
