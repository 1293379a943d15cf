"""What every joint and stage offers: its stiffness, stresses and loads in terms of its blades."""

from abc import abstractmethod
from typing import Any, ClassVar, NamedTuple

from pydantic import AliasPath, Field, model_validator

from flexcli.formulas.quantity import Quantity
from flexcli.formulas.section import blade_volume
from flexcli.parts.base import Part, PositiveLength, spec_error
from flexcli.parts.structure import Spring

__all__ = ["Blade", "Extent", "Geometry", "NotAvailable"]


class NotAvailable(ValueError):
    """A quantity that a geometry has no closed form for."""


class Blade(NamedTuple):
    """Dimensions of the equal blades: floats, arrays of many designs, or signomials [m]."""

    h: Quantity
    l: Quantity
    b: Quantity


class Extent(Part):
    """A dimension of the blade: fixed, free, or free between bounds [m]."""

    is_plain: ClassVar[bool] = True

    fixed: PositiveLength | None = None
    least: PositiveLength | None = Field(None, validation_alias=AliasPath("free", 0))
    most: PositiveLength | None = Field(None, validation_alias=AliasPath("free", 1))

    @model_validator(mode="before")
    @classmethod
    def _read(cls, data: Any) -> Any:
        if data == "free":
            return {}
        if not isinstance(data, dict):
            if isinstance(data, str) and data.strip().isalpha():
                raise spec_error(f"'{data}' is not a length", "write 0.2 mm, or free")
            return {"fixed": data}
        if set(data) != {"free"} or not isinstance(data["free"], list) or len(data["free"]) != 2:
            raise spec_error(
                "a dimension is a length, 'free', or free between bounds",
                "write 0.2 mm, free, or {free: [0.1 mm, 1 mm]} (null where there is no bound)",
            )
        return data

    @model_validator(mode="after")
    def _in_order(self) -> "Extent":
        if self.least is not None and self.most is not None and self.least >= self.most:
            raise spec_error("the lower bound is not below the upper one", "write [least, most]")
        return self


class Geometry(Part):
    """A joint or stage made of equal blades."""

    motion: ClassVar[str]
    source: ClassVar[str]
    sag_bends_width: ClassVar[bool] = False
    """Whether the sag bends the blades across their width."""

    h: Extent
    l: Extent
    b: Extent

    @property
    def extents(self) -> dict[str, Extent]:
        """Return the extents of h, l and b by their symbols."""
        return {"h": self.h, "l": self.l, "b": self.b}

    @property
    def free(self) -> tuple[str, ...]:
        """Return the symbols of the dimensions that sizing may choose."""
        return tuple(name for name, extent in self.extents.items() if extent.fixed is None)

    @property
    @abstractmethod
    def blade_count(self) -> int:
        """Return the number of blades."""

    @property
    def stiffness_unit(self) -> str:
        """Return the SI unit of the stiffness along the motion."""
        return "N*m/rad" if self.motion == "rotation" else "N/m"

    @abstractmethod
    def stiffness(self, E: float, blade: Blade) -> Quantity:
        """Return the stiffness along the motion [N·m/rad or N/m]."""

    @abstractmethod
    def end_stresses(self, E: float, blade: Blade, travel: float) -> dict[str, Quantity]:
        """Return the signed bending stress at each end of a blade [Pa] at a travel [rad or m]."""

    @abstractmethod
    def axial_share(self, direction: float) -> float:
        """Return the largest axial force in a blade per force on the joint in its plane [-].

        ``direction`` [rad] is the angle of the force from the axis of symmetry.
        """

    @abstractmethod
    def s_bending_share(self, blade: Blade) -> float:
        """Return the part of the stiffness that is S-shaped bending, which shear softens [-]."""

    def parasitic_shift(self, blade: Blade, travel: float) -> Quantity:
        """Return the signed parasitic motion at a travel [m]."""
        raise NotAvailable("has no closed form for its parasitic shift")

    def sag_stiffness(self, E: float, blade: Blade, axis: str) -> Quantity:
        """Return the stiffness against the weight of the moving body along an axis [N/m]."""
        raise NotAvailable(f"has no closed form for its stiffness along {axis}")

    def spring(self, E: float, blade: Blade) -> Spring:
        """Return the joint as a linear spring in its plane, for its vibration."""
        raise NotAvailable("has no linear spring in its plane yet")

    def volume(self, blade: Blade) -> Quantity:
        """Return the volume of all blades [m³]."""
        return blade_volume(self.blade_count, blade.h, blade.l, blade.b)
