"""Requirements on the real response of the modes to a vibration or a shock.

They judge a given blade; its modes are no posynomials, so they cannot size one. What computes
modes and lives is imported where it is called: few designs ask, and all would wait for it.
"""

from collections.abc import Callable, Iterator, Mapping, Sequence
from math import inf
from typing import Annotated, ClassVar, Literal, NamedTuple

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.peaks import MINIMUM_CYCLES, peak_factor
from flexcli.parts.asd import Vibration
from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.ends import FREE
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.requirements.buckling import borne
from flexcli.parts.requirements.closed_form import least_blade_force
from flexcli.parts.requirements.response_range import (
    Uncertain,
    between,
    compounded,
    pushed,
    uncertain_structure,
)
from flexcli.parts.requirements.shaking import (
    RANDOM,
    SHAKES,
    SINES,
    Shaking,
    at_once,
    random_at_once,
    refuse_unknown_axes,
    shakings,
)
from flexcli.parts.requirements.standing import (
    STANDING,
    changed_peaks,
    standing_force,
    standing_stress,
)
from flexcli.parts.requirements.yielding import Allowable
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.structure import MOTIONS, Answer, Structure
from flexcli.results import ErrorRange, QuantityKind, error_of_ratio

__all__ = ["Dynamic", "DynamicBuckling", "DynamicLife", "DynamicYield", "FindsPeaks"]


AXIAL_TOO = "bending with the axial force"


MILES = "Miles"
"""Name of the formula of one mode under a random vibration."""

BESIDE = " and what stands beside it"
"""Name of what stroke, static loads and temperature of a case add."""


class _Peak(NamedTuple):
    """The peak of one output with its error, its name, and its source."""

    output: str
    value: float
    error: ErrorRange | None
    what: str
    source: str


FindsPeaks = Callable[[Ask, str, float], Iterator[_Peak]]
"""Function that returns the peaks of outputs whose name has a prefix, up to a bearable one."""

Ranges = Mapping[str, tuple[float, ErrorRange | None]]
"""Peaks by output, each with the range of its error."""


class Dynamic(FactorRequirement):
    """A requirement on the peaks or the life under the response of the modes to a moving base."""

    closed_form: ClassVar[bool] = False
    by_solids: ClassVar[bool] = True

    peak: Literal["sigma", "duration"] = "sigma"
    """Peaks of a random response: sigma times the rms, or what the duration lets expect,
    e.g. ``duration``.
    """

    def applies(self, scene: Scene) -> bool:
        """Return whether the base moves in this case."""
        return self.covers(scene) and bool(scene.loads & SHAKES)

    def weighs(self, scene: Scene) -> bool:
        """Return True."""
        return True

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return what shakes the base."""
        return scene.loads & SHAKES

    def peaks(self, ask: Ask, prefix: str, bearable: float = inf) -> Iterator[_Peak]:
        """Yield the peak of every output whose name starts with the prefix.

        A peak beyond what is ``bearable`` passes it on the way: the error of the stress counts at
        the motion at which it is reached, not at a larger one.
        """
        for shaking in at_once(ask, self._peak_factor):
            found = uncertain_structure(ask, shaking.changes_at)
            try:
                found = pushed(ask, found, shaking.peaks, shaking.changes_at)
                ranges = found.of(shaking.peaks)
            except ValueError as error:
                raise RequirementError(str(error), shaking.hint) from error
            rest = _rest(ask, found, ranges, shaking.peaks, prefix, bearable)
            for name, (value, off) in ranges.items():
                if name.startswith(prefix):
                    what = f"{shaking.named(found.structure, name)} {name}"
                    yield _Peak(name, value, compounded(off, rest), what, shaking.source)

    def formula(self, scene: Scene) -> str:
        """Return Miles' name where his formula may give the peak: of random vibration in a plane.

        It does not cover peaks by the number of cycles in a duration.
        """
        shakes = scene.loads & SHAKES
        told = bool(shakes) and shakes <= RANDOM and not scene.vibrates_in_space
        return MILES if told and self.peak == "sigma" else ""

    def miles_peaks(self, ask: Ask, prefix: str, bearable: float = inf) -> Iterator[_Peak]:
        """Yield the peaks by Miles' formula, its omissions in their errors."""
        from flexcli.parts.miles_response import miles_outputs

        found = uncertain_structure(ask, ())
        if found.stiffer is None:
            raise NotAvailable("has no response by Miles: its stiffness or masses are not known")
        for vibration in random_at_once(ask.scene):
            refuse_unknown_axes(found.structure, vibration.axes)
            sigma = vibration.sigma

            def peaks(
                structure: Structure, vibration: Vibration = vibration, sigma: float = sigma
            ) -> dict[str, float]:
                each = miles_outputs(structure, vibration, (1.0, 1.0))
                return {name: sigma * one.rms for name, one in each.items()}

            found = pushed(ask, found, peaks, ())
            if found.stiffer is None:
                raise NotAvailable("has no response by Miles: its blades are pushed or bent")
            outputs = miles_outputs(found.structure, vibration, found.stiffer)
            ranges = {
                # a peak that is told lies in its own range
                name: (sigma * one.rms, between(one.rms, [one.rms, one.least, one.most]))
                for name, one in outputs.items()
            }
            rest = _rest(ask, found, ranges, peaks, prefix, bearable)
            for name, (value, off) in ranges.items():
                if not name.startswith(prefix):
                    continue
                error = compounded(off, rest)
                if error is None:  # of nothing, below or above the band, not even a zero is known
                    raise NotAvailable("has no response by Miles: its mode is outside the band")
                what, source = f"{sigma:.3g}σ {name}", f"{MILES}, {vibration.q.told}"
                yield _Peak(name, value, error, what, source)

    def _peak_factor(self, scene: Scene, vibration: Vibration, rate: float) -> float:
        if self.peak == "sigma":
            return vibration.sigma
        duration = _duration(scene, vibration)
        enough = rate * duration > MINIMUM_CYCLES
        return float(peak_factor(rate, duration)) if enough else vibration.sigma


