"""Where the lines of exact beams went, and their sections along them."""

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.space.exact.blade import along
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.stresses import beams_of_state
from flexcli.mechanics.space.layout import seats_grown
from flexcli.mechanics.space.swept_box import Edges, steps_along
from flexcli.numerics.collocation import gauss_nodes, integration_to, interpolation_matrix

__all__ = ["lines_of"]

Floats = NDArray[np.float64]

PLACES = np.linspace(-1.0, 1.0, 25)
"""On each segment of a blade."""


def lines_of(state: SpaceEquilibrium) -> list[Edges]:
    """Return the line and the sections of every blade and rod, along the axes of the layout.

    The places are the same at every level of nodes.
    """
    beams, inside = beams_of_state(state)
    mesh, layout = beams.mesh, state.layout
    felt = along(mesh, beams.nodes(inside), state.own_forces)
    count = mesh.per_segment
    onto, to_nodes = integration_to(count, PLACES), interpolation_matrix(count, PLACES)
    weights = gauss_nodes(count)[1]
    rate = felt.rate + np.array([1.0, 0.0, 0.0])
    bent = np.linalg.norm(felt.kappa[..., 1:], axis=-1)
    bodies = {body.name for body in layout.bodies}
    found = []
    for i, blade in enumerate(layout.blades):
        l, axes = mesh.sections[i].l, state.linearised.axes[i]
        start = np.asarray(blade.start, dtype=np.float64)
        if blade.first in bodies:
            start = start + state.motion_of(blade.first, blade.start)[:3]
        else:
            start = start + seats_grown(layout, blade)[:3]
        at, sections, rest = np.zeros(3), list[Floats](), list[Floats]()
        thin = float(mesh.h[i][mesh.h[i] > 0.0].min())
        for k in range(mesh.nodes // count):
            own = slice(k * count, (k + 1) * count)
            half, turned = mesh.half[i, own], np.swapaxes(felt.R[i, own], -1, -2)
            gone = rate[i, own] * half[:, None]
            line = start + l * (at + onto @ gone) @ axes
            at = at + weights @ gone
            R = (to_nodes @ turned.reshape(count, 9)).reshape(-1, 3, 3) @ axes
            R /= np.linalg.norm(R, axis=-1, keepdims=True)
            sections.append(np.concatenate([line[:, None], R], axis=1))
            h = np.maximum(to_nodes @ mesh.h[i, own], thin)
            # sections stand still where pieces of a notch begin
            bends = np.abs(to_nodes @ bent[i, own]) / l
            rest.append(np.column_stack([h, bends, steps_along(line)]))
        line, x, y, z = np.moveaxis(np.concatenate(sections), 1, 0)
        h, kappa, step = np.concatenate(rest).T
        found.append(Edges(line, x, y, z, h, kappa, step))
    return found
