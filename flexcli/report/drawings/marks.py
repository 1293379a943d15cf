"""Annotations of a mechanism: centres, masses, forces, lengths, angles, and names."""

from collections.abc import Iterator, Sequence
from math import atan2, cos, degrees, hypot, pi, sin

from flexcli.report.drawings.caption import times_of
from flexcli.report.drawings.outlines import along
from flexcli.report.drawings.sheet import TYPE, Sheet
from flexcli.report.svg import Box, text_box
from flexcli.results.drawing import XY, DrawnBlade, DrawnLength
from flexcli.units import show

__all__ = ["draw_marks"]

MOST_NAMED = 8
"""Number of bodies or sizes beyond which they are not named one by one."""

PATH, CLOSE = 34.0, 3.0
"""Span that the path of a centre is magnified to, and one that is not worth drawing [px]."""

OFFSETS = (26.0, 44.0, 62.0, 84.0, 110.0)
"""Distances from what it measures at which a dimension line is tried [px]."""


def draw_marks(sheet: Sheet) -> None:
    """Draw the annotations, those that need free room last."""
    _centres(sheet)
    _masses(sheet)
    _forces(sheet)
    for length in _measured(sheet):
        _dimension(sheet, length)
    _angles(sheet)
    _path(sheet)
    _names(sheet)


def _centres(sheet: Sheet) -> None:
    """Mark the centre of rotation, or those of several joints with their names."""
    drawing = sheet.drawing
    rotates = drawing.motion == "rotation" and not drawing.twists
    centres = drawing.pivots or ((("", drawing.centre),) if rotates else ())
    for _, place in centres:
        x, y = sheet.at(place)
        sheet.page.circle((x, y), 4.5, "hole")
        sheet.page.circle((x, y), 1.4, "dot")
        sheet.labels.taken.append(Box(x - 6.0, y - 6.0, x + 6.0, y + 6.0))
    for name, place in centres:
        if name:
            sheet.label(name, sheet.at(place), "")
    for guide in drawing.guides:
        sheet.label(guide.name, sheet.at(guide.at), "")


def _path(sheet: Sheet) -> None:
    """Draw the path of the centre of rotation about its place, with its magnification."""
    drawing = sheet.drawing
    if not drawing.path or drawing.motion != "rotation":
        return
    (cx, cy), far = drawing.centre, 0.0
    away = [(x - cx, y - cy) for x, y in drawing.path]
    far = max(hypot(x, y) for x, y in away) * sheet.scale
    if far == 0.0:
        return
    times = times_of(PATH / far)
    if far * times < CLOSE:
        return
    x, y = sheet.at(drawing.centre)
    size = sheet.scale * times
    places = [(x + size * u, y - size * v) for u, v in away]
    sheet.page.path(places, "plus")
    sheet.labels.keep_off(places)
    sheet.label(f"path of the centre ×{times:g}", places[0], "m")


def _masses(sheet: Sheet) -> None:
    """Mark each centre of mass by a quartered disc, with its mass."""
    for body in sheet.drawing.bodies:
        for mass in body.masses:
            x, y = sheet.at(mass.at)
            sheet.page.circle((x, y), 4.5, "hole")
            for quarter in (0.0, pi):
                turns = [quarter + k * pi / 16.0 for k in range(9)]
                arc = [(x + 4.5 * cos(a), y - 4.5 * sin(a)) for a in turns]
                sheet.page.path([(x, y), *arc], "dot", closed=True)
            sheet.labels.taken.append(Box(x - 6.0, y - 6.0, x + 6.0, y + 6.0))
    for body in sheet.drawing.bodies:
        for mass in body.masses:
            told = f"{mass.name} {show(mass.mass, 'kg')}".lstrip()
            sheet.label(told, sheet.at(mass.at), "s")


def _forces(sheet: Sheet) -> None:
    for force in sheet.drawing.forces:
        x, y = sheet.at(force.at)
        wx, wy = force.way[0], -force.way[1]
        start = (x - 64.0 * wx, y - 64.0 * wy)
        sheet.page.arrow(start, (x - 7.0 * wx, y - 7.0 * wy), "force", "headf", 11.0)
        sheet.labels.keep_off([start, (x, y)])
        sheet.label(f"{force.name} = {show(force.newtons, 'N')}", start, "f")


def _measured(sheet: Sheet) -> Iterator[DrawnLength]:
    """Yield the lengths of the mechanism, and that of the first blade seen as long as it is."""
    yield from sheet.drawing.lengths
    for blade in sheet.drawing.blades:
        if blade.length is not None and _length(blade) < (1.0 - 1e-6) * blade.length:
            continue
        name = "l" if _is_size(sheet, "l", _length(blade)) else ""
        yield DrawnLength(name, blade.axis[0], blade.axis[-1])
        return


