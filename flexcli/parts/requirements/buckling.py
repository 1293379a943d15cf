"""Buckling: the force on the joint against the one at which it, or a blade of it, buckles."""

from collections.abc import Iterator, Sequence
from typing import ClassVar

import numpy as np

from flexcli.formulas.buckling import EFFECTIVE_LENGTH, johnson_stress
from flexcli.formulas.quantity import Computed
from flexcli.numerics.rows import number, smaller
from flexcli.numerics.signomial import Signomial
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Critical
from flexcli.parts.material import Material
from flexcli.parts.requirements.ask import CRUSHED, MOST_SHARE, Ask, CriticalShare, RequirementError
from flexcli.parts.requirements.base import FactorRequirement, Limit
from flexcli.parts.scene import LoadKind, Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["Buckling", "borne", "strained"]

BEYOND = 1.5
"""How far beyond the factor that is asked for it is looked what buckles a joint: the error of what
stands up to there is less."""

BULKY = 100.0
"""Strain from which on blades are too bulky to buckle, whatever their law."""

LESS = 2.0
"""Strains by which a critical force may be less than that of beams at most."""

FURTHER, FARTHEST = 1.15, 1e3
"""Where its error is more, how far beyond what would do it is looked once more, and how often the
factor that is asked for at most: beams whose springs are hardly known may stand a hundred times."""


class Buckling(FactorRequirement):
    """Factor on the force at which the joint buckles, held as stated, at the motion of the case.

    A load acts in the direction that it states, or either way along the axis where it states none;
    an acceleration acts either way.
    """

    label: ClassVar[str] = "buckling"
    is_of_buckling: ClassVar[bool] = True

    def applies(self, scene: Scene) -> bool:
        """Return whether the case puts a force along the blades, or any load in space."""
        pushes = scene.is_loaded if _in_shares(scene) else scene.blade_force > 0.0
        return self.covers(scene) and (pushes or bool(scene.across_by))

    def looks_at(self, scene: Scene) -> frozenset[LoadKind]:
        """Return the loads of the joint, in its plane or out of it."""
        return scene.pushed_by | scene.across_by

    def may_be_decided(self, ask: Ask) -> bool:
        """Return whether the model knows how far off it is, of loads in space alone."""
        scene = ask.scene
        in_plane = scene.blade_force and not _in_shares(scene)
        in_space = scene.in_space or bool(scene.across_by)
        return bool(in_plane) or not in_space or ask.joint_model.knows_critical_shares(ask)

    def limits(self, ask: Ask) -> Iterator[Limit]:
        """Yield force against critical force, in the plane and across the blades' width."""
        scene = ask.scene
        if _in_shares(scene) or scene.across_by:
            yield from self._shares(ask)
        if _in_shares(scene) or not scene.blade_force:
            return
        if scene.ends is None:
            raise RequirementError(
                f"nothing says what holds the blades' ends in case '{scene.case}'",
                f"add ends: to the case, one of {', '.join(EFFECTIVE_LENGTH)}",
            )
        most = max(MOST_SHARE, BEYOND * self.factor)
        for critical in ask.joint_model.critical(ask._replace(most_share=most)):
            capacity, crushed = borne(critical, ask.material)
            yield Limit(
                self.label,
                scene.case,
                f"force {scene.force_name}, buckling {critical.way}",
                scene.force,
                capacity,
                "N",
                f"{critical.source}: {scene.ends_why}{crushed}",
                required=self.factor,
                load=True,
                driver="force",
                kind=QuantityKind.BUCKLING,
                in_capacity=True,
                error=_error(critical, ask),
            )

    def _shares(self, ask: Ask) -> Iterator[Limit]:
        """Yield the loads of a case against the factor on them that buckles blades or bodies."""
        in_space = ask.scene.in_space or ask.scene.across_by
        beams = ask.joint_model.at_stroke if in_space else "exact beams in the plane"
        what = "the loads of the case"
        if ask.scene.temperature is not None:
            alone = ask.scene.loads <= {LoadKind.TEMPERATURE, LoadKind.STROKE}
            what = "the temperature" if alone else "temperature and loads"
        unloaded = _by_temperature_alone(ask)
        heated = () if unloaded is None else self._far_enough(unloaded)
        for found in self._far_enough(ask):
            yield Limit(
                self.label,
                ask.scene.case,
                f"share of {what} that buckles it, {found.held}",
                1.0,
                found.share,
                "",
                f"where a direction of blades and bodies gets unstable, {beams}",
                required=self.factor,
                kind=QuantityKind.BUCKLING,
                in_capacity=True,
                error=_strained_by(ask, found, _with(heated, found)),
            )

    def _far_enough(self, ask: Ask) -> Sequence[CriticalShare]:
        """Return the shares of the loads that buckle the joint, looked for as far as that decides.

        What stands at all shares that were looked at may be known to stand at the factor only if it
        stands far beyond. They are borne where blades yield before they buckle.
        """
        most = max(MOST_SHARE, BEYOND * self.factor)
        found = tuple(ask.joint_model.critical_shares(ask._replace(most_share=most)))
        for _ in range(2):
            further = self._most_to_decide(found, most, ask.material)
            if further is None:
                break
            try:
                more = ask.joint_model.critical_shares(ask._replace(most_share=further))
                found, most = tuple(more), further
            except NotAvailable:  # so far its path is not found
                break
        return tuple(each.borne(ask.material) for each in found)

    def _most_to_decide(
        self, found: Sequence[CriticalShare], most: float, material: Material
    ) -> float | None:
        """Return up to which share to look, if that all stand beyond ``most`` may decide."""
        least = [each.borne(material).least for each in found if each.error is not None]
        standing = all(each.share >= most for each in found) and len(least) == len(found)
        if not found or not standing or not 0.0 < min(least) < self.factor:
            return None
        further = FURTHER * most * self.factor / min(least)
        return further if further <= FARTHEST * self.factor else None


