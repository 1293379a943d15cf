"""A mechanism drawn to scale as SVG: in its plane, at rest and at the ends of its stroke.

Line weights 2:1 as in ISO 128; what the spec does not state (the shapes of bodies) is drawn plain
and named in the caption.
"""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import atan2, cos, degrees, floor, hypot, log10, pi, sin
from xml.sax.saxutils import escape

from flexcli.report.svg import STEPS, Box, Labels, Page, text_box
from flexcli.results.drawing import XY, Drawing, DrawnBlade, DrawnBody, DrawnState
from flexcli.units import show

__all__ = [
    "LIGHT",
    "STYLE",
    "blocks",
    "caption",
    "drawing_svg",
    "edge_of",
    "magnification",
    "sheet_of",
    "size_of",
]

TYPE, SMALL = 12.5, 11.5
"""Sizes of type [px]."""

WIDTH, ROOM, EDGE = 640.0, (440.0, 380.0), (100.0, 64.0)
"""Width of the page, the room that the mechanism is fitted into, and around it [px]."""

FOOT = 54.0
"""Height of the band at the foot that holds scale bar and legend [px]."""

THIN_BLADE = 1.2
"""Least width at which a blade is drawn [px]."""

CLAMP, INTO = 0.09, 0.13
"""Half the width of a clamp, and the depth of a body behind it, over the mechanism's size."""

PIN, EIGHTHS = 0.03, tuple(k * pi / 4.0 for k in range(8))
"""Half the width of a link about a pin over the mechanism's size, and the corners there."""

SEEN = 0.12
"""Share of the mechanism's size that the overlay is to move by."""

MOST_NAMED = 8
"""Bodies or blades beyond which they are not named one by one."""

LIGHT = {
    "paper": "#fff", "ink": "#16181b", "ink2": "#4a5057", "steel": "#e6e9ec", "motion": "#5a4fa3",
    "force": "#9a3412",
}  # fmt: skip
DARK = {
    "paper": "#121417", "ink": "#eceae6", "ink2": "#b9bec4", "steel": "#2b3036",
    "motion": "#b3a9f7", "force": "#ff9a70",
}  # fmt: skip
"""Colours; every one of text has a contrast of 7 and more on its paper."""


def _colours(names: dict[str, str]) -> str:
    return "".join(f"--{name}:{colour};" for name, colour in names.items())


STYLE = (
    f"""\
.dwg{{{_colours(LIGHT)}}}
@media screen and (prefers-color-scheme:dark){{.dwg{{{_colours(DARK)}}}}}
"""
    + """\
.dwg{font-family:"Helvetica Neue",Helvetica,Arial,"Liberation Sans",sans-serif}
.dwg .paper{fill:var(--paper)}
.dwg text{font-size:12.5px;fill:var(--ink);stroke:var(--paper);stroke-width:3.5px;\
stroke-linejoin:round;paint-order:stroke;font-variant-numeric:tabular-nums}
.dwg text.s{fill:var(--ink2);font-size:11.5px}
.dwg text.m{fill:var(--motion)}
.dwg text.f{fill:var(--force)}
.dwg .body{fill:var(--steel);stroke:var(--ink);stroke-width:1.5;stroke-linejoin:round}
.dwg .blade{fill:var(--ink);stroke:none}
.dwg .face{fill:var(--steel);stroke:var(--ink);stroke-width:.75;stroke-linejoin:round}
.dwg .curved{fill:var(--steel);stroke:var(--steel);stroke-width:.75}
.dwg .edge{stroke:var(--ink);stroke-width:1.5;fill:none}
.dwg .thin{stroke:var(--ink2);stroke-width:.75;fill:none}
.dwg .axis{stroke:var(--ink2);stroke-width:.75;stroke-dasharray:11 2.5 2 2.5;fill:none}
.dwg .plus{stroke:var(--motion);stroke-width:1.1;fill:none;stroke-linejoin:round}
.dwg .minus{stroke:var(--motion);stroke-width:.9;fill:none;stroke-dasharray:7 2 1.5 2 1.5 2}
.dwg .plusb{stroke:var(--motion);stroke-width:2;fill:none}
.dwg .head{fill:var(--ink2)}
.dwg .headf{fill:var(--force)}
.dwg .force{stroke:var(--force);stroke-width:1.75;fill:none}
.dwg .dot{fill:var(--ink)}
.dwg .hole{fill:var(--paper);stroke:var(--ink);stroke-width:1}
.dwg .heat{fill:none;stroke-width:3.2}
"""
)

