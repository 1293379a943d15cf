"""The thickness of a blade as a spec draws it; its least thickness may be left to sizing."""

from abc import abstractmethod
from functools import partial
from itertools import pairwise
from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from pydantic import Field, model_validator

from flexcli.formulas import fillet, notch
from flexcli.formulas import profile as shapes
from flexcli.formulas.notch_compliance import planar_compliance
from flexcli.formulas.quantity import Computed, Numbers, Quantity
from flexcli.numerics.rows import number, one_by_one, smaller
from flexcli.parts.base import Part, PositiveLength, QuantityOf, spec_error
from flexcli.parts.bending.base import Thick
from flexcli.parts.bending.thick import thick_notch
from flexcli.parts.geometries.base import Extent

__all__ = ["AnyProfile", "BladeProfile", "ConstantProfile", "FilletedProfile"]

Fraction = Annotated[float, QuantityOf("ratio", at_least=0.0)]


class BladeProfile(Part):
    """A thickness profile; its ``symbol`` names the thickness that is a size."""

    symbol: ClassVar[str] = "h"

    @property
    def extent(self) -> Extent | None:
        """Return the thickness that may be chosen, None where the profile fixes it."""
        found: Extent = getattr(self, self.symbol)
        return found

    @abstractmethod
    def shape(self, size: Any) -> shapes.Profile:
        """Return the thickness along the blade for a value of its size [m]."""

    def thinnest(self, size: Quantity) -> Computed:
        """Return the least thickness [m]."""
        return size

    def radius(self, l: float) -> float:
        """Return the radius where the shape meets a body, or of its throat; 0 if sharp [m]."""
        return 0.0

    def straight(self, l: float) -> float | None:
        """Return over what length it is as thick, None where more than fillets vary [m]."""
        return None

    def peaks(self, size: Any, l: float) -> tuple[Computed, Computed]:
        """Return the stress concentration factors of the shape in bending and along the blade."""
        return 1.0, 1.0

    def peaks_above(self, size: Any, l: float, clamped: bool) -> tuple[Computed, Computed]:
        """Return by what share peaks of stress may be less than those say, bent and along [-]."""
        return 0.0, 0.0

    def thick(self, size: Numbers, l: float) -> Thick | None:
        """Return its change by plane elasticity, where it is a notch."""
        return None

    def turn(self, size: Numbers, l: float) -> float:
        """Return the rotational stiffness of a length at E b = 1, as a beam [m²]."""
        C = planar_compliance(self.shape(number(size)), E=1.0, l=l, b=1.0, a=l / 2.0)
        return 1.0 / number(C[..., 2, 2])

    def misfit(self, l: float) -> str:
        """Return why the profile does not fit on a length [m], empty where it does."""
        return ""


class ConstantProfile(BladeProfile):
    """The same thickness h everywhere."""

    kind: Literal["constant"]
    h: Extent
    """Thickness, in the direction in which the blade bends, e.g. ``0.2 mm``."""

    def shape(self, size: Any) -> shapes.Profile:
        """Return h."""
        return shapes.Constant(size)

    def straight(self, l: float) -> float:
        """Return all of it."""
        return l


class NeckedDownProfile(BladeProfile):
    """Hinges of thickness h and length l_c at both ends of a rigid middle."""

    kind: Literal["necked-down"]
    h: Extent
    """Thickness of the hinges at both ends, e.g. ``0.1 mm``."""
    l_c: PositiveLength
    """Length of a hinge, e.g. ``5 mm``."""

    def shape(self, size: Any) -> shapes.Profile:
        """Return the two hinges."""
        return shapes.NeckedDown(size, self.l_c)

    def misfit(self, l: float) -> str:
        """Return that two hinges are longer than the blade."""
        return "two hinges are longer than the blade" if 2.0 * self.l_c > l else ""