def _rest(
    ask: Ask, found: Uncertain, ranges: Ranges, answer: Answer, prefix: str, bearable: float
) -> ErrorRange | None:
    """Return the further error of stresses, at the motion that reaches the bearable one."""
    own = [ranges[name] for name in MOTIONS if name in ranges]
    most = max((_largest(*ranges[n]) for n in ranges if n.startswith(prefix)), default=0.0)
    reached = min(1.0, bearable / most) if most > 0.0 else 1.0
    travel = _largest(*own[0]) if own else 0.0
    return found.stress_error(ask, travel, answer, reached)


def _largest(value: float, error: ErrorRange | None) -> float:
    """Return the largest of a peak within its error, itself where that has no bound."""
    return value * (1.0 + (error.high if error is not None and error.high < inf else 0.0))


def _duration(scene: Scene, vibration: Vibration) -> float:
    duration = vibration.lasts
    if duration is None:
        raise RequirementError(
            f"this needs the duration of the vibration of case '{scene.case}'",
            "add duration: 2 min to its asd",
        )
    return duration


class DynamicYield(Dynamic):
    """Factor on the peak stress of the modes, against R_p0.2 unless said otherwise.

    The largest stress of the case's stroke, static loads and temperature is added.
    """

    label: ClassVar[str] = "dynamic yield"

    allowable: Allowable = "yield-strength"
    """Strength that the stress is held against, e.g. ``fatigue-amplitude``."""

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the loads that shake the base, and all that stands beside them."""
        return super().looks_at(scene) | (scene.loads & {*STANDING, LoadKind.TEMPERATURE})

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the peak stress at every joint against the allowable."""
        yield from self._limits_of(ask, self.peaks)

    def by_formula(self, ask: Ask) -> Iterator[Limit]:
        """Yield the same by Miles' formula."""
        yield from self._limits_of(ask, self.miles_peaks)

    def _limits_of(self, ask: Ask, peaks: FindsPeaks) -> Iterator[Limit]:
        try:
            strength = ask.material.strength(self.allowable.replace("-", "_"))
        except MissingProperty as missing:
            raise RequirementError(str(missing), f"give material.{missing.field}") from missing
        (still, still_error), changed = standing_stress(ask), changed_peaks(ask)
        kind = "von Mises" if ask.scene.vibrates_in_space else AXIAL_TOO
        for peak in peaks(ask, "stress", strength / self.factor):
            error = compounded(peak.error, changed)
            yield Limit(
                self.label,
                ask.scene.case,
                f"{peak.what}{BESIDE if still else ''} ({kind})",
                peak.value + still,
                strength,
                "Pa",
                f"{peak.source}; allowable: {self.allowable}",
                required=self.factor,
                kind=QuantityKind.RESPONSE,
                error=_summed((peak.value, error), (still, still_error)),
                strengths=(self.allowable.replace("-", "_"),),
            )


