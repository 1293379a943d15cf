"""What each model declares: the effects that it carries, its cost, what it borrows."""

from typing import NamedTuple

from flexcli.mechanics.mesh import Effects
from flexcli.parts.effect_names import EffectName

__all__ = ["COARSE", "COVERAGE", "FINE", "OUTER", "Coverage", "covered"]


class Coverage(NamedTuple):
    """The effects a model ``can`` carry or leave out, and those that it ``always`` carries.

    What it does not carry, its answers to ``borrowed`` included, is corrected on top or left out.
    ``cost`` is declared in closed forms, with all that is printed of a design.
    """

    can: frozenset[EffectName]
    always: frozenset[EffectName]
    cost: float
    borrowed: tuple[str, ...] = ()


_SWITCHED = frozenset({EffectName.SHEAR, EffectName.AXIAL_EXTENSION})
_OF_BEAMS = frozenset({EffectName.BLADE_TENSION, EffectName.HINGE_LENGTH, EffectName.ROOT_RADIUS})
_AT_TRAVEL = frozenset({EffectName.LARGE_ROTATION, EffectName.AXIAL_LOAD})

COVERAGE = {
    "closed-form": Coverage(frozenset(), frozenset(), 1.0),
    "linear": Coverage(_SWITCHED, _OF_BEAMS, 20.0, ("shift",)),
    "exact": Coverage(_SWITCHED, _OF_BEAMS | _AT_TRAVEL, 40.0),
}
"""From the cheapest to the finest; the exact one's cost is at its coarsest tolerance."""


def covered(model: str, blades: Effects) -> frozenset[EffectName]:
    """Return what a model of beams carries, of what it can, with blades that deform so."""
    has = {EffectName.SHEAR: blades.shear, EffectName.AXIAL_EXTENSION: blades.extension}
    return frozenset(name for name in COVERAGE[model].can if has[name])


OUTER = frozenset(
    {
        EffectName.PLATE_WIDENING,
        EffectName.ANTICLASTIC,
        EffectName.WARPING,
        EffectName.CLAMP_STRESS,
        EffectName.CLAMP_COMPLIANCE,
        EffectName.THICK_NOTCH,
        EffectName.BLADE_MASS,
    }
)
"""What no model of beams has inside, so that a correction on top carries it in all of them."""

COARSE, FINE = 1e-6, 1e-12
"""Tolerances between which the exact model is asked to work."""
