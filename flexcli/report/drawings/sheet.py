"""The page of a drawing: its scale, the positions on it, and the areas in use."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import cos, hypot, sin

from flexcli.report.drawings.caption import magnification
from flexcli.report.drawings.outlines import blocks, edge_of, size_of
from flexcli.report.svg import STEPS, Box, Labels, Page, text_box
from flexcli.results.drawing import XY, Drawing, DrawnBlade, DrawnState

__all__ = ["FOOT", "TYPE", "WIDTH", "Sheet"]

TYPE, SMALL = 12.5, 11.5
"""Sizes of type [px]."""

WIDTH, HIGH, EDGE = 640.0, 380.0, 64.0
"""Width of the page, the height that the mechanism is fitted into, and above and below it [px]."""

BESIDE = 0.16
"""Share of the width that is left on either side for labels."""

FOOT = 76.0
"""Height of the band at the foot that holds scale bar and legend [px]."""


class Sheet:
    """A drawing on its page: the scale, and the areas in use."""

    def __init__(self, drawing: Drawing, width: float = WIDTH) -> None:
        self.drawing = drawing
        self.size = size_of(drawing)
        self.times = magnification(drawing)
        self.blocks = {
            body.name: blocks(drawing, body) for body in drawing.bodies if not body.is_ground
        }
        places = [*self._extent()]
        lows, highs = ([f(side) for side in zip(*places, strict=True)] for f in (min, max))
        wide, high = (top - low or self.size for low, top in zip(lows, highs, strict=True))
        self.scale = min((1.0 - 2.0 * BESIDE) * width / wide, HIGH / high)
        height = high * self.scale + 2.0 * EDGE + FOOT
        self.page = Page(width, height)
        self.left = 0.5 * (width - wide * self.scale) - lows[0] * self.scale
        self.base = EDGE + highs[1] * self.scale
        self.labels = Labels(Box(4.0, 4.0, width - 4.0, height - FOOT))
        self.unnamed: list[str] = []

    def _extent(self) -> Iterator[XY]:
        """Yield all places that have to be on the page [m]."""
        for body in self.drawing.bodies:
            yield from body.clamps
        for blade in self.drawing.blades:
            yield from blade.surface or edge_of(blade)
            for state in self.drawing.states:
                yield from self.bent(blade, state)
        for name, blocks_of in self.blocks.items():
            for block in blocks_of:
                yield from block
                for state in self.drawing.states:
                    yield from self.carried(name, block, state)
        if self.drawing.motion == "rotation":
            yield self.drawing.centre

    def bent(self, blade: DrawnBlade, state: DrawnState) -> list[XY]:
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

    def carried(self, name: str, block: Sequence[XY], state: DrawnState) -> list[XY]:
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

    def label(self, text: str, near: XY, style: str) -> None:
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
