"""The manual of a spec: every key, kind and effect with what it means and YAML to copy.

All of it is read from the JSON Schema, so that it knows what the tool accepts and nothing else.
"""

import re
from collections.abc import Iterator, Mapping
from functools import cache
from typing import Any, NamedTuple

from flexcli.parts.effects import EFFECTS, Effect, ModelEffect
from flexcli.results.explanation import FieldRow, KeyRow
from flexcli.spec.as_yaml import as_yaml
from flexcli.spec.schema import BESIDE, json_schema
from flexcli.spec.sketches import AXES
from flexcli.units import DIMENSIONS

__all__ = ["entries", "meaning", "names"]

NAME = "<name>"
"""Step of a path where a spec has a name of its own."""
ITEM = "[]"
"""Step of a path into a list."""
SECTIONS = ("requirements", "cases", "size", "balance", "effects")
"""Sections whose keys are explained on their own."""
ALONE = ("min", "max", "equals", "minimize", "maximize")
"""Keys that exclude those of the example around them."""


class _Place(NamedTuple):
    """A key of a spec: its path, its schema, and the mappings or lists that it stands in."""

    path: tuple[str, ...]
    schema: Mapping[str, Any]
    within: tuple[Mapping[str, Any], ...]

    @property
    def steps(self) -> tuple[str, ...]:
        """Return its path as one asks for it."""
        return tuple(step for step in self.path if step not in (NAME, ITEM))

    def is_at(self, path: tuple[str, ...]) -> bool:
        """Return whether it stands at the path of a spec, whose own names are any."""
        own = [step for step in self.path if step != ITEM]
        return len(own) == len(path) and all(a in (b, NAME) for a, b in zip(own, path, strict=True))

    @property
    def kind(self) -> str:
        """Return the kind of what it stands in, or nothing."""
        return str(self.within[-1].get("properties", {}).get("kind", {}).get("const", ""))


def names() -> tuple[str, ...]:
    """Return every key and every kind that has an entry, sorted."""
    keys = {place.steps[-1] for place in _places()} | {place.kind for place in _places()}
    return tuple(sorted({*keys, *(effect.key for effect in EFFECTS)} - {"", "kind"}))


def entries(name: str) -> tuple[FieldRow, ...]:
    """Return what a name means: a key, a path such as ``geometry.h``, or a kind such as ``rcc``.

    In a path the names of a spec's own, and places in its lists, may stand as findings print them.
    Places of one meaning share an entry; there is none where the name means nothing.
    """
    whole = tuple(step for step in re.split(r"\.|\[\d*\]", name) if step)
    asked = tuple(step for step in whole if step != NAME)
    keys = [place for place in _places() if place.path[-1] != "kind"]
    ending = [place for place in keys if place.steps[-len(asked) :] == asked]
    found: dict[str, list[_Place]] = {}
    for place in _places():
        if place.path[-1] == "kind" and place.kind == name:
            found.setdefault(f"kind {place.schema.get('description')}", []).append(place)
    for place in ending or (place for place in keys if place.is_at(whole)):
        found.setdefault(str(place.schema.get("description")), []).append(place)
    effects = (_effect(each) for each in EFFECTS if name in (each.key, f"effects.{each.key}"))
    return (*(_entry(places) for places in found.values()), *effects)


def meaning(path: tuple[str | int, ...], kind: str) -> str:
    """Return what the key at a path of a design means, in a part of a kind if it has one."""
    for place in _places():
        own = len(place.path) == len(path) and place.kind in ("", kind)
        if own and all(a in (b, NAME, ITEM) for a, b in zip(place.path, path, strict=True)):
            return str(place.schema.get("description", ""))
    return ""


def _effect(effect: Effect) -> FieldRow:
    """Return the entry of an effect; what a scene has or has not is no choice."""
    is_choice = isinstance(effect, ModelEffect)
    can_go = is_choice or bool(effect.excludes)
    return FieldRow(
        path=f"effects.{effect.key}",
        also=(),
        kinds=(),
        text=(type(effect).__doc__ or "").partition("\n")[0].removesuffix("."),
        written="auto, on, off" if is_choice else "auto, off" if can_go else "auto",
        default="auto",
        required=False,
        keys=(),
        axes="",
        example=as_yaml({"effects": {effect.key: "off"}}, 2) if can_go else "",
    )


