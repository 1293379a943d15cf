"""The JSON Schema of each kind of spec file."""

from typing import Any

from pydantic import TypeAdapter

from flexcli.parts.design import CASE_KEYS, DesignSpec
from flexcli.spec.load import KINDS as PARTS

__all__ = ["KINDS", "json_schema"]

KINDS = ("design", *PARTS)


def json_schema(kind: str) -> dict[str, Any]:
    """Return the JSON Schema (2020-12) of a file of a kind."""
    if kind != "design":
        schema = TypeAdapter(PARTS[kind]).json_schema(by_alias=True)
        definitions = schema.pop("$defs", {})
        return {
            "$schema": "https://json-schema.org/draft/2020-12/schema",
            "type": "object",
            "properties": {"flexure": {"const": 1}, kind: schema},
            "required": ["flexure", kind],
            "additionalProperties": False,
            "$defs": definitions,
        }
    schema = DesignSpec.model_json_schema(by_alias=True)
    case = schema["$defs"]["Case"]["properties"]
    schema["properties"].update({key: case[key] for key in CASE_KEYS})
    schema["required"] = [key for key in schema["required"] if key != "cases"]
    by_name = {"type": "string", "description": "name of a shipped spec, or a path ending in .yaml"}
    for key in ("material", "geometry", "stroke"):
        schema["properties"][key] = {"anyOf": [schema["properties"][key], by_name]}
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", **schema}
