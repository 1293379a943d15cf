"""An effect that the closed forms leave out: its indicator, and what leaving it out may change."""

from abc import ABC, abstractmethod
from typing import NamedTuple

from flexcli.parts.geometries import Blade, Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.parts.scene import Scene
from flexcli.results import EffectRow

__all__ = ["Effect", "Setting"]


class Setting(NamedTuple):
    """The sized or given design that effects are estimated on."""

    material: Material
    geometry: Geometry
    sizes: Sizes
    scenes: tuple[Scene, ...]
    hangs: bool

    @property
    def blade(self) -> Blade | None:
        """Return the slender blade that bends, where there is one of constant thickness."""
        return self.geometry.blade(self.sizes)

    @property
    def poisson_bound(self) -> float:
        """Return Poisson's ratio, or ½, the most it can be, where the material gives none."""
        given = self.material.poisson_ratio
        return given.value if given is not None else 0.5

    @property
    def largest_travel(self) -> float:
        """Return the largest travel of the joint in any case [rad or m]."""
        return max((s.travel + s.mean_travel for s in self.scenes), default=0.0)


class Effect(ABC):
    """One effect; estimates are relative changes of the most affected reported number."""

    name: str

    @abstractmethod
    def row(self, setting: Setting) -> EffectRow | None:
        """Return the effect on this design, or nothing when the design can't have it."""
