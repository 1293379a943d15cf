"""The acceleration spectral density of a vibration environment, and how a case uses it."""

from abc import ABC, abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Annotated, Any, Literal, TypeAlias

import numpy as np
from numpy.typing import NDArray
from pydantic import (
    Field,
    GetJsonSchemaHandler,
    ValidationError,
    field_validator,
    model_validator,
)
from pydantic_core import CoreSchema, InitErrorDetails, PydanticCustomError

from flexcli.formulas.decibels import levels_from_slopes, scale_level
from flexcli.formulas.miles import MilesWorstCase, miles_worst_case
from flexcli.formulas.spectrum import Scale
from flexcli.formulas.spectrum_integrals import rms
from flexcli.parts.base import (
    Acceleration,
    AccelerationDensity,
    Duration,
    Frequency,
    OrTable,
    Part,
    QuantityOf,
    Ratio,
    said,
    spec_error,
)
from flexcli.parts.quality import Quality
from flexcli.units import LARGEST, SMALLEST, show

__all__ = [
    "AXES",
    "ASDProfile",
    "AppliedASD",
    "Axis",
    "Breakpoint",
    "Gain",
    "ItemMass",
    "Margin",
    "MassScaling",
    "RandomVibration",
    "Segment",
    "Start",
    "Tolerance",
    "Vibration",
    "refuse_mass",
]

Floats = NDArray[np.float64]

Axis: TypeAlias = Literal["x", "y", "z"]

AXES: tuple[Axis, ...] = ("x", "y", "z")

Gain = Annotated[float, QuantityOf("decibel", above=-100.0, below=100.0)]
Margin = Annotated[float, QuantityOf("decibel", at_least=0.0, below=100.0)]
Slope = Annotated[float, QuantityOf("slope", above=-1000.0, below=1000.0)]
ItemMass = Annotated[float, QuantityOf("mass", above=0.0)]


def _refuse(title: str, faults: list[PydanticCustomError]) -> None:
    """Raise all faults of a part at once, if there are any."""
    if faults:
        details = [InitErrorDetails(type=fault, loc=(), input=None) for fault in faults]
        raise ValidationError.from_exception_data(title, details)


class Breakpoint(Part):
    """One corner of a profile; ``step`` says that the level jumps here from the point before."""

    frequency: Frequency
    """Frequency of the corner, e.g. ``20 Hz``."""
    level: AccelerationDensity
    """Acceleration spectral density at the corner, e.g. ``0.02 g^2/Hz``."""
    step: bool = False
    """Whether the level jumps here: the point before has the same frequency, e.g. ``false``."""

    @field_validator("step", mode="before")
    @classmethod
    def _true_or_false(cls, value: Any) -> Any:
        if not isinstance(value, bool):
            raise spec_error(f"{said(value)} is neither true nor false", "write step: true")
        return value


class Start(Part):
    """The lower end of a profile given by segments; its level may follow from a plateau's."""

    frequency: Frequency
    """Lowest frequency of the profile, e.g. ``20 Hz``."""
    level: AccelerationDensity | None = None
    """Level there; left out, it follows from the plateau of a segment, e.g. ``0.02 g^2/Hz``."""


class Segment(Part):
    """A straight line on log-log axes: a slope in dB per octave, or a plateau by its level."""

    to: Frequency
    """Frequency where the segment ends, e.g. ``to: 50 Hz, slope: 6 dB/oct``."""
    slope: Slope | None = None
    """Slope of the level; a plateau has a level instead, e.g. ``slope: 6 dB/oct, to: 50 Hz``."""
    level: AccelerationDensity | None = None
    """Level of a plateau; a slope has none, e.g. ``level: 0.16 g^2/Hz, to: 800 Hz``."""

    @model_validator(mode="after")
    def _slope_or_plateau(self) -> "Segment":
        if (self.slope is None) == (self.level is None):
            raise spec_error(
                "a segment has a slope, or the level of a plateau",
                "write {to: 50 Hz, slope: 6 dB/oct} or {to: 800 Hz, level: 0.16 g^2/Hz}",
            )
        return self


