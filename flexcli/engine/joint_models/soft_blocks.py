"""Joints whose hinges have blocks beside them, drawn with the most that these may give way."""

from dataclasses import replace

import numpy as np

from flexcli.engine.joint_models.space_errors import AT_STROKE
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import SpaceBlade, SpaceBody, SpaceLayout, Vector, vector
from flexcli.mechanics.space.springs import SPREAD, WARPED, springs_of

__all__ = ["hinge_alone_off", "with_soft_blocks"]


def with_soft_blocks(layout: SpaceLayout) -> SpaceLayout | None:
    """Return a layout with bars for the blocks beside its hinges, as long as they may count.

    A bar is as high as the mouth of a hinge. None where no hinge has blocks.
    """
    bodies, blades = list(layout.bodies), list[SpaceBlade]()
    for blade in layout.blades:
        if not isinstance(blade, SpaceBlade) or not any(blade.blocks):
            return None
        near, far = (f"{blade.name}, {end}" for end in ("inner block", "outer block"))
        l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
        H = blade.profile.mouth(l)
        reach = (blade.blocks[1] + SPREAD * H) * blade.axes[0]
        places = _moved(blade.start, -reach), blade.start, blade.end, _moved(blade.end, reach)
        bodies += [SpaceBody(near, places[1], places[1]), SpaceBody(far, places[2], places[2])]
        bar = replace(blade, profile=Constant(H), blocks=(0.0, 0.0))
        if blade.b < H:  # a strip is no thicker than wide
            bar = replace(bar, profile=Constant(blade.b), b=H, width=vector(blade.axes[1]))
        blades += [
            replace(bar, name=near, second=near, start=places[0], end=places[1]),
            replace(blade, first=near, second=far, blocks=(0.0, 0.0)),
            replace(bar, name=far, first=far, start=places[2], end=places[3]),
        ]
    return replace(layout, bodies=tuple(bodies), blades=tuple(blades))


def hinge_alone_off(layout: SpaceLayout) -> float:
    """Return by how much less the hinges of a layout may be stiff than beams, without blocks.

    At rest and at a stroke; a hinge twists more between blocks than between rigid bodies.
    """
    bare = (blade for blade in layout.blades if isinstance(blade, SpaceBlade))
    alone = (springs_of(replace(blade, blocks=(0.0, 0.0))) for blade in bare)
    least = min(float(springs.low.min()) for springs in alone)
    return 1.0 - (1.0 + least) / (1.0 + WARPED) + AT_STROKE


def _moved(place: Vector, by: np.ndarray) -> Vector:
    return vector(np.add(place, by))
