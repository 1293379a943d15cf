"""Charts as SVG: curves, bars and areas on linear or logarithmic axes, to stand on a page.

The colours are the variables of the page, so that a chart follows it into the dark. It is as wide
as half of a page's text, so that type has its own size there; where the page enlarges the type,
as on phones, there is room for it.
"""

from collections.abc import Callable, Iterator, Sequence
from itertools import accumulate
from math import ceil, floor, isfinite, log10
from textwrap import wrap
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.report.svg import XY, Box, Labels, Page, text_box

__all__ = ["COLOURS", "DASHES", "Axis", "Chart", "standalone"]

Floats = NDArray[np.float64]

COLOURS = {
    "paper": "#fff", "ink": "#16181b", "ink2": "#4a5057", "ink3": "#676e75", "hair": "#e8eaec",
    "motion": "#5a4fa3", "force": "#9a3412", "fail": "#a8320a", "undecided": "#765300",
    "pass": "#0b5a85",
}  # fmt: skip
"""Colours of the page by name, as they are in the light."""

DASHES = ("", "6 3", "1.5 2.5", "8 2.5 1.5 2.5", "12 4", "4 1.5")
"""Dashes of curves [px], in the order in which curves are told apart by them."""

WIDTH, HEIGHT = 432.0, 202.0
"""Width, and height of the plane that curves are drawn in [px]."""

TYPE = 14.5
"""Largest type that there is room for [px]; it is 12 px high where nothing enlarges it."""

RIGHT, TOP, ROW = 10.0, 8.0, 19.0
"""Room right of the plane and above it, and height of a line of text [px]."""

BAR, LETTERS = 40.0, 50
"""Height of a bar with its name above it [px], and letters of that on a line."""

MOST_ZEROS = 4
"""Powers of ten from this on are written with an exponent."""

RAISED = str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")

HALO = 'stroke="var(--paper)" stroke-width="3" paint-order="stroke"'
"""Of paper about text, so that what it lies over does not cross it."""

PLAIN = 1e-9
"""Share of a value that is rounding: curves that vary by less are level."""


class Axis(NamedTuple):
    """What is along an axis, with its unit; ``log`` for tenfold steps.

    ``least`` and ``most`` are shown at least; ``names`` stand for the numbers 0, 1, 2 … .
    """

    label: str
    log: bool = False
    least: float = float("inf")
    most: float = float("-inf")
    names: tuple[str, ...] = ()


class _Item(NamedTuple):
    """Something to draw between axes: where it reaches, and how it is drawn there."""

    x: Floats
    y: Floats
    draw: Callable[["_Plane"], None]