class Tolerance(Part):
    """How far the level of a test may be off, by its standard."""

    above: Margin
    """How far above the profile a test may be, e.g. ``3 dB``."""
    below: Margin
    """How far below the profile a test may be, e.g. ``1.5 dB``."""


class MassScaling(Part):
    """How the whole level falls for items heavier than a reference: level ∝ reference/mass.

    Beyond ``uniform_to`` the standard changes the shape too.
    """

    reference: ItemMass
    """Mass of an item up to which the level is the full one, e.g. ``22.7 kg``."""
    uniform_to: ItemMass
    """Mass up to which the whole level falls with it; beyond, the shape changes, e.g. ``59 kg``."""

    @model_validator(mode="after")
    def _in_order(self) -> "MassScaling":
        if self.uniform_to <= self.reference:
            raise spec_error(
                "the scaling must reach beyond its reference mass",
                "give a mass above the reference",
                at=("uniform_to",),
            )
        return self

    def factor(self, mass: float) -> float:
        """Return the factor on the level for an item of this mass [kg]."""
        return min(1.0, self.reference / mass)


class ASDProfile(Part):
    """An acceleration spectral density: its breakpoints, or where it starts and its segments."""

    name: str = ""
    """Name of the profile as reports print it, e.g. ``GEVS qualification``."""
    standard: str = ""
    """Document that the profile is from, e.g. ``GSFC-STD-7000``."""
    revision: str = ""
    """Revision of the document, e.g. ``B``."""
    location: str = ""
    """Page or table in the document, e.g. ``table 2.4-3``."""
    status: Literal["verified", "unverified", "reconstructed", "given"] = "given"
    """How far the numbers were checked against the document, e.g. ``verified``."""
    note: str = ""
    """Anything a reader should know of the numbers, e.g. ``read off a chart``."""
    points: Annotated[tuple[Breakpoint, ...], OrTable()] | None = None
    """Corners of the profile by rising frequency, or a table of them, ``psd.csv`` or ``{file:
    psd.csv, units: [Hz, g^2/Hz], column: 2}``; or give start and segments,
    e.g. ``[{frequency: 20 Hz, level: 0.02 g^2/Hz}, {frequency: 2 kHz, level: 0.02 g^2/Hz}]``.
    """
    start: Start | None = None
    """Lower end of a profile that is given by segments,
    e.g. ``start: {frequency: 20 Hz, level: 0.02 g^2/Hz}, segments: [{to: 2 kHz, slope: 0
    dB/oct}]``.
    """
    segments: tuple[Segment, ...] | None = Field(None, json_schema_extra={"minItems": 1})
    """Straight lines from the start, each a slope or a plateau,
    e.g. ``segments: [{to: 50 Hz, slope: 6 dB/oct}, {to: 800 Hz, level: 0.16 g^2/Hz}], start:
    {frequency: 20 Hz}``.
    """
    interpolation: Literal["log-log", "linear"] = "log-log"
    """Axes on which the profile is straight between its corners, e.g. ``log-log``."""
    duration: Duration | None = None
    """Time that the vibration lasts, e.g. ``2 min``."""
    axis: str = ""
    """Axes of the standard that the profile is for, in its own words, e.g. ``all``."""
    tolerance: Tolerance | None = None
    """How far the level of a test may be off, by the standard,
    e.g. ``{above: 3 dB, below: 1.5 dB}``.
    """
    published_grms: Acceleration | None = None
    """Root mean square that the document prints, to check the numbers by, e.g. ``14.1 g``."""
    mass_scaling: MassScaling | None = None
    """How the level falls for heavier items, e.g. ``{reference: 22.7 kg, uniform_to: 182 kg}``."""

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        return {**whole, "anyOf": [{"required": ["points"]}, {"required": ["start", "segments"]}]}

    @model_validator(mode="after")
    def _is_one_profile(self) -> "ASDProfile":
        by_segments = self.start is not None or self.segments is not None
        if (self.points is None) != by_segments:
            text = "stands beside start and segments" if by_segments else "is missing"
            raise spec_error(
                f"'points' {text}",
                "give points, or start and segments",
                at=("points",) if by_segments else (),
            )
        faults = self._faults_of_segments() if by_segments else self._faults_of_points()
        _refuse("profile", list(faults))
        return self

    def _faults_of_points(self) -> Iterator[PydanticCustomError]:
        points = self.points or ()
        if len(points) < 2:
            yield spec_error(
                "a profile needs two points or more",
                "add the other end of the band",
                at=("points",),
            )
        elif len({point.frequency for point in points}) == 1:
            yield spec_error("the band has no width", "add a second frequency", at=("points",))
        else:
            yield from _faults_of_order(points)

    def _faults_of_segments(self) -> Iterator[PydanticCustomError]:
        if self.start is None:
            yield spec_error("'start' is missing", "add 'start: {frequency: 20 Hz}'")
            return
        if not self.segments:
            yield spec_error(
                "a profile needs a segment or more",
                "add e.g. 'segments: [{to: 50 Hz, slope: 6 dB/oct}]'",
                at=("start",) if self.segments is None else ("segments",),
            )
            return
        if self.interpolation == "linear":
            yield spec_error(
                "segments are straight on log-log axes", "give points", at=("interpolation",)
            )
        edges = [self.start.frequency, *(segment.to for segment in self.segments)]
        falling = [i for i, (low, high) in enumerate(pairwise(edges)) if high <= low]
        for index in falling:
            yield spec_error(
                "frequencies must rise", "put the segments in order", at=("segments", index, "to")
            )
        known = self._known_levels()
        if not known:
            yield spec_error(
                "no level is given", "give start its level, or a segment", at=("start",)
            )
        for place, _, _ in known[1:]:
            yield spec_error(
                "a second level", "give one level; the slopes give the others", at=place
            )
        if known and not falling:
            sound = np.isfinite(self.levels) & (self.levels > SMALLEST) & (self.levels < LARGEST)
            for edge in np.flatnonzero(~sound)[:1]:
                yield spec_error(
                    "the slopes lead beyond any physical level",
                    "write slopes in dB per octave, e.g. 6 dB/oct",
                    at=("segments", max(int(edge) - 1, 0), "slope"),
                )

    def _known_levels(self) -> list[tuple[tuple[str | int, ...], int, float]]:
        """Return the levels given among the segments: path in the spec, edge, level."""
        found: list[tuple[tuple[str | int, ...], int, float]] = []
        if self.start is not None and self.start.level is not None:
            found.append((("start", "level"), 0, self.start.level))
        for index, segment in enumerate(self.segments or ()):
            if segment.level is not None:
                found.append((("segments", index, "level"), index, segment.level))
        return found

    @property
    def frequencies(self) -> Floats:
        """Return the frequencies of the breakpoints [Hz]."""
        if self.points is not None:
            return np.array([point.frequency for point in self.points])
        assert self.start is not None
        return np.array([self.start.frequency, *(s.to for s in self.segments or ())])

    @property
    def levels(self) -> Floats:
        """Return the levels of the breakpoints [(m/s²)²/Hz]."""
        if self.points is not None:
            return np.array([point.level for point in self.points])
        _, edge, level = self._known_levels()[0]
        slopes = [segment.slope or 0.0 for segment in self.segments or ()]
        with np.errstate(over="ignore"):  # a level beyond floats is a finding
            return levels_from_slopes(self.frequencies, slopes, known_index=edge, known_level=level)

    @property
    def scale(self) -> Scale:
        """Return the axes in which the profile is straight."""
        return "linear" if self.interpolation == "linear" else "log"

    @property
    def grms(self) -> float:
        """Return the root mean square of the acceleration [m/s²]."""
        return rms(self.frequencies, self.levels, scale=self.scale)


