"""A mechanism in space as it is drawn: from the front, the side and the corner, at rest and moved.

Each view is a planar drawing of what is seen: blades as thick as they look, at rest. Moved blades
are cubics between their ends, whose places and directions are those of the exact model; the stress
along them is that of its beams.
"""

from collections.abc import Iterator, Mapping
from dataclasses import replace
from math import cos, radians, sin
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.drawn_layout import (
    drawn_blade,
    drawn_bodies,
    drawn_line,
    place_of,
    turning,
)
from flexcli.engine.joint_models.beam_peaks import section_peaks
from flexcli.engine.joint_models.space_stroke import at_travel
from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant, Profile
from flexcli.mechanics.layout import Blade, Body, Layout
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.rotation import matrix_of
from flexcli.mechanics.space.exact.stresses import blade_stresses
from flexcli.mechanics.space.layout import SpaceLayout, SpaceRod
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.results.drawing import (
    XY,
    Drawing,
    DrawnBlade,
    DrawnCut,
    DrawnEdge,
    DrawnInSpace,
    DrawnState,
)

__all__ = ["space_drawing"]

Floats = NDArray[np.float64]

AXES = {"z": ("x", "y"), "x": ("y", "z"), "y": ("x", "z")}
"""Axes to the right and up, by the axis that one looks along."""

_C, _S = cos(radians(30.0)), sin(radians(30.0))

CORNER = {"x": {"y": (-_C, -_S), "z": (_C, -_S), "x": (0.0, 1.0)},
          "y": {"z": (-_C, -_S), "x": (_C, -_S), "y": (0.0, 1.0)},
          "z": {"x": (-_C, -_S), "y": (_C, -_S), "z": (0.0, 1.0)}}  # fmt: skip
"""Where the axes point as seen from the corner between all three, by the one that is upright."""

END_ON = 1e-3
"""Share of its length that a blade is seen of, below which it is only seen end on."""

EDGE_ON = 0.05
"""Sine of the angle to its surface at which a blade is looked at, below which it is a line."""

ROUNDING = 1e-9
"""Of a cosine that is one."""

ALONG = np.linspace(0.0, 1.0, 25)
"""Places along a moved blade, over its length, beside those where its stress is known."""


class View(NamedTuple):
    """Where on the page x, y and z point, as columns (2, 3), and the words for it."""

    rows: Floats
    words: str

    @property
    def axes(self) -> tuple[tuple[str, tuple[float, float]], ...]:
        """Return the axes that are seen, with where they point."""
        ways = zip("xyz", drawn_line(self.rows.T), strict=True)
        return tuple((name, way) for name, way in ways if any(way))

    @property
    def normal(self) -> Floats:
        """Return the axis that one looks along, towards the eye."""
        towards = np.cross(*self.rows)
        return np.asarray(towards / np.linalg.norm(towards))


def _view_along(axis: str) -> View:
    right, up = AXES[axis]
    rows = np.array([[float(a == b) for a in "xyz"] for b in (right, up)])
    return View(rows, f"seen along {axis}: {right} to the right, {up} upwards")


def _views(layout: SpaceLayout) -> dict[str, View]:
    """Return the views; the front is along a rotation, or along what a translation is across."""
    size = dict(zip("xyz", np.abs(layout.drive.direction), strict=True))
    if layout.drive.turns:
        front = max(AXES, key=lambda axis: size[axis])
    else:
        front = min(AXES, key=lambda axis: round(size[axis], 3))
    beside = max(
        (axis for axis in AXES if axis != front), key=lambda axis: _count_seen(layout, axis)
    )
    corner = np.array([CORNER[AXES[front][1]][axis] for axis in "xyz"]).T
    return {
        "front": _view_along(front),
        "side": _view_along(beside),
        "isometric": View(corner, "seen from the corner between the axes"),
    }


def _count_seen(layout: SpaceLayout, axis: str) -> int:
    """Return how many blades are seen along an axis."""
    return len(_as_planar(layout, _view_along(axis))[0].blades)


