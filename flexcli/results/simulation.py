"""Results of a static sweep of a joint over its stroke."""

from typing import NamedTuple, TypeAlias

__all__ = [
    "Deflection",
    "SpacePoint",
    "SpaceSweep",
    "SupportSweeps",
    "Sweep",
    "SweepPoint",
    "SweepResult",
]


class SweepPoint(NamedTuple):
    """The joint at one travel: what drives it, how stiff it is there, where it went, stresses.

    ``effort`` is the moment or force of the drive, ``stiffness`` its tangent with all else free;
    ``stiffness_x``, ``_y`` and ``_phi`` are those of the body's point in the plane, all else free
    but the drive, which stays held (along the drive it is its own tangent again);
    ``shift`` is the motion (x, y) of the centre or of the stage's own point. ``bending`` is the
    largest bending stress, ``total`` the largest at either face with the axial force, each with
    the blade that has it. ``frequency`` is that of the mechanism's own motion about this
    travel, by the tangent, where a mechanism moves masses. ``stable`` says whether the body
    stands by itself, the drive held.
    """

    travel: float
    effort: float
    stiffness: float
    stiffness_x: float
    stiffness_y: float
    stiffness_phi: float
    shift_x: float
    shift_y: float
    bending: float
    total: float
    blade: str
    energy: float
    frequency: float | None
    stable: bool
    outcome: str
    estimated_error: float


class SpacePoint(NamedTuple):
    """A joint in space at one travel, its drive held there.

    ``effort`` is the force or moment of the drive, ``stiffness`` its tangent with all else free;
    ``shift_x`` … ``turn_z`` are the motion of the moving body's point along the axes of cases and
    its rotation vector. ``k_x`` … ``k_theta_z`` are the support stiffness of that point, the drive
    locked and all else free, infinite along the drive itself. ``frequency`` is the lowest of the
    bodies with the drive locked, blades without mass; ``stress`` the largest of the blades' von
    Mises' stresses, as beams bear it, with the blade that has it. ``error`` is that of the support
    stiffness, where it is known.
    """

    travel: float
    effort: float
    stiffness: float
    shift_x: float
    shift_y: float
    shift_z: float
    turn_x: float
    turn_y: float
    turn_z: float
    k_x: float
    k_y: float
    k_z: float
    k_theta_x: float
    k_theta_y: float
    k_theta_z: float
    frequency: float | None
    stress: float
    blade: str
    error: float | None


class SpaceSweep(NamedTuple):
    """The sweep of one case in space; ``missed`` says which travels were not reached, and why.

    ``drive`` is the axis of cases that the drive moves along or about (``x`` … ``theta_z``), empty
    where it is oblique to them all.
    """

    case: str
    motion: str
    points: tuple[SpacePoint, ...]
    missed: str = ""
    drive: str = ""


class Deflection(NamedTuple):
    """Deflection of one joint of a linkage of rigid links, at every point of a sweep, in a unit."""

    joint: str
    unit: str
    values: tuple[float, ...]


class SweepResult(NamedTuple):
    """The sweep of one case; ``missed`` says which travels were not reached, and why."""

    case: str
    motion: str
    points: tuple[SweepPoint, ...]
    missed: str = ""
    deflections: tuple[Deflection, ...] = ()


Sweep: TypeAlias = SweepResult | SpaceSweep
"""The sweep of a joint in its plane, or in space."""


class SupportSweeps(NamedTuple):
    """What holds a joint over the stroke of every case: in six axes, or in three of its plane.

    ``in_plane`` has the cases that cannot be followed in space; ``notes`` says why.
    """

    in_space: tuple[SpaceSweep, ...]
    in_plane: tuple[SweepResult, ...]
    notes: tuple[str, ...]
