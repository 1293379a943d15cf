"""A joint in space with its springs' errors: what support, stress and modes are asked of."""

from collections.abc import Callable
from functools import cached_property
from math import inf
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import Directed, SpaceLayout, SpaceRod
from flexcli.mechanics.space.linear import SpaceAssembly, assemble
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.results import ErrorRange

if TYPE_CHECKING:
    from flexcli.parts.temperature import Temperature

__all__ = ["SpaceJoint", "joint_in_space"]

Floats = NDArray[np.float64]

RIGID = 1e8
"""Factor on a spring that nobody knows the stiffness of: as good as rigid."""

UNKNOWN = 1e3
"""Relative error from which there is no telling."""


class SpaceJoint:
    """The assembly of a joint, and how far its springs may be off.

    ``low`` and ``high`` are the least and the largest relative error of every spring; a high of
    infinity says that nobody knows how much stiffer than a beam one is.
    """

    def __init__(self, layout: SpaceLayout) -> None:
        self.layout = layout
        self.assembly = assemble(layout)
        exact = np.zeros(len(self.assembly.stiffness) - 6 * len(self.assembly.members))
        members = self.assembly.members
        self.low = np.concatenate([*(m.low for m in members), exact])
        self.high = np.concatenate([*(m.high for m in members), exact])

    @property
    def is_known(self) -> bool:
        """Return whether the proportions of all blades are those for which the errors hold."""
        return all(member.is_known for member in self.assembly.members)

    @property
    def is_directed(self) -> bool:
        """Return whether its springs and their errors are those of the blades' directions."""
        return all(isinstance(blade.material, Directed) for blade in self.layout.blades)

    @property
    def is_uniform(self) -> bool:
        """Return whether every blade is of constant thickness, as the second order takes them."""
        return all(
            isinstance(blade, SpaceRod) or isinstance(blade.profile, Constant)
            for blade in self.layout.blades
        )

    @cached_property
    def softest(self) -> SpaceAssembly:
        """Return the assembly with every spring as soft as it may be."""
        return self.assembly.scaled(1.0 + self.low)

    @cached_property
    def stiffest(self) -> SpaceAssembly:
        """Return that with every spring as stiff as it may be; all but rigid where nobody knows."""
        return self.assembly.scaled(np.minimum(1.0 + self.high, RIGID))

    def error(self, value: Callable[[SpaceAssembly], float]) -> ErrorRange | None:
        """Return between what relative errors a number lies that grows with every spring."""
        if not self.is_known:
            return None
        best = value(self.assembly)
        high = value(self.stiffest) / best - 1.0
        return ErrorRange(value(self.softest) / best - 1.0, high if high < UNKNOWN else inf)

    def form_error(self, found: float, work: float, softer: float = 0.0) -> ErrorRange | None:
        """Return the error of a motion under a load, ``g·C f``.

        ``work`` is √(g·C g · f·C f). The compliance lies between multiples of itself, so do forms
        of it with the same load on both sides, and mixed ones as Schwarz has it. ``softer`` is by
        what share clamps may give way besides.
        """
        if not self.is_known or found == 0.0:
            return None
        up = float(np.max(1.0 / (1.0 + self.low))) * (1.0 + softer) - 1.0
        down = 1.0 - float(np.min(1.0 / (1.0 + self.high)))
        middle, half = (up - down) / 2.0, (up + down) / 2.0 * work / abs(found)
        return ErrorRange(middle - half, middle + half)


MOST = 4
"""Joints kept: a design and one beside it, each warm and cold."""


class _Latest:
    """The joints that were asked last: all requirements of a design ask for the same."""

    def __init__(self) -> None:
        self.known: list[tuple[SpaceJoint, Geometry, Material, Sizes, Temperature | None]] = []

    def of(
        self,
        geometry: Geometry,
        material: Material,
        sizes: Sizes,
        temperature: "Temperature | None",
    ) -> SpaceJoint:
        """Return the joint of a design, found once."""
        for i, (joint, drawn, made_of, own, at) in enumerate(self.known):
            same = made_of is material and at is temperature
            if same and drawn.has_blades_of(geometry) and own == sizes:
                self.known.append(self.known.pop(i))
                return joint
        density = material.density.value if material.density is not None else 0.0
        layout = geometry.space_layout(material.elastic, sizes, density)
        layout = material.laid(layout, geometry.drawn_turn)
        if temperature is not None:
            others = geometry.body_materials
            layout = temperature.warmed(layout, material, geometry.axes, others)
        joint = SpaceJoint(layout)
        self.known = [*self.known[1 - MOST :], (joint, geometry, material, sizes, temperature)]
        return joint


_LATEST = _Latest()


def joint_in_space(
    geometry: Geometry,
    material: Material,
    sizes: Sizes,
    temperature: "Temperature | None" = None,
) -> SpaceJoint:
    """Return a joint in space, grown by a temperature where one is given.

    Raises
    ------
    NotAvailable
        When it is not made of blades, or the material has no shear modulus.

    """
    try:
        return _LATEST.of(geometry, material, sizes, temperature)
    except SolveError as error:
        raise NotAvailable(f"has no stiffness: {error}") from error
