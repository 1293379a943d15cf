"""The JSON Schema of each kind of spec file, from the parts that read it."""

from collections.abc import Iterator
from typing import Any

from pydantic import BaseModel, TypeAdapter
from pydantic.fields import FieldInfo
from pydantic.json_schema import GenerateJsonSchema, JsonSchemaValue
from pydantic_core import core_schema

from flexcli.parts.base import QuantityOf
from flexcli.parts.design import DesignSpec
from flexcli.parts.fields import key_of, note
from flexcli.spec.load import KINDS as PARTS
from flexcli.spec.parameters import DRAWN, NAMES
from flexcli.spec.parse import parse_document
from flexcli.spec.references import EXTENDS, FORMAT, REFERENCES
from flexcli.spec.shipped import shipped_names
from flexcli.units import written

__all__ = ["BESIDE", "KINDS", "json_schema"]

KINDS = ("design", *PARTS)
BESIDE = "beside"
"""Keyword for the keys that an example needs, for the manual."""
EXTENT = "#/$defs/Extent"
"""A size that may be free, in any geometry."""
DIALECT = "https://json-schema.org/draft/2020-12/schema"


def json_schema(kind: str) -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of a file of a kind.

    It accepts what the tool does, but for what depends on more than one value: the rules between
    keys, between parts and of mechanics.
    """
    model = DesignSpec if kind == "design" else PARTS[kind]
    schema = TypeAdapter(model).json_schema(by_alias=True, schema_generator=_Generator)
    definitions = schema.pop("$defs", {})
    for part in (schema, *definitions.values()):
        if EXTENDS in part.get("properties", {}):
            part["properties"][EXTENDS] = _or_named(part["properties"][EXTENDS], "material")
    if kind == "design":
        schema = _referring(schema, definitions)
        _let_parameters_in(schema["properties"]["geometry"], definitions)
    else:
        schema = {
            "type": "object",
            "properties": {"flexure": {"const": FORMAT}, kind: schema},
            "required": ["flexure", kind],
            "additionalProperties": False,
        }
    shared: dict[str, Any] = {}
    schema = _sharing({**schema, "$defs": definitions}, shared)
    schema["$defs"] |= shared
    return {"$schema": DIALECT, "$id": f"urn:flexcli:{kind}:{FORMAT}", **schema}


class _Generator(GenerateJsonSchema):
    """Pydantic's own, with what stands below each field, and without what YAML here has not."""

    def field_title_should_be_set(self, schema: Any) -> bool:
        """Leave out titles: they repeat the names of the fields."""
        return False

    def sort(self, value: JsonSchemaValue, parent_key: str | None = None) -> JsonSchemaValue:
        """Keep the order: keys and examples stand as a designer writes them."""
        return value

    def model_schema(self, schema: core_schema.ModelSchema) -> JsonSchemaValue:
        """Return the schema of a part with what its fields mean."""
        found = super().model_schema(schema)
        found.pop("title", None)
        model = schema["cls"]
        for name, info in model.model_fields.items():
            key = key_of(model, name)
            value = _given(found["properties"].pop(key))
            if value is not None:
                # what has a title keeps its own description
                found["properties"][key] = {"allOf": [value], **_about(model, name, info)}
        return found

    def default_schema(self, schema: core_schema.WithDefaultSchema) -> JsonSchemaValue:
        """Leave out defaults: they are numbers in SI, which a spec cannot write."""
        return self.generate_inner(schema["schema"])

    def dict_schema(self, schema: core_schema.DictSchema) -> JsonSchemaValue:
        """Refuse names that do not follow the pattern of a mapping's names."""
        found = super().dict_schema(schema)
        return {**found, "additionalProperties": False} if "patternProperties" in found else found

    def tagged_union_schema(self, schema: core_schema.TaggedUnionSchema) -> JsonSchemaValue:
        """Leave out OpenAPI's discriminator: each choice has its constant ``kind``."""
        found = super().tagged_union_schema(schema)
        found.pop("discriminator", None)
        return found


def _given(schema: dict[str, Any]) -> dict[str, Any] | None:
    """Return the schema of a field that is given, nothing where it cannot be.

    A key without a value is a mistake.
    """
    if schema.get("type") == "null":
        return None
    choices = [each for each in schema.get("anyOf", ()) if each != {"type": "null"}]
    if len(choices) == 1:
        return {**{k: v for k, v in schema.items() if k != "anyOf"}, **choices[0]}
    return {**schema, "anyOf": choices} if choices else schema


