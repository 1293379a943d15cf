"""The balanced design: every kind of load requirement exactly at its limit."""

from collections.abc import Callable, Collection, Iterator, Sequence
from dataclasses import dataclass
from itertools import product

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.optimum import optimum
from flexcli.engine.sizing.program import SizingProgram
from flexcli.numerics.lexicographic import log_value
from flexcli.numerics.ratios import Equality, Ratio, Settled
from flexcli.numerics.signomial import Signomial, as_signomial
from flexcli.numerics.square_system import solve_square
from flexcli.parts.requirements import Limit
from flexcli.results import Sensitivity

__all__ = [
    "ACTIVE",
    "Balanced",
    "NotBalanced",
    "balanced",
    "cannot_balance",
    "kind_of",
    "smallest_of",
]

ACTIVE = 1e-9
"""Log utilisation above which another row of the same requirement would be violated."""


@dataclass(frozen=True)
class Balanced:
    """A balanced design, what makes it, and how it moves with each demand."""

    x: dict[str, float]
    active: tuple[str, ...]
    sensitivities: tuple[Sensitivity, ...]
    condition: float | None
    others: int


@dataclass(frozen=True)
class NotBalanced:
    """Why there is no balanced design."""

    reason: str


def balanced(program: SizingProgram, volume: Signomial) -> Balanced | NotBalanced:
    """Return the balanced design of least volume among those that satisfy every other row.

    With as many kinds of load requirement (fatigue, buckling, yield) as free dimensions it is a
    root of a square system; with fewer, the least volume on what they leave free. In each kind
    one row governs; every choice of governing rows is tried, the others of the kind must hold.
    """
    groups = _load_rows(program)
    refusal = cannot_balance(groups, len(program.names))
    if refusal is not None:
        return refusal
    candidates = [
        found for rows in product(*groups.values()) for found in _with_active(program, rows, volume)
    ]
    return smallest_of(
        candidates, groups, lambda x: _violated(program, x), lambda x: float(volume.at(**x))
    )


def cannot_balance(kinds: Collection[str], free: int) -> NotBalanced | None:
    """Return why so many kinds of load requirement have no balanced design, if they have none."""
    if not kinds:
        return NotBalanced("no load requirement (fatigue, buckling, yield) moves with what is free")
    if len(kinds) > free:
        return NotBalanced(
            f"{len(kinds)} load requirements ({', '.join(kinds)}) cannot all be active on "
            f"{free} free dimensions"
        )
    return None


def smallest_of(
    candidates: Sequence[Balanced],
    kinds: Collection[str],
    violated: Callable[[dict[str, float]], list[str]],
    volume: Callable[[dict[str, float]], float],
) -> Balanced | NotBalanced:
    """Return the candidate of least volume among those that violate nothing, or why none does."""
    if not candidates:
        return NotBalanced(
            f"{', '.join(kinds)} cannot all be at their limit together: no size does it"
        )
    allowed = [c for c in candidates if not violated(c.x)]
    if not allowed:
        broken = violated(candidates[0].x)
        return NotBalanced(f"the balanced design violates {', '.join(broken)}")
    best = min(allowed, key=lambda c: volume(c.x))
    return Balanced(best.x, best.active, best.sensitivities, best.condition, len(allowed) - 1)


def _load_rows(program: SizingProgram) -> dict[str, list[Ratio]]:
    groups: dict[str, list[Ratio]] = {}
    for row in program.constraints:
        limit = program.rows[row.name].limit
        if limit is not None and limit.load and isinstance(row, Ratio):
            groups.setdefault(kind_of(limit), []).append(row)
    return {name: _governing(rows) for name, rows in groups.items()}


def kind_of(limit: Limit) -> str:
    """Return what a balanced design makes active once: a requirement, in each joint of its own."""
    return f"{limit.requirement} of {limit.joint}" if limit.joint else limit.requirement


def _governing(rows: list[Ratio]) -> list[Ratio]:
    """Return the rows that can govern: none whose every term another row exceeds."""
    kept: list[Ratio] = []
    for row in rows:
        if not any(_exceeds(other, row) for other in kept):
            kept = [other for other in kept if not _exceeds(row, other)]
            kept.append(row)
    return kept


def _exceeds(one: Ratio, other: Ratio) -> bool:
    if not (one.is_convex and other.is_convex):
        return False
    more = one.numerator / one.denominator - other.numerator / other.denominator
    return more.negative_part().is_zero


def _violated(program: SizingProgram, x: dict[str, float]) -> list[str]:
    broken = [
        row.name
        for row in program.constraints
        if (not row.holds if isinstance(row, Settled) else log_value(row, x) > ACTIVE)
    ]
    broken += [row.name for row in program.equalities if abs(log_value(row, x)) > ACTIVE]
    return [program.rows[name].name for name in broken]


def _with_active(
    program: SizingProgram, rows: tuple[Ratio, ...], volume: Signomial
) -> Iterator[Balanced]:
    """Yield the designs at which the given rows are all at their limit."""
    names = tuple(program.rows[r.name].name for r in rows)
    if len(rows) == len(program.names):
        # a nearly singular system may throw its refinement to where logarithms are no numbers
        with np.errstate(invalid="ignore", over="ignore", divide="ignore"):
            roots = solve_square(rows, program.names)
        for root in roots:
            slopes = _sensitivities(program, rows, root.sensitivity, root.x)
            yield Balanced(root.x, names, slopes, root.condition, 0)
        return
    equalities = [Equality(r.name, r.numerator, r.denominator) for r in rows]
    others = [r for r in program.constraints if r.name not in {row.name for row in rows}]
    solution = optimum(program, [volume], others, [*program.equalities, *equalities])
    if solution.converged:
        yield Balanced(solution.x, names, (), None, 0)


def _sensitivities(
    program: SizingProgram,
    rows: tuple[Ratio, ...],
    slopes: NDArray[np.float64],
    x: dict[str, float],
) -> tuple[Sensitivity, ...]:
    """Return what 1 % more of each demand moves, from the inverse Jacobian of the rows.

    A row holds negative terms of its demand in its denominator; more demand scales these too,
    so that at the root its logarithm grows by only the capacity's share of the denominator.
    """
    found = []
    for index, row in enumerate(rows):
        source = program.rows[row.name]
        share = float(as_signomial(source.capacity).at(**x) / row.denominator.at(**x))
        on = {
            n: float(slopes[j, index]) * share * source.power for j, n in enumerate(program.names)
        }
        on["volume"] = sum(on.values())
        found.append(Sensitivity(source.name, source.driver, on))
    return tuple(found)
