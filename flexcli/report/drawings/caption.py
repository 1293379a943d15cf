"""The caption of a drawing: its magnification, and what the spec leaves open."""

from math import degrees, floor, hypot, log10

from flexcli.report.drawings.outlines import blocks, size_of
from flexcli.results.drawing import Drawing
from flexcli.units import show

__all__ = ["caption", "magnification", "times_of", "travel_text"]

SEEN = 0.12
"""Share of the mechanism's size by which the deflected overlay should move."""


def magnification(drawing: Drawing) -> float:
    """Return the magnification of the overlay's displacements: 1, 2, 3, 5 times a decade."""
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
    return times_of(SEEN * size / most)


def times_of(wanted: float) -> float:
    """Return the largest of 1, 2, 3, 5 times a power of ten up to some times, 1 at least."""
    if wanted < 2.0:
        return 1.0
    decade = 10.0 ** floor(log10(wanted))
    return max(step * decade for step in (1.0, 2.0, 3.0, 5.0) if step * decade <= wanted)


def caption(drawing: Drawing) -> str:
    """Return the caption: what the drawing shows and what the spec leaves open."""
    said = ["To scale."]
    if drawing.states:
        times = magnification(drawing)
        ends = " and ".join(travel_text(drawing, s.travel) for s in drawing.states)
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


def travel_text(drawing: Drawing, travel: float) -> str:
    """Return a travel with its sign, in the unit of the motion."""
    text = f"{degrees(travel):.4g}°" if drawing.unit == "rad" else show(travel, "m")
    return text.replace("-", "−") if travel < 0.0 else f"+{text}"
