"""Circular notch in pure bending between rigid bodies: a solid by Ritz's method.

The notch is |x| ≤ r = 1, |y| ≤ b/2, |z| ≤ h(x)/2 with h = e + 2 − 2 √(1 − x²), E = 1; an eighth is
solved in coordinates that follow the throat, by polynomials whose products are integrated by
quadrature. Shares no code with the package, nor with the plates beside it.
"""

import numpy as np
from numpy.polynomial import legendre

__all__ = ["stiffness"]


def stiffness(*, e, b, nu, along=9, across=5, thick=2):
    """Return the moment per rotation and per width."""
    scale = np.sqrt(e)
    end = np.arcsinh(0.999 / scale)
    g, w = legendre.leggauss(3 * along)
    s, ws = (g + 1) / 2, w / 2
    p, q = legendre.leggauss(2 * across + 2)
    y, wy = (p + 1) / 2, q / 2
    m, n = legendre.leggauss(2 * thick + 2)
    z, wz = (m + 1) / 2, n / 2
    S, Y, Z = (a.ravel() for a in np.meshgrid(s, y, z, indexing="ij"))
    weight = np.einsum("i,j,k->ijk", ws, wy, wz).ravel()
    x = scale * np.sinh(end * S)
    x_s = scale * end * np.cosh(end * S)
    h = e + 2 - 2 * np.sqrt(1 - x**2)
    h_x = 2 * x / np.sqrt(1 - x**2)
    # x = x(s), y = b/2 Y, z = h(x)/2 Z
    volume = weight * x_s * b / 2 * h / 2

    def family(t, degrees, zero=False):
        """Return polynomials and derivatives; those that vanish at 1 where asked."""
        value, slope = [], []
        for d in degrees:
            c = np.zeros(d + 1)
            c[d] = 1
            v, dv = legendre.legval(t, c), legendre.legval(t, legendre.legder(c))
            value.append(v * (1 - t**2) if zero else v)
            slope.append(dv * (1 - t**2) - 2 * t * v if zero else dv)
        return np.array(value), np.array(slope)

    odd, even = (np.arange(first, 2 * along, 2) for first in (1, 0))
    parts = {
        "u": (odd, np.arange(0, 2 * across, 2), np.arange(1, 2 * thick + 1, 2)),
        "v": (even, np.arange(1, 2 * across, 2), np.arange(1, 2 * thick + 1, 2)),
        "w": (even, np.arange(0, 2 * across, 2), np.arange(0, 2 * thick + 1, 2)),
    }
    rows = []
    for field, (i, j, k) in parts.items():
        f, f_s = family(S, i, zero=True)
        g_, g_Y = family(Y, j)
        k_, k_Z = family(Z, k)
        ds = np.einsum("ip,jp,kp->ijkp", f_s, g_, k_).reshape(-1, S.size)
        dY = np.einsum("ip,jp,kp->ijkp", f, g_Y, k_).reshape(-1, S.size)
        dZ = np.einsum("ip,jp,kp->ijkp", f, g_, k_Z).reshape(-1, S.size)
        d_z = dZ * 2 / h
        d_x = ds / x_s - dZ * Z * h_x / h
        d_y = dY * 2 / b
        zero = np.zeros_like(d_x)
        strain = {
            "u": (d_x, zero, zero, d_y, d_z, zero),
            "v": (zero, d_y, zero, d_x, zero, d_z),
            "w": (zero, zero, d_z, zero, d_x, d_y),
        }[field]
        rows.append(np.stack(strain, axis=1))
    B = np.concatenate(rows)  # functions, strains, points
    lame, G = nu / ((1 + nu) * (1 - 2 * nu)), 0.5 / (1 + nu)
    C = np.diag([2 * G] * 3 + [G] * 3)
    C[:3, :3] += lame
    # the ends turn by ± 1: u = −φ z, and w with the slope φ, which keeps the sections square;
    # φ is the beam's, so that little is left to the polynomials
    bent = (e / h) ** 3
    own = np.zeros((6, S.size))
    own[0] = -Z * h / 2 * bent / (weight @ (bent * x_s))
    own = (own * np.sqrt(volume)).ravel()
    B = (B * np.sqrt(volume)).reshape(len(B), 6, -1)
    CB = np.einsum("ab,fbp->fap", C, B).reshape(len(B), -1)
    K, load = CB @ B.reshape(len(B), -1).T, CB @ own
    size = 1 / np.sqrt(np.diag(K))
    found = size * np.linalg.solve(K * size[:, None] * size, size * load)
    whole = own @ (C @ own.reshape(6, -1)).ravel()
    energy = 8 * float(whole - load @ found)  # moment times the turn of 2
    return energy / 4 / b
