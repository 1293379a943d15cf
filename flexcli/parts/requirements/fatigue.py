"""Fatigue: the stress amplitude of the stroke against the strength for the asked cycles."""

from collections.abc import Iterator
from typing import ClassVar, Literal

from flexcli.formulas.fatigue import goodman_amplitude, swt_amplitude_squared
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import is_of_many, larger, number, smaller
from flexcli.parts.material import MissingProperty
from flexcli.parts.requirements.ask import Ask, EndStress, RequirementError, Swing
from flexcli.parts.requirements.base import ErrorOf, FactorRequirement, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["Fatigue"]


LIMITS = {"goodman": "tensile_strength", "soderberg": "yield_strength"}
"""What a mean stress is compared with, by the method."""


class Fatigue(FactorRequirement):
    """Factor on the stress amplitude; mean stress by Goodman unless said otherwise.

    The factor is on the load: amplitude and mean grow together. A compressive mean earns nothing.
    """

    label: ClassVar[str] = "fatigue"
    by_shells: ClassVar[QuantityKind | None] = QuantityKind.STRESS
    by_solids: ClassVar[bool] = True

    mean_stress: Literal["goodman", "soderberg", "swt", "none"] = "goodman"
    """How the mean stress counts, e.g. ``soderberg``."""

    def applies(self, scene: Scene) -> bool:
        """Return whether the case has a stroke that repeats."""
        return self.covers(scene) and scene.travel > 0.0

    def weighs(self, scene: Scene) -> bool:
        """Return whether the mean of its stress is in part of what moves."""
        return scene.is_accelerated

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the stroke, and as its mean what pushes the joint in its plane or out of it."""
        pushed = scene.pushed_by | scene.across_by
        steady = frozenset() if self.mean_stress == "none" else pushed
        return steady | {LoadKind.STROKE}

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield amplitude against strength at each end."""
        scene, material = ask.scene, ask.material
        if scene.cycles is None:
            raise RequirementError(
                f"fatigue needs the cycles of the stroke of case '{scene.case}'", "add cycles: 1e7"
            )
        try:
            strength, where = material.reversed_amplitude(scene.cycles, self.mean_stress)
            name, stresses = ask.joint_model.stresses(ask)
            for stress in stresses:
                method = self._method(stress, ask)
                meant = f"equivalent amplitude ({method}) of the {name}"
                if method == "none":
                    meant = f"amplitude of the {ask.geometry.strain} stress"
                demand, power = self._equivalent(stress, ask, strength, method)
                yield Limit(
                    self.label,
                    scene.case,
                    f"{meant}, {stress.where}",
                    demand,
                    strength**power,
                    "Pa",
                    f"{where}; mean stress: {method}; {ask.geometry.source}",
                    required=self.factor,
                    power=power,
                    load=True,
                    joint=stress.joint,
                    driver="stroke" if method == "none" else scene.driver,
                    kind=QuantityKind.STRESS,
                    error=self._error(stress, ask, strength, method, demand),
                    strengths=("fatigue_amplitude", *filter(None, (LIMITS.get(method),))),
                )
        except MissingProperty as missing:
            raise RequirementError(
                str(missing), f"give material.{missing.field}, or take another material"
            ) from missing

    def _method(self, stress: EndStress, ask: Ask) -> str:
        """Return the method for a place's mean stress; a material may lack what it needs.

        Where a mean comes only from the difference of both ways of a reversing stroke, the larger
        end then counts as the amplitude: no less than by Goodman, for R_m is above the strength.
        """
        if stress.is_reversed:
            return "none"
        lacking = LIMITS.get(self.mean_stress)
        if stress.reverses and lacking is not None and getattr(ask.material, lacking) is None:
            return "larger end"
        return self.mean_stress

    def _error(
        self, stress: EndStress, ask: Ask, strength: float, method: str, demand: Computed
    ) -> ErrorRange | ErrorOf:
        """Return the error of a formula's demand where a directed force may compress its blades.

        Formulas take every axial stress as tension; compression does not add to the mean. Elsewhere
        the error is that of the stress.
        """
        axial = stress.axial
        plain = all(isinstance(x, float) or is_of_many(x) for x in (axial, demand))
        swing = ask.joint_model.swing(ask)
        if swing is not None and plain and demand > 0.0:
            return self._beside_loads(stress, ask, strength, method, swing, demand)
        of_swing = ask.joint_model.swing_error(ask)
        if of_swing is not None:
            return of_swing
        if not (ask.scene.directed and plain):
            return ErrorOf.MODEL
        if stress.is_at_face or axial <= 0.0 or demand <= 0.0:
            return ErrorOf.MODEL
        known = ask.joint_model.error(ask, QuantityKind.STRESS)
        if known is None:
            return ErrorOf.MODEL
        pushed = stress._replace(axial=-axial, is_at_face=True)
        least, power = self._equivalent(pushed, ask, strength, method)
        return known + ErrorRange(smaller(_share(least, demand, power) - 1.0, 0.0), 0.0)

    def _beside_loads(
        self,
        stress: EndStress,
        ask: Ask,
        strength: float,
        method: str,
        swing: Swing,
        demand: Computed,
    ) -> ErrorRange:
        """Return the error of a demand whose amplitude is the stroke's, its mean of loads besides.

        What they add is largest at one place, and may be nothing where the amplitude is; there the
        amplitude may be nothing.
        """
        size, mean, axial = (number(x) for x in (abs(stress.amplitude), stress.mean, stress.axial))
        own, added = swing.own, swing.added
        least, most = sorted((mean * (1.0 + own.low), mean * (1.0 + own.high)))
        beside = abs(axial) * own.largest
        in_plane = min(abs(axial - added), abs(axial + added))

        def share(amplitude: float, middle: float, other: float) -> float:
            at = stress._replace(amplitude=larger(amplitude, 0.0), mean=middle, axial=other)
            changed, power = self._equivalent(at, ask, strength, method)
            return _share(changed, demand, power)

        low = max(
            share(size * (1.0 + own.low) - swing.off, least, axial - added - beside),
            share(0.0, 0.0, max(added * (1.0 + swing.error.low) - in_plane, 0.0)),
        )
        high = axial + added * max(swing.error.high, 0.0) + beside
        return ErrorRange(low - 1.0, share(size * (1.0 + own.high) + swing.off, most, high) - 1.0)

    def _equivalent(
        self, stress: EndStress, ask: Ask, strength: float, method: str
    ) -> tuple[Computed, int]:
        mean = stress.mean + stress.axial
        if stress.is_at_face:
            mean = max(mean, 0.0)
        if method == "none":
            return stress.amplitude, 1
        if method == "larger end":
            return stress.amplitude + mean, 1
        if method == "swt":
            return swt_amplitude_squared(amplitude=stress.amplitude, mean=mean), 2
        limit = ask.material.strength(LIMITS[method])
        return (
            goodman_amplitude(
                amplitude=stress.amplitude, mean=mean, reversed_strength=strength, limit=limit
            ),
            1,
        )


def _share(changed: Computed, demand: Computed, power: int) -> float:
    """Return one equivalent amplitude over another; there is none where all is compressed."""
    return float((larger(number(changed), 0.0) / number(demand)) ** (1.0 / power))
