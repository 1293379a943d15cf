"""A design as a geometric program: limits and bounds as rows over the free dimensions."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from decimal import ROUND_CEILING, ROUND_FLOOR, Decimal

from flexcli.formulas.quantity import Quantity
from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Sizes
from flexcli.parts.requirements import Limit
from flexcli.parts.sizing import Objective
from flexcli.units import show

__all__ = ["Row", "SizingProgram", "bounds_of", "objective_of", "sizing_program", "ties"]


DIGITS = 4
"""Significant digits of a proposed relaxation, rounded to the side that does."""

LEEWAY = 1e-9
"""Relative noise of a solve: what a proposal is eased by before it is rounded."""


@dataclass(frozen=True)
class Row:
    """Where a row ``demand ≤ capacity`` comes from: a limit, or a bound on a dimension."""

    name: str
    demand: Quantity
    capacity: Quantity
    limit: Limit | None = None
    bound: float = 0.0

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

    def constraint(
        self, key: str, *, tighter: float = 1.0, ease: Quantity = 1.0
    ) -> Ratio | Settled:
        """Return the row with its demand times ``tighter`` or its capacity times ``ease``."""
        return at_most(key, self.demand * tighter**self.power, self.capacity * ease)

    def equality(self, key: str, *, more: Quantity = 1.0, less: Quantity = 1.0) -> Equality:
        """Return the row of a target that is ``more/less`` times as large."""
        difference = as_signomial(self.demand * less) - as_signomial(self.capacity * more)
        return Equality(key, difference.positive_part(), difference.negative_part())

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
            return f"bound {show(self.bound, 'm')} → {show(new, 'm')}"
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


@dataclass(frozen=True)
class SizingProgram:
    """Rows over the free dimensions; ``rows`` says what each stands for."""

    names: tuple[str, ...]
    sizes: Sizes
    constraints: tuple[Ratio | Settled, ...]
    equalities: tuple[Equality, ...]
    rows: dict[str, Row] = field(default_factory=dict)

    @property
    def targets(self) -> tuple[str, ...]:
        """Return the keys of the targets."""
        return tuple(row.name for row in self.equalities)

    @property
    def curved(self) -> tuple[str, ...]:
        """Return the names of what is not convex in the logarithms."""
        rows: list[Ratio | Equality] = [r for r in self.constraints if isinstance(r, Ratio)]
        curved = [row for row in (*rows, *self.equalities) if not row.is_convex]
        return tuple(dict.fromkeys(self.rows[row.name].name for row in curved))

    def banded(self) -> list[Ratio | Settled]:
        """Return the constraints with each target as the band of its tolerance."""
        rows = list(self.constraints)
        for row in self.equalities:
            limit = self.rows[row.name].limit
            assert limit is not None  # a bound on a dimension is no equality
            assert limit.tolerance is not None
            band = (1.0 + limit.tolerance) ** limit.power
            rows.append(at_most(row.name + " above", row.numerator, row.denominator * band))
            rows.append(at_most(row.name + " below", row.denominator, row.numerator * band))
        return rows

    def complete(self, x: Mapping[str, Quantity]) -> Sizes:
        """Return the blade of a solution, fixed dimensions included."""
        return self.sizes._replace(**x)


def sizing_program(design: DesignSpec) -> SizingProgram:
    """Return the geometric program of a design's requirements and bounds."""
    names = design.geometry.free
    symbols = dict(zip(names, variables(*names), strict=True)) if names else {}
    sizes = design.geometry.sized(symbols)
    constraints: list[Ratio | Settled] = []
    equalities: list[Equality] = []
    rows: dict[str, Row] = {}
    for index, limit in enumerate(design.closed_limits(sizes)):
        key = f"{index} {limit.name}"
        asked = limit.required**limit.power
        row = Row(f"{limit.name}: {limit.quantity}", limit.demand * asked, limit.capacity, limit)
        rows[key] = row
        if limit.tolerance is not None:
            equalities.append(row.equality(key))
        else:
            constraints.append(row.constraint(key))
    for key, row in bounds_of(design, symbols).items():
        rows[key] = row
        constraints.append(row.constraint(key))
    return SizingProgram(names, sizes, tuple(constraints), tuple(equalities), rows)


def bounds_of(design: DesignSpec, sizes: Mapping[str, Quantity]) -> dict[str, Row]:
    """Return the bounds on the free dimensions, whose sizes are given, as rows by their keys."""
    rows: dict[str, Row] = {}
    for name in design.geometry.free:
        extent, x = design.geometry.extents[name], sizes[name]
        if extent.least is not None:
            rows[f"least {name}"] = Row(f"least {name}", extent.least, x, bound=extent.least)
        if extent.most is not None:
            rows[f"most {name}"] = Row(f"most {name}", x, extent.most, bound=extent.most)
    return rows


def objective_of(design: DesignSpec, objective: Objective, sizes: Sizes) -> Signomial:
    """Return what an objective minimises, on the blade's signomials."""
    geometry = design.geometry
    volume = geometry.volume(sizes)
    stiffness = geometry.stiffness(design.material.elastic, sizes)
    lengths = sizes._asdict()
    by_name = {
        "least-volume": volume,
        "least-stiffness": stiffness,
        "balanced": volume,
        "volume": volume,
        "mass": volume,
        "k_pivot": stiffness,
        **({"shortest": lengths["l"]} if "l" in lengths else {}),
        **lengths,
    }
    if isinstance(objective, str):
        return as_signomial(by_name[objective])
    if objective.minimize is not None:
        return as_signomial(by_name[objective.minimize])
    return as_signomial(1.0 / by_name[objective.maximize or ""])


def ties(sizes: Iterable[str]) -> list[str]:
    """Return what breaks ties after the volume: shortest, then narrowest, then thinnest."""
    order = {"l": 0, "b": 1, "h": 2}
    return sorted(sizes, key=lambda name: order.get(name, 3))