HEAT = ("#fee8c8", "#fdd49e", "#fdbb84", "#fc8d59", "#ef6548", "#d7301f", "#990000")
"""Stress from none to the largest: a series of even steps in lightness (Brewer's OrRd)."""


def blocks(drawing: Drawing, body: DrawnBody) -> list[list[XY]]:
    """Return the plain blocks that stand for a body: around its clamps and what is behind them.

    It is one, unless that would lie over the blades; then there is one at each clamp.
    """
    feet = [_foot(*clamp, size_of(drawing)) for clamp in zip(
        body.clamps, body.ways, body.depths, strict=True
    )]  # fmt: skip
    whole = _hull([corner for foot in feet for corner in foot])
    if any(_is_inside(_along(blade, 0.5), whole) for blade in drawing.blades):
        return feet
    return [whole]


def _foot(place: XY, way: XY, depth: float, size: float) -> list[XY]:
    """Return the block behind one clamp, or about a pin."""
    (x, y), (wx, wy) = place, way
    if wx == wy == 0.0:  # a pin
        return [(x + PIN * size * cos(a), y + PIN * size * sin(a)) for a in EIGHTHS]
    half, deep = max(CLAMP * size, 0.75 * depth), INTO * size
    return [
        (x + s * half * wy + d * wx, y - s * half * wx + d * wy)
        for s, d in ((-1.0, deep), (-1.0, 0.0), (1.0, 0.0), (1.0, deep))
    ]


def _hull(points: Sequence[XY]) -> list[XY]:
    """Return the convex hull, anticlockwise (Andrew 1979)."""
    ordered = sorted(set(points))
    if len(ordered) < 3:
        return ordered

    def half(run: Sequence[XY]) -> list[XY]:
        chain: list[XY] = []
        for c in run:
            while len(chain) > 1 and _left(chain[-2], chain[-1], c) <= 0.0:
                chain.pop()
            chain.append(c)
        return chain[:-1]

    return half(ordered) + half(ordered[::-1])


def _left(a: XY, b: XY, c: XY) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def _is_inside(place: XY, hull: Sequence[XY]) -> bool:
    """Return whether a place lies within a convex outline that runs anticlockwise."""
    ends = [*hull[1:], hull[0]]
    return all(_left(a, b, place) > 0.0 for a, b in zip(hull, ends, strict=True))


def edge_of(blade: DrawnBlade) -> list[XY]:
    """Return the outline of a blade at rest [m]: one face from end to end, then the other back."""
    (x0, y0), (x1, y1) = blade.axis[0], blade.axis[-1]
    l = hypot(x1 - x0, y1 - y0)
    nx, ny = -(y1 - y0) / l, (x1 - x0) / l
    rigid = 3.0 * max(blade.thickness)
    halves = [0.5 * (h or rigid) for h in blade.thickness]
    left, right = (
        [
            (x + side * k * nx, y + side * k * ny)
            for (x, y), k in zip(blade.axis, halves, strict=True)
        ]
        for side in (1.0, -1.0)
    )
    return [*left, *right[::-1]]


def magnification(drawing: Drawing) -> float:
    """Return by how much the overlay's displacements are magnified: 1, 2, 3, 5 times a decade."""
    size = size_of(drawing)
    moved = [
        hypot(x - u, y - v)
        for state in drawing.states
        for blade in drawing.blades
        for (x, y), (u, v) in (
            (state.axes[blade.name][0], blade.axis[0]),
            (state.axes[blade.name][-1], blade.axis[-1]),
        )
    ]
    most = max(moved, default=0.0)
    if most == 0.0:
        return 1.0
    wanted = SEEN * size / most
    if wanted < 2.0:
        return 1.0
    decade = 10.0 ** floor(log10(wanted))
    return max(step * decade for step in (1.0, 2.0, 3.0, 5.0) if step * decade <= wanted)


