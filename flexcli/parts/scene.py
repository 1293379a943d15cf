"""What one case asks of each joint: travel, force, what holds the blades' ends."""

from collections.abc import Mapping
from dataclasses import dataclass, field

from flexcli.results import Note, Value

__all__ = ["Scene"]


@dataclass(frozen=True)
class Scene:
    """One case in the joint's own terms.

    ``travel`` and ``mean_travel`` are rotations [rad] or translations [m] of the joint; ``force``
    is the largest force on a joint in its plane [N], ``axial_share`` the largest axial force in a
    blade per unit of it.
    """

    case: str
    travel: float = 0.0
    mean_travel: float = 0.0
    cycles: float | None = None
    force: float = 0.0
    force_name: str = ""
    axial_share: float = 0.0
    ends: str | None = None
    ends_why: str = ""
    acceleration: float = 0.0
    axis: str = ""
    values: Mapping[str, Value] = field(default_factory=dict)
    notes: tuple[Note, ...] = ()

    @property
    def blade_force(self) -> float:
        """Return the largest axial force in a blade [N]."""
        return self.force * self.axial_share
