"""A single blade between a clamp and its tip: pushed, guided or turned."""

from typing import ClassVar, Literal

from flexcli.formulas import single_blade as blade
from flexcli.formulas.card import Card
from flexcli.formulas.hinge_shift import BLADE_CARDS, blade_shift
from flexcli.formulas.quantity import Computed
from flexcli.formulas.stage import shortening
from flexcli.mechanics.layout import Body, Layout, Point
from flexcli.numerics.rows import number
from flexcli.parts.bending import Bending, WideBlades
from flexcli.parts.bending.arc import Arc
from flexcli.parts.bending.straight import Straight
from flexcli.parts.bending.wide import wide_cantilever, wide_guided, wide_moment
from flexcli.parts.elastic import Elastic
from flexcli.parts.geometries.base import GROUND, MOVING, Blade, Critical, Held
from flexcli.parts.geometries.blades import BladeGeometry
from flexcli.parts.geometries.joint_buckling import row_critical
from flexcli.parts.geometries.parallel import (
    SagsAlongStroke,
    force_share,
    is_push,
    straight_share,
)

__all__ = ["Cantilever", "GuidedBlade", "MomentBlade"]


class _SingleBlade(BladeGeometry):
    source: ClassVar[str] = "Henein & Thalmann, Dimensioning of flexure joints"

    @property
    def blade_count(self) -> int:
        """Return 1."""
        return 1

    def axial_share(self, direction: float) -> float:
        """Return the axial force in the blade per force on its tip [-]."""
        return force_share(direction, 1)

    def root(self, sizes: Blade) -> Computed:
        """Return where the clamp is on x [m]."""
        return 0.0

    def joint_critical(
        self, elastic: Elastic, sizes: Blade, ends: str, direction: float
    ) -> Critical:
        """Return the force along the blade at which it buckles [N]."""
        push, guided = is_push(direction, "blade"), self.is_guided
        return row_critical(elastic, sizes, (0.0,), 1, ends, push=push, guided=guided)

    def layout(self, elastic: Elastic, sizes: Blade) -> Layout:
        """Return the blade along x; the moving body's point is its tip."""
        root, tip = (self.root(sizes), 0.0), (self.root(sizes) + sizes.l, 0.0)
        strip = self.strip("blade", (GROUND, MOVING), (root, tip), sizes)
        return Layout((Body(MOVING, tip),), (strip,), elastic.E, elastic.shear)

    def indicators(self, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the quantities of its validity: shape and stroke."""
        stroke = {"theta": travel} if self.motion == "rotation" else {"x/l": travel / sizes.l}
        return {**self.ratios(sizes), **stroke}


class Cantilever(SagsAlongStroke, _SingleBlade):
    """A clamped blade that a force moves at its free tip."""

    motion: ClassVar[str] = "translation"
    cards: ClassVar[tuple[Card, ...]] = blade.FORCE_CARDS
    turns_freely: ClassVar[bool] = True
    held_by_one_blade: ClassVar[bool] = True

    kind: Literal["cantilever"]

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the stiffness of the tip [N/m]."""
        return blade.force_stiffness(E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the bending stress at the clamp [Pa]."""
        h, l, _ = self.blade(sizes)
        return {"clamp": blade.force_stress(E=elastic.E, h=h, l=l, x=travel, s=0.0)}

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of half a guided blade."""
        h, l, _ = map(number, self.blade(sizes))
        return Straight(h=h, l=l, travel=travel, halves=2)

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades | None:
        """Return the plate factors of a blade bent by a force."""
        return wide_cantilever(sizes, nu)

    def s_bending_share(self, sizes: Blade) -> float:
        """Return ¼: a cantilever softens by Φ/4, Φ that of a blade clamped at both ends."""
        return 0.25

    def parasitic_shift(self, sizes: Blade, travel: float) -> Computed:
        """Return the motion of the tip towards the clamp, 3x²/(5l) as of a guided one [m]."""
        return shortening(l=sizes.l, x=travel)


class GuidedBlade(_SingleBlade):
    """A clamped blade whose tip moves across it without turning."""

    motion: ClassVar[str] = "translation"
    cards: ClassVar[tuple[Card, ...]] = blade.GUIDED_CARDS
    held_by_one_blade: ClassVar[bool] = True

    kind: Literal["guided-blade"]

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the stiffness of the tip [N/m]."""
        return blade.guided_stiffness(E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the bending stress, equal and opposite at the two ends [Pa]."""
        h, l, _ = self.blade(sizes)
        return {"both ends": blade.guided_stress(E=elastic.E, h=h, l=l, x=travel, s=0.0)}

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of a guided blade."""
        h, l, _ = map(number, self.blade(sizes))
        return Straight(h=h, l=l, travel=travel)

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades | None:
        """Return the plate factors of a guided blade."""
        return wide_guided(sizes, nu)

    def shift_change(self, sizes: Blade, pure: float, bent: float) -> float:
        """Return the change of shortening of a blade bent to an S."""
        return bent

    def s_bending_share(self, sizes: Blade) -> float:
        """Return 1: the blade bends in an S alone."""
        return 1.0

    def parasitic_shift(self, sizes: Blade, travel: float) -> Computed:
        """Return the motion of the tip towards the clamp [m]."""
        return shortening(l=sizes.l, x=travel)

    def held(self, travel: float) -> Held:
        """Return a hold that keeps the tip from turning."""
        return None, travel, 0.0


class MomentBlade(_SingleBlade):
    """A clamped blade that a moment turns at its free tip; its centre is the blade's middle."""

    motion: ClassVar[str] = "rotation"
    cards: ClassVar[tuple[Card, ...]] = (*blade.MOMENT_CARDS, *BLADE_CARDS)
    held_by_one_blade: ClassVar[bool] = True

    kind: Literal["moment-blade"]

    def stiffness(self, elastic: Elastic, sizes: Blade) -> Computed:
        """Return the rotational stiffness of the tip [N·m/rad]."""
        return blade.moment_stiffness(E=elastic.E, h=sizes.h, l=sizes.l, b=sizes.b)

    def end_stresses(self, elastic: Elastic, sizes: Blade, travel: float) -> dict[str, Computed]:
        """Return the bending stress, the same all along [Pa]."""
        h, l, _ = self.blade(sizes)
        return {"all along": blade.moment_stress(E=elastic.E, h=h, l=l, theta=travel)}

    def bending(self, elastic: Elastic, sizes: Blade, travel: float) -> Bending:
        """Return the bending of an arc."""
        return Arc(theta=travel)

    def wide_blades(self, sizes: Blade, nu: float) -> WideBlades | None:
        """Return the plate factors of a blade bent by a moment."""
        return wide_moment(sizes, nu)

    def shift_change(self, sizes: Blade, pure: float, bent: float) -> float:
        """Return the change of l/4 less the shortening l/6 of an arc that starts at the clamp."""
        return -pure / 2.0

    def root(self, sizes: Blade) -> Computed:
        """Return the place of the clamp: the tip turns about the blade's middle, the origin [m]."""
        return -sizes.l / 2.0

    def payload_point(self, moving: Point) -> Point:
        """Return the middle of the blade."""
        return 0.0, 0.0

    def axial_share(self, direction: float) -> float:
        """Return 1 for a force along the blade."""
        return straight_share(direction, "blade")

    def parasitic_shift(self, sizes: Blade, travel: float) -> Computed:
        """Return the shift of the centre, the middle of the blade: away from the clamp [m]."""
        return -blade_shift(l=sizes.l, theta=travel)
