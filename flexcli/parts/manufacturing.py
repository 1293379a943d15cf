"""Manufacturing: what a process can make, as limits that a design is held to."""

from collections.abc import Iterator
from typing import Annotated, Literal

import numpy as np
from pydantic import Field, model_validator

from flexcli.formulas.quantity import Computed
from flexcli.numerics.signomial import Signomial
from flexcli.parts.base import Length, Part, PositiveLength, QuantityOf, Ratio, spec_error
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.requirements import Limit
from flexcli.results import EXACT
from flexcli.results.drawing import DrawnCut

__all__ = ["Manufacturing"]

Outline = Annotated[tuple[tuple[Length, Length], ...], Field(min_length=3)]


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
    wire: PositiveLength | None = None
    """Diameter of the wire, which no gap is narrower and half of which no inner radius is smaller
    than, e.g. ``0.25 mm``."""
    spark_gap: Annotated[float, QuantityOf("length", at_least=0.0)] | None = None
    """What sparks take away on each side of the wire,
    e.g. ``spark_gap: 20 um, process: wire-edm, wire: 0.25 mm``.
    """
    slot: PositiveLength | None = None
    """Width of the slots that ``flexure export`` frees blades and bodies by; left out, the
    narrowest that can be made, e.g. ``slot: 0.5 mm, process: wire-edm, wire: 0.25 mm``.
    """
    outlines: dict[str, Outline] = Field({})
    """Corners of bodies, and of the plate by the name of the ground, in the axes of ``flexure
    draw``; the others are plain blocks, e.g. ``{ground: [[-20 mm, -5 mm], [20 mm, -5 mm],
    [20 mm, 30 mm], [-20 mm, 30 mm]]}``."""

    @model_validator(mode="after")
    def _states_a_limit(self) -> "Manufacturing":
        stated = (self.least_thickness, self.least_radius, self.least_gap, self.aspect, self.wire)
        if all(limit is None for limit in stated):
            raise spec_error(
                "no limit of the process is given", "give what the workshop states, e.g. 60 um",
                at=("least_thickness",),
            )  # fmt: skip
        for key in ("wire", "spark_gap", "slot"):
            if getattr(self, key) is not None and self.process != "wire-edm":
                raise spec_error(f"{key} is of a cut by wire", "write process: wire-edm", at=(key,))
        if self.spark_gap is not None and self.wire is None:
            raise spec_error(
                "a spark gap is beside a wire", "give wire, e.g. 0.25 mm", at=("wire",)
            )
        if self.slot is not None and self.gap is None:
            raise spec_error(
                "no wire is given to cut a slot", "give wire, e.g. 0.25 mm", at=("wire",)
            )
        if self.slot is not None and self.gap is not None and self.slot < self.gap:
            raise spec_error(
                f"a slot is narrower than what can be made, {self.gap * 1e3:.4g} mm",
                "widen it, or leave it out", at=("slot",),
            )  # fmt: skip
        return self

    @property
    def kerf(self) -> float | None:
        """Return the width of a single cut of the wire [m]."""
        return None if self.wire is None else self.wire + 2.0 * (self.spark_gap or 0.0)

    @property
    def gap(self) -> float | None:
        """Return the narrowest room that can be made [m]."""
        return _largest(self.least_gap, self.kerf)

    @property
    def radius(self) -> float | None:
        """Return the smallest inner radius that can be made [m]."""
        return _largest(self.least_radius, None if self.kerf is None else self.kerf / 2.0)

    def cut(self) -> DrawnCut | None:
        """Return how slots are cut by a wire, where it is stated what it can make."""
        if self.process != "wire-edm" or self.gap is None:
            return None
        radius = self.radius if self.radius is not None else self.gap / 2.0
        slot = max(self.slot or self.gap, 2.0 * radius)
        return DrawnCut(slot, self.gap, radius, self.outlines)

    def limits(self, geometry: Geometry, sizes: Sizes) -> Iterator[Limit]:
        """Yield what is stated against the sizes, which may be signomials."""
        given = all(isinstance(size, float | np.floating) for size in sizes)
        for name, h in _thicknesses(geometry, sizes, given):
            if self.least_thickness is not None:
                yield self._limit("least_thickness", name, self.least_thickness, h)
        if self.radius is not None:
            for name, radius in geometry.radii(sizes).items():
                yield self._limit("least_radius", name, self.radius, radius)
        if self.aspect is not None:
            for name, h, b in _sections(geometry, sizes, given):
                yield self._limit("aspect", name, b / h, self.aspect, "")
        if self.gap is not None:
            for name, room in geometry.clearances(sizes):
                yield self._limit("least_gap", name, self.gap, _at_least_none(room))

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


def _at_least_none(room: Computed) -> Computed:
    """Return what is left where blades overlap: nothing."""
    return room if isinstance(room, Signomial) else np.maximum(room, 0.0)[()]


def _largest(*limits: float | None) -> float | None:
    return max((limit for limit in limits if limit is not None), default=None)
