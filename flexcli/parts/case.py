"""A case: one thing the flexure lives through, with its loads and what is locked."""

from typing import Annotated, Literal

from pydantic import PrivateAttr, model_validator

from flexcli.parts.asd import RandomVibration
from flexcli.parts.base import Acceleration, Angle, Force, Part, QuantityOf, spec_error
from flexcli.parts.ends import EndCondition
from flexcli.parts.excitation import Sine, Sweep
from flexcli.parts.shock import Shock
from flexcli.parts.stroke import Stroke

__all__ = ["Case", "EndCondition", "Load", "SteadyAcceleration"]


class Load(Part):
    """A force on each joint in its plane, at an angle from its axis of symmetry.

    That axis is the bisector of a pivot, the blades of a stage, and x of a drawn layout; along it
    (0 deg) the force pulls the body away from the base. Where no direction is stated, it acts
    along the axis either way.
    """

    force: Force
    direction: Angle = 0.0

    @property
    def is_directed(self) -> bool:
        """Return whether its sense is stated."""
        return "direction" in self.model_fields_set


class Wrench(Part):
    """Forces and moments on the joint at its centre, in any direction of space.

    x is along the stroke of a stage, or the bisector of a pivot; z along the width of the blades.
    """

    x: Annotated[float, QuantityOf("force")] = 0.0
    y: Annotated[float, QuantityOf("force")] = 0.0
    z: Annotated[float, QuantityOf("force")] = 0.0
    theta_x: Annotated[float, QuantityOf("moment")] = 0.0
    theta_y: Annotated[float, QuantityOf("moment")] = 0.0
    theta_z: Annotated[float, QuantityOf("moment")] = 0.0

    @model_validator(mode="after")
    def _loads_something(self) -> "Wrench":
        if not any(self.components):
            raise spec_error("this wrench is zero", "give it a force or a moment, e.g. z: 3 N")
        return self

    @property
    def components(self) -> tuple[float, ...]:
        """Return (F_x, F_y, F_z, M_x, M_y, M_z) [N, N·m]."""
        return self.x, self.y, self.z, self.theta_x, self.theta_y, self.theta_z


class SteadyAcceleration(Part):
    """Gravity or a quasi-static acceleration along x (stroke, bisector), y (in plane) or z (b)."""

    level: Acceleration
    axis: Literal["x", "y", "z"]


class Case(Part):
    """Loads that act together; margins are per case."""

    stroke: Stroke | None = None
    load: Load | None = None
    wrench: Wrench | None = None
    acceleration: SteadyAcceleration | None = None
    asd: RandomVibration | None = None
    shock: Shock | None = None
    sine: Sine | None = None
    sweep: Sweep | None = None
    lock: str | None = None
    ends: EndCondition | None = None

    _is_at_rest: bool = PrivateAttr(False)

    @classmethod
    def at_rest(cls) -> "Case":
        """Return the case of a design of which nothing is asked but what it is."""
        case = cls.model_construct()
        case._is_at_rest = True
        return case

    @model_validator(mode="after")
    def _asks_something(self) -> "Case":
        loads = (self.stroke, self.load, self.wrench, self.acceleration, self._is_at_rest)
        if not self.vibrates and not any(loads):
            raise spec_error(
                "this case loads nothing",
                "give it a stroke, a load, an acceleration, an asd, a shock, a sine or a sweep",
            )
        return self

    @property
    def vibrates(self) -> bool:
        """Return whether the base is shaken."""
        return any((self.asd, self.shock, self.sine, self.sweep))
