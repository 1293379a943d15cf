"""The verb draw: the joint at rest and at the ends of its stroke, as the exact model has it."""

from collections.abc import Callable, Mapping, Sequence
from math import cos, sin
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.exact import TOLERANCE, ExactModel
from flexcli.engine.joint_models.joint_states import blades_of, over_travels
from flexcli.engine.values import stated_strength
from flexcli.errors import SolveError
from flexcli.formulas.profile import Edge
from flexcli.mechanics.demand import Held
from flexcli.mechanics.equilibrium import solve
from flexcli.mechanics.layout import Blade, Body, Layout, Load, Point
from flexcli.mechanics.mesh import Effects, column
from flexcli.mechanics.points import point_motion
from flexcli.mechanics.shape import ROUNDING, centre_line
from flexcli.mechanics.state import Equilibrium, Outcome
from flexcli.parts.design import DesignSpec
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Geometry, Sizes
from flexcli.parts.geometries.base import GROUND, MOVING
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

__all__ = [
    "drawing",
    "drawn_blade",
    "drawn_bodies",
    "drawn_case",
    "drawn_states",
    "turning",
]

Floats = NDArray[np.float64]

STATES = 21
"""Travels from end to end of the stroke: the path of the centre is drawn through them."""

AT_REST = 33
"""Places on each piece of a blade at rest, enough to see the shape of a notch."""

Turn = Callable[[Floats], Floats]


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
    ask = drawn_case(design, sizes, case)
    geometry, notes = design.geometry, []
    if getattr(geometry, "spacing", 1.0) is None:
        apart = geometry.length(sizes) / 2.0
        geometry = geometry.model_copy(update={"spacing": apart})
        ask = ask._replace(geometry=geometry)
        notes.append("the distance from blade to blade is not in the spec")
    carried = None
    if design.mechanism is not None and design.mechanism.joints > 1:
        notes.append(f"one of the {design.mechanism.joints} joints alone")
    given = tuple((name, float(size)) for name, size in sizes._asdict().items())
    strength = stated_strength(design.material)
    cut = design.manufacturing.cut() if design.manufacturing is not None else None
    if geometry.in_space:
        from flexcli.engine.draw_in_space import space_drawing

        return space_drawing(ask, given, tuple(notes), cut)
    try:
        layout = geometry.layout(design.material.elastic, sizes)
    except NotAvailable:
        twists = geometry.strain == "twist"
        blades, bodies = _bar(geometry, sizes) if twists else ((), _links(geometry))
        return Drawing(
            kind=geometry.name, motion=geometry.motion, blades=blades, bodies=bodies, sizes=given,
            centre=(0.0, 0.0), case=ask.scene.case, unit=geometry.travel_unit, twists=twists,
            notes=tuple(notes), cut=cut,
        )  # fmt: skip
    if design.mechanism is not None:
        carried = design.mechanism.carried_body(geometry, layout)
    turn = turning(-geometry.axes)
    states, path, missed = _moved(ask, turn) if ask.scene.moves else ((), (), "")
    centre = _numbers(layout.body(MOVING).point)
    return Drawing(
        kind=geometry.name,
        motion=geometry.motion,
        blades=tuple(drawn_blade(blade, turn) for blade in layout.blades),
        bodies=drawn_bodies(layout, turn, _moving(geometry), carried),
        sizes=given,
        centre=_place(turn(centre)),
        case=ask.scene.case,
        unit=geometry.travel_unit,
        states=states,
        path=path,
        forces=tuple(_forces(ask, layout, -geometry.axes)),
        angles=tuple(_angles(geometry)),
        missed=missed,
        strength=strength[1] if strength is not None else None,
        notes=tuple(notes),
        cut=cut,
    )


def drawn_case(design: DesignSpec, sizes: Sizes, case: str | None) -> Ask:
    """Return the case of that name, or the first that moves the joint, or the first."""
    if case is not None and case not in design.cases:
        text = f"there is no case {case}"
        raise SolveError("no-such-case", text, f"name one of {', '.join(design.cases)}")
    asks = design.asks(sizes, ExactModel())
    named = [a for a in asks if a.scene.case == case]
    return next(iter(named or [a for a in asks if a.scene.moves] or asks))


