"""The best continuous design: what makes it sure, what holds it, and how it moves with demands."""

from collections.abc import Sequence
from math import log

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.sizing.program import STARTS, SizingProgram
from flexcli.engine.sizing.rows import Term, size_of
from flexcli.errors import NoSolution, Outcome
from flexcli.numerics.log_stencil import differences
from flexcli.numerics.solution import Solution
from flexcli.parts.sizing import Objective
from flexcli.results.sizing import Sensitivity

__all__ = ["active_rows", "certificate", "optimum", "refuse", "sensitivities"]

Floats = NDArray[np.float64]

AS_GOOD = 1e-4
"""Relative objective within which designs count as equally good when a loose size is looked for."""
SAME_ROW = 1e-7
"""Singular values below this share of the largest are zero: rows that repeat each other. Gradients
are differences, good to some 1e-11."""
FLAT = 1e-6
"""Curvature below this share of the largest counts as none; curvatures are good to some 1e-9."""
HOLDS = 1e-7
"""Multiplier above which a row holds the optimum."""


def optimum(program: SizingProgram, objective: Objective) -> Solution:
    """Return the best design, ties broken by the volume, then by l, b and h."""
    goals = program.objectives(objective)
    return program.least(goals, program.limits(goals), program.equalities())


def refuse(
    program: SizingProgram, objective: Objective, solution: Solution, smallest: Solution
) -> None:
    """Raise where a solution is no design, or not even the volume makes it the only one."""
    if solution.outcome is Outcome.UNBOUNDED:
        names = ", ".join(n for n in solution.runaway if n in program.names) or "a dimension"
        raise NoSolution(
            "unbounded",
            f"the objective falls without limit as {names} runs away: nothing holds it",
            f"bound {names} in the geometry, e.g. {{free: [0.1 mm, 10 mm]}}, or add a requirement",
        )
    if solution.outcome is Outcome.STALLED:
        if program.exact:
            remedy = solution.outcome.remedy
            raise NoSolution("did-not-converge", "the sizing did not converge", remedy)
        raise NoSolution(
            "did-not-converge",
            "the sizing did not converge on limits that are numbers",
            "bound the free dimensions more closely; a limit with a kink needs a limit of its "
            "own for each of its branches",
        )
    if not (solution.unique or smallest.converged):
        names = ", ".join(_loose(program, objective, solution, smallest))
        raise NoSolution(
            "undetermined",
            f"nothing holds {names}: the objective does not depend on it, and the volume that "
            "would break the tie falls without limit",
            f"bound {names} in the geometry, e.g. {{free: [0.1 mm, 10 mm]}}, or add a requirement",
        )


def _loose(
    program: SizingProgram, objective: Objective, solution: Solution, smallest: Solution
) -> Sequence[str]:
    """Return the dimensions that run away with the volume although the objective stays as good."""
    goal = program.goal(objective)
    as_good = goal._replace(shift=goal.shift - log(solution.objective * (1.0 + AS_GOOD)))
    limits = [*program.limits([goal]), as_good]
    loose = []
    for name in smallest.runaway:
        if name in program.names:
            found = program.least([Term(size_of(name))], limits, program.equalities(), solution.x)
            if found.outcome is Outcome.UNBOUNDED:
                loose.append(name)
    return loose or smallest.runaway


def active_rows(program: SizingProgram, solution: Solution) -> tuple[str, ...]:
    """Return the names of what holds a solution: constraints at their limit, and all targets."""
    return tuple(program.rows[key].name for key in _active(program, solution))


def _active(program: SizingProgram, solution: Solution) -> tuple[str, ...]:
    held = (key for key in solution.active if key in program.constraints)
    return (*(key for key in held if key not in (program.pursued or ())), *program.targets)


def certificate(program: SizingProgram, solution: Solution) -> str:
    """Return how sure the optimum is, in words."""
    if solution.certificate == "global":
        return f"global optimum, duality gap {max(solution.gap, 0.0):.0e}"
    found = f"best of {solution.optima} found" if solution.optima > 1 else "the only one found"
    if not program.exact:
        return f"local optimum, {STARTS} starts: {found}"
    what = "; ".join(program.curved) or "the objective"
    return f"local optimum, {found} from many starts: not posynomial are {what}"


