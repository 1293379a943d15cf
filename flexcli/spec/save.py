"""A sized design as the text of a spec."""

import os
from pathlib import Path
from typing import Any

import yaml

from flexcli.spec.document import Document
from flexcli.spec.read import read_document
from flexcli.units import written

__all__ = ["sized_text"]


def sized_text(path: Path, document: Document, target: Path, sizes: dict[str, float]) -> str:
    """Return a design with its blade fixed, to be written to ``target`` and read by check.

    What the spec named stays named, with paths made to start at the folder it is written to;
    a geometry that it named is written out, because its blade changes.
    """
    spec = _moved(read_document(path).value, path.parent, target.parent)
    spec["geometry"] = {
        **document.value["geometry"],
        **{name: written(value, "length") for name, value in sizes.items()},
    }
    return yaml.safe_dump(spec, sort_keys=False, allow_unicode=True, width=100)


def _moved(value: Any, folder: Path, target: Path) -> Any:
    """Return a value with the paths of spec files made relative to another folder."""
    if isinstance(value, dict):
        return {key: _moved(inner, folder, target) for key, inner in value.items()}
    if isinstance(value, list):
        return [_moved(inner, folder, target) for inner in value]
    if isinstance(value, str) and value.endswith((".yaml", ".yml")) and (folder / value).is_file():
        return Path(os.path.relpath(folder / value, target)).as_posix()
    return value
