"""Lowest frequency of a mechanism in space at rest, its drive free or locked, with its error."""

from functools import cache, partial
from math import pi
from typing import NamedTuple

from flexcli.mechanics.space.linear import SpaceAssembly, assemble
from flexcli.mechanics.space.modes import natural_modes, own_blade_frequency
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.parts.own_motion import DENSEST, TAKES_PART, UNSURE_PART, first_taking
from flexcli.parts.requirements.ask import Told
from flexcli.parts.space_joint import joint_in_space
from flexcli.results import ErrorRange

__all__ = ["INNER", "own_frequency", "parasitic_frequency"]

INNER = 0.8
"""Ratio of a frequency to that of a blade with fixed ends up to which blades follow their ends
quasi-statically."""


def own_frequency(geometry: Geometry, material: Material, sizes: Sizes) -> Told:
    """Return the lowest frequency with a part in the driven motion, the drive free [Hz].

    A mode whose part is about as small as counts is in the range.
    """
    return _frequency(geometry, material, sizes, locked=False)


def parasitic_frequency(geometry: Geometry, material: Material, sizes: Sizes) -> Told:
    """Return the lowest frequency with the drive locked at rest [Hz]."""
    return _frequency(geometry, material, sizes, locked=True)


def _frequency(geometry: Geometry, material: Material, sizes: Sizes, *, locked: bool) -> Told:
    joint = joint_in_space(geometry, material, sizes)
    if not any(body.mass for body in joint.layout.bodies):
        raise NotAvailable("has no body with a mass: give its bodies theirs")

    angular = cache(partial(_angular, locked=locked))

    def lower(assembly: SpaceAssembly) -> float:
        return angular(assembly).lower

    def higher(assembly: SpaceAssembly) -> float:
        return angular(assembly).higher

    best, error, above = angular(joint.assembly).own, joint.error(lower), joint.error(higher)
    # blades of a material without a density may be as heavy as any
    weighs = material.density.value if material.density is not None else DENSEST
    bare, loaded = (
        assemble(geometry.space_layout(material.elastic, sizes, density))
        for density in (0.0, weighs)
    )
    heavy = lower(loaded)
    ratio = heavy / own_blade_frequency(loaded)
    if error is None or above is None or ratio > INNER:
        return Told(best / (2.0 * pi), None)
    # what blades vibrate beside their ends is missing: that of their share of the mass
    share = max(1.0 - (heavy / lower(bare)) ** 2, 0.0)
    low = (1.0 + error.low) * (heavy / best) * (1.0 - share * ratio**2 / (1.0 - ratio**2))
    high = (1.0 + above.high) * higher(joint.assembly) / best
    return Told(best / (2.0 * pi), ErrorRange(low - 1.0, high - 1.0))


class _Lowest(NamedTuple):
    """Lowest angular frequencies [rad/s]: the own one, and of what may be the own mode as well."""

    own: float
    lower: float
    higher: float


def _angular(assembly: SpaceAssembly, *, locked: bool) -> _Lowest:
    """Return the lowest angular frequencies of the modes in question.

    With the drive free they are those that take part in its compliance.
    """
    modes = natural_modes(assembly, locked=locked)
    if not len(modes.angular):
        raise NotAvailable("has no mass that moves")
    if locked:
        return _Lowest(*3 * (float(modes.angular[0]),))
    compliance = (modes.shapes[assembly.driven] / modes.angular) ** 2
    found = []
    for part in (TAKES_PART, TAKES_PART / UNSURE_PART, TAKES_PART * UNSURE_PART):
        first = first_taking(compliance, compliance.sum(), part)
        if first is None:
            raise NotAvailable("has no mass or inertia on the body that moves")
        found.append(float(modes.angular[first]))
    return _Lowest(*found)