def _faults_of_order(points: tuple[Breakpoint, ...]) -> Iterator[PydanticCustomError]:
    """Yield what is wrong with the order of points: each rises, or is a step and says so."""
    if points[0].step:
        yield spec_error("a step needs a point before it", "remove step", at=("points", 0, "step"))
    for index, (first, second) in enumerate(pairwise(points), start=1):
        at = ("points", index, "frequency")
        if second.frequency < first.frequency:
            yield spec_error("frequencies must rise", "put the points in order", at=at)
        elif second.frequency > first.frequency:
            if second.step:
                yield spec_error(
                    "a step keeps the frequency of the point before",
                    f"write frequency: {first.frequency:g} Hz, or remove step",
                    at=("points", index, "step"),
                )
        elif index > 1 and points[index - 2].frequency == first.frequency:
            yield spec_error("three points share this frequency", "a step has two", at=at)
        elif second.level == first.level:
            yield spec_error("this point stands twice", "remove one of them", at=at)
        elif not second.step:
            yield spec_error(
                f"{second.frequency:g} Hz stands twice",
                "if the level jumps here, add 'step: true' to this point; if not, remove one",
                at=at,
            )
        elif index in (1, len(points) - 1):
            outer = "the point before" if index == 1 else "this point"
            yield spec_error("a step at an end of the band has no width", f"remove {outer}", at=at)