class Chart:
    """A chart that grows by curves, marks, rules, bars and areas; its axes follow from them."""

    def __init__(self, x: Axis, y: Axis) -> None:
        self.x, self.y = x, y
        self.items: list[_Item] = []
        self.legend: list[tuple[str, str]] = []

    def curve(
        self,
        x: Any,
        y: Any,
        name: str = "",
        dash: str = "",
        colour: str = "ink",
        width: float = 1.5,
    ) -> None:
        """Draw a line through points; where a number is missing it has a gap."""
        x, y = (np.asarray(v, dtype=np.float64) for v in (x, y))
        style = _stroke(colour, width, dash)
        self._add(x, y, lambda plane: plane.line(x, y, style))
        if name:
            self.legend.append((name, style))

    def marks(self, x: Any, y: Any, colour: str = "ink", *, filled: bool = True) -> None:
        """Draw a ring or a dot at each point."""
        x, y = (np.atleast_1d(np.asarray(v, dtype=np.float64)) for v in (x, y))
        inside = f"var(--{colour})" if filled else "var(--paper)"
        style = f'fill="{inside}" stroke="var(--{colour})"'
        self._add(x, y, lambda plane: plane.dots(x, y, style))

    def rule(
        self, *, x: float | None = None, y: float | None = None, name: str = "",
        colour: str = "ink", width: float = 1.0,
    ) -> None:  # fmt: skip
        """Draw a line right across the plane where x or y has a value."""
        none = np.zeros(0)
        at = [none if v is None else np.array([v]) for v in (x, y)]
        style = _stroke(colour, width)
        self._add(at[0], at[1], lambda plane: plane.rule(x, y, name, colour, style))

    def band(self, low: float, high: float) -> None:
        """Shade between two values of x."""
        ends = np.array([low, high])
        self._add(ends, np.zeros(0), lambda plane: plane.band(low, high))

    def areas(self, corners: Sequence[Floats]) -> None:
        """Shade areas by their corners."""
        self._add(np.zeros(0), np.zeros(0), lambda plane: plane.areas(corners))

    def note(self, text: str, x: Any, y: Any, colour: str = "ink2") -> None:
        """Write beside one of some points, where there is room."""
        x, y = (np.atleast_1d(np.asarray(v, dtype=np.float64)) for v in (x, y))
        self._add(x, y, lambda plane: plane.note(text, x, y, colour))

    def bar(self, row: int, low: float, high: float, colour: str, *, filled: bool = True) -> None:
        """Draw a bar along x in a row."""
        ends = np.array([low, high])
        style = f'fill="var(--{colour})"' if filled else (
            f'fill="none" stroke-dasharray="3 2" stroke="var(--{colour})"'
        )  # fmt: skip
        self._add(ends, np.zeros(0), lambda plane: plane.bar(row, low, high, style))

    def column(self, low: float, high: float, top: float) -> None:
        """Draw an upright bar from zero over a range of x."""
        ends, tops = np.array([low, high]), np.array([0.0, top])
        self._add(ends, tops, lambda plane: plane.column(low, high, top))

    def tick(self, row: int, x: float) -> None:
        """Mark a value of x in a row."""
        self._add(np.array([x]), np.zeros(0), lambda plane: plane.tick(row, x))

    def _add(self, x: Floats, y: Floats, draw: Callable[["_Plane"], None]) -> None:
        self.items.append(_Item(x, y, draw))

    def svg(self) -> str:
        """Return the chart as SVG, its colours named."""
        plane = _Plane(self)
        plane.grid()
        for item in self.items:
            item.draw(plane)
        plane.write_notes()
        width, height = f"{WIDTH:.0f}", f"{plane.page.height:.0f}"
        return (
            f'<svg xmlns="http://www.w3.org/2000/svg" class="plot" viewBox="0 0 {width} {height}" '
            f'font-size="12" stroke-linejoin="round">{"".join(plane.page.shapes)}</svg>\n'
        )


def standalone(svg: str) -> str:
    """Return a chart as a drawing of its own, in light colours on white."""
    for name, colour in COLOURS.items():
        svg = svg.replace(f"var(--{name})", colour)
    width, height = svg.split('viewBox="0 0 ')[1].split('"')[0].split()
    faces = "Helvetica Neue, Helvetica, Arial, Liberation Sans, DejaVu Sans, sans-serif"
    own = f'<svg width="{width}" height="{height}" font-family="{faces}" '
    # a style for the background is not painted by what makes a PNG of it
    paper = '><rect width="100%" height="100%" fill="#fff"/>'
    return svg.replace("<svg ", own, 1).replace(">", paper, 1)


def _stroke(colour: str, width: float, dash: str = "") -> str:
    dashes = f' stroke-dasharray="{dash}"' if dash else ""
    return f'fill="none" stroke="var(--{colour})" stroke-width="{width:g}"{dashes}'