def space_drawing(
    ask: Ask,
    given: tuple[tuple[str, float], ...],
    notes: tuple[str, ...],
    cut: DrawnCut | None,
) -> Drawing:
    """Return a mechanism in space from the front, with the other views in ``views``."""
    space = ask.geometry.space_layout(ask.material.elastic, ask.sizes)
    scene, found, missed = ask.scene, {}, ""
    if scene.moves:
        try:
            found = {travel: at_travel(ask, travel) for travel in dict.fromkeys(scene.stroke_ends)}
        except (NotAvailable, SolveError) as reason:
            missed = str(reason)
    drawn = {
        name: _drawn_view(ask, space, view, found, given, notes, cut, missed)
        for name, view in _views(space).items()
    }
    views = {k: v for k, v in drawn.items() if k != "front"}
    return replace(drawn["front"], views=views, in_space=tuple(_in_space(space)))


def _in_space(layout: SpaceLayout) -> Iterator[DrawnInSpace]:
    """Yield blades in the plane across their width, and rods in that across themselves."""
    for member in layout.blades:
        l = float(np.linalg.norm(np.subtract(member.end, member.start)))
        axes, ends = member.axes, ((0.0, 0.0), (l, 0.0))
        if isinstance(member, SpaceRod):
            axes = axes[[1, 2, 0]]
            r = member.d / 2.0
            corners = [(r, 0.0), (0.0, r), (-r, 0.0), (0.0, -r)]
            quarters = zip(corners, [*corners[1:], corners[0]], strict=True)
            around = tuple(DrawnEdge(one, other, (0.0, 0.0)) for one, other in quarters)
            drawn = DrawnBlade(
                member.name, member.first, member.second, (), (member.d,), l, l / 2.0, (around,)
            )
        else:
            blade = Blade(member.name, member.first, member.second, *ends, member.profile, member.b)
            drawn = drawn_blade(blade, turning(0.0))
        x, y, z = ((float(a), float(b), float(c)) for a, b, c in axes)
        u, v, w = (float(c) for c in member.start)
        yield DrawnInSpace(drawn, (x, y, z), (u, v, w))


def _drawn_view(
    ask: Ask,
    space: SpaceLayout,
    view: View,
    moved: Mapping[float, SpaceEquilibrium],
    given: tuple[tuple[str, float], ...],
    notes: tuple[str, ...],
    cut: DrawnCut | None,
    missed: str,
) -> Drawing:
    """Return the mechanism as it is seen from one side."""
    layout, hidden = _as_planar(space, view)
    notes = (*notes, f"{view.words}; lengths as they look")
    if hidden:
        notes = (*notes, f"{hidden} blades are seen end on, and left out")
    if moved:
        notes = (*notes, "moved blades are cubics between their ends, turns of bodies as they look")
        notes = (
            *notes,
            "stress is von Mises' by exact beams, the largest of each section, of the stroke alone",
        )
    surfaces = dict(_surfaces(space, view))
    lengths = {m.name: float(np.linalg.norm(np.subtract(m.end, m.start))) for m in space.blades}
    turn = turning(0.0)
    drive = space.drive.body
    at = view.rows @ np.asarray(space.drive.point if space.drive.turns else space.body(drive).point)
    return Drawing(
        kind=ask.geometry.name,
        motion=ask.geometry.motion,
        blades=tuple(
            replace(
                drawn_blade(blade, turn),
                surface=surfaces.get(blade.name, ()),
                length=lengths[blade.name],
            )
            for blade in layout.blades
        ),
        bodies=drawn_bodies(layout, turn, drive),
        sizes=given,
        centre=place_of(at),
        case=ask.scene.case,
        unit=ask.geometry.travel_unit,
        states=tuple(_state(space, layout, view, *each) for each in moved.items()),
        axes=view.axes,
        missed=missed,
        is_a_view=True,
        notes=notes,
        cut=cut,
    )


