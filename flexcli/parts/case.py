"""A case: one thing the flexure lives through, with its loads and what is locked."""

from math import hypot
from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import GetJsonSchemaHandler, PrivateAttr, ValidationError, model_validator
from pydantic_core import CoreSchema

from flexcli.parts.base import Acceleration, Angle, Force, Part, QuantityOf, Ratio, spec_error
from flexcli.parts.ends import EndCondition
from flexcli.parts.named import Named
from flexcli.parts.stroke import Stroke

if TYPE_CHECKING:
    from flexcli.parts.asd import RandomVibration, Vibration
    from flexcli.parts.axes import Axes
    from flexcli.parts.excitation import Sine, Sweep, Tone
    from flexcli.parts.quality import Quality
    from flexcli.parts.shock import Shock
    from flexcli.parts.temperature import Temperature
else:
    RandomVibration = Annotated[Any, Named("flexcli.parts.asd:RandomVibration")]
    Axes = Annotated[Any, Named("flexcli.parts.axes:Axes")]
    Tone = Annotated[Any, Named("flexcli.parts.excitation:Tone")]
    Sine = Annotated[Any, Named("flexcli.parts.excitation:Sine")]
    Sweep = Annotated[Any, Named("flexcli.parts.excitation:Sweep")]
    Quality = Annotated[Any, Named("flexcli.parts.quality:Quality")]
    Shock = Annotated[Any, Named("flexcli.parts.shock:Shock")]
    Temperature = Annotated[Any, Named("flexcli.parts.temperature:Temperature")]

__all__ = ["Case", "EndCondition", "Load", "SteadyAcceleration", "components_along"]


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


def components_along(axis: str | None, level: float) -> tuple[float, float, float]:
    """Return the components along x, y and z of what acts along one of them."""
    x, y, z = (level if axis == each else 0.0 for each in "xyz")
    return x, y, z


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
    axes: Axes | None = None
    """Random vibration of the base with a profile for each axis, and the case's ``q``,
    e.g. ``axes: {x: {asd: gevs-qualification}, z: {asd: gevs-qualification, scale: -3 dB}},
    q: 50``.
    """
    combine: Literal["at-once", "in-turn"] = "at-once"
    """Whether the axes of a vibration act at once, or one after another as on a shaker,
    e.g. ``combine: in-turn, axes: {x: {asd: gevs-qualification}, z: {asd: gevs-qualification}},
    q: 50``.
    """
    q: Quality | None = None
    """Quality factor Q of the responses that state none of their own, or of modes by their number,
    e.g. ``q: 50, asd: {profile: gevs-qualification}``.
    """
    sigma: Ratio = 3.0
    """Peak that is designed for under ``axes``, in root mean squares,
    e.g. ``sigma: 4, axes: {x: {asd: gevs-qualification}}, q: 50``.
    """
    shock: Shock | None = None
    """A shock of the base, e.g. ``{half-sine: {acceleration: 30 g, duration: 11 ms}}``."""
    sine: Sine | None = None
    """A sine of the base at one frequency, e.g. ``{acceleration: 2 g, frequency: 60 Hz}``."""
    sweep: Sweep | None = None
    """A sine of the base that goes through a range of frequencies,
    e.g. ``{from: 5 Hz, to: 100 Hz, rate: 2 oct/min, acceleration: 1 g}``.
    """
    sines: tuple[Tone, ...] = ()
    """Sines that stand on the random vibration, each somewhere in its band,
    e.g. ``sines: [{acceleration: 3 g, from: 40 Hz, to: 60 Hz}], asd: {profile:
    gevs-qualification, q: 50}``.
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

    @model_validator(mode="before")
    @classmethod
    def _share_q(cls, data: Any) -> Any:
        """Give the vibration and the shock the case's own quality factors where they state none."""
        if not isinstance(data, dict) or data.get("q") is None:
            return data
        asd, shock = data.get("asd"), data.get("shock")
        if isinstance(asd, dict) and "q" not in asd:
            data = {**data, "asd": {**asd, "q": data["q"]}}
        if isinstance(shock, dict) and "q" not in shock:
            data = {**data, "shock": {**shock, **_largest(data["q"])}}
        return data

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
                "give it a stroke, a load, an acceleration, an asd, axes, a shock, a sine, a "
                "sweep, sines or a temperature",
            )
        return self

    @model_validator(mode="after")
    def _vibrates_in_one_way(self) -> "Case":
        if self.axes is not None and self.asd is not None:
            text = "profiles by axis stand beside an asd"
            raise spec_error(text, "write the asd as one of the axes", at=("axes",))
        if self.axes is not None and self.q is None:
            text = "nothing says how the modes are damped"
            raise spec_error(text, "add q: 50 to the case", at=("axes",))
        if "sigma" in self.model_fields_set and self.axes is None:
            raise spec_error("sigma is that of axes", "write it in the asd", at=("sigma",))
        if self.q is not None and not self.vibrates:
            raise spec_error("nothing vibrates that q could damp", "take it out", at=("q",))
        if self.combine == "in-turn" and len(self.shaken_axes) < 2:
            text = "there are no axes to act one after another"
            raise spec_error(text, "give the profiles by axis: axes: {x: …, z: …}", at=("combine",))
        return self

    @property
    def vibrates(self) -> bool:
        """Return whether the base is shaken."""
        return any((self.asd, self.axes, self.shock, self.sine, self.sweep, self.sines))

    @property
    def shaken_axes(self) -> frozenset[str]:
        """Return the axes along which the base moves."""
        random = self.vibration.axes if self.vibration is not None else ()
        others = (self.shock, self.sine, self.sweep, *self.sines)
        return frozenset((*random, *(each.axis for each in others if each is not None)))

    @property
    def vibration(self) -> "Vibration | None":
        """Return the random vibration, of one profile or of one for each axis."""
        if self.axes is None or self.q is None:
            return self.asd
        return self.axes.vibration(self.q, self.sigma)


def _largest(quality: Any) -> dict[str, float]:
    """Return, as key of a shock, the largest of a case's quality factors as a spec has them."""
    from flexcli.parts.quality import Quality

    try:
        return {"q": Quality.model_validate(quality).largest}
    except ValidationError:
        return {}  # which the case's own field tells
