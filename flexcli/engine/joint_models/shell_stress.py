"""Bending moments of a joint of the plane by thin shells, its bodies held upright.

Shells know what plates between clamps bear: how they widen, how a force along them and curvature
change that, how unequal ones share a load. What beams without shear bear in the same states is
taken from it; what is left is added to the stress of exact beams, which shear.
"""

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.engine.joint_models.face_stress import PlateStresses
from flexcli.engine.joint_models.joint_states import of_case, solved, states_of
from flexcli.engine.joint_models.shell_shift import (
    LEVELS,
    TOLERANCE,
    check_thin,
    narrowed,
    upright,
)
from flexcli.errors import SolveError
from flexcli.formulas.plate_factors import beyond_plate
from flexcli.formulas.profile import Constant
from flexcli.mechanics.demand import Held
from flexcli.mechanics.layout import Layout, Load
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.shell.first_guess import shells_from_beams
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium, solve
from flexcli.mechanics.space.exact.rotation import matrix_of
from flexcli.mechanics.space.layout import SpaceBlade, SpaceLoad, SpaceRod
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import BladeStress, blade_stress
from flexcli.numerics.rows import one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask

__all__ = ["by_plates"]

Floats = NDArray[np.float64]

E_X = np.array([1.0, 0.0, 0.0])

PLAIN = Effects(shear=False)
"""Of the beams that shells are held against, which have none."""

OF_PLATES, FLOOR = 0.02, 2e-3
"""Errors: a share of what plates change, and the least, of the largest stress of the blade.

Solids (CalculiX) of guides, cantilevers, stages, pivots and stars, b/l 0.15 to 3, h/l 0.003 to 0.06
and travels to 0.3 l or 0.3 rad, were within 0.003 of the whole where they know it as well
(``tests/benchmarks/shell_stresses.py``)."""


class _States(NamedTuple):
    """Shells in a case's states.

    ``motions`` (states, bodies, 3) are those of the bodies [m, rad]. ``stresses`` and ``coarser``,
    those of the level before, (states, blades, 4) are the bending stress at both ends and the axial
    one there [Pa].
    """

    motions: Floats
    stresses: Floats
    coarser: Floats


def by_plates(ask: Ask) -> PlateStresses:
    """Return what plates make of the stress of a case's beams, in each of its states.

    Sections of thick blades curl as plates between their own width and the effective one.

    Raises
    ------
    NotAvailable
        When its blades are none of which thin shells were held against solids, or it buckles.

    """
    one_alone()
    layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
    check_thin(ask, layout)
    if ask.scene.temperature is not None:
        raise NotAvailable("has no stress by shells at a temperature")
    widths = False, True
    own, less = (_shells(ask, is_narrow=each) for each in widths)
    beams = [_beams(ask, is_narrow=each) for each in widths]
    largest = [_sizes(each) for each in beams]
    # under a force a narrower blade has the more stress: as a share of that of its beams
    scale = largest[0] / np.where(largest[1] > 0.0, largest[1], 1.0)
    changes = own.stresses - beams[0], (less.stresses - beams[1]) * scale[..., None]
    middle, apart = (changes[0] + changes[1]) / 2.0, (changes[0] - changes[1]) / 2.0
    parts = np.stack([middle, apart, own.stresses, own.coarser])
    thick = _thick(ask, layout)
    unsure = _unsure(parts, thick)
    if ask.scene.moves:  # states are pairs of both ends
        unsure = max(unsure, _unsure((parts[:, ::2] - parts[:, 1::2]) / 2.0, thick))
    return PlateStresses(middle[..., :2], middle[..., 2:], unsure)


def _unsure(parts: Floats, thick: Floats) -> float:
    """Return by what share the largest stress of all is unsure, ``thick`` for each blade.

    The parts are what plates add, half of what both widths differ by, and shells on two levels.
    """
    middle, apart, shells, coarser = parts
    sizes = _sizes(shells)
    off = _sizes(apart) + _sizes(shells - coarser) + OF_PLATES * _sizes(middle)
    off += (FLOOR + thick) * sizes
    most = float(sizes.max())
    return float(off.max()) / most if most else 0.0


def _sizes(stress: Floats) -> Floats:
    """Return the largest stress at a face of a blade, of both ends (…,) [Pa]."""
    each = np.abs(stress)
    return np.asarray(np.max(each[..., :2] + each[..., 2:], axis=-1))