def _summed(*parts: tuple[float, ErrorRange | None]) -> ErrorRange | None:
    """Return the error of a sum of non-negative numbers, from their errors."""
    whole, low, high = sum(value for value, _ in parts), 0.0, 0.0
    for value, error in parts:
        if value == 0.0:
            continue
        if error is None:
            return None
        low, high = low + value * error.low / whole, high + value * error.high / whole
    return ErrorRange(low, high)


def _refuse_temperature(ask: Ask, what: str) -> None:
    if ask.scene.temperature is not None:
        hint = "give the temperature a case of its own, or name other cases"
        raise RequirementError(f"{what} beside a temperature is not computed", hint)


def _of_plain_beams(error: ErrorRange | None, ask: Ask) -> ErrorRange | None:
    """Return the error of a critical force of beams between rigid clamps.

    Wide blades can only raise it, clamps that give way only lower it, a solid crossing does both.
    """
    if error is None:
        return None
    wide = ask.material.elastic.most_nu
    least, most = map(float, ask.geometry.crossed(ask.sizes))
    low = (1.0 + error.low) * least / (1.0 + ask.clamp_softening) - 1.0
    return ErrorRange(low, (1.0 + error.high + wide**2 / (1.0 - wide**2)) * most - 1.0)


class DynamicBuckling(Dynamic):
    """Factor on the peak axial force of the modes, against the least that buckles the joint.

    The largest force along a blade by the case's stroke and static loads is added.
    """

    label: ClassVar[str] = "dynamic buckling"
    by_solids: ClassVar[bool] = False

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the loads that shake the base, and all loads that stand beside them."""
        return super().looks_at(scene) | (scene.loads & STANDING)

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the peak axial force in every joint's blades against their critical force."""
        yield from self._limits_of(ask, self.peaks)

    def by_formula(self, ask: Ask) -> Iterator[Limit]:
        """Yield the same by Miles' formula."""
        yield from self._limits_of(ask, self.miles_peaks)

    def _limits_of(self, ask: Ask, peaks: FindsPeaks) -> Iterator[Limit]:
        scene = ask.scene
        if scene.ends is None:
            raise RequirementError(
                f"nothing says what holds the blades' ends in case '{scene.case}'",
                f"add ends: to the case, one of {', '.join(EFFECTIVE_LENGTH)}",
            )
        _refuse_temperature(ask, "the buckling under a vibration")
        if ask.geometry.in_space:
            raise RequirementError(
                "the buckling of a mechanism in space under a vibration is not computed",
                "give its peak as acceleration: in a case of its own, and ask for buckling",
            )
        critical = least_blade_force(ask)
        capacity, crushed = borne(critical, ask.material)
        per_force = ask.geometry.axial_stress(1.0, ask.sizes)
        still, still_error = standing_force(ask, per_force)
        own = _of_plain_beams(critical.error, ask)
        aside = self._pushed_aside(ask) if scene.ends == FREE else 0.0
        for peak in peaks(ask, "axial stress", inf):
            demand = peak.value / per_force + still
            error = error_of_ratio(
                _summed((peak.value / per_force, peak.error), (still, still_error)), own
            )
            if error is not None and demand > 0.0:
                error = error._replace(high=max(error.high, aside * capacity / demand - 1.0))
            yield Limit(
                self.label,
                scene.case,
                f"{peak.what.replace('stress', 'force')}{BESIDE if still else ''} of a blade",
                demand,
                capacity,
                "N",
                f"{peak.source}; {critical.source}: {scene.ends_why}{crushed}",
                required=self.factor,
                kind=QuantityKind.RESPONSE,
                error=error,
            )

    def _pushed_aside(self, ask: Ask) -> float:
        """Return what the peaks are of static loads that buckle the joint, out of its plane too.

        All components of the force on it at once, which is more than happens.
        """
        from flexcli.parts.requirements.pushed_by_peaks import pushed_share

        each = []
        for shaking in at_once(ask, self._peak_factor):
            found = uncertain_structure(ask, shaking.changes_at)
            each.append(pushed_share(ask, found.structure, shaking.peaks, found.on_way))
        return max((share for share in each if share is not None), default=0.0)