class _Scale:
    """An axis on the page: where a value stands, and which values are told."""

    def __init__(self, axis: Axis, values: Floats, start: float, end: float) -> None:
        self.log, self.start, self.end = axis.log, start, end
        values = values[np.isfinite(values) & ((values > 0.0) if axis.log else True)]
        inside = [*values.tolist(), *filter(isfinite, (axis.least, axis.most))] or [1.0]
        low, high = min(inside), max(inside)
        if axis.log:
            low, high = log10(low), log10(high)
            gap = 0.03 * (high - low) if high - low > PLAIN else 0.5
        else:
            level = high - low <= PLAIN * max(abs(low), abs(high))
            gap = (0.5 * abs(high) or 0.5) if level else 0.05 * (high - low)
        stands = not axis.log and low == 0.0  # what is never negative stands on its axis
        self.low, self.high = low if stands else low - gap, high + gap

    def at(self, values: Any) -> Any:
        """Return where values stand [px]."""
        v = np.asarray(values, dtype=np.float64)
        if self.log:
            with np.errstate(divide="ignore", invalid="ignore"):
                v = np.where(v > 0.0, np.log10(np.where(v > 0.0, v, 1.0)), np.nan)
        return self.start + (v - self.low) / (self.high - self.low) * (self.end - self.start)

    def ticks(self, most: int) -> list[tuple[float, str]]:
        """Return values that are told, with their text: at most so many, evenly spread."""
        if not self.log:
            return _even(self.low, self.high, most)
        if self.high - self.low < 0.6:
            return [t for t in _even(10.0**self.low, 10.0**self.high, most) if t[0] > 0.0]
        powers = range(ceil(self.low - 1e-9), floor(self.high + 1e-9) + 1)
        step = max(ceil(len(powers) / most), 1)
        found = [10.0**p for p in powers if p % step == 0]
        if len(powers) < 3:
            found = [
                k * 10.0**p
                for p in range(floor(self.low), floor(self.high) + 1)
                for k in (1.0, 2.0, 5.0)
                if self.low <= log10(k * 10.0**p) <= self.high
            ]
        return [(value, _of_ten(value)) for value in found]


def _even(low: float, high: float, most: int) -> list[tuple[float, str]]:
    """Return round values between two, at steps of 1, 2 or 5."""
    rough = (high - low) / most
    decade = 10.0 ** floor(log10(rough))
    step = next(k * decade for k in (1.0, 2.0, 5.0, 10.0) if k * decade >= rough * (1.0 - 1e-9))
    numbers = range(ceil(low / step - 1e-9), floor(high / step + 1e-9) + 1)
    return [(k * step, _plain(k * step, step)) for k in numbers]


def _plain(value: float, step: float) -> str:
    """Return a number with the digits that tell it from one that is a step off."""
    last = floor(log10(step) + 1e-9)
    if value == 0.0:
        return "0"
    if abs(value) < 1e6 and last > -6:
        return f"{value:.{max(-last, 0)}f}".replace("-", "−")
    power = floor(log10(abs(value)) + 1e-9)
    text = f"{value / 10.0**power:.{max(power - last, 0)}f}"
    return f"{text}·10{str(power).translate(RAISED)}".replace("-", "−")


def _of_ten(value: float) -> str:
    power = floor(log10(value) + 1e-9)
    if abs(power) < MOST_ZEROS:
        return f"{value:g}"
    lead = round(value / 10.0**power)
    return (f"{lead}·" if lead > 1 else "") + "10" + str(power).translate(RAISED)


