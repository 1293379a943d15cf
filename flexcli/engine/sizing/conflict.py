"""Why there is no design: requirements that disagree, and how far each must give way."""

from collections.abc import Sequence
from math import inf

from flexcli.engine.sizing.program import SizingProgram
from flexcli.engine.sizing.rows import ONE, Term
from flexcli.results.sizing import Relaxation

__all__ = ["explain_conflict"]

EASE = (("ease", 1.0),)
"""The unknown by which rows are eased: the factor by which a demand may exceed its capacity."""


MOST = 1e6
"""Factor beyond which a requirement that gives way is none any more."""


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
        text = "relaxing it alone does not help"
        if ended is not None:
            text = row.relaxed(ended[0], upward=ended[1])
            text = f"{text} ends this conflict, but others remain"
        found.append(Relaxation(row.name, None, text))
    return tuple(found), sure


def _members(program: SizingProgram) -> tuple[Sequence[str], str]:
    """Return the keys of rows that conflict, and how sure it is that fewer do not."""
    keys = (*program.constraints, *program.targets)
    terms = [Term(key, sign) for key in keys for sign in program.senses(key)]
    found = program.disagreement(terms, [keys.index(term.key) for term in terms])
    sure = "no smaller set conflicts" if found.smallest else "a smaller set may conflict"
    if not program.exact:
        sure += "; found from many starts, not proved, as limits are numbers"
    elif program.curved:
        sure += "; found from many starts, not proved, as the problem is not convex"
    return [keys[k] for k in found.members], sure


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
        found = program.least(least_ease, limits, equal, beyond=True)
        ease = found.x["ease"] if found.converged else inf
        return (ease, True) if ease <= MOST else None
    outward = Term(ONE, 1.0, 0.0, EASE)
    ends = []
    for sense in (1.0, -1.0):
        target = Term(key, sense, 0.0, EASE)
        found = program.least(least_ease, [*limits, outward], [*equal, target], beyond=True)
        if found.converged and found.x["ease"] <= MOST:
            ends.append((found.x["ease"], sense > 0.0))
    return min(ends, default=None)
