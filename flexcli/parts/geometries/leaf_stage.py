"""Parallel leaf-spring stage: equal parallel blades that guide a straight motion."""

from typing import Annotated, ClassVar, Literal

from pydantic import Field

from flexcli.formulas import stage
from flexcli.formulas.planar_joint import joint_stiffness, stress_rows
from flexcli.formulas.quantity import Quantity
from flexcli.parts.geometries.base import Blade, Geometry, NotAvailable
from flexcli.parts.structure import Spring

__all__ = ["LeafSpringStage"]


class LeafSpringStage(Geometry):
    """n parallel blades between the base and a stage that moves across them."""

    motion: ClassVar[str] = "translation"
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints"

    kind: Literal["leaf-spring-stage"]
    blades: Annotated[int, Field(strict=True, ge=2, le=1000)] = 2

    @property
    def blade_count(self) -> int:
        """Return the number of blades."""
        return self.blades

    def stiffness(self, E: float, blade: Blade) -> Quantity:
        """Return the stiffness along the stroke [N/m]."""
        return stage.translational_stiffness(
            E=E, h=blade.h, l=blade.l, b=blade.b, blades=self.blades
        )

    def end_stresses(self, E: float, blade: Blade, travel: float) -> dict[str, Quantity]:
        """Return the bending stress, equal and opposite at the two ends [Pa]."""
        return {"both ends": stage.end_stress(E=E, h=blade.h, l=blade.l, x=travel)}

    def s_bending_share(self, blade: Blade) -> float:
        """Return 1: the blades bend in an S alone."""
        return 1.0

    def spring(self, E: float, blade: Blade) -> Spring:
        """Return the stage as a linear spring: its parallel blades keep it from turning."""
        angles = (0.0,) * self.blades
        stiffness = joint_stiffness(E=E, h=blade.h, l=blade.l, b=blade.b, p=0.0, angles=angles)
        axial, faces = stress_rows(E=E, h=blade.h, l=blade.l, p=0.0, angles=angles[:1])
        return Spring(stiffness, axial, faces, holds_rotation=True)

    def axial_share(self, direction: float) -> float:
        """Return the axial force in a blade per force on the stage along the blades [-]."""
        if direction != 0.0:
            raise NotAvailable("takes a load along its blades only (direction: 0 deg)")
        return 1.0 / self.blades

    def parasitic_shift(self, blade: Blade, travel: float) -> Quantity:
        """Return the motion towards the base [m]."""
        return stage.shortening(l=blade.l, x=travel)

    def sag_stiffness(self, E: float, blade: Blade, axis: str) -> Quantity:
        """Return the stiffness along the stroke x [N/m]."""
        if axis != "x":
            raise NotAvailable(f"has no closed form for its sag along {axis}, only along x")
        return self.stiffness(E, blade)
