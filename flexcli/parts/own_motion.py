"""The mechanism's driven motion: its mode among all modes of bodies and heavy blades."""

from collections.abc import Iterable

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.blade_spring import Warping
from flexcli.formulas.profile import Constant, NeckedDown
from flexcli.formulas.quantity import Quantity
from flexcli.mechanics.hanging_mass import hanging_mass as hanging_in
from flexcli.mechanics.layout import Layout
from flexcli.numerics.modes import natural_modes
from flexcli.numerics.rows import cos, number, sin
from flexcli.parts.elastic import Elastic, NotAvailable
from flexcli.parts.geometries.base import MOVING, Geometry, Sizes
from flexcli.parts.mechanisms import Mechanism, MechanismError, Mode
from flexcli.parts.mechanisms.carried import carried, is_guided
from flexcli.parts.structure import Structure, joined

__all__ = [
    "DENSEST",
    "TAKES_PART",
    "UNSURE_PART",
    "either_mode",
    "first_taking",
    "hanging_mass",
    "hanging_on",
    "own_angular",
    "own_mode",
    "structure_of",
]

Floats = NDArray[np.float64]

DENSEST = 22_600.0
"""Density of osmium [kg/m³], the upper limit for blades of unknown material."""

TAKES_PART = 0.01
"""Part of the driven motion's compliance from which a mode belongs to it."""

UNSURE_PART = 3.0
"""Factor by which models may differ in a mode's part: one about as large as that belongs to it in
one, and not in another."""

KEEPS_WARPING = 1e3
"""Factor by which a notch without warping is stiffer in torsion than its sections."""

NO_MASS = "a frequency needs a mass that moves"
HINT = "add mechanism: {kind: payload, mass: …}, or give a layout's bodies their mass"


def structure_of(
    mechanism: Mechanism | None,
    geometry: Geometry,
    elastic: Elastic,
    sizes: Sizes,
    lock: str | None = None,
    density: float = 0.0,
    *,
    thick: bool = False,
) -> Structure:
    """Return a mechanism, or a layout whose own bodies have mass, as a structure in its plane.

    Raises
    ------
    MechanismError
        When nothing that moves has a mass, or the lock is none of this mechanism.
    NotAvailable
        When the joint is not made of blades in a plane.

    """
    if mechanism is not None:
        return mechanism.structure(geometry, elastic, sizes, lock, density, thick=thick)
    if not geometry.has_masses:
        raise MechanismError("mechanism", NO_MASS, HINT)
    return carried(geometry, elastic, sizes, density=density, thick=thick)


def own_mode(
    mechanism: Mechanism | None,
    stiffness: Quantity,
    geometry: Geometry,
    elastic: Elastic,
    sizes: Sizes,
) -> Mode:
    """Return stiffness and mass of the mechanism's own motion, the blades without mass.

    Of a layout whose bodies have mass all coordinates count: the mass is what gives the mode's
    frequency with the stiffness of the motion.

    Raises
    ------
    MechanismError
        When nothing says what moves.

    """
    if not geometry.has_masses:
        if mechanism is None:
            raise MechanismError("mechanism", NO_MASS, HINT)
        return mechanism.mode(stiffness, geometry)
    structure = structure_of(mechanism, geometry, elastic, sizes)
    return Mode(stiffness, structure.motion_stiffness / own_angular(structure) ** 2)


def own_angular(structure: Structure, part: float = TAKES_PART) -> float:
    """Return the angular frequency [rad/s] of the lowest mode that the own motion takes part in.

    Modes are weighed by what they add to the static compliance of the motion, so that a mode
    which only rocks a body beside the motion does not stand for it: ``part`` is the least share.
    """
    return _lowest_taking(structure, (part,))[0]


def either_mode(structure: Structure) -> float:
    """Return by what share a frequency may be that of another mode, whose part may count or not.

    It is nothing where no mode's part is about as small as that.
    """
    parts = TAKES_PART, TAKES_PART / UNSURE_PART, TAKES_PART * UNSURE_PART
    own, *others = _lowest_taking(structure, parts)
    return max(abs(other / own - 1.0) for other in others)


def first_taking(compliance: Floats, whole: float, part: float = TAKES_PART) -> int | None:
    """Return the first of some modes that adds more than a part to the whole compliance, if any."""
    taking = np.flatnonzero(compliance > part * whole)
    return int(taking[0]) if taking.size else None


def _lowest_taking(structure: Structure, parts: Iterable[float]) -> list[float]:
    """Return the angular frequencies of the lowest modes that take these parts at least [rad/s]."""
    assert structure.motion is not None  # not locked
    modes = natural_modes(structure.stiffness, structure.mass)
    compliance = (structure.motion @ modes.shapes) ** 2 / modes.angular**2
    found = []
    for part in parts:
        first = first_taking(compliance, 1.0 / structure.motion_stiffness, part)
        if first is None:
            raise MechanismError("mechanism", "the body that moves has no mass or inertia", HINT)
        found.append(number(modes.angular[first]))
    return found


def hanging_mass(
    mechanism: Mechanism | None,
    geometry: Geometry,
    elastic: Elastic,
    sizes: Sizes,
    axis: str,
    warping: Warping = "restrained",
) -> float:
    """Return the mass that the joint carries against a steady acceleration along an axis [kg].

    Bodies of a layout hang on the moving one as their place lets them; x is along the stroke.

    Raises
    ------
    MechanismError
        When nothing says what hangs.
    NotAvailable
        When the material gives no shear modulus for the blades between several bodies.

    """
    if not geometry.has_masses:
        if mechanism is None:
            raise MechanismError("mechanism", "a sag needs a mass that hangs", HINT)
        return mechanism.hanging_mass()
    payload = mechanism.hanging_mass() if mechanism is not None else 0.0
    return hanging_on(geometry, elastic, sizes, payload, axis, warping=warping)


def hanging_on(
    geometry: Geometry,
    elastic: Elastic,
    sizes: Sizes,
    payload: float,
    axis: str,
    *,
    arm: float = 0.0,
    density: float = 0.0,
    warping: Warping = "restrained",
) -> float:
    """Return the effective mass at a joint's moving body that carries a payload [kg].

    Where ``warping`` is restrained, notches do not twist at all: their throats keep their warping.
    ``arm`` [m] is how far along the blades the payload's centre lies beyond the body's point.
    """
    layout = geometry.blades_layout(elastic, sizes)
    moving = layout.body(MOVING)
    x, y = moving.point
    load = moving._replace(mass=payload, inertia=0.0, com=(x + arm, y))
    body = joined(MOVING, moving.point, [moving, load])
    bodies = tuple(body if b.name == MOVING else b for b in layout.bodies)
    G = layout.G
    if warping == "restrained" and not all(
        isinstance(blade.profile, Constant | NeckedDown) for blade in layout.blades
    ):
        warping = "free"
        if axis == "z" and G is not None:
            G *= KEEPS_WARPING
    whole = Layout(bodies, layout.blades, layout.E, G, layout.supports)
    c, s = cos(geometry.axes), sin(geometry.axes)
    along = {"x": (c, s, 0.0), "y": (-s, c, 0.0), "z": (0.0, 0.0, 1.0)}[axis]
    try:
        return hanging_in(
            whole, MOVING, along, density, is_guided=is_guided(geometry), warping=warping
        )
    except SolveError as error:
        raise NotAvailable(f"has no sag along {axis}: {error}") from error
