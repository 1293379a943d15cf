"""A case: one thing the flexure lives through, with its loads and what is locked."""

from typing import TYPE_CHECKING, Annotated, Any, Literal

from pydantic import PrivateAttr, ValidationError, model_validator

from flexcli.parts.base import Part, Ratio, spec_error
from flexcli.parts.ends import EndCondition
from flexcli.parts.named import Named
from flexcli.parts.stroke import Stroke

if TYPE_CHECKING:
    from flexcli.parts.asd import RandomVibration, Vibration
    from flexcli.parts.axes import Axes
    from flexcli.parts.excitation import Sine, Sweep, Tone
    from flexcli.parts.loads import Load, SteadyAcceleration, Wrench
    from flexcli.parts.quality import Quality
    from flexcli.parts.shock import Shock
    from flexcli.parts.temperature import Temperature
else:
    RandomVibration = Annotated[Any, Named("flexcli.parts.asd:RandomVibration")]
    Axes = Annotated[Any, Named("flexcli.parts.axes:Axes")]
    Tone = Annotated[Any, Named("flexcli.parts.excitation:Tone")]
    Sine = Annotated[Any, Named("flexcli.parts.excitation:Sine")]
    Sweep = Annotated[Any, Named("flexcli.parts.excitation:Sweep")]
    Load = Annotated[Any, Named("flexcli.parts.loads:Load")]
    Wrench = Annotated[Any, Named("flexcli.parts.loads:Wrench")]
    SteadyAcceleration = Annotated[Any, Named("flexcli.parts.loads:SteadyAcceleration")]
    Quality = Annotated[Any, Named("flexcli.parts.quality:Quality")]
    Shock = Annotated[Any, Named("flexcli.parts.shock:Shock")]
    Temperature = Annotated[Any, Named("flexcli.parts.temperature:Temperature")]

__all__ = ["Case", "EndCondition"]


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
        if not (self._is_at_rest or self.vibrates or self._stands):
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

    def quiet(self) -> "Case | None":
        """Return the case without what shakes its base, if anything else loads it."""
        if not self._stands:
            return None
        shaking = ("asd", "axes", "shock", "sine", "sweep", "q")
        return self.model_copy(update={**dict.fromkeys(shaking), "sines": ()})

    @property
    def _stands(self) -> bool:
        """Return whether something loads it that does not shake its base."""
        return any((self.stroke, self.load, self.wrench, self.acceleration, self.temperature))

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
