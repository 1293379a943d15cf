"""A neck under six unit loads: compliances and surface stresses, each on two meshes.

The coarser mesh has bricks of one order less each way; by what both differ the finer is off at
most.
"""

from collections.abc import Iterable
from functools import cached_property, lru_cache
from itertools import product

import numpy as np
from numpy.typing import NDArray

from flexcli.errors import SolveError
from flexcli.mechanics.solids.neck import Neck, neck_lattice
from flexcli.mechanics.solids.octant import LOADS, Moved, Octant

__all__ = ["COARSE", "FINE", "NeckUnderLoads", "equivalent", "neck_under_loads", "sides"]

Floats = NDArray[np.float64]
Orders = tuple[int, int, int]

COARSE, FINE = (3, 5, 3), (4, 6, 4)
"""Orders of the bricks along, across and over the width."""

BEYOND = 0.9
"""Share of the length of a curved face, from which on a place is beside the block."""

TWISTED = 0.208
"""Least torque of a rectangle over b h² times its largest shear: that of a square."""

FINER = (6e-3, 0.0, 5e-3, 3e-3, 0.0, 0.0)
"""Of the largest stress of each unit load, what finer bricks may change besides. Of 34 random necks
(e/ρ 0.003 to 0.8, b/e 0.3 to 18, straight or not, clamped or not) those of orders 6, 8 and 6 were
farther from the finer mesh here than this from the coarser, of N (ends of short, thick straight
stretches) by 0.0076, of V_z by 0.0063, of T by 0.0046, of moments and V_y by 0.0025."""

WIDTH = 2
"""A force over the width, among six loads."""

ROUNDED, ROUNDED_LIMB = 2.5e-14, 4e-13
"""Rounding of the compliance to that force, of a neck or a limb, over the fourth power of half its
length over its width: three times by how much numbers scattered that differed in their tenth digit.
Five necks whose half is 300 and 900 widths long scattered by 2e-5 to 5e-5 and by 6e-4 to 5e-3, one
of 1300 by 6e-3, a limb by 1e-3 and 0.07."""

KEPT = 16
"""Necks whose solution is kept, a few megabytes each: the next verb or case asks the same."""

TINY = np.finfo(np.float64).tiny
"""Least divisor of a cube of a stress [Pa³]."""

VOIGT = ((0, 0), (1, 1), (2, 2), (1, 2), (0, 2), (0, 1))
"""Ways of the stresses as the octant has them."""


