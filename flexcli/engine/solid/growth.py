"""How solids grow by a temperature: strains of each blade, and how far its clamps move."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.solid.model import SolidModel, Stretch
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import single
from flexcli.parts.temperature import held_share

__all__ = ["Spacer", "grows", "spacers_of", "strains_of"]


class Spacer(NamedTuple):
    """A clamp that moves from where it is on its body at assembly: its nodes, place and way [m]."""

    body: str
    nodes: NDArray[np.intp]
    place: tuple[float, float]
    moved: tuple[float, float]


def grows(layout: Layout) -> bool:
    """Return whether a temperature makes anything of a layout grow."""
    return bool(layout.body_growth or layout.blade_growth)


def spacers_of(model: SolidModel) -> Iterator[Spacer]:
    """Yield the clamps that move: a body grows about its point, the ground about the origin."""
    points = {body.name: body.point for body in model.bodies}
    for stretch in model.stretches if grows(model.layout) else ():
        blade = next(b for b in model.layout.blades if b.name == stretch.name)
        for body, place, side in zip(
            stretch.bodies, (blade.start, blade.end), (0, -1), strict=True
        ):
            x, y = (single(c) for c in place)
            about = points.get(body, (0.0, 0.0))
            strain = _strain(model.layout, body)
            moved = strain * (x - about[0]), strain * (y - about[1])
            if any(moved):
                yield Spacer(body, stretch.bricks.end(side) + stretch.first_node, (x, y), moved)


def strains_of(model: SolidModel, stretch: Stretch) -> tuple[float, float]:
    """Return the free strain of a blade along itself, and across, beside that of its bodies.

    Clamps are as wide and thick as at assembly here: what blade and bodies grow alike across is
    left out, and between two bodies the mean of both. What clamps that hold it across add along the
    blade is in the growth of the layout, and comes by itself in a solid.
    """
    layout = model.layout
    blade = next(b for b in layout.blades if b.name == stretch.name)
    E, G = (single(x) for x in (layout.E, layout.G))
    held = held_share(blade, E / (2.0 * G) - 1.0)
    of_bodies = sum(_strain(layout, body) for body in stretch.bodies) / 2.0
    longer = single(layout.blade_growth.get(stretch.name, 0.0))
    own = (longer + held * of_bodies) / (1.0 + held)
    return own, own - of_bodies


def _strain(layout: Layout, body: str) -> float:
    return single(layout.body_growth.get(body, 0.0))
