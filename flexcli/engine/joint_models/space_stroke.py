"""A joint in space at a travel: beams or shells, the drive held, other loads of the case aside."""

from collections.abc import Callable
from typing import NamedTuple
from weakref import WeakKeyDictionary

import numpy as np
from numpy.typing import NDArray

from flexcli.formulas.profile import Constant
from flexcli.formulas.rigid_motion import axes_about_z, motion_along
from flexcli.mechanics.refinement import LEVELS
from flexcli.mechanics.space.exact.beams import beams_of
from flexcli.mechanics.space.exact.demand import drive_frame
from flexcli.mechanics.space.exact.equilibrium import SpaceEquilibrium, beside, solve
from flexcli.mechanics.space.exact.members import MembersOf
from flexcli.mechanics.space.exact.support import support_compliance
from flexcli.mechanics.space.layout import SpaceLayout, SpaceRod, Vector
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask
from flexcli.parts.space_joint import SpaceJoint, joint_in_space
from flexcli.results import ErrorRange

__all__ = [
    "BEAMS",
    "Blades",
    "StrokeErrors",
    "along_cases",
    "at_travel",
    "compliance_along_cases",
    "driven_coordinate",
    "forget",
    "is_compared",
    "strain_error",
    "support_at_stroke",
]

Floats = NDArray[np.float64]

TOLERANCE = 1e-5
"""Of forces and motions: of its tangent, the last two levels of nodes tell."""

BEAM_ERROR = 0.06
"""Error of a support stiffness at stroke by beams whose sections curl, against CalculiX's solids.

Two-blade guides, b/l 0.2 and 0.5, b/h 40 and 100, strokes of l/20 and l/5, and crossed pivots, b/l
0.4, at 10° and 15°: within 4.6 %, 1 % of it by the mesh of the solids."""

SHIFT_ERROR = 0.02
"""Error of the motion beside a stroke, against the solids of ``BEAM_ERROR``: within 0.7 %."""

STRESS_ERROR = 0.05
"""Error of the nominal stress of a stroke: of the drive's force, within 1 % of those solids, and of
how restrained warping spreads."""

BUCKLING_ERROR = 0.1
"""Error of a critical share by beams: of their support stiffness at stroke, and of the mass of
blades, which is not among their loads."""

WIDEST, THICKEST, LONGEST = 0.5, 0.02, 0.2
"""Largest b/l, h/l, and shift of a blade's end against its start over its length, compared."""

WIDE, THICK = 2.0, 0.1
"""Largest b/l and h/l for which is told what thermal forces change.

Bridges between walls, to four fifths of what buckles them, against CalculiX's solids: the change is
within 4 % of its own at h/l 0.02 to 0.1 and b/l 0.2 to 1.5.
"""

EULER_SHEAR = 10.5
"""Share of (h/l)² by which shear lowers Euler's load of a clamped beam, 4π² E/(12 κ G), ν = 1/3."""

ROUNDING = 0.02
"""What a stroke of a fifth of the length moves besides, along the blade."""

_KNOWN: WeakKeyDictionary[SpaceJoint, dict[tuple[str, float | None, bool], SpaceEquilibrium]]
_KNOWN = WeakKeyDictionary()


class StrokeErrors(NamedTuple):
    """Relative errors at a stroke beside that of the level: of what blades are made of."""

    support: float
    shift: float
    stress: float
    critical: float


class Blades(NamedTuple):
    """What blades are made of at a stroke, how finely, and what is known of their errors.

    ``errors`` gives nothing where they are not known. ``critical`` are levels and accuracy of
    critical loads.
    """

    name: str
    made: MembersOf
    levels: tuple[int, ...]
    tolerance: float
    errors: Callable[[SpaceEquilibrium], StrokeErrors | None]
    critical: tuple[tuple[int, ...], float]


def at_travel(
    ask: Ask, travel: float | None, blades: Blades | None = None, *, warm: bool = True
) -> SpaceEquilibrium:
    """Return the joint at a travel of its drive, all else free but for a guide; by beams if unsaid.

    Without a travel the drive is free: the joint is as its temperature leaves it, which it has
    where it is ``warm``. Where the ask is ``near`` another, what a small change makes of that one.

    Raises
    ------
    NotAvailable
        When it is not made of blades of constant thickness, or has no stable equilibrium there.
    SolveError
        When the path to it ends before.

    """
    heat = ask.scene.temperature if warm else None
    joint = joint_in_space(ask.geometry, ask.material, ask.sizes, heat)
    blades = BEAMS if blades is None else blades
    known, key = _KNOWN.setdefault(joint, {}), (blades.name, travel, ask.near is not None)
    if key not in known:
        layout = joint.layout
        held: list[float | None] = [None] * 6
        if ask.geometry.is_guided:
            # the frame's third axis is z
            held[5] = 0.0
        held[3 if layout.drive.turns else 0] = travel
        motion, frames = {layout.drive.body: held}, drive_frame(layout.drive)
        if ask.near is None:
            known[key] = solve(
                layout,
                motion,
                frames=frames,
                tolerance=blades.tolerance,
                levels=blades.levels,
                made=blades.made,
            ).checked()
        else:
            about = at_travel(ask.near._replace(scene=ask.scene), travel, blades, warm=warm)
            known[key] = beside(about, layout, motion, frames=frames, made=blades.made)
    if ask.near is None and known[key].unstable:
        held_by = "by its temperature" if travel is None else "at its stroke with the drive locked"
        raise NotAvailable(f"buckles {held_by}")
    return known[key]


