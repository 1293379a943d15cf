"""What a force along a wide blade changes in the factor by which plates raise its stress."""

from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas import plate_factors as plates
from flexcli.formulas.plates_under_force import s_under_force, under_force
from flexcli.formulas.profile import Constant
from flexcli.formulas.sheet_factors import axial_factor
from flexcli.mechanics.layout import Blade
from flexcli.mechanics.stresses import BladeStress
from flexcli.numerics.rows import Number, larger, number, of_each, smaller, states_of
from flexcli.parts.bending.plate_range import blade_factor
from flexcli.parts.geometries.base import Blade as Sizes
from flexcli.parts.requirements import Ask, WideFactor

__all__ = ["StateFactors", "factors_of_states", "factors_of_warmth"]

Floats = NDArray[np.float64]


class StateFactors(NamedTuple):
    """Factors of a blade's stress in each state, its axial share, and its size (states, …)."""

    low: Floats
    high: Floats
    axial: Floats
    kept: Floats
    largest: Floats

    def of_pair(self, one: int, other: int) -> WideFactor:
        """Return the factor of what two states have between them, by the stress of each."""
        pair = [one, other]
        whole = self.largest[pair].sum(axis=0)
        share = np.where(whole > 0.0, self.largest[pair] / np.where(whole > 0.0, whole, 1.0), 0.5)
        return WideFactor(*(number((x[pair] * share).sum(axis=0)) for x in self[:4]))


def factors_of_states(ask: Ask, blade: Blade, stress: BladeStress) -> StateFactors:
    """Return the factors of a blade in all states.

    Its axial force and its moments are those of the beam. Hinges bend over so short a length that
    forces along them change nothing.
    """
    if not isinstance(blade.profile, Constant):
        same = np.ones_like(states_of(stress.axial)[..., 0])
        return StateFactors(same, same, 0.0 * same, same, same)
    x, y = (np.asarray(end) - start for start, end in zip(blade.start, blade.end, strict=True))
    l, h, b, nu, E = (
        _of_states(each)
        for each in (
            np.hypot(x, y), blade.profile.h, blade.b, ask.material.elastic.most_nu,
            ask.material.elastic.E,
        )
    )  # fmt: skip
    s, bent, axial = (states_of(each) for each in (stress.s, stress.bending, stress.axial))
    along = np.diff(s, axis=-1)
    whole = along.sum(axis=-1)

    def mean(values: Floats) -> Floats:
        middle = (values[..., 1:] + values[..., :-1]) / 2.0
        return np.asarray((middle * along).sum(axis=-1) / whole)

    pull = mean(axial)
    n = 12.0 * pull / E * (l / h) ** 2
    at: dict[str, Any] = {"b": b, "l": l, "poisson_ratio": nu}
    low, high = under_force(first=bent[..., 0], last=bent[..., -1], mean=mean(bent), n=n, h=h, **at)
    largest = np.maximum(np.abs(bent[..., 0]), np.abs(bent[..., -1]))
    most = largest + np.abs(pull)
    share = np.abs(pull) / np.where(most > 0.0, most, 1.0)
    kept = np.maximum(axial_factor(**at), s_under_force(n=n, **at))
    return StateFactors(low, high, share, kept, most)


def factors_of_warmth(ask: Ask, blade: Blade, stress: BladeStress) -> StateFactors:
    """Return the factors of the bending of a blade whose ends a temperature moves, in all states.

    A plate's moments over the beam's at the same motions: of an arc, of an S and of what is between
    by their shares. Where the body finds its place by what blades of several shapes resist, and of
    one whose thickness varies, it is anything between those of all shapes.
    """
    nu = ask.material.elastic.most_nu
    under = factors_of_states(ask, blade, stress)
    if not isinstance(blade.profile, Constant):
        flat = 1.0 + float(plates.bound(nu))
        return under._replace(high=flat * under.high, kept=flat * under.kept)
    (x, y), (u, v) = blade.start, blade.end
    l = np.hypot(np.subtract(u, x), np.subtract(v, y))
    sizes = Sizes(_of_designs(blade.profile.h), _of_designs(l), _of_designs(blade.b))
    arc, s_shape = (
        blade_factor(formula, sizes, nu)
        for formula in (plates.pure_bending_factor, plates.guided_factor)
    )
    lows, highs = ((arc.low, s_shape.low), (arc.high, s_shape.high))
    if ask.geometry.closed_forms and ask.geometry.motion == "translation":
        bent = states_of(stress.bending)
        first, last = bent[..., 0], bent[..., -1]
        both = np.abs(first + last) + np.abs(first - last)
        share = np.abs(first - last) / np.where(both > 0.0, both, 1.0)
        low, high = ((1.0 - share) * of_arc + share * of_s for of_arc, of_s in (lows, highs))
    else:
        low, high = np.asarray(smaller(*lows)), np.asarray(larger(*highs))
    return under._replace(low=low * under.low, high=high * under.high)


def _of_designs(value: Any) -> Number:
    """Return a size of a blade as the number of one design, or those of many."""
    return of_each(np.ravel(np.asarray(value, dtype=np.float64)))


def _of_states(value: Any) -> Floats:
    """Return a number of one design, or those of many as (states, designs) or (1, designs)."""
    found = np.asarray(value, dtype=np.float64)
    return states_of(found.ravel()) if found.ndim else found
