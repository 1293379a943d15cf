"""The joint of a case in exact equilibrium: at the ends of its stroke, under its forces."""

from collections.abc import Callable, Sequence
from dataclasses import replace
from math import cos, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import LEVELS, solve
from flexcli.mechanics.layout import Layout, Load, Point, Support
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.state import Equilibrium
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING, Geometry
from flexcli.parts.requirements import Ask
from flexcli.parts.scene import Scene

__all__ = [
    "at_rest",
    "blades_of",
    "case_demand",
    "driven_axis",
    "forces_on",
    "held_in",
    "layout_of",
    "over_stroke",
    "solved",
    "turned",
]

Floats = NDArray[np.float64]

RIGHT = 1e-9
"""Sine of twice an angle that counts as a right one."""


def layout_of(ask: Ask) -> Layout:
    """Return the joint as bodies and blades."""
    return ask.geometry.layout(ask.material.elastic, ask.sizes)


def blades_of(layout: Layout, effects: Effects) -> Effects:
    """Return the effects that the layout can have: no shear without a shear modulus."""
    return effects if layout.G is not None else effects._replace(shear=False)


def driven_axis(geometry: Geometry) -> int:
    """Return which coordinate (x, y, φ) of the moving body the stroke drives."""
    return 2 if geometry.motion == "rotation" else 1


def forces_on(scene: Scene, sign: Any, centre: Point) -> list[Load]:
    """Return the forces of a case at the joint's centre, all with one sign (or an array)."""
    return [
        Load(MOVING, centre, (sign * force * cos(direction), sign * force * sin(direction)))
        for force, direction in scene.forces
    ]


def held_in(ask: Ask, travel: Any) -> Held:
    """Return what the case holds: the stroke's motion, or the rotation where a lock does.

    Without either the body is free in its plane.
    """
    scene = ask.scene
    if scene.bends:
        x, y, phi = ask.geometry.held(1.0)
        if driven_axis(ask.geometry) == 2:
            return {MOVING: (x, y, travel)}
        return {MOVING: (x, travel, phi)}
    return {MOVING: (None, None, 0.0)} if scene.lock is not None else {}


def case_demand(ask: Ask, layout: Layout) -> tuple[Held, list[Load]]:
    """Return what a case holds and loads, in two states: both ends of its stroke.

    With forces there are four: they act one way, then the other.
    """
    scene = ask.scene
    ends = np.array([scene.middle + scene.travel, scene.middle - scene.travel] * 2)
    signs = np.array([1.0, 1.0, -1.0, -1.0])
    if not scene.forces:
        ends, signs = ends[:2], signs[:2]
    return held_in(ask, ends), forces_on(scene, signs, layout.body(MOVING).point)


def over_stroke(
    ask: Ask, effects: Effects, tolerance: float, levels: Sequence[int] = LEVELS
) -> Equilibrium:
    """Return the exact equilibria of a case's states."""
    layout = layout_of(ask)
    held, loads = case_demand(ask, layout)
    return solved(
        layout, held, loads=loads,
        effects=blades_of(layout, effects), tolerance=tolerance, levels=levels,
    )  # fmt: skip


def at_rest(
    ask: Ask, effects: Effects, tolerance: float, levels: Sequence[int] = LEVELS
) -> Equilibrium:
    """Return the joint at rest, its driven motion held."""
    layout = layout_of(ask)
    held = {MOVING: ask.geometry.held(0.0)}
    return solved(
        layout, held, effects=blades_of(layout, effects), tolerance=tolerance, levels=levels
    )


def solved(layout: Layout, held: Held, **demand: Any) -> Equilibrium:
    """Return an equilibrium, or say why there is none where a requirement asks."""
    try:
        state = solve(layout, held, **demand).checked()
    except SolveError as error:
        raise NotAvailable(f"has no exact equilibrium: {error}") from error
    if state.unstable.any():
        raise NotAvailable("has no stable exact equilibrium: the forces of the case buckle it")
    return state


def turned(layout: Layout, angle: float) -> Layout:
    """Return a layout turned about the origin by an angle [rad]."""
    c, s = cos(angle), sin(angle)

    def place(point: Point) -> Point:
        x, y = point
        return c * x - s * y, s * x + c * y

    return replace(
        layout,
        bodies=tuple(b._replace(point=place(b.point), com=place(b.com)) for b in layout.bodies),
        blades=tuple(
            replace(blade, start=place(blade.start), end=place(blade.end))
            for blade in layout.blades
        ),
        supports=tuple(_turned_support(support, place, angle) for support in layout.supports),
    )


def _turned_support(support: Support, place: Callable[[Point], Point], angle: float) -> Support:
    """Return a support turned by an angle; springs that differ turn by right angles only."""
    along, across, turn = support.stiffness
    if along != across and abs(sin(2.0 * angle)) > RIGHT:
        raise NotAvailable("has supports whose springs differ: no oblique load on them")
    if along != across and abs(sin(angle)) > 0.5:
        along, across = across, along
    return support._replace(point=place(support.point), stiffness=(along, across, turn))
