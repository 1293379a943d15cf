"""The specs that ship with the tool, found from a wheel and from a source tree alike."""

from functools import cache
from pathlib import Path

__all__ = ["FOLDERS", "shipped_names", "shipped_path", "shipped_root"]

FOLDERS = {
    "material": "materials",
    "asd": "asd",
    "geometry": "geometries",
    "stroke": "strokes",
}
"""Folder of each kind of spec."""


@cache
def shipped_root(folder: str = "specs") -> Path:
    """Return a folder that ships: inside the package of a wheel, beside it in a source tree."""
    package = Path(__file__).resolve().parent.parent
    inside = package / folder
    return inside if inside.is_dir() else package.parent / folder


@cache
def shipped_names(kind: str) -> tuple[str, ...]:
    """Return the names of the shipped specs of a kind, sorted."""
    return tuple(sorted(path.stem for path in (shipped_root() / FOLDERS[kind]).glob("*.yaml")))


def shipped_path(kind: str, name: str) -> Path | None:
    """Return the file of a shipped spec, or nothing when there is none of that name."""
    return (
        (shipped_root() / FOLDERS[kind] / f"{name}.yaml") if name in shipped_names(kind) else None
    )
