"""A sized design as the text of a spec."""

import os
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import yaml

from flexcli.spec.document import Document
from flexcli.spec.read import read_document
from flexcli.units import written

__all__ = ["sized_text"]


def sized_text(
    path: Path,
    document: Document,
    target: Path,
    sizes: Mapping[tuple[str, ...], float],
    height: float | None = None,
) -> str:
    """Return a design with its sizes fixed, to be written to ``target`` and read by check.

    ``sizes`` are by their place in the geometry; ``height`` is that of the mechanism, where it
    was chosen with them.

    What the spec named stays named, with paths made to start at the folder it is written to;
    a geometry that it named is written out, because its blade changes.
    """
    spec = _moved(read_document(path).value, path.parent, target.parent)
    geometry = document.value["geometry"]
    for place, value in sizes.items():
        geometry = _with(geometry, place, written(value, "length"))
    spec["geometry"] = geometry
    if height is not None:
        spec["mechanism"] = _with(
            document.value["mechanism"], ("height",), written(height, "length")
        )
    return yaml.safe_dump(spec, sort_keys=False, allow_unicode=True, width=100)


def _with(value: Any, place: tuple[str, ...], new: Any) -> Any:
    """Return a mapping with the value at a place replaced."""
    if not place:
        return new
    return {**value, place[0]: _with(value[place[0]], place[1:], new)}


def _moved(value: Any, folder: Path, target: Path) -> Any:
    """Return a value with the paths of spec files made relative to another folder."""
    if isinstance(value, dict):
        return {key: _moved(inner, folder, target) for key, inner in value.items()}
    if isinstance(value, list):
        return [_moved(inner, folder, target) for inner in value]
    if isinstance(value, str) and value.endswith((".yaml", ".yml")) and (folder / value).is_file():
        return Path(os.path.relpath(folder / value, target)).as_posix()
    return value
