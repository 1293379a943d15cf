"""The verb draw: the joint at rest and at the ends of its stroke, as the exact model has it."""

from collections.abc import Sequence
from dataclasses import replace
from math import cos, sin
from typing import Any

import numpy as np

from flexcli.engine.drawn_layout import (
    Turn,
    drawn_blade,
    drawn_bodies,
    drawn_line,
    drawn_states,
    numbers,
    place_of,
    turning,
)
from flexcli.engine.joint_models.exact import TOLERANCE, ExactModel
from flexcli.engine.joint_models.joint_states import blades_of, over_travels
from flexcli.engine.values import stated_strength
from flexcli.errors import Outcome, SolveError
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Body, Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.state import Equilibrium
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.geometries.base import GROUND, MOVING
from flexcli.parts.geometries.linkage import LinkageGeometry
from flexcli.parts.requirements import Ask
from flexcli.results.drawing import (
    XY,
    Drawing,
    DrawnAngle,
    DrawnBlade,
    DrawnBody,
    DrawnEdge,
    DrawnForce,
    DrawnMass,
    DrawnState,
)

__all__ = ["drawing", "drawn_case", "strength_shown"]

STATES = 21
"""Travels from end to end of the stroke: the path of the centre is drawn through them."""


def drawing(design: DesignSpec, sizes: Sizes, case: str | None = None) -> Drawing:
    """Return the joint of a design as it is drawn, in the axes of its cases.

    Parameters
    ----------
    design : DesignSpec
        The design.
    sizes : named tuple
        Its sizes [m].
    case : str, optional
        The case whose stroke and forces are drawn; the first that moves the joint, if left out.

    Raises
    ------
    SolveError
        When there is no such case.

    """
    ask, notes = _with_spacing(drawn_case(design, sizes, case), sizes)
    if design.mechanism is not None and design.mechanism.joints > 1:
        notes = (*notes, f"one of the {design.mechanism.joints} joints alone")
    geometry = ask.geometry
    given = tuple((name, float(size)) for name, size in sizes._asdict().items())
    cut = design.manufacturing.cut() if design.manufacturing is not None else None
    if geometry.in_space:
        from flexcli.engine.draw_in_space import space_drawing

        return space_drawing(ask, given, notes, cut)
    if isinstance(geometry, LinkageGeometry):
        from flexcli.engine.drawn_linkage import linkage_drawing

        at_rest = linkage_drawing(geometry, ask, given, notes, cut)
        return _moved_linkage(geometry, at_rest, ask, design, sizes)
    if geometry.strain == "twist":
        blades, bodies = _twisted_bars(geometry, sizes)
        return Drawing(
            kind=geometry.name, motion=geometry.motion, blades=blades, bodies=bodies, sizes=given,
            centre=(0.0, 0.0), case=ask.scene.case, unit=geometry.travel_unit, twists=True,
            notes=notes, cut=cut,
        )  # fmt: skip
    layout = geometry.layout(design.material.elastic, sizes)
    carried = design.mechanism.carried_body(geometry, layout) if design.mechanism else None
    turn = turning(-geometry.axes)
    states, path, missed = _stroke(ask, turn) if ask.scene.moves else ((), (), "")
    centre = place_of(turn(numbers(layout.body(MOVING).point)))
    return Drawing(
        kind=geometry.name,
        motion=geometry.motion,
        blades=tuple(drawn_blade(blade, turn) for blade in layout.blades),
        bodies=drawn_bodies(layout, turn, _moving(geometry), carried),
        sizes=given,
        centre=centre,
        case=ask.scene.case,
        unit=geometry.travel_unit,
        states=states,
        path=path,
        forces=tuple(_forces(ask, centre, turn)),
        angles=tuple(_angles(geometry)),
        missed=missed,
        strength=strength_shown(design),
        notes=notes,
        cut=cut,
    )


def _with_spacing(ask: Ask, sizes: Sizes) -> tuple[Ask, tuple[str, ...]]:
    """Return the case with a distance from blade to blade to draw, and a word where it had none."""
    geometry = ask.geometry
    if getattr(geometry, "spacing", 1.0) is not None:
        return ask, ()
    drawn = geometry.model_copy(update={"spacing": geometry.length(sizes) / 2.0})
    return ask._replace(geometry=drawn), ("the distance from blade to blade is not in the spec",)


def _moved_linkage(
    geometry: LinkageGeometry, at_rest: Drawing, ask: Ask, design: DesignSpec, sizes: Sizes
) -> Drawing:
    """Return the drawing of a linkage with its stroke and what it carries, where it is solved."""
    from flexcli.engine.drawn_linkage import as_in_spec

    turn, bodies = as_in_spec(geometry), at_rest.bodies
    try:
        states, path, missed = _stroke(ask, turn) if ask.scene.moves else ((), (), "")
        if design.mechanism is not None:
            layout = geometry.plane_layout(design.material.elastic, sizes)
            carried = design.mechanism.carried_body(geometry, layout)
            bodies = tuple(
                _loaded(body, carried, turn) if carried and body.name == geometry.moving else body
                for body in bodies
            )
    except NotAvailable as reason:
        states, path, missed = (), (), f"it {reason}"
    return replace(
        at_rest, states=states, path=path, missed=missed, bodies=bodies,
        forces=tuple(_forces(ask, at_rest.centre, turn)), strength=strength_shown(design),
    )  # fmt: skip


