"""What accelerated blades weigh in a joint's plane: their stress, and bounds where it is left out.

Between its ends a blade bends by itself, by ρ a l²/(2h) at its clamps if it is uniform, and it
hangs on the bodies besides. Loads that buckle a joint are the more by it.
"""

from collections.abc import Iterable
from functools import partial
from math import inf

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.joint_states import by_weight_alone, fields, layout_of, linearly
from flexcli.formulas.profile import per_design
from flexcli.mechanics.layout import Blade, Number
from flexcli.mechanics.mesh import Effects, column
from flexcli.mechanics.own_weight import blade_places, direction, held_blade
from flexcli.numerics.rows import hypot, larger, largest_of_each, of_each, states_of
from flexcli.parts.own_motion import DENSEST
from flexcli.parts.requirements import Ask, EndStress

__all__ = ["LEAST", "BladeWeights", "forced_stress", "left_share", "weighed"]

Floats = NDArray[np.float64]

SIMPLIFIED = 0.02
"""Of the stress of its own weight: what shear makes of an uneven blade's, and the integrals."""

WIDENED = 0.15
"""Of it: what factors of wide blades may make of it, which are of bending by a stroke."""

LEAST = 1e-300
"""Stress over which none is divided [Pa]."""

AMPLIFIED = 2.0
"""Times that blades bend under their weight beside a push of half of what buckles the joint."""


class BladeWeights:
    """Stress of blades between held ends under the accelerations of a case's states."""

    def __init__(self, ask: Ask, density: Number) -> None:
        self.layout, self.x, self.y = fields(ask)
        self.widens = ask.scene.bends
        self.blades = [held_blade(blade, density) for blade in self.layout.blades]

    @classmethod
    def of(cls, ask: Ask) -> "BladeWeights | None":
        """Return those of a case, nothing where it has none or nobody knows the density."""
        density = ask.material.density
        if density is None or not ask.scene.is_accelerated:
            return None
        return cls(ask, density.value)

    def stress(self, index: int) -> tuple[Floats, Floats]:
        """Return axial and bending stress along a blade (states·designs, places) [Pa]."""
        blade, held = self.layout.blades[index], self.blades[index]
        c, s = direction(blade)
        ahead, left = (c * self.x + s * self.y)[:, None], (c * self.y - s * self.x)[:, None]
        b, bends, pulls = (column(value)[:, None] for value in (blade.b, *blade.peak))
        bending = bends * 6.0 * held.moment * left / (b * held.thickness**2)
        return pulls * held.pull * ahead / (b * held.thickness), bending

    def off(
        self,
        index: int,
        added: tuple[Floats, Floats],
        axial: Floats,
        bending: Floats,
        motions: Floats,
    ) -> Number:
        """Return how far the stress of its weight may be off in a blade with other stresses [Pa].

        A blade that is bent turns aside from its weight, by no more than its slope; a pushed one
        bends 1/(1 − n) times as much, n the share of the force that would buckle it between held
        ends; a pulled one less.
        """
        blade, held = self.layout.blades[index], self.blades[index]
        b, bends, pulls = (column(value)[:, None] for value in (blade.b, *blade.peak))
        E = column(self.layout.E * blade.stiffer)[:, None]
        curved = 2.0 * np.abs(bending) / (bends * E * held.thickness)
        slope = np.sum((curved[:, 1:] + curved[:, :-1]) / 2.0 * held.steps, axis=1)
        bodies = [body.name for body in self.layout.bodies]
        if blade.first in bodies:
            slope = slope + np.abs(motions[:, bodies.index(blade.first), 2])
        force = np.max(np.abs(axial) * b * held.thickness / pulls, axis=1)
        share = force * held.softness / E[:, 0]
        bent = np.where(share < 0.5, 2.0 * share / np.maximum(1.0 - share, 0.5), inf)
        tension = np.min(axial, axis=1) >= 0.0
        bent = np.where(tension, np.minimum(bent, 1.0), bent)
        most = np.max(np.abs(added[0]) + np.abs(added[1]), axis=1)
        doubt = slope + bent + SIMPLIFIED + WIDENED * self.widens
        return largest_of_each(states_of((np.where(most > 0.0, most * doubt, 0.0))[:, None]))


def forced_stress(blade: Blade, force: Floats) -> tuple[Floats, Floats]:
    """Return axial and bending stress [Pa] along a straight blade (designs, places).

    ``force`` (designs, 3) acts on its end: along x and y [N], and the moment [N·m].
    """
    x, y = (b - a for a, b in zip(blade.start, blade.end, strict=True))
    l = np.hypot(x, y)
    s, h = blade_places(blade, l)
    N = (force[:, 0] * x + force[:, 1] * y) / l
    V = (force[:, 1] * x - force[:, 0] * y) / l
    M = force[:, 2:] + V[:, None] * (per_design(l) - s)
    b, bends, pulls = map(per_design, (blade.b, *blade.peak))
    return pulls * N[:, None] / (b * h), bends * 6.0 * M / (b * h**2)


def left_share(ask: Ask, stresses: Iterable[EndStress]) -> Number:
    """Return the largest stress that blades may have by their weight, over that without it [-].

    Twice that of their weight alone by small motion: a joint pushed by half of what buckles it
    bends that much more under anything else.
    """
    density = _most_density(ask)
    found = by_weight_alone(ask, partial(linearly, effects=Effects()), density)
    weights, most = BladeWeights(ask, density), 0.0
    for index, blade in enumerate(weights.layout.blades):
        axial, bending = forced_stress(blade, found.end_forces[:, index])
        pulled, bent = weights.stress(index)
        axial, bending = axial + pulled, bending + bent
        most = larger(most, largest_of_each(states_of(np.abs(axial) + np.abs(bending))))
    return AMPLIFIED * most / larger(LEAST, *(stress.largest for stress in stresses))


def _most_density(ask: Ask) -> Number:
    """Return the density of the blades, the largest that there is where nobody states it."""
    density = ask.material.density
    return DENSEST if density is None else density.value


def weighed(ask: Ask) -> Number:
    """Return the force of all blades' mass in the accelerations of a case [N]."""
    density = _most_density(ask)
    each = [held_blade(blade, density) for blade in layout_of(ask).blades]
    mass = of_each(np.asarray(sum(held.along.sum(axis=1) for held in each)))
    return mass * sum(hypot(x, y) for x, y, _ in ask.scene.accelerations)
