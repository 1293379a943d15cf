"""Parasitic shift of a joint of the plane by thin shells, its bodies held upright.

Shells know how plates bend, shorten and flatten between their clamps, exact beams of the plane what
shear does besides: a shift is that of shells, times what shear changes in that of beams.
"""

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from flexcli.engine.joint_models.exact import DIGITS, lost, shifts_of
from flexcli.engine.joint_models.joint_states import solved
from flexcli.engine.joint_models.space_errors import STOUTEST
from flexcli.engine.joint_models.strain_law import off_by_strain_law
from flexcli.errors import SolveError
from flexcli.formulas.plate_factors import effective_width
from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.mesh import Effects
from flexcli.mechanics.shell.first_guess import shells_from_beams
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import solve
from flexcli.mechanics.space.exact.members import FIRST_GUESS
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.state import Equilibrium
from flexcli.mechanics.stresses import blade_stress
from flexcli.numerics.rows import one_alone
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import MOVING
from flexcli.parts.requirements import Ask

__all__ = [
    "LEVELS",
    "TOLERANCE",
    "check_thin",
    "narrowed",
    "shift_by_shells",
    "upright",
]

LEVELS, TOLERANCE = (FIRST_GUESS, 12, 16, 20, 24), 2e-3
"""Modes along a blade, and by how much forces and motions may differ from one to the next."""

NARROWEST, WIDEST, THICKEST = 0.05, 3.0, 0.1
"""Least and largest b/l, and h/l: in narrower blades polynomials do not find the layers at the
clamps, others were not held against solids."""

ROUNDING = 1e-9
"""Of a size at the very end of its range."""

LEAST = 1e-11
"""Of a travel, below which rounding leaves of a shift none to be told."""

OF_STRAIN = 4.0
"""Times the largest axial strain: shells have Green's, beams that of engineers, and no material
states its law; beams under 10⁻³ were 2.6 times that from shells that neither curl nor shear."""

OF_SHEAR, OF_PLATES, FLOOR = 0.5, 0.05, 3e-4
"""Errors: shares of what shear and of what plates change, and the least.

CalculiX's solids of pivots of two and three blades, of parallelograms and of folded stages, even
and uneven, h/l from 0.0004 to 0.26, h/b to 0.2, were at most 0.28 of what shear changes less
(``tests/benchmarks/shell_shifts.py``)."""

MOST_POISSON = 0.45
"""Largest Poisson's ratio of those."""

ALIKE = 1e-9
"""Relative difference of the shifts of both ends that counts as none."""


class _Path(NamedTuple):
    """How far a travel moves the centre [m] by beams without shear, shells, and coarser ones.

    ``stretched`` is the largest axial strain.
    """

    beams: float
    shells: float
    coarser: float
    stretched: float


def shift_by_shells(ask: Ask) -> tuple[float, float]:
    """Return the largest shift at the ends of a stroke alone, signed as beams', and its error.

    Raises
    ------
    NotAvailable
        When its blades are none of which thin shells were held against solids, or it buckles.

    Returns
    -------
    shift, error : float
        The shift [m], and its relative error [-].

    """
    one_alone()
    layout = _thin(ask)
    found = list[tuple[float, float]]()
    beams = list[float]()
    for travel in ask.scene.stroke_ends:
        shift = float(shifts_of(_beams(ask, layout, travel, Effects()), ask)[0])
        if shift == 0.0 or any(abs(abs(shift / other) - 1.0) < ALIKE for other in beams):
            continue  # the joint's mirror image, or at rest
        beams.append(shift)
        found.append(_at_end(ask, layout, travel, shift))
    if not found:
        raise NotAvailable("has no shift")
    return max(found, key=lambda each: abs(each[0]))