def _state(
    space: SpaceLayout, layout: Layout, view: View, travel: float, state: SpaceEquilibrium
) -> DrawnState:
    """Return the mechanism at a travel, as it is seen."""
    shown = {blade.name for blade in layout.blades}
    axes, stress = {}, {}
    for member, felt in zip(space.blades, blade_stresses(state), strict=True):
        if member.name in shown:
            s = np.union1d(ALONG, felt.s)
            length = float(np.linalg.norm(np.subtract(member.end, member.start)))
            line = _cubic(*_moved_end(state, member.first, member.start, member.axes[0]),
                          *_moved_end(state, member.second, member.end, member.axes[0]),
                          length, s)  # fmt: skip
            axes[member.name] = drawn_line(line @ view.rows.T)
            largest = np.abs(section_peaks(felt)).max(axis=1)
            stress[member.name] = tuple(np.interp(s, felt.s, largest).tolist())
    motions = {}
    for body in space.bodies:
        motion = state.motion_of(body.name, body.point)
        x, y = view.rows @ motion[:3]
        motions[body.name] = (float(x), float(y), float(view.normal @ motion[3:]))
    return DrawnState(travel, axes, stress, motions)


def _moved_end(
    state: SpaceEquilibrium, body: str, end: tuple[float, float, float], along: Floats
) -> tuple[Floats, Floats]:
    """Return where an end of a blade went, and the way along the blade there."""
    turned = matrix_of(state.quaternion(body)) @ along
    return np.asarray(end) + state.shift_of(body, end), np.asarray(turned)


def _cubic(
    start: Floats, out: Floats, end: Floats, into: Floats, length: float, places: Floats
) -> Floats:
    """Return places on the cubic from one place and direction to another (Hermite)."""
    s = places[:, None]
    return np.asarray(
        (2 * s**3 - 3 * s**2 + 1) * start + (s**3 - 2 * s**2 + s) * length * out
        + (3 * s**2 - 2 * s**3) * end + (s**3 - s**2) * length * into
    )  # fmt: skip


def _as_planar(layout: SpaceLayout, view: View) -> tuple[Layout, int]:
    """Return a mechanism as a planar one seen from a side, and how many blades are end on."""
    rows = view.rows
    blades, hidden = [], 0
    for member in layout.blades:
        start, end = rows @ member.start, rows @ member.end
        length = float(np.linalg.norm(end - start))
        if length < END_ON * float(np.linalg.norm(np.subtract(member.end, member.start))):
            hidden += 1
            continue
        across = np.array([start[1] - end[1], end[0] - start[0]]) / length @ rows
        profile: Profile | None = None
        if isinstance(member, SpaceRod):
            thick, deep = member.d, member.d
        else:
            h = float(member.profile.h) if isinstance(member.profile, Constant) else 0.0
            thick = abs(float(across @ member.axes[1])) * h
            thick += abs(float(across @ member.axes[2])) * member.b
            deep = member.b
            if abs(float(across @ member.axes[1])) > 1.0 - ROUNDING:  # seen along its width
                profile = member.profile
        ends = place_of(start), place_of(end)
        height = float(view.normal @ (np.add(member.start, member.end) / 2.0))
        profile = profile or Constant(thick)
        blades.append(Blade(member.name, member.first, member.second, *ends, profile, deep, height))
    return Layout(tuple(_bodies(layout, rows)), tuple(blades), 1.0), hidden


def _bodies(layout: SpaceLayout, rows: Floats) -> Iterator[Body]:
    for body in layout.bodies:
        point, com = place_of(rows @ body.point), place_of(rows @ body.com)
        yield Body(body.name, point, body.mass, 0.0, com)


def _surfaces(layout: SpaceLayout, view: View) -> Iterator[tuple[str, tuple[XY, ...]]]:
    """Yield the middle surfaces of blades, as they are seen, that are not seen edge on."""
    for member in layout.blades:
        if isinstance(member, SpaceRod) or abs(float(view.normal @ member.axes[1])) < EDGE_ON:
            continue
        half = 0.5 * member.b * member.axes[2]
        start, end = np.asarray(member.start), np.asarray(member.end)
        corners = (start - half, start + half, end + half, end - half)
        yield member.name, tuple(place_of(view.rows @ corner) for corner in corners)
