"""How many times its loads a plane mechanism bears at least before it leaves its plane.

Closed forms of its straight or bent blades instead of a search in space: cheap, and on the low
side, so that what is far from leaving its plane is known to be.
"""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import product
from typing import Any

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.layout import Blade, Layout, Load

__all__ = ["lateral_bound"]

Floats = NDArray[np.float64]

NODES, WEIGHTS = np.polynomial.legendre.leggauss(5)
NODES, WEIGHTS = (NODES + 1.0) / 2.0, WEIGHTS / 2.0
"""Along a blade, where its bent shape turns its section."""

EULER = 4.0 / np.pi**2
"""Of a column clamped at one end: 1/(Euler's load) = this l²/EI."""

TURNED = 2.0 / np.pi
"""Of a strip clamped at one end: 1/(moment that turns it aside) = this l/√(EI GJ)."""


SHEARED = 1.2
"""Of a rectangle: what shear gives way = this V l/(G A)."""

TINY = 1e-12
"""What stands for no rest of what a stroke leaves, so that nothing is divided by nothing."""


def lateral_bound(
    layout: Layout,
    groups: Sequence[Sequence[Load]],
    *,
    directed: bool,
    driven: int,
    travels: Sequence[Any] = (),
    tips: bool = True,
) -> Floats:
    """Return a factor on loads up to which no blade or body leaves the plane, from below [-].

    What the layout has grown by belongs to the loads.

    Parameters
    ----------
    layout : Layout
        The mechanism, with G, without springs; numbers may be of many designs. What ideal joints
        guide in the plane is free out of it.
    groups : sequence of sequence of Load
        Loads that act together; each group acts in either sense.
    directed : bool
        Whether the first group acts in its own sense alone.
    driven : int
        The coordinate (3 body + 0, 1, 2) that the drive moves. It is free, and if there are
        travels locked as well.
    travels : sequence
        Ends of a stroke from rest [m or rad]; what they bend softens blades across their width.
    tips : bool
        Whether the bodies may leave the plane; else only blades between them do.

    Returns
    -------
    array (designs,)
        The least factor of all senses; zero where a stroke alone may turn a blade aside.

    Notes
    -----
    Our own. With w and φ the deflection across and the twist of a blade in the frame of its first
    end, ``∫N w'²/2 ≥ −(4 l²/π²EI) N U`` for a push N, and ``∫M φ w'' ≥ −(2 M l/(π √(EI GJ))) U``
    for a moment M in the plane, U its energy of bending and torsion (both from
    ``∫f² ≤ (2l/π)² ∫f'²``, f(0) = 0; equal to Euler's load and to the moment that turns a strip
    aside, Timoshenko & Gere, Theory of Elastic Stability, 1961, 2-1 and 6.1). What forces do on
    the levers of bodies and blades that tip is a quadratic form of their tilts, as much of U as an
    eigenvalue says. A moment of which the tilts change the work by their order counts against it.
    Blades have their least thickness throughout. Forces are those of small motion in the plane.

    Held against beams in space that stay straight
    (:func:`flexcli.mechanics.space.exact.critical.straight_critical_factor`): of no random joint
    more than theirs.

    """
    many = _designs(layout, groups, travels)
    blades = [_Strip.of(layout, blade, many) for blade in layout.blades]
    plane = _assembled([(blade.in_plane, blade.rows_in_plane) for blade in blades])
    moves = len(travels) > 0
    guided = _guided(layout)
    strokes = [np.zeros(plane.shape[:-1])]
    if moves:
        strokes = _moved(plane, driven, guided, travels)
    pulls = [_pull(layout, group, many) for group in groups]
    senses = [(1.0,) if directed and k == 0 else (1.0, -1.0) for k in range(len(groups))]
    least = np.full(plane.shape[0], np.inf)
    misfit = np.sum([blade.growing for blade in blades], axis=0)
    for locked in (False, True)[: 1 + moves]:
        held = [*guided, driven] if locked else guided
        moved, grown = [_under(plane, pull, held) for pull in pulls], _under(plane, misfit, held)
        for signs in product(*senses):
            by_loads = sum((s * each for s, each in zip(signs, moved, strict=True)), grown)
            loads = [
                load.times(s) for s, group in zip(signs, groups, strict=True) for load in group
            ]
            lever = _of_loads(layout, loads, plane.shape)
            for stroke in strokes:
                found = _factor(blades, by_loads, stroke, lever, tips=tips)
                least = np.minimum(least, found)
    return least


