"""A joint in space at a travel, its drive held, or under loads: beams or shells."""

from collections.abc import Callable
from contextlib import suppress
from functools import partial
from typing import NamedTuple, TypeAlias
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.holds import FREE, hold_of
from flexcli.engine.joint_models.space_errors import StrokeErrors, beam_errors, strain_error
from flexcli.errors import SolveError
from flexcli.formulas.rigid_motion import axes_about_z, motion_along
from flexcli.mechanics.refinement import LEVELS
from flexcli.mechanics.space.exact.beams import beams_of
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium, beside, solve
from flexcli.mechanics.space.exact.members import MembersOf
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import SpaceLayout, SpaceLoad
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import Hold
from flexcli.parts.requirements import Ask, Told
from flexcli.parts.space_joint import SpaceJoint, joint_of
from flexcli.results import ErrorRange

__all__ = [
    "BEAMS",
    "Blades",
    "Loads",
    "along_cases",
    "at_travel",
    "compliance_along_cases",
    "driven_coordinate",
    "forget",
    "held_motion",
    "sag_of_drive",
    "support_at_stroke",
    "warm_ratio",
    "warm_support_ratio",
]

Floats = NDArray[np.float64]

ROUNDING = 1e-6
"""Error of a ratio of two states at the same nodes."""

TOLERANCE = 1e-5
"""Of forces and motions: of its tangent, the last two levels of nodes tell."""

NEARBY = 0.2
"""Share of a stroke beyond or before its end within which the path goes by that end."""

Loads: TypeAlias = tuple[SpaceLoad, ...]
"""Dead loads on bodies of a layout."""

_Asked: TypeAlias = tuple[str, float | None, Loads, float, bool, bool, bool]

_KNOWN: WeakKeyDictionary[SpaceJoint, dict[_Asked, SpaceEquilibrium | SolveError]]
_KNOWN = WeakKeyDictionary()


class Blades(NamedTuple):
    """What blades are made of at a stroke, how finely, and what is known of their errors.

    ``errors`` gives nothing where they are not known. ``critical`` are levels and accuracy of
    critical loads.
    """

    name: str
    made: MembersOf
    levels: tuple[int, ...]
    tolerance: float
    errors: Callable[[SpaceEquilibrium], StrokeErrors | None]
    critical: tuple[tuple[int, ...], float]


def at_travel(
    ask: Ask,
    travel: float | None,
    blades: Blades | None = None,
    *,
    loads: Loads = (),
    warmth: float = 1.0,
    start: SpaceEquilibrium | None = None,
    hold: Hold = FREE,
) -> SpaceEquilibrium:
    """Return the joint at a travel of its drive, all else free but for a guide; by beams if unsaid.

    Without a travel the drive is free: the joint is as its loads and its temperature leave it, of
    whose strains it has the share ``warmth``; the path is that from ``start`` where there is one,
    of the same blades, else from rest, of beams by the end of the stroke. ``hold`` is what keeps
    the body from turning besides. Where the ask is ``near`` another, what a small change makes of
    that one.

    Raises
    ------
    NotAvailable
        When it is not made of blades, shells do not take them, or it buckles there.
    SolveError
        When the path to it ends before.

    """
    warmth = 0.0 if ask.scene.temperature is None else warmth
    joint = joint_of(ask, warm=warmth != 0.0)
    blades = BEAMS if blades is None else blades
    known = _KNOWN.setdefault(joint, {})
    own = ask.near is not None, start is not None, hold.turn
    key = blades.name, travel, loads, warmth, *own
    if key not in known:
        layout = joint.layout.grown(warmth) if warmth else joint.layout
        frames = drive_frame(layout.drive)
        motion = held_motion(ask, layout, travel, hold)
        if ask.near is None:
            try:
                known[key] = solve(
                    layout,
                    motion,
                    loads=loads,
                    frames=frames,
                    tolerance=blades.tolerance,
                    levels=blades.levels,
                    made=blades.made,
                    start=start or _on_the_way(ask, travel, blades, loads, warmth, hold),
                ).checked()
            except SolveError as error:  # whoever asks next need not look for it again
                known[key] = error
        else:
            near = ask.near._replace(scene=ask.scene)
            about = at_travel(near, travel, blades, loads=loads, warmth=warmth, hold=hold)
            known[key] = beside(about, layout, motion, loads=loads, frames=frames, made=blades.made)
    found = known[key]
    if isinstance(found, SolveError):
        raise found
    at_rest = travel == 0.0 and not loads and not warmth
    if ask.near is None and not at_rest and found.unstable:
        raise NotAvailable(f"buckles {_under(travel, loads)}")
    return found


def _on_the_way(
    ask: Ask, travel: float | None, blades: Blades, loads: Loads, warmth: float, hold: Hold
) -> SpaceEquilibrium | None:
    """Return the joint without loads at the end of a stroke nearby, from which it is not far.

    A stroke may be a long way for beams; loads at its end, or a little less of it, seldom are.
    """
    ends = ask.scene.stroke_ends if travel is not None else (None,)
    near = min(ends, key=lambda end: abs((end or 0.0) - (travel or 0.0)))
    is_rest = not near and (ask.scene.temperature is None or not warmth)
    if blades is not BEAMS or is_rest or (travel == near and not loads):
        return None
    if travel is not None and abs(travel - (near or 0.0)) > NEARBY * abs(near or 0.0):
        return None
    with suppress(NotAvailable, SolveError):
        return at_travel(ask, near, blades, warmth=warmth, hold=hold)
    return None


