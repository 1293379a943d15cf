"""A mechanism cut by wire from one plate: the contours left between the slots.

Along both faces of every blade, and around every body that moves, runs a slot as wide as asked,
whose inner corners are no sharper than the wire leaves. What is left of the plate is the ground.
"""

from collections.abc import Iterator, Sequence
from itertools import combinations, pairwise
from math import atan2, cos, hypot, pi, sin, tan
from typing import Any, NamedTuple

from flexcli.errors import SolveError
from flexcli.report.cad_kernel import face, library, part
from flexcli.report.drawings.outlines import blocks
from flexcli.report.prisms import (
    MM,
    PLATE,
    Arc,
    Edges,
    Prism,
    anticlockwise,
    outline,
    rigid_middles,
    span_of,
)
from flexcli.results.drawing import XY, Drawing, DrawnBlade, DrawnBody, DrawnCut, DrawnEdge

__all__ = ["cut_plate"]

NEAR = 1e-9
"""Length [m] within which two places coincide: the accuracy of exported files."""

TURN = 1e-3
"""Angle [rad] between two edges that meet smoothly: the kernel places corners to 1e-7 mm."""

INTO = 1e-6
"""How far behind a clamp its body is looked for [m]."""

RIM = 5.0
"""What a plate that nobody draws reaches beyond all slots, over their width."""


class _Stretch(NamedTuple):
    """A stretch of a blade that flexes: its name, face and the ends of its middle line [m]."""

    name: str
    edges: Edges
    ends: tuple[XY, XY]
    halves: tuple[float, float]

    @property
    def along(self) -> XY:
        """Return its direction."""
        (x, y), (u, v) = self.ends
        return (u - x) / self.length, (v - y) / self.length

    @property
    def length(self) -> float:
        """Return how long it is [m]."""
        return _apart(*self.ends)

    def at(self, s: float, t: float) -> XY:
        """Return a place so far along it and to its left [m]."""
        (x, y), (c, n) = self.ends[0], self.along
        return x + s * c - t * n, y + s * n + t * c


class _Body(NamedTuple):
    """A body: its outlines [m], anticlockwise, and places that lie within it."""

    name: str
    outlines: tuple[tuple[XY, ...], ...]
    places: tuple[XY, ...]
    is_ground: bool


def cut_plate(drawing: Drawing) -> tuple[Prism, tuple[str, ...]]:
    """Return the plate with all its slots, and what to know of it.

    Raises
    ------
    SolveError
        ``no-cad`` without the library; ``not-cut`` where a wire cannot make the mechanism.

    """
    cut = drawing.cut
    assert cut is not None  # only such drawings are cut
    low, high = _span(drawing)
    library()
    stretches = _stretches(drawing)
    bodies = _bodies(drawing, cut)
    for stretch in stretches:
        _refuse_rough(stretch, cut)
    blades = [face(stretch.edges) for stretch in stretches]
    rooms = [face(_room(stretch, cut)) for stretch in stretches]
    moving = [body for body in bodies if not body.is_ground]
    loose = [
        _without(_joined([face(_rounded(corners, cut.radius)) for corners in body.outlines]), rooms)
        for body in moving
    ]
    around = [_grown(corners, cut.slot) for body in moving for corners in body.outlines]
    plate = _plate(bodies, [*rooms, *around], cut)
    ground = _without(plate, [*rooms, *around])
    pieces = [*_pieces(ground), *(piece for shape in loose for piece in _pieces(shape))]
    kept = _kept(pieces, bodies)
    for (name, one), (other_name, other) in combinations(
        [*zip((s.name for s in stretches), blades, strict=True)], 2
    ):
        _refuse_close((name, one), (other_name, other), cut.gap)
    for (name, one), (other_name, other) in combinations(kept.items(), 2):
        _refuse_close((name, one), (other_name, other), cut.gap)
    # a fillet touches the edge of its body: bars as thick as the roots are joined, then thinned
    bars = [face(outline(_bar(stretch))) for stretch in stretches]
    beside = [face(edges) for stretch in stretches for edges in _beside(stretch)]
    whole = _pieces(_without(_joined([*kept.values(), *bars]), beside))
    if len(whole) != 1:
        text = f"the cut leaves {len(whole)} separate pieces: a blade ends beside its bodies"
        raise _not_cut(text, "draw outlines that reach the ends of the blades")
    contours = _contours(whole[0])
    for contour in contours:
        _refuse_sharp(contour, cut.radius)
    outer, *holes = contours
    return Prism(drawing.kind, PLATE, outer, low, high, tuple(holes)), tuple(
        _notes(drawing, cut, len(pieces) - len(kept))
    )


