"""From pydantic's errors to findings: by their type and context, never by their English text."""

from collections.abc import Iterable, Iterator
from difflib import get_close_matches
from types import UnionType
from typing import Annotated, Any, Literal, Union, get_args, get_origin

from pydantic import BaseModel, ValidationError

from flexcli.errors import Finding
from flexcli.spec.document import Position, finding_at

__all__ = ["findings_of", "nearest", "path_text"]

_EXPECTED = {
    "string_type": ("a text is expected here", "write it in quotes if it looks like a number"),
    "int_type": ("a whole number is expected here", ""),
    "int_from_float": ("a whole number is expected here", ""),
    "list_type": ("a list is expected here", "write [first, second]"),
    "tuple_type": ("a list is expected here", "write [first, second]"),
    "dict_type": ("a mapping is expected here", "write 'name: value' lines below the key"),
    "model_type": ("a mapping is expected here", "write 'key: value' lines below the key"),
    "model_attributes_type": ("a mapping is expected here", "write 'key: value' lines below it"),
    "none_required": ("nothing can be given here", "take the key out"),
}


def nearest(word: str, names: Iterable[str]) -> str:
    """Return "did you mean …" for the nearest name, or the names themselves."""
    known = sorted(names)
    close = get_close_matches(word, known, n=1, cutoff=0.6)
    if close:
        return f"did you mean '{close[0]}'?"
    shown = ", ".join(known[:12]) + (", …" if len(known) > 12 else "")
    return f"one of: {shown}" if known else ""


def path_text(path: Iterable[str | int]) -> str:
    """Return a path as people write it: ``cases.operation.points[2]``."""
    text = ""
    for step in path:
        text += f"[{step}]" if isinstance(step, int) else f".{step}" if text else step
    return text


def findings_of(
    error: ValidationError, model: Any, position: Position, lines: dict[str, list[str]]
) -> list[Finding]:
    """Return one finding for each of pydantic's errors."""
    return [
        finding
        for raw in error.errors(include_url=False, include_input=True)
        for finding in _finding(raw, model, position, lines)
    ]


def _finding(
    raw: Any, model: Any, position: Position, lines: dict[str, list[str]]
) -> Iterator[Finding]:
    kind, loc, context = raw["type"], tuple(raw["loc"]), raw.get("ctx", {})
    place, path = position.closest(loc)
    at_key = False
    if kind == "spec":
        text, hint = context["text"], context["hint"]
        place, path = position.closest((*loc, *context["at"]))
    elif kind == "extra_forbidden":
        key = str(loc[-1])
        text, hint, at_key = f"unknown key '{key}'", nearest(key, keys_at(model, loc[:-1])), True
    elif kind == "missing":
        text, hint = f"'{loc[-1]}' is missing", f"add '{loc[-1]}:'"
        at_key = bool(path)
    elif kind == "literal_error":
        text, hint = (
            f"'{raw['input']}' is not known here",
            _choice(raw["input"], context["expected"]),
        )
    elif kind == "union_tag_invalid":
        text = f"'{context['tag']}' is not a known {_last_name(path)}"
        hint = _choice(context["tag"], context["expected_tags"])
        place, path = position.closest((*loc, context["discriminator"].strip("'")))
    elif kind == "union_tag_not_found":
        tag = context["discriminator"].strip("'")
        text, hint = f"'{tag}' is missing", f"say which {_last_name(path)}: {_tags(model, loc)}"
    elif kind == "too_short":
        text, hint = f"at least {context['min_length']} is needed here", ""
    else:
        text, hint = _EXPECTED.get(kind, (raw["msg"], ""))
    yield finding_at(place, lines, path_text(path), text, hint, at_key=at_key)


def _last_name(path: tuple[str | int, ...]) -> str:
    return next((str(step) for step in reversed(path) if isinstance(step, str)), "value")


def _choice(given: Any, expected: str) -> str:
    names = [name.strip().strip("'") for name in expected.replace(" or ", ", ").split(",")]
    return nearest(str(given), names)


def _members(annotation: Any) -> Iterator[Any]:
    """Yield the plain types that an annotation allows, through aliases and unions."""
    origin = get_origin(annotation)
    if origin is Annotated:
        yield from _members(get_args(annotation)[0])
    elif origin in (Union, UnionType):
        for member in get_args(annotation):
            yield from _members(member)
    elif origin in (tuple, list):
        yield from (m for a in get_args(annotation) if a is not Ellipsis for m in _members(a))
    elif origin is dict:
        yield from _members(get_args(annotation)[1])
    else:
        yield annotation


def _models(annotation: Any) -> list[type[BaseModel]]:
    return [m for m in _members(annotation) if isinstance(m, type) and issubclass(m, BaseModel)]


def _fields(model: type[BaseModel]) -> dict[str, Any]:
    return {info.alias or name: info.annotation for name, info in model.model_fields.items()}


def _models_at(model: Any, loc: tuple[str | int, ...]) -> list[type[BaseModel]]:
    """Return the models that may stand at a pydantic location, following union tags."""
    here = _models(model)
    for step in loc:
        inside = [m for candidate in here if step in (f := _fields(candidate)) for m in _models(f[str(step)])]  # fmt: skip
        if inside:
            here = inside
            continue
        tagged = [c for c in here if step in _tag_values(c)]
        here = tagged or here
    return here


def _tag_values(model: type[BaseModel]) -> tuple[Any, ...]:
    kind = _fields(model).get("kind")
    return get_args(kind) if get_origin(kind) is Literal else ()


def _tags(model: Any, loc: tuple[str | int, ...]) -> str:
    return ", ".join(str(tag) for m in _models_at(model, loc) for tag in _tag_values(m))


def keys_at(model: Any, loc: tuple[str | int, ...]) -> set[str]:
    """Return the keys that a spec may have at a location."""
    return {key for candidate in _models_at(model, loc) for key in _fields(candidate)}
