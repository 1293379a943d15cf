"""Stress of a warm blade at clamps that keep it from growing, with the stress along it."""

from typing import NamedTuple

from flexcli.formulas.held_at_clamps import (
    HELD_EDGES,
    HELD_MIDDLE_ERROR,
    held_face,
    held_middle,
    held_together,
)
from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Layout
from flexcli.mechanics.space.layout import SpaceLayout, SpaceRod
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.parts.temperature import Temperature, usual_nu

__all__ = ["HeldAtClamps", "held_at_clamps"]

TOWARDS_SIDES = 0.2
"""Share by which what a clamp holds at the faces is larger towards the sides, see ``held_face``.

With it and ``HELD_EDGES`` all of a blade but its edges at the clamp had at most 0.96 of
``HeldAtClamps.most``: sixteen of CalculiX's solids, bent to an S by 0 to 8 times what is held, b/h
1 to 60, b/l 0.05 to 4, ν 0 to 0.48."""


class HeldAtClamps(NamedTuple):
    """What clamps hold of the growth of blades: E times the largest difference of strains [Pa].

    It acts with Poisson's ratio ``nu``, or any of ``nus``. ``stiffer`` is Young's modulus in the
    stiffest direction over that along blades, and ``is_sure`` whether its clamps are known to hold
    so much at least: they are said to be rigid, the blades are of one thickness and not directed.
    """

    size: float
    nu: float
    nus: tuple[float, ...]
    stiffer: float
    is_sure: bool

    @property
    def middle(self) -> float:
        """Return von Mises' stress amid a rigid clamp, of nothing else [Pa]."""
        return self._middle(self.nu)

    def likely(self, along: float, axial: float) -> float:
        """Return von Mises' stress of rigid clamps beside one along blades [Pa].

        It is the larger of that amid a clamp, where blades are stretched but not bent, and that at
        its faces. ``axial`` is what of the stress along is not bending.
        """
        return max(self.middle + axial, self._face(self.nu, along))

    def most(self, along: float, axial: float) -> float:
        """Return no less than von Mises' stress at any clamp, but for its edges [Pa].

        Between the middle and the faces up to half of the bending counts.
        """
        amid, at_face = (self.stiffer * (1.0 + more) for more in (HELD_EDGES, TOWARDS_SIDES))
        return max(
            each
            for nu in self.nus
            for each in (
                self._middle(nu) * amid + (along + axial) / 2.0,
                self._face(nu, along, at_face),
            )
        )

    def least(self, along: float, axial: float) -> float:
        """Return no more than von Mises' stress at clamps that hold what they are known to [Pa].

        ``along`` is the least of the stress along blades, ``axial`` the most of what is not
        bending, of either sign.
        """
        if not self.is_sure:
            return along
        held = min(map(self._middle, self.nus)) * (1.0 - HELD_MIDDLE_ERROR)
        return max(along, held - axial)

    def _middle(self, nu: float) -> float:
        return self.size * float(held_middle(poisson_ratio=nu))

    def _face(self, nu: float, along: float, share: float = 1.0) -> float:
        face, size = held_face(poisson_ratio=nu), self.size * share
        return float(held_together(along=along, across=size * face.across, held=size * face.along))


def held_at_clamps(
    temperature: Temperature, geometry: Geometry, material: Material, sizes: Sizes
) -> HeldAtClamps | None:
    """Return what clamps hold of the growth of blades in a case.

    None where the material does not state its expansion, or the joint has no blades.
    """
    if not all(each.expands for each in (material, *geometry.body_materials.values())):
        return None
    own, at = geometry.drawn(sizes)
    elastic = material.elastic
    layout: Layout | SpaceLayout
    try:
        layout = (own.space_layout if own.in_space else own.layout)(elastic, at)
        held = temperature.held_across(layout, material, geometry.axes, geometry.body_materials)
    except NotAvailable:  # a temperature beyond the points of a material is refused by the case
        return None
    # across its blades a directed material has a Poisson's ratio of its own
    any_nu = elastic._replace(nu=None) if material.is_directed else elastic
    return HeldAtClamps(
        elastic.E * held,
        usual_nu(elastic),
        tuple(each.most_nu for each in any_nu.likely),
        material.stiffest / elastic.E,
        geometry.says_rigid and not material.is_directed and _are_even(layout),
    )


def _are_even(layout: Layout | SpaceLayout) -> bool:
    """Return whether all are blades of one thickness."""
    return all(
        not isinstance(blade, SpaceRod) and isinstance(blade.profile, Constant)
        for blade in layout.blades
    )
