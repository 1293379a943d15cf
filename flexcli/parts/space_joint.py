"""A joint in space with its springs' errors, for support stiffness, stress and modes."""

from collections.abc import Callable
from dataclasses import replace
from functools import cached_property
from math import inf
from operator import is_
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.formulas.profile import Constant
from flexcli.mechanics.space.layout import Directed, SpaceBlade, SpaceLayout, SpaceRod
from flexcli.mechanics.space.linear import SpaceAssembly, assemble
from flexcli.mechanics.space.planar import from_plane
from flexcli.mechanics.space.springs import MemberSprings
from flexcli.parts.elastic import NotAvailable
from flexcli.parts.geometries.base import Geometry, Sizes
from flexcli.parts.material import Material
from flexcli.parts.mechanisms.base import OutOfPlane
from flexcli.results import ErrorRange

if TYPE_CHECKING:
    from flexcli.parts.requirements.ask import Ask
    from flexcli.parts.temperature import Temperature

__all__ = ["Form", "SpaceJoint", "joint_in_space", "joint_of", "on_pivots"]

Floats = NDArray[np.float64]

RIGID = 1e8
"""Factor on a spring of unknown stiffness: practically rigid."""

UNKNOWN = 1e3
"""Relative error from which a number counts as unknown."""

HARDLY, LESS = 1e-6, 1e-2
"""Share of a spring that stands for none, so that a joint can be solved; and what of that a number
must not feel, which then is that of none."""


ROUNDING = 1e-10
"""Ratio to the other terms below which a number is rounding."""


class Form(NamedTuple):
    """A motion under a load, its error either way if known, and √(g·C g · f·C f)."""

    found: float
    off: tuple[float, float] | None
    work: float

    @property
    def error(self) -> ErrorRange | None:
        """Return its relative error."""
        if self.off is None or self.found == 0.0:
            return None
        low, high = sorted(end / self.found for end in self.off)
        return ErrorRange(low, high)


