"""Parasitic shift of a joint of the plane at a temperature by beams: of stroke, heat, and both."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from math import inf

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.joint_states import layout_of, warmed
from flexcli.formulas.amplified import FURTHER, bent_part
from flexcli.formulas.plate_factors import bound
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import single
from flexcli.numerics.rows import one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Held
from flexcli.parts.requirements import Ask
from flexcli.parts.requirements.warm_shift import EndShift, WarmShift
from flexcli.parts.temperature import alike, held_bending, held_lengths

__all__ = ["Shifts", "warm_shift"]

Floats = NDArray[np.float64]

Shifts = Callable[[Layout, Held], tuple[Floats, Floats]]
"""Shifts (designs, 2) of a layout that is held so, and by how much they are not settled [m]."""


def warm_shift(ask: Ask, shifts: Shifts) -> WarmShift:
    """Return the shifts of a case with a temperature, alone with its stroke."""
    one_alone()
    scene, geometry, nu = ask.scene, ask.geometry, ask.material.elastic.most_nu
    assert scene.temperature is not None
    drawn, grown = layout_of(ask), warmed(ask)
    layout = _wider(grown, scene.temperature.stiffer(grown, ask.material, geometry.axes))
    plates, held = float(bound(nu)), held_bending(grown, nu)
    kinds, unsure = alike(drawn.blades), held_lengths(grown, ask.material)
    free: Held = None, None, 0.0 if geometry.is_guided else None
    rest = geometry.held(0.0) if scene.moves else free
    heat, off = _with_rest(*shifts(_variants(layout, kinds, unsure, plates), rest))
    raised = FURTHER + plates  # as much as plates may be stiffer
    hotter = layout.grown(1.0 + raised)
    if not scene.moves:
        none = 0.0 * heat
        bent = _bent(shifts, hotter, rest, (none, heat), raised)
        return WarmShift((EndShift(none, heat, none, bent, off),), plates, held, raised)
    # what a modulus may differ by is of the stroke's share as well
    unlike = _drifted(layout, scene.temperature.unlike(grown, ask.material, geometry.axes))
    ends = list[EndShift]()
    for travel in dict.fromkeys(scene.stroke_ends):
        at = geometry.held(travel)
        cold, unsettled = _with_rest(*shifts(drawn, at))
        warm, drifted = _with_rest(*shifts(unlike, at))
        bent = _bent(shifts, hotter, at, (cold, warm), raised)
        ends.append(EndShift(cold, heat, warm - cold - heat, bent, off + unsettled + drifted))
    return WarmShift(tuple(ends), plates, held, raised)


def _bent(
    shifts: Shifts, hotter: Layout, held: Held, of: tuple[Floats, Floats], raised: float
) -> float:
    """Return what heat makes of a shift by bending what is deformed [m], see ``bent_part``.

    ``of`` are the shifts without the heat and with it, ``raised`` by what share it is more in the
    layout. It is endless where that buckles.
    """
    try:
        further = shifts(hotter, held)[0][0]
    except NotAvailable:
        return inf
    return float(np.linalg.norm(bent_part(*of, further, raised)))


def _with_rest(shifts: Floats, unsettled: Floats) -> tuple[Floats, float]:
    """Return the shift of the first design, and by how much the others leave it unsure [m]."""
    off = np.linalg.norm(shifts[1:] - shifts[0], axis=-1).sum()
    return shifts[0], float(off + np.linalg.norm(unsettled[0]))


def _wider(layout: Layout, factors: Mapping[str, float | Floats]) -> Layout:
    """Return a layout of one modulus whose blades are that much stiffer in the plane.

    There a stiffness of any kind is in proportion to the width as to the modulus.
    """
    blades = (replace(blade, b=blade.b * factors[blade.name]) for blade in layout.blades)
    return replace(layout, blades=tuple(blades))


def _variants(
    layout: Layout, kinds: Sequence[Sequence[str]], unsure: Mapping[str, float], plates: float
) -> Layout:
    """Return a layout as it is, and as it may be: a design for each kind of blade and change.

    What is not known of alike blades is the same of each. Blades that are not alike are as plates
    differently much, which counts where they have to share what does not fit.
    """
    changes = len(kinds) if len(kinds) > 1 else 0
    designs = 1 + len(kinds) + changes
    growth = {name: np.full(designs, single(g)) for name, g in layout.blade_growth.items()}
    width = {blade.name: np.ones(designs) for blade in layout.blades}
    for index, names in enumerate(kinds):
        for name in names:
            growth[name][1 + index] += unsure[name]
            if changes:
                width[name][1 + len(kinds) + index] += plates
    return replace(_wider(layout, width), blade_growth=growth)


def _drifted(layout: Layout, unlike: Mapping[str, float]) -> Layout:
    """Return a layout as it is, and with each blade as stiff as it may be."""
    names = [name for name, share in unlike.items() if share]
    width = {blade.name: np.ones(1 + len(names)) for blade in layout.blades}
    for index, name in enumerate(names):
        width[name][1 + index] += unlike[name]
    return _wider(layout, width) if names else layout
