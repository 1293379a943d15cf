"""Anticlastic flattening: a wide blade that is bent far keeps its section from curling."""

from typing import ClassVar

import numpy as np

from flexcli.formulas.plate_factors import bound
from flexcli.formulas.plate_flattening import (
    energy_factor,
    flat_width,
    held_and_curved,
    secant_factor,
)
from flexcli.numerics.quadrature import gauss_rule
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.effects.plate import wide_of

__all__ = ["Anticlastic"]

FREE, TAKEN = 2.6, 0.8
"""Of what clamps leave free of the plates' widening, 1 − ρ, the power that is at least left to
curvature, and of what they take, ρ, the share that is at most not, where it flattens nothing.

Thin shells bent to arcs, to S shapes, by forces at a tip and as pivots do, b/l 0.1 to 2, h/l 0.001
to 0.02, ν 0.3 and 0.45, b²κ/h to 1300 (``tests/benchmarks/flattened_blades.py``)."""

UNEVEN = 1.3
"""Times the most of that: blades that are bent more at one end flatten more there."""

_NODES = 8
"""Gauss nodes along a blade: the factor is smooth in a curvature that is linear."""


class Anticlastic(ModelEffect):
    """Flattening by curvature beside that by the clamps, b²κ/h; none at rest.

    Where clamps keep sections flat, curvature has the less to flatten: the moment of a travel rises
    by a part of what both would add as independent effects, and by no less than the energy of the
    curvature alone says.
    """

    name: ClassVar[EffectName] = EffectName.ANTICLASTIC
    grows_with_travel: ClassVar[bool] = True
    needs: ClassVar[str] = "poisson_ratio"
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return Searle's b²κ/h at the most curved place."""
        ends = _end_curvatures(setting)
        if ends is None:
            return None
        h, _, b = _blade(setting)
        searle = b**2 * larger(abs(end) for end in ends) / h
        return Indicator(searle, f"b²κ/h = {searle:.2g}")

    def changes(self, setting: Setting) -> Changes:
        """Return the change of the moment at the largest travel."""
        ends, wide = _end_curvatures(setting), wide_of(setting)
        if ends is None or wide is None:
            return {}
        h, _, b = _blade(setting)
        nu, held = setting.poisson_bound, wide.stress.value
        most = (1.0 + number(bound(nu))) / held - 1.0
        place, weight = gauss_rule(_NODES)
        first, last, width, thick, ratio = (np.asarray(x)[..., None] for x in (*ends, b, h, nu))
        curvature = first + (last - first) * place
        beta = flat_width(b=width, h=thick, curvature=curvature, poisson_ratio=ratio)
        share = weight * curvature**2
        curved, least = (
            number((rises[..., None, :] @ share[..., :, None])[..., 0, 0] / share.sum(axis=-1))
            for rises in (
                factor(beta=beta, poisson_ratio=ratio) for factor in (secant_factor, energy_factor)
            )
        )
        both = number(held_and_curved(held=held, curved=curved, poisson_ratio=nu)) / held - 1.0
        whole = number(bound(nu))
        kept, flat = ((x - 1.0) / whole if whole else 0.0 * x for x in (held, curved))
        kept, flat = (larger(smaller(x, 1.0), 0.0) for x in (kept, flat))
        high = smaller(UNEVEN * both * (1.0 - TAKEN * kept * (1.0 - flat)), larger(most, 0.0))
        if self.lacks(setting):  # at ν = ½, where sections flatten the most
            return {"stress": Change(None, larger(high, 0.0), 0.0, 1)}
        low = larger(both * (1.0 - kept) ** FREE, least / held - 1.0)
        low = smaller(low, high)
        return {"stress": Change((low + high) / 2.0, high, (high - low) / 2.0)}


def _blade(setting: Setting) -> tuple[float, float, float]:
    """Return h, l and b of the blade whose curvatures are known [m]."""
    wide = wide_of(setting)
    blade = (wide.bent if wide is not None else None) or setting.blade
    assert blade is not None  # those that have curvatures
    h, l, b = (number(size) for size in blade)
    return h, l, b


def _end_curvatures(setting: Setting) -> tuple[float, float] | None:
    """Return the beam's curvatures at both ends of a blade at the largest travel [1/m]."""
    wide, travel = wide_of(setting), setting.largest_travel
    if wide is None or wide.bends is None or not travel:
        return None
    first, second = wide.bends
    return first * travel, second * travel
