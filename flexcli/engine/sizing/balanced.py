"""The balanced design: every kind of load requirement exactly at its limit."""

from collections.abc import Iterator
from dataclasses import dataclass, replace
from itertools import product

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.program import BEYOND, SizingProgram
from flexcli.engine.sizing.rows import Term
from flexcli.numerics.log_stencil import Field, differences
from flexcli.numerics.roots import roots
from flexcli.parts.requirements import Limit
from flexcli.results.sizing import Sensitivity

__all__ = ["Balanced", "NotBalanced", "balanced", "kind_of"]

Floats = NDArray[np.float64]

ACTIVE = 1e-9
"""Log utilisation above which another row of the same requirement would be violated."""
FROM = 24
"""Starts of Newton's method for each choice of governing rows."""


@dataclass(frozen=True)
class Balanced:
    """A balanced design, the rows and checks that make it, and how it moves with each demand."""

    x: dict[str, float]
    active: tuple[str, ...]
    checks: tuple[str, ...]
    sensitivities: tuple[Sensitivity, ...]
    is_square: bool
    others: int = 0


@dataclass(frozen=True)
class NotBalanced:
    """Why there is no balanced design."""

    reason: str


def balanced(program: SizingProgram) -> Balanced | NotBalanced:
    """Return the balanced design of least volume among those that satisfy every other row.

    With as many kinds of load requirement (fatigue, buckling, yield) as free dimensions it is a
    root of a square system; with fewer, the least volume on what they leave free. In each kind
    one row governs; every choice of governing rows is tried, the others of the kind must hold.
    A row that another of its kind exceeds at all of many points is left out.
    """
    kinds, free = _load_rows(program), len(program.names)
    if not kinds:
        return NotBalanced("no load requirement (fatigue, buckling, yield) moves with what is free")
    if len(kinds) > free:
        return NotBalanced(
            f"{len(kinds)} load requirements ({', '.join(kinds)}) cannot all be active on "
            f"{free} free dimensions"
        )
    of = _roots if len(kinds) == free else _least_volume
    candidates = [found for keys in product(*kinds.values()) for found in of(program, keys)]
    if not candidates:
        return NotBalanced(
            f"{', '.join(kinds)} cannot all be at their limit together: no size does it"
        )
    allowed = [found for found in candidates if not _violated(program, found.x)]
    if not allowed:
        broken = _violated(program, candidates[0].x)
        return NotBalanced(f"the balanced design violates {', '.join(broken)}")
    best = min(allowed, key=lambda found: float(program.at(["volume"], found.x)[0, 0]))
    return replace(best, others=len(allowed) - 1)


def _load_rows(program: SizingProgram) -> dict[str, list[str]]:
    """Return by kind the keys of the load rows that move with what is free and may govern."""
    keys = list(program.constraints)
    values = np.nan_to_num(program.picked(keys)(program.samples(BEYOND)), nan=-np.inf)
    kinds: dict[str, list[int]] = {}
    for k, key in enumerate(keys):
        limit = program.rows[key].limit
        known = values[k][np.isfinite(values[k])]
        if limit is not None and limit.load and known.size and np.ptp(known) > 0.0:
            kinds.setdefault(kind_of(limit), []).append(k)
    largest = {kind: np.unique(np.argmax(values[own], axis=0)) for kind, own in kinds.items()}
    return {kind: [keys[kinds[kind][k]] for k in place] for kind, place in largest.items()}


def kind_of(limit: Limit) -> str:
    """Return what a balanced design makes active once: a requirement, in each joint of its own."""
    return f"{limit.requirement} of {limit.joint}" if limit.joint else limit.requirement


def _violated(program: SizingProgram, x: dict[str, float]) -> list[str]:
    """Return the names of the rows that sizes violate."""
    keys = [*program.constraints, *program.targets]
    values = dict(zip(keys, program.at(keys, x)[:, 0].tolist(), strict=True))
    broken = [key for key in program.constraints if values[key] > ACTIVE]
    broken += [key for key in program.targets if abs(values[key]) > ACTIVE]
    return [program.rows[key].name for key in broken]


def _roots(program: SizingProgram, keys: tuple[str, ...]) -> Iterator[Balanced]:
    """Yield the designs at which as many rows as there are free dimensions are at their limit."""
    rows = program.picked(keys)
    for root in roots(rows, _starts(program, rows)):
        x = dict(zip(program.names, np.exp(root.y).tolist(), strict=True))
        slopes = _sensitivities(program, keys, root.y, root.inverse)
        yield Balanced(x, *_names(program, keys), slopes, is_square=True)


def _starts(program: SizingProgram, rows: Field) -> Floats:
    """Return where Newton's method starts: about a place there, else at the best of many points."""
    if program.around is not None:
        centre, _ = program.around
        return np.log([[centre[name] for name in program.names]])
    points = program.samples(BEYOND)
    with np.errstate(invalid="ignore"):
        order = np.argsort(np.abs(rows(points)).max(axis=0), kind="stable")[:FROM]
    return np.asarray(points[:, order].T)


def _sensitivities(
    program: SizingProgram, keys: tuple[str, ...], y: Floats, inverse: Floats
) -> tuple[Sensitivity, ...]:
    """Return what 1 % more of each demand moves, from the inverse Jacobian of the rows."""
    volume = differences(program.picked(["volume"]), y).jacobian[0]
    found = []
    for index, key in enumerate(keys):
        row = program.rows[key]
        moved = -inverse[:, index] * row.power
        on = dict(zip(program.names, moved.tolist(), strict=True))
        on["volume"] = float(volume @ moved)
        found.append(Sensitivity(row.name, row.driver, on))
    return tuple(found)


def _least_volume(program: SizingProgram, keys: tuple[str, ...]) -> Iterator[Balanced]:
    """Yield the least volume at which fewer rows than free dimensions are at their limit."""
    limits = [term for term in program.limits() if term.key not in keys]
    equal = [*program.equalities(), *(Term(key) for key in keys)]
    found = program.least([Term("volume")], limits, equal)
    if found.converged:
        x = {name: found.x[name] for name in program.names}
        yield Balanced(x, *_names(program, keys), (), is_square=False)


def _names(
    program: SizingProgram, keys: tuple[str, ...]
) -> tuple[tuple[str, ...], tuple[str, ...]]:
    """Return the names of rows, and of the checks that they belong to."""
    limits = [program.rows[key].limit for key in keys]
    names = tuple(program.rows[key].name for key in keys)
    return names, tuple(limit.name for limit in limits if limit is not None)