def _factor(
    blades: Sequence["_Strip"], by_loads: Floats, stroke: Floats, lever: Floats, *, tips: bool
) -> Floats:
    """Return the factor on loads that no blade and no body tips under, beside a stroke."""
    used = taken = 0.0 * by_loads[:, 0]
    forces = [blade.force(by_loads, blade.misfit) for blade in blades]
    for blade, force in zip(blades, forces, strict=True):
        used = np.maximum(used, blade.share(force, clamped=not tips))
        taken = np.maximum(taken, blade.share(blade.force(stroke)))
    if not tips:
        return _borne(used, taken)
    for blade, force in zip(blades, forces, strict=True):
        lever = lever + blade.lever(force)
    springs = [(blade.bent(stroke + by_loads), blade.rows_across) for blade in blades]
    stiffness = _assembled(springs)
    size = np.sqrt(np.einsum("dii->di", stiffness))
    unit = size[:, :, None] * size[:, None, :]
    root = np.linalg.inv(np.linalg.cholesky(stiffness / unit))
    tipped = np.linalg.eigvalsh(-root @ (lever / unit) @ root.transpose(0, 2, 1))[:, -1]
    return _borne(used + np.maximum(tipped, 0.0), taken)


def _borne(needed: Floats, taken: Floats) -> Floats:
    """Return the factor on what loads need of what a stroke leaves."""
    with np.errstate(divide="ignore"):
        return np.where(taken < 1.0, np.maximum(1.0 - taken, TINY) / needed, 0.0)


