"""The numbers of a design that differ from part to part, and the design of one part."""

from collections.abc import Sequence
from math import inf, log
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray
from pydantic_core import PydanticCustomError

from flexcli.errors import NoSolution, SolveError
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.own_blades import OwnBlades, blade_names
from flexcli.parts.tolerances import Spread, place_of, with_number
from flexcli.units import DIMENSIONS

__all__ = ["Variation", "as_made", "variations"]

Floats = NDArray[np.float64]

DOMAIN = 4.5
"""Standard deviations to which designs are judged of a normal spread; one part in 150 000 lies
beyond."""

NEAREST = 0.05
"""Share of the nominal below which no part is judged."""


DRAWN = ("layout", "linkage")
"""Kinds of joints whose blades have sizes of their own in the spec."""


class Variation(NamedTuple):
    """One number that differs: its tolerance, where it stands, nominal value and spread [SI].

    ``blade`` is the one it is of, where each differs by itself.
    """

    name: str
    tolerance: str
    path: tuple[str | int, ...]
    unit: str
    nominal: float
    spread: Spread
    blade: str = ""

    @property
    def domain(self) -> tuple[float, float]:
        """Return between which values designs are judged."""
        low, high = self.spread.low, self.spread.high
        if self.spread.kind == "normal":
            low, high = -DOMAIN * self.spread.sigma, DOMAIN * self.spread.sigma
        low, high = self.nominal + low, self.nominal + high
        return (max(low, NEAREST * self.nominal) if self.nominal > 0.0 else low), high

    @property
    def least(self) -> float:
        """Return a value below all that are judged, where a part is taken to be at least."""
        low = self.domain[0]
        return 0.5 * low if low > 0.0 else -inf

    @property
    def width(self) -> float:
        """Return by how much the scaled variable changes for a relative change at nominal."""
        low, high = self.domain
        if low > 0.0:
            return 2.0 / log(high / low)
        return 2.0 * abs(self.nominal) / (high - low)

    def made(self, deviation: Floats) -> Floats:
        """Return the numbers of parts by their deviation from the nominal, at least ``least``."""
        return np.asarray(np.maximum(self.nominal + deviation, self.least))

    def scale(self, x: Floats) -> Floats:
        """Return values as a variable that is −1 and 1 at the ends of the domain.

        It is linear in the logarithm where the number has one: laws of powers are straight in it.
        """
        low, high = self.domain
        if low > 0.0:
            return np.asarray(2.0 * np.log(x / low) / np.log(high / low) - 1.0)
        return np.asarray(2.0 * (x - low) / (high - low) - 1.0)

    def value(self, u: Floats) -> Floats:
        """Return the values of that variable."""
        low, high = self.domain
        share = (np.asarray(u) + 1.0) / 2.0
        if low > 0.0:
            return np.asarray(low * (high / low) ** share)
        return np.asarray(low + (high - low) * share)


def variations(design: DesignSpec) -> tuple[Variation, ...]:
    """Return what differs from part to part in a design whose sizes are given.

    Raises
    ------
    SolveError
        Where blades shall differ that cannot be drawn each by itself.

    """
    found: list[Variation] = []
    for name, tolerance in design.tolerances.items():
        place = place_of(design, name)
        assert place.value is not None  # a design with sizes
        try:
            spread = tolerance.spread(place.dimension, place.value)
        except PydanticCustomError as error:  # of a size that was chosen since the spec was read
            context = error.context or {}
            raise NoSolution(
                "tolerance-too-wide",
                f"{name} is {place.value:.3g} {DIMENSIONS[place.dimension].si} as chosen: "
                f"{context.get('text', error)}",
                f"narrow the tolerance of {name}, or bound it from below",
            ) from None
        unit = DIMENSIONS[place.dimension].si
        one = Variation(name, name, place.path, unit, place.value, spread)
        blades = ("",) if tolerance.each == "part" else _blades(design, name)
        found += [
            one._replace(name=f"{name} of {blade}" if blade else name, blade=blade)
            for blade in blades
        ]
    return tuple(found)


def _blades(design: DesignSpec, name: str) -> tuple[str, ...]:
    geometry = design.geometry
    try:
        names = () if geometry.name in DRAWN else blade_names(geometry)
        reason = "has blades with names of their own"
    except NotAvailable as error:
        names, reason = (), str(error)
    if not names:
        raise SolveError(
            "no-blades-of-their-own",
            f"{name} cannot differ from blade to blade: a {geometry.name} {reason}",
            "leave each: blade out, or draw a layout and give each of its blades a tolerance",
        )
    return names


def as_made(design: DesignSpec, each: Sequence[Variation], values: Sequence[float]) -> DesignSpec:
    """Return the design of a part whose numbers have these values [SI]."""
    own = []
    for variation, value in zip(each, values, strict=True):
        if variation.blade:
            own.append((variation, value))
        else:
            design = with_number(design, variation.path, value)
    if not own:
        return design
    joints: dict[str, Any] = {}
    for (_, _, (_, *path), *_, blade), value in own:
        joints[blade] = with_number(joints.get(blade, design.geometry), tuple(path), value)
    drawn = OwnBlades.model_construct(whole=design.geometry, each=joints)
    return design.model_copy(update={"geometry": drawn})
