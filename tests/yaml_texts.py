"""YAML texts read for tests: their values, their findings, where a value stands."""

import pytest

from flexcli.errors import Finding, SpecError
from flexcli.spec.document import Document
from flexcli.spec.parse import parse_document


def parsed(text: str) -> Document:
    return parse_document(text, "spec.yaml")


def value(text: str) -> object:
    found = parsed(text)
    assert not found.findings
    return found.value


def refused(text: str) -> list[Finding]:
    with pytest.raises(SpecError) as raised:
        parsed(text)
    return raised.value.findings


def place(text: str, *path: str | int) -> tuple[int, int, int, int]:
    found, taken = parsed(text).position.closest(path)
    assert taken == path
    return found.line, found.column, found.key_line, found.key_column
