"""A case: one thing the flexure lives through, with its loads and what is locked."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import PrivateAttr, model_validator

from flexcli.parts.base import Acceleration, Angle, Force, Part, QuantityOf, spec_error
from flexcli.parts.ends import EndCondition
from flexcli.parts.named import Named
from flexcli.parts.stroke import Stroke

if TYPE_CHECKING:
    from flexcli.parts.asd import RandomVibration
    from flexcli.parts.excitation import Sine, Sweep
    from flexcli.parts.shock import Shock
    from flexcli.parts.temperature import Temperature
else:
    RandomVibration = Annotated[Any, Named("flexcli.parts.asd:RandomVibration")]
    Sine = Annotated[Any, Named("flexcli.parts.excitation:Sine")]
    Sweep = Annotated[Any, Named("flexcli.parts.excitation:Sweep")]
    Shock = Annotated[Any, Named("flexcli.parts.shock:Shock")]
    Temperature = Annotated[Any, Named("flexcli.parts.temperature:Temperature")]

__all__ = ["Case", "EndCondition", "Load", "SteadyAcceleration"]


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
    """Gravity or a quasi-static acceleration along x (stroke, bisector), y (in plane) or z (b)."""

    level: Acceleration
    """Size of the acceleration, e.g. ``9.81 m/s^2``."""
    axis: Literal["x", "y", "z"]
    """Axis along which it acts: x the stroke or the bisector, y in the plane across it, z along
    the width,
    e.g. ``z``.
    """


class Case(Part):
    """Loads that act together; margins are per case."""

    stroke: Stroke | None = None
    """Travel of the stage or of the joint: inline, the name of a shipped one, or a path,
    e.g. ``{rotation: 1 deg, cycles: 1e6}``.
    """
    load: Load | None = None
    """A force on each joint in its plane, e.g. ``{force: 10 N, direction: 0 deg}``."""
    wrench: Wrench | None = None
    """Forces and moments on the joint at its centre, in any direction of space,
    e.g. ``{z: 3 N}``.
    """
    acceleration: SteadyAcceleration | None = None
    """Gravity or a quasi-static acceleration of the base, e.g. ``{level: 9.81 m/s^2, axis: z}``."""
    asd: RandomVibration | None = None
    """Random vibration of the base, e.g. ``{profile: gevs-qualification, q: 100, sigma: 3}``."""
    shock: Shock | None = None
    """A shock of the base, e.g. ``{half-sine: {acceleration: 30 g, duration: 11 ms}}``."""
    sine: Sine | None = None
    """A sine of the base at one frequency, e.g. ``{acceleration: 2 g, frequency: 60 Hz}``."""
    sweep: Sweep | None = None
    """A sine of the base that goes through a range of frequencies,
    e.g. ``{from: 5 Hz, to: 100 Hz, rate: 2 oct/min, acceleration: 1 g}``.
    """
    temperature: Temperature | None = None
    """A change of temperature from assembly, e.g. ``{uniform: -60 K, bodies: {moving: 5 K}}``."""
    lock: str | None = None
    """Body of the mechanism that is held in this case,
    e.g. ``lock: solid-2, asd: {profile: gevs-qualification, q: 100}``.
    """
    ends: EndCondition | None = None
    """What holds the two ends of a blade, and so which critical load is meant: the base is fixed,
    the body held as named,
    e.g. ``ends: clamped-guided, load: {force: 10 N}``.
    """

    _is_at_rest: bool = PrivateAttr(False)

    @classmethod
    def at_rest(cls) -> "Case":
        """Return the case of a design of which nothing is asked but what it is."""
        case = cls.model_construct()
        case._is_at_rest = True
        return case

    @model_validator(mode="after")
    def _asks_something(self) -> "Case":
        loads = (self.stroke, self.load, self.wrench, self.acceleration, self.temperature)
        if not self._is_at_rest and not self.vibrates and not any(loads):
            raise spec_error(
                "this case loads nothing",
                "give it a stroke, a load, an acceleration, an asd, a shock, a sine, a sweep or a "
                "temperature",
            )
        return self

    @property
    def vibrates(self) -> bool:
        """Return whether the base is shaken."""
        return any((self.asd, self.shock, self.sine, self.sweep))
