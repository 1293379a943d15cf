"""Stress of a model with corrections: what of it a stroke makes, and what else does."""

from collections.abc import Iterator, Sequence
from math import inf

import numpy as np

from flexcli.engine.joint_models.corrections import Corrections, is_told, setting_of
from flexcli.formulas.amplified import amplified, relieved
from flexcli.numerics.rows import Number, isfinite, larger, number, smaller
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects import Change
from flexcli.parts.effects.plate import change_by_loads, pulled, stretched, widest
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, EndStress
from flexcli.parts.scene import LoadKind
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["CorrectedStress"]

LEAST_STRESS = LEAST_STIFFNESS = 1e-300
"""Stress and stiffness below which there is none [Pa, N/m or N·m/rad]."""

PUSHED = 2.0
"""Times the share that a load along the stroke has in a stress by which it may be off. That share
was at most 1.13 times what is told of it (exact beams with the load and without, of 676 random
pivots, stages and single blades, h/l 0.002 to 0.05, strokes to 0.16 rad or 0.13 l)."""


class CorrectedStress:
    """Stresses of the model that is corrected, and what of them is not the stroke's."""

    def __init__(self, by: Corrections) -> None:
        self.by = by

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stresses, those of the stroke corrected.

        A wide blade resists a curvature more than a beam; under a force along the stroke it is
        curved less, and its moments and stresses are those of the force. That of a force along it
        is its largest across the width.
        """
        name, found = self.by.inner.stresses(ask)
        if self.by.widening(ask) is not None:
            along = stretched(setting_of(ask)).value
            found = [s._replace(axial=s.axial * along) for s in found]
        if not ask.scene.moves:
            factor, _ = self._of_push(ask)
            return name, [s._replace(mean=s.mean * factor * self._warm(ask, s)[0]) for s in found]
        of_mean = bool(ask.scene.mean_travel) or not ask.scene.push
        whole, corrected = self.by.factor(ask, QuantityKind.STRESS), []
        for s in found:
            factor = whole * self._of_wide(ask, s)[0]
            mean = s.mean * factor if of_mean else s.mean
            corrected.append(s._replace(amplitude=s.amplitude * factor, mean=mean))
        return name, corrected

    def peaks_above(self, ask: Ask) -> Number:
        """Return by what share the peaks may be less than their factors make the largest stress."""
        bent, along = map(number, ask.geometry.peaks_above(ask.sizes))
        try:
            found = self.by.inner.stresses(ask)[1]
        except NotAvailable:
            return larger(bent, along)
        if any(s.is_at_face and s.pulled is None for s in found):
            return larger(bent, along)
        stretches = (larger(number(abs(s.axial)), number(abs(s.pulled or 0.0))) for s in found)
        largest = larger(LEAST_STRESS, *(number(abs(s.largest)) for s in found))
        share = smaller(1.0, larger(0.0, *stretches) / largest)
        return bent + larger(along - bent, 0.0) * share

    def _of_push(self, ask: Ask) -> tuple[Number, Number]:
        """Return the factor of the stress by a load along the stroke, and what wide blades leave.

        It moves the joint by its force over the stiffness, and both are corrected. That of blades
        which a case keeps from turning is the force's.
        """
        factor: Number = 1.0
        wide: Number = 0.0
        scene = ask.scene
        if scene.push == 0.0 or not setting_of(ask).largest_travel:
            return factor, wide
        for effect in self.by.of_stress(ask):
            found = self.by.changes(ask, effect)
            both = found.get(QuantityKind.STRESS), found.get(QuantityKind.STIFFNESS)
            stress, stiffness = (None if each is None else each.value for each in both)
            if stress is None or stiffness is None:
                continue
            ratio = (1.0 + stress) / (1.0 + stiffness)
            if effect.name is EffectName.SHEAR:
                factor *= ratio
            elif effect.name is EffectName.PLATE_WIDENING and not scene.keeps_turn:
                wide = abs(ratio - 1.0)
        return factor, wide

    def _of_wide(self, ask: Ask, stress: EndStress) -> tuple[Number, ErrorRange]:
        """Return what the force along a wide blade changes of its factor, and the range left.

        Nothing is changed where the factor corrects nothing; nor where a force makes the travel.
        """
        wide, effect = stress.wide, self.by.widening(ask)
        if wide is None or effect is None:
            return 1.0, ErrorRange(0.0, 0.0)
        change = self.by.changes(ask, effect).get(QuantityKind.STRESS)
        plain = 1.0 + (change.value or 0.0) if change is not None else 1.0
        low, high = (each / plain for each in wide.of(plain))
        if not isfinite(high):
            return 1.0, ErrorRange(-1.0, inf)
        loose = pulled(setting_of(ask)) * wide.axial
        if change is None or change.value is None or ask.scene.push:
            return 1.0, ErrorRange(smaller(low, 1.0) - 1.0 - loose, larger(high, 1.0) - 1.0 + loose)
        value = (low + high) / 2.0
        return value, ErrorRange(low / value - 1.0 - loose, high / value - 1.0 + loose)

    def _warm(self, ask: Ask, stress: EndStress) -> tuple[Number, ErrorRange]:
        """Return the factor of what a temperature bends a wide blade by, and the range left.

        Loads beside it, without a stroke, have the moments of beams.
        """
        wide, effect = stress.wide, self.by.widening(ask)
        if ask.scene.temperature is None or wide is None or effect is None:
            return 1.0, ErrorRange(0.0, 0.0)
        low, high = wide.low, wide.high
        if not is_told(effect, setting_of(ask)) or ask.scene.loads != {LoadKind.TEMPERATURE}:
            low = smaller(low, 1.0)
        value = (low + high) / 2.0
        if not isfinite(value):
            return 1.0, ErrorRange(-1.0, inf)
        return value, ErrorRange(low / value - 1.0, high / value - 1.0)

    def beside_stroke(self, ask: Ask) -> ErrorRange | None:
        """Return what of a stress is not the stroke's: of a force beside it, of blades' weight."""
        scene, found = ask.scene, ErrorRange(0.0, 0.0)
        if scene.moves and scene.has_plane:
            found += self._of_nearer_end(ask)
        if scene.moves:
            found += self._of_forces(ask)
        if scene.is_loaded:
            bent = self._of_bent(ask)
            if bent is None:
                return None
            found += self._of_loads(ask) + self._of_pulled(ask) + bent
        if scene.temperature is not None:
            found += self._of_warmth(ask)
        if scene.push:
            factor, wide = self._of_push(ask)
            pushed = self._of_pushed_travel(ask) + ErrorRange(-wide, wide)
            if scene.moves:
                whole = self.by.factor(ask, QuantityKind.STRESS)
                of_mean = whole if scene.mean_travel else 1.0
                # what is not raised of a mean may be the stroke's own
                more = self._share_beside(ask) * (whole / of_mean - 1.0)
                found += ErrorRange(smaller(more, 0.0), larger(more, 0.0))
                share = self._pushed_share(ask)
                low, high = (share * each for each in pushed + _as_much(factor / of_mean))
                pushed = ErrorRange(low, high)
            elif scene.beyond or scene.blade_force:  # other loads bend it besides
                pushed += _as_much(1.0 / factor)
            found += pushed
        if not scene.is_accelerated:
            return found
        if ask.geometry.has_limbs(ask.material.elastic, ask.sizes):
            return None  # nobody knows what they weigh
        if self.by.inner.weighs_blades and ask.material.density is not None:
            return found
        from flexcli.engine.joint_models.blade_weight import left_share

        try:
            more = left_share(ask, self.by.inner.stresses(ask)[1])
        except NotAvailable:
            return None
        return found + ErrorRange(-more, more)

    def _of_bent(self, ask: Ask) -> ErrorRange | None:
        """Return what blades that loads and heat bend leave, which are as stiff as they are.

        What a model has in its stress it has in what bends it. Under loads along blades they are as
        stiff as what buckles them is large, too.
        """
        inner = self.by.inner
        try:
            bent = inner.bent(ask)
        except NotAvailable:  # a little more of them buckles it
            return None
        if not np.any(bent.share):
            return ErrorRange(0.0, 0.0)
        carried = inner.carries(ask, QuantityKind.STRESS)
        softer = self.by.unlike(ask, carried)
        if softer is None:
            return None
        stiffer = softer
        if ask.scene.blade_force:
            bears = self.by.bears(ask, carried)
            if bears is None:
                return None
            softer = larger(softer, 1.0 / bears[0] - 1.0)
            stiffer = larger(stiffer, smaller(bears[1] - 1.0, 1.0))
        low, high = (each + bent.unlike for each in (stiffer, softer))
        return ErrorRange(-relieved(bent.share, low), amplified(bent.share, high))

    def _of_nearer_end(self, ask: Ask) -> ErrorRange:
        """Return what corrections that grow with the travel do not do at its nearer end.

        They are of the end at which the stress is largest. The amplitude is between both ends: a
        term that is of the square of the travel, as the two ways of an uneven joint, cancels there.
        Of ends that are alike nothing is less; bars in torsion have no two ways.
        """
        low, high, is_even = 1.0, 1.0, not ask.scene.mean_travel
        for change in self._growing(ask):
            factor = 1.0 + (change.value or 0.0)
            low /= larger(factor, 1.0)
            high /= 1.0 if is_even else smaller(factor, 1.0)
        return ErrorRange(low - 1.0, high - 1.0)

    def _of_loads(self, ask: Ask) -> ErrorRange:
        """Return what is raised too much of a stress that is in part of loads beside the stroke.

        Of loads is a mean that is not that of the stroke.
        """
        more = 1.0
        for effect in self.by.of_stress(ask):
            change = self.by.changes(ask, effect).get(QuantityKind.STRESS)
            if effect.spares_loads and change is not None:
                more *= 1.0 + larger(change.value or 0.0, 0.0)
        if more == 1.0:
            return ErrorRange(0.0, 0.0)
        return ErrorRange((1.0 / more - 1.0) * self._share_beside(ask), 0.0)

    def _share_beside(self, ask: Ask) -> Number:
        """Return the largest share of a stress that is a mean which the stroke does not make."""
        scene, shares = ask.scene, [0.0]
        own = scene.mean_travel / scene.travel if scene.travel else 0.0
        for stress in self.by.inner.stresses(ask)[1]:
            size, mean = number(abs(stress.amplitude)), number(abs(stress.mean))
            beside = abs(mean - own * size)
            shares.append(beside / larger(size + larger(mean, beside), LEAST_STRESS))
        return larger(shares)

    def _pushed_share(self, ask: Ask) -> Number:
        """Return the share of the largest stress that may be of a load along the stroke.

        By how far it moves the joint and by the mean beside that of the stroke, which large
        travels and other loads may hide or be. A design nearby is moved as far.
        """
        scene, about = ask.scene, ask if ask.near is None else ask.near._replace(scene=ask.scene)
        moved = scene.push / larger(number(self.by.stiffness(about)), LEAST_STIFFNESS)
        share = larger(moved / (moved + scene.travel), self._share_beside(ask))
        return smaller(PUSHED * share, 1.0)

    def _of_pulled(self, ask: Ask) -> ErrorRange:
        """Return what wide blades may have of the forces along them.

        Without a stroke what widens has no share in that beside it: of the largest stress, that of
        these forces is as unsure as they are, and the rest as what widens.
        """
        widening, setting = self.by.widening(ask), setting_of(ask)
        if widening is None or not (ask.scene.moves or is_told(widening, setting)):
            return ErrorRange(0.0, 0.0)
        shares, along, bent, largest = [0.0], 0.0, 0.0, LEAST_STRESS
        for stress in self.stresses(ask)[1]:
            axial = number(abs(stress.axial))
            rest = number(abs(stress.amplitude)) + number(abs(stress.mean))
            shares.append(axial / larger(rest + axial, LEAST_STRESS))
            along, bent = larger(along, axial), larger(bent, rest)
            largest = larger(largest, number(abs(stress.largest)))
        value, low, high, _ = stretched(setting)
        share = larger(shares) if ask.scene.moves else along / largest
        off = 0.0 if ask.scene.moves else pulled(setting) * bent / largest
        low, high = (share * (each / value - 1.0) for each in (low, high))
        return ErrorRange(low - off, high + off)

    def _of_forces(self, ask: Ask) -> ErrorRange:
        """Return what of the largest stress forces along wide blades leave, see plates.

        Each blade's stress has its own range; one that is not the largest may become it.
        """
        effect = self.by.widening(ask)
        if effect is None:
            return ErrorRange(0.0, 0.0)
        found = list[tuple[Number, ErrorRange]]()
        for s in self.stresses(ask)[1]:
            if s.wide is None:
                return change_by_loads(setting_of(ask))
            found.append((number(abs(s.largest)), self._of_wide(ask, s)[1]))
        return _of_largest(found)

    def _of_warmth(self, ask: Ask) -> ErrorRange:
        """Return what wide blades leave of a stress by what a temperature moves their ends.

        Beside a stroke it has the factor of that, and may have one of any shape.
        """
        effect = self.by.widening(ask)
        if effect is None:
            return ErrorRange(0.0, 0.0)
        if ask.scene.moves:
            change = self.by.changes(ask, effect).get(QuantityKind.STRESS)
            own = 1.0 + ((change.value or 0.0) if change is not None else 0.0)
            share, most = self._share_beside(ask), larger(widest(setting_of(ask)) / own, 1.0)
            return ErrorRange(share * (1.0 / own - 1.0), share * (most - 1.0))
        plain, found = self.by.inner.stresses(ask)[1], list[tuple[Number, ErrorRange]]()
        for s, as_beam in zip(self.stresses(ask)[1], plain, strict=True):
            bent, left = number(abs(s.mean)), self._warm(ask, as_beam)[1]
            share = bent / larger(bent + number(abs(s.axial)), LEAST_STRESS)
            found.append((number(abs(s.largest)), ErrorRange(share * left.low, share * left.high)))
        return _of_largest(found) + ErrorRange(0.0, self._of_stretch(plain))

    def _of_stretch(self, stresses: Sequence[EndStress]) -> Number:
        """Return how much more wide blades may have of what a temperature stretches [-]."""
        return larger(
            0.0, *(s.wide.axial * (s.wide.kept - 1.0) for s in stresses if s.wide is not None)
        )

    def _of_pushed_travel(self, ask: Ask) -> ErrorRange:
        """Return what a travel by a force may change of its stress, either way.

        Corrections are of a travel that is given; a force that moves the joint as far has other
        moments by as much.
        """
        found = ErrorRange(0.0, 0.0)
        for change in self._growing(ask):
            found += ErrorRange(-abs(change.value or 0.0), abs(change.value or 0.0))
        return found

    def _growing(self, ask: Ask) -> Iterator[Change]:
        """Yield what effects that grow with the travel correct of a stress."""
        for effect in self.by.of_stress(ask):
            change = self.by.changes(ask, effect).get(QuantityKind.STRESS)
            if effect.grows_with_travel and change is not None:
                yield change


def _as_much(other: Number) -> ErrorRange:
    """Return the range of a number of which a part, or all, is another factor times as much."""
    return ErrorRange(smaller(other, 1.0) - 1.0, larger(other, 1.0) - 1.0)


def _of_largest(found: Sequence[tuple[Number, ErrorRange]]) -> ErrorRange:
    """Return the range of the largest of several stresses, each with its own.

    One that is not the largest may become it.
    """
    sizes = larger(0.0, *(size for size, _ in found))
    if sizes == 0.0:
        return ErrorRange(0.0, 0.0)
    least = larger(0.0, *(size * (1.0 + left.low) for size, left in found))
    most = larger(0.0, *(size * (1.0 + left.high) for size, left in found))
    return ErrorRange(smaller(least / sizes - 1.0, 0.0), larger(most / sizes - 1.0, 0.0))