@dataclass(frozen=True, eq=False)
class AppliedASD:
    """The density that a case designs for: frequency [Hz], level [(m/s²)²/Hz], duration [s].

    ``text`` says what was applied to the profile.
    """

    frequency: Floats
    level: Floats
    scale: Scale
    duration: float | None
    text: str

    def worst_case(self, q: float) -> MilesWorstCase:
        """Return Miles' largest rms response of an oscillator of any frequency."""
        return miles_worst_case(self.frequency, self.level, q, scale=self.scale)


def refuse_mass(profile: ASDProfile, mass: float | None) -> None:
    """Raise what is wrong with the mass of an item, by the profile's scaling."""
    if mass is None:
        return
    scaling = profile.mass_scaling
    if scaling is None:
        raise spec_error(
            "this profile has no scaling with mass",
            "remove it, or give the profile its mass_scaling",
            at=("mass",),
        )
    if mass > scaling.uniform_to:
        raise spec_error(
            f"beyond {show(scaling.uniform_to, 'kg')} this standard changes the shape too",
            "write the standard's points for this mass as a profile, without mass here",
            at=("mass",),
        )


class Vibration(ABC):
    """A random vibration of the base along one axis, or along several independent of each other."""

    q: Quality
    sigma: float

    @abstractmethod
    def by_axis(self) -> dict[Axis, AppliedASD]:
        """Return the density that is designed for along each axis that is shaken."""

    @abstractmethod
    def alone(self, axis: Axis) -> "RandomVibration":
        """Return what it does along one of its axes."""

    @property
    def axes(self) -> tuple[Axis, ...]:
        """Return the axes that are shaken."""
        return tuple(self.by_axis())

    @property
    def lasts(self) -> float | None:
        """Return how long it lasts [s], along several axes the longest of them."""
        each = [applied.duration for applied in self.by_axis().values()]
        known = [duration for duration in each if duration is not None]
        return max(known) if len(known) == len(each) else None

    @property
    def band(self) -> tuple[float, float]:
        """Return the lowest and the highest frequency of all axes [Hz]."""
        each = [applied.frequency for applied in self.by_axis().values()]
        return min(float(f[0]) for f in each), max(float(f[-1]) for f in each)


