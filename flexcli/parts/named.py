"""Parts by their names: a class is imported, and its schema built, when a spec first uses it."""

from collections.abc import Iterable, Mapping
from functools import partial
from importlib import import_module
from typing import Annotated, Any

from pydantic import BaseModel, GetCoreSchemaHandler, GetJsonSchemaHandler
from pydantic_core import CoreSchema, core_schema

__all__ = ["Kinds", "Named", "marked", "part_class"]


def marked(annotation: Any, metadata: Iterable[Any]) -> Any:
    """Return an annotation together with the marker that gives its classes, if it has one."""
    for marker in metadata:
        if isinstance(marker, Kinds | Named):
            return Annotated[annotation, marker]
    return annotation


def part_class(path: str) -> type[BaseModel]:
    """Return the class of a path such as ``flexcli.parts.shock:Shock``."""
    module, _, name = path.partition(":")
    found: type[BaseModel] = getattr(import_module(module), name)
    return found


def _read(path: str, value: Any) -> BaseModel:
    return part_class(path).model_validate(value)


def _full_schema(path: str) -> CoreSchema:
    found = part_class(path)
    found.model_rebuild()
    return found.__pydantic_core_schema__


class Named:
    """A type marker: a part of a class that is imported when a spec uses it."""

    def __init__(self, path: str) -> None:
        self.path = path

    @property
    def classes(self) -> tuple[type[Any], ...]:
        """Return the class, alone."""
        return (part_class(self.path),)

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.no_info_plain_validator_function(partial(_read, self.path))

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        # around the part, so that it stands among the definitions under its own name
        return handler(core_schema.definitions_schema(_full_schema(self.path), []))


class Kinds:
    """A type marker: a part whose ``kind`` says its class, imported when a spec names it.

    ``paths`` are those of the classes, such as ``flexcli.parts.geometries.rcc:RCCPivot``, by kind.
    """

    def __init__(self, paths: Mapping[str, str]) -> None:
        self.paths = dict(paths)

    @property
    def by_kind(self) -> dict[str, Any]:
        """Return the class of every kind."""
        return {kind: part_class(path) for kind, path in self.paths.items()}

    @property
    def classes(self) -> tuple[type[Any], ...]:
        """Return the classes of all kinds."""
        return tuple(self.by_kind.values())

    def __get_pydantic_core_schema__(
        self, source: Any, handler: GetCoreSchemaHandler
    ) -> CoreSchema:
        return core_schema.tagged_union_schema(
            {
                kind: core_schema.no_info_plain_validator_function(partial(_read, path))
                for kind, path in self.paths.items()
            },
            discriminator="kind",
        )

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        each = {kind: _full_schema(path) for kind, path in self.paths.items()}
        return handler(core_schema.tagged_union_schema(each, discriminator="kind"))
