"""A quantity that a spec gives, or leaves free to be chosen, with bounds if any."""

from typing import Any, NamedTuple

from pydantic import GetJsonSchemaHandler
from pydantic_core import CoreSchema

from flexcli.parts.base import QuantityOf, or_free, spec_error
from flexcli.units import DIMENSIONS

__all__ = ["Free", "OrFree"]


class Free(NamedTuple):
    """The meaning of ``free`` or ``{free: [least, most]}``: bounds in SI, None for no bound."""

    least: float | None = None
    most: float | None = None


class OrFree(QuantityOf):
    """A type marker: a quantity, ``free``, or ``{free: [least, most]}``, as for h, l and b."""

    def __get_pydantic_json_schema__(
        self, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        return or_free(self)

    def read(self, value: Any) -> Any:
        """Return the SI value or the free range, or raise what is wrong."""
        if value == "free":
            return Free()
        expected = DIMENSIONS[self.dimension]
        if not isinstance(value, dict):
            if isinstance(value, str) and value.strip().isalpha():
                text = f"'{value}' is not a number with a unit"
                raise spec_error(text, f"write {expected.example}, or free")
            return super().read(value)
        bounds = value.get("free")
        if set(value) != {"free"} or not isinstance(bounds, list) or len(bounds) != 2:
            example = expected.example
            raise spec_error(
                f"{expected.named}, 'free', or free between bounds is expected",
                f"write {example}, free, or {{free: [null, {example}]}} (null: no bound)",
            )
        least, most = (None if bound is None else self._bound(bound) for bound in bounds)
        if least is not None and most is not None and least >= most:
            raise spec_error("the lower bound is not below the upper one", "write [least, most]")
        return Free(least, most)

    def _bound(self, value: Any) -> float:
        return super().read(value)
