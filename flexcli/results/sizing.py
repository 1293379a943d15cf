"""How the dimensions of a design were found."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

__all__ = ["Design", "Relaxation", "Sensitivity", "SizingResult"]


class Design(NamedTuple):
    """One set of sizes [m] by their symbols, and what it is."""

    label: str
    sizes: Mapping[str, float]
    volume: float


class Sensitivity(NamedTuple):
    """What 1 % more of one demand costs: d ln(name) / d ln(demand) for each quantity."""

    constraint: str
    driver: str
    on: Mapping[str, float]


class Relaxation(NamedTuple):
    """How far one requirement of a conflict must give way for a design to exist."""

    name: str
    factor: float | None
    text: str


@dataclass(frozen=True, eq=False)
class SizingResult:
    """How the dimensions were found, and what holds them there."""

    objective: str
    certificate: str
    designs: tuple[Design, ...] = ()
    active: tuple[str, ...] = ()
    sensitivities: tuple[Sensitivity, ...] = ()
    conflict: tuple[Relaxation, ...] = ()
    remarks: tuple[str, ...] = ()
