"""Wide blades in the shift of a drawn layout: each shortens more than its beam."""

from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.plate_shortening import pure_shortening_factor, s_shortening_factor
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.linear import LinearSolution, linear
from flexcli.parts.geometries.base import MOVING, Blade, Held

__all__ = ["Astray", "shift_by_shapes"]

Floats = NDArray[np.float64]

GUIDED = 6.0
"""Shortening of a guided blade, 3x²/(5l), over the part of its S shape beside its chord,
x²/(10l)."""

SHARES = 0.2
"""Error of a plate's extra shortening in a shape that is neither an arc nor an S."""


class Astray(NamedTuple):
    """Relative change of the second-order shift of a layout's centre, and its error [-].

    ``first`` is the first-order motion of the centre, by shear and stretching, over the second
    order of a unit travel [rad or m].
    """

    value: float
    error: float
    first: float


def shift_by_shapes(
    blades: Sequence[Blade], nu: float, layout: Layout, held: Held, solution: LinearSolution
) -> Astray | None:
    """Return the change by plates of a layout's shift, of second order in its travel.

    A blade whose ends turn by α and β from its chord shortens by ``l ((α − β)²/24 + (α + β)²/40)``,
    the first part of an arc and the second of an S, each more in a plate; besides, its ends move by
    the square of the rotation of its bodies, and its chord turns. The motion of the bodies that
    compensates all this is the linear response to blades of excess length.

    Parameters
    ----------
    blades : sequence of Blade
        Thickness, length and width of each [m], in the order of the layout's.
    nu : float
        Poisson's ratio [-].
    layout : Layout
        The beams.
    held : tuple
        A unit travel of its moving body [rad or m].
    solution : LinearSolution
        The motions at that travel.

    Returns
    -------
    change : Astray or None
        Nothing where the second order vanishes beside what the blades shorten more.

    """
    turns = held[1] is None
    first = float(np.hypot(*_centre(layout, solution, turns=turns)))
    beams, plates = [], []
    for blade, strip in zip(blades, layout.blades, strict=True):
        (u, alpha), (v, beta) = (
            _end(layout, solution, body, point)
            for body, point in ((strip.first, strip.start), (strip.second, strip.end))
        )
        along = np.subtract(strip.end, strip.start) / blade.l
        chord = float(along[0] * (v[0, 1] - u[0, 1]) - along[1] * (v[0, 0] - u[0, 0])) / blade.l
        even, odd = (alpha - beta) ** 2 / 24.0, (alpha + beta - 2.0 * chord) ** 2 / 40.0
        rigid = float(along @ (v[1] - u[1])) / blade.l + chord**2 / 2.0
        at = {"b": blade.b, "l": blade.l, "poisson_ratio": nu}
        more = even * (float(pure_shortening_factor(**at)) - 1.0)
        # that factor is of all that a guided blade shortens, its chord's turn with it
        more += GUIDED * odd * (float(s_shortening_factor(**at)) - 1.0)
        beams.append(-even - odd - rigid)
        plates.append(-more)
    still: Held = (None, None, 0.0) if turns else (None, 0.0, held[2])
    answers = np.array([_answer(layout, strip.name, still, turns=turns) for strip in layout.blades])
    whole, parts = np.array(beams) @ answers, np.array(plates)[:, None] * answers
    shift = float(np.hypot(*whole)) if turns else abs(float(whole[0]))
    off = float(np.abs(parts).sum()) if turns else float(np.abs(parts[:, 0]).sum())
    if off >= shift:
        return None
    moved = parts.sum(axis=0)
    value = float(moved @ whole) / shift**2 if turns else float(moved[0] / whole[0])
    return Astray(value, SHARES * off / shift + (off / shift) ** 2, first / shift)


def _end(
    layout: Layout, solution: LinearSolution, body: str, point: tuple[float, float]
) -> tuple[Floats, float]:
    """Return the first and second order of the motion of a body's point (2, 2), and its turn."""
    names = [each.name for each in layout.bodies]
    if body not in names:
        return np.zeros((2, 2)), 0.0
    i = names.index(body)
    x, y, turn = (float(each) for each in solution.motions[0, i])
    arm = np.subtract(point, layout.bodies[i].point).astype(np.float64)
    first = np.array([x - turn * arm[1], y + turn * arm[0]])
    return np.array([first, -(turn**2) / 2.0 * arm]), turn


def _centre(layout: Layout, solution: LinearSolution, *, turns: bool) -> Floats:
    """Return the motion of the origin of the moving body, or of a stage's point along x (2,)."""
    point = (0.0, 0.0) if turns else layout.body(MOVING).point
    moved, _ = _end(layout, solution, MOVING, point)
    return np.asarray(moved[0] if turns else moved[0] * np.array([1.0, 0.0]))


def _answer(layout: Layout, name: str, held: Held, *, turns: bool) -> Floats:
    """Return how the centre moves as one blade grows by its length, the drive held (2,) [m]."""
    grown = linear(replace(layout, blade_growth={name: 1.0}), {MOVING: held})
    return _centre(layout, grown, turns=turns)
