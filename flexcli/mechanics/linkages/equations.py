"""The closure of a linkage's loops as equations in the poses of its links.

The pose of a link takes its point r, at rest, to w + c + (r − c) e^{iφ}: complex numbers in units
of the linkage's size, c the middle of the link's pivots. The unknowns q are (Re w, Im w, φ) of
each moving link.
"""

from dataclasses import dataclass
from math import hypot

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.linkages.linkage import Joint, Linkage, Prismatic, Revolute

__all__ = ["Loops", "loops"]

Floats = NDArray[np.float64]
Complex = NDArray[np.complex128]
Integers = NDArray[np.intp]


@dataclass(frozen=True, eq=False)
class Loops:
    """Closure and deflection of every joint, with the derivatives, for any number of poses.

    ``first`` and ``second`` number the links of each joint, the last number being the ground;
    ``arms`` reach from the middles of these links to a point of the joint. ``slides`` is 1 for
    a slider, else 0, and ``directions`` its direction, else 1.
    """

    moving: int
    input: int
    first: Integers
    second: Integers
    arms: tuple[Complex, Complex]
    slides: Floats
    directions: Complex
    middles: Complex
    size: float

    def values(self, q: Floats) -> Floats:
        """Return the closure of all joints and the deflection of the input, (..., 2j + 1)."""
        return self._system(self.rows(q))

    def jacobian(self, q: Floats) -> Floats:
        """Return the derivatives of :meth:`values` by q, (..., 2j + 1, 3m)."""
        slopes = self.slopes(q)
        closure = slopes[..., :2, :].reshape(*q.shape[:-1], 2 * self.first.size, q.shape[-1])
        return np.concatenate([closure, slopes[..., self.input, 2:, :]], axis=-2)

    def bend(self, q: Floats, v: Floats) -> Floats:
        """Return the second derivative of :meth:`values` along v."""
        return self._system(self.bends(q, v))

    def rows(self, q: Floats) -> Floats:
        """Return each joint's closure (two numbers) and deflection, shape (..., j, 3)."""
        w, phi = self.poses(q)
        turn = phi[..., self.second] - phi[..., self.first]
        return self._sorted(self._frame(phi) * self._gap(w, phi), turn)

    def slopes(self, q: Floats) -> Floats:
        """Return the derivatives of :meth:`rows` by q, shape (..., j, 3, 3m)."""
        w, phi = self.poses(q)
        frame, joints = self._frame(phi), np.arange(self.first.size)
        gap = np.zeros((*phi.shape[:-1], joints.size, 3 * (self.moving + 1)), dtype=np.complex128)
        turn = np.zeros(gap.shape)
        levers = self._levers(phi)
        for links, sign, lever in zip((self.first, self.second), (-1.0, 1.0), levers, strict=True):
            gap[..., joints, 3 * links] = sign * frame
            gap[..., joints, 3 * links + 1] = sign * 1j * frame
            gap[..., joints, 3 * links + 2] = sign * 1j * frame * lever
            turn[..., joints, 3 * links + 2] = sign
        gap[..., joints, 3 * self.first + 2] -= 1j * self.slides * frame * self._gap(w, phi)
        by_variable = self._sorted(np.moveaxis(gap, -1, 0), np.moveaxis(turn, -1, 0))
        return np.moveaxis(by_variable, 0, -1)[..., : 3 * self.moving]

    def bends(self, q: Floats, v: Floats) -> Floats:
        """Return the second derivative of :meth:`rows` along v, shape (..., j, 3)."""
        (w, phi), (w_v, phi_v) = self.poses(q), self.poses(v)
        inner, outer = self._levers(phi)
        spin, swing = phi_v[..., self.first], phi_v[..., self.second]
        velocity = w_v[..., self.second] - w_v[..., self.first]
        velocity = velocity + 1j * (outer * swing - inner * spin)
        acceleration = inner * spin**2 - outer * swing**2
        # a slider is seen from its first link: Coriolis and centrifugal terms of that frame
        turning = self.slides * spin
        seen = acceleration - 2j * turning * velocity - turning**2 * self._gap(w, phi)
        return self._sorted(self._frame(phi) * seen, np.zeros(seen.shape))

    def poses(self, q: Floats) -> tuple[Complex, Floats]:
        """Return w and φ of every link, the ground last, shapes (..., m + 1)."""
        pose = np.zeros((*q.shape[:-1], self.moving + 1, 3))
        pose[..., :-1, :] = q.reshape(*q.shape[:-1], self.moving, 3)
        return pose[..., 0] + 1j * pose[..., 1], pose[..., 2]

    def units(self) -> Floats:
        """Return the unit of each joint's deflection, 1 rad or the size [m], shape (j,)."""
        return np.where(self.slides > 0.0, self.size, 1.0)

    def _system(self, rows: Floats) -> Floats:
        closure = rows[..., :2].reshape(*rows.shape[:-2], 2 * self.first.size)
        return np.concatenate([closure, rows[..., self.input, 2:]], axis=-1)

    def _sorted(self, gap: Complex, turn: Floats) -> Floats:
        """Return what stays closed, then what deflects: a slider may part along its direction."""
        hinge = np.stack([gap.real, gap.imag, turn], axis=-1)
        slider = np.stack([gap.imag, turn, gap.real], axis=-1)
        return np.where(self.slides[:, None] > 0.0, slider, hinge)

    def _gap(self, w: Complex, phi: Floats) -> Complex:
        """Return the way from the joint's point on the first link to that on the second."""
        inner, outer = self._levers(phi)
        start, end = self.arms
        return w[..., self.second] - w[..., self.first] + (outer - end) - (inner - start)

    def _levers(self, phi: Floats) -> tuple[Complex, Complex]:
        """Return the arms of the first and the second links, turned."""
        e = np.exp(1j * phi)
        return self.arms[0] * e[..., self.first], self.arms[1] * e[..., self.second]

    def _frame(self, phi: Floats) -> Complex:
        """Return the factor that gives components along and across each slider; 1 for a hinge."""
        return np.asarray(
            np.conj(self.directions * np.exp(1j * self.slides * phi[..., self.first]))
        )