def _thick(ask: Ask, layout: Layout) -> Floats:
    """Return by what share thick blades may be stiffer or softer than plates that shear (blades,).

    Clamps keep them from thinning and from warping.
    """
    found = []
    for blade in layout.blades:
        assert isinstance(blade.profile, Constant)  # of which there are shells
        at = {"l": float(blade.length), "poisson_ratio": ask.material.elastic.most_nu}
        found.append(np.max(beyond_plate(h=blade.profile.h, **at)))
    return np.array(found)


def _shells(ask: Ask, *, is_narrow: bool) -> _States:
    """Return the states of a case by shells."""

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> _States:
        drawn = _drawn(layout, is_narrow=is_narrow)
        each = [_by_shells(ask, drawn, *state) for state in states_of(held, loads)]
        return _States(*(np.stack(part) for part in zip(*each, strict=True)))

    return of_case(ask, solver)


def _beams(ask: Ask, *, is_narrow: bool) -> Floats:
    """Return the stresses of a case's states by beams, as those of shells (states, blades, 4) [Pa].

    A stroke starts where its loads leave the joint, beams where they leave beams: what shells bear
    of a load along the stroke would not be that of beams that are moved as far.
    """

    def solver(layout: Layout, held: Held, loads: Sequence[Load]) -> Equilibrium:
        return solved(_drawn(layout, is_narrow=is_narrow), held, loads=loads, effects=PLAIN)

    found = of_case(ask, solver)
    each = [_at_ends(blade_stress(found, blade.name)) for blade in found.layout.blades]
    return np.stack(each, axis=1)


def _drawn(layout: Layout, *, is_narrow: bool) -> Layout:
    return narrowed(upright(layout)) if is_narrow else upright(layout)


def _at_ends(found: BladeStress) -> Floats:
    ends = [x[:, [0, -1]] for x in (found.bending, found.axial)]
    return np.concatenate(ends, axis=-1)


def _in_space(load: Load) -> SpaceLoad:
    """Return a load in the plane as one in space."""
    point = float(load.point[0]), float(load.point[1]), 0.0
    return SpaceLoad(load.body, point, (*load.force, 0.0), (0.0, 0.0, load.moment))


def _by_shells(
    ask: Ask, layout: Layout, held: Held, loads: Sequence[Load]
) -> tuple[Floats, Floats, Floats]:
    """Return motions of the bodies in the plane and stresses at the ends of blades, two levels."""
    space = from_plane(layout, MOVING, turns=ask.geometry.motion == "rotation")
    motions = {body: (x, y, None, None, None, phi) for body, (x, y, phi) in held.items()}
    try:
        state = solve(
            space, motions, loads=[_in_space(load) for load in loads],
            tolerance=TOLERANCE, levels=LEVELS, made=shells_from_beams,
        ).checked()  # fmt: skip
    except SolveError as error:
        raise NotAvailable(f"has no stress by shells: {error}") from error
    if state.coarser is None or (state.unstable and (loads or _moves(held))):
        raise NotAvailable("buckles by shells")
    moved = state.coordinates[:, [0, 1, 5]]
    return moved, _stresses(state), _stresses(state.coarser)


def _thickness(blade: SpaceBlade | SpaceRod) -> float:
    assert isinstance(blade, SpaceBlade)  # of the plane
    assert isinstance(blade.profile, Constant)  # of which there are shells
    return float(blade.profile.h)


def _moves(held: Held) -> bool:
    return any(x for motion in held.values() for x in motion)


def _stresses(state: SpaceEquilibrium) -> Floats:
    """Return bending stress at start and end, and axial one there, of shells (blades, 4) [Pa]."""
    force, moment = np.split(state.own_forces, 2, axis=-1)
    ends = state.linearised.blades
    reach, along = ends.motion + E_X, matrix_of(ends.turn)[..., 0]
    started = (moment + np.cross(reach, force))[:, 2]
    blades = state.layout.blades
    E = np.array([each.material.E for each in blades if isinstance(each, SpaceBlade)])
    h = np.array([_thickness(blade) for blade in blades]) / state.part.assembly.members.lengths
    bending = np.stack([started, moment[:, 2]], axis=-1) * (E * h / 2.0)[:, None]
    pulled = np.stack([force[:, 0], np.sum(force * along, axis=-1)], axis=-1)
    return np.concatenate([bending, pulled * (E * h**2 / 12.0)[:, None]], axis=-1)
