"""Why limits that are numbers leave no design: rows that disagree, and how far each is off."""

from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.number_optimum import optimum
from flexcli.engine.sizing.number_rows import NumberSizing, Term
from flexcli.engine.sizing.optimum import relaxations
from flexcli.numerics.convex_program import FEASIBLE, SUPPORT
from flexcli.results import Relaxation

__all__ = ["explain_conflict"]


def explain_conflict(sizing: NumberSizing) -> tuple[tuple[Relaxation, ...], str]:
    """Return rows of which none can be spared from the conflict, each with its relaxation."""
    members = _irreducible(sizing)

    def nearest(name: str, among: Sequence[str] | None) -> tuple[float, bool] | None:
        return _nearest(sizing, name, among)

    text = "a smaller set may conflict; found from many starts, not proved, as limits are numbers"
    return relaxations(sizing.rows, members, nearest), text


def _irreducible(sizing: NumberSizing) -> list[str]:
    """Return a conflicting set of rows that none can be left out of, by a deletion filter."""
    everything = [*sizing.constraints, *sizing.targets]
    known = _violated_at_samples(sizing, everything)

    def conflict(keys: Sequence[str]) -> dict[str, float] | None:
        """Return the weights of the rows in their conflict, nothing when all can hold."""
        some = [everything.index(key) for key in keys]
        if not known[some].any(axis=0).all():
            return None
        eased = _all_eased(sizing, keys)
        found = optimum(sizing, None, eased, ())
        if found.converged and np.log(found.x["t"]) <= FEASIBLE:
            return None
        return found.multipliers

    weights = conflict(everything) or {}
    members = [key for key in everything if weights.get(key, 0.0) > SUPPORT]
    if not members or conflict(members) is None:
        members = everything
    for key in list(members):
        rest = [other for other in members if other != key]
        if rest and conflict(rest) is not None:
            members = rest
    return members


def _violated_at_samples(sizing: NumberSizing, keys: Sequence[str]) -> NDArray[np.bool_]:
    """Return which rows are violated at each of the points that starts are chosen from."""
    equal = len(sizing.targets)
    values = sizing.evaluate(sizing.samples())[[sizing.keys.index(key) for key in keys]]
    values[len(keys) - equal :] = np.abs(values[len(keys) - equal :])
    return np.asarray(~(values <= 0.0))


def _all_eased(sizing: NumberSizing, keys: Sequence[str]) -> list[Term]:
    rows = [Term(key, 1.0, 0.0, 1.0) for key in keys]
    rows += [Term(key, -1.0, 0.0, 1.0) for key in keys if key in sizing.targets]
    return [*rows, Term("volume", 0.0, -1.0, 1.0)]  # t ≥ −1: more room than that is not asked


def _nearest(
    sizing: NumberSizing, name: str, among: Sequence[str] | None
) -> tuple[float, bool] | None:
    """Return the least factor by which a requirement must give way, and a target's direction."""
    row = sizing.rows[name]
    held = [key for key in sizing.constraints if among is None or key in among]
    targets = [key for key in sizing.targets if (among is None or key in among) and key != name]
    limits = [
        Term(key, ease=float(sizing.rows[key].requirement == row.requirement)) for key in held
    ]
    equal = [Term(key) for key in targets]
    if name in sizing.constraints:
        found = optimum(sizing, None, limits, equal)
        return (found.x["t"], True) if found.converged else None
    outward = Term("volume", 0.0, 0.0, 1.0)
    ends = []
    for upward, way in ((True, 1.0), (False, -1.0)):
        found = optimum(sizing, None, [*limits, outward], [*equal, Term(name, way, 0.0, 1.0)])
        if found.converged:
            ends.append((found.x["t"], upward))
    return min(ends, default=None)