def size_of(drawing: Drawing) -> float:
    """Return the larger side of what the blades or pins span [m]."""
    places = [place for blade in drawing.blades for place in blade.axis]
    places = places or [place for body in drawing.bodies for place in body.clamps]
    xs, ys = zip(*places, strict=True)
    return float(max(max(xs) - min(xs), max(ys) - min(ys)))


def caption(drawing: Drawing) -> str:
    """Return what the drawing shows and what of it the spec does not say."""
    said = ["To scale."]
    if drawing.states:
        times = magnification(drawing)
        ends = " and ".join(_travel(drawing, s.travel) for s in drawing.states)
        said.append(f"Moved by {ends}, displacements × {times:g}.")
    elif drawing.missed:
        said.append(f"Its stroke is not drawn: {drawing.missed}.")
    if drawing.twists:
        said.append("The bar twists about its axis; it is drawn from the side.")
    said.append("The shapes of the bodies are not in the spec and are drawn plain.")
    if any(len(blocks(drawing, b)) > 1 for b in drawing.bodies if not b.is_ground):
        said.append("Blocks that move alike are one body.")
    if any(0.0 in blade.thickness for blade in drawing.blades):
        said.append("Rigid stretches of a blade have no stated thickness.")
    said.extend(f"{note[0].upper()}{note[1:]}." for note in drawing.notes)
    return " ".join(said)


def _travel(drawing: Drawing, travel: float) -> str:
    text = f"{degrees(travel):.4g}°" if drawing.unit == "rad" else show(travel, "m")
    return text.replace("-", "−") if travel < 0.0 else f"+{text}"


def drawing_svg(drawing: Drawing, title: str, *, stress: bool = False) -> str:
    """Return the drawing as an SVG of its own, its blades by stress where that is asked."""
    sheet = _Sheet(drawing)
    sheet.mechanism(stress=stress)
    return sheet_of(sheet.page, title, caption(drawing))


def sheet_of(page: Page, title: str, description: str) -> str:
    """Return a page as an SVG that stands alone, with title and description for readers."""
    w, h = f"{page.width:.0f}", f"{page.height:.0f}"
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" class="dwg" role="img" width="{w}" height="{h}" '
        f'viewBox="0 0 {w} {h}"><title>{escape(title)}</title><desc>{escape(description)}</desc>'
        f'<style>{STYLE}</style><path class="paper" d="M0 0H{w}V{h}H0Z"/>'
        + "".join(page.shapes)
        + "</svg>\n"
    )