def sensitivities(
    program: SizingProgram, objective: Objective, solution: Solution
) -> tuple[Sensitivity, ...] | None:
    r"""Return what 1 % more demand in each active row does to the objective and dimensions.

    A bound tightens by 1 %, a target grows by 1 %. From the optimality conditions: with J the
    gradients of the active rows, a demand that grows by s in its logarithm (a target by −s) moves
    the sizes by dy,

    .. math:: J\,dy = -s, \quad Z^T \nabla^2 L\,dy = 0

    where Z spans the directions along which the active rows stay, and L is the Lagrangian; where
    its curvature leaves a direction free, that of the objective which breaks the tie decides.

    Returns
    -------
    tuple of Sensitivity or None
        None where the active set is not regular: rows that repeat each other in part, one that
        touches without holding anything, or sizes that nothing decides. There a demand moves the
        design one way when it grows and another when it falls.

    """
    keys = _active(program, solution)
    y = np.log([solution.x[name] for name in program.names])
    goals = program.objectives(objective)
    if goals[0].eases:  # of the row that is its worst
        own = program.pursued or ()
        rows = program.picked(own)(y) / [program.rows[key].power for key in own]
        goals = [Term(own[int(np.argmax(rows))]), *goals[1:]]
    at = differences(program.picked([*(g.key for g in goals), *keys]), y)
    count = len(goals)
    J, groups = _independent(at.jacobian[count:])
    signs = np.array([goal.sign for goal in goals])
    slopes = signs[:, None] * at.jacobian[:count]
    moves = _moves(J, slopes, signs, at.curvatures, [group[0] + count for group in groups])
    if moves is None:
        return None
    found = []
    for place, group in enumerate(groups):
        for k in group:
            row = program.rows[keys[k]]
            # rows that repeat each other, as both ends of a blade do, share what they move
            share = row.power / len(group)
            dy = moves[:, place] * (-share if row.is_target else share)
            on = {"objective": float(slopes[0] @ dy)}
            on |= dict(zip(program.names, dy.tolist(), strict=True))
            found.append((k, Sensitivity(row.name, row.driver, on)))
    return tuple(each for _, each in sorted(found, key=lambda pair: pair[0]))


def _independent(J: Floats) -> tuple[Floats, list[list[int]]]:
    """Return gradients without those that repeat one before, and which rows each stands for."""
    groups: list[list[int]] = []
    for k, gradient in enumerate(J):
        for group in groups:
            if np.abs(J[group[0]] - gradient).max() <= SAME_ROW:
                group.append(k)
                break
        else:
            groups.append([k])
    return J[[group[0] for group in groups]], groups


def _moves(
    J: Floats, slopes: Floats, signs: Floats, curvatures: Floats, rows: Sequence[int]
) -> Floats | None:
    """Return by how much the sizes move per logarithm of each active row's demand, if they do."""
    count, n = J.shape
    _, s, Vt = np.linalg.svd(J)
    size = float(np.abs(J).max(initial=1.0))
    if count > n or (s <= SAME_ROW * size).any():
        return None
    Z = Vt[count:].T
    dy = -np.linalg.pinv(J)
    held = np.zeros(count, dtype=bool)
    for k, slope in enumerate(slopes):
        multipliers = np.linalg.lstsq(J.T, -slope, rcond=None)[0]
        held |= np.abs(multipliers) > HOLDS
        if not Z.shape[1]:
            continue
        H = signs[k] * curvatures[k] + np.tensordot(multipliers, curvatures[rows], axes=1)
        bends, ways = np.linalg.eigh(Z.T @ H @ Z)
        firm = np.abs(bends) > FLAT * max(1.0, float(np.abs(H).max()))
        W = Z @ ways[:, firm]
        dy = dy - W @ ((W.T @ H @ dy) / bends[firm][:, None])
        Z = Z @ ways[:, ~firm]
    return None if Z.shape[1] or not held.all() else np.asarray(dy)
