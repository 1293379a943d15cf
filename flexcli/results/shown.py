"""The conversion of a record for scripts and notebooks, by renderers that a higher layer registers.

Records know nothing of reports; what makes a mapping, a page or a picture of them is registered
from above, and asked for the first time when somebody looks.
"""

from collections.abc import Callable, Iterator, Mapping
from typing import Any

__all__ = ["Renderer", "records", "register", "rendered", "tables"]

Renderer = Callable[[Any], Any]

_RENDERERS: dict[str, Renderer] = {}


def register(**renderers: Renderer) -> None:
    """Give the renderers of a kind of output: ``mapping``, ``html``, ``svg``."""
    _RENDERERS.update(renderers)


def rendered(record: Any, kind: str) -> Any:
    """Return a record as a kind of output; None where no renderer is registered."""
    return _RENDERERS[kind](record) if kind in _RENDERERS else None


def tables(content: Mapping[str, Any], before: str = "") -> Iterator[str]:
    """Yield the paths of all lists of rows in a document, outer ones first."""
    for key, value in content.items():
        path = f"{before}{key}"
        if isinstance(value, Mapping):
            yield from tables(value, f"{path}.")
        elif isinstance(value, list) and value and isinstance(value[0], Mapping):
            yield path
            yield from tables(value[0], f"{path}.")


def records(content: Any, path: str) -> list[dict[str, Any]]:
    """Return the rows at a path of a document; rows within rows repeat the plain cells outside.

    Raises :class:`KeyError` where there is no such table.
    """
    key, _, rest = path.partition(".")
    found = content[key]
    if not rest:
        return [dict(row) for row in found]
    if isinstance(found, Mapping):
        return records(found, rest)
    return [{**_plain(outer), **row} for outer in found for row in records(outer, rest)]


def _plain(row: Mapping[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in row.items() if not isinstance(value, Mapping | list)}
