"""Warping: clamps keep the ends of a twisted blade flat, which stiffens it in torsion."""

from collections.abc import Iterator, Mapping
from math import dist
from typing import TYPE_CHECKING, ClassVar

from flexcli.numerics.rows import larger, number, sqrt
from flexcli.parts.bending import Change, Changes
from flexcli.parts.effect_names import EffectName
from flexcli.parts.effects.base import Indicator, ModelEffect, Setting
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries import Geometry

if TYPE_CHECKING:
    from flexcli.formulas.guide_support import Stiffening

__all__ = ["Warping"]


class Warping(ModelEffect):
    """Effect of rigid clamps on the torsion of a blade or bar, whose ends they keep flat.

    It is part of the formulas of torsion bars and of blades in space, and corrects none: without it
    they have Saint-Venant's torsion alone.
    """

    name: ClassVar[EffectName] = EffectName.WARPING
    is_whole: ClassVar[bool] = True

    def indicator(self, setting: Setting) -> Indicator | None:
        """Return the relative stiffening of bars in torsion by flat ends, or of a blade."""
        if _twists(setting):
            found = _beside_free(setting) - 1.0
            return Indicator(found, f"torsion of the bars {found:+.0%}")
        if not setting.supports:
            return None
        each = list(_stiffened(setting))
        if not each:
            return None
        rest, bent = (float(max(one)) - 1.0 for one in zip(*each, strict=True))
        text = f"torsion of a blade {rest:+.0%}"
        return Indicator(rest, f"{text}, bent to an S {bent:+.0%}")

    def changes(self, setting: Setting) -> Changes:
        """Return no changes: every number that it affects includes it."""
        names = ["stiffness", "frequency", "stress"] if _twists(setting) else []
        if setting.supports:
            names.append("support")
        return dict.fromkeys(names, Change(0.0, 0.0, 0.0))

    def estimates(self, setting: Setting) -> Mapping[str, float]:
        """Return its change of bars, and its largest change of any support stiffness."""
        found: dict[str, float] = {}
        if _twists(setting):
            stiffer = _beside_free(setting)
            found |= {"stiffness": stiffer - 1.0, "frequency": sqrt(stiffer) - 1.0}
            if setting.largest_travel:
                held, free = (
                    larger(*each.end_stresses(
                        setting.material.elastic, setting.sizes, setting.largest_travel
                    ).values(), 0.0)
                    for each in _whole_and_without(setting)
                )  # fmt: skip
                found["stress"] = abs(number(held / free) - 1.0)
        if setting.supports:
            moves = bool(setting.largest_travel)
            each = [float(held[moves]) for held in _stiffened(setting)]
            found["support"] = max(each, default=1.0) - 1.0
        return found


def _twists(setting: Setting) -> bool:
    """Return whether the joint's own motion twists bars whose ends are kept flat."""
    bars = setting.geometry.omitting(frozenset()).twisting_bars(setting.sizes)
    return bars is not None and bars.restrained


def _whole_and_without(setting: Setting) -> tuple[Geometry, Geometry]:
    off = frozenset({EffectName.WARPING})
    return setting.geometry.omitting(frozenset()), setting.geometry.omitting(off)


def _beside_free(setting: Setting) -> float:
    """Return the stiffness of bars over that of bars whose ends may warp [-]."""
    elastic, sizes = setting.material.elastic, setting.sizes
    stiff, bare = (each.stiffness(elastic, sizes) for each in _whole_and_without(setting))
    return number(stiff / bare)


def _stiffened(setting: Setting) -> Iterator["Stiffening"]:
    """Yield the factors by which held ends stiffen blades: in pure torsion, and bent to an S."""
    from flexcli.formulas.guide_support import twist_stiffening
    from flexcli.formulas.profile import Constant
    from flexcli.mechanics.space.layout import SpaceBlade

    try:
        layout = setting.geometry.space_layout(setting.material.elastic, setting.sizes)
    except NotAvailable:
        return
    for blade in layout.blades:
        if not isinstance(blade, SpaceBlade) or blade.warps:
            continue
        if isinstance(blade.profile, Constant):
            l = dist(blade.start, blade.end)
            E, G, nu = blade.material.E, blade.material.G, blade.material.nu
            sizes = {"h": float(blade.profile.h), "b": blade.b, "l": l}
            yield twist_stiffening(E=E, G=G, poisson_ratio=nu, **sizes)
