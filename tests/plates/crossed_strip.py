"""Kirchhoff plate clamped in two rigid bodies, held on a line across it, by Ritz's method.

The thin limit of two equal blades that cross and are joined there: each holds the line of the
other straight, as it is that much stiffer in its plane, and both turn along the line alike, so that
neither keeps the other from turning unevenly over the width. The plate is 0 ≤ x ≤ 1, |y| ≤ b/2,
with E h³/12 = 1; its line at x = c does not move, and the body at its end turns about it by 1.
Shares no code with the package.
"""

import numpy as np
from plates.smooth_basis import graded, smooth_basis
from scipy.linalg import cho_factor, cho_solve

__all__ = ["CrossedStrip"]


class CrossedStrip:
    """Energy, moment and shortening of a blade of joined ones, even across its width."""

    def __init__(self, b, nu, crossing, *, levels=2, bubbles=5):
        D = 1.0 / (1.0 - nu**2)
        c = crossing
        near = graded(c, 1.5 * b, levels, both=True)
        far = c + graded(1.0 - c, 1.5 * b, levels, both=True)
        along = smooth_basis(np.concatenate([near, far[1:]]), bubbles)
        across = smooth_basis(graded(b / 2.0, 0.75, levels, both=False), bubbles)
        columns = np.setdiff1d(np.arange(across.size), [1])  # no slope on the middle line
        last = 2 * (len(along.knots) - 1)
        line = 2 * (len(near) - 1)
        rows = np.setdiff1d(np.arange(along.size), [0, 1, line, last, last + 1])

        def form(pairs):
            """Return a quadratic form of free motions, and with the turned body's, over b."""
            whole, mixed, own = 0.0, 0.0, 0.0
            ends = np.zeros(along.size)
            ends[[last, last + 1]] = 1.0 - c, 1.0
            flat = np.zeros(across.size)
            flat[: 2 * len(across.knots) : 2] = 1.0
            for factor, (i, j), (p, q) in pairs:
                x, y = along.products(i, j), across.products(p, q)
                whole = whole + 2.0 * factor * np.kron(
                    x[np.ix_(rows, rows)], y[np.ix_(columns, columns)]
                )
                mixed = mixed + 2.0 * factor * np.kron((x @ ends)[rows], (y @ flat)[columns])
                own += 2.0 * factor * float(ends @ x @ ends) * float(flat @ y @ flat)
            return whole, mixed, own

        bends = [
            (D, (2, 2), (0, 0)),
            (D, (0, 0), (2, 2)),
            (D * nu, (2, 0), (0, 2)),
            (D * nu, (0, 2), (2, 0)),
            (2.0 * D * (1.0 - nu), (1, 1), (1, 1)),
        ]
        K, load, own = form(bends)
        scale = 1.0 / np.sqrt(np.diag(K))
        e = -scale * cho_solve(cho_factor(K * scale[:, None] * scale), scale * load)
        self.b = b
        self.stiffness = own + float(load @ e)
        """Moment about the line over its rotation; the beam's is 4 EI."""
        self._e, self._rows, self._columns = e, rows, columns
        self._ends = (last, c)
        self.along, self.across = along, across

    def factor(self):
        """Return the stiffness over the beam's, 4 E I/l."""
        return self.stiffness / (4.0 * self.b)

    def shortenings(self):
        """Return ½∫w_x² dx of both parts, each against the straight line that it joins, mean."""
        along, across = self.along, self.across
        last, c = self._ends
        full = np.zeros((along.size, across.size))
        full[np.ix_(self._rows, self._columns)] = self._e.reshape(
            len(self._rows), len(self._columns)
        )
        nodes = np.arange(0, 2 * len(across.knots), 2)
        full[last, nodes] += 1.0 - c
        full[last + 1, nodes] += 1.0
        u, g = np.polynomial.legendre.leggauss(along.bubbles + 6)
        found = []
        steps = np.diff(across.knots)[:, None] / 2
        wide = across.at((across.knots[:-1, None] + (u + 1) * steps).ravel(), 0)
        weight = (g * steps).ravel() / (self.b / 2.0)
        for lo, hi, turn in ((0.0, c, 0.0), (c, 1.0, 1.0)):
            total = 0.0
            for s, t in zip(along.knots[:-1], along.knots[1:], strict=True):
                if s < lo - 1e-12 or t > hi + 1e-12:
                    continue
                step = (t - s) / 2
                slope = along.at(s + (u + 1) * step, 1) @ full @ wide.T - turn
                total += float((g * step) @ slope**2 @ weight)
            found.append(total / 2.0)
        return found