def strength_shown(design: DesignSpec) -> float | None:
    """Return the strength against which stresses are coloured [Pa], where the material has one."""
    stated = stated_strength(design.material)
    return stated[1] if stated is not None else None


def drawn_case(design: DesignSpec, sizes: Sizes, case: str | None) -> Ask:
    """Return the case of that name, or the first that moves the joint, or the first."""
    if case is not None and case not in design.cases:
        text = f"there is no case {case}"
        raise SolveError("no-such-case", text, f"name one of {', '.join(design.cases)}")
    asks = design.asks(sizes, ExactModel())
    named = [a for a in asks if a.scene.case == case]
    return next(iter(named or [a for a in asks if a.scene.moves] or asks))


def _moving(geometry: Geometry) -> str:
    """Return what the moving body is called: by the spec, where it draws it."""
    return str(getattr(geometry, "moving", "moving body"))


def _stroke(ask: Ask, turn: Turn) -> tuple[tuple[DrawnState, ...], tuple[XY, ...], str]:
    """Return the ends of the stroke, the path of the centre, and what was not reached."""
    scene = ask.scene
    travels = np.linspace(*scene.stroke_ends, STATES)

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        effects = blades_of(layout, Effects())
        return solve(layout, held, loads=loads, effects=effects, tolerance=TOLERANCE)

    state = over_travels(ask, solver, travels)
    for outcome in state.outcome:
        if outcome is not Outcome.CONVERGED:
            return (), (), str(outcome.error())
    layout = state.layout
    centre = numbers(layout.body(MOVING).point)
    path = centre + point_motion(state, MOVING, layout.body(MOVING).point)
    ends = (0, STATES - 1) if scene.travel else (0,)
    moving = _moving(ask.geometry)
    states = drawn_states(state, turn, moving, {i: float(travels[i]) for i in ends})
    return states, drawn_line(turn(path)), ""


def _loaded(body: DrawnBody, carried: Body, turn: Turn) -> DrawnBody:
    """Return a body with the mass that is carried."""
    mass = DrawnMass("", place_of(turn(numbers(carried.com))), float(np.ravel(carried.mass)[0]))
    return replace(body, masses=(mass,))


def _forces(ask: Ask, at: XY, turn: Turn) -> list[DrawnForce]:
    """Return the forces of the case on the moving body, which act at a place of the drawing."""
    return [
        DrawnForce(
            ask.scene.force_name if len(ask.scene.forces) == 1 else f"F{k}",
            at,
            place_of(turn(np.array([cos(direction), sin(direction)]))),
            abs(force),
        )
        for k, (force, direction) in enumerate(ask.scene.forces, 1)
        if force != 0.0
    ]


def _angles(geometry: Geometry) -> list[DrawnAngle]:
    """Return the angles that the spec states, at the centre."""
    half = getattr(geometry, "half_angle", None)
    if half is None:
        return []
    return [DrawnAngle("2α", (0.0, 0.0), -float(half), float(half))]


def _twisted_bars(
    geometry: Geometry, sizes: Any
) -> tuple[tuple[DrawnBlade, ...], tuple[DrawnBody, ...]]:
    """Return bars that twist about their axis, one behind the other, as seen from the side."""
    l = float(sizes.l)
    deep = float(getattr(sizes, "b", None) or getattr(sizes, "d", None) or sizes.h)
    across = float(getattr(sizes, "h", deep))
    held = getattr(geometry, "bars", 1) > 1
    spans = [("bar 1", 0.0, l)] + ([("bar 2", 2.5 * l, 1.5 * l)] if held else [])
    blades, ground, moving = [], [], []
    for name, start, end in spans:
        axis = ((start, 0.0), (end, 0.0))
        low, high = sorted((start, end))
        ends = ((low, -1.0), (high, -1.0), (high, 1.0), (low, 1.0))
        corners = [(x, side * deep / 2.0) for x, side in ends]
        around = zip(corners, [*corners[1:], corners[0]], strict=True)
        outline = tuple(DrawnEdge(a, b) for a, b in around)
        outlines = () if hasattr(sizes, "d") else (outline,)  # a round bar is no prism across it
        blades.append(
            DrawnBlade(name, GROUND, MOVING, axis, (deep, deep), across, outlines=outlines)
        )
        way = 1.0 if end > start else -1.0
        ground.append(((start, 0.0), (-way, 0.0)))
        moving.append(((end, 0.0), (way, 0.0)))
    bodies = tuple(
        DrawnBody(
            name,
            tuple(place for place, _ in ends),
            tuple(way for _, way in ends),
            (deep,) * len(ends),
            ends[0][0],
            is_ground=name == GROUND,
        )
        for name, ends in ((GROUND, ground), (_moving(geometry), moving))
    )
    return tuple(blades), bodies
