"""The worked examples that ship with the tool, each a folder with a spec and a text about it."""

import re
from pathlib import Path
from typing import NamedTuple

from flexcli.errors import Finding, SpecError
from flexcli.spec.findings import nearest
from flexcli.spec.read import read_document
from flexcli.spec.shipped import shipped_root

__all__ = ["SPEC", "Example", "example", "examples"]

SPEC = "flexure.yaml"
TEXT = "README.md"

_COMMAND = re.compile(r"^ {4}(flexure [^\n]*?) ?examples/", re.MULTILINE)
"""The command that runs an example, in the text about it."""


class Example(NamedTuple):
    """A worked example: its name, what its spec calls itself, and the command that runs it."""

    name: str
    title: str
    command: str
    folder: Path

    def files(self) -> dict[str, bytes]:
        """Return the contents of its files by their names."""
        paths = sorted(path for path in self.folder.iterdir() if path.is_file())
        return {path.name: path.read_bytes() for path in paths}


def examples() -> list[Example]:
    """Return all examples, sorted by name."""
    return [_example(path.parent) for path in sorted(_root().glob(f"*/{SPEC}"))]


def example(name: str) -> Example:
    """Return an example; raise :class:`SpecError` where there is none of that name."""
    names = [path.parent.name for path in _root().glob(f"*/{SPEC}")]
    if name not in names:
        text = f"there is no example '{name}'"
        raise SpecError([Finding("flexure examples", text, nearest(name, names))])
    return _example(_root() / name)


def _root() -> Path:
    return shipped_root("examples")


def _example(folder: Path) -> Example:
    title = read_document(folder / SPEC).value["title"]
    found = _COMMAND.search((folder / TEXT).read_text(encoding="utf-8"))
    return Example(folder.name, title, found[1] if found else "flexure check", folder)
