"""Drawings whose sizes follow free parameters: the drawing at given values."""

from abc import ABC, abstractmethod
from collections import namedtuple
from collections.abc import Iterator, Mapping
from math import sqrt
from typing import Any, Self

import numpy as np
from pydantic import ModelWrapValidatorHandler, PrivateAttr, ValidationError, model_validator

from flexcli.formulas.quantity import Quantity
from flexcli.parts.base import Part
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Extent, Geometry, Sizes

__all__ = ["DRAWING", "Drawn", "Follows"]

DRAWING = "follows"
"""Key under which a drawing receives its free parameters; no spec can contain it."""


class Follows(ABC):
    """The dependence of a drawing on its free parameters."""

    extents: Mapping[str, Extent]
    """Their ranges by name."""
    dimensions: Mapping[str, str]
    """Their dimensions."""

    @abstractmethod
    def at(self, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the drawing at values [SI], as a spec writes it."""

    @abstractmethod
    def numbers(self, values: Mapping[str, Any]) -> Iterator[tuple[tuple[str | int, ...], Any]]:
        """Yield its numbers [SI] at values of one or of many designs, and their paths."""


class Drawn(Geometry):
    """A geometry drawn in the spec, with sizes of its own and possibly free parameters.

    A drawing with free parameters stands in the middle of their ranges; :meth:`drawn` gives it at
    other values.
    """

    _follows: Follows | None = PrivateAttr(None)
    _last: tuple[Sizes, tuple[Geometry, Sizes]] | None = PrivateAttr(None)
    _middle: Geometry | None = PrivateAttr(None)

    @model_validator(mode="wrap")
    @classmethod
    def _told(cls, data: Any, handler: ModelWrapValidatorHandler[Self]) -> Self:
        follows = data.get(DRAWING) if isinstance(data, dict) else None
        if not isinstance(follows, Follows):
            return handler(data)
        found = handler({key: value for key, value in data.items() if key != DRAWING})
        found._follows = follows
        return found

    def __copy__(self) -> Self:
        """Return a copy, which may be given other parts: it has drawn nothing yet."""
        copied = super().__copy__()
        copied._last = copied._middle = None
        return copied

    @property
    def parameters(self) -> Mapping[str, Extent]:
        """Return the ranges of its free parameters."""
        return self._follows.extents if self._follows is not None else {}

    @property
    @abstractmethod
    def drawn_extents(self) -> dict[str, Extent]:
        """Return the thicknesses by symbol and name of what has them."""

    @abstractmethod
    def drawn_label(self, name: str) -> str:
        """Return the name of a thickness, in words."""

    @property
    def extents(self) -> dict[str, Extent]:
        """Return the extents of thicknesses and free parameters."""
        own = self.drawn_extents
        if self._follows is None:
            return own
        return {**self.parameters, **{n: each for n, each in own.items() if each.fixed is None}}

    def label(self, name: str) -> str:
        """Return the name of a size, in words."""
        return f"parameter {name}" if name in self.parameters else self.drawn_label(name)

    def dimension(self, name: str) -> str:
        """Return the dimension of a size."""
        if self._follows is None:
            return super().dimension(name)
        return self._follows.dimensions.get(name, super().dimension(name))

    def place(self, name: str) -> tuple[str, ...]:
        """Return where a size stands in the spec."""
        return ("parameters", name) if name in self.parameters else self.drawn_place(name)

    def drawn_place(self, name: str) -> tuple[str, ...]:
        """Return the place of a thickness in the spec."""
        return super().place(name)

    def sized(self, values: Mapping[str, Quantity]) -> Sizes:
        """Return the sizes; a fixed one keeps its value."""
        found = {name: values.get(name, extent.fixed) for name, extent in self.extents.items()}
        return namedtuple("DrawnSizes", found)(**found)

    def probe(self) -> Sizes:
        """Return sizes for validating requirements: the middle of each range."""
        usual = super().probe()
        middle = {
            name: sqrt(extent.least * extent.most)
            for name, extent in self.parameters.items()
            if extent.least is not None and extent.most is not None
        }
        return usual._replace(**middle)

    def drawn(self, sizes: Sizes) -> tuple[Geometry, Sizes]:
        """Return the drawing at values of its free parameters, and its own sizes.

        Raises
        ------
        NotAvailable
            Where it cannot be drawn: a blade without length, or thicker than wide.

        """
        if self._follows is None:
            return self, sizes
        last = self._last
        if last is None or last[0] is not sizes:  # all requirements ask for the same
            drawing = self._at(self._follows, sizes)
            own = {name: getattr(sizes, name) for name in drawing.free}
            last = self._last = sizes, (drawing, drawing.sized(own))
        return last[1]

    def in_the_middle(self) -> Geometry:
        """Return the drawing in the middle of the ranges of its free parameters.

        Raises
        ------
        NotAvailable
            Where it cannot be drawn.

        """
        if self._follows is None:
            return self
        if self._middle is None:
            self._middle = self._at(self._follows, self.probe())
        return self._middle

    def _at(self, follows: Follows, sizes: Sizes) -> Self:
        values = {name: getattr(sizes, name) for name in follows.extents}
        if any(np.ndim(value) for value in values.values()):
            drawing = self.model_copy()
            drawing._follows = None
            for place, number in follows.numbers(values):
                drawing = _replaced(drawing, place, number)
            return drawing
        try:
            return type(self).model_validate(follows.at(values))
        except ValidationError as error:
            first = error.errors()[0]
            where = ".".join(map(str, first["loc"]))
            raise NotAvailable(f"cannot be drawn there: {where} {first['msg']}") from error


def _replaced(part: Any, place: tuple[str | int, ...], number: Any) -> Any:
    """Return a part with one number replaced, which may be that of many designs."""
    if not place:
        fixed = isinstance(part, Extent)
        return Extent.model_construct(fixed=number, least=None, most=None) if fixed else number
    step, rest = place[0], place[1:]
    if isinstance(part, Part):
        fields = type(part).model_fields.items()
        name = next(name for name, field in fields if step in (name, field.alias))
        return part.model_copy(update={name: _replaced(getattr(part, name), rest, number)})
    if isinstance(part, Mapping):
        return {**part, step: _replaced(part[step], rest, number)}
    assert isinstance(step, int)
    return (*part[:step], _replaced(part[step], rest, number), *part[step + 1 :])
