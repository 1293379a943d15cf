"""Manufacturing: what a process can make, as limits that a design is held to."""

from collections.abc import Iterator
from typing import Literal

import numpy as np
from pydantic import model_validator

from flexcli.formulas.quantity import Computed
from flexcli.parts.base import Part, PositiveLength, Ratio, spec_error
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.requirements import Limit
from flexcli.results import EXACT

__all__ = ["Manufacturing"]


class Manufacturing(Part):
    """How the flexure is made, and what the workshop states of it; nothing is implied."""

    process: Literal["wire-edm", "milling", "etching", "additive", "laser"] | None = None
    """What makes it, as the checks name it, e.g. ``wire-edm``."""
    least_thickness: PositiveLength | None = None
    """Thinnest section that can be made, e.g. ``60 um``."""
    least_radius: PositiveLength | None = None
    """Smallest inner radius: of fillets, of notches, and of roots in one piece with their bodies,
    which are sharp where no root_radius is stated, e.g. ``0.15 mm``."""
    least_gap: PositiveLength | None = None
    """Narrowest room between blades in one plane, e.g. ``0.3 mm``."""
    aspect: Ratio | None = None
    """Most width over thickness of a section, e.g. ``100``."""

    @model_validator(mode="after")
    def _states_a_limit(self) -> "Manufacturing":
        if self.least_thickness is self.least_radius is self.least_gap is self.aspect is None:
            raise spec_error(
                "no limit of the process is given", "give what the workshop states, e.g. 60 um",
                at=("least_thickness",),
            )  # fmt: skip
        return self

    def limits(self, geometry: Geometry, sizes: Sizes) -> Iterator[Limit]:
        """Yield what is stated against the sizes, which may be signomials."""
        given = all(isinstance(size, float | np.floating) for size in sizes)
        for name, h in _thicknesses(geometry, sizes, given):
            if self.least_thickness is not None:
                yield self._limit("least_thickness", name, self.least_thickness, h)
        if self.least_radius is not None:
            for name, radius in geometry.radii(sizes).items():
                yield self._limit("least_radius", name, self.least_radius, radius)
        if self.aspect is not None:
            for name, h, b in _sections(geometry, sizes, given):
                yield self._limit("aspect", name, b / h, self.aspect, "")
        if self.least_gap is not None and given:
            for name, room in geometry.clearances(sizes):
                yield self._limit("least_gap", name, self.least_gap, max(room, 0.0))

    def _limit(
        self, key: str, name: str, demand: Computed, capacity: Computed, unit: str = "m"
    ) -> Limit:
        of = f" of {name}" if name else ""
        return Limit(
            key.replace("_", " "), "", f"manufacturing.{key}{of}", demand, capacity, unit,
            self.process or "as stated", error=EXACT, path=("manufacturing", key),
        )  # fmt: skip


def _thicknesses(geometry: Geometry, sizes: Sizes, given: bool) -> Iterator[tuple[str, Computed]]:
    """Yield the thicknesses by name; of given sizes all that are drawn."""
    if given:
        yield from ((name, h) for name, h, _ in geometry.sections(sizes))
    else:
        yield from geometry.thicknesses(sizes).items()


def _sections(
    geometry: Geometry, sizes: Sizes, given: bool
) -> Iterator[tuple[str, Computed, Computed]]:
    """Yield name, thickness and width."""
    if given:
        yield from geometry.sections(sizes)
    elif hasattr(sizes, "b"):
        yield from ((name, h, sizes.b) for name, h in geometry.thicknesses(sizes).items())
