"""Rows of a sizing: demand ≤ capacity over the free dimensions, and how a spec states them."""

from collections.abc import Mapping
from dataclasses import dataclass
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal
from typing import NamedTuple

from flexcli.engine.sizing.problem import SizingProblem
from flexcli.formulas.quantity import Computed, Quantity
from flexcli.parts.requirements import Limit
from flexcli.units import DIMENSIONS, show

__all__ = ["ONE", "Row", "Term", "rows_of", "size_of"]

DIGITS = 4
"""Significant digits of a proposed relaxation, rounded to the side that does."""

LEEWAY = 1e-9
"""Relative noise of a solve: what a proposal is eased by before it is rounded."""

ONE = "one"
"""Key of the row that is one whatever the sizes are."""


class Term(NamedTuple):
    """One row as a program uses it: ``sign · ln(demand/capacity) + shift ≤ Σ power · ln(ease)``.

    As an objective the left side minus the right is what becomes least. ``eases`` are further
    unknowns of the program beside the sizes, each with its power.
    """

    key: str
    sign: float = 1.0
    shift: float = 0.0
    eases: tuple[tuple[str, float], ...] = ()


@dataclass(frozen=True)
class Row:
    """A row ``demand ≤ capacity`` and what it stands for: a limit, a bound, or a quantity."""

    name: str
    demand: Computed
    capacity: Computed
    limit: Limit | None = None
    bound: float = 0.0
    unit: str = "m"

    @property
    def is_target(self) -> bool:
        """Return whether demand and capacity shall be equal."""
        return self.limit is not None and self.limit.tolerance is not None

    @property
    def requirement(self) -> tuple[object, ...]:
        """Return what rows have in common that the spec states once: both ends, signs and axes."""
        limit = self.limit
        if limit is None:
            return (self.name,)
        stated = [s for s in (limit.demand, limit.capacity) if isinstance(s, float)]
        return limit.name, limit.required, *(stated if limit.is_bound else ())

    @property
    def power(self) -> int:
        """Return the power that demand and capacity are given raised to."""
        return self.limit.power if self.limit is not None else 1

    @property
    def driver(self) -> str:
        """Return what the demand of the row grows with."""
        if self.limit is None:
            return "bound"
        return self.limit.driver or ("target" if self.limit.tolerance is not None else "bound")

    def relaxed(self, ratio: float, *, upward: bool) -> str:
        """Return what would do if this row alone gave way, as the spec states it.

        ``ratio`` > 1 is on its utilisation; a target moves ``upward`` or down.
        """
        ratio = ratio ** (1.0 / self.power)
        limit = self.limit
        if limit is None:
            new = self._given_way(self.bound, ratio, upward=not self.name.startswith("least"))
            return f"bound {show(self.bound, self.unit)} → {show(new, self.unit)}"
        if limit.is_bound:
            side = limit.demand if limit.variant == "min" else limit.capacity
            given = float(side) ** (1.0 / limit.power)
            sense = {"min": False, "max": True, "equals": upward}[limit.variant]
            new = self._given_way(given, ratio, upward=sense)
            return f"{limit.variant} {show(given, limit.unit)} → {show(new, limit.unit)}"
        new = self._given_way(limit.required, ratio, upward=False)
        return f"required factor {limit.required:.4g} → {new:.4g}"

    @staticmethod
    def _given_way(given: float, ratio: float, *, upward: bool) -> float:
        """Return a value moved by a ratio and rounded on to the digits that are shown."""
        eased = ratio * (1.0 + LEEWAY)
        new = Decimal(given * eased if upward else given / eased)
        last = Decimal(1).scaleb(new.adjusted() - DIGITS + 1)
        return float(new.quantize(last, ROUND_CEILING if upward else ROUND_FLOOR))


def rows_of(problem: SizingProblem, x: Mapping[str, Quantity]) -> dict[str, Row]:
    """Return the rows of a problem by their keys: its limits, bounds, then what can be least.

    Parameters
    ----------
    problem : SizingProblem
        The design whose free dimensions are chosen, and its corrections.
    x : mapping
        The free dimensions [m]: floats, arrays or signomials.

    """
    geometry = problem.design.geometry
    sizes = geometry.sized(dict(x))
    shape, drawn = geometry.drawn(sizes)
    rows: dict[str, Row] = {}
    for index, limit in enumerate(problem.limits(sizes)):
        demand = limit.demand * limit.required**limit.power
        name = f"{limit.name}: {limit.quantity}"
        rows[f"{index} {limit.name}"] = Row(name, demand, limit.capacity, limit)
    for name in geometry.free:
        extent, unit = geometry.extents[name], DIMENSIONS[geometry.dimension(name)].si
        if extent.least is not None:
            rows[f"least {name}"] = Row(
                f"least {name}", extent.least, x[name], bound=extent.least, unit=unit
            )
        if extent.most is not None:
            rows[f"most {name}"] = Row(
                f"most {name}", x[name], extent.most, bound=extent.most, unit=unit
            )
    quantities = {
        ONE: 1.0,
        "volume": shape.volume(drawn),
        **{size_of(name): x[name] for name in geometry.free},
    }
    if geometry.closed_forms:
        quantities["k_pivot"] = geometry.stiffness(problem.design.material.elastic, sizes)
    return rows | {key: Row(key, value, 1.0) for key, value in quantities.items()}


def size_of(name: str) -> str:
    """Return the key of a free dimension as a quantity that can be least."""
    return f"size {name}"
