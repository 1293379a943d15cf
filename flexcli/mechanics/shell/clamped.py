"""Strips of shell between two clamps: all inside eliminated, end motions from end forces.

In the frame of its start a strip is held there, its normal along y; its other end is at r, turned
by Q. Within its own plane it may stretch and shear at a clamp: slopes d_1 there have no part along
the normal. Unknowns of a strip are the slopes in its plane at both ends, the vectors of the
functions that vanish with their slopes at the ends, r and the quaternion of Q.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from flexcli.mechanics.shell.basis import AT_ENDS
from flexcli.mechanics.shell.element import Strips, energy_slopes
from flexcli.mechanics.space.exact.rotation import cross, matrix_of, skew

__all__ = ["Clamped", "Ends", "Unknowns"]

Floats = NDArray[np.float64]


class Unknowns(NamedTuple):
    """Slopes at start and end (strips, 2, across, 2), inside (…), end (…, 3) and turn (…, 4)."""

    slopes: Floats
    inside: Floats
    end: Floats
    turn: Floats


class Ends(NamedTuple):
    """Slope and Hessian of the energy by the inside, and by shift and spin of the end.

    ``inner`` (strips, n, n), ``mixed`` (strips, n, 6), ``outer`` (strips, 6, 6); ``load`` (strips,
    n) and ``force`` (strips, 6).
    """

    load: Floats
    force: Floats
    inner: Floats
    mixed: Floats
    outer: Floats


class Clamped(NamedTuple):
    """Strips between clamps on one set of functions."""

    strips: Strips

    @property
    def inside(self) -> int:
        """Return the number of unknowns of a strip whose ends are held."""
        basis = self.strips.basis
        return 4 * basis.across + 3 * basis.across * (basis.along - AT_ENDS)

    def rest(self) -> Floats:
        """Return the unknowns of strips at rest (strips, unknowns)."""
        z = np.zeros((self.strips.nu.size, self.inside + 7))
        at = self.split(z)
        at.end[:, 0] = at.turn[:, 0] = 1.0
        return z

    def split(self, z: Floats) -> Unknowns:
        """Return views of the unknowns."""
        n, count = self.strips.basis.across, self.inside
        return Unknowns(
            z[:, : 4 * n].reshape(-1, 2, 2, n),
            z[:, 4 * n : count].reshape(z.shape[0], -1, n, 3),
            z[:, count : count + 3],
            z[:, count + 3 :],
        )

    def vectors(self, z: Floats) -> Floats:
        """Return the vectors d of strips (strips, along, across, 3)."""
        at, basis = self.split(z), self.strips.basis
        d = np.zeros((z.shape[0], basis.along, basis.across, 3))
        slopes = at.slopes.copy()
        slopes[:, :, 0, 0] += 1.0
        Q = matrix_of(at.turn)
        half = self.strips.width[:, None] / 2.0
        d[:, 0, 1, 2] = half[:, 0]
        d[:, 1, :, 0], d[:, 1, :, 2] = slopes[:, 0, 0], slopes[:, 0, 1]
        d[:, 2, 0], d[:, 2, 1] = at.end, half * Q[:, :, 2]
        d[:, 3] = np.swapaxes(Q[:, :, ::2] @ slopes[:, 1], 1, 2)
        d[:, AT_ENDS:] = at.inside
        return d

    def about(self, z: Floats) -> Ends:
        """Return slope and Hessian of the energy about unknowns z, the end spinning in space."""
        B, n = z.shape[0], self.strips.basis.across
        d = self.vectors(z)
        g, H = energy_slopes(self.strips, d)
        rim, own = 3 * n * AT_ENDS, 4 * n
        Q = matrix_of(self.split(z).turn)
        T = np.zeros((B, AT_ENDS, n, 3, own + 6))
        j = np.arange(n)
        T[:, 1, j, 0, j] = T[:, 1, j, 2, n + j] = 1.0
        T[:, 3, j, :, 2 * n + j] = Q[:, :, 0]
        T[:, 3, j, :, 3 * n + j] = Q[:, :, 2]
        T[:, 2, 0, :, own : own + 3] = np.eye(3)
        T[:, 2, 1, :, own + 3 :] = -skew(d[:, 2, 1])
        T[:, 3, :, :, own + 3 :] = -skew(d[:, 3])
        by_own = T.reshape(B, rim, own + 6)
        T_t = np.swapaxes(by_own, -1, -2)
        bounds, through = T_t @ H[:, :rim, :rim] @ by_own, T_t @ H[:, :rim, rim:]
        pulled = (T_t @ g[:, :rim, None])[..., 0]
        # the end's vectors turn by ½ θ × (θ × d), and with them what slopes add to them
        at_end = g[:, :rim].reshape(B, AT_ENDS, n, 3)
        turned = np.concatenate([at_end[:, 2, 1:2], at_end[:, 3]], axis=1)
        moved = np.concatenate([d[:, 2, 1:2], d[:, 3]], axis=1)
        bounds[:, own + 3 :, own + 3 :] += _swings(turned, moved)
        for k, axis in enumerate((0, 2)):
            both = cross(Q[:, None, :, axis], at_end[:, 3])
            part = slice((2 + k) * n, (3 + k) * n)
            bounds[:, part, own + 3 :] += both
            bounds[:, own + 3 :, part] += np.swapaxes(both, 1, 2)
        inner = np.empty((B, self.inside, self.inside))
        inner[:, :own, :own], inner[:, own:, own:] = bounds[:, :own, :own], H[:, rim:, rim:]
        inner[:, :own, own:] = through[:, :own]
        inner[:, own:, :own] = np.swapaxes(through[:, :own], 1, 2)
        return Ends(
            load=np.concatenate([pulled[:, :own], g[:, rim:]], axis=1),
            force=pulled[:, own:],
            inner=inner,
            mixed=np.concatenate(
                [bounds[:, :own, own:], np.swapaxes(through[:, own:], 1, 2)], axis=1
            ),
            outer=bounds[:, own:, own:],
        )


def _swings(n: Floats, a: Floats) -> Floats:
    """Return the Hessians of ``Σ n·(θ × (θ × a))`` (strips, 3, 3)."""
    both = np.swapaxes(n, -1, -2) @ a
    level = np.sum(n * a, axis=(-2, -1))[:, None, None] * np.eye(3)
    return np.asarray((both + np.swapaxes(both, -1, -2)) / 2.0 - level)