def _not_cut(text: str, hint: str) -> SolveError:
    return SolveError("not-cut", text, f"{hint}; --plain writes blades and blocks without slots")


def _span(drawing: Drawing) -> tuple[float, float]:
    """Return from where to where the plate reaches across its plane [m]."""
    if drawing.is_a_view or drawing.twists or not drawing.blades:
        text = f"a {drawing.kind} is not planar: a wire cuts no slots that free it"
        raise _not_cut(text, "cut its parts one by one")
    spans = [span_of(blade) for blade in drawing.blades]
    for one, other in pairwise(spans):
        if max(abs(a - b) for a, b in zip(one, other, strict=True)) > NEAR:
            text = "its blades lie at several heights or are of several widths: no one plate"
            raise _not_cut(text, "cut each layer as a mechanism of its own")
    return spans[0]


# -- what is to be freed -----------------------------------------------------------------------


def _stretches(drawing: Drawing) -> list[_Stretch]:
    found = []
    for blade in drawing.blades:
        for k, edges in enumerate(blade.outlines, 1):
            name = blade.name if len(blade.outlines) == 1 else f"{blade.name} hinge {k}"
            found.append(_stretch(name, edges))
    return found


def _stretch(name: str, edges: tuple[DrawnEdge, ...]) -> _Stretch:
    """Return a stretch whose outline goes along its right face, across its end, and back."""
    far, near = edges[len(edges) // 2 - 1], edges[-1]
    ends = _middle(near), _middle(far)
    plain = _Stretch(name, edges, ends, (0.0, 0.0))
    (x, y), (c, n) = ends[0], plain.along
    apart = [abs((v - y) * c - (u - x) * n) for u, v in (edge.start for edge in edges)]
    return plain._replace(halves=(min(apart), max(apart)))


def _middle(edge: DrawnEdge) -> XY:
    return (edge.start[0] + edge.end[0]) / 2.0, (edge.start[1] + edge.end[1]) / 2.0


def _bodies(drawing: Drawing, cut: DrawnCut) -> list[_Body]:
    """Return all bodies, and the rigid middles of blades."""
    known = {_spoken(body): body for body in drawing.bodies}
    for name in cut.outlines:
        if name not in known:
            text = f"there is no body '{name}' to give an outline"
            raise SolveError("no-such-body", text, f"one of {', '.join(known)}")
    found = [
        _Body(
            name,
            _outlines(drawing, body, cut.outlines.get(name)),
            tuple(_behind(body)),
            body.is_ground,
        )
        for name, body in known.items()
    ]
    return found + [
        _Body(f"{blade.name} middle", (tuple(anticlockwise(corners)),), (_centre(corners),), False)
        for blade in drawing.blades
        for corners in rigid_middles(blade)
    ]


def _spoken(body: DrawnBody) -> str:
    """Return the name of a body in a spec."""
    return "moving" if body.name == "moving body" else body.name


def _outlines(
    drawing: Drawing, body: DrawnBody, given: Sequence[XY] | None
) -> tuple[tuple[XY, ...], ...]:
    each = blocks(drawing, body) if given is None else [given]
    return tuple(tuple(anticlockwise(corners)) for corners in each)


def _behind(body: DrawnBody) -> Iterator[XY]:
    for (x, y), (c, n) in zip(body.clamps, body.ways, strict=True):
        yield x + INTO * c, y + INTO * n


def _centre(corners: Sequence[XY]) -> XY:
    return sum(x for x, _ in corners) / len(corners), sum(y for _, y in corners) / len(corners)


def _refuse_rough(stretch: _Stretch, cut: DrawnCut) -> None:
    """Raise where a wire does not fit beside a blade, or cannot leave roots that sharp."""
    if stretch.length < cut.gap - NEAR:
        text = f"{stretch.name} is {_mm(stretch.length)} long: no wire fits into its slots"
        raise _not_cut(text, f"{_mm(cut.gap)} is the narrowest that can be made")
    root = stretch.edges[0]
    if root.centre is None and stretch.halves[1] - stretch.halves[0] < NEAR:
        text = f"the roots of {stretch.name} are sharp, and a wire leaves {_mm(cut.radius)}"
        hint = f"state root_radius: {_mm(cut.radius)}, or of a drawn blade a filleted profile"
        raise _not_cut(text, hint)


def _mm(length: float) -> str:
    return f"{length * MM:.4g} mm"


# -- slots ---------------------------------------------------------------------------------------


def _room(stretch: _Stretch, cut: DrawnCut) -> Edges:
    """Return the outline of a stretch with the slots along both its faces, its corners round."""
    thin, thick = stretch.halves
    r = min(cut.radius, stretch.length / 2.0)
    return _with_arcs(_bar(stretch, max(thin + cut.slot, thick + r)), [r] * 4)


def _bar(stretch: _Stretch, half: float | None = None) -> list[XY]:
    """Return the corners of a bar as long as a stretch, and as thick or so thick [m]."""
    l, t = stretch.length, stretch.halves[1] if half is None else half
    return [stretch.at(*corner) for corner in ((0.0, -t), (l, -t), (l, t), (0.0, t))]


def _beside(stretch: _Stretch) -> Iterator[Edges]:
    """Yield the outlines between the bar as thick as a stretch and its faces."""
    if stretch.halves[1] - stretch.halves[0] < NEAR:
        return
    n = len(stretch.edges) // 2 - 1
    low_start, low_end, high_end, high_start = _bar(stretch)
    for run, way in (
        (stretch.edges[:n], (low_end, low_start)),
        (stretch.edges[n + 1 : 2 * n + 1], (high_start, high_end)),
    ):
        places = [run[-1].end, *way, run[0].start]
        closing = [DrawnEdge(a, b) for a, b in pairwise(places) if _apart(a, b) > NEAR]
        yield (*run, *closing)


def _apart(one: XY, other: XY) -> float:
    return hypot(other[0] - one[0], other[1] - one[1])


def _rounded(corners: Sequence[XY], radius: float) -> Edges:
    """Return an outline with its inner corners rounded as a wire leaves them."""
    turns = _turns(corners)
    return _with_arcs(corners, [radius if turn < -TURN else 0.0 for turn in turns])


def _turns(corners: Sequence[XY]) -> list[float]:
    """Return by what an outline turns to the left at each corner [rad]."""
    n = len(corners)
    found = []
    for k, (x, y) in enumerate(corners):
        (a, b), (c, d) = corners[k - 1], corners[(k + 1) % n]
        back, on = (x - a, y - b), (c - x, d - y)
        cross, dot = back[0] * on[1] - back[1] * on[0], back[0] * on[0] + back[1] * on[1]
        found.append(atan2(cross, dot))
    return found


def _with_arcs(corners: Sequence[XY], radii: Sequence[float]) -> Edges:
    """Return an outline whose corners are arcs of given radii [m], tangent to its sides."""
    n, turns = len(corners), _turns(corners)
    cuts = [r * abs(tan(turn / 2.0)) for r, turn in zip(radii, turns, strict=True)]
    edges: list[DrawnEdge | Arc] = []
    begin: list[XY] = []
    finish: list[XY] = []
    for k, (x, y) in enumerate(corners):
        (a, b), (c, d) = corners[k - 1], corners[(k + 1) % n]
        before, after = _apart((a, b), (x, y)), _apart((x, y), (c, d))
        if cuts[k] + cuts[k - 1] > before + NEAR:
            text = f"an outline has a side of {_mm(before)} between corners"
            raise _not_cut(text, f"leave room for inner radii of {_mm(max(radii))}")
        begin.append((x - (x - a) / before * cuts[k], y - (y - b) / before * cuts[k]))
        finish.append((x + (c - x) / after * cuts[k], y + (d - y) / after * cuts[k]))
    for k, (radius, turn) in enumerate(zip(radii, turns, strict=True)):
        if cuts[k] > 0.0:
            (x, y), (a, b), (c, d) = begin[k], corners[k - 1], corners[k]
            side = (radius if turn > 0.0 else -radius) / _apart((a, b), (c, d))
            centre = (x - (d - b) * side, y + (c - a) * side)
            edges.append(Arc(begin[k], finish[k], centre, turn))
        end = begin[(k + 1) % n]
        if _apart(finish[k], end) > NEAR:
            edges.append(DrawnEdge(finish[k], end))
    return tuple(edges)


def _grown(corners: Sequence[XY], by: float) -> Any:
    """Return all that is no farther from an outline, or within it [m]."""
    shapes = [face(outline(corners))]
    for (x, y), (u, v) in zip(corners, [*corners[1:], corners[0]], strict=True):
        l = _apart((x, y), (u, v))
        a, b = (v - y) / l * by, -(u - x) / l * by
        shapes.append(face(outline([(x, y), (x + a, y + b), (u + a, v + b), (u, v)])))
        shapes.append(face(_circle((x, y), by)))
    return _joined(shapes)


def _circle(centre: XY, r: float) -> Edges:
    x, y = centre
    right, left = (x + r, y), (x - r, y)
    return Arc(right, left, centre, pi), Arc(left, right, centre, pi)


def _plate(bodies: Sequence[_Body], cleared: Sequence[Any], cut: DrawnCut) -> Any:
    """Return the plate: as drawn, else a rectangle about everything."""
    drawn = cut.outlines.get("ground")
    if drawn is not None:
        return face(_rounded(anticlockwise(drawn), cut.radius))
    box = part("Bnd").Bnd_Box()
    shapes = [face(outline(corners)) for body in bodies for corners in body.outlines]
    for shape in (*cleared, *shapes):
        part("BRepBndLib").BRepBndLib.AddOptimal_s(shape, box, False, False)
    low, high, rim = box.CornerMin(), box.CornerMax(), RIM * cut.slot
    (x, y), (u, v) = ((end.X() / MM, end.Y() / MM) for end in (low, high))
    x, y, u, v = x - rim, y - rim, u + rim, v + rim
    return face(outline([(x, y), (u, y), (u, v), (x, v)]))


# -- what is left --------------------------------------------------------------------------------


def _joined(shapes: Sequence[Any]) -> Any:
    """Return plane faces as one shape, edges between them gone."""
    first, *others = shapes
    return _boolean("BRepAlgoAPI_Fuse", first, others)


def _without(shape: Any, others: Sequence[Any]) -> Any:
    """Return a plane shape less others."""
    return _boolean("BRepAlgoAPI_Cut", shape, others)


def _boolean(name: str, first: Any, others: Sequence[Any]) -> Any:
    if not others:
        return first
    operation = getattr(part("BRepAlgoAPI"), name)()
    for take, shapes in ((operation.SetArguments, [first]), (operation.SetTools, others)):
        listed = part("collections").List_TopoDS_Shape()
        for shape in shapes:
            listed.Append(shape)
        take(listed)
    operation.Build()
    same = part("ShapeUpgrade").ShapeUpgrade_UnifySameDomain(operation.Shape(), True, True, False)
    same.Build()
    return same.Shape()


def _pieces(shape: Any) -> list[Any]:
    """Return the faces of a plane shape, each of one piece."""
    return list(_explored(shape, "Face"))


def _explored(shape: Any, kind: str) -> Iterator[Any]:
    """Yield the faces or wires of a shape."""
    explorer = part("TopExp").TopExp_Explorer(
        shape, getattr(part("TopAbs"), f"TopAbs_{kind.upper()}")
    )
    as_kind = getattr(part("TopoDS").TopoDS, kind)
    while explorer.More():
        yield as_kind(explorer.Current())
        explorer.Next()


def _kept(pieces: Sequence[Any], bodies: Sequence[_Body]) -> dict[str, Any]:
    """Return the piece of each body; loose pieces fall out."""
    found: dict[str, Any] = {}
    owner: dict[int, str] = {}
    for body in bodies:
        at = {next((k for k, p in enumerate(pieces) if _holds(p, x)), -1) for x in body.places}
        if at == {-1} or len(at) != 1:
            text = (
                f"{body.name} is in {len(at)} pieces"
                if -1 not in at
                else (f"a blade ends beside {body.name}")
            )
            hint = f"draw it in manufacturing.outlines.{body.name}, about the ends of its blades"
            raise _not_cut(text, hint)
        (k,) = at
        if k in owner:
            text = f"{body.name} and {owner[k]} are one piece: nothing is free to move"
            raise _not_cut(text, "draw their outlines apart")
        found[body.name], owner[k] = pieces[k], body.name
    return found


def _holds(piece: Any, place: XY) -> bool:
    point = part("gp").gp_Pnt(place[0] * MM, place[1] * MM, 0.0)
    classifier = part("BRepClass").BRepClass_FaceClassifier(piece, point, NEAR * MM)
    return bool(classifier.State().name == "TopAbs_IN")


def _refuse_close(one: tuple[str, Any], other: tuple[str, Any], gap: float) -> None:
    apart = part("BRepExtrema").BRepExtrema_DistShapeShape(one[1], other[1]).Value() / MM
    if apart < gap - NEAR:
        text = f"{one[0]} and {other[0]} are {_mm(apart)} apart"
        raise _not_cut(text, f"{_mm(gap)} is the narrowest that can be made")


def _contours(piece: Any) -> list[Edges]:
    """Return the outer contour, anticlockwise, then those within it, clockwise [m]."""
    outer = part("BRepTools").BRepTools.OuterWire_s(piece)
    inner = [wire for wire in _explored(piece, "Wire") if not wire.IsSame(outer)]
    found = []
    for k, wire in enumerate((outer, *inner)):
        edges: list[DrawnEdge | Arc] = []
        walk = part("BRepTools").BRepTools_WireExplorer(wire, piece)
        while walk.More():
            edges.extend(_edges(walk.Current()))
            walk.Next()
        area = _area(edges)
        if (area > 0.0) != (k == 0):
            edges = [_back(edge) for edge in reversed(edges)]
        found.append(tuple(edges))
    return found


def _area(edges: Sequence[DrawnEdge | Arc]) -> float:
    """Return the area of the polygon through the middles and ends of edges, with its sign."""
    places = []
    for edge in edges:
        places.append(edge.start)
        if isinstance(edge, Arc):
            (x, y), (a, b) = edge.centre, edge.start
            c, s = cos(edge.sweep / 2.0), sin(edge.sweep / 2.0)
            places.append((x + c * (a - x) - s * (b - y), y + s * (a - x) + c * (b - y)))
    around = zip(places, [*places[1:], places[0]], strict=True)
    return sum(x * v - u * y for (x, y), (u, v) in around) / 2.0


def _back(edge: DrawnEdge | Arc) -> DrawnEdge | Arc:
    if isinstance(edge, Arc):
        return Arc(edge.end, edge.start, edge.centre, -edge.sweep)
    return edge._replace(start=edge.end, end=edge.start)


def _edges(edge: Any) -> Iterator[DrawnEdge | Arc]:
    """Yield an edge of the kernel as it is walked, an ellipse in its quarters [m]."""
    curve = part("BRepAdaptor").BRepAdaptor_Curve(edge)
    kind = curve.GetType().name
    first, last = curve.FirstParameter(), curve.LastParameter()
    is_back = edge.Orientation().name == "TopAbs_REVERSED"

    def place(at: float) -> XY:
        point = curve.Value(at)
        return point.X() / MM, point.Y() / MM

    found: list[DrawnEdge | Arc]
    if kind == "GeomAbs_Line":
        found = [DrawnEdge(place(first), place(last))]
    elif kind == "GeomAbs_Circle":
        circle = curve.Circle()
        at = circle.Location()
        up = 1.0 if circle.Axis().Direction().Z() > 0.0 else -1.0
        found = [Arc(place(first), place(last), (at.X() / MM, at.Y() / MM), up * (last - first))]
    else:
        at = curve.Ellipse().Location()
        centre, steps = (at.X() / MM, at.Y() / MM), round((last - first) / (pi / 2.0))
        ends = [first + k * (pi / 2.0) for k in range(steps)] + [last]
        found = [DrawnEdge(place(a), place(b), centre) for a, b in pairwise(ends)]
    yield from (_back(each) for each in reversed(found)) if is_back else found


def _refuse_sharp(contour: Edges, radius: float) -> None:
    """Raise where a contour with the metal on its left has a corner that no wire can cut."""
    for edge, after in zip(contour, (*contour[1:], contour[0]), strict=True):
        (a, b), (c, d) = _way(edge, 1), _way(after, 0)
        x, y = (f"{each * MM:.4g}" for each in edge.end)
        if atan2(a * d - b * c, a * c + b * d) < -TURN:
            text = f"an inner corner at ({x}, {y}) mm is sharp, and a wire leaves {_mm(radius)}"
            raise _not_cut(text, "round it, or draw the bodies beside it otherwise")
        r = _inner_radius(edge)
        if r is not None and r < radius - NEAR:
            text = f"an inner radius at ({x}, {y}) mm is {_mm(r)}, and a wire leaves {_mm(radius)}"
            raise _not_cut(text, "make it larger")


def _inner_radius(edge: DrawnEdge | Arc) -> float | None:
    """Return the least radius of an edge with the metal outside of it, on its left [m]."""
    if edge.centre is None:
        return None
    if isinstance(edge, Arc):
        return _apart(edge.start, edge.centre) if edge.sweep < 0.0 else None
    x, y = edge.centre
    (a, b), (c, d) = ((u - x, v - y) for u, v in (edge.start, edge.end))
    least, most = sorted((hypot(a, b), hypot(c, d)))
    return least**2 / most if a * d - b * c < 0.0 else None


def _way(edge: DrawnEdge | Arc, end: int) -> XY:
    """Return the direction in which an edge is walked at its start (0) or its end (1)."""
    if edge.centre is None:
        return edge.end[0] - edge.start[0], edge.end[1] - edge.start[1]
    x, y = edge.centre
    (a, b), (c, d) = ((u - x, v - y) for u, v in (edge.start, edge.end))
    if isinstance(edge, Arc):
        side = 1.0 if edge.sweep > 0.0 else -1.0
        u, v = (c, d) if end else (a, b)
        return -v * side, u * side
    # a quarter of an ellipse leaves along the other half-axis
    return (-a, -b) if end else (c, d)


def _notes(drawing: Drawing, cut: DrawnCut, fallen: int) -> Iterator[str]:
    yield (
        f"one plate with slots of {_mm(cut.slot)} and inner radii of {_mm(cut.radius)}; the shape "
        "of bodies is that of manufacturing.outlines, else plain blocks in a plain plate"
    )
    if fallen:
        pieces = "piece falls" if fallen == 1 else "pieces fall"
        yield f"{fallen} {pieces} out of the plate, and {'is' if fallen == 1 else 'are'} left out"
    far = max((_farthest(drawing, blade) for blade in drawing.blades), default=0.0)
    if far > cut.slot:
        yield (
            f"a blade moves by up to {_mm(far)}, the slots are {_mm(cut.slot)} wide: they stop the "
            "stroke; state manufacturing.slot"
        )


def _farthest(drawing: Drawing, blade: DrawnBlade) -> float:
    """Return how far a blade moves away from where it is at rest [m]."""
    (x, y), (u, v) = blade.axis[0], blade.axis[-1]
    l = _apart((x, y), (u, v))
    c, n = (u - x) / l, (v - y) / l
    return max(
        (
            abs((b - y) * c - (a - x) * n)
            for state in drawing.states
            for a, b in state.axes[blade.name]
        ),
        default=0.0,
    )
