"""A design as a geometric program: limits and bounds as rows over the free dimensions."""

from dataclasses import dataclass, field

from flexcli.numerics.ratios import Equality, Ratio, Settled, at_most
from flexcli.numerics.signomial import Signomial, as_signomial, variables
from flexcli.parts.design import DesignSpec
from flexcli.parts.geometries import Blade
from flexcli.parts.requirements import Limit
from flexcli.parts.sizing import Objective
from flexcli.units import show

__all__ = ["Row", "SizingProgram", "objective_of", "sizing_program"]


@dataclass(frozen=True)
class Row:
    """Where a row of the program comes from: a limit, or a bound on a dimension."""

    name: str
    limit: Limit | None = None
    bound: float = 0.0

    @property
    def driver(self) -> str:
        """Return what the demand of the row grows with."""
        if self.limit is None:
            return "bound"
        return self.limit.driver or ("target" if self.limit.tolerance is not None else "bound")

    def relaxed(self, ratio: float) -> str:
        """Return what would do if this row alone gave way by a factor > 1 on its utilisation."""
        limit = self.limit
        if limit is None:
            least = self.name.startswith("least")
            new = self.bound / ratio if least else self.bound * ratio
            return f"bound {show(self.bound, 'm')} → {show(new, 'm')}"
        ratio = ratio ** (1.0 / limit.power)
        if limit.variant in ("min", "max", "equals"):
            upper = limit.variant != "min"
            side = limit.capacity if upper else limit.demand
            given = float(side) ** (1.0 / limit.power)
            new = given * ratio if upper else given / ratio
            return f"{limit.variant} {show(given, limit.unit)} → {show(new, limit.unit)}"
        return f"required factor {limit.required:.4g} → {limit.required / ratio:.4g}"


@dataclass(frozen=True)
class SizingProgram:
    """Rows over the free dimensions; ``rows`` says what each stands for."""

    names: tuple[str, ...]
    blade: Blade
    constraints: tuple[Ratio | Settled, ...]
    equalities: tuple[Equality, ...]
    rows: dict[str, Row] = field(default_factory=dict)

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

    def complete(self, x: dict[str, float]) -> Blade:
        """Return the blade of a solution, fixed dimensions included."""
        return Blade(*(x.get(name, size) for name, size in self.blade._asdict().items()))


def sizing_program(design: DesignSpec) -> SizingProgram:
    """Return the geometric program of a design's requirements and bounds."""
    extents = design.geometry.extents
    names = design.geometry.free
    symbols = dict(zip(names, variables(*names), strict=True)) if names else {}
    blade = Blade(*(symbols.get(n) or extent.fixed for n, extent in extents.items()))
    constraints: list[Ratio | Settled] = []
    equalities: list[Equality] = []
    rows: dict[str, Row] = {}
    for index, limit in enumerate(design.limits(blade)):
        key = f"{index} {limit.name}"
        rows[key] = Row(f"{limit.name}: {limit.quantity}", limit)
        if limit.tolerance is not None:
            difference = as_signomial(limit.demand) - as_signomial(limit.capacity)
            equalities.append(Equality(key, difference.positive_part(), difference.negative_part()))
        else:
            asked = limit.required**limit.power
            constraints.append(at_most(key, limit.demand * asked, limit.capacity))
    for name in names:
        extent = extents[name]
        for side, size in (("least", extent.least), ("most", extent.most)):
            if size is None:
                continue
            key = f"{side} {name}"
            rows[key] = Row(key, bound=size)
            low, high = (size, symbols[name]) if side == "least" else (symbols[name], size)
            constraints.append(at_most(key, low, high))
    return SizingProgram(names, blade, tuple(constraints), tuple(equalities), rows)


def objective_of(design: DesignSpec, objective: Objective, blade: Blade) -> Signomial:
    """Return what an objective minimises, on the blade's signomials."""
    geometry = design.geometry
    volume = geometry.volume(blade)
    stiffness = geometry.stiffness(design.material.E, blade)
    by_name = {
        "least-volume": volume,
        "least-stiffness": stiffness,
        "shortest": blade.l,
        "balanced": volume,
        "volume": volume,
        "mass": volume,
        "k_pivot": stiffness,
        "h": blade.h,
        "l": blade.l,
        "b": blade.b,
    }
    if isinstance(objective, str):
        return as_signomial(by_name[objective])
    if objective.minimize is not None:
        return as_signomial(by_name[objective.minimize])
    return as_signomial(1.0 / by_name[objective.maximize or "h"])