class NotchProfile(BladeProfile):
    """Two opposite half-ellipses as long as the blade leave a throat of thickness e."""

    symbol: ClassVar[str] = "e"

    kind: Literal["notch"]
    e: Extent
    """Thickness of the throat, e.g. ``0.1 mm``."""
    depth: PositiveLength
    """Depth of the notches; half the blade's length for circular ones, e.g. ``2 mm``."""

    def shape(self, size: Any) -> shapes.Profile:
        """Return the two half-ellipses."""
        return shapes.Notch(size, self.depth)

    def radius(self, l: float) -> float:
        """Return that of its throat, (l/2)²/depth."""
        return l**2 / (4.0 * self.depth)

    def peaks(self, size: Any, l: float) -> tuple[Computed, Computed]:
        """Return those of a deep notch."""
        at = {"e": size, "r": self.radius(l)}
        return notch.bending_factor(**at), notch.axial_factor(**at)

    def thick(self, size: Numbers, l: float) -> Thick:
        """Return the factor of the throat."""
        return thick_notch(e=size, depth=self.depth, l=l, turn=self.turn(size, l))


class FilletedProfile(BladeProfile):
    """Thickness h between quarter circles of radius r at both roots."""

    kind: Literal["filleted"]
    h: Extent
    """Thickness, in the direction in which the blade bends, e.g. ``0.2 mm``."""
    r: PositiveLength
    """Radius of the fillets at both ends, e.g. ``0.5 mm``."""

    def shape(self, size: Any) -> shapes.Profile:
        """Return the blade with its fillets."""
        return shapes.Filleted(size, self.r)

    def radius(self, l: float) -> float:
        """Return that of its fillets."""
        return self.r

    def straight(self, l: float) -> float:
        """Return the length between its fillets."""
        return l - 2.0 * self.r

    def peaks(self, size: Any, l: float) -> tuple[Computed, Computed]:
        """Return those of its fillets."""
        at = {"h": size, "l": l, "r": self.r}
        return fillet.bending_factor(**at), fillet.axial_factor(**at)

    def peaks_above(self, size: Any, l: float, clamped: bool) -> tuple[Computed, Computed]:
        """Return what those of its fillets may be less."""
        above = partial(fillet.factors_above, clamped=clamped)
        bent, along = one_by_one(above, size, l, self.r)
        return bent, along

    def misfit(self, l: float) -> str:
        """Return that two fillets are longer than the blade."""
        return "two fillets are longer than the blade" if 2.0 * self.r > l else ""


class TabulatedProfile(BladeProfile):
    """Thicknesses h at fractions of the length, straight lines between them."""

    kind: Literal["tabulated"]
    at: tuple[Fraction, ...]
    """Fractions of the length, from 0 at the blade's start to 1 at its end,
    e.g. ``at: [0, 0.5, 1], h: [0.3 mm, 0.2 mm, 0.3 mm]``.
    """
    h: tuple[PositiveLength, ...]
    """Thickness at each of the fractions, e.g. ``h: [0.3 mm, 0.2 mm, 0.3 mm], at: [0, 0.5, 1]``."""

    @model_validator(mode="after")
    def _is_a_table(self) -> "TabulatedProfile":
        if len(self.at) < 2 or self.at[0] != 0.0 or self.at[-1] != 1.0:
            raise spec_error(
                "a table of thicknesses runs from 0 to 1", "e.g. at: [0, 0.5, 1]", at=("at",)
            )
        if any(one >= other for one, other in pairwise(self.at)):
            raise spec_error("these fractions do not rise", "put them in order", at=("at",))
        if len(self.h) != len(self.at):
            raise spec_error(
                f"{len(self.h)} thicknesses stand at {len(self.at)} places",
                "give one for each",
                at=("h",),
            )
        return self

    @property
    def extent(self) -> None:
        """Return None: the table fixes the thickness."""
        return

    def shape(self, size: Any) -> shapes.Profile:
        """Return the table."""
        return shapes.Tabulated(self.at, self.h)

    def thinnest(self, size: Quantity) -> Computed:
        """Return the least thickness of the table [m]."""
        return smaller(self.h)


AnyProfile: TypeAlias = Annotated[
    ConstantProfile | NeckedDownProfile | NotchProfile | FilletedProfile | TabulatedProfile,
    Field(discriminator="kind"),
]