def loops(linkage: Linkage) -> Loops:
    """Return the loop equations of a linkage; q = 0 is the assembled pose."""
    names, joints = (*linkage.moving, linkage.ground), linkage.joints
    number = {name: i for i, name in enumerate(names)}
    points = np.array([complex(*j.point) for j in joints if isinstance(j, Revolute)], dtype=complex)
    size = float(np.abs(points[:, None] - points).max(initial=0.0))
    # without two points there is no length to measure by, and any unit does
    size = size if size > 0.0 else 1.0
    middles = np.array([_middle(name, joints) for name in names])
    first = np.array([number[j.first] for j in joints], dtype=np.intp)
    second = np.array([number[j.second] for j in joints], dtype=np.intp)
    moves = np.where(second < len(linkage.moving), second, first)
    at = np.array(
        [
            complex(*joint.point) if isinstance(joint, Revolute) else middles[link]
            for joint, link in zip(joints, moves, strict=True)
        ]
    )
    directions = [
        complex(*j.direction) / hypot(*j.direction) if isinstance(j, Prismatic) else 1.0 + 0.0j
        for j in joints
    ]
    return Loops(
        moving=len(linkage.moving),
        input=[j.name for j in joints].index(linkage.input),
        first=first,
        second=second,
        arms=((at - middles[first]) / size, (at - middles[second]) / size),
        slides=np.array([float(isinstance(j, Prismatic)) for j in joints]),
        directions=np.array(directions),
        middles=middles,
        size=size,
    )


def _middle(link: str, joints: tuple[Joint, ...]) -> complex:
    """Return the middle of a link's pivots, the origin when it has none."""
    points = [
        complex(*j.point) for j in joints if isinstance(j, Revolute) and link in (j.first, j.second)
    ]
    return sum(points, 0j) / max(len(points), 1)
