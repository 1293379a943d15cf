"""Sheet in its own plane between two rigid bodies, its long sides free: plane stress by Ritz.

The sheet is 0 ≤ x ≤ 1 (l = 1), |y| ≤ b/2, E h = 1. Its displacement is a beam's (plane sections)
and a part that vanishes at the ends. ``shear`` as of a strip. Shares no code with the package.
"""

from functools import cached_property

import numpy as np
from numpy.polynomial import Polynomial
from plates.smooth_basis import graded, smooth_basis
from scipy.linalg import cho_factor, cho_solve

__all__ = ["Sheet"]


class Sheet:
    """A sheet of width b over length 1, stretched (``bends`` false) or bent in its plane."""

    def __init__(self, b, nu, *, bends, shear=1.0, levels=2, bubbles=5):
        self.b, self.nu, self.bends, self.shear = b, nu, bends, shear
        self.along = smooth_basis(graded(1.0, 1.5 * b, levels, both=True), bubbles)
        self.across = smooth_basis(graded(b / 2.0, 0.75, levels, both=False), bubbles)
        last = 2 * (len(self.along.knots) - 1)
        self.inner = np.setdiff1d(np.arange(self.along.size), [0, last])  # slopes are free
        odd, even = (np.setdiff1d(np.arange(self.across.size), [held]) for held in (0, 1))
        self.u_lines, self.v_lines = (odd, even) if bends else (even, odd)

    @cached_property
    def _solver(self):
        nu, rows = self.nu, np.ix_(self.inner, self.inner)
        G = self.shear * (1.0 - nu) / 2.0

        def term(i, j, p, q, first, second):
            line = self.across.products(p, q)[np.ix_(first, second)]
            return np.kron(self.along.products(i, j)[rows], line)

        u, v = self.u_lines, self.v_lines
        uu = term(1, 1, 0, 0, u, u) + G * term(0, 0, 1, 1, u, u)
        vv = term(0, 0, 1, 1, v, v) + G * term(1, 1, 0, 0, v, v)
        uv = nu * term(1, 0, 0, 1, u, v) + G * term(0, 1, 1, 0, u, v)
        K = 2.0 / (1.0 - nu**2) * np.block([[uu, uv], [uv.T, vv]])
        scale = 1.0 / np.sqrt(np.diag(K))
        factor = cho_factor(K * scale[:, None] * scale)
        return lambda right: scale * cho_solve(factor, scale * right)

    def energy(self, strain, profile):
        """Return twice the energy for the strain ε_x = strain(x) profile(y) of plane sections."""

        def outer(order, line_order, lines):
            x = self.along.moments(order, strain)[self.inner]
            return np.kron(x, self.across.moments(line_order, profile)[lines])

        stiff = 2.0 / (1.0 - self.nu**2)
        own = self.b**3 / 12.0 if self.bends else self.b
        own *= stiff / 2.0 * ((strain**2).integ()(1.0) - (strain**2).integ()(0.0))
        load = -stiff * np.concatenate(
            [outer(1, 0, self.u_lines), self.nu * outer(0, 1, self.v_lines)]
        )
        return own - float(load @ self._solver(load))

    def axial_factor(self):
        """Return the stiffness along the sheet over E h b/l."""
        return self.energy(Polynomial([1.0]), np.ones_like) / self.b

    def bending_factor(self):
        """Return the stiffness in pure bending in the plane over E h b³/(12 l)."""
        return self.energy(Polynomial([1.0]), lambda y: -y) / (self.b**3 / 12.0)

    def guided_factor(self):
        """Return the stiffness of the S shape in the plane over Timoshenko's 12 EI/(l³(1 + Φ))."""
        found = self.energy(Polynomial([6.0, -12.0]), lambda y: -y)
        Phi = 2.4 * (1.0 + self.nu) / self.shear * self.b**2
        return found * (1.0 + Phi) / self.b**3
