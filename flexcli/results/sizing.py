"""Results of a sizing: designs, active requirements, sensitivities, conflicts."""

from collections.abc import Mapping
from dataclasses import dataclass
from typing import NamedTuple

__all__ = ["Design", "Relaxation", "Sensitivity", "SizingResult"]


class Design(NamedTuple):
    """One set of sizes [m] by their symbols, with its properties."""

    label: str
    sizes: Mapping[str, float]
    volume: float


class Sensitivity(NamedTuple):
    """Cost of 1 % more of one demand: d ln(name) / d ln(demand) for each quantity."""

    constraint: str
    driver: str
    on: Mapping[str, float]


class Relaxation(NamedTuple):
    """How far one requirement of a conflict must be relaxed for a design to exist."""

    name: str
    factor: float | None
    text: str


@dataclass(frozen=True, eq=False)
class SizingResult:
    """How the dimensions were found, and which requirements are active there."""

    objective: str
    certificate: str
    designs: tuple[Design, ...] = ()
    active: tuple[str, ...] = ()
    sensitivities: tuple[Sensitivity, ...] = ()
    conflict: tuple[Relaxation, ...] = ()
    remarks: tuple[str, ...] = ()
