"""Shapes of a mechanism: ground, bodies, blades at rest, moved, coloured by stress."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import hypot

from flexcli.report.drawings.outlines import CLAMP, INTO, edge_of
from flexcli.report.drawings.sheet import Sheet
from flexcli.report.drawings.style import HEAT
from flexcli.results.drawing import XY, DrawnBlade, DrawnBody, DrawnGuide, DrawnState

__all__ = ["draw_blade", "draw_body", "draw_ground", "draw_guide", "draw_state", "draw_stress"]

RAIL, APART = 10.0, 8.0
"""How far the rails of an ideal stage reach beyond its block, and are from it [px]."""

THIN_BLADE = 1.2
"""Least width at which a blade is drawn [px]."""


def draw_ground(sheet: Sheet, body: DrawnBody) -> None:
    """Draw a line with hatching behind it at every clamp."""
    for place, (wx, wy), depth in zip(body.clamps, body.ways, body.depths, strict=True):
        _draw_edge(sheet, sheet.at(place), (wx, wy), max(18.0, 0.75 * depth * sheet.scale))


def _draw_edge(sheet: Sheet, at: XY, way: XY, half: float, *, hatched: bool = True) -> None:
    """Draw an edge across a direction, hatched on that side, about a place of the page."""
    (x, y), (wx, wy) = at, way
    tx, ty = wy, wx  # along the edge on the page, whose y is down
    ends = [(x - half * tx, y - half * ty), (x + half * tx, y + half * ty)]
    sheet.page.path(ends, "edge")
    sheet.labels.keep_off(ends)
    steps = max(round(2.0 * half / 6.5), 2) if hatched else 0
    for k in range(steps):
        share = -half + (k + 0.5) * 2.0 * half / steps
        sx, sy = x + share * tx, y + share * ty
        lean = (0.707 * (wx + tx), 0.707 * (-wy + ty))
        sheet.page.path([(sx, sy), (sx + 8.0 * lean[0], sy + 8.0 * lean[1])], "thin")


def draw_guide(sheet: Sheet, guide: DrawnGuide) -> None:
    """Draw the direction of a stage, and the rails of an ideal one."""
    (x, y), (wx, wy) = sheet.at(guide.at), guide.way
    size = (sheet.drawing.joint_size or sheet.size) * sheet.scale
    half, apart = INTO * size + RAIL, CLAMP * size + APART
    for end in (1.0, -1.0):
        tip = (x + end * half * wx, y - end * half * wy)
        sheet.page.arrow((x, y), tip, "thin", "head")
        sheet.labels.keep_off([(x, y), tip])
    for nx, ny in ((-wy, wx), (wy, -wx)) if guide.is_ideal else ():
        _draw_edge(sheet, (x + apart * nx, y - apart * ny), (nx, ny), half, hatched=guide.on_ground)


def draw_body(sheet: Sheet, body: DrawnBody) -> None:
    """Draw the blocks of a body, tied by chain lines where they are several."""
    places = [sheet.line(block) for block in sheet.blocks[body.name]]
    for ends in _ties(places):
        sheet.page.path(ends, "axis")
    for block in places:
        sheet.page.path(block, "body", closed=True)
        sheet.labels.keep_off(block, closed=True)


def _ties(places: Sequence[Sequence[XY]]) -> Iterator[list[XY]]:
    """Yield lines between the nearest corners that make one body of several blocks."""
    tied, left = list(places[:1]), list(places[1:])
    while left:
        pairs = ((hypot(p[0] - q[0], p[1] - q[1]), p, q, k)
                 for k, block in enumerate(left)
                 for p in block for q in (corner for each in tied for corner in each))  # fmt: skip
        _, p, q, k = min(pairs)
        yield [p, q]
        tied.append(left.pop(k))


def draw_blade(sheet: Sheet, blade: DrawnBlade) -> None:
    """Draw a blade at rest at its true thickness, but no thinner than is visible."""
    if blade.surface:
        corners = sheet.line(blade.surface)
        sheet.page.path(corners, "face", closed=True)
        sheet.labels.keep_off(corners, closed=True)
        return
    edge = edge_of(blade)
    n = len(blade.axis)
    ends = sheet.line([blade.axis[0], blade.axis[-1]])
    for share in (0.0, 0.25, 0.5, 0.75, 1.0):  # also what a wide blade covers
        both = zip(edge[:n], edge[n:][::-1], strict=True)
        sheet.labels.keep_off(
            sheet.line([(u + share * (x - u), v + share * (y - v)) for (u, v), (x, y) in both])
        )
    if max(blade.thickness) * sheet.scale < THIN_BLADE and 0.0 not in blade.thickness:
        sheet.page.path(ends, "edge")
        return
    for first, last in pairwise(range(n)):
        rigid = 0.0 in (blade.thickness[first], blade.thickness[last])
        if rigid and blade.axis[first] != blade.axis[last]:
            stretch = sheet.line(_stretch(sheet, blade, first, last))
            sheet.page.path(stretch, "body", closed=True)
    solid = [k for k in range(n) if blade.thickness[k] > 0.0]
    for run in _runs(solid):
        around = [edge[k] for k in run] + [edge[2 * n - 1 - k] for k in reversed(run)]
        if max(blade.thickness[k] for k in run) * sheet.scale < THIN_BLADE:
            sheet.page.path(sheet.line([blade.axis[run[0]], blade.axis[run[-1]]]), "edge")
        else:
            sheet.page.path(sheet.line(around), "blade", closed=True)


def _stretch(sheet: Sheet, blade: DrawnBlade, first: int, last: int) -> list[XY]:
    """Return the rectangle of a rigid stretch [m]."""
    (x0, y0), (x1, y1) = blade.axis[first], blade.axis[last]
    l = hypot(x1 - x0, y1 - y0)
    half = max(1.5 * max(blade.thickness), 4.0 / sheet.scale)
    nx, ny = -(y1 - y0) / l * half, (x1 - x0) / l * half
    return [(x0 + nx, y0 + ny), (x1 + nx, y1 + ny), (x1 - nx, y1 - ny), (x0 - nx, y0 - ny)]


def draw_state(sheet: Sheet, state: DrawnState, style: str) -> None:
    """Draw the mechanism moved, in the style of that end of its stroke."""
    for name, block in ((n, block) for n, each in sheet.blocks.items() for block in each):
        moved = sheet.line(sheet.carried(name, block, state))
        sheet.page.path(moved, style, closed=True)
        sheet.labels.keep_off(moved, closed=True)
    for blade in sheet.drawing.blades:
        bent = sheet.line(sheet.bent(blade, state))
        sheet.page.path(bent, "plusb" if style == "plus" else style)
        sheet.labels.keep_off(bent)


def draw_stress(sheet: Sheet, state: DrawnState) -> None:
    """Draw the blades of a state by their stress."""
    most = max(max(each) for each in state.stress.values())
    for blade in sheet.drawing.blades:
        places, stress = sheet.line(sheet.bent(blade, state)), state.stress[blade.name]
        for k, (start, end) in enumerate(pairwise(places)):
            share = 0.5 * (stress[k] + stress[k + 1]) / most if most else 0.0
            colour = HEAT[min(int(share * len(HEAT)), len(HEAT) - 1)]
            sheet.page.path([start, end], "heat", paint=f'stroke="{colour}"')


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
