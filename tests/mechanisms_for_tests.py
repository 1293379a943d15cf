"""Layouts for the tests of the exact solver: a cantilever, pivots, a parallelogram."""

import numpy as np

from flexcli.formulas.profile import Constant
from flexcli.mechanics.layout import Blade, Body, Layout

E, G = 114e9, 114e9 / 2.68


def cantilever(*, h=1e-4, l=20e-3, b=10e-3, E=E, G=G, profile=None, angle=0.0, **more):
    """A blade clamped at the origin; the body ``tip`` sits at its end."""
    end = (l * np.cos(angle), l * np.sin(angle))
    blade = Blade("blade", "ground", "tip", (0.0, 0.0), end, profile or Constant(h), b)
    return Layout((Body("tip", end),), (blade,), E, G, **more)


def pivot(*, h=1e-4, l=20e-3, b=10e-3, delta=0.2, alpha=np.pi / 4, angle=0.0, **more):
    """Two blades towards the centre at the origin, δ = p/l, bisector along x turned by angle.

    The body ``out`` is at the inner ends, the ground at the outer ends.
    """
    p, blades = delta * l, []
    for name, side in (("upper", 1.0), ("lower", -1.0)):
        c, s = np.cos(angle + side * alpha), np.sin(angle + side * alpha)
        inner, outer = (p * c, p * s), ((p + l) * c, (p + l) * s)
        thickness = h if np.ndim(h) == 0 else np.asarray(h)[:, None]
        blades.append(Blade(name, "ground", "out", outer, inner, Constant(thickness), b))
    return Layout((Body("out", (0.0, 0.0)),), tuple(blades), E, G, **more)


def parallelogram(*, h=1e-4, l=20e-3, b=10e-3, apart=30e-3, **more):
    """Two blades along x from the ground to the body ``table``, which moves along y."""
    blades = tuple(
        Blade(name, "ground", "table", (0.0, y), (l, y), Constant(h), b)
        for name, y in (("left", -apart / 2.0), ("right", apart / 2.0))
    )
    return Layout((Body("table", (l, 0.0)),), blades, E, G, **more)
