"""Damping of modes: one quality factor, or one for each mode."""

from typing import Annotated, Any, ClassVar

from pydantic import Field, GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.base import QuantityOf, Shorthand, spec_error

__all__ = ["Quality"]

_Q = Annotated[float, QuantityOf("ratio", at_least=0.5)]


class Quality(Shorthand):
    """Quality factor Q of all modes, and of some by their number."""

    stands_for: ClassVar[str] = "all"

    all: _Q
    """Q of all the other modes, e.g. ``50``."""
    modes: dict[Annotated[int, Field(ge=1)], _Q] = Field(default_factory=dict)
    """Q of modes by their number, as asd response counts them, e.g. ``{1: 80}``."""

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        found = super().__get_pydantic_json_schema__(schema, handler)
        plain, whole = found["anyOf"]
        # names of modes are numbers, which a schema of names can say by a pattern alone
        modes = whole["properties"]["modes"]
        named = {
            "type": "object",
            "patternProperties": {r"^[1-9][0-9]*$": plain},
            "additionalProperties": False,
        }
        about = {key: modes[key] for key in ("description", "examples") if key in modes}
        properties = {**whole["properties"], "modes": {**named, **about}}
        return {"anyOf": [plain, {**whole, "properties": properties}]}

    @model_validator(mode="before")
    @classmethod
    def _modes_are_numbers(cls, data: Any) -> Any:
        modes = data.get("modes", {}) if isinstance(data, dict) else {}
        if not isinstance(modes, dict) or not all(str(key).isdigit() for key in modes):
            raise spec_error("modes are numbers from 1 on", "write modes: {1: 80}", at=("modes",))
        return data

    @property
    def largest(self) -> float:
        """Return the largest quality factor of any mode."""
        return max(self.all, *self.modes.values()) if self.modes else self.all

    @property
    def told(self) -> str:
        """Return the quality factors in words."""
        own = ", ".join(f"{q:g} of mode {n}" for n, q in sorted(self.modes.items()))
        return f"Q = {self.all:g}" + (f" ({own})" if own else "")