def _about(model: type[BaseModel], name: str, info: FieldInfo) -> dict[str, Any]:
    """Return what a field means, its example and its default."""
    key, said = key_of(model, name), note(model, name)
    about: dict[str, Any] = {}
    if name == "kind":
        about["description"] = (model.__doc__ or "").partition("\n")[0].removesuffix(".")
    if said.text:
        about["description"] = said.text
    if said.example:
        lines = said.example.startswith(f"{key}:")
        text = f"{{{said.example}}}" if lines else f"{key}: {said.example}"
        beside = parse_document(text, "").value
        about["examples"] = [beside.pop(key)]
        if lines:
            about[BESIDE] = beside
    default = _written(info)
    return about if default in (None, "") else {**about, "default": default}


def _written(info: FieldInfo) -> Any:
    """Return a default as a spec would write it, nothing where there is none to write."""
    if isinstance(info.default, bool | str | int):
        return info.default
    quantity = next((each for each in info.metadata if isinstance(each, QuantityOf)), None)
    if isinstance(info.default, float) and quantity is not None:
        return written(info.default, quantity.dimension)
    return None


def _referring(schema: dict[str, Any], definitions: dict[str, Any]) -> dict[str, Any]:
    """Return a design's schema in which a spec may be named where the tool takes its name."""

    def put(node: Any, path: tuple[str, ...], kind: str) -> None:
        for inner in _alternatives(node, definitions):
            if path[0] == "*":
                # names of one's own may have to look like a name
                named = inner.get("patternProperties", {}).values()
                for each in named or (inner["additionalProperties"],):
                    put(each, path[1:], kind)
            elif path[0] in inner.get("properties", {}):
                here = inner["properties"]
                if path[1:]:
                    put(here[path[0]], path[1:], kind)
                elif _NAMED not in here[path[0]].get("anyOf", ()):
                    here[path[0]] = _or_named(here[path[0]], kind)

    for path, kind in REFERENCES.items():
        put(schema, path, kind)
    return schema


def _let_parameters_in(geometry: dict[str, Any], definitions: dict[str, Any]) -> None:
    """Let sums and products of parameters stand for the sizes of what is drawn."""
    for drawn in _alternatives(geometry, definitions):
        (kind,) = drawn["properties"]["kind"]["allOf"]
        if kind.get("const") in DRAWN:
            _let_expressions_in(drawn, definitions, set())


def _let_expressions_in(node: Any, definitions: dict[str, Any], done: set[str]) -> None:
    """Let expressions stand for every quantity below a node; what others share stays as it is."""
    expression = {"type": "string", "pattern": NAMES}
    for key, inner in list(node.items() if isinstance(node, dict) else enumerate(node)):
        if key == "$ref" and inner == EXTENT:
            node["anyOf"] = [{"$ref": node.pop("$ref")}, expression]
        elif key == "$ref" and inner not in done:
            done.add(inner)
            _let_expressions_in(definitions[inner.rpartition("/")[2]], definitions, done)
        elif isinstance(inner, dict) and "patternErrorMessage" in inner:
            about = {k: inner[k] for k in ("description", "title", "examples") if k in inner}
            inner.pop("title", None)
            if "title" in about:
                about["title"] += ", or of parameters"
            node[key] = {**about, "anyOf": [inner, expression]}
        elif isinstance(inner, dict | list):
            _let_expressions_in(inner, definitions, done)


_NAMED = {"type": "string", "pattern": r"\S"}


def _or_named(schema: dict[str, Any], kind: str) -> dict[str, Any]:
    about: dict[str, Any] = {k: schema[k] for k in ("description", "examples") if k in schema}
    rest = {k: v for k, v in schema.items() if k not in about}
    rest = rest["allOf"][0] if "allOf" in rest else rest
    shipped: dict[str, Any] = {"enum": list(shipped_names(kind)), "title": f"shipped {kind}"}
    return {**about, "anyOf": [shipped, _NAMED, rest]}


def _alternatives(node: Any, definitions: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Yield the objects that a node may be, through references and choices."""
    if "$ref" in node:
        yield from _alternatives(definitions[node["$ref"].rpartition("/")[2]], definitions)
    for key in ("allOf", "anyOf", "oneOf"):
        for inner in node.get(key, ()):
            yield from _alternatives(inner, definitions)
    if node.get("type") == "object":
        yield node


def _sharing(node: Any, shared: dict[str, Any]) -> Any:
    """Return a schema in which what has a title is written once, among the definitions."""
    if isinstance(node, list):
        return [_sharing(each, shared) for each in node]
    if not isinstance(node, dict):
        return node
    found = {key: _sharing(value, shared) for key, value in node.items()}
    if isinstance(title := found.get("title"), str):
        name = title.replace(" ", "-").replace(",", "")
        shared[name] = found
        return {"$ref": f"#/$defs/{name}"}
    return {**found.pop("allOf")[0], **found} if "allOf" in found else found
