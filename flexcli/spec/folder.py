"""Which files of a folder are designs."""

from collections.abc import Iterable
from pathlib import Path

from flexcli.errors import SpecError
from flexcli.spec.load import KINDS
from flexcli.spec.read import read_document

__all__ = ["designs_in"]


def designs_in(paths: Iterable[Path]) -> list[Path]:
    """Return files as they are and, of folders, the designs below them, sorted.

    A file of a folder that holds another kind of spec, or no spec at all, is passed over; one
    that cannot be read stays in, so that its findings are reported, and so does a folder without
    a design.
    """
    found: dict[Path, None] = {}
    for path in paths:
        if not path.is_dir():
            found[path] = None
            continue
        files = sorted([*path.rglob("*.yaml"), *path.rglob("*.yml")])
        found |= dict.fromkeys([file for file in files if _may_be_design(file)] or [path])
    return list(found)


def _may_be_design(file: Path) -> bool:
    try:
        root = read_document(file).value
    except SpecError:
        return True
    if not isinstance(root, dict) or "flexure" not in root:
        return False
    return not set(root) <= {"flexure", *KINDS} or "requirements" in root