class RandomVibration(Part, Vibration):
    """A profile as a case uses it, the quality factor of the response, and the sigma of design.

    ``scale`` and ``tolerance`` raise the level (the upper edge is designed for), ``mass`` lowers
    it as the profile's standard does.
    """

    profile: ASDProfile
    """The profile: inline, the name of a shipped one, or a path, e.g. ``gevs-qualification``."""
    q: Quality
    """Quality factor Q of the response, or of its modes by their number, the others' beside; left
    out, that of the case, e.g. ``100``.
    """
    sigma: Ratio = 3.0
    """Peak that is designed for, in root mean squares, e.g. ``3``."""
    scale: Gain = 0.0
    """Raises the whole level, e.g. ``-3 dB``."""
    tolerance: Margin = 0.0
    """Raises the level to the upper edge of the test's tolerance, e.g. ``3 dB``."""
    mass: ItemMass | None = None
    """Mass of the item, where the profile scales with it,
    e.g. ``mass: 45 kg, profile: gevs-qualification, q: 100``.
    """
    duration: Duration | None = None
    """Time it lasts, in place of the profile's, e.g. ``60 s``."""
    axis: Literal["x", "y", "z", "x and y", "x and z", "y and z", "x, y and z"] = "x"
    """Axes along which the base is shaken, of several independently at once; x is that of the
    stroke, or of a pivot's symmetry, z that of the blades' width,
    e.g. ``x and y``.
    """

    @classmethod
    def __get_pydantic_json_schema__(
        cls, schema: CoreSchema, handler: GetJsonSchemaHandler
    ) -> dict[str, Any]:
        whole = handler.resolve_ref_schema(handler(schema))
        points = {
            "anyOf": [OrTable.schema()],
            "description": "A table of the points of a profile, in its place",
            "examples": ["psd.csv"],
            "beside": {"q": 100},  # not the profile of the example around it
        }
        whole["properties"] = {**whole["properties"], "points": points}
        whole["required"] = [key for key in whole["required"] if key not in ("profile", "q")]
        either = [{"required": ["profile"]}, {"required": ["points"]}]
        return {**whole, "oneOf": either}

    @model_validator(mode="before")
    @classmethod
    def _say_what_is_needed(cls, data: Any) -> Any:
        if not isinstance(data, dict):
            raise spec_error(
                "a vibration case needs its profile and Q", "write {profile: my.yaml, q: 100}"
            )
        if "points" not in data:
            return data
        if "profile" in data:
            raise spec_error("'points' stands beside profile", "keep one of them", at=("points",))
        rest = {key: value for key, value in data.items() if key != "points"}
        return {"profile": {"points": data["points"]}, **rest}

    @model_validator(mode="after")
    def _mass_can_be_applied(self) -> "RandomVibration":
        refuse_mass(self.profile, self.mass)
        return self

    def by_axis(self) -> dict[Axis, AppliedASD]:
        """Return the one density along each axis that is shaken."""
        return dict.fromkeys((axis for axis in AXES if axis in self.axis), self.applied())

    def alone(self, axis: Axis) -> "RandomVibration":
        """Return the same along one axis."""
        return self.model_copy(update={"axis": axis})

    def applied(self) -> AppliedASD:
        """Return the density that is designed for, with all that the case applies to it."""
        profile = self.profile
        level = scale_level(profile.levels, self.scale + self.tolerance)
        applied = [f"{self.scale:+g} dB"] if self.scale else []
        if self.tolerance:
            applied.append(f"{self.tolerance:+g} dB for the tolerance of the test")
        if self.mass is not None and profile.mass_scaling is not None:
            factor = profile.mass_scaling.factor(self.mass)
            level = level * factor
            applied.append(f"level × {factor:.4g} for {show(self.mass, 'kg')}")
        return AppliedASD(
            frequency=profile.frequencies,
            level=level,
            scale=profile.scale,
            duration=profile.duration if self.duration is None else self.duration,
            text=", ".join(applied) or "as given",
        )