def _dimension(sheet: Sheet, length: DrawnLength) -> None:
    """Draw a length as a dimension beside the part, or list it with the sizes."""
    (x0, y0), (x1, y1) = sheet.line([length.start, length.end])
    long = hypot(x1 - x0, y1 - y0)
    ux, uy = (x1 - x0) / long, (y1 - y0) / long
    if ux < -1e-9 or (abs(ux) < 1e-9 and uy > 0.0):  # read from below or from the right
        x0, y0, x1, y1, ux, uy = x1, y1, x0, y0, -ux, -uy
    size = show(long / sheet.scale, "m")
    text = f"{length.name} = {size}" if length.name else size
    tried = []
    thick = max((max(b.thickness) for b in sheet.drawing.blades), default=0.0)
    for off in (0.5 * thick * sheet.scale + step for step in OFFSETS):
        for side in (1.0, -1.0):
            nx, ny = side * uy * off, -side * ux * off
            middle = (0.5 * (x0 + x1) + nx, 0.5 * (y0 + y1) + ny)
            tried.append((_turned_box(text, middle, (ux, uy)), 1.2 * off, (nx, ny)))
    found = sheet.labels.best((box, cost) for box, cost, _ in tried)
    if found is None:
        sheet.unnamed.append(text)
        return
    nx, ny = tried[found][2]
    start, end = (x0 + nx, y0 + ny), (x1 + nx, y1 + ny)
    away = hypot(nx, ny)
    for (ax, ay), (bx, by) in (((x0, y0), start), ((x1, y1), end)):
        gap, over = 3.0 / away, 4.0 / away
        sheet.page.path(
            [(ax + gap * (bx - ax), ay + gap * (by - ay)),
             (bx + over * (bx - ax), by + over * (by - ay))],
            "thin",
        )  # fmt: skip
    middle = (0.5 * (start[0] + end[0]), 0.5 * (start[1] + end[1]))
    sheet.page.arrow(middle, start, "thin", "head")
    sheet.page.arrow(middle, end, "thin", "head")
    sheet.labels.keep_off([start, end])
    above = (middle[0] + 4.5 * uy, middle[1] - 4.5 * ux)
    sheet.page.text(text, above, "middle", turn=degrees(atan2(uy, ux)))


def _length(blade: DrawnBlade) -> float:
    return hypot(*(b - a for a, b in zip(blade.axis[0], blade.axis[-1], strict=True)))


def _is_size(sheet: Sheet, symbol: str, value: float) -> bool:
    """Return whether a length equals that size of the spec, to rounding."""
    sizes = dict(sheet.drawing.sizes)
    return symbol in sizes and abs(sizes[symbol] - value) <= 1e-9 * value


def _angles(sheet: Sheet) -> None:
    for angle in sheet.drawing.angles:
        x, y = sheet.at(angle.at)
        sheet.page.arc((x, y), 38.0, (angle.start, angle.end), "thin")
        middle = 0.5 * (angle.start + angle.end)
        near = (x + 38.0 * cos(middle), y - 38.0 * sin(middle))
        sheet.label(f"{angle.name} = {degrees(angle.end - angle.start):.4g}°", near, "")
        for way in (angle.start, angle.end):
            end = (x + 46.0 * cos(way), y - 46.0 * sin(way))
            sheet.page.path([(x, y), end], "axis")


def _names(sheet: Sheet) -> None:
    """Name bodies and blades, and say the sizes that have no dimension line."""
    bodies = [body for body in sheet.drawing.bodies if not body.is_ground]
    if len(bodies) <= MOST_NAMED:
        for body in bodies:
            corners = sheet.line(max(sheet.blocks[body.name], key=_span))
            x, y = (sum(side) / len(corners) for side in zip(*corners, strict=True))
            sheet.label(body.name, (x, y), "")
    for body in sheet.drawing.bodies:
        if body.is_ground:
            place, way = body.clamps[0], body.ways[0]
            x, y = sheet.at(place)
            sheet.label("ground", (x + 10.0 * way[0], y - 10.0 * way[1]), "s")
    if not sheet.drawing.blades:
        return
    first = _length(sheet.drawing.blades[0])
    said = [
        (symbol, size)
        for symbol, size in sheet.drawing.sizes
        if not (symbol == "l" and _is_size(sheet, "l", first))
    ]
    for symbol, size in said[:MOST_NAMED]:
        name, blade = _blade_of(sheet.drawing.blades, symbol)
        near = sheet.at(along(blade, 0.72 if symbol == "b" else 0.5))
        sheet.label(f"{name} = {show(size, 'm')}", near, "s")


def _span(corners: Sequence[XY]) -> float:
    """Return the larger side of what corners span [m]."""
    return max(float(max(side) - min(side)) for side in zip(*corners, strict=True))


def _blade_of(blades: Sequence[DrawnBlade], symbol: str) -> tuple[str, DrawnBlade]:
    """Return the letter of a size and its blade, the first where its symbol names none."""
    letter, _, of = symbol.partition("_")
    of = of.replace("_", "-")
    found = next((b for b in blades if of and b.name.startswith(of)), None)
    return (symbol, blades[0]) if found is None else (letter, found)


def _turned_box(text: str, middle: XY, way: XY) -> Box:
    """Return the box of a text that is centred above a place and runs in a direction."""
    flat = text_box(text, (0.0, -4.5), "middle", TYPE)
    corners = [
        (middle[0] + x * way[0] - y * way[1], middle[1] + x * way[1] + y * way[0])
        for x in (flat.left, flat.right)
        for y in (flat.top, flat.bottom + 6.0)
    ]
    xs, ys = zip(*corners, strict=True)
    return Box(min(xs), min(ys), max(xs), max(ys))
