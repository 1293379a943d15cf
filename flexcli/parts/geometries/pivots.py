"""What the pivots of equal blades that point at one centre have in common."""

from abc import abstractmethod
from typing import ClassVar

from flexcli.formulas import pivot
from flexcli.formulas.planar_joint import joint_stiffness, stress_rows
from flexcli.formulas.quantity import Quantity
from flexcli.parts.geometries.base import Blade, Geometry, NotAvailable
from flexcli.parts.structure import Spring

__all__ = ["BladePivot"]


class BladePivot(Geometry):
    """A pivot of n equal blades whose centre lines meet in its centre."""

    motion: ClassVar[str] = "rotation"

    @property
    @abstractmethod
    def blade_angles(self) -> tuple[float, ...]:
        """Return the direction of each blade from the axis of symmetry [rad]."""

    @abstractmethod
    def offset(self, blade: Blade) -> Quantity:
        """Return p, from the centre to the inner ends of the blades [m]."""

    @property
    def blade_count(self) -> int:
        """Return the number of blades."""
        return len(self.blade_angles)

    def stiffness(self, E: float, blade: Blade) -> Quantity:
        """Return the rotational stiffness [N·m/rad]."""
        return pivot.rotational_stiffness(
            E=E, h=blade.h, l=blade.l, b=blade.b, p=self.offset(blade), blades=self.blade_count
        )

    def end_stresses(self, E: float, blade: Blade, travel: float) -> dict[str, Quantity]:
        """Return the signed bending stress at the inner and the outer end [Pa]."""
        inner, outer = pivot.end_stresses(
            E=E, h=blade.h, l=blade.l, p=self.offset(blade), theta=travel
        )
        return {"inner end": inner, "outer end": outer}

    def s_bending_share(self, blade: Blade) -> float:
        """Return 3(1 + 2δ)²/(1 + 3(1 + 2δ)²): the rest is uniform bending, free of shear."""
        s_bending = 3.0 * (1.0 + 2.0 * self.offset(blade) / blade.l) ** 2
        return float(s_bending / (1.0 + s_bending))

    def spring(self, E: float, blade: Blade) -> Spring:
        """Return the pivot as a linear spring in its plane."""
        p, angles = float(self.offset(blade)), self.blade_angles
        axial, faces = stress_rows(E=E, h=blade.h, l=blade.l, p=p, angles=angles)
        stiffness = joint_stiffness(E=E, h=blade.h, l=blade.l, b=blade.b, p=p, angles=angles)
        return Spring(stiffness, axial, faces)

    def axial_share(self, direction: float) -> float:
        """Return the largest axial force in a blade per force on the pivot in its plane [-]."""
        try:
            return max(abs(share) for share in pivot.axial_share(self.blade_angles, direction))
        except ValueError as error:
            raise NotAvailable("has blades too parallel to share a force") from error


def crossing_pair(half_angle: float) -> tuple[float, ...]:
    """Return the angles of two blades at ± the half-angle from the bisector [rad]."""
    return (half_angle, -half_angle)