def _at_end(ask: Ask, layout: Layout, travel: float, beams: float) -> tuple[float, float]:
    """Return the shift at an end of the stroke, and its error.

    Sections of thick blades curl as plates between their own width and the effective one.
    """
    wide = _path(ask, layout, travel)
    less = _path(ask, narrowed(layout), travel)
    each = wide.shells / wide.beams, less.shells / less.beams
    widened, apart = sum(each) / 2.0, abs(each[0] - each[1]) / 2.0
    sheared = abs(abs(beams / wide.beams) - 1.0)
    error = abs(wide.coarser / wide.shells - 1.0) + apart / widened
    error += OF_SHEAR * sheared + OF_PLATES * abs(widened - 1.0)
    error += OF_STRAIN * wide.stretched + off_by_strain_law(ask, beams)
    digits = lost(ask, beams)
    if digits * LEAST > 1.0:
        raise NotAvailable("has a shift that is lost in rounding")
    error += DIGITS * digits
    return beams * widened, error + FLOOR


def _thin(ask: Ask) -> Layout:
    """Return the joint, all its blades in one plane, where shells are known."""
    layout = ask.geometry.layout(ask.material.elastic, ask.sizes)
    check_thin(ask, layout)
    return upright(layout)


def upright(layout: Layout) -> Layout:
    """Return a layout all of whose blades are in one plane."""
    return replace(layout, blades=tuple(replace(blade, z=0.0) for blade in layout.blades))


def check_thin(ask: Ask, layout: Layout) -> None:
    """Raise :class:`NotAvailable` where thin shells were not held against solids of such blades."""
    nu = ask.material.poisson_ratio
    if nu is None:
        raise NotAvailable("needs material.poisson_ratio for shells")
    if ask.material.is_uneven:
        raise NotAvailable("has blades that differ by their directions: take --model exact")
    if ask.geometry.joined_in or layout.guides or nu.value > MOST_POISSON:
        raise NotAvailable("has no such number by shells: take --model exact")
    for blade in layout.blades:
        if not isinstance(blade.profile, Constant):
            raise NotAvailable("has blades of varying thickness, of which there are no shells")
        h, b, l = float(blade.profile.h), float(blade.b), float(blade.length)
        thin = h <= THICKEST * l and h <= STOUTEST * b
        if not (thin and NARROWEST * l <= b <= WIDEST * (1.0 + ROUNDING) * l):
            raise NotAvailable("has blades of which no shells were held against solids")


def narrowed(layout: Layout) -> Layout:
    """Return a layout of blades of their effective widths."""
    blades = (
        replace(blade, b=float(effective_width(b=float(blade.b), h=float(blade.profile.h))))
        for blade in layout.blades
        if isinstance(blade.profile, Constant)
    )
    return replace(layout, blades=tuple(blades))


def _path(ask: Ask, layout: Layout, travel: float) -> _Path:
    """Return how far a travel moves the centre off its path by a layout's beams and shells."""
    turns, held = ask.geometry.motion == "rotation", ask.geometry.held(travel)
    space = from_plane(layout, MOVING, turns=turns)
    motion: list[float | None] = [None] * 6
    motion[3 if turns else 0] = travel
    if not turns:
        motion[5] = held[2]
    drive = space.drive
    try:
        state = solve(
            space,
            {drive.body: motion},
            frames=drive_frame(drive),
            tolerance=TOLERANCE,
            levels=LEVELS,
            made=shells_from_beams,
        ).checked()
    except SolveError as error:
        raise NotAvailable(f"has no shift by shells: {error}") from error
    if state.unstable or state.coarser is None:
        raise NotAvailable("buckles at its stroke by shells")
    point = (0.0, 0.0, 0.0) if turns else drive.point
    each = (
        float(np.linalg.norm(at.motion_of(drive.body, point)[: 2 if turns else 1]))
        for at in (state, state.coarser)
    )
    plain = _beams(ask, layout, travel, Effects(shear=False))
    beams, (shells, coarser) = abs(float(shifts_of(plain, ask)[0])), each
    if not (beams and shells):
        raise NotAvailable("has no shift")
    return _Path(beams, shells, coarser, _stretched(plain))


def _stretched(plain: Equilibrium) -> float:
    """Return the largest axial strain of beams."""
    each = (blade_stress(plain, blade.name) for blade in plain.layout.blades)
    return max(float(np.abs(found.axial).max()) for found in each) / float(plain.layout.E)


def _beams(ask: Ask, layout: Layout, travel: float, effects: Effects) -> Equilibrium:
    """Return exact beams of the plane at a travel."""
    return solved(layout, {MOVING: ask.geometry.held(travel)}, effects=effects)
