"""Efforts of a drive by a model with corrections, and what loads make of them."""

from collections.abc import Sequence

from flexcli.engine.joint_models.corrections import Corrections, setting_of
from flexcli.numerics.rows import larger, number, smaller
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.plate import flattest
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.requirements import Ask, DriveEffort
from flexcli.parts.scene import Scene
from flexcli.results import ErrorRange, QuantityKind

__all__ = ["CorrectedEffort"]

SHORTENED = 0.35
"""By how much more a wide blade shortens than its beam, of what a plate is stiffer at most: an arc
up to 0.2 of it, an S beside its chord 0.32, by ``plate_shortening``."""

NOTHING_BORNE = 0.0, 0.0, 0.0
"""What no loads make of an effort, by beams, by a joint as stiff, and its error."""


class CorrectedEffort:
    """Efforts of the model that is corrected at the ends of a stroke."""

    def __init__(self, by: Corrections) -> None:
        self.by = by

    def effort(self, ask: Ask) -> tuple[DriveEffort, ...]:
        """Return the efforts at the ends of the stroke, corrected as the stiffness is.

        What beside the stiffness at rest a large travel makes of an effort may be corrected or not;
        it bends wide blades otherwise, up to as flat as plates are. Curvature that flattens them
        makes more of it, as of their moments. What loads make of it is that of a joint as stiff.
        Errors of the stiffness are of its own share, however small the whole is.
        """
        factor = self.by.factor(ask, QuantityKind.STIFFNESS)
        widens = self.by.widening(ask, QuantityKind.STIFFNESS) is not None
        most = larger(factor, flattest(setting_of(ask)) if widens else 1.0)
        stiffened, warm = factor != 1.0 or most != 1.0, ask.scene.temperature is not None
        cold = ask._replace(scene=ask.scene.at_assembly())
        plain = float(self.by.inner.stiffness(cold)) if stiffened or warm else 0.0
        other, flat = larger(abs(factor - 1.0), most / factor - 1.0), self._flattened(ask)
        given = self.by.inner.effort(ask)
        borne = self._borne(ask, given, factor, most) if stiffened else [NOTHING_BORNE] * len(given)
        found = []
        for (travel, effort, known, load), (beam, of_loads, unsure) in zip(
            given, borne, strict=True
        ):
            own = factor * (effort - beam)
            whole = own + of_loads
            error = None if known is None else self.by.left(ask, QuantityKind.STIFFNESS, known)
            if error is not None and whole != 0.0:
                share = larger(abs(own / whole), 1.0)
                if warm:  # which presses and pulls no less if blades are stiffer
                    share = larger(share, abs(factor * plain * travel / whole))
                beside = abs(own - factor * plain * abs(travel)) * other if stiffened else 0.0
                off = (beside + unsure) / abs(whole)
                error = ErrorRange(share * error.low - off, share * (error.high + flat) + off)
            found.append(DriveEffort(travel, whole, error, load))
        return tuple(found)

    def _borne(
        self, ask: Ask, given: Sequence[DriveEffort], factor: float, most: float
    ) -> list[tuple[float, float, float]]:
        """Return what loads make of the efforts: by beams, by a joint as stiff, and its error.

        A joint so many times as stiff under its loads is the joint under so much less. Of what
        bends otherwise nobody knows more than that it is between beams and flat plates. The error
        has what wide blades shorten otherwise as they bend, and all of what other effects do.
        """
        scene = ask.scene
        if not scene.is_loaded or scene.temperature is not None:
            return [NOTHING_BORNE] * len(given)
        alone = self._efforts(ask, scene.without_loads())
        try:
            under = [(k, self._efforts(ask, scene.with_loads(1.0 / k))) for k in (factor, most)]
        except NotAvailable:  # softer, it buckles
            return [NOTHING_BORNE] * len(given)
        of_loads = [
            [k * (effort - own) for effort, own in zip(efforts, alone, strict=True)]
            for k, efforts in ((1.0, [each.effort for each in given]), *under)
        ]
        off, found = self._shortened(ask, factor), list[tuple[float, float, float]]()
        for beam, value, flat in zip(*of_loads, strict=True):
            unsure = larger(abs(beam - value), abs(flat - value)) + off * abs(value)
            found.append((beam, value, number(unsure)))
        return found

    def _efforts(self, ask: Ask, scene: Scene) -> list[float]:
        """Return the efforts of beams in another scene."""
        return [each.effort for each in self.by.inner.effort(ask._replace(scene=scene))]

    def _shortened(self, ask: Ask, factor: float) -> float:
        """Return by how much the shortening of bent blades may differ from that of beams [-].

        A stage of its own form shifts by that; of blades in any shape it is that of plates at most.
        """
        effect = self.by.widening(ask, QuantityKind.STIFFNESS)
        if effect is None:
            return abs(factor - 1.0)
        found = self.by.changes(ask, effect)
        widened, shift = found.get(QuantityKind.STIFFNESS), found.get(QuantityKind.SHIFT)
        most = SHORTENED * (flattest(setting_of(ask)) - 1.0)
        if shift is not None and ask.geometry.motion == "translation" and ask.geometry.closed_forms:
            most = smaller(most, shift.bound)
        own = 1.0 + ((widened.value if widened is not None else None) or 0.0)
        return most + abs(factor / own - 1.0)

    def _flattened(self, ask: Ask) -> float:
        """Return by how much curvature at most raises the moments of a travel [-]."""
        for effect in (*self.by.effects, *self.by.omitted):
            if effect.name is EffectName.ANTICLASTIC and effect.indicator(setting_of(ask)):
                change = self.by.changes(ask, effect).get(QuantityKind.STRESS)
                return 0.0 if change is None else change.bound
        return 0.0