class SpaceJoint:
    """The assembly of a joint, and the errors of its springs.

    ``low`` and ``high`` are the least and the largest relative error of every spring; an infinite
    high marks a stiffness of unknown excess over a beam's. ``members`` are the springs of the
    layout's blades, where others than those by formulas are known. ``roots`` is what the roots of
    its blades add to their compliances at most, times E (:meth:`Geometry.root_springs`).
    """

    def __init__(
        self,
        layout: SpaceLayout,
        members: tuple[MemberSprings, ...] | None = None,
        roots: Floats | None = None,
    ) -> None:
        self.layout = layout
        self.assembly = assemble(layout, members)
        exact = np.zeros(len(self.assembly.stiffness) - 6 * len(self.assembly.members))
        members = self.assembly.members
        low = [member.low for member in members]
        if roots is not None:
            low = [
                _softened(member, float(blade.material.E), added)
                for member, blade, added in zip(members, layout.blades, roots, strict=True)
            ]
        self.low = np.concatenate([*low, exact])
        self.high = np.concatenate([*(m.high for m in members), exact])

    @property
    def is_known(self) -> bool:
        """Return whether the proportions of all blades are within the validity of the errors."""
        return all(member.is_known for member in self.assembly.members)

    @property
    def is_bounded(self) -> bool:
        """Return whether the errors of all springs hold, whatever was compared."""
        return all(member.is_known or member.is_bounded for member in self.assembly.members)

    @property
    def is_known_in_stress(self) -> bool:
        """Return whether they are also within the validity of nominal stresses."""
        return self.is_known and all(member.in_stress for member in self.assembly.members)

    @property
    def is_directed(self) -> bool:
        """Return whether its springs and their errors include the blades' directions."""
        return all(isinstance(blade.material, Directed) for blade in self.layout.blades)

    @property
    def is_uniform(self) -> bool:
        """Return whether every blade is of constant thickness, as the second order assumes."""
        return all(
            isinstance(blade, SpaceRod) or isinstance(blade.profile, Constant)
            for blade in self.layout.blades
        )

    @cached_property
    def softest(self) -> SpaceAssembly:
        """Return the assembly with every spring at its lower limit."""
        return self.assembly.scaled(np.maximum(1.0 + self.low, HARDLY))

    @cached_property
    def stiffest(self) -> SpaceAssembly:
        """Return the assembly with every spring at its upper limit; nearly rigid if unknown."""
        return self.assembly.scaled(np.minimum(1.0 + self.high, RIGID))

    @cached_property
    def rigid_crossings(self) -> SpaceAssembly | None:
        """Return it with what blades share that cross made rigid, every spring at its upper limit.

        That stiffens a joint against any load. None where they share nothing, or what is left of
        a blade is of unknown stiffness.
        """
        left = [_beyond_crossing(blade) for blade in self.layout.blades]
        if all(map(is_, left, self.layout.blades)) or None in left:
            return None
        blades = tuple(blade for blade in left if blade is not None)
        joint = SpaceJoint(replace(self.layout, blades=blades))
        return joint.stiffest if joint.is_bounded and np.isfinite(joint.high).all() else None

    def error(self, value: Callable[[SpaceAssembly], float]) -> ErrorRange | None:
        """Return the range of error of a number that grows with every spring."""
        if not self.is_bounded:
            return None
        best, most = value(self.assembly), value(self.stiffest)
        if self.rigid_crossings is not None:
            most = min(most, value(self.rigid_crossings))
        high, least = most / best - 1.0, value(self.softest)
        if np.any(self.low <= -1.0):
            softer = self.assembly.scaled(np.maximum(1.0 + self.low, LESS * HARDLY))
            least *= value(softer) >= least * (1.0 - HARDLY)
        return ErrorRange(least / best - 1.0, high if high < UNKNOWN else inf)

    @property
    def is_mirrored(self) -> bool:
        """Return whether the joint is its own mirror image in a plane of constant z."""
        blades, members = self.layout.blades, self.assembly.members
        places = [z for blade in blades for z in (blade.start[2], blade.end[2])]
        upright = all(abs(abs(member.axes[2, 2]) - 1.0) <= ROUNDING for member in members)
        flat = float(np.ptp(places)) <= ROUNDING * max(member.l for member in members)
        return upright and flat and not self.layout.springs

    @cached_property
    def _apart(self) -> list[NDArray[np.intp]]:
        """Return the springs in groups that share no motion of a body, however stiff they are."""
        rows = np.abs(self.assembly.rows)
        rows = rows / np.where(rows.any(axis=0), rows.max(axis=0), 1.0)
        touches = rows > ROUNDING * rows.max(axis=1, keepdims=True)
        groups, left = list[NDArray[np.intp]](), np.ones(len(rows), dtype=bool)
        while left.any():
            group = np.zeros(len(rows), dtype=bool)
            group[int(np.argmax(left))] = True
            while (more := touches[:, touches[group].any(axis=0)].any(axis=1)).sum() > group.sum():
                group = more
            groups.append(np.flatnonzero(group))
            left &= ~group
        return groups

    def form(self, sought: Floats, load: Floats) -> Form:
        """Return a motion under a load, ``g·C f``, and its error.

        Parameters
        ----------
        sought, load : array
            Deformations of all springs under g and under f (springs,).

        Notes
        -----
        A form of the same load on both sides rises by no more than the energy of its forces in
        softer springs says, and falls by no more than that of its motions in stiffer ones; a mixed
        one is the difference of two such. Springs that share no motion are taken apart.

        """
        found, low, high = 0.0, 0.0, 0.0
        k = self.assembly.stiffness
        with np.errstate(divide="ignore"):  # of which nobody knows how little it bears
            up = 1.0 / (1.0 + self.low) - 1.0
        whole = [float(k @ d**2) for d in (sought, load)]
        for group in self._apart:
            g, f = sought[group], load[group]
            work = [float(k[group] @ d**2) for d in (g, f)]
            if any(part <= ROUNDING**2 * of for part, of in zip(work, whole, strict=True)):
                continue
            found += float(k[group] @ (g * f))
            t = (work[1] / work[0]) ** 0.5
            changes = []
            for sign in (1.0, -1.0):
                energy = k[group] * (t * g + sign * f) ** 2
                used = energy > ROUNDING**2 * work[1]  # both are of the load's size
                energy, stiffer = energy[used], self.high[group][used]
                own = float(energy.sum())
                down = own - own / (1.0 + float(energy @ stiffer) / own) if own else 0.0
                changes.append((float(energy @ up[group][used]), down))
            (rises, falls), (against, for_it) = changes
            high += (rises + for_it) / (4.0 * t)
            low -= (falls + against) / (4.0 * t)
        return Form(found, (low, high) if self.is_bounded else None, (whole[0] * whole[1]) ** 0.5)


