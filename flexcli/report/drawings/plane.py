"""A mechanism drawn in its plane: at rest and at the ends of its stroke, with annotations.

What the spec does not state (the shapes of bodies) is drawn plain and named in the caption.
"""

from math import floor, log10

from flexcli.report.drawings.caption import caption, travel_text
from flexcli.report.drawings.marks import draw_marks
from flexcli.report.drawings.shapes import (
    draw_blade,
    draw_body,
    draw_ground,
    draw_guide,
    draw_state,
    draw_stress,
)
from flexcli.report.drawings.sheet import WIDTH, Sheet
from flexcli.report.drawings.style import HEAT, sheet_of
from flexcli.results.drawing import Drawing
from flexcli.units import show

__all__ = ["drawing_svg"]


def drawing_svg(drawing: Drawing, title: str, *, stress: bool = False, width: float = WIDTH) -> str:
    """Return the drawing as an SVG of its own so wide [px], its blades by stress if asked."""
    sheet = Sheet(drawing, width)
    for body in drawing.bodies:
        if body.is_ground:
            draw_ground(sheet, body)
        else:
            draw_body(sheet, body)
    for guide in drawing.guides:
        draw_guide(sheet, guide)
    for state, style in zip(drawing.states, ("plus", "minus"), strict=False):
        draw_state(sheet, state, style)
    for blade in drawing.blades:
        draw_blade(sheet, blade)
    coloured = stress and any(state.stress for state in drawing.states)
    if coloured:
        draw_stress(sheet, drawing.states[0])
    _draw_foot(sheet, stress=coloured)
    draw_marks(sheet)
    left_out = f" No room for the names of {', '.join(sheet.unnamed)}." if sheet.unnamed else ""
    return sheet_of(sheet.page, title, caption(drawing) + left_out)


def _draw_foot(sheet: Sheet, *, stress: bool) -> None:
    """Draw scale bar, axes, and the legend of overlay and colours."""
    page, drawing = sheet.page, sheet.drawing
    y = page.height - 14.0
    length = _round_length(0.11 * page.width / sheet.scale)
    wide = length * sheet.scale
    page.path([(16.0, y - 4.0), (16.0, y), (16.0 + wide, y), (16.0 + wide, y - 4.0)], "edge")
    page.text(show(length, "m"), (24.0 + wide, y + 1.0), "start", "s")
    x, low = page.width - 56.0, min(way[1] for _, way in drawing.axes)
    for name, (right, up) in drawing.axes:
        start = (x, y + 24.0 * min(low, 0.0))
        end = (start[0] + 24.0 * right, start[1] - 24.0 * up)
        page.arrow(start, end, "thin", "head")
        page.text(name, (end[0] + (5.0 if right >= 0.0 else -12.0), end[1] + 4.0), "start", "s")
    if stress:
        most = max(max(each) for each in drawing.states[0].stress.values())
        x, above = 16.0, y - 19.0
        page.text("stress  0", (x, above), "start", "s")
        for k, colour in enumerate(HEAT):
            at = x + 58.0 + 8.0 * k
            swatch = [(at, above - 4.0), (at + 8.0, above - 4.0)]
            page.path(swatch, "heat", paint=f'stroke="{colour}"')
        page.text(show(most, "Pa"), (x + 120.0, above), "start", "s")
    x, y = 16.0, y - 38.0
    for state, style in zip(drawing.states, ("plus", "minus"), strict=False):
        page.path([(x, y - 4.0), (x + 26.0, y - 4.0)], style)
        text = travel_text(drawing, state.travel)
        page.text(text, (x + 32.0, y), "start", "s")
        x += 48.0 + 7.2 * len(text)
    if drawing.states:
        page.text(f"displacements ×{sheet.times:g}", (x, y), "start", "s")


def _round_length(wanted: float) -> float:
    """Return the largest 1, 2 or 5 times a power of ten that is not above a length."""
    decade = 10.0 ** floor(log10(wanted))
    return max(step * decade for step in (1.0, 2.0, 5.0) if step * decade <= wanted * (1 + 1e-12))
