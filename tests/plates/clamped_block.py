"""Block between two rigid bodies that bends across its thickness: a solid by Ritz's method.

The block is |x| ≤ ½ (l = 1), |y| ≤ b/2, |z| ≤ h/2, E = 1; an eighth of it is solved. Its
displacement is the beam's and a part that vanishes at the end. Shares no code with the package.
"""

import numpy as np
from plates.smooth_basis import smooth_basis
from scipy.linalg import cho_factor, cho_solve

__all__ = ["bending_factor", "guided_factor"]

ALONG = {"u": (1, 0, 0), "v": (0, 1, 0), "w": (0, 0, 1)}
"""Derivatives that make the strain along each axis."""


def bending_factor(*, b, h, nu):
    """Return the stiffness in pure bending over E I/l."""
    return _energy(b, h, nu, np.ones_like, odd=False) / (b * h**3 / 24.0)


def guided_factor(*, b, h, nu):
    """Return the stiffness of the S shape over Timoshenko's 12 E I/(l³ (1 + Φ))."""
    Phi = 2.4 * (1.0 + nu) * h**2
    return _energy(b, h, nu, lambda x: x, odd=True) * (1.0 + Phi) / (b * h**3 / 288.0)


def _knots(length, *back):
    return np.unique([0.0, length, *(length - d for d in back if d < 0.95 * length)])


def _energy(b, h, nu, curvature, *, odd):
    """Return twice the energy of half the length for ε_x = −z κ(x) and what follows."""
    near = min(h, 0.2 * b)
    x = smooth_basis(_knots(0.5, min(1.5 * b, 0.3), 0.5 * min(b, 0.3), near, 0.15 * near), 3)
    y = smooth_basis(_knots(b / 2.0, min(1.5 * h, 0.3 * b)), 2)
    z = smooth_basis(_knots(h / 2.0), 2)
    last = 2 * (len(x.knots) - 1)
    value, slope = [0, last], [1, last]  # zero in the middle: value or slope; zero at the end
    # u is odd in z and w even; across y, v is odd; along x, u is odd where the curvature is even
    zero = {
        "u": (slope if odd else value, [1], [0]),
        "v": (value if odd else slope, [0], [0]),
        "w": (value if odd else slope, [1], [1]),
    }
    lines = (x, y, z)
    kept = {
        field: [np.setdiff1d(np.arange(m.size), out) for m, out in zip(lines, outs, strict=True)]
        for field, outs in zero.items()
    }
    products = [[[m.products(i, j) for j in (0, 1)] for i in (0, 1)] for m in lines]
    lame, G = nu / ((1.0 + nu) * (1.0 - 2.0 * nu)), 0.5 / (1.0 + nu)

    def form(one, other, first, second):
        found = np.array([[4.0]])
        for axis, (i, j) in enumerate(zip(first, second, strict=True)):
            found = np.kron(found, products[axis][i][j][np.ix_(kept[one][axis], kept[other][axis])])
        return found

    def block(one, other):
        found = lame * form(one, other, ALONG[one], ALONG[other])
        found += G * form(one, other, ALONG[other], ALONG[one])
        if one == other:
            found += G * sum(form(one, one, d, d) for d in ALONG.values())
        return found

    def load(field):
        loads = (curvature, np.ones_like, np.negative)
        found = np.array([-4.0 * (lame + (2.0 * G if field == "u" else 0.0))])
        for m, line, order, load in zip(lines, kept[field], ALONG[field], loads, strict=True):
            found = np.kron(found, m.moments(order, load)[line])
        return found

    K = np.block([[block(one, other) for other in ALONG] for one in ALONG])
    right = np.concatenate([load(field) for field in ALONG])
    scale = 1.0 / np.sqrt(np.diag(K))
    K *= scale[:, None] * scale
    found = scale * cho_solve(cho_factor(K, overwrite_a=True), scale * right)
    bent = x.moments(0, lambda s: curvature(s) ** 2)[: 2 * len(x.knots) : 2].sum()
    return (lame + 2.0 * G) * b * h**3 / 12.0 * bent - float(right @ found)