def _beyond_crossing(blade: SpaceBlade | SpaceRod) -> SpaceBlade | SpaceRod | None:
    """Return a blade without what it shares with one that crosses it, None where that is all."""
    if isinstance(blade, SpaceRod) or not any(blade.shared):
        return blade
    start, end = np.array(blade.start), np.array(blade.end)
    l = float(np.linalg.norm(end - start))
    first, last = blade.shared
    if first + last >= l:
        return None
    along = (end - start) / l
    x, y, z = map(float, start + first * along)
    u, v, w = map(float, end - last * along)
    return replace(blade, start=(x, y, z), end=(u, v, w), crossed=(1.0, 1.0), shared=(0.0, 0.0))


def _softened(member: MemberSprings, E: float, added: Floats) -> Floats:
    """Return the least errors of a blade's springs whose roots give way, ``added`` at most.

    Twist is softened by no more than what stretches it and bends it across its thickness: by the
    shear of its faces, and by the bending of its fibres to an S.
    """
    k = member.springs.stiffness
    softer = k[[0, 1, 2, 4, 5]] / E * added
    softer = np.array([*softer[:3], max(softer[0], softer[1]), *softer[3:]])
    return np.asarray((1.0 + member.low) / (1.0 + (1.0 + member.low) * softer) - 1.0)


MOST = 4
"""Joints kept: a design and one beside it, each warm and cold."""


class _Latest:
    """The last joints asked for, kept because all requirements of a design need the same."""

    def __init__(self) -> None:
        self.known: list[tuple[SpaceJoint, Geometry, Material, Sizes, tuple[object, ...]]] = []

    def of(
        self,
        geometry: Geometry,
        material: Material,
        sizes: Sizes,
        beside: tuple[object, ...],
        laid: Callable[[float], SpaceLayout],
        roots: Callable[[], Floats | None] = lambda: None,
    ) -> SpaceJoint:
        """Return the joint of a design and of what stands beside it, found once.

        ``laid`` draws it with blades of a density [kg/m³].
        """
        for i, (joint, drawn, made_of, own, others) in enumerate(self.known):
            same = made_of is material and all(map(is_, others, beside))
            if same and drawn is geometry and own == sizes:
                self.known.append(self.known.pop(i))
                return joint
        try:
            density = 0.0 if material.density is None else material.density.value
            joint = SpaceJoint(laid(density), roots=roots())
        except SolveError as error:
            raise NotAvailable(f"has no stiffness: {error}") from error
        self.known = [*self.known[1 - MOST :], (joint, geometry, material, sizes, beside)]
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

    def laid(density: float) -> SpaceLayout:
        layout = geometry.space_layout(material.elastic, sizes, density)
        layout = material.laid(layout, geometry.drawn_turn)
        if temperature is None:
            return layout
        return temperature.warmed(layout, material, geometry.axes, geometry.body_materials)

    def roots() -> Floats | None:
        return geometry.root_springs(sizes, material.elastic.most_nu)

    return _LATEST.of(geometry, material, sizes, (temperature, None, None), laid, roots)


def on_pivots(whole: OutOfPlane, density: float, gyration: float) -> SpaceLayout:
    """Return a mechanism on several joints from its plane, with inertia about x and y.

    Unstated inertia is that of a radius of gyration [m].
    """
    first = whole.layout.bodies[0].name
    if whole.layout.G is None:
        raise NotAvailable("needs material.poisson_ratio for its shear and torsion")
    found = from_plane(whole.layout, first, turns=True, density=density)
    bodies = []
    for body in found.bodies:
        about_x, about_y = whole.inertia.get(body.name) or (body.mass * gyration**2,) * 2
        about_z = body.inertia[2][2]
        inertia = ((about_x, 0.0, 0.0), (0.0, about_y, 0.0), (0.0, 0.0, about_z))
        bodies.append(body._replace(inertia=inertia))
    return SpaceLayout(tuple(bodies), found.blades, found.drive, found.springs)


def joint_of(ask: "Ask", *, warm: bool = True) -> SpaceJoint:
    """Return what a case loads in space: its joint, or a mechanism on several that is locked.

    The joint is as its temperature has grown it where it is ``warm``.

    Raises
    ------
    NotAvailable
        When it is not made of blades, or the material has no shear modulus.

    """
    scene, mechanism = ask.scene, ask.mechanism
    if not scene.on_bodies:
        heat = scene.temperature if warm else None
        return joint_in_space(ask.geometry, ask.material, ask.sizes, heat)
    assert mechanism is not None  # it has the body that is locked

    def laid(density: float) -> SpaceLayout:
        layout = ask.geometry.blades_layout(ask.material.elastic, ask.sizes)
        return on_pivots(mechanism.out_of_plane(layout, scene.lock), density, 0.0)

    return _LATEST.of(ask.geometry, ask.material, ask.sizes, (None, mechanism, scene.lock), laid)
