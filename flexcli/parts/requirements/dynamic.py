"""Requirements on the real response of the modes to a vibration or a shock.

They judge a given blade; its modes are no posynomials, so they cannot size one. What computes
modes and lives is imported where it is called: few designs ask, and all would wait for it.
"""

from collections.abc import Iterator
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, NamedTuple

from flexcli.formulas.buckling import EFFECTIVE_LENGTH
from flexcli.formulas.peaks import MINIMUM_CYCLES, peak_factor
from flexcli.parts.asd import RandomVibration
from flexcli.parts.base import QuantityOf
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.material import MissingProperty
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements.ask import Ask, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.requirements.yielding import Allowable
from flexcli.parts.scene import LoadKind, Scene
from flexcli.parts.structure import Structure
from flexcli.results import QuantityKind

if TYPE_CHECKING:
    from flexcli.parts.response import RandomResponse

__all__ = ["DynamicBuckling", "DynamicLife", "DynamicYield"]


class _Peak(NamedTuple):
    """The peak of one output, what it is, and how it was found."""

    output: str
    value: float
    what: str
    source: str


class _Dynamic(FactorRequirement):
    closed_form: ClassVar[bool] = False

    peak: Literal["sigma", "duration"] = "sigma"
    """Peaks of a random response: sigma times the rms, or what the duration lets expect."""

    def applies(self, scene: Scene) -> bool:
        """Return whether the base moves in this case."""
        return self.covers(scene) and (scene.vibration is not None or scene.shock is not None)

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return what shakes the base."""
        return scene.loads & {LoadKind.ASD, LoadKind.SHOCK}

    def peaks(self, ask: Ask, prefix: str) -> Iterator[_Peak]:
        """Yield the peak of every output whose name starts with the prefix."""
        from flexcli.parts.response import shock_peaks

        structure = _structure(ask)
        vibration, shock = ask.scene.vibration, ask.scene.shock
        if vibration is not None:
            for name, output in _random(structure, vibration).outputs.items():
                if name.startswith(prefix):
                    factor = self._peak_factor(ask.scene, vibration, output.crossing_rate)
                    source = f"modal response, Q = {vibration.q:g}"
                    yield _Peak(name, factor * output.rms, f"{factor:.3g}σ {name}", source)
        if shock is not None:
            try:
                found = shock_peaks(structure, shock)
            except ValueError as error:
                hint = "extend the spectrum to the modes' frequencies"
                raise RequirementError(str(error), hint) from error
            for name, value in found.items():
                if name.startswith(prefix):
                    source = f"modal response to the shock, Q = {shock.q:g}"
                    yield _Peak(name, value, f"peak {name}", source)

    def _peak_factor(self, scene: Scene, vibration: RandomVibration, rate: float) -> float:
        if self.peak == "sigma":
            return vibration.sigma
        duration = _duration(scene, vibration)
        enough = rate * duration > MINIMUM_CYCLES
        return float(peak_factor(rate, duration)) if enough else vibration.sigma


def _structure(ask: Ask) -> Structure:
    if ask.mechanism is None:
        raise RequirementError("a response needs masses that move", "add a mechanism")
    try:
        return ask.mechanism.structure(
            ask.geometry, ask.material.elastic, ask.sizes, ask.scene.lock
        )
    except (MechanismError, NotAvailable) as error:
        raise RequirementError(str(error), getattr(error, "hint", "")) from error


def _random(structure: Structure, vibration: RandomVibration) -> "RandomResponse":
    from flexcli.parts.response import random_response

    try:
        return random_response(structure, vibration)
    except ValueError as error:
        raise RequirementError(str(error)) from error


def _duration(scene: Scene, vibration: RandomVibration) -> float:
    duration = vibration.applied().duration
    if duration is None:
        raise RequirementError(
            f"this needs the duration of the vibration of case '{scene.case}'",
            "add duration: 2 min to its asd",
        )
    return duration


class DynamicYield(_Dynamic):
    """Factor on the peak stress of the modes, against R_p0.2 unless said otherwise."""

    label: ClassVar[str] = "dynamic yield"

    allowable: Allowable = "yield-strength"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the peak stress at every joint against the allowable."""
        try:
            strength = ask.material.strength(self.allowable.replace("-", "_"))
        except MissingProperty as missing:
            raise RequirementError(str(missing), f"give material.{missing.field}") from missing
        for peak in self.peaks(ask, "stress"):
            yield Limit(
                self.label,
                ask.scene.case,
                f"{peak.what} (bending with the axial force)",
                peak.value,
                strength,
                "Pa",
                f"{peak.source}; allowable: {self.allowable}",
                required=self.factor,
                kind=QuantityKind.RESPONSE,
            )


class DynamicBuckling(_Dynamic):
    """Factor on the peak axial force of the modes in the most loaded blade."""

    label: ClassVar[str] = "dynamic buckling"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the peak axial force in every joint's blades against their critical force."""
        scene = ask.scene
        if scene.ends is None:
            raise RequirementError(
                f"nothing says what holds the blades' ends in case '{scene.case}'",
                f"add ends: to the case, one of {', '.join(EFFECTIVE_LENGTH)}",
            )
        critical = min(
            ask.geometry.critical(ask.material.elastic, ask.sizes, scene.ends),
            key=lambda found: float(found.force),
        )
        per_force = ask.geometry.axial_stress(1.0, ask.sizes)
        for peak in self.peaks(ask, "axial stress"):
            yield Limit(
                self.label,
                scene.case,
                f"{peak.what.replace('stress', 'force')} of a blade",
                peak.value / per_force,
                critical.force,
                "N",
                f"{peak.source}; {critical.source}: {scene.ends_why}",
                required=self.factor,
                kind=QuantityKind.RESPONSE,
            )


class DynamicLife(_Dynamic):
    """Factor on the life under the random stress, by a named method or the least of all."""

    label: ClassVar[str] = "dynamic life"

    method: Literal[
        "least", "narrow-band", "steinberg", "wirsching-light", "dirlik", "tovo-benasciutti"
    ] = "least"
    mean_stress: Annotated[float, QuantityOf("stress", at_least=0.0)] = 0.0
    """Tension that stands at the blade's end beside the vibration, by Goodman."""

    def applies(self, scene: Scene) -> bool:
        """Return whether the case vibrates at random."""
        return self.covers(scene) and scene.vibration is not None

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the duration of the vibration against the life of every joint."""
        from flexcli.parts.vibration_life import life_under

        vibration = ask.scene.vibration
        assert vibration is not None  # it applies
        duration = _duration(ask.scene, vibration)
        mean = f"mean stress {self.mean_stress / 1e6:.4g} MPa" if self.mean_stress else "no mean"
        for name, output in _random(_structure(ask), vibration).outputs.items():
            if not name.startswith("stress"):
                continue
            try:
                lives = life_under(ask.material, output.moments, self.mean_stress)
            except MissingProperty as missing:
                raise RequirementError(str(missing), f"give material.{missing.field}") from missing
            shortest = min(lives, key=lambda key: lives[key])
            method = shortest if self.method == "least" else self.method
            yield Limit(
                self.label,
                ask.scene.case,
                f"duration against life, {name}",
                duration,
                lives[method],
                "s",
                f"{method}, S-N amplitudes at R = −1, {mean}, modal response, Q = {vibration.q:g}",
                required=self.factor,
                kind=QuantityKind.RESPONSE,
            )
