"""The lowest frequency of a mechanism in space at a stroke, its drive locked there."""

from collections.abc import Sequence
from math import pi

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.space_stroke import Blades
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium
from flexcli.mechanics.space.exact.support import PointMass, vibration
from flexcli.mechanics.space.inertia import blade_masses
from flexcli.mechanics.space.layout import SpaceRod
from flexcli.mechanics.space.linear import assemble
from flexcli.mechanics.space.modes import own_blade_frequency
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.own_motion import DENSEST
from flexcli.parts.requirements import Ask
from flexcli.parts.space_joint import joint_of
from flexcli.parts.space_own_motion import INNER
from flexcli.results import ErrorRange

__all__ = ["locked_frequency"]

Floats = NDArray[np.float64]

HEAVIEST = (0.7, 1.0 / 19.0)
"""Of a blade's mass, and of that times l²: what a point mass at either end has that is heavier than
the blade, however its ends move. Beams under loads at their ends have no more, in bending, along
themselves and in twist: the consistent masses of a cubic beam are below it."""

FOLLOWS = 13.0 / 35.0 / HEAVIEST[0]
"""Share of that which a blade has whose end moves across it, its other end held."""


def locked_frequency(
    ask: Ask, state: SpaceEquilibrium, cold: SpaceEquilibrium, blades: Blades
) -> tuple[float, ErrorRange | None]:
    """Return the lowest frequency at an equilibrium [Hz], and its error.

    Blades are point masses at their ends; the range goes from blades of no mass to some that are
    surely too heavy, and counts what blades vibrate inside. Stiffness is off in any motion by no
    more than a support stiffness may be: twice that of a frequency.
    """
    joint = joint_of(ask)
    if not any(body.mass for body in joint.layout.bodies):
        raise NotAvailable("has no body with a mass: give its bodies theirs")
    weighed, share = joint.assembly, FOLLOWS
    if ask.material.density is None:
        # blades of a material without a density may be as heavy as any
        layout = ask.geometry.space_layout(ask.material.elastic, ask.sizes, DENSEST)
        weighed, share = assemble(layout), 0.0
    masses = blade_masses(weighed)
    found = _lowest(state, masses, share)
    bare, heavy = _lowest(state, masses, 0.0), _lowest(state, masses, 1.0)
    known, inside = blades.errors(state), 2.0 * pi * heavy / own_blade_frequency(weighed)
    if state.coarser is None or known is None or inside > INNER:
        return found, None
    of_heat = 0.0
    if cold is not state:
        of_heat = abs((_lowest(cold, masses, share) / found) ** 2 - 1.0)
    off = abs(_lowest(state.coarser, masses, share) / found - 1.0)
    off += known.support * (1.0 + of_heat)
    of_blades = max(1.0 - (heavy / bare) ** 2, 0.0)
    least = heavy / found * (1.0 - of_blades * inside**2 / (1.0 - inside**2))
    return found, ErrorRange(least * (1.0 - off) - 1.0, bare / found * (1.0 + off) - 1.0)


def _lowest(state: SpaceEquilibrium, masses: Sequence[float] | Floats, share: float) -> float:
    """Return the lowest frequency [Hz], the blades' ends having a share of the heaviest masses."""
    besides = []
    for blade, mass in zip(state.layout.blades, masses, strict=True):
        broad = blade.d if isinstance(blade, SpaceRod) else blade.b
        l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
        at, around = (share * float(mass) * each for each in HEAVIEST)
        inertia = around * l**2 + at * broad**2 / 12.0
        besides += [
            PointMass(blade.first, blade.start, at, inertia),
            PointMass(blade.second, blade.end, at, inertia),
        ]
    return float(vibration(state, besides=besides).frequency[0, 0])