def forget() -> None:
    """Forget all equilibria, so that the next take their time."""
    _KNOWN.clear()


def driven_coordinate(layout: SpaceLayout) -> int:
    """Return the coordinate of the layout's bodies that the drive moves."""
    return 6 * layout.index(layout.drive.body) + (3 if layout.drive.turns else 0)


def support_at_stroke(
    ask: Ask,
    index: int,
    point: tuple[float, float, float],
    *,
    locked: bool,
    blades: Blades | None = None,
) -> tuple[tuple[float, ErrorRange | None], ...]:
    """Return the support stiffness at both ends of a case's stroke, as a joint model does.

    Raises
    ------
    NotAvailable
        When what is asked for is held, or the joint cannot be solved in space.

    """
    scene, blades = ask.scene, BEAMS if blades is None else blades
    found = []
    for travel in dict.fromkeys((scene.middle + scene.travel, scene.middle - scene.travel)):
        state = at_travel(ask, travel, blades)
        value = _stiffness(ask, state, index, point, locked=locked)
        known, error = blades.errors(state), None
        if state.coarser is not None and known is not None:
            before = _stiffness(ask, state.coarser, index, point, locked=locked)
            change = abs(before / value - 1.0) + known.support
            error = ErrorRange(-change, change)
        found.append((value, error))
    return tuple(found)


def _of_beams(state: SpaceEquilibrium) -> StrokeErrors | None:
    if not is_compared(state):
        return None
    return StrokeErrors(BEAM_ERROR, SHIFT_ERROR, STRESS_ERROR, BUCKLING_ERROR)


BEAMS = Blades("exact", beams_of, LEVELS, TOLERANCE, _of_beams, ((12, 18, 27, 40), 1e-3))
"""Exact beams: their critical loads are far more accurate than beams are."""


def along_cases(ask: Ask) -> Floats:
    """Return the matrix that takes motions along the layout's axes to those of cases (6, 6)."""
    return motion_along(axes_about_z(ask.geometry.axes))


def compliance_along_cases(
    ask: Ask, state: SpaceEquilibrium, point: tuple[float, float, float], *, locked: bool
) -> Floats:
    """Return the 6×6 compliance of a point of the moving body along the axes of cases."""
    layout = state.layout
    body = layout.body(layout.drive.body)
    axes = axes_about_z(ask.geometry.axes)
    x, y, z = (float(c) for c in body.point + axes.T @ np.array(point))
    free = () if locked else (driven_coordinate(layout),)
    turned = along_cases(ask)
    return turned @ support_compliance(state, body.name, (x, y, z), free=free) @ turned.T


def is_compared(state: SpaceEquilibrium) -> bool:
    """Return whether blades and motion are among those whose error is known."""
    found = _proportions(state)
    return found is not None and all(wide <= WIDEST and thick <= THICKEST for wide, thick in found)


def strain_error(state: SpaceEquilibrium) -> float | None:
    """Return by what share of itself what thermal forces change of a stiffness may be off.

    Thicker blades and rods shear as they bend. Nothing where nobody compared.
    """
    found = _proportions(state)
    if found is None or any(wide > WIDE or thick > THICK + 1e-9 for wide, thick in found):
        return None
    return BEAM_ERROR + EULER_SHEAR * max(thick for _, thick in found) ** 2


def _proportions(state: SpaceEquilibrium) -> list[tuple[float, float]] | None:
    """Return b/l (of rods nothing) and h/l of blades of even thickness that moved no further."""
    found = []
    for blade in state.layout.blades:
        l = float(np.linalg.norm(np.subtract(blade.end, blade.start)))
        if isinstance(blade, SpaceRod):
            wide, thick = 0.0, blade.d
        elif isinstance(blade.profile, Constant):
            wide, thick = blade.b, float(blade.profile.h)
        else:
            return None
        apart = _shift(state, blade.second, blade.end) - _shift(state, blade.first, blade.start)
        if np.linalg.norm(apart) > LONGEST * (1.0 + ROUNDING) * l:
            return None
        found.append((wide / l, thick / l))
    return found


def _shift(state: SpaceEquilibrium, body: str, point: Vector) -> Floats:
    """Return how far a point moved; those of the ground do not."""
    if body not in {each.name for each in state.layout.bodies}:
        return np.zeros(3)
    return state.motion_of(body, point)[:3]


def _stiffness(
    ask: Ask,
    state: SpaceEquilibrium,
    index: int,
    point: tuple[float, float, float],
    *,
    locked: bool,
) -> float:
    C = compliance_along_cases(ask, state, point, locked=locked)
    block = slice(0, 3) if index < 3 else slice(3, 6)
    if C[index, index] <= 1e-14 * np.trace(np.abs(C)[block, block]):
        raise NotAvailable("is held by its guide or drive in the direction that is asked for")
    return float(1.0 / C[index, index])