class _Plane:
    """The plane between the axes on its page, and what has its place there already."""

    def __init__(self, chart: Chart) -> None:
        self.chart = chart
        self.rows = list(self._legend_rows())
        top = TOP + ROW * (len(self.rows) + 1)  # the label of y stands above its axis
        bars = [wrap(name, LETTERS) for name in chart.y.names]
        heights = [BAR + ROW * (len(lines) - 1) for lines in bars]
        self.bars = list(zip(bars, accumulate(heights), strict=True))
        high = sum(heights) if bars else HEIGHT
        xs, ys = (np.concatenate([getattr(i, key).ravel() for i in chart.items] or [np.zeros(0)])
                  for key in ("x", "y"))  # fmt: skip
        self.y = _Scale(chart.y, ys, top + high, top)
        self.heights = [] if bars else self.y.ticks(5)
        widest = max((len(text) for _, text in self.heights), default=0)
        left = 14.0 + 0.55 * TYPE * widest if widest else 8.0
        self.box = Box(left, top, WIDTH - RIGHT, top + high)
        self.page = Page(WIDTH, self.box.bottom + 46.0)
        self.x = _Scale(chart.x, xs, self.box.left, self.box.right)
        self.labels = Labels(self.box)
        self.notes: list[tuple[str, list[XY], str]] = []

    def _legend_rows(self) -> Iterator[list[tuple[str, str, float]]]:
        """Yield the lines of the legend, each entry with its place along the line."""
        row: list[tuple[str, str, float]] = []
        x = 8.0
        for name, style in self.chart.legend:
            wide = 34.0 + text_box(name, (0.0, 0.0), "start", TYPE).right + 14.0
            if row and x + wide > WIDTH:
                yield row
                row, x = [], 8.0
            row.append((name, style, x))
            x += wide
        if row:
            yield row

    def write(self, text: str, at: XY, anchor: str = "start", colour: str = "ink2") -> None:
        """Write a line of text on the page."""
        self.page.text(text, at, anchor, paint=f'{HALO} fill="var(--{colour})"')

    def path(self, points: Sequence[XY], style: str, *, closed: bool = False) -> None:
        """Draw a line on the page in a style of its own."""
        self.page.path(points, closed=closed, paint=style)

    def grid(self) -> None:
        """Draw hairlines, the numbers along them, what the axes are, and the legend."""
        box, chart = self.box, self.chart
        for k, row in enumerate(self.rows):
            y = TOP + ROW * k + 8.0
            for name, style, x in row:
                self.path([(x, y), (x + 26.0, y)], style)
                self.write(name, (x + 32.0, y + 4.0))
        if chart.y.label:
            self.write(chart.y.label, (8.0, box.top - 8.0))
        self.write(chart.x.label, (box.right, box.bottom + 40.0), "end")
        hair = _stroke("hair", 0.75)
        end = float("-inf")
        for value, text in self.x.ticks(6):
            x = float(self.x.at(value))
            self.path([(x, box.top), (x, box.bottom)], hair)
            wide = text_box(text, (x, 0.0), "middle", TYPE)
            if wide.left > end and wide.right < WIDTH:
                self.write(text, (x, box.bottom + 19.0), "middle")
                end = wide.right + 4.0
        for value, text in self.heights:
            y = float(self.y.at(value))
            self.path([(box.left, y), (box.right, y)], hair)
            self.write(text, (box.left - 7.0, y + 4.0), "end")
        if self.heights:
            self.path([(box.left, box.top), (box.left, box.bottom)], _stroke("ink2", 0.75))
        self.path([(box.left, box.bottom), (box.right, box.bottom)], _stroke("ink2", 0.75))

    def _row(self, row: int) -> float:
        """Return where the bar of a row is [px]."""
        return self.box.top + self.bars[row][1] - 16.0

    def line(self, x: Floats, y: Floats, style: str) -> None:
        """Draw a line through points, as far as they are in the plane."""
        run: list[XY] = []
        places = zip(self.x.at(x).tolist(), self.y.at(y).tolist(), strict=True)
        for place in [*places, (float("nan"),) * 2]:
            if all(map(isfinite, place)):
                run.append((place[0], place[1]))
                continue
            if len(run) > 1:
                self.path(_simpler(run), style)
                self.labels.keep_off(run)
            run = []

    def dots(self, x: Floats, y: Floats, style: str) -> None:
        """Draw a circle at each point."""
        for px, py in zip(self.x.at(x).tolist(), self.y.at(y).tolist(), strict=True):
            if isfinite(px) and isfinite(py):
                self.page.circle((px, py), 3.5, paint=style)
                self.labels.taken.append(Box(px - 4.0, py - 4.0, px + 4.0, py + 4.0))

    def rule(self, x: float | None, y: float | None, name: str, colour: str, style: str) -> None:
        """Draw a line across the plane, its name at its end."""
        box = self.box
        if x is not None:
            at = float(self.x.at(x))
            ends = [(at, box.bottom), (at, box.top)]
        else:
            at = float(self.y.at(y))
            ends = [(box.left, at), (box.right, at)]
        self.path(ends, style)
        self.labels.keep_off(ends)
        if name:
            self.notes.append((name, [ends[1], ends[0]], colour))

    def band(self, low: float, high: float) -> None:
        """Shade between two values of x."""
        left, right = (float(self.x.at(v)) for v in (low, high))
        corners = [(x, y) for x, y in ((left, self.box.bottom), (right, self.box.bottom),
                                       (right, self.box.top), (left, self.box.top))]  # fmt: skip
        self.path(corners, 'fill="var(--hair)"', closed=True)

    def areas(self, corners: Sequence[Floats]) -> None:
        """Shade areas."""
        for each in corners:
            points = zip(
                self.x.at(each[:, 0]).tolist(), self.y.at(each[:, 1]).tolist(), strict=True
            )
            self.path(_simpler(list(points)), 'fill="var(--hair)"', closed=True)

    def bar(self, row: int, low: float, high: float, style: str) -> None:
        """Draw a bar in a row, at least as wide as is seen."""
        left, right = sorted(float(self.x.at(v)) for v in (low, high))
        right, y = max(right, left + 1.5), self._row(row)
        corners = [(left, y - 1.0), (right, y - 1.0), (right, y + 9.0), (left, y + 9.0)]
        self.path(corners, style, closed=True)

    def column(self, low: float, high: float, top: float) -> None:
        """Draw an upright bar."""
        left, right = (float(self.x.at(v)) for v in (low, high))
        y, base = float(self.y.at(top)), float(self.y.at(0.0))
        corners = [(left, base), (left, y), (right, y), (right, base)]
        self.path(corners, 'fill="var(--ink3)" stroke="var(--paper)"', closed=True)

    def tick(self, row: int, x: float) -> None:
        """Mark a value in a row."""
        at, y = float(self.x.at(x)), self._row(row)
        self.path([(at, y - 4.0), (at, y + 12.0)], _stroke("ink", 1.5))

    def note(self, text: str, x: Floats, y: Floats, colour: str) -> None:
        """Keep a note for when all else is drawn."""
        places = zip(self.x.at(x).tolist(), self.y.at(y).tolist(), strict=True)
        near = [place for place in places if all(map(isfinite, place))]
        self.notes.append((text, near, colour))

    def write_notes(self) -> None:
        """Write names and notes over all else: notes clear of each other and, if may be, of lines.

        The longest is the hardest to place, and comes first.
        """
        for k, (lines, _) in enumerate(self.bars):
            for up, line in enumerate(reversed(lines)):
                self.write(line, (self.box.left, self._row(k) - 6.0 - ROW * up), colour="ink")
        for text, near, colour in sorted(self.notes, key=lambda note: -len(note[0])):
            found = self.labels.place(text, near, TYPE)
            if found is not None:
                self.write(text, found[0], found[1], colour)


def _simpler(points: list[XY]) -> list[XY]:
    """Return a line without the points that are nearer than a quarter of a pixel to its chords."""
    kept = [points[0]]
    k = 0
    while k < len(points) - 1:
        last = k + 1
        while last + 1 < len(points) and _is_straight(points[k : last + 2]):
            last += 1
        kept.append(points[last])
        k = last
    return kept


def _is_straight(points: Sequence[XY]) -> bool:
    (x0, y0), (x1, y1) = points[0], points[-1]
    ux, uy = x1 - x0, y1 - y0
    size = (ux * ux + uy * uy) ** 0.5
    return size > 0.0 and all(
        abs(ux * (y - y0) - uy * (x - x0)) < 0.25 * size
        and -1e-9 <= ux * (x - x0) + uy * (y - y0) <= size * size * (1 + 1e-9)
        for x, y in points[1:-1]
    )