class NeckUnderLoads:
    """The neck between rigid bodies, solved on a mesh when one of its loads is first asked for.

    Raises
    ------
    SolveError
        Where it is asked for a load under which it is so slender that no digits are left.

    """

    def __init__(self, neck: Neck, E: float, nu: float) -> None:
        self.neck = neck
        self.elastic = E, nu

    @cached_property
    def _octants(self) -> dict[Orders, Octant]:
        meshes = (COARSE, FINE)
        return {each: Octant(neck_lattice(self.neck, each), *self.elastic) for each in meshes}

    def solve(self, indices: Iterable[int], meshes: Iterable[Orders] = (COARSE, FINE)) -> None:
        """Solve loads that will be asked for, told by their places in a wrench.

        What those in the plane and those across it have in common is then found once.
        """
        asked = tuple(indices)
        for each in meshes:
            self._octants[each].solve(asked)

    def compliance(self, index: int) -> tuple[float, float]:
        """Return the compliance to a unit load about the middle, and its relative error.

        ``index`` is the place of the load in a wrench [m/N or rad/(N·m)].
        """
        coarse, fine = (self._moved(orders, index).compliance for orders in (COARSE, FINE))
        error = abs(coarse / fine - 1.0)
        if index == WIDTH:
            neck = self.neck
            rounded = ROUNDED if neck.bar == 0.0 else ROUNDED_LIMB
            error += rounded * ((neck.throat + neck.end + neck.block) / neck.b) ** 4
        return fine, error

    def stresses(self, wrenches: Floats, orders: Orders) -> tuple[Floats, Floats]:
        """Return the stresses of wrenches about the middle, all over the surface beside the throat.

        It is all that lies between the mouths, but for the last bricks where these are clamped: a
        rigid body stresses without end what is beside its edges.

        Parameters
        ----------
        wrenches : array, shape (states, 6)
            What the body at its end bears, along the neck's axes [N, N·m].
        orders : tuple of int
            Those of the mesh.

        Returns
        -------
        stress : array, shape (states, places, 6)
            xx, yy, zz, yz, zx, xy [Pa]; the same place in each state.
        is_last : array, shape (places,)
            Whether a place is in the last bricks before the mouth or beyond it, or as near as any
            to one that is clamped: larger stresses may be beyond.

        """
        lattice = self._octants[orders].lattice
        rows, near = lattice.mouth + 1, lattice.mouth - orders[0]
        if self.neck.block == 0.0:
            rows = near + 1
        on = np.zeros(lattice.shape, dtype=bool)
        on[:rows, -1, :] = on[:rows, :, -1] = True
        row, column, _ = np.nonzero(on)
        beside = self.neck.throat + self.neck.straight / 2.0 + BEYOND * self.neck.l / 2.0
        last = (row >= near) | (lattice.x[row, column] >= beside)
        found = np.zeros((len(wrenches), 8, last.size, 6))
        acting = np.flatnonzero(np.any(wrenches, axis=0)).tolist()
        self.solve(acting, [orders])
        for index in acting:
            own = self._moved(orders, index).stress[on]
            for octant, mirrored in enumerate(product((False, True), repeat=3)):
                signs = _signs(LOADS[index].signs, mirrored)
                found[:, octant] += wrenches[:, index, None, None] * (own * signs)
        return found.reshape(len(wrenches), -1, 6), np.tile(last, 8)

    def at_mouth(self, wrenches: Floats) -> float:
        """Return the most that a beam as high as the mouth is stressed there by wrenches [Pa]."""
        neck = self.neck
        H, b, x = neck.height, neck.b, neck.throat + neck.end
        Fx, Fy, Fz, Mx, My, Mz = np.abs(wrenches).T
        normal = Fx / (b * H) + 6.0 * (Mz + x * Fy) / (b * H**2) + 6.0 * (My + x * Fz) / (H * b**2)
        shear = 1.5 * (Fy + Fz) / (b * H) + Mx / (TWISTED * b * H * min(b, H))
        return float(np.max(normal + np.sqrt(3.0) * shear))

    def apart(self, index: int) -> float:
        """Return by how much finer meshes may change the largest stress of a unit load [Pa].

        That is by how much it differs on both, and a share of it.
        """
        unit = np.eye(6)[[index]]
        coarse, fine = (
            float(np.abs(equivalent(self.stresses(unit, each)[0])).max()) for each in (COARSE, FINE)
        )
        return abs(coarse - fine) + FINER[index] * fine

    def _moved(self, orders: Orders, index: int) -> Moved:
        found = self._octants[orders].moved(index)
        if found is None:
            hint = "leave a body as slender as that to beams"
            raise SolveError("too-slender", "a solid has too few digits", hint)
        return found


@lru_cache(maxsize=KEPT)
def neck_under_loads(neck: Neck, E: float, nu: float) -> NeckUnderLoads:
    """Return a neck with whatever was solved of it in this process."""
    return NeckUnderLoads(neck, E, nu)


def _signs(parity: tuple[int, int, int], mirrored: tuple[bool, ...]) -> Floats:
    """Return the signs (6,) of the stresses of a load in a mirrored octant."""
    found = np.ones(6)
    for axis in range(3):
        if mirrored[axis]:
            found *= [parity[axis] * (-1.0) ** ((i == axis) + (j == axis)) for i, j in VOIGT]
    return found


def sides(places: int) -> Floats:
    """Return on which side of the middle so many places of a surface are: 1 beyond it, or −1.

    Octants before the middle are the mirror images of those beyond it, and come after them.
    """
    return np.repeat([1.0, -1.0], places // 2)


def equivalent(stress: Floats) -> Floats:
    """Return the larger of von Mises' stress and the largest principal one (...,) [Pa].

    It has the sign of the latter. A wide throat has von Mises' below its stress along, by which
    beams are judged; in shear von Mises' is the larger.
    """
    mean = stress[..., :3].sum(axis=-1) / 3.0
    a, b, c = (stress[..., k] - mean for k in range(3))
    d, e, f = (stress[..., k] for k in range(3, 6))
    J = (a**2 + b**2 + c**2) / 2.0 + d**2 + e**2 + f**2
    third = a * (b * c - d**2) - f * (f * c - d * e) + e * (f * d - b * e)
    radius = np.sqrt(J / 3.0)
    # cos 3θ of Lode's angle; each end from where its sum has all digits, so that signs reverse it
    lode = np.clip(third / np.maximum(2.0 * radius**3, TINY), -1.0, 1.0)
    most, least = (
        mean + sign * 2.0 * radius * np.cos(np.arccos(sign * lode) / 3.0) for sign in (1.0, -1.0)
    )
    mises = np.sqrt(3.0 * J)
    found = np.maximum(mises, np.maximum(np.abs(most), np.abs(least)))
    return np.asarray(np.where(most >= -least, found, -found))