@dataclass(frozen=True, eq=False)
class _Strip:
    """A blade as a strip between two bodies, in numbers of many designs (designs, …).

    ``rows_in_plane`` and ``rows_across`` make of the coordinates (x, y, φ) and (z, θ_x, θ_y) of
    all bodies the motion of its second end in the frame of its first: along it, across it in the
    plane and its rotation, and out of the plane with both tilts. ``misfit`` is the motion in the
    plane by which what has grown leaves it without force. ``arms`` are of its ends from
    their bodies' points, ``at`` where these bodies' coordinates begin, none of the ground.
    """

    l: Floats
    along: Floats
    EA: Floats
    EI: Floats
    EI_across: Floats
    GJ: Floats
    gyration: Floats
    shear: Floats
    misfit: Floats
    arms: tuple[Floats, Floats]
    at: tuple[int | None, int | None]
    size: int

    @classmethod
    def of(cls, layout: Layout, blade: Blade, designs: int) -> "_Strip":
        """Return the strip of a blade, as thick as where it is thinnest."""
        names = [body.name for body in layout.bodies]
        h, b, E, G = (
            np.broadcast_to(np.asarray(x, np.float64), designs)
            for x in (blade.least_thickness, blade.b, layout.E, layout.G)
        )
        E, G = E * blade.stiffer, G * blade.stiffer
        chord = _vector(blade.end, designs) - _vector(blade.start, designs)
        l = np.linalg.norm(chord, axis=-1)
        grown = layout.blade_growth.get(blade.name, 0.0) * chord
        ends, arms = [], []
        for name, point in ((blade.first, blade.start), (blade.second, blade.end)):
            i = names.index(name) if name in names else None
            ends.append(None if i is None else 3 * i)
            base = (0.0, 0.0) if i is None else layout.bodies[i].point
            arms.append(_vector(point, designs) - _vector(base, designs))
            growth = layout.body_growth.get(name, 0.0)
            grown = grown + (1.0 if len(arms) == 1 else -1.0) * growth * arms[-1]
        thin, wide = np.minimum(h, b), np.maximum(h, b)
        J = wide * thin**3 / 3.0 * (1.0 - 0.63 * thin / wide)
        along = chord / l[:, None]
        misfit = np.stack(
            [np.sum(along * grown, axis=-1), np.sum(_normal(along) * grown, axis=-1), 0.0 * l],
            axis=-1,
        )
        return cls(
            l, along, E * b * h, E * b * h**3 / 12.0, E * h * b**3 / 12.0, G * J,
            (b**2 + h**2) / 12.0, SHEARED / (G * b * h), misfit,
            (arms[0], arms[1]), (ends[0], ends[1]),
            3 * len(names),
        )  # fmt: skip

    @cached_property
    def normal(self) -> Floats:
        """Return the direction across the blade in the plane."""
        return _normal(self.along)

    @cached_property
    def rows_in_plane(self) -> Floats:
        """Return what takes coordinates in the plane to the motion of the end (designs, 3, all)."""
        found = self._none(3)
        for at, arm, sign in self._ends():
            for row, way in enumerate((self.along, self.normal)):
                found[:, row, at : at + 2] += sign * way
                found[:, row, at + 2] += sign * np.sum(way * _normal(arm), axis=-1)
            found[:, 2, at + 2] += sign
        return found

    @cached_property
    def rows_across(self) -> Floats:
        """Return what takes coordinates out of the plane to the motion of the end."""
        found = self._none(3)
        for at, arm, sign in self._ends():
            found[:, 0] += sign * self._raised(at, arm)
            found[:, 1, at + 1] += sign
            found[:, 2, at + 2] += sign
        return found

    @cached_property
    def in_plane(self) -> Floats:
        """Return the stiffness of the end in the plane (designs, 3, 3)."""
        l, EI = self.l, self.EI
        found = np.zeros((len(l), 3, 3))
        found[:, 0, 0] = self.EA / l
        found[:, 1, 1], found[:, 2, 2] = 12.0 * EI / l**3, 4.0 * EI / l
        found[:, 1, 2] = found[:, 2, 1] = -6.0 * EI / l**2
        return found

    @property
    def growing(self) -> Floats:
        """Return the forces on the coordinates of the plane that undo its misfit (designs, all)."""
        back = self.in_plane @ self.misfit[:, :, None]
        return np.asarray((self.rows_in_plane.transpose(0, 2, 1) @ back)[:, :, 0])

    def force(self, coordinates: Floats, misfit: Floats | float = 0.0) -> Floats:
        """Return the pull, the force across and the moment at its second end (designs, 3)."""
        moved = (self.rows_in_plane @ coordinates[:, :, None])[:, :, 0] - misfit
        return np.asarray((self.in_plane @ moved[:, :, None])[:, :, 0])

    def share(self, force: Floats, *, clamped: bool = False) -> Floats:
        """Return the share of a force of what turns it aside at least, between ends that do not.

        Both are ``clamped``, or the second is free to move out of the plane with its body. What
        twists a strip between clamps bends it across its thickness before, in the plane.
        """
        most = np.maximum(np.abs(force[:, 2]), np.abs(force[:, 2] + self.l * force[:, 1]))
        push = np.maximum(-force[:, 0], 0.0)
        of_moment = TURNED * most * self.l / np.sqrt(self.EI_across * self.GJ)
        if clamped:
            aside = EULER / 16.0 * self.l**2 / self.EI_across + self.shear
            return np.asarray(push * aside + of_moment / 2.0)
        aside = EULER * self.l**2 / self.EI_across + self.shear
        aside = np.maximum(aside, self.gyration / self.GJ)
        return np.asarray(push * aside + of_moment)

    def bent(self, coordinates: Floats) -> Floats:
        """Return the stiffness of its end out of the plane as it is bent in it (designs, 3, 3)."""
        _, v, phi = (self.rows_in_plane @ coordinates[:, :, None])[:, :, 0].T
        s, v, phi = NODES, v[:, None], phi[:, None]  # (designs, nodes)
        l, along, normal = (x[:, None] for x in (self.l, self.along, self.normal))
        turn = 6.0 * (s - s**2) * v / l + (3.0 * s**2 - 2.0 * s) * phi
        aside = (1.0 - 3.0 * s**2 + 2.0 * s**3) * v - (s**3 - s**2) * l * phi
        turned = np.stack([np.cos(turn), np.sin(turn)], axis=-1)
        tangent = turned[..., :1] * along + turned[..., 1:] * normal
        lever = ((1.0 - s) * l)[..., None] * along + aside[..., None] * normal
        flexes = np.zeros((len(v), 3, 3))
        for way, stiffness in ((_normal(tangent), self.EI_across), (tangent, self.GJ)):
            moments = way[..., :1] * lever[..., 1:] - way[..., 1:] * lever[..., :1]
            rows = np.concatenate([moments, way], axis=-1)
            weights = WEIGHTS * l / stiffness[:, None]
            flexes += np.einsum("dn,dni,dnj->dij", weights, rows, rows)
        flexes[:, 0, 0] += self.shear * self.l
        return np.asarray(np.linalg.inv(flexes), np.float64)

    def lever(self, force: Floats) -> Floats:
        """Return what a force on it adds to the stiffness of its bodies out of the plane."""
        F = force[:, 0, None] * self.along + force[:, 1, None] * self.normal
        (first, second), chord = self.at, self.l[:, None] * self.along
        found = self._none(self.size)
        half = np.abs(force[:, 2]) / 2.0
        if second is not None:
            found[:, second + 1 : second + 3, second + 1 : second + 3] -= _lever(self.arms[1], F)
        if first is not None:
            turned = slice(first + 1, first + 3)
            found[:, turned, turned] += _lever(self.arms[0] - chord, F)
            raised = self._none(1)[:, 0] - self._raised(first, self.arms[0])
            if second is not None:
                raised += self._raised(second, self.arms[1])
            to = np.stack([-F[:, 1], F[:, 0]], axis=-1)
            product = raised[:, :, None] * to[:, None, :]
            found[:, :, turned] -= product
            found[:, turned, :] -= product.transpose(0, 2, 1)
        for at in (first, second):
            if at is not None:
                found[:, at + 1, at + 1] -= half
                found[:, at + 2, at + 2] -= half
        return found

    def _ends(self) -> Iterator[tuple[int, Floats, float]]:
        """Yield the bodies that move, the arms of the blade's second end on them, and their sign.

        The first body takes that end with it as if it were its own.
        """
        first, second = self.arms
        arms = first + self.l[:, None] * self.along, second
        for at, arm, sign in zip(self.at, arms, (-1.0, 1.0), strict=True):
            if at is not None:
                yield at, arm, sign

    def _raised(self, at: int, arm: Floats) -> Floats:
        """Return what takes coordinates to the motion along z of a point of a body."""
        found = np.zeros((len(arm), self.size))
        found[:, at], found[:, at + 1], found[:, at + 2] = 1.0, arm[:, 1], -arm[:, 0]
        return found

    def _none(self, rows: int) -> Floats:
        return np.zeros((len(self.l), rows, self.size))


