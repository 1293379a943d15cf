"""The meaning of the fields of a spec: the text below each field, read from the source.

Such a text ends with an example, where the type gives none: ``e.g. ``410 um`` `` is a value,
``e.g. ``cycles: 1e6, rotation: 5 deg`` `` are lines of the part, the field's own first.
"""

import ast
import re
import sys
from collections.abc import Iterator, Mapping
from functools import cache
from inspect import getsource
from itertools import pairwise
from typing import NamedTuple

from pydantic import BaseModel

from flexcli.parts.base import Part

__all__ = ["Note", "key_of", "note"]

_EXAMPLE = re.compile(r",?\s*e\.g\. ``(?P<example>[^`]+)``")


class Note(NamedTuple):
    """What a field is, and how it is written; either may be empty."""

    text: str
    example: str


def note(model: type[BaseModel], field: str) -> Note:
    """Return the text and the example that stand below a field."""
    for part in _parts(model):
        text = _texts(part.__module__).get(part.__name__, {}).get(field)
        if text is not None:
            found = _EXAMPLE.search(text)
            plain = _EXAMPLE.sub("", text).replace("``", "'")
            return Note(plain.removesuffix("."), found["example"] if found else "")
    return Note("", "")


def key_of(model: type[BaseModel], field: str) -> str:
    """Return the key by which a spec writes a field."""
    return model.model_fields[field].alias or field


def _parts(model: type[BaseModel]) -> Iterator[type[BaseModel]]:
    """Yield a part and those that it inherits from, generic ones as they are written."""
    for part in model.__mro__:
        if issubclass(part, Part):
            yield part.__pydantic_generic_metadata__["origin"] or part


@cache
def _texts(module: str) -> Mapping[str, Mapping[str, str]]:
    """Return the texts below the fields of a module's classes."""
    tree = ast.parse(getsource(sys.modules[module]))
    classes = (node for node in tree.body if isinstance(node, ast.ClassDef))
    return {each.name: dict(_below(each)) for each in classes}


def _below(part: ast.ClassDef) -> Iterator[tuple[str, str]]:
    for field, text in pairwise(part.body):
        match field, text:
            case (
                ast.AnnAssign(target=ast.Name(id=name)),
                ast.Expr(value=ast.Constant(value=str(said))),
            ):
                yield name, " ".join(said.split())