class _Sheet:
    """A drawing on its page: the scale, and what has its place already."""

    def __init__(self, drawing: Drawing) -> None:
        self.drawing = drawing
        self.size = size_of(drawing)
        self.times = magnification(drawing)
        self.blocks = {
            body.name: blocks(drawing, body) for body in drawing.bodies if not body.is_ground
        }
        places = [*self._extent()]
        lows, highs = ([f(side) for side in zip(*places, strict=True)] for f in (min, max))
        wide, high = (top - low or self.size for low, top in zip(lows, highs, strict=True))
        self.scale = min(ROOM[0] / wide, ROOM[1] / high)
        height = high * self.scale + 2.0 * EDGE[1] + FOOT
        self.page = Page(WIDTH, height)
        self.left = 0.5 * (WIDTH - wide * self.scale) - lows[0] * self.scale
        self.base = EDGE[1] + highs[1] * self.scale
        self.labels = Labels(Box(4.0, 4.0, WIDTH - 4.0, height - FOOT))
        self.unnamed: list[str] = []

    def _extent(self) -> Iterator[XY]:
        """Yield all places that have to be on the page [m]."""
        for body in self.drawing.bodies:
            yield from body.clamps
        for blade in self.drawing.blades:
            yield from edge_of(blade)
            for state in self.drawing.states:
                yield from self._bent(blade, state)
        for name, blocks_of in self.blocks.items():
            for block in blocks_of:
                yield from block
                for state in self.drawing.states:
                    yield from self._carried(name, block, state)
        if self.drawing.motion == "rotation":
            yield self.drawing.centre

    def _bent(self, blade: DrawnBlade, state: DrawnState) -> list[XY]:
        """Return the axis of a blade in a state, its displacements from rest magnified."""
        start, end = blade.axis[0], blade.axis[-1]
        line = state.axes[blade.name]
        length = hypot(end[0] - start[0], end[1] - start[1])
        found, gone = [], 0.0
        whole = sum(hypot(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(line)) or length
        for before, at in zip((line[0], *line), line, strict=False):
            gone += hypot(at[0] - before[0], at[1] - before[1])
            share = gone / whole
            rest = [a + share * (b - a) for a, b in zip(start, end, strict=True)]
            x, y = (r + self.times * (m - r) for r, m in zip(rest, at, strict=True))
            found.append((x, y))
        return found

    def _carried(self, name: str, block: Sequence[XY], state: DrawnState) -> list[XY]:
        """Return the block of a body in a state, its displacements magnified."""
        body = next(body for body in self.drawing.bodies if body.name == name)
        (u, v, phi), (px, py) = state.motions[name], body.point
        c, s = cos(phi), sin(phi)
        found = []
        for x, y in block:
            rx, ry = x - px, y - py
            dx, dy = u + (c - 1.0) * rx - s * ry, v + s * rx + (c - 1.0) * ry
            found.append((x + self.times * dx, y + self.times * dy))
        return found

    def at(self, place: XY) -> XY:
        """Return a place on the page [px]."""
        return self.left + self.scale * place[0], self.base - self.scale * place[1]

    def line(self, places: Sequence[XY]) -> list[XY]:
        """Return places on the page [px]."""
        return [self.at(place) for place in places]

    def mechanism(self, *, stress: bool) -> None:
        """Draw everything, labels last."""
        for body in self.drawing.bodies:
            if body.is_ground:
                self._ground(body)
            else:
                for block in map(self.line, self.blocks[body.name]):
                    self.page.path(block, "body", closed=True)
                    self.labels.keep_off(block, closed=True)
        for state, style in zip(self.drawing.states, ("plus", "minus"), strict=False):
            self._state(state, style)
        for blade in self.drawing.blades:
            self._blade(blade)
        if stress and self.drawing.states:
            self._heat(self.drawing.states[0])
        self._foot(stress=stress)
        self._centre()
        self._forces()
        self._lengths()
        self._angles()
        self._names()

    def _ground(self, body: DrawnBody) -> None:
        """Draw a line with hatching behind it at every clamp."""
        for place, (wx, wy), depth in zip(body.clamps, body.ways, body.depths, strict=True):
            x, y = self.at(place)
            half = max(18.0, 0.75 * depth * self.scale)
            tx, ty = wy, wx  # along the clamp on the page, whose y is down
            ends = [(x - half * tx, y - half * ty), (x + half * tx, y + half * ty)]
            self.page.path(ends, "edge")
            self.labels.keep_off(ends)
            steps = max(round(2.0 * half / 6.5), 2)
            for k in range(steps):
                share = -half + (k + 0.5) * 2.0 * half / steps
                sx, sy = x + share * tx, y + share * ty
                lean = (0.707 * (wx + tx), 0.707 * (-wy + ty))
                self.page.path([(sx, sy), (sx + 8.0 * lean[0], sy + 8.0 * lean[1])], "thin")

    def _blade(self, blade: DrawnBlade) -> None:
        edge = edge_of(blade)
        n = len(blade.axis)
        ends = self.line([blade.axis[0], blade.axis[-1]])
        for share in (0.0, 0.25, 0.5, 0.75, 1.0):  # also what a wide blade covers
            both = zip(edge[:n], edge[n:][::-1], strict=True)
            self.labels.keep_off(
                self.line([(u + share * (x - u), v + share * (y - v)) for (u, v), (x, y) in both])
            )
        if max(blade.thickness) * self.scale < THIN_BLADE and 0.0 not in blade.thickness:
            self.page.path(ends, "edge")
            return
        for first, last in pairwise(range(n)):
            rigid = 0.0 in (blade.thickness[first], blade.thickness[last])
            if rigid and blade.axis[first] != blade.axis[last]:
                stretch = self.line(self._stretch(blade, first, last))
                self.page.path(stretch, "body", closed=True)
        solid = [k for k in range(n) if blade.thickness[k] > 0.0]
        for run in _runs(solid):
            around = [edge[k] for k in run] + [edge[2 * n - 1 - k] for k in reversed(run)]
            if max(blade.thickness[k] for k in run) * self.scale < THIN_BLADE:
                self.page.path(self.line([blade.axis[run[0]], blade.axis[run[-1]]]), "edge")
            else:
                self.page.path(self.line(around), "blade", closed=True)

    def _stretch(self, blade: DrawnBlade, first: int, last: int) -> list[XY]:
        """Return the rectangle of a rigid stretch [m]."""
        (x0, y0), (x1, y1) = blade.axis[first], blade.axis[last]
        l = hypot(x1 - x0, y1 - y0)
        half = max(1.5 * max(blade.thickness), 4.0 / self.scale)
        nx, ny = -(y1 - y0) / l * half, (x1 - x0) / l * half
        return [(x0 + nx, y0 + ny), (x1 + nx, y1 + ny), (x1 - nx, y1 - ny), (x0 - nx, y0 - ny)]

    def _state(self, state: DrawnState, style: str) -> None:
        for name, block in ((n, block) for n, each in self.blocks.items() for block in each):
            moved = self.line(self._carried(name, block, state))
            self.page.path(moved, style, closed=True)
            self.labels.keep_off(moved, closed=True)
        for blade in self.drawing.blades:
            bent = self.line(self._bent(blade, state))
            self.page.path(bent, "plusb" if style == "plus" else style)
            self.labels.keep_off(bent)

    def _heat(self, state: DrawnState) -> None:
        """Draw the blades of the + end by their stress."""
        most = max(max(each) for each in state.stress.values())
        for blade in self.drawing.blades:
            places, stress = self.line(self._bent(blade, state)), state.stress[blade.name]
            for k, (start, end) in enumerate(pairwise(places)):
                share = 0.5 * (stress[k] + stress[k + 1]) / most if most else 0.0
                colour = HEAT[min(int(share * len(HEAT)), len(HEAT) - 1)]
                self.page.path([start, end], "heat", paint=f'stroke="{colour}"')

    def _centre(self) -> None:
        """Mark the centre of rotation, and how its path looks close by."""
        if self.drawing.motion == "rotation" and not self.drawing.twists:
            x, y = self.at(self.drawing.centre)
            self.page.circle((x, y), 4.5, "hole")
            self.page.circle((x, y), 1.4, "dot")
            self.labels.taken.append(Box(x - 6.0, y - 6.0, x + 6.0, y + 6.0))
        for body in self.drawing.bodies:
            if body.com is not None:
                x, y = self.at(body.com)
                self.page.circle((x, y), 4.5, "hole")
                for quarter in (0.0, pi):
                    turns = (quarter, quarter + pi / 2.0)
                    arc = [
                        (x + 4.5 * cos(a), y - 4.5 * sin(a))
                        for a in (turns[0] + k * (turns[1] - turns[0]) / 8.0 for k in range(9))
                    ]
                    self.page.path([(x, y), *arc], "dot", closed=True)

    def _forces(self) -> None:
        for force in self.drawing.forces:
            x, y = self.at(force.at)
            wx, wy = force.way[0], -force.way[1]
            start = (x - 64.0 * wx, y - 64.0 * wy)
            self.page.arrow(start, (x - 7.0 * wx, y - 7.0 * wy), "force", "headf", 11.0)
            self.labels.keep_off([start, (x, y)])
            self._label(f"{force.name} = {show(force.newtons, 'N')}", start, "f")

    def _lengths(self) -> None:
        """Draw the length of the first blade as a dimension, and say the other sizes."""
        if not self.drawing.blades:
            return
        blade = self.drawing.blades[0]
        (x0, y0), (x1, y1) = self.line([blade.axis[0], blade.axis[-1]])
        long = hypot(x1 - x0, y1 - y0)
        ux, uy = (x1 - x0) / long, (y1 - y0) / long
        if ux < -1e-9 or (abs(ux) < 1e-9 and uy > 0.0):  # read from below or from the right
            x0, y0, x1, y1, ux, uy = x1, y1, x0, y0, -ux, -uy
        l = hypot(*(b - a for a, b in zip(blade.axis[0], blade.axis[-1], strict=True)))
        text = f"{'l = ' if self._is_length('l', l) else ''}{show(l, 'm')}"
        tried = []
        clear = 0.5 * max(blade.thickness) * self.scale
        for off in (clear + 26.0, clear + 44.0, clear + 62.0, clear + 84.0):
            for side in (1.0, -1.0):
                nx, ny = side * uy * off, -side * ux * off
                middle = (0.5 * (x0 + x1) + nx, 0.5 * (y0 + y1) + ny)
                tried.append((_turned_box(text, middle, (ux, uy)), 1.2 * off, (nx, ny), side * off))
        found = self.labels.best((box, cost) for box, cost, *_ in tried)
        if found is None:
            self.unnamed.append(f"l = {show(l, 'm')}")
            return
        nx, ny = tried[found][2]
        start, end = (x0 + nx, y0 + ny), (x1 + nx, y1 + ny)
        away = hypot(nx, ny)
        for (ax, ay), (bx, by) in (((x0, y0), start), ((x1, y1), end)):
            gap, over = 3.0 / away, 4.0 / away
            self.page.path(
                [(ax + gap * (bx - ax), ay + gap * (by - ay)),
                 (bx + over * (bx - ax), by + over * (by - ay))],
                "thin",
            )  # fmt: skip
        middle = (0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]))
        self.page.arrow(middle, start, "thin", "head")
        self.page.arrow(middle, end, "thin", "head")
        self.labels.keep_off([start, end])
        above = (middle[0] + 4.5 * uy, middle[1] - 4.5 * ux)
        self.page.text(text, above, "middle", turn=degrees(atan2(uy, ux)))

    def _is_length(self, symbol: str, value: float) -> bool:
        return any(name == symbol and size == value for name, size in self.drawing.sizes)

    def _angles(self) -> None:
        for angle in self.drawing.angles:
            x, y = self.at(angle.at)
            self.page.arc((x, y), 38.0, (angle.start, angle.end), "thin")
            middle = 0.5 * (angle.start + angle.end)
            near = (x + 38.0 * cos(middle), y - 38.0 * sin(middle))
            self._label(f"{angle.name} = {degrees(angle.end - angle.start):.4g}°", near, "")
            for way in (angle.start, angle.end):
                end = (x + 46.0 * cos(way), y - 46.0 * sin(way))
                self.page.path([(x, y), end], "axis")

    def _names(self) -> None:
        """Name bodies and blades, and say the sizes that have no dimension line."""
        bodies = [body for body in self.drawing.bodies if not body.is_ground]
        if len(bodies) <= MOST_NAMED:
            for body in bodies:
                corners = self.line(self.blocks[body.name][0])
                x, y = (sum(side) / len(corners) for side in zip(*corners, strict=True))
                self._label(body.name, (x, y), "")
        for body in self.drawing.bodies:
            if body.is_ground:
                place, way = body.clamps[0], body.ways[0]
                x, y = self.at(place)
                self._label("ground", (x + 10.0 * way[0], y - 10.0 * way[1]), "s")
        if not self.drawing.blades:
            return
        said = [
            (symbol, size)
            for symbol, size in self.drawing.sizes
            if not (symbol == "l" and self._is_length("l", self._first_length()))
        ]
        for symbol, size in said[:MOST_NAMED]:
            name, blade = self._blade_of(symbol)
            near = self.at(_along(blade, 0.72 if symbol == "b" else 0.5))
            self._label(f"{name} = {show(size, 'm')}", near, "s")

    def _first_length(self) -> float:
        blade = self.drawing.blades[0]
        return hypot(*(b - a for a, b in zip(blade.axis[0], blade.axis[-1], strict=True)))

    def _blade_of(self, symbol: str) -> tuple[str, DrawnBlade]:
        """Return the letter of a size and its blade, the first where its symbol names none."""
        letter, _, of = symbol.partition("_")
        of = of.replace("_", "-")
        found = next((b for b in self.drawing.blades if of and b.name.startswith(of)), None)
        return (symbol, self.drawing.blades[0]) if found is None else (letter, found)

    def _label(self, text: str, near: XY, style: str) -> None:
        """Write a label near a place, with a leader where it stands far from it."""
        size = SMALL if style == "s" else TYPE
        found = self.labels.place(text, [near], size)
        if found is None:
            self.unnamed.append(text)
            return
        at, anchor, step = found
        if step > STEPS[2]:
            box = text_box(text, at, anchor, size)
            end = (min(max(near[0], box.left), box.right), min(max(near[1], box.top), box.bottom))
            self.page.path([near, end], "thin")
        self.page.text(text, at, anchor, style)

    def _foot(self, *, stress: bool) -> None:
        """Draw scale bar, axes, and what the overlay is."""
        y = self.page.height - 18.0
        length = _round_length(70.0 / self.scale)
        wide = length * self.scale
        self.page.path(
            [(16.0, y - 4.0), (16.0, y), (16.0 + wide, y), (16.0 + wide, y - 4.0)], "edge"
        )
        self.page.text(show(length, "m"), (24.0 + wide, y + 1.0), "start", "s")
        x = 190.0
        right, up = self.drawing.axes
        for name, way in ((right, (1.0, 0.0)), (up, (0.0, -1.0))):
            end = (x + 24.0 * way[0], y + 24.0 * way[1])
            self.page.arrow((x, y), end, "thin", "head")
            self.page.text(name, (end[0] + 5.0, end[1] + 4.0), "start", "s")
        x, y = 250.0, y - 8.0
        for state, style in zip(self.drawing.states, ("plus", "minus"), strict=False):
            self.page.path([(x, y - 4.0), (x + 26.0, y - 4.0)], style)
            text = _travel(self.drawing, state.travel)
            self.page.text(text, (x + 32.0, y), "start", "s")
            x += 48.0 + 7.2 * len(text)
        if self.drawing.states:
            self.page.text(f"displacements ×{self.times:g}", (x, y), "start", "s")
        x, y = 250.0, y + 17.0
        if stress and self.drawing.states:
            most = max(max(each) for each in self.drawing.states[0].stress.values())
            self.page.text("stress  0", (x, y), "start", "s")
            for k, colour in enumerate(HEAT):
                at = x + 58.0 + 8.0 * k
                swatch = [(at, y - 4.0), (at + 8.0, y - 4.0)]
                self.page.path(swatch, "heat", paint=f'stroke="{colour}"')
            self.page.text(show(most, "Pa"), (x + 120.0, y), "start", "s")


