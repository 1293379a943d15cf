"""What the law of finite strain, which no material states, may change in a parasitic shift."""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.blade_weight import forced_stress
from flexcli.engine.joint_models.exact import shifts_of
from flexcli.engine.joint_models.joint_states import layout_of, linearly
from flexcli.engine.joint_models.linear import LinearState
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.own_weight import blade_places
from flexcli.numerics.rows import Number, larger, of_each
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask

__all__ = ["off_by_strain_law"]

Floats = NDArray[np.float64]


def off_by_strain_law(ask: Ask, shift: Number) -> Number:
    """Return what laws of finite strain may change of the shift of a stroke, relative [-].

    Bent to ±ε at its faces and not pulled, a blade's middle grows by −ε²/2 where stress is linear
    in Green's strain and by +ε²/2 where it is in Hencky's, of which the beam's is the mean, and by
    ν ε²/2 in all of them: what presses it through its thickness, and curls, is of that order too.

    Parameters
    ----------
    ask : Ask
        The joint, in its plane, at a stroke.
    shift : float
        Its shift by beams [m].

    Raises
    ------
    NotAvailable
        When it has no linear solution.

    Notes
    -----
    Strains are those of small motion, and the centre moves with what blades grow as at rest.
    Metals may be beyond Hencky's law.

    References
    ----------
    Our own: pure bending of a strip in plane stress, its radii solved for by either law.

    """
    geometry, travel = ask.geometry, larger(map(abs, ask.scene.stroke_ends))
    effects = Effects()
    if geometry.layout_lacks:
        layout = geometry.blades_layout(ask.material.elastic, ask.sizes)
    else:
        layout = layout_of(ask)
    bent = linearly(layout, {MOVING: geometry.held(travel)}, effects=effects)
    laws, growth = (1.0 + ask.material.elastic.most_nu) / 2.0, dict[str, Floats]()
    for index, blade in enumerate(layout.blades):
        bending = forced_stress(blade, bent.end_forces[:, index])[1]
        s, _ = blade_places(blade, blade.length)
        E = np.reshape(layout.E * blade.stiffer, (-1, 1))
        squared = np.trapezoid((bending / E) ** 2, s)
        growth[blade.name] = laws * squared / blade.length
    layout = replace(layout, blade_growth=growth)
    grown = linearly(layout, {MOVING: geometry.held(0.0)}, effects=effects)
    state = LinearState(layout, grown.motions, grown.end_forces)
    return of_each(np.abs(shifts_of(state, ask))) / abs(shift)
