"""Values as YAML that a person would write: in one line where they fit, else one key a line."""

import json
import re
from typing import Any

__all__ = ["as_yaml"]

WIDTH = 78
_PLAIN = re.compile(r"[\w°%./(\[]?[^:#{}\[\],\"'&*!|>`@\n]*")
_NUMBER = re.compile(r"[-+.\d]+(?:e[-+]?\d+)?")
_WORDS = {"", "~", "null", "true", "false", "True", "False", "Null", "NULL", "TRUE", "FALSE"}


def as_yaml(value: dict[str, Any], unfolded: int) -> str:
    """Return a mapping as YAML, unfolded along its first levels, which hold one path."""
    return "\n".join(_lines(value, 0, unfolded)) + "\n"


def _lines(value: dict[str, Any], indent: int, unfolded: int) -> list[str]:
    found = []
    for key, inner in value.items():
        start = f"{' ' * indent}{key}:"
        short = f"{start} {_flow(inner)}"
        deep = isinstance(inner, dict) and inner and unfolded > 1 and indent < 2 * unfolded - 2
        if isinstance(inner, dict) and inner and (deep or len(short) > WIDTH):
            found += [start, *_lines(inner, indent + 2, unfolded if deep else 0)]
        elif isinstance(inner, list) and len(short) > WIDTH:
            found += [start, *(f"{' ' * indent}  - {_flow(each)}" for each in inner)]
        else:
            found.append(short)
    return found


def _flow(value: Any) -> str:
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key}: {_flow(inner)}' for key, inner in value.items())}}}"
    if isinstance(value, list):
        return f"[{', '.join(map(_flow, value))}]"
    if isinstance(value, str):
        is_plain = _PLAIN.fullmatch(value) and value == value.strip() and value not in _WORDS
        return value if is_plain and not _NUMBER.fullmatch(value) else json.dumps(value)
    if isinstance(value, float):
        return f"{value:g}".replace("e+0", "e").replace("e-0", "e-")
    return json.dumps(value)
