"""An effect: its indicator, and the change of each reported number without it."""

from abc import ABC, abstractmethod
from collections.abc import Mapping
from math import inf
from typing import TYPE_CHECKING, ClassVar, NamedTuple

from flexcli.numerics.rows import larger, number
from flexcli.parts.bending import Bending, Change, Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries import Blade, Geometry, NotAvailable, Sizes
from flexcli.parts.material import Material
from flexcli.parts.mechanisms import Mechanism
from flexcli.parts.scene import Scene
from flexcli.results import QuantityKind

if TYPE_CHECKING:
    from flexcli.parts.stops import Stops

__all__ = ["Effect", "Indicator", "ModelEffect", "SceneEffect", "Setting"]


class Setting(NamedTuple):
    """The sized or given design that effects are estimated on."""

    material: Material
    geometry: Geometry
    mechanism: Mechanism | None
    sizes: Sizes
    scenes: tuple[Scene, ...]
    stops: "Stops | None" = None
    supports: bool = False
    """Whether the stiffness of the joint off its motion is asked for."""

    @property
    def blade(self) -> Blade | None:
        """Return the slender blade that bends, where there is one of constant thickness."""
        return self.geometry.blade(self.sizes)

    @property
    def sags_along_stroke(self) -> bool:
        """Return whether every acceleration bends the joint as its stroke does."""
        along = self.geometry.sags_along_stroke
        return all(not scene.sags or along(scene.axis) for scene in self.scenes)

    @property
    def bending(self) -> Bending:
        """Return how the blades bend at the largest travel of any case."""
        return _LAST.of(self)

    @property
    def slenderness(self) -> float | None:
        """Return thickness over length of the stockiest blade [-]."""
        return self.geometry.slenderness(self.sizes)

    @property
    def poisson_ratios(self) -> tuple[float, float]:
        """Return the range of Poisson's ratio: 0 to ½ where the material gives none."""
        given = self.material.poisson_ratio
        return (given.value, given.value) if given is not None else (0.0, 0.5)

    @property
    def poisson_bound(self) -> float:
        """Return Poisson's ratio, or its upper limit ½ where the material gives none."""
        return self.material.elastic.most_nu

    @property
    def largest_travel(self) -> float:
        """Return the largest travel of the joint in any case, by loads along it too [rad or m]."""
        return max((self._reach(scene) for scene in self.scenes), default=0.0)

    def _reach(self, scene: Scene) -> float:
        stroke = scene.travel + scene.mean_travel
        if scene.push == 0.0:
            return stroke
        try:
            stiffness = number(self.geometry.stiffness(self.material.elastic, self.sizes))
        except NotAvailable:
            return stroke
        return stroke + scene.push / stiffness


class _Last:
    """The last bending asked for, kept because every effect of a case needs the same."""

    def __init__(self) -> None:
        self.known: tuple[Geometry, tuple[Elastic, Sizes, float], Bending] | None = None

    def of(self, setting: Setting) -> Bending:
        """Return the bending of a setting."""
        asked = setting.material.elastic, setting.sizes, setting.largest_travel
        last = self.known
        if last is None or last[0] is not setting.geometry or last[1] != asked:
            last = setting.geometry, asked, setting.geometry.bending(*asked)
            self.known = last
        return last[2]


_LAST = _Last()


class Indicator(NamedTuple):
    """A dimensionless number for the size of an effect, and its text."""

    value: float
    text: str


class Effect(ABC):
    """One effect; a stateless object, listed in the tuple of this package."""

    name: ClassVar[EffectName]
    excludes: ClassVar[tuple[str, ...]] = ()
    """Keys of a case that ``effects: {name: off}`` takes out of it."""

    @property
    def key(self) -> str:
        """Return its name in a spec."""
        return self.name.key

    @abstractmethod
    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the indicator, or None where the design cannot have the effect."""


class SceneEffect(Effect):
    """An effect of the scene: it is on exactly when a case, or the design, states it."""

    shuts_out: ClassVar[frozenset[EffectName]] = frozenset()
    """Effects of the blades that its solver cannot include at the same time."""

    def estimates(self, setting: Setting) -> Mapping[str, float]:
        """Return the relative change of each number without it, where it can be estimated."""
        return {}


class ModelEffect(Effect):
    """An effect that a model of the blades includes or leaves out."""

    cost: ClassVar[float] = 1.0
    """Cost of correcting a closed form by it, in closed forms."""
    needs: ClassVar[str] = ""
    """The property of the material without which no model can carry it."""
    is_whole: ClassVar[bool] = False
    """Whether its bounds cover its whole change, not just leading terms."""
    grows_with_travel: ClassVar[bool] = False
    """Whether what it changes of a stress grows with the travel."""
    spares_loads: ClassVar[bool] = False
    """Whether what it corrects of a stress is that of the travel alone, not of loads beside it."""
    spans_what_it_needs: ClassVar[bool] = False
    """Whether its changes cover all values of a property that is not given."""
    only: ClassVar[frozenset[QuantityKind]] = frozenset(QuantityKind)
    """The numbers that it may change; the changes of others are not computed, to save time."""

    @abstractmethod
    def changes(self, setting: Setting) -> Changes:
        """Return the changes; frequency, and sag along a stroke, follow from the stiffness."""

    def lacks(self, setting: Setting) -> str:
        """Return the property that is needed and not given, or an empty text."""
        missing = self.needs and getattr(setting.material, self.needs) is None
        return f"material.{self.needs}" if missing else ""

    def all_changes(self, setting: Setting) -> dict[str, Change]:
        """Return the changes of stiffness, stress, shift, buckling, and what follows from them."""
        found = dict(self.changes(setting))
        stiffness = found.get("stiffness")
        if stiffness is not None:
            value, bound, error, sign, other = stiffness
            half = None if value is None else (1.0 + value) ** 0.5 - 1.0
            inverse = None if value is None else 1.0 / (1.0 + value) - 1.0
            found.setdefault("frequency", Change(half, bound / 2.0, error / 2.0, sign, other / 2.0))
            if setting.sags_along_stroke:
                found.setdefault("sag", Change(inverse, _grown(bound, bound), error, -sign))
        return found

    def estimates(self, setting: Setting) -> Mapping[str, float]:
        """Return the largest relative change of each number without it.

        The bound of the leading terms starts a geometric series: each further order is smaller by
        the bound itself, or by the ratio of the bending.
        """
        if self.is_whole:
            return {name: change.bound for name, change in self.all_changes(setting).items()}
        ratio = setting.bending.ratio
        return {
            name: _grown(change.bound, larger(change.bound, ratio))
            for name, change in self.all_changes(setting).items()
        }


def _grown(bound: float, ratio: float) -> float:
    """Return the sum of a geometric series, infinite where it diverges."""
    return bound / (1.0 - ratio) if ratio < 1.0 else inf if bound else 0.0
