"""A model with corrections for effects that it does not carry itself: each by its formula, once."""

from collections.abc import Sequence

from flexcli.formulas.quantity import Quantity
from flexcli.parts.effects import ModelEffect, Setting
from flexcli.parts.geometries.base import Critical
from flexcli.parts.requirements import Answers, Ask, EndStress

__all__ = ["Corrected"]


class Corrected(Answers):
    """The answers of a model times one factor an effect."""

    def __init__(self, inner: Answers, effects: Sequence[ModelEffect]) -> None:
        twice = [e.name for e in effects if e.name in inner.covers | inner.always]
        if twice:
            raise ValueError(f"the {inner.model} model carries {', '.join(twice)} itself")
        self.inner = inner
        self.effects = tuple(effects)
        self.model = f"{inner.model} with {', '.join(e.name for e in effects)}"

    def frequency_factor(self, ask: Ask) -> float:
        """Return what the effects change beside the stiffness."""
        factor, setting = self.inner.frequency_factor(ask), _setting(ask)
        for effect in self.effects:
            change = effect.changes(setting).get("frequency")
            factor *= 1.0 + (change.value or 0.0) if change is not None else 1.0
        return factor

    def stiffness(self, ask: Ask) -> Quantity:
        """Return the stiffness along the motion [N·m/rad or N/m]."""
        return self.inner.stiffness(ask) * self._factor(ask, "stiffness")

    def sag_stiffness(self, ask: Ask) -> Quantity:
        """Return the stiffness along the case's acceleration [N/m]."""
        return self.inner.sag_stiffness(ask) / self._factor(ask, "sag")

    def parasitic_shift(self, ask: Ask) -> Quantity:
        """Return the signed shift at the end of the case's stroke [m]."""
        return self.inner.parasitic_shift(ask) * self._factor(ask, "shift")

    def stresses(self, ask: Ask) -> tuple[str, list[EndStress]]:
        """Return the stresses, those of the stroke corrected."""
        name, found = self.inner.stresses(ask)
        factor = self._factor(ask, "stress") if ask.scene.bends else 1.0
        return name, [
            s._replace(amplitude=s.amplitude * factor, mean=s.mean * factor) for s in found
        ]

    def critical(self, ask: Ask) -> tuple[Critical, ...]:
        """Return the critical forces, those across the thickness corrected."""
        factor = self._factor(ask, "buckling")
        return tuple(
            c if c.way == "across the width" else c._replace(force=c.force * factor)
            for c in self.inner.critical(ask)
        )

    def _factor(self, ask: Ask, name: str) -> float:
        factor, setting = 1.0, _setting(ask)
        for effect in self.effects:
            change = effect.all_changes(setting).get(name)
            factor *= 1.0 + (change.value or 0.0) if change is not None else 1.0
        return factor


def _setting(ask: Ask) -> Setting:
    return Setting(ask.material, ask.geometry, ask.mechanism, ask.sizes, (ask.scene,))