def _in_shares(scene: Scene) -> bool:
    """Return whether a case is judged as a whole, by a factor on all of its loads."""
    return scene.in_space or scene.temperature is not None


def _by_temperature_alone(ask: Ask) -> Ask | None:
    """Return what asks of a temperature without the loads beside it, where there are both.

    A load across blades bends them from the start, and no bifurcation lies on that path: the joint
    bends far instead where it would buckle without the load.
    """
    if ask.scene.temperature is None or ask.scene.loads <= {LoadKind.TEMPERATURE, LoadKind.STROKE}:
        return None
    return ask._replace(scene=ask.scene.without_loads())


def _with(heated: Sequence[CriticalShare], found: CriticalShare) -> ErrorRange | None:
    """Return the error of a factor that may be as small as that of the temperature alone."""
    least = [found.error, *(each.error for each in heated)]
    shares = [found.share, *(each.share for each in heated)]
    ends = [share * (1.0 + error.low) for share, error in zip(shares, least, strict=True) if error]
    if found.error is None or len(ends) < len(shares):
        return None
    return ErrorRange(min(ends) / found.share - 1.0, found.error.high)


def _strained_by(ask: Ask, found: CriticalShare, error: ErrorRange | None) -> ErrorRange | None:
    """Return the error of a share with what the strain of the blades at it leaves open."""
    return None if error is None else strained(error, found.stress / ask.material.elastic.E)


def borne(critical: Critical, material: Material) -> tuple[Computed, str]:
    """Return the force [N] that a joint bears, and how if its blades yield before they buckle.

    By Johnson's parabola where the material has a yield strength; a choice of sizes takes the
    elastic force, which its algebra can express.
    """
    force, given = critical.force, material.yield_strength
    if given is None or isinstance(force, Signomial):
        return force, ""
    if isinstance(critical.stress, float) and critical.stress == 0.0:  # across the blades
        return force, ""
    elastic = critical.elastic
    if elastic is None:
        return force, ""
    strength = number(given.value)
    found = johnson_stress(elastic, strength) / np.asarray(critical.stress, dtype=np.float64)
    if np.ndim(found):
        return found, ""
    if number(elastic) <= strength / 2.0:
        return force, ""
    return number(found), CRUSHED


def _error(critical: Critical, ask: Ask) -> ErrorRange | None:
    """Return the error of the bearable force from that of the elastic force, and its strain."""
    force, middle = critical.force, borne(critical, ask.material)[0]
    if critical.error is None or isinstance(force, Signomial):
        return critical.error
    if not np.all(np.isfinite(np.asarray(middle, np.float64))):
        return critical.error
    error, elastic = critical.error, critical.elastic
    if elastic is not None:
        given, E = ask.material.yield_strength, ask.material.elastic.E
        most = BULKY if given is None else given.value / E
        strain = smaller(number(elastic / E), most)
        # at the lower end it is less strained
        error = strained(error, strain)
    ends = (borne(critical._replace(force=force * (1.0 + end)), ask.material)[0] for end in error)
    low, high = (number(end) / number(middle) - 1.0 for end in ends)
    return ErrorRange(low, high)


def strained(error: ErrorRange, strain: float) -> ErrorRange:
    """Return the error of an elastic critical force with what the strain at it leaves open.

    Laws of finite strain differ by that: Green's strain or a beam's, stress of the first area or of
    the last, with or without what a blade shortens first. No material states which is its own.
    Solids of small motion (CalculiX, h/l from 0.06 to 0.22) had up to twice the strain less.
    """
    low, high = (1.0 + end for end in error)
    return ErrorRange(low / (1.0 + LESS * strain) - 1.0, high * (1.0 + strain) - 1.0)
