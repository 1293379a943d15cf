"""Kirchhoff plate between two rigid bodies, its long sides free, by Ritz's method.

The plate is 0 ≤ x ≤ 1 (l = 1), |y| ≤ b/2, with E h³/12 = 1, so that the beam's EI is b. What it
does is the beam's shape w_0 and a part e that vanishes at the ends: only w_0'' ν e_yy, and in
twist 2 (1 − ν) θ' e_xy, tie them, so that nothing cancels. A sheet that is stiffer one way is the
same plate, as wide as b (E_x/E_y)^¼ and with ν = √(ν_xy ν_yx), but for its shear modulus: ``shear``
is that over √(E_x E_y)/(2 (1 + ν)). Shares no code with the package.
"""

from functools import cached_property

import numpy as np
from numpy.polynomial import Polynomial
from plates.smooth_basis import graded, smooth_basis
from scipy.linalg import cho_factor, cho_solve, eigh

__all__ = ["PURE", "S_SHAPE", "Strip"]

PURE = Polynomial([0.0, -0.5, 0.5])
"""Ends turned by −½ and ½."""
S_SHAPE = Polynomial([-0.5, 0.0, 3.0, -2.0])
"""Ends moved by −½ and ½ without turning."""


class Strip:
    """A strip of width b over length 1; even across its width, or odd (twist)."""

    def __init__(self, b, nu, *, odd=False, shear=1.0, levels=2, bubbles=5):
        self.b, self.nu, self.odd = b, nu, odd
        self.twist = 2.0 * (1.0 - nu) * shear
        self.D = 1.0 / (1.0 - nu**2)
        self.along = smooth_basis(graded(1.0, 1.5 * b, levels, both=True), bubbles)
        self.across = smooth_basis(graded(b / 2.0, 0.75, levels, both=False), bubbles)
        held = [0] if odd else [1]  # value or slope on the middle line
        self.kept = np.setdiff1d(np.arange(self.across.size), held)
        last = 2 * (len(self.along.knots) - 1)
        self.ends = [0, 1, last, last + 1]
        self.inner = np.setdiff1d(np.arange(self.along.size), self.ends)

    def _form(self, pairs):
        """Return the quadratic form of e, which vanishes at the ends, over the whole width."""
        rows = np.ix_(self.inner, self.inner)
        columns = np.ix_(self.kept, self.kept)
        return sum(
            2.0
            * factor
            * np.kron(self.along.products(i, j)[rows], self.across.products(p, q)[columns])
            for factor, (i, j), (p, q) in pairs
        )

    @property
    def _bends(self):
        D, nu = self.D, self.nu
        return [
            (D, (2, 2), (0, 0)),
            (D, (0, 0), (2, 2)),
            (D * nu, (2, 0), (0, 2)),
            (D * nu, (0, 2), (2, 0)),
            (D * self.twist, (1, 1), (1, 1)),
        ]

    @cached_property
    def _solver(self):
        K = self._form(self._bends)
        scale = 1.0 / np.sqrt(np.diag(K))
        factor = cho_factor(K * scale[:, None] * scale)
        return lambda right: scale * cho_solve(factor, scale * right)

    def _load(self, shape):
        """Return minus the slope of the energy in e at the beam's shape."""

        def outer(order, f, line_order, g):
            x = self.along.moments(order, f)[self.inner]
            y = self.across.moments(line_order, g)[self.kept]
            return np.kron(x, y)

        bent, turned = shape.deriv(2), shape.deriv()
        D, nu = self.D, self.nu
        if not self.odd:
            return -2.0 * D * nu * outer(0, bent, 2, np.ones_like)
        tied = nu * outer(0, bent, 2, lambda y: y)
        return -2.0 * D * (tied + self.twist * outer(1, turned, 1, np.ones_like))

    def energy(self, shape):
        """Return twice the energy for end motions given by the beam's shape, a cubic in x."""
        bent, turned = (float(((shape.deriv(n)) ** 2).integ()(1.0)) for n in (2, 1))
        bent -= float((shape.deriv(2) ** 2).integ()(0.0))
        load = self._load(shape)
        own = self.D * self.b * bent
        if self.odd:
            twisted = self.twist * self.b * turned
            own = self.D * (self.b**3 / 12.0 * bent + twisted)
        return own - float(load @ self._solver(load))

    def bending_factor(self):
        """Return the stiffness in pure bending over E I/l."""
        return self.energy(PURE) / self.b

    def guided_factor(self):
        """Return the stiffness of the S shape over 12 E I/l³."""
        return self.energy(S_SHAPE) / (12.0 * self.b)

    def twist_factor(self):
        """Return the torsional stiffness between ends that cannot warp over G J/l, thin."""
        J = self.D * self.twist * self.b  # G b h³/3 of E h³/12 = 1
        return self.energy(S_SHAPE) / J

    def curvature(self, shape, x, y):
        """Return w_xx at a place."""
        e = self._solver(self._load(shape)).reshape(len(self.inner), len(self.kept))
        rows, columns = self.along.at(x, 2)[:, self.inner], self.across.at(y, 0)[:, self.kept]
        return shape.deriv(2)(np.atleast_1d(x)) + np.einsum("pi,im,pm->p", rows, e, columns)

    def shortening(self, shape):
        """Return ½∫ w_x² dx, mean over the width."""
        e = self._solver(self._load(shape))
        slopes = self._form([(1.0, (1, 1), (0, 0))])
        x = self.along.moments(1, shape.deriv())[self.inner]
        mixed = 2.0 * np.kron(x, self.across.moments(0, np.ones_like)[self.kept])
        own = self.b * float((shape.deriv() ** 2).integ()(1.0) - (shape.deriv() ** 2).integ()(0.0))
        return (own + 2.0 * float(mixed @ e) + float(e @ slopes @ e)) / (2.0 * self.b)

    def frequencies(self, count):
        """Return the least ω l² √(ρ h/D) between ends that are held."""
        K, M = self._form(self._bends) / self.D, self._form([(1.0, (0, 0), (0, 0))])
        return np.sqrt(eigh(K, M, eigvals_only=True, subset_by_index=[0, count - 1]))

    def _whole(self, pairs, kept):
        """Return a form of all motions: those of the bodies listed, then the inside."""
        m, whole = len(self.kept), 0.0
        columns = np.ix_(self.kept, self.kept)
        for factor, (i, j), (p, q) in pairs:
            line = self.across.products(p, q)[columns]
            whole = whole + 2.0 * factor * np.kron(self.along.products(i, j), line)
        select = np.zeros((whole.shape[0], len(kept)))
        nodes = 2 * np.arange(len(self.across.knots))
        rigid = np.zeros(self.across.size)
        rigid[nodes] = 1.0
        for column, end in enumerate(kept):
            place = self.ends[end] * m
            select[place : place + m, column] = rigid[self.kept]
        inside = (self.inner[:, None] * m + np.arange(m)).ravel()
        top = whole @ select
        lower = top[inside]
        return np.block([[select.T @ top, lower.T], [lower, whole[np.ix_(inside, inside)]]])

    def critical(self, free):
        """Return the least axial force over the width that buckles it.

        Of the end motions w, w' at 0, w, w' at 1 those in ``free`` are free, the others zero.
        """
        K, G = self._whole(self._bends, free), self._whole([(1.0, (1, 1), (0, 0))], free)
        scale = 1.0 / np.sqrt(np.diag(K))
        K, G = (form * scale[:, None] * scale for form in (K, G))
        last = len(K) - 1
        return 1.0 / eigh(G, K, eigvals_only=True, subset_by_index=[last, last])[0]

    def stiffness(self, force):
        """Return the stiffness of w, w' at 0, w, w' at 1 under an axial force, of a width."""
        K, G = self._of_ends
        form = K - force * G
        inside = form[4:, 4:]
        return form[:4, :4] - form[:4, 4:] @ np.linalg.solve(inside, form[4:, :4])

    @cached_property
    def _of_ends(self):
        every = range(4)
        return self._whole(self._bends, every), self._whole([(1.0, (1, 1), (0, 0))], every)

    def critical_of_two(self, middle, free):
        """Return the least axial force over the width that buckles two, rigid between them.

        That is as long as ``middle``. Of w, w' at the start, where the first one ends, and at the
        end of the second those in ``free`` are free, the others zero.
        """
        first, second = np.eye(6)[:4], np.zeros((4, 6))
        second[[0, 0, 1, 2, 3], [2, 3, 3, 4, 5]] = 1.0, middle, 1.0, 1.0, 1.0
        n = len(self.inner) * len(self.kept)
        K, G = (
            self._placed(form, first, 0, n) + self._placed(form, second, n, n)
            for form in self._of_ends
        )
        G[3, 3] += self.b * middle
        kept = [*free, *range(6, len(K))]
        K, G = (form[np.ix_(kept, kept)] for form in (K, G))
        last, scale = len(kept) - 1, 1.0 / np.sqrt(np.diag(K))
        K, G = (form * scale[:, None] * scale for form in (K, G))
        return 1.0 / eigh(G, K, eigvals_only=True, subset_by_index=[last, last])[0]

    @staticmethod
    def _placed(form, ends, place, n):
        """Return a form of ends and inside in one of six motions and the inside of two strips."""
        where = np.zeros((4 + n, 6 + 2 * n))
        where[:4, :6] = ends
        where[4:, 6 + place : 6 + place + n] = np.eye(n)
        return where.T @ form @ where