class DynamicLife(Dynamic):
    """Factor on the life under the random stress, by a named method or the least of all."""

    label: ClassVar[str] = "dynamic life"
    adds_up: ClassVar[bool] = True

    method: Literal[
        "least", "narrow-band", "steinberg", "wirsching-light", "dirlik", "tovo-benasciutti"
    ] = "least"
    """Method of the damage of a random stress; the least life of all, if left out,
    e.g. ``dirlik``.
    """
    mean_stress: Annotated[float, QuantityOf("stress", at_least=0.0)] = 0.0
    """Tension that stands at the blade's end beside the vibration, by Goodman, e.g. ``50 MPa``;
    the largest stress of the case's stroke and static loads is added.
    """

    def applies(self, scene: Scene) -> bool:
        """Return whether the case vibrates at random."""
        return self.covers(scene) and scene.vibration is not None

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the random vibration, and what stands beside it, sines too."""
        return scene.loads & (RANDOM | SINES | STANDING)

    def formula(self, scene: Scene) -> str:
        """Return none: damage hangs on all of the response's spectrum."""
        return ""

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the duration of the vibration against the life of every joint."""
        _refuse_temperature(ask, "a life under vibration")
        vibration = ask.scene.vibration
        assert vibration is not None  # it applies
        if beside := sorted(ask.scene.loads & SHAKES - RANDOM - SINES):
            raise RequirementError(
                f"a life under random vibration with a {' and a '.join(beside)} in one case is "
                "not computed",
                f"give the {' and the '.join(beside)} a case of its own, or judge another case",
            )
        still, off = standing_stress(ask)
        mean = self.mean_stress + still
        means = None if off is None else (mean, *(mean + still * end for end in off))
        exposures = list(_exposures(ask, vibration))
        duration = sum(exposure.duration for exposure in exposures)
        shaken = at_once(ask, lambda _scene, random, _rate: random.sigma)
        corners = {f for shaking in shaken for f in shaking.changes_at}
        found = uncertain_structure(ask, tuple(sorted(corners)))

        def peaks(structure: Structure) -> dict[str, float]:
            each = [shaking.peaks(structure) for shaking in shaken]
            return {name: max(one[name] for one in each) for name in each[0]}

        found = pushed(ask, found, peaks, tuple(sorted(corners)))
        ranges = found.of(peaks)
        own = [ranges[name] for name in MOTIONS if name in ranges]
        travel = _largest(*own[0]) if own else 0.0
        rest = found.stress_error(ask, travel, peaks)
        told = f"mean stress {mean / 1e6:.4g} MPa" if mean else "no mean"
        on_it = "".join(f", {exposure.told}" for exposure in exposures if exposure.sines)
        for name, (life, error) in self._lives(ask, found, exposures, rest, (mean, means)).items():
            yield Limit(
                self.label,
                ask.scene.case,
                f"duration against life, {name}",
                duration,
                life,
                "s",
                f"{self.method}, S-N amplitudes at R = −1, {told}, modal response, "
                f"{vibration.q.told}{on_it}",
                required=self.factor,
                kind=QuantityKind.RESPONSE,
                in_capacity=True,
                error=error,
            )

    def _lives(
        self,
        ask: Ask,
        found: Uncertain,
        exposures: "Sequence[_Exposure]",
        rest: ErrorRange | None,
        means: tuple[float, tuple[float, ...] | None],
    ) -> dict[str, tuple[float, ErrorRange | None]]:
        """Return the life at every joint [s], with its error from the range of the stress.

        Damages of exposures one after another add up (Miner). ``means`` are the mean stress and all
        that it may be, if that is known [Pa].
        """
        mean, all_means = means

        def lives(
            structure: Structure, stress: float = 1.0, mean: float = mean
        ) -> dict[str, float]:
            """Return the lives when every stress is multiplied by a factor, beside a mean."""
            whole = sum(exposure.duration for exposure in exposures)
            used: dict[str, float] = {}
            for exposure in exposures:
                for name, life in self._alone(ask, structure, exposure, stress, mean).items():
                    share = exposure.duration / life if life > 0.0 else inf
                    used[name] = used.get(name, 0.0) + share
            return {name: whole / each if each > 0.0 else inf for name, each in used.items()}

        try:
            if rest is None or found.others is None or all_means is None:
                return {name: (life, None) for name, life in lives(found.structure).items()}
            every = [
                lives(structure, 1.0 + end, beside)
                for structure in (found.structure, *found.others)
                for end in rest
                for beside in dict.fromkeys(all_means)
            ]
            plain = lives(found.structure)
        except MissingProperty as missing:
            raise RequirementError(str(missing), f"give material.{missing.field}") from missing
        except RequirementError:
            raise
        except ValueError as error:
            raise RequirementError(str(error)) from error
        ranges = {
            name: (life, between(life, [each[name] for each in every]))
            for name, life in plain.items()
        }
        if found.is_bounded:
            return ranges
        return {  # it may be any shorter
            name: (life, None if error is None else error._replace(low=-1.0))
            for name, (life, error) in ranges.items()
        }

    def _alone(
        self, ask: Ask, structure: Structure, exposure: "_Exposure", stress: float, mean: float
    ) -> dict[str, float]:
        """Return the life at every joint under one exposure alone [s], stresses times a factor."""
        from flexcli.parts.response import random_outputs
        from flexcli.parts.vibration_life import SineStress, life_under

        living = {}
        sines = [(each.peaks(structure), max(each.changes_at)) for each in exposure.sines]
        highest = max((frequency for _, frequency in sines), default=0.0)
        for name, output in random_outputs(structure, exposure.vibration).items():
            if not name.startswith("stress"):
                continue
            m0, m1, m2, m4 = (moment * stress**2 for moment in output.moments)
            sine = SineStress(stress * sum(peaks[name] for peaks, _ in sines), highest)
            by_method = life_under(ask.material, (m0, m1, m2, m4), mean, sine)
            if self.method not in ("least", *by_method):
                why = (
                    "is of a random stress alone, and sines stand on it"
                    if sine.amplitude
                    else "is fitted to one slope, and the S-N curve has several"
                )
                hint = ", or one of ".join(("take least", ", ".join(by_method)))
                raise RequirementError(f"{self.method} {why}", hint)
            least = self.method == "least"
            living[name] = min(by_method.values()) if least else by_method[self.method]
        return living


class _Exposure(NamedTuple):
    """A random vibration for a time [s], and the sines that stand on it."""

    vibration: Vibration
    duration: float
    sines: tuple[Shaking, ...]

    @property
    def told(self) -> str:
        """Return how sines count in the damage, in words."""
        each = " and the ".join(shaking.source for shaking in self.sines)
        return f"with the {each}, amplitudes by Rice (1945) at the higher rate"


def _exposures(ask: Ask, vibration: Vibration) -> Iterator[_Exposure]:
    """Yield a random vibration with all sines on it, or axis after axis with its own.

    Raises
    ------
    RequirementError
        When a duration is missing, or a sine acts in turn where nothing says how long.

    """
    scene = ask.scene
    sines = [each for each in shakings(ask, lambda *_: 0.0) if each.kind in SINES]
    if not scene.in_turn:
        yield _Exposure(vibration, _duration(scene, vibration), tuple(sines))
        return
    for sine in sines:
        if not set(sine.axes) <= set(vibration.axes):
            text = f"nothing says how long the sine along {sine.axes[0]} of '{scene.case}' lasts"
            raise RequirementError(text, "give it a case of its own, with a random vibration")
    for axis in vibration.axes:
        alone = vibration.alone(axis)
        on_it = tuple(sine for sine in sines if axis in sine.axes)
        yield _Exposure(alone, _duration(scene, alone), on_it)
