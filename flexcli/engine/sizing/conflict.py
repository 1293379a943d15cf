"""Why there is no design: requirements that disagree, and how far each must give way."""

from collections.abc import Sequence

import numpy as np

from flexcli.engine.sizing.program import SizingProgram
from flexcli.engine.sizing.rows import ONE, Term
from flexcli.numerics.convex_program import FEASIBLE, SUPPORT
from flexcli.numerics.infeasibility import conflict
from flexcli.results import Relaxation

__all__ = ["explain_conflict"]

EASE = (("ease", 1.0),)
"""The unknown by which rows are eased: the factor by which a demand may exceed its capacity."""


def explain_conflict(program: SizingProgram) -> tuple[tuple[Relaxation, ...], str]:
    """Return the requirements that conflict, each with its nearest relaxation, and how sure it is.

    Rows that repeat a requirement, such as both ends of a blade, give way together. Where that
    does not help, because others conflict as well, it is said how far it must to end this conflict.
    """
    members, sure = _members(program)
    together = {program.rows[key].requirement: key for key in reversed(members)}
    found = []
    for key in reversed(together.values()):
        row = program.rows[key]
        alone = _nearest(program, key, None)
        if alone is not None:
            text = row.relaxed(alone[0], upward=alone[1])
            found.append(Relaxation(row.name, alone[0], text))
            continue
        ended = _nearest(program, key, members)
        text = "giving way alone does not help"
        if ended is not None:
            text = row.relaxed(ended[0], upward=ended[1])
            text = f"{text} ends this conflict, but others remain"
        found.append(Relaxation(row.name, None, text))
    return tuple(found), sure


def _members(program: SizingProgram) -> tuple[Sequence[str], str]:
    """Return the keys of rows that conflict, and how sure it is that fewer do not."""
    if not program.exact:
        text = "a smaller set may conflict; found from many starts, not proved, as limits are "
        return _irreducible(program), text + "numbers"
    found = conflict(program.ratios(program.limits()), program.exact_equalities(), program.names)
    sure = "no smaller set conflicts" if found.smallest else "a smaller set may conflict"
    if found.certificate == "local":
        sure += "; found from many starts, not proved, as the problem is not convex"
    return found.members, sure


def _irreducible(program: SizingProgram) -> list[str]:
    """Return a conflicting set of rows that none can be left out of, by a deletion filter."""
    everything = [*program.constraints, *program.targets]
    values = program.picked(everything)(program.samples())
    equal = [k for k, key in enumerate(everything) if key in program.targets]
    values[equal] = np.abs(values[equal])
    known = ~(values <= 0.0)

    def weights(keys: Sequence[str]) -> dict[str, float] | None:
        """Return the weights of the rows in their conflict, nothing when all can hold."""
        some = [everything.index(key) for key in keys]
        if not known[some].any(axis=0).all():
            return None
        rows = [Term(key, sign, 0.0, EASE) for key in keys for sign in _senses(program, key)]
        rows.append(Term(ONE, 1.0, -1.0, EASE))  # more room than that is not asked
        found = program.least([Term(ONE, 1.0, 0.0, (("ease", -1.0),))], rows)
        if found.converged and np.log(found.x["ease"]) <= FEASIBLE:
            return None
        return found.multipliers

    weighed = weights(everything) or {}
    members = [key for key in everything if weighed.get(key, 0.0) > SUPPORT]
    if not members or weights(members) is None:
        members = everything
    for key in list(members):
        rest = [other for other in members if other != key]
        if rest and weights(rest) is not None:
            members = rest
    return members


def _senses(program: SizingProgram, key: str) -> tuple[float, ...]:
    return (1.0, -1.0) if key in program.targets else (1.0,)


def _nearest(
    program: SizingProgram, key: str, among: Sequence[str] | None
) -> tuple[float, bool] | None:
    """Return the least factor by which a requirement must give way, and a target's direction.

    For all rows, or for those named, to hold; nothing where that does not help.
    """
    row = program.rows[key]
    limits = [
        Term(other, eases=EASE if program.rows[other].requirement == row.requirement else ())
        for other in program.constraints
        if among is None or other in among
    ]
    equal = [
        Term(other)
        for other in program.targets
        if other != key and (among is None or other in among)
    ]
    least_ease = [Term(ONE, 1.0, 0.0, (("ease", -1.0),))]
    if key not in program.targets:
        found = program.least(least_ease, limits, equal)
        return (found.x["ease"], True) if found.converged else None
    outward = Term(ONE, 1.0, 0.0, EASE)
    ends = []
    for sense in (1.0, -1.0):
        target = Term(key, sense, 0.0, EASE)
        found = program.least(least_ease, [*limits, outward], [*equal, target])
        if found.converged:
            ends.append((found.x["ease"], sense > 0.0))
    return min(ends, default=None)