def _entry(places: list[_Place]) -> FieldRow:
    first = places[0]
    is_kind = first.path[-1] == "kind"
    path = first.path[:-1] if is_kind else first.path
    holder = first.within[-1]
    inner = holder if is_kind else next(_of_each(first.schema), {})
    keys = {k: v for k, v in inner.get("properties", {}).items() if k not in ("kind", "free")}
    where = sorted({_spoken(place.path[:-1] if is_kind else place.path) for place in places})
    kinds = () if is_kind else tuple(dict.fromkeys(filter(None, (p.kind for p in places))))
    return FieldRow(
        path=_spoken(path),
        also=tuple(each for each in where if each != _spoken(path)),
        kinds=kinds,
        text=str(first.schema.get("description", "")),
        written=f"kind: {first.kind}" if is_kind else _form(first.schema),
        default=str(first.schema.get("default", "")),
        required=not is_kind and first.path[-1] in holder.get("required", ()),
        keys=tuple(_key(k, each, k in inner.get("required", ())) for k, each in keys.items()),
        axes=AXES.get(first.kind, "") if path[0] == "geometry" else "",
        example=as_yaml(_snippet(first), len(path) + is_kind),
    )


def _key(name: str, schema: Mapping[str, Any], required: bool) -> KeyRow:
    default = str(schema.get("default", ""))
    return KeyRow(name, str(schema.get("description", "")), _form(schema), default, required)


def _spoken(path: tuple[str, ...]) -> str:
    return ".".join(path).replace(f".{ITEM}", ITEM)


@cache
def _design() -> dict[str, Any]:
    return json_schema("design")


@cache
def _places() -> tuple[_Place, ...]:
    """Return every key of a design; of a single case at the top, those below ``cases``."""
    cases = next(iter(_mappings(_design()["properties"]["cases"]["additionalProperties"])))
    return tuple(
        place for place in _below(_design(), (), ()) if place.path[0] not in cases["properties"]
    )


def _below(
    node: Mapping[str, Any], path: tuple[str, ...], within: tuple[Mapping[str, Any], ...]
) -> Iterator[_Place]:
    for inner in _meant(node):
        here = (*within, inner)
        for key, schema in inner.get("properties", {}).items():
            yield _Place((*path, key), schema, here)
            yield from _below(schema, (*path, key), here)
        for schema in _named(inner):
            if isinstance(schema, dict):
                yield from _below(schema, (*path, NAME), here)
        if isinstance(inner.get("items"), dict):
            yield from _below(inner["items"], (*path, ITEM), here)