def turning(angle: float) -> Turn:
    """Return what turns places about the origin."""
    c, s = cos(angle), sin(angle)
    matrix = np.array([[c, -s], [s, c]])
    matrix[np.abs(matrix) < 1e-12] = 0.0  # quarter turns leave straight lines straight
    return lambda places: places @ matrix.T


def _numbers(place: Point) -> Floats:
    """Return the place of the one design that is drawn."""
    return np.array([float(column(c)[0]) for c in place])


def _place(place: Floats) -> XY:
    return float(place[0]), float(place[1])


def drawn_line(places: Floats) -> tuple[XY, ...]:
    return tuple(_place(place) for place in places)


def _ends(blade: Blade) -> tuple[Floats, Floats]:
    return _numbers(blade.start), _numbers(blade.end)


def drawn_blade(blade: Blade, turn: Turn) -> DrawnBlade:
    """Return a blade at rest, its thickness at places crowded where it changes."""
    start, end = _ends(blade)
    l = float(np.hypot(*(end - start)))
    s, h = [0.0], [0.0]
    u = np.linspace(-1.0, 1.0, AT_REST)[None, :]
    for piece in blade.profile.pieces(l):
        at = np.broadcast_to(piece.position(u), u.shape)[0]
        if at[0] > s[-1] + ROUNDING * l:  # a rigid stretch before it
            s, h = [*s, float(at[0])], [*h, 0.0]
        s.extend(at.tolist())
        h.extend(np.broadcast_to(piece.thickness(u), u.shape)[0].tolist())
    if s[-1] < l * (1.0 - ROUNDING):
        s, h = [*s, s[-1], l], [*h, 0.0, 0.0]
    if h[0] == 0.0 and s[1] == 0.0:
        s, h = s[1:], h[1:]
    axis = start + (np.array(s) / l)[:, None] * (end - start)
    width, height = float(column(blade.b)[0]), float(column(blade.z)[0])
    outlines = tuple(_outline(face, start, end, turn) for face in blade.profile.faces(l))
    line = drawn_line(turn(axis))
    return DrawnBlade(
        blade.name, blade.first, blade.second, line, tuple(h), width, height, outlines
    )


def _outline(face: Sequence[Edge], start: Floats, end: Floats, turn: Turn) -> tuple[DrawnEdge, ...]:
    """Return the outline of a stretch between its left face and the mirror of it, on the right."""
    along = (end - start) / np.hypot(*(end - start))
    across = np.array([-along[1], along[0]])

    def drawn(edge: Edge, side: float) -> DrawnEdge:
        def place(at: XY) -> XY:
            return _place(turn(start + at[0] * along + side * at[1] * across))

        centre = None if edge.centre is None else place(edge.centre)
        return DrawnEdge(place(edge.start), place(edge.end), centre)

    right = [drawn(edge, -1.0) for edge in face]
    left = [edge._replace(start=edge.end, end=edge.start) for edge in reversed(face)]
    whole = [right, [drawn(edge, 1.0) for edge in left]]
    closed = [DrawnEdge(a[-1].end, b[0].start) for a, b in (whole, whole[::-1])]
    return (*whole[0], closed[0], *whole[1], closed[1])


def drawn_bodies(
    layout: Layout, turn: Turn, moving: str, carried: Body | None = None
) -> tuple[DrawnBody, ...]:
    """Return the ground and the bodies with what is clamped to them and what they carry."""
    known = {body.name: body for body in layout.bodies}
    if carried is not None:
        known[MOVING] = known[MOVING]._replace(mass=carried.mass, com=carried.com)
    names = [GROUND, *known]
    places: dict[str, list[XY]] = {name: [] for name in names}
    ways: dict[str, list[XY]] = {name: [] for name in names}
    depths: dict[str, list[float]] = {name: [] for name in names}
    for blade in layout.blades:
        start, end = _ends(blade)
        along = turn((end - start) / np.hypot(*(end - start)))
        h = [x for x in drawn_blade(blade, turn).thickness if x > 0.0]
        for body, place, way, depth in (
            (blade.first, start, -along, h[0]),
            (blade.second, end, along, h[-1]),
        ):
            name = body if body in known else GROUND
            places[name].append(_place(turn(place)))
            ways[name].append(_place(way))
            depths[name].append(depth)
    found = []
    for name in names:
        if not places[name]:
            continue
        point = np.zeros(2)
        masses: tuple[DrawnMass, ...] = ()
        if name in known:
            rigid = known[name]
            point = _numbers(rigid.point)
            if (mass := float(column(rigid.mass)[0])) > 0.0:
                masses = (DrawnMass("", _place(turn(_numbers(rigid.com))), mass),)
        found.append(
            DrawnBody(
                name=moving if name == MOVING else name,
                clamps=tuple(places[name]),
                ways=tuple(ways[name]),
                depths=tuple(depths[name]),
                point=_place(turn(point)),
                is_ground=name == GROUND,
                masses=masses,
            )
        )
    return tuple(found)


