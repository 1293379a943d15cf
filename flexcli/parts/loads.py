"""The steady loads of a case: a force in the plane, a wrench, an acceleration."""

from math import hypot
from typing import Annotated, Any, Literal

from pydantic import GetJsonSchemaHandler, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.base import Acceleration, Angle, Force, Part, QuantityOf, spec_error
from flexcli.parts.scene import components_along

__all__ = ["Load", "SteadyAcceleration", "Wrench"]


class Load(Part):
    """A force on each joint in its plane, at an angle from its axis of symmetry.

    That axis is the bisector of a pivot, the blades of a stage, and x of a drawn layout; along it
    (0 deg) the force pulls the body away from the base. Where no direction is stated, it acts
    along the axis either way.
    """

    force: Force
    """Size of the force on each joint, e.g. ``10 N``."""
    direction: Angle = 0.0
    """Angle of the force from the axis of symmetry; left out, it acts along that axis either way,
    e.g. ``direction: 90 deg, force: 10 N``.
    """

    @property
    def is_directed(self) -> bool:
        """Return whether its sense is stated."""
        return "direction" in self.model_fields_set


class Wrench(Part):
    """Forces and moments on the joint at its centre, in any direction of space.

    x is along the stroke of a stage, or the bisector of a pivot; z along the width of the blades.
    """

    x: Annotated[float, QuantityOf("force")] = 0.0
    """Force along the stroke of a stage, or a pivot's bisector, e.g. ``5 N``."""
    y: Annotated[float, QuantityOf("force")] = 0.0
    """Force in the plane across x, e.g. ``5 N``."""
    z: Annotated[float, QuantityOf("force")] = 0.0
    """Force along the width of the blades, e.g. ``3 N``."""
    theta_x: Annotated[float, QuantityOf("moment")] = 0.0
    """Moment about x, e.g. ``10 N*mm``."""
    theta_y: Annotated[float, QuantityOf("moment")] = 0.0
    """Moment about y, e.g. ``10 N*mm``."""
    theta_z: Annotated[float, QuantityOf("moment")] = 0.0
    """Moment about z, e.g. ``2 N*mm``."""

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
    """Gravity or a quasi-static acceleration along x (stroke, bisector), y (in plane) or z (b).

    Along one axis by its level, or in any direction by its components; it acts either way.
    """

    level: Acceleration | None = None
    """Size of an acceleration along one axis, e.g. ``level: 9.81 m/s^2, axis: z``."""
    axis: Literal["x", "y", "z"] | None = None
    """Axis along which the level acts: x the stroke or the bisector, y in the plane across it, z
    along the width,
    e.g. ``axis: z, level: 1 g``.
    """
    x: Annotated[float, QuantityOf("acceleration")] = 0.0
    """Component along the stroke of a stage, or a pivot's bisector, e.g. ``x: 6 g, y: 2 g``."""
    y: Annotated[float, QuantityOf("acceleration")] = 0.0
    """Component in the plane across x, e.g. ``y: 6 g, z: -2 g``."""
    z: Annotated[float, QuantityOf("acceleration")] = 0.0
    """Component along the width of the blades, e.g. ``z: 2 g, x: 6 g``."""

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        ways = (("level", "axis"), ("x",), ("y",), ("z",))
        return {**whole, "anyOf": [{"required": list(way)} for way in ways]}

    @model_validator(mode="after")
    def _one_description(self) -> "SteadyAcceleration":
        components = {"x", "y", "z"} & self.model_fields_set
        if not components and self.level is None:
            raise spec_error(
                "nothing says how large the acceleration is",
                "give level: 1 g and axis: z, or components, e.g. {x: 6 g, y: 2 g}",
            )
        if components and (self.level is not None or self.axis is not None):
            at = "level" if self.level is not None else "axis"
            raise spec_error(f"'{at}' stands beside components", "keep one of them", at=(at,))
        if not components and self.axis is None:
            text = "nothing says along which axis the level acts"
            raise spec_error(text, "add axis: z, or give components, e.g. {x: 6 g, y: 2 g}")
        return self

    @property
    def vector(self) -> tuple[float, float, float]:
        """Return its components along x, y and z [m/s²]."""
        if self.level is None:
            return self.x, self.y, self.z
        return components_along(self.axis, self.level)

    @property
    def size(self) -> float:
        """Return its size [m/s²]."""
        return hypot(*self.vector)

    @property
    def only_axis(self) -> str:
        """Return the axis that it acts along, nothing where it is not along one."""
        axes = [each for each, a in zip("xyz", self.vector, strict=True) if a != 0.0]
        return axes[0] if len(axes) == 1 else ""