def _meant(node: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """Yield what a value may be, through references and choices."""
    if "$ref" in node:
        yield from _meant(_design()["$defs"][node["$ref"].rpartition("/")[2]])
    for key in ("anyOf", "oneOf"):
        for choice in node.get(key, ()):
            yield from _meant(choice)
    if "type" in node or "enum" in node or "const" in node:
        yield node


def _mappings(node: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    return (inner for inner in _meant(node) if "properties" in inner)


def _named(node: Mapping[str, Any]) -> tuple[Any, ...]:
    """Return the schemas of what stands under names of a spec's own."""
    return (node.get("additionalProperties"), *node.get("patternProperties", {}).values())


def _of_each(node: Mapping[str, Any]) -> Iterator[Mapping[str, Any]]:
    """Yield the mappings that a value may be, or that each in a list or under a name may be."""
    yield from _mappings(node)
    for inner in _meant(node):
        for each in (*_named(inner), inner.get("items")):
            if isinstance(each, dict):
                yield from _mappings(each)


def _required(holder: Mapping[str, Any]) -> tuple[str, ...]:
    """Return the keys that a mapping must have, by the first of its choices."""
    first: Mapping[str, Any] = next(iter(holder.get("anyOf", ())), {})
    return (*holder.get("required", ()), *first.get("required", ()))


def _example(schema: Mapping[str, Any]) -> Any:
    """Return the example of a key, its own or that of the first thing it may be."""
    for node in (schema, *_meant(schema)):
        if "examples" in node:
            return node["examples"][0]
        if "const" in node:
            return node["const"]
    raise ValueError(f"no example in {schema}")


def _snippet(place: _Place) -> dict[str, Any]:
    """Return the part of a spec that shows a key in its place, with all that it needs."""
    value = _example(place.schema)
    for depth in range(len(place.path) - 1, -1, -1):
        step = place.path[depth]
        if step == ITEM:
            others = _example(_at(place, depth - 1))
            value = _among(others, value, BESIDE in place.schema)
        elif step == NAME:
            others = _example(_at(place, depth - 1))
            value = {**others, next(iter(others)): value}
        elif depth:
            value = {**_beside(place, depth), step: value}
        else:
            value = {step: value, **_at(place, 0).get(BESIDE, {})}
    return dict(value)


def _among(others: list[Any], value: Any, exact: bool) -> list[Any]:
    """Return the example of a list with a value in the place of the one that is like it."""
    like = [i for i, each in enumerate(others) if not exact or set(each) == set(value)]
    return [*others[: like[0]], value, *others[like[0] + 1 :]] if like else [value]


def _beside(place: _Place, depth: int) -> dict[str, Any]:
    """Return what stands beside a step of a path: what it needs, or the example around it."""
    holder, schema = place.within[depth], _at(place, depth)
    keys = holder["properties"]
    if BESIDE in schema:
        needed, more = holder.get("required", ()), schema[BESIDE]
    else:
        needed, more = _required(holder), keys.get("kind", {}).get(BESIDE, {})
        around = _around(place, depth)
        is_same = isinstance(around, dict) and around.get("kind") == keys.get("kind", {}).get(
            "const"
        )
        if is_same and place.path[depth] not in ALONE:
            more = around
    found = {key: _example(keys[key]) for key in needed if key not in more} | more
    first = {"kind": found["kind"]} if "kind" in found else {}
    return {**first, **found}


def _around(place: _Place, depth: int) -> Any:
    """Return the example of the mapping that a step stands in, where it is more than a list."""
    if (depth == 1 and place.path[0] in SECTIONS) or (
        place.path[:2] == ("cases", NAME) and depth == 2
    ):
        return None
    if place.path[depth - 1] == ITEM:
        return _example(_at(place, depth - 2))[0]
    if place.path[depth - 1] == NAME:
        return next(iter(_example(_at(place, depth - 2)).values()))
    return _example(_at(place, depth - 1))


def _at(place: _Place, depth: int) -> Mapping[str, Any]:
    """Return the schema of a step of a path."""
    found: Mapping[str, Any] = place.within[depth]["properties"][place.path[depth]]
    return found


def _form(schema: Mapping[str, Any]) -> str:
    """Return in words how a value is written."""
    if "$ref" in schema:
        return _form(_design()["$defs"][schema["$ref"].rpartition("/")[2]])
    title = schema.get("title", "")
    if title:
        return _titled(title)
    if "properties" in schema:
        return "a mapping"
    choices = [_form(choice) for key in ("anyOf", "oneOf") for choice in schema.get(key, ())]
    if choices:
        return " or ".join(dict.fromkeys(filter(None, choices)))
    if "const" in schema:
        return str(schema["const"])
    if "enum" in schema:
        return ", ".join(map(str, schema["enum"]))
    if "items" in schema:
        return f"a list, each {_form(schema['items'])}"
    if "prefixItems" in schema:
        return f"[{', '.join(_form(each) for each in schema['prefixItems'])}]"
    if schema.get("type") == "object":
        return "a mapping by names of your own"
    return _TYPES[schema["type"]]


_TYPES = {
    "string": "a text",
    "integer": "a whole number",
    "number": "a number",
    "boolean": "true or false",
    "null": "null",
    "array": "a list",
}


def _titled(title: str) -> str:
    """Return how a quantity is written, with its units, or that a shipped spec is named."""
    if title.startswith("shipped "):
        return f"the name of a {title}, or a path"
    if title == "table":
        return "the path of a table, or one with its units and column"
    named = max((d for d in DIMENSIONS if title.startswith(d)), key=len)
    units = ", ".join(filter(None, DIMENSIONS[named].units))
    return f"{title} (in {units})" if units else title