def _moving(geometry: Geometry) -> str:
    """Return what the moving body is called: by the spec, where it draws it."""
    return str(getattr(geometry, "moving", "moving body"))


def _moved(ask: Ask, turn: Turn) -> tuple[tuple[DrawnState, ...], tuple[XY, ...], str]:
    """Return the ends of the stroke, the path of the centre, and what was not reached."""
    scene = ask.scene
    travels = np.linspace(scene.middle + scene.travel, scene.middle - scene.travel, STATES)

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        effects = blades_of(layout, Effects())
        return solve(layout, held, loads=loads, effects=effects, tolerance=TOLERANCE)

    state = over_travels(ask, solver, travels)
    for outcome in state.outcome:
        if outcome is not Outcome.CONVERGED:
            return (), (), str(outcome.value)
    layout = state.layout
    centre = _numbers(layout.body(MOVING).point)
    path = centre + point_motion(state, MOVING, layout.body(MOVING).point)
    ends = (0, STATES - 1) if scene.travel else (0,)
    moving = _moving(ask.geometry)
    states = drawn_states(state, turn, moving, {i: float(travels[i]) for i in ends})
    return states, drawn_line(turn(path)), ""


def drawn_states(
    state: Equilibrium, turn: Turn, moving: str, travels: Mapping[int, float]
) -> tuple[DrawnState, ...]:
    """Return equilibria by their rows, as they are drawn, with what the moving body is called."""
    lines = {blade.name: centre_line(state, blade.name) for blade in state.layout.blades}
    found = []
    for i, travel in travels.items():
        motions = {}
        for k, body in enumerate(state.layout.bodies):
            x, y = turn(state.motions[i, k, :2])
            name = moving if body.name == MOVING else body.name
            motions[name] = (float(x), float(y), float(state.motions[i, k, 2]))
        found.append(
            DrawnState(
                travel=travel,
                axes={name: drawn_line(turn(line.place[i])) for name, line in lines.items()},
                stress={name: tuple(line.stress[i].tolist()) for name, line in lines.items()},
                motions=motions,
            )
        )
    return tuple(found)


def _forces(ask: Ask, layout: Layout, angle: float) -> list[DrawnForce]:
    """Return the forces of the case on the moving body."""
    at = turning(angle)(_numbers(layout.body(MOVING).point))
    return [
        DrawnForce(
            ask.scene.force_name if len(ask.scene.forces) == 1 else f"F{k}",
            _place(at),
            (cos(direction + angle), sin(direction + angle)),
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


def _bar(geometry: Geometry, sizes: Any) -> tuple[tuple[DrawnBlade, ...], tuple[DrawnBody, ...]]:
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


def _links(geometry: Any) -> tuple[DrawnBody, ...]:
    """Return the links of a linkage with ideal joints, each by the places of its joints."""
    found = []
    for link in geometry.rigid.moving:
        pins = tuple(
            (float(joint.at[0]), float(joint.at[1]))
            for joint in geometry.joints.values()
            if link in joint.links
        )
        none = ((0.0, 0.0),) * len(pins)
        found.append(DrawnBody(link, pins, none, (0.0,) * len(pins), pins[0]))
    ground = tuple(
        (float(joint.at[0]), float(joint.at[1]))
        for joint in geometry.joints.values()
        if geometry.ground in joint.links
    )
    down = ((0.0, -1.0),) * len(ground)
    return (
        DrawnBody(GROUND, ground, down, (0.0,) * len(ground), ground[0], is_ground=True),
        *found,
    )