def _lever(arm: Floats, force: Floats) -> Floats:
    """Return the stiffness against tilts of a dead force on an arm (designs, 2, 2)."""
    product = arm[:, :, None] * force[:, None, :]
    along = np.sum(arm * force, axis=-1)[:, None, None]
    return np.asarray(along * np.eye(2) - (product + product.transpose(0, 2, 1)) / 2.0)


def _of_loads(layout: Layout, loads: Sequence[Load], shape: tuple[int, ...]) -> Floats:
    """Return what loads add to the stiffness of bodies out of the plane."""
    found = np.zeros(shape)
    for load in loads:
        at, arm, force = _placed(layout, load, len(found))
        half = np.abs(np.asarray(load.moment, np.float64)).reshape(-1, 1, 1) / 2.0
        turned = slice(at + 1, at + 3)
        found[:, turned, turned] += _lever(arm, force) - half * np.eye(2)
    return found


def _pull(layout: Layout, loads: Sequence[Load], designs: int) -> Floats:
    """Return the forces of loads on the coordinates of the plane (designs, all)."""
    found = np.zeros((designs, 3 * len(layout.bodies)))
    for load in loads:
        at, arm, force = _placed(layout, load, designs)
        found[:, at : at + 2] += force
        found[:, at + 2] += np.sum(_normal(arm) * force, axis=-1) + np.asarray(load.moment)
    return found


def _placed(layout: Layout, load: Load, designs: int) -> tuple[int, Floats, Floats]:
    """Return where the coordinates of a load's body begin, its arm there, and its force."""
    i = layout.index(load.body)
    arm = _vector(load.point, designs) - _vector(layout.bodies[i].point, designs)
    return 3 * i, arm, _vector(load.force, designs)


def _designs(layout: Layout, groups: Sequence[Sequence[Load]], travels: Sequence[Any]) -> int:
    """Return of how many designs there are numbers."""
    numbers = [layout.E, layout.G, *travels]
    for body in layout.bodies:
        numbers += body.point
    for blade in layout.blades:
        numbers += [*blade.start, *blade.end, blade.b, blade.least_thickness]
    for load in (load for group in groups for load in group):
        numbers += [*load.point, *load.force, load.moment]
    return max(np.size(np.asarray(each)) for each in numbers)


def _guided(layout: Layout) -> tuple[int, ...]:
    """Return the coordinates of the plane that ideal joints hold."""
    each = (
        (3 * layout.index(name) + k, held)
        for name, holds in layout.guides.items()
        for k, held in enumerate(holds)
    )
    return tuple(k for k, held in each if held)


def _under(plane: Floats, pull: Floats, locked: Sequence[int]) -> Floats:
    """Return the coordinates of the plane under forces on them, some of them locked."""
    free = [i for i in range(plane.shape[1]) if i not in locked]
    found = np.zeros_like(pull)
    found[:, free] = np.linalg.solve(plane[:, free][:, :, free], pull[:, free, None])[:, :, 0]
    return found


def _moved(
    plane: Floats, driven: int, guided: Sequence[int], travels: Sequence[Any]
) -> list[Floats]:
    """Return the coordinates of the plane at each travel, all but what is guided free."""
    unit = _under(plane, -plane[:, :, driven], [*guided, driven])
    unit[:, driven] = 1.0
    return [np.asarray(travel, np.float64).reshape(-1, 1) * unit for travel in travels]


def _assembled(springs: Sequence[tuple[Floats, Floats]]) -> Floats:
    """Return the stiffness of coordinates by those of blades (designs, all, all)."""
    each = [rows.transpose(0, 2, 1) @ k @ rows for k, rows in springs]
    return np.asarray(np.sum(each, axis=0))


def _vector(point: Any, designs: int) -> Floats:
    """Return the coordinates of a point, or parts of a force (designs, 2)."""
    x, y = (np.broadcast_to(np.asarray(each, np.float64), designs) for each in point)
    return np.stack([x, y], axis=-1)


def _normal(way: Floats) -> Floats:
    """Return vectors turned by a right angle to the left."""
    return np.stack([-way[..., 1], way[..., 0]], axis=-1)
