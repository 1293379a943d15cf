"""Strip between rigid clamps at a large twist: von Kármán's plate by Ritz's method.

The strip is |x| ≤ l/2, |y| ≤ b/2, E = 1. Polynomials that vanish at the clamps, of the parity that
a twist has, for what it moves besides a plain twist. Shares no code with the package.
"""

from typing import NamedTuple

import numpy as np
from numpy.polynomial import legendre

__all__ = ["ClampedEnds", "twisted_strip"]


class ClampedEnds(NamedTuple):
    """Stress at the edges of the clamps, of bending and of tension, by their moments."""

    bent: float
    stretched: float


def twisted_strip(*, b, l, h, nu, theta, free, orders=8, steps=4):
    """Return the stress of a strip whose ends are held apart, or free to come closer."""
    plate = _Plate(b, l, nu, free, orders)
    bending = h**3 / 12.0 / (1.0 - nu**2)
    stretching = h / (1.0 - nu**2)
    found = np.zeros(plate.size)
    for part in np.arange(1, steps + 1) / steps:
        for _ in range(40):
            change = plate.newton(found, theta * part, bending, stretching)
            found = found - change
            if np.max(np.abs(change)) < 1e-10 * np.max(np.abs(found)):
                break
        else:
            raise AssertionError("Newton's method did not converge")
    return plate.ends(found, theta, bending, stretching, h)


class _Plate:
    def __init__(self, b, l, nu, free, n):
        self.nu, self.sides = nu, np.array([l, b])
        u, w = legendre.leggauss(2 * n + 14)
        self.u, self.w = u, np.outer(w * l / 2, w * b / 2).ravel()
        self.edge = w * b / 2
        odd, even = range(1, 2 * n, 2), range(0, 2 * n, 2)
        double = [_integral(_integral([0] * k + [1])) for k in range(3, 3 + 2 * n, 2)]
        drops = [[_bubble(k) for k in range(first, first + 2 * n, 2)] for first in (3, 2)]
        across = [[[0] * j + [1] for j in orders] for orders in (odd, even)]
        self.w_shapes = [(x, y) for x in double for y in across[0]]
        self.u_shapes = [(x, y) for x in drops[0] for y in across[1]]
        if free:
            self.u_shapes.append(([0, 1], [1]))
        self.v_shapes = [(x, y) for x in drops[1] for y in across[0]]
        self.turning = (legendre.poly2leg([0, 0.75, 0, -0.25]), [0, b / 2])
        self.size = len(self.w_shapes) + len(self.u_shapes) + len(self.v_shapes)
        orders = {"x": (1, 0), "y": (0, 1), "xx": (2, 0), "yy": (0, 2), "xy": (1, 1)}
        self.of = {d: self.values(self.w_shapes, m) for d, m in orders.items()}
        self.given = {d: self.values([self.turning], m)[0] for d, m in orders.items()}
        self.u_x, self.u_y = (self.values(self.u_shapes, m) for m in ((1, 0), (0, 1)))
        self.v_x, self.v_y = (self.values(self.v_shapes, m) for m in ((1, 0), (0, 1)))

    def values(self, shapes, orders, x=None):
        lines = (self.u if x is None else x, self.u)
        rows = []
        for shape in shapes:
            one, other = (
                legendre.legval(at, legendre.legder(c, m)) * (2 / side) ** m
                for c, at, m, side in zip(shape, lines, orders, self.sides, strict=True)
            )
            rows.append(np.outer(one, other).ravel())
        return np.array(rows)

    def parts(self, found):
        k, m = len(self.w_shapes), len(self.w_shapes) + len(self.u_shapes)
        return found[:k], found[k:m], found[m:]

    def form(self, one, other):
        """Return the products of curvatures, or of strains, (x, y, twice or simple shear)."""
        nu, shear = self.nu, (1 - self.nu) / 2
        (ax, ay, a), (bx, by, b) = ((np.atleast_2d(p) for p in each) for each in (one, other))
        direct = (ax * self.w) @ bx.T + (ay * self.w) @ by.T
        crossed = (ax * self.w) @ by.T + (ay * self.w) @ bx.T
        return direct + nu * crossed + shear * (a * self.w) @ b.T

    def newton(self, found, theta, bending, stretching):
        w, u, v = self.parts(found)
        of, k = self.of, w.size
        slope = {d: self.given[d] * theta + w @ of[d] for d in ("x", "y")}
        # of a body that turns by θ/2, its ends narrow by θ²/8
        strain = (
            u @ self.u_x + slope["x"] ** 2 / 2,
            v @ self.v_y - theta**2 / 8 + slope["y"] ** 2 / 2,
            u @ self.u_y + v @ self.v_x + slope["x"] * slope["y"],
        )
        none_u, none_v = np.zeros_like(self.u_x), np.zeros_like(self.v_x)
        rows = (
            np.vstack([of["x"] * slope["x"], self.u_x, none_v]),
            np.vstack([of["y"] * slope["y"], none_u, self.v_y]),
            np.vstack([of["x"] * slope["y"] + of["y"] * slope["x"], self.u_y, self.v_x]),
        )
        curved = (of["xx"], of["yy"], 2 * of["xy"])
        twist = tuple(self.given[d] * size for d, size in (("xx", 1), ("yy", 1), ("xy", 2)))
        residual = stretching * self.form(rows, strain)[:, 0]
        K = stretching * self.form(rows, rows)
        plate = bending * self.form(curved, curved)
        residual[:k] += plate @ w + bending * theta * self.form(curved, twist)[:, 0]
        n_x, n_y = (stretching * (strain[i] + self.nu * strain[1 - i]) for i in (0, 1))
        n_xy = stretching * (1 - self.nu) / 2 * strain[2]
        mixed = (of["x"] * (self.w * n_xy)) @ of["y"].T
        K[:k, :k] += plate + mixed + mixed.T
        K[:k, :k] += sum((of[d] * (self.w * n)) @ of[d].T for d, n in (("x", n_x), ("y", n_y)))
        scale = 1 / np.sqrt(np.diag(K))
        return scale * np.linalg.solve(K * np.outer(scale, scale), scale * residual)

    def ends(self, found, theta, bending, stretching, h):
        w, u, v = self.parts(found)
        end, (_, b) = np.array([1.0]), self.sides
        y = self.u * b / 2
        # at the clamp the slope along it is nought, and across it all moves as a rigid body
        moment = bending * (
            theta * self.values([self.turning], (2, 0), end)[0]
            + w @ self.values(self.w_shapes, (2, 0), end)
        )
        force = stretching * (
            u @ self.values(self.u_shapes, (1, 0), end)
            + self.nu * v @ self.values(self.v_shapes, (0, 1), end)
        )
        shapes = np.array([np.ones_like(y), y**2])
        mean, square = np.linalg.solve(
            (shapes * self.edge) @ shapes.T, (shapes * self.edge) @ force
        )
        bent = 36 * abs(np.sum(self.edge * moment * y)) / (b * h) ** 2
        return ClampedEnds(float(bent), float(mean + square * b**2 / 4) / h)


def _integral(c):
    return legendre.legint(c, lbnd=-1)


def _bubble(k):
    c = np.zeros(k + 1)
    c[k], c[k - 2] = 1.0, -1.0
    return c