def sag_of_drive(
    ask: Ask, loads: Loads, blades: Blades | None = None, *, warmth: float = 1.0
) -> float:
    """Return how far loads move the free drive of the joint [m or rad], see :func:`at_travel`."""
    at = partial(at_travel, ask, None, blades, warmth=warmth, hold=hold_of(ask.scene))
    under, free = (at(loads=each) for each in (loads, ()))
    own = driven_coordinate(under.layout)
    return float((under.coordinates - free.coordinates).ravel()[own])


def _under(travel: float | None, loads: Loads) -> str:
    """Return what a joint is under, in words."""
    if travel is None:
        return "under its loads" if loads else "by its temperature"
    return "at its stroke with the drive locked" + (" under its loads" if loads else "")


def held_motion(
    ask: Ask, layout: SpaceLayout, travel: float | None = None, hold: Hold = FREE
) -> dict[str, list[float | None]]:
    """Return what holds the driven body in its drive's frame: its guide, and its drive at a travel.

    Without a travel the drive is free. ``hold`` keeps the body from turning about z.
    """
    held: list[float | None] = [None] * 6
    if ask.geometry.is_guided or (hold.turn and not layout.drive.turns):
        held[5] = 0.0  # the frame's third axis is z
    if layout.drive.turns:
        held[3] = 0.0 if travel is None and hold.turn else travel
    else:
        held[0] = travel
    return {layout.drive.body: held}


def forget() -> None:
    """Forget all equilibria, so that the next take their time."""
    _KNOWN.clear()


def driven_coordinate(layout: SpaceLayout) -> int:
    """Return the coordinate of the layout's bodies that the drive moves."""
    return 6 * layout.index(layout.drive.body) + (3 if layout.drive.turns else 0)


def support_at_stroke(
    ask: Ask,
    index: int,
    point: tuple[float, float, float],
    *,
    locked: bool,
    blades: Blades | None = None,
) -> tuple[tuple[float, ErrorRange | None], ...]:
    """Return the support stiffness at both ends of a case's stroke, as a joint model does.

    Raises
    ------
    NotAvailable
        When what is asked for is held, or the joint cannot be solved in space.

    """
    scene, blades = ask.scene, BEAMS if blades is None else blades
    found = []
    for travel in dict.fromkeys(scene.stroke_ends):
        state = at_travel(ask, travel, blades)
        value = _stiffness(ask, state, index, point, locked=locked)
        known, error = blades.errors(state), None
        if state.coarser is not None and known is not None:
            before = _stiffness(ask, state.coarser, index, point, locked=locked)
            cold, of_heat = at_travel(ask, travel, blades, warmth=0.0), 0.0
            if cold is not state:  # what heat takes away of it, it does as surely where it is off
                of_heat = abs(_stiffness(ask, cold, index, point, locked=locked) / value - 1.0)
            change = abs(before / value - 1.0) + known.support * (1.0 + of_heat)
            error = ErrorRange(-change, change)
        found.append((value, error))
    return tuple(found)


def warm_ratio(
    ask: Ask, number: Callable[[SpaceEquilibrium], float], travel: float | None = None
) -> Told:
    """Return a number at the temperature over that of the same joint unstrained, by exact beams.

    What strain changes is known to a share of itself; what nobody compared may be off by itself.
    Without a travel the drive is free.

    Raises
    ------
    NotAvailable, SolveError
        When there is no stable equilibrium.

    """
    warm, cold = (at_travel(ask, travel, warmth=each) for each in (1.0, 0.0))
    ratio, share = number(warm) / number(cold), strain_error(warm)
    off = max((1.0 if share is None else share) * abs(ratio - 1.0) / ratio, ROUNDING)
    return Told(ratio, ErrorRange(-off, off))


def warm_support_ratio(
    ask: Ask, index: int, point: tuple[float, float, float], *, locked: bool
) -> Told:
    """Return what a temperature strains makes of a support stiffness at rest, by exact beams [-].

    Raises
    ------
    NotAvailable
        When what is asked for is held, or there is no stable equilibrium.

    """

    def stiffness(state: SpaceEquilibrium) -> float:
        return _stiffness(ask, state, index, point, locked=locked)

    try:
        return warm_ratio(ask, stiffness, 0.0 if locked else None)
    except SolveError as failed:
        raise NotAvailable(f"has no equilibrium at its temperature: {failed}") from failed


BEAMS = Blades("exact", beams_of, LEVELS, TOLERANCE, beam_errors, ((12, 18, 27, 40, 60), 1e-3))
"""Exact beams: their critical loads are far more accurate than beams are."""


def along_cases(ask: Ask) -> Floats:
    """Return the matrix that takes motions along the layout's axes to those of cases (6, 6)."""
    return motion_along(axes_about_z(ask.geometry.axes))


def compliance_along_cases(
    ask: Ask, state: SpaceEquilibrium, point: tuple[float, float, float], *, locked: bool
) -> Floats:
    """Return the 6×6 compliance of a point of the moving body along the axes of cases."""
    layout = state.layout
    body = layout.body(layout.drive.body)
    axes = axes_about_z(ask.geometry.axes)
    x, y, z = (float(c) for c in body.point + axes.T @ np.array(point))
    free = () if locked else (driven_coordinate(layout),)
    turned = along_cases(ask)
    return turned @ support_compliance(state, body.name, (x, y, z), free=free) @ turned.T


def _stiffness(
    ask: Ask,
    state: SpaceEquilibrium,
    index: int,
    point: tuple[float, float, float],
    *,
    locked: bool,
) -> float:
    C = compliance_along_cases(ask, state, point, locked=locked)
    block = slice(0, 3) if index < 3 else slice(3, 6)
    if C[index, index] <= 1e-14 * np.trace(np.abs(C)[block, block]):
        raise NotAvailable("is held by its guide or drive in the direction that is asked for")
    return float(1.0 / C[index, index])
