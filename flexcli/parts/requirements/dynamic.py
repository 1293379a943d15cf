"""Requirements on the real response of the modes to a vibration: yield, buckling, life.

They judge a given blade; its modes are no posynomials, so they cannot size one.
"""

from collections.abc import Iterator
from typing import ClassVar, Literal

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, euler_load
from flexcli.formulas.section import second_moment
from flexcli.parts.geometries.base import NotAvailable
from flexcli.parts.material import MissingProperty
from flexcli.parts.mechanisms import MechanismError
from flexcli.parts.requirements.base import Ask, FactorRequirement, Limit, RequirementError
from flexcli.parts.requirements.yielding import Allowable
from flexcli.parts.response import RandomResponse, random_response
from flexcli.parts.scene import Scene
from flexcli.parts.vibration_life import life_under

__all__ = ["DynamicBuckling", "DynamicLife", "DynamicYield", "response_of"]


def response_of(ask: Ask) -> RandomResponse:
    """Return the response of a case's modes, or raise what keeps it from being computed."""
    scene = ask.scene
    assert scene.vibration is not None  # what a dynamic requirement applies to
    if ask.mechanism is None:
        raise RequirementError("a response needs masses that move", "add a mechanism")
    try:
        structure = ask.mechanism.structure(ask.geometry, ask.material.E, ask.blade, scene.lock)
        return random_response(structure, scene.vibration)
    except (MechanismError, NotAvailable) as error:
        raise RequirementError(str(error), getattr(error, "hint", "")) from error


class _Dynamic(FactorRequirement):
    closed_form: ClassVar[bool] = False

    def applies(self, scene: Scene) -> bool:
        """Return whether the case vibrates."""
        return self.covers(scene) and scene.vibration is not None


class DynamicYield(_Dynamic):
    """Factor on sigma times the rms stress of the modes, R_p0.2 unless said otherwise."""

    label: ClassVar[str] = "dynamic yield"

    allowable: Allowable = "yield-strength"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the peak stress of every joint against the allowable."""
        try:
            strength = ask.material.strength(self.allowable.replace("-", "_"))
        except MissingProperty as missing:
            raise RequirementError(str(missing), f"give material.{missing.field}") from missing
        response, vibration = response_of(ask), ask.scene.vibration
        assert vibration is not None
        for name, output in response.outputs.items():
            if name.startswith("stress"):
                yield Limit(
                    self.label,
                    ask.scene.case,
                    f"{vibration.sigma:g}σ {name} (bending with the axial force)",
                    vibration.sigma * output.rms,
                    strength,
                    "Pa",
                    f"modal response, Q = {vibration.q:g}; allowable: {self.allowable}",
                    required=self.factor,
                )


class DynamicBuckling(_Dynamic):
    """Factor on sigma times the rms axial force of the modes in the most loaded blade."""

    label: ClassVar[str] = "dynamic buckling"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the peak axial force of every joint's blades against their critical force."""
        scene, (h, l, b) = ask.scene, ask.blade
        if scene.ends is None:
            raise RequirementError(
                f"nothing says what holds the blades' ends in case '{scene.case}'",
                f"add ends: to the case, one of {', '.join(EFFECTIVE_LENGTH)}",
            )
        response, vibration = response_of(ask), scene.vibration
        assert vibration is not None
        inertia = min(second_moment(b, h), second_moment(h, b))
        critical = euler_load(E=ask.material.E, I=inertia, l=l, ends=scene.ends)
        for name, output in response.outputs.items():
            if name.startswith("axial stress"):
                yield Limit(
                    self.label,
                    scene.case,
                    f"{vibration.sigma:g}σ axial force in a blade, {name.split()[-1]}",
                    vibration.sigma * output.rms * h * b,
                    critical,
                    "N",
                    f"modal response, Q = {vibration.q:g}; Euler, {scene.ends} ends",
                    required=self.factor,
                )


class DynamicLife(_Dynamic):
    """Factor on the life under the random stress, by a named method or the least of all."""

    label: ClassVar[str] = "dynamic life"

    method: Literal[
        "least", "narrow-band", "steinberg", "wirsching-light", "dirlik", "tovo-benasciutti"
    ] = "least"

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield the duration of the vibration against the life of every joint."""
        vibration = ask.scene.vibration
        assert vibration is not None
        duration = vibration.applied().duration
        if duration is None:
            raise RequirementError(
                f"a life needs the duration of the vibration of case '{ask.scene.case}'",
                "add duration: 2 min to its asd",
            )
        response = response_of(ask)
        for name, output in response.outputs.items():
            if not name.startswith("stress"):
                continue
            try:
                lives = life_under(ask.material, output.moments)
            except MissingProperty as missing:
                raise RequirementError(str(missing), f"give material.{missing.field}") from missing
            method = (
                min(lives, key=lambda key: lives[key]) if self.method == "least" else self.method
            )
            yield Limit(
                self.label,
                ask.scene.case,
                f"duration against life, {name}",
                duration,
                lives[method],
                "s",
                f"{method}, S-N amplitudes, modal response, Q = {vibration.q:g}",
                required=self.factor,
            )