def _runs(places: Sequence[int]) -> Iterator[list[int]]:
    """Yield runs of numbers that follow each other."""
    run: list[int] = []
    for k in places:
        if run and k != run[-1] + 1:
            yield run
            run = []
        run.append(k)
    if run:
        yield run


def _along(blade: DrawnBlade, share: float) -> XY:
    (x0, y0), (x1, y1) = blade.axis[0], blade.axis[-1]
    return x0 + share * (x1 - x0), y0 + share * (y1 - y0)


def _turned_box(text: str, middle: XY, way: XY) -> Box:
    """Return the room of a text that is centred above a place and runs in a direction."""
    flat = text_box(text, (0.0, -4.5), "middle", TYPE)
    corners = [
        (middle[0] + x * way[0] - y * way[1], middle[1] + x * way[1] + y * way[0])
        for x in (flat.left, flat.right)
        for y in (flat.top, flat.bottom + 6.0)
    ]
    xs, ys = zip(*corners, strict=True)
    return Box(min(xs), min(ys), max(xs), max(ys))


def _round_length(wanted: float) -> float:
    """Return the largest 1, 2 or 5 times a power of ten that is not above a length."""
    decade = 10.0 ** floor(log10(wanted))
    return max(step * decade for step in (1.0, 2.0, 5.0) if step * decade <= wanted * (1 + 1e-12))
