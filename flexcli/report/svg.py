"""SVG as text: shapes in page pixels, and labels that keep off each other."""

from collections.abc import Iterable, Sequence
from itertools import pairwise
from math import cos, hypot, pi, sin
from typing import NamedTuple
from xml.sax.saxutils import escape

__all__ = ["Box", "Labels", "Page", "number", "text_box"]

XY = tuple[float, float]

WIDE = 0.62
"""Width of a character over the size of the type, on the safe side for figures and capitals."""

STEP = 8.0
"""Length of line that a label is kept off piece by piece [px]."""

STEPS = (9.0, 16.0, 26.0, 40.0, 58.0, 80.0, 110.0)
"""Distances at which a label is tried [px]."""

WAYS = (0.0, pi, pi / 2.0, -pi / 2.0, pi / 4.0, 3.0 * pi / 4.0, -pi / 4.0, -3.0 * pi / 4.0)
"""Directions in which it is tried, the best to read first."""


def number(x: float) -> str:
    """Return a coordinate to a hundredth of a pixel."""
    text = f"{x:.2f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def _drawn(style: str, paint: str) -> str:
    """Return the attributes that say how a shape is drawn."""
    return (f' class="{style}"' if style else "") + (f" {paint}" if paint else "")


class Box(NamedTuple):
    """A rectangle on the page [px]."""

    left: float
    top: float
    right: float
    bottom: float

    def overlap(self, other: "Box") -> float:
        """Return the area that two rectangles share [px²]."""
        wide = min(self.right, other.right) - max(self.left, other.left)
        high = min(self.bottom, other.bottom) - max(self.top, other.top)
        return max(wide, 0.0) * max(high, 0.0)

    def cut(self, start: XY, end: XY) -> float:
        """Return the length of a line within the rectangle [px] (Liang and Barsky 1984)."""
        if (
            max(start[0], end[0]) < self.left
            or min(start[0], end[0]) > self.right
            or max(start[1], end[1]) < self.top
            or min(start[1], end[1]) > self.bottom
        ):
            return 0.0
        way = (end[0] - start[0], end[1] - start[1])
        first, last = 0.0, 1.0
        sides = ((self.left, self.right), (self.top, self.bottom))
        for at, step, (least, most) in zip(start, way, sides, strict=True):
            if step == 0.0:
                if not least <= at <= most:
                    return 0.0
                continue
            enter, leave = sorted(((least - at) / step, (most - at) / step))
            first, last = max(first, enter), min(last, leave)
        return max(last - first, 0.0) * hypot(*way)


def text_box(text: str, at: XY, anchor: str, size: float) -> Box:
    """Return the room of a line of text whose baseline starts, is centred or ends at a place."""
    wide = WIDE * size * len(text)
    left = at[0] - {"start": 0.0, "middle": wide / 2.0, "end": wide}[anchor]
    return Box(left, at[1] - 0.8 * size, left + wide, at[1] + 0.25 * size)


class Page:
    """A page of SVG that grows by shapes; later ones lie over earlier ones."""

    def __init__(self, width: float, height: float) -> None:
        self.width, self.height = width, height
        self.shapes: list[str] = []

    def path(
        self, points: Sequence[XY], style: str = "", *, closed: bool = False, paint: str = ""
    ) -> None:
        """Draw a line through points, or around them, by the name of a style or in paint."""
        steps = "L".join(f"{number(x)} {number(y)}" for x, y in points)
        drawn = _drawn(style, paint)
        self.shapes.append(f'<path{drawn} d="M{steps}{"Z" if closed else ""}"/>')

    def arc(self, centre: XY, radius: float, angles: tuple[float, float], style: str) -> None:
        """Draw an arc between two angles of the page, anticlockwise from x [rad]."""
        (x, y), steps = centre, 24
        turns = [angles[0] + (angles[1] - angles[0]) * k / steps for k in range(steps + 1)]
        self.path([(x + radius * cos(a), y - radius * sin(a)) for a in turns], style)

    def circle(self, centre: XY, radius: float, style: str = "", *, paint: str = "") -> None:
        """Draw a circle."""
        x, y, r = (number(v) for v in (*centre, radius))
        self.shapes.append(f'<circle{_drawn(style, paint)} cx="{x}" cy="{y}" r="{r}"/>')

    def arrow(self, start: XY, end: XY, line: str, head: str, size: float = 8.5) -> None:
        """Draw a line with a head at its end, which is 3.8 px wide."""
        length = hypot(end[0] - start[0], end[1] - start[1]) or 1.0
        x, y = (end[0] - start[0]) / length, (end[1] - start[1]) / length
        foot = (end[0] - size * x, end[1] - size * y)
        self.path([start, foot if length > size else start], line)
        sides = [(foot[0] - 1.9 * s * y, foot[1] + 1.9 * s * x) for s in (1.0, -1.0)]
        self.path([end, *sides], head, closed=True)

    def text(
        self, text: str, at: XY, anchor: str = "start", style: str = "", turn: float = 0.0,
        *, paint: str = "",
    ) -> None:  # fmt: skip
        """Write a line, turned about its place by degrees clockwise."""
        x, y = number(at[0]), number(at[1])
        turned = f' transform="rotate({number(turn)} {x} {y})"' if turn else ""
        kind = _drawn(style, paint)
        self.shapes.append(
            f'<text{kind} x="{x}" y="{y}" text-anchor="{anchor}"{turned}>{escape(text)}</text>'
        )


class Labels:
    """Places for labels: clear of each other and of the page's edge, and of lines as may be."""

    def __init__(self, page: Box) -> None:
        self.page = page
        self.taken: list[Box] = []
        self.lines: list[tuple[XY, XY]] = []

    def keep_off(self, points: Sequence[XY], *, closed: bool = False) -> None:
        """Take a line as something that a label had better not cover, by steps that show."""
        kept = [points[0]]
        for point in points[1:-1]:
            if hypot(point[0] - kept[-1][0], point[1] - kept[-1][1]) > STEP:
                kept.append(point)
        kept.append(points[-1])
        self.lines.extend(pairwise([*kept, kept[0]] if closed else kept))

    def cost(self, box: Box) -> float:
        """Return how bad a place is: zero where nothing lies under it, infinite over a label."""
        inside = box.overlap(self.page)
        area = (box.right - box.left) * (box.bottom - box.top)
        if inside < area * (1.0 - 1e-9) or any(box.overlap(taken) > 0.0 for taken in self.taken):
            return float("inf")
        return sum(box.cut(start, end) for start, end in self.lines)

    def best(self, boxes: Iterable[tuple[Box, float]]) -> int | None:
        """Return which of some boxes, each with a cost of its own, is the best, and take it."""
        found: tuple[int, Box] | None = None
        least = float("inf")
        for k, (box, own) in enumerate(boxes):
            if own < least and (cost := self.cost(box) + own) < least:
                found, least = (k, box), cost
        if found is None:
            return None
        self.taken.append(found[1])
        return found[0]

    def place(self, text: str, near: Sequence[XY], size: float) -> tuple[XY, str, float] | None:
        """Return baseline, anchor and distance of a label near one of some places, if any is free.

        Of the places the first is as good as the last.
        """
        tried: list[tuple[XY, str, float]] = []
        for step in STEPS:
            for place in near:
                for way in WAYS:
                    x, y = place[0] + step * cos(way), place[1] - step * sin(way) + 0.3 * size
                    is_upright = abs(cos(way)) < 0.1
                    anchor = "middle" if is_upright else "start" if cos(way) > 0.0 else "end"
                    tried.append(((x, y), anchor, step))
        found = self.best(
            (_padded(text_box(text, at, anchor, size)), 0.6 * step) for at, anchor, step in tried
        )
        return None if found is None else tried[found]


def _padded(box: Box) -> Box:
    return Box(box.left - 2.0, box.top - 1.5, box.right + 2.0, box.bottom + 1.5)
